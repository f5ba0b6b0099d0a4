// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTriangleLimits_h
#define BitingTriangleLimits_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "MutableMesh.h"
#include "Star.h" // for the measure of angles

#include <cstddef> // for sizes

namespace biting
{

/// What sets good triangles apart from those that are looked at more closely.
struct TriangleLimits
{
  double Shortest;  ///< edge, in spacings
  double Longest;   ///< edge, in spacings
  double Cotangent; ///< of the smallest angle, the greatest one
};

/// Whether a triangle is within the limits by more than rounding, so that it is whichever corner it
/// is seen from. Most triangles are, and this takes no root.
inline bool IsSurelyWithin(const MutableMesh& mesh, Id triangle, const TriangleLimits& limits)
{
  constexpr double Margin = 1e-9; // of lengths and cotangents: far above rounding
  const double least = 0.25 * (1.0 + Margin) * limits.Shortest * limits.Shortest;
  const double greatest = 0.25 * (1.0 - Margin) * limits.Longest * limits.Longest;
  const auto isWithin = [least, greatest](double square, double sumOfSpacings)
  {
    const double unit = sumOfSpacings * sumOfSpacings;
    return square > least * unit && square < greatest * unit;
  };
  const Id* corners = mesh.Corners.data() + 4 * static_cast<std::size_t>(triangle);
  const Point2& a = mesh.Points[corners[0]];
  const double atA = mesh.Spacings[corners[0]];
  const Point2 p = mesh.Points[corners[1]] - a;
  const double pp = Dot(p, p);
  const double atP = mesh.Spacings[corners[1]];
  if (!isWithin(pp, atA + atP))
  {
    return false;
  }
  const Point2 q = mesh.Points[corners[2]] - a;
  const double qq = Dot(q, q);
  const double atQ = mesh.Spacings[corners[2]];
  return isWithin(qq, atA + atQ) && isWithin(Dot(q - p, q - p), atP + atQ) &&
    WorstCotangent(p, q, pp, qq) < (1.0 - Margin) * limits.Cotangent;
}

} // namespace biting

#endif
