// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingResolveCrossings_h
#define BitingResolveCrossings_h

#include "../Surface/SurfaceCheck.h"

namespace biting
{

/// Takes crossings and folds out of a surface that was checked, if it is clear what is inside:
/// small ones are cut out and closed as holes are (CutOutCrossings), told as SmallCrossings; else,
/// and where shells touch, the surface becomes that of the union (UniteSurfaces), told as
/// UnitedSurfaces. These replace crossings in `found`, which has what the check found. All stays
/// as it is where neither leaves a closed surface without crossings that is the union of the given.
void ResolveCrossings(CheckedSurface& surface, const SurfaceCheckOptions& options,
  ProblemList& found, Monitor& monitor);

} // namespace biting

#endif
