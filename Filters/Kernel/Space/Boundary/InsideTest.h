// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingInsideTest_h
#define BitingInsideTest_h

#include "../../Base/BoxTree.h"
#include "../Features/SurfaceGround.h"

namespace biting
{

/// Whether the ray from the place along the first axis meets the triangle. Exact, and no ray meets
/// an edge: the place counts as moved by an infinitesimal along the third axis and a smaller one
/// along the second. For a place on the triangle the answer may be either.
bool MeetsRay(const std::array<Point3, 3>& triangle, const Point3& place);

/// On which side of surfaces that bound parts of space a place is: along a ray the label changes
/// from one side of each triangle that it meets to the other, so the label of the place is the
/// exclusive or of all of them (MeetsRay). Places on a surface are on either side.
class InsideTest
{
public:
  InsideTest(const SurfaceGround& ground, const BoxTree<SurfaceItem, 3>& tree)
    : Ground(ground)
    , Mesh(ground.Mesh)
    , Tree(tree)
    , Bounds(ground.Mesh.Bounds())
  {
  }

  /// One of TriangleSides; 0: outside.
  Id LabelAt(const Point3& place) const;

private:
  const SurfaceGround& Ground;
  const SurfaceMesh& Mesh;
  const BoxTree<SurfaceItem, 3>& Tree;
  Box3 Bounds;
};

} // namespace biting

#endif
