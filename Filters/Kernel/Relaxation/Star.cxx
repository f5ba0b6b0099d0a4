// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Star.h"

#include "../Predicates/Predicates.h"

namespace biting
{

bool IsValidAt(const MutableMesh& mesh, const Star& star, const Point2& place)
{
  for (int k = 0; k < star.NumberOfTriangles; ++k)
  {
    if (Orient2D(place, mesh.Points[star.Vertices[k]], mesh.Points[star.Vertices[k + 1]]) <= 0)
    {
      return false;
    }
  }
  return true;
}

} // namespace biting
