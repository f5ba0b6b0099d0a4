// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRemeshRegion_h
#define BitingRemeshRegion_h

#include "../Base/Monitor.h"
#include "../Base/Problem.h"
#include "../Spacing/Spacing.h"
#include "ChangedRegion.h"
#include "EdgeSimplification.h"
#include "OldMesh.h"
#include "RemeshOptions.h"

#include <vector> // for spacings

namespace biting
{

/// What of a mesh must change, and the spacing that it is to have.
struct RemeshRegion
{
  ChangedRegion Region;            ///< empty: nothing must
  Spacing F;                       ///< in the region and around it
  std::vector<double> OldSpacings; ///< f at the vertices of the mesh
  EdgeTolerance Tolerance;         ///< how far edges may move
};

/// Compares the mesh with the spacing that is wanted of it. Where the limit by feature size makes
/// the region larger, f is limited around it, too: in a region that grows until the two agree. What
/// is wrong is added to `problems`; then, and where the monitor asks to stop, the result has no
/// meaning.
RemeshRegion FindRemeshRegion(
  const OldMesh& mesh, const RemeshOptions& options, ProblemList& problems, Monitor& monitor);

} // namespace biting

#endif
