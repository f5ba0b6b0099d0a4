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
  std::vector<Id> Corners;
};

/// Makes its triangles better: in turns edges are flipped, by smallest angles and by the numbers of
/// triangles at vertices, and free vertices move to the middle of mass of their triangles, density
/// 1/f^4, on the ground. Then the vertices of the worst triangles are moved by trial. `pieces` are
/// edges that stay, two points each.
/// Law: no step makes a triangle worse than the worst one about it was, but for those whose
/// smallest angle stays above 35 degrees. Triangles stay within 50 degrees of the ground's normals,
/// or as near to them as they were.
void RelaxSurface(
  const SurfaceGround& ground, const std::vector<Id>& pieces, RelaxedSurface& mesh, Pulse& pulse);

} // namespace biting

#endif
