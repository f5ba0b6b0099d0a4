// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSurfaceCrossings_h
#define BitingSurfaceCrossings_h

#include "../../Base/BoxTree.h"
#include "../../Base/Pulse.h"
#include "SurfaceLinks.h"

#include <vector> // for pairs

namespace biting
{

/// All triangles. Empty where the monitor wants to stop.
BoxTree<SurfaceItem, 3> MakeSurfaceTree(const SurfaceMesh& mesh, Pulse& pulse);

/// Two triangles that have a common point beside the vertices and edges that they share.
struct SurfaceContact
{
  Id First;
  Id Second;
  Point3 Place;
  double Depth; ///< how far one has to be moved until they only touch (DepthOfMeeting)
};

/// All pairs without a common edge, each once, in an order that the mesh decides; exact. Flat
/// triangles meet nothing. Cost O(n log n + pairs of boxes that meet).
std::vector<SurfaceContact> FindContacts(
  const SurfaceMesh& mesh, const BoxTree<SurfaceItem, 3>& tree, Pulse& pulse);

/// Pairs of triangles with a common edge that lie on each other: the apex of the lower one is
/// within `rounding` of the plane of the other, on its side of the edge. The depth is the height of
/// the lower triangle over the edge, and above `rounding`.
std::vector<SurfaceContact> FindFolds(
  const SurfaceMesh& mesh, const SurfaceLinks& links, double rounding, Pulse& pulse);

} // namespace biting

#endif
