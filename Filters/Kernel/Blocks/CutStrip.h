// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCutStrip_h
#define BitingCutStrip_h

#include "../Base/Monitor.h"
#include "../Domain/Domain.h"
#include "../Spacing/Spacing.h"
#include "JoinedBlocks.h"
#include "StripReturn.h"

#include <cstdint> // for flags
#include <vector>  // for flags

namespace biting
{

/// Relaxes the strips around the cuts, StripSteps wide (StripParts.h). Inner vertices of a strip
/// move, come and go. Vertices on a segment slide or go, unless `areTouching` says that the segment
/// nearly touches another. All others stay. Vertices of the domain keep their numbers, other kept
/// vertices their order. New vertices and the triangles of strips come last. Where the monitor
/// wants to stop the result has no meaning.
StripChange RelaxCuts(const Domain& domain, const std::vector<std::uint8_t>& areTouching,
  const Spacing& spacing, JoinedMesh& mesh, Monitor& monitor);

} // namespace biting

#endif
