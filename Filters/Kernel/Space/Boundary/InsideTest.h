// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingInsideTest_h
#define BitingInsideTest_h

#include "../../Base/BoxTree.h"
#include "../Features/SurfaceGround.h"
#include "../Surface/NearestOnTriangle.h"

#include <utility> // for pairs

namespace biting
{

/// Any triangle is wanted.
struct AnyTriangle
{
  bool operator()(Id) const { return true; }
};

/// Of the triangles nearer to the place than `most` for which isWanted(triangle) the nearest, and
/// its distance; else NoId and `most`. `tree`: of the triangles of the mesh.
template <typename Question = AnyTriangle>
std::pair<Id, double> NearestTriangle(const SurfaceMesh& mesh, const BoxTree<SurfaceItem, 3>& tree,
  const Point3& place, double most, const Question& isWanted = {})
{
  std::pair<Id, double> nearest{ NoId, most };
  tree.Search(place, 1.0, most,
    [&mesh, &place, &nearest, &isWanted](const SurfaceItem& item, double)
    {
      if (item.Bounds.DistanceTo(place) >= nearest.second)
      {
        return nearest.second;
      }
      const double distance =
        Distance(NearestPoint(mesh.Triangle(At(item.Triangle)), place), place);
      const bool isNearest = distance < nearest.second && isWanted(item.Triangle);
      nearest = isNearest ? std::make_pair(item.Triangle, distance) : nearest;
      return nearest.second;
    });
  return nearest;
}

/// On which side of surfaces that bound parts of space a place is: along a ray the label changes
/// from one side of each triangle that it meets to the other, so the label of the place is the
/// exclusive or of all of them (MeetRay). Places on a surface are on either side.
class InsideTest
{
public:
  /// `sides`, `tree`: of the triangles of the mesh.
  InsideTest(const SurfaceMesh& mesh, const std::vector<TriangleSides>& sides,
    const BoxTree<SurfaceItem, 3>& tree)
    : Mesh(mesh)
    , Sides(sides)
    , Tree(tree)
    , Bounds(mesh.Bounds())
  {
  }

  /// One of TriangleSides; 0: outside.
  Id LabelAt(const Point3& place) const;

private:
  const SurfaceMesh& Mesh;
  const std::vector<TriangleSides>& Sides;
  const BoxTree<SurfaceItem, 3>& Tree;
  Box3 Bounds;
};

} // namespace biting

#endif
