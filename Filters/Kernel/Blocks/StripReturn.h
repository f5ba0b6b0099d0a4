// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingStripReturn_h
#define BitingStripReturn_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "JoinedBlocks.h"
#include "TakenStrip.h"

#include <cstddef> // for slots
#include <vector>  // for the strips

namespace biting
{

/// A strip whose mesh has been relaxed.
struct RelaxedStrip
{
  TakenStrip Strip;
  std::vector<Id> Origins; ///< of its vertices, in the strip as it was taken; NoId: new
};

/// The change of a mesh along its cuts, in the numbers before the change.
struct StripChange
{
  std::vector<Id> GoneVertices; ///< rising
  std::vector<Id> Triangles;    ///< of the strips, rising: replaced by others, which come last
  bool IsWhole = true;          ///< false: flips needed what is not there (FlipUntilDelaunay)
};

/// Puts strips, which have no vertex in common, back into the mesh that they were taken from.
/// Vertices of the domain keep their numbers, the others their order; new ones come last, and so do
/// the triangles of strips, strip by strip. The mesh is constrained Delaunay where strips meet the
/// rest. Where the monitor wants to stop the result has no meaning.
StripChange ReturnStrips(const std::vector<RelaxedStrip>& strips, JoinedMesh& mesh, Pulse& pulse);

/// Makes the mesh constrained Delaunay by flips, exactly. Precondition: all edges that may not be
/// Delaunay lie opposite the corners `slots`. Stopped by the monitor, the mesh is valid, no more.
/// False where a flip came to an edge without a constraint and without a second triangle: the core
/// of a block beyond is missing here, and the result is not that of the whole.
bool FlipUntilDelaunay(const std::vector<Point2>& points, std::vector<std::size_t> slots,
  Triangulation& mesh, Pulse& pulse);

} // namespace biting

#endif
