// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGlobeSource_h
#define BitingGlobeSource_h

#include "../../Kernel/Base/Pulse.h"
#include "../../Kernel/Spacing/Spacing.h"
#include "../Drawing/PlaneFrame.h"

namespace biting
{

/// Takes the grid and the triangulation of `options`, which are in degrees, into the stereographic
/// plane `frame`, as triangles. Cells wider than 2 degrees are divided, so that what is linear in
/// degrees stays so; what is more than 175 degrees from the middle is left out. Cells of a
/// triangulation go the shorter way around the globe.
void SourceOnGlobe(const PlaneFrame& frame, SpacingOptions& options, Pulse& pulse);

} // namespace biting

#endif
