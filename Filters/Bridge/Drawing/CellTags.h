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

/// For each cell of the drawing a number, equal where all components of the cell array `name` are
/// equal: whole numbers to the last digit, NaN to NaN, 0 to -0, texts. Empty where `name` is empty
/// or "None". Returns why there are none: the drawing has no such array, or one that is too short.
std::string FindRegionNumbers(
  const Drawing& drawing, const std::string& name, std::vector<Id>& numbers, Pulse& pulse);

/// Whether two cells have equal values in every cell array, of any type. Arrays of global or
/// pedigree ids, of numbers of original cells and of ghosts do not count, nor those that have no
/// value for some cell. Faces,
/// those chains of `chains` that are one, are always alike: where the boundary passes from one to
/// another nothing ends but what belongs to their areas.
/// Refers to `drawing`. Empty where all cells are alike.
std::function<bool(Id, Id)> CompareTags(const Drawing& drawing, const Polylines& chains);

} // namespace biting

#endif
