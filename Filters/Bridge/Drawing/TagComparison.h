// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTagComparison_h
#define BitingTagComparison_h

#include "../../Kernel/Base/Ids.h"
#include "../../Kernel/Domain/Polylines.h"
#include "Drawing.h"

#include <functional> // for the comparison

namespace biting
{

/// Whether two cells have equal values in every cell array, of any type. Arrays of global or
/// pedigree ids, of numbers of original cells and of ghosts do not count, nor those that have no
/// value for some cell. Faces,
/// those chains of `chains` that are one, are always alike: where the boundary passes from one to
/// another nothing ends but what belongs to their areas.
/// Refers to `drawing`. Empty where all cells are alike.
std::function<bool(Id, Id)> CompareTags(const Drawing& drawing, const Polylines& chains);

} // namespace biting

#endif
