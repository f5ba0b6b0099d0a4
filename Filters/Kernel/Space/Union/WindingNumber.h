// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingWindingNumber_h
#define BitingWindingNumber_h

#include "../../Base/BoxTree.h"
#include "../Surface/SurfaceLinks.h"
#include "../Surface/TriangleContact.h"

#include <cmath>   // for abs
#include <cstdint> // for marks
#include <vector>  // for numbers

namespace biting
{

/// The axis along which a vector is longest.
inline std::size_t LongestAxis(const Point3& v)
{
  const std::size_t first = std::abs(v.X) >= std::abs(v.Y) ? 0 : 1;
  return std::abs(v[first]) >= std::abs(v.Z) ? first : 2;
}

/// How often oriented closed surfaces wind around a place: 1 within one that faces outwards.
class WindingNumber
{
public:
  /// `tree`: of the triangles of the mesh.
  WindingNumber(const SurfaceMesh& mesh, const BoxTree<SurfaceItem, 3>& tree)
    : Mesh(mesh)
    , Tree(tree)
  {
  }

  /// Along a ray from the place in the direction of the axis, past the triangles that isSkipped(t).
  template <typename Question>
  int At(const Point3& place, std::size_t axis, const Question& isSkipped) const
  {
    int winding = 0;
    Box3 ray = Box3::Around(place, place);
    ray.High[axis] = Infinity;
    this->Tree.AllOf(ray,
      [this, &place, axis, &isSkipped, &winding](const SurfaceItem& item)
      {
        const std::size_t t = biting::At(item.Triangle);
        Triangle3 turned = this->Mesh.Triangle(t);
        for (Point3& corner : turned)
        {
          corner = Turned(corner, axis);
        }
        if (MeetRay(turned, Turned(place, axis)) && !isSkipped(t))
        {
          winding += this->Mesh.Normal(t)[axis] > 0.0 ? 1 : -1;
        }
        return true;
      });
    return winding;
  }

  /// In front of each triangle that is not marked; 0 for the others. One ray serves all that hang
  /// together at edges without marked ones, which those that cross others have to be.
  std::vector<int> InFront(
    const SurfaceLinks& links, const std::vector<std::uint8_t>& isMarked, Pulse& pulse) const;

private:
  // MeetRay goes along the first axis.
  static Point3 Turned(const Point3& p, std::size_t axis)
  {
    return { p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] };
  }

  const SurfaceMesh& Mesh;
  const BoxTree<SurfaceItem, 3>& Tree;
};

} // namespace biting

#endif
