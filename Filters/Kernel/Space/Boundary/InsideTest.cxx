// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "InsideTest.h"

#include "../Surface/TriangleContact.h" // for MeetRay

namespace biting
{

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
      const bool isMet = MeetRay(this->Mesh.Triangle(At(item.Triangle)), place);
      label ^= isMet ? sides[0] ^ sides[1] : 0;
      return true;
    });
  return label;
}

} // namespace biting
