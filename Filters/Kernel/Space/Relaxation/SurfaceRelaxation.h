// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSurfaceRelaxation_h
#define BitingSurfaceRelaxation_h

#include "../../Base/Pulse.h"
#include "../Features/SurfaceGround.h"

#include <vector> // for the arrays

namespace biting
{

/// A mesh on a ground that is relaxed.
struct RelaxedSurface
{
  std::vector<Point3> Points;
  std::vector<double> Sizes;        ///< f at points
  std::vector<Id> Triangles;        ///< of points: the triangle of the ground that each lies on
  std::vector<std::uint8_t> IsFree; ///< 1: it may move on its patch
  std::vector<Id> Chains;           ///< of points: the chain that each may slide along, or NoId
  std::vector<Id> Corners;
};

/// Makes its triangles better: in turns edges are flipped, by smallest angles and by the numbers of
/// triangles at vertices, and vertices move to the middle of mass of their triangles, density
/// 1/f^4: free ones on the ground, those of chains along their chains. Then the vertices of the
/// worst triangles are moved by trial. At last edges are flipped and free vertices moved by trial
/// where middles of triangles are farther than .08 f from the ground, unless more than an eighth
/// are. `pieces` are edges that stay, two points each.
/// Laws: no step makes a triangle worse than the worst one about it was, but for those whose
/// smallest angle stays above 35 degrees; steps towards the ground none but for those above 38.
/// Triangles stay within 50 degrees of the ground's normals, or as near to them as they were.
/// Vertices of chains stay on them, in order.
void RelaxSurface(
  const SurfaceGround& ground, const std::vector<Id>& pieces, RelaxedSurface& mesh, Pulse& pulse);

} // namespace biting

#endif
