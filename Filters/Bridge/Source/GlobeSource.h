// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGlobeSource_h
#define BitingGlobeSource_h

#include "../../Kernel/Base/Pulse.h"
#include "../../Kernel/Spacing/Spacing.h"
#include "../Drawing/PlaneFrame.h"

namespace biting
{

/// Takes a source, which is in degrees, into the stereographic plane `frame`, as triangles that are
/// straight and linear there: of cells up to 10 degrees wide that is as in degrees but for about 2
/// % of what f changes in one, up to 90 degrees from the middle (w tan(c / 2) / 8 for the width w
/// and the distance c, as the scale changes). Triangles with a corner more than 175 degrees from
/// the middle are left out.
std::shared_ptr<const TriangulatedSource> SourceOnGlobe(
  const PlaneFrame& frame, const GivenSource& source, Pulse& pulse);

} // namespace biting

#endif
