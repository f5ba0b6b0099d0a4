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

/// Relaxes what lies within some rings around the cuts: their vertices move, come and go like all
/// others. On segments they slide and go only, and not at all where `areTouching` says that the
/// segment nearly touches another. What is farther away stays. Vertices of the domain keep their
/// numbers, the others their order; new ones come last, and so do triangles of the strip. Where
/// the monitor wants to stop the result has no meaning.
StripChange RelaxCuts(const Domain& domain, const std::vector<std::uint8_t>& areTouching,
  const Spacing& spacing, JoinedMesh& mesh, Monitor& monitor);

} // namespace biting

#endif
