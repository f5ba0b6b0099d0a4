// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingResolveCrossings_h
#define BitingResolveCrossings_h

#include "../Surface/SurfaceCheck.h"

namespace biting
{

/// Takes crossings and folds out of a surface that was checked, if it is clear what is inside:
/// small ones are cut out and closed as holes are (CutOutCrossings), told as SmallCrossings; else
/// the surface becomes that of the union (UniteSurfaces), told as UnitedSurfaces. `found` has what
/// the check found; its crossings and folds become one of these. Where neither leaves a closed
/// surface without crossings, or the union is not that of the given surface all stays as it is.
void ResolveCrossings(CheckedSurface& surface, const SurfaceCheckOptions& options,
  ProblemList& found, Monitor& monitor);

} // namespace biting

#endif
