// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "InsideTest.h"

#include "../../Predicates/Predicates.h"
#include "../../Predicates/Predicates3.h"

#include <utility> // for swap

namespace biting
{

namespace
{

Point2 Shadow(const Point3& p)
{
  return { p.Y, p.Z };
}

/// Whether the ray in the plane from p upwards (along z) crosses the segment. An end at the height
/// of p along y counts as left of it; p on the segment is below it.
bool IsBelow(const Point2& p, Point2 a, Point2 b)
{
  if ((a.X > p.X) == (b.X > p.X))
  {
    return false;
  }
  if (b.X < a.X)
  {
    std::swap(a, b);
  }
  return Orient2D(a, b, p) <= 0;
}

} // namespace

bool MeetsRay(const std::array<Point3, 3>& corners, const Point3& place)
{
  const Point2 p = Shadow(place);
  bool isWithin = false;
  for (std::size_t k = 0; k < 3; ++k)
  {
    isWithin ^= IsBelow(p, Shadow(corners[k]), Shadow(corners[(k + 1) % 3]));
  }
  if (!isWithin)
  {
    return false;
  }
  // Before or behind: the sides of the place and of a point far along the ray differ.
  const int turn = Orient2D(Shadow(corners[0]), Shadow(corners[1]), Shadow(corners[2]));
  return turn * Orient3D(corners[0], corners[1], corners[2], place) < 0;
}

Id InsideTest::LabelAt(const Point3& place) const
{
  Id label = 0;
  if (!this->Bounds.Contains(place))
  {
    return label;
  }
  const Box3 ray = Box3::Around(place, { this->Bounds.High.X, place.Y, place.Z });
  this->Tree.AllOf(ray,
    [this, &place, &label](const SurfaceItem& item)
    {
      const TriangleSides& sides = this->Sides[At(item.Triangle)];
      const bool isMet = MeetsRay(this->Mesh.Triangle(At(item.Triangle)), place);
      label ^= isMet ? sides[0] ^ sides[1] : 0;
      return true;
    });
  return label;
}

} // namespace biting
