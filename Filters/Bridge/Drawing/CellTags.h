// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCellTags_h
#define BitingCellTags_h

#include "../../Kernel/Base/Ids.h"
#include "../../Kernel/Base/Pulse.h"
#include "../../Kernel/Domain/Polylines.h"
#include "Drawing.h"

#include <functional> // for the comparison
#include <string>     // for the refusal
#include <vector>     // for numbers

namespace biting
{

/// Numbers the cells of the drawing: two cells have the same number where all components of the
/// cell array `name` are equal. NaN equals NaN, 0 equals -0. `numbers` is empty where `name` is
/// empty or "None". Returns a refusal where the drawing has no such array, or one that is too
/// short.
std::string FindRegionNumbers(
  const Drawing& drawing, const std::string& name, std::vector<Id>& numbers, Pulse& pulse);

/// Whether two cells have equal values in every cell array, of any type. Arrays of global or
/// pedigree ids, of numbers of original cells and of ghosts do not count, nor do arrays without a
/// value for each cell. Faces, which are cells of a chain of `chains` of that kind, always equal
/// each other: an edge of the mesh may cover parts of several faces.
/// Refers to `drawing`. Empty where all cells are equal.
std::function<bool(Id, Id)> CompareTags(const Drawing& drawing, const Polylines& chains);

/// Sets `opens` to whether the cell array `name` is another number than 0, and not NaN, at a cell;
/// leaves it where `name` is empty or "None". Returns a refusal where the drawing has no such
/// numbers. Refers to `drawing`.
std::string FindCracks(
  const Drawing& drawing, const std::string& name, std::function<bool(Id)>& opens);

} // namespace biting

#endif
