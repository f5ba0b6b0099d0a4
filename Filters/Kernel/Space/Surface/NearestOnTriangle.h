// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingNearestOnTriangle_h
#define BitingNearestOnTriangle_h

#include "../../Base/Point.h"

#include <array> // for corners

namespace biting
{

/// The point of the triangle that is nearest to p (C. Ericson, Real-Time Collision Detection, 2005,
/// section 5.1.5: by the regions of corners, sides and the face).
inline Point3 NearestPoint(const std::array<Point3, 3>& t, const Point3& p)
{
  const Point3 ab = t[1] - t[0];
  const Point3 ac = t[2] - t[0];
  const double d1 = Dot(ab, p - t[0]);
  const double d2 = Dot(ac, p - t[0]);
  const double d3 = Dot(ab, p - t[1]);
  const double d4 = Dot(ac, p - t[1]);
  const double d5 = Dot(ab, p - t[2]);
  const double d6 = Dot(ac, p - t[2]);
  const double inC = d1 * d4 - d3 * d2;
  const double inB = d5 * d2 - d1 * d6;
  const double inA = d3 * d6 - d5 * d4;
  const auto along = [](const Point3& from, const Point3& side, double part, double rest)
  { return from + (part + rest > 0.0 ? part / (part + rest) : 0.0) * side; };
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return t[0];
  }
  if (d3 >= 0.0 && d4 <= d3)
  {
    return t[1];
  }
  if (d6 >= 0.0 && d5 <= d6)
  {
    return t[2];
  }
  if (inC <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
  {
    return along(t[0], ab, d1, -d3);
  }
  if (inB <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
  {
    return along(t[0], ac, d2, -d6);
  }
  if (inA <= 0.0 && d4 >= d3 && d5 >= d6)
  {
    return along(t[1], t[2] - t[1], d4 - d3, d5 - d6);
  }
  const double sum = inA + inB + inC;
  return t[0] + (inB / sum) * ab + (inC / sum) * ac;
}

} // namespace biting

#endif
