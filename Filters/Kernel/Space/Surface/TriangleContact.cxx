// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleContact.h"

#include "../../Base/Numbers.h"
#include "../../Predicates/Predicates.h"
#include "../../Predicates/Predicates3.h"

#include <algorithm> // for max, min
#include <cmath>     // for abs

namespace biting
{

namespace
{

// The shadow along the axis.
Point2 Shadow(const Point3& p, std::size_t axis)
{
  return { p[(axis + 1) % 3], p[(axis + 2) % 3] };
}

// Sign of (a, b, p) where p is moved by (e, e^2), for an e that is small beyond all numbers: never
// 0 where a and b differ.
int MovedSide(const Point2& a, const Point2& b, const Point2& p)
{
  const int side = Orient2D(a, b, p);
  const double slope = a.Y != b.Y ? a.Y - b.Y : b.X - a.X;
  return side != 0 ? side : (slope > 0.0) - (slope < 0.0);
}

// Where the triangle and pq lie in one plane: by their shadows along an axis that keep the triangle
// a triangle.
bool MeetsInPlane(const Triangle3& t, const Point3& p, const Point3& q, Point3& place)
{
  std::size_t axis = 0;
  while (axis < 3 && Orient2D(Shadow(t[0], axis), Shadow(t[1], axis), Shadow(t[2], axis)) == 0)
  {
    ++axis;
  }
  if (axis == 3)
  {
    return false; // flat
  }
  const Point2 a = Shadow(p, axis);
  const Point2 b = Shadow(q, axis);
  bool isInside = true;
  int turn = 0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Point2 c = Shadow(t[k], axis);
    const Point2 d = Shadow(t[(k + 1) % 3], axis);
    if (Meet(a, b, c, d) != Meeting::None)
    {
      place = IsOnSegment(a, c, d) ? p : IsOnSegment(b, c, d) ? q : t[k];
      return true;
    }
    const int side = Orient2D(c, d, a);
    isInside = isInside && (turn == 0 || side == turn);
    turn = side;
  }
  place = p;
  return isInside;
}

// The least overlap of the shadows of two triangles along directions that are not too short.
class Overlap
{
public:
  Overlap(const Triangle3& a, const Triangle3& b)
    : A(a)
    , B(b)
  {
  }

  void Try(const Point3& direction, double least)
  {
    const double length = biting::Length(direction);
    if (length <= least)
    {
      return;
    }
    double lowA = Dot(this->A[0] - this->A[0], direction);
    double highA = lowA;
    double lowB = Dot(this->B[0] - this->A[0], direction);
    double highB = lowB;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double inA = Dot(this->A[k] - this->A[0], direction);
      const double inB = Dot(this->B[k] - this->A[0], direction);
      lowA = std::min(lowA, inA);
      highA = std::max(highA, inA);
      lowB = std::min(lowB, inB);
      highB = std::max(highB, inB);
    }
    const double overlap = std::min(highA - lowB, highB - lowA) / length;
    this->Least = std::min(this->Least, std::max(overlap, 0.0));
  }

  double Least = Infinity;

private:
  const Triangle3& A;
  const Triangle3& B;
};

// Whether a plane across the direction between the middles separates the triangles, through the
// shared corner, if there is one: then nothing exact has to be computed, as it would for most pairs
// in one plane. A product with the direction has three differences (1), products (2) and two sums
// (4 in all): its error is below 5 u times the sum of magnitudes, which rounding may have lowered
// by as much: 8 u is above. In the second bound that of the subtraction is within 16 u.
bool AreApart(const Triangle3& a, const Triangle3& b, std::size_t shared)
{
  constexpr double Bound = 16.0 * 0x1p-53;
  const Point3& origin = a[0];
  const auto middle = [&origin, shared](const Triangle3& t)
  {
    const Point3 sum = (t[1] - origin) + (t[2] - origin);
    const double length = Length(sum);
    return shared > 0 ? (length > 0.0 ? 1.0 / length : 0.0) * sum : sum + (t[0] - origin);
  };
  const Point3 direction = middle(a) - middle(b);
  double low = Infinity;
  double high = -Infinity;
  for (std::size_t k = shared; k < 3; ++k)
  {
    const auto add = [&origin, &direction](const Point3& p, double side)
    {
      const Point3 v = p - origin;
      const double size =
        std::abs(v.X * direction.X) + std::abs(v.Y * direction.Y) + std::abs(v.Z * direction.Z);
      return Dot(v, direction) + side * Bound * size;
    };
    low = std::min(low, add(a[k], -1.0));
    high = std::max(high, add(b[k], 1.0));
  }
  return shared > 0 ? low > 0.0 && high < 0.0 : low > high;
}

// Whether all corners of a that are not shared lie strictly on one side of the plane of b: then a
// has no other point in it.
bool IsBeside(const Triangle3& a, const Triangle3& b, std::size_t shared)
{
  const int side = HeightOver(b, a[2]);
  return side != 0 && HeightOver(b, a[1]) == side && (shared > 0 || HeightOver(b, a[0]) == side);
}

} // namespace

int HeightOver(const Triangle3& triangle, const Point3& p)
{
  return Orient3D(triangle[0], triangle[1], triangle[2], p);
}

bool MeetRay(const Triangle3& triangle, const Point3& p)
{
  const Point2 a = Shadow(triangle[0], 0);
  const Point2 b = Shadow(triangle[1], 0);
  const Point2 c = Shadow(triangle[2], 0);
  const int side = MovedSide(a, b, Shadow(p, 0));
  if (side == 0 || MovedSide(b, c, Shadow(p, 0)) != side || MovedSide(c, a, Shadow(p, 0)) != side)
  {
    return false;
  }
  // The shadow is counterclockwise (side > 0) if the normal has a positive x: then p is before the
  // triangle where it is behind its back.
  return HeightOver(triangle, p) * side < 0;
}

bool Meets(const Triangle3& triangle, const Point3& p, const Point3& q, Point3& place)
{
  const int sideP = HeightOver(triangle, p);
  const int sideQ = HeightOver(triangle, q);
  if (sideP * sideQ > 0)
  {
    return false;
  }
  if (sideP == 0 && sideQ == 0)
  {
    return MeetsInPlane(triangle, p, q, place);
  }
  bool isLeft = false;
  bool isRight = false;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const int turn = Orient3D(p, q, triangle[k], triangle[(k + 1) % 3]);
    isLeft = isLeft || turn > 0;
    isRight = isRight || turn < 0;
  }
  if (isLeft && isRight)
  {
    return false;
  }
  const Point3 normal = Cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  const double heightP = std::abs(Dot(p - triangle[0], normal));
  const double heightQ = std::abs(Dot(q - triangle[0], normal));
  const double sum = heightP + heightQ;
  place = p + (sum > 0.0 ? heightP / sum : 0.0) * (q - p);
  return true;
}

bool Meet(const Triangle3& a, const Triangle3& b, std::size_t shared, Point3& place)
{
  if (AreApart(a, b, shared) || IsBeside(a, b, shared) || IsBeside(b, a, shared))
  {
    return false;
  }
  if (shared == 1)
  {
    return Meets(b, a[1], a[2], place) || Meets(a, b[1], b[2], place);
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (Meets(b, a[k], a[(k + 1) % 3], place) || Meets(a, b[k], b[(k + 1) % 3], place))
    {
      return true;
    }
  }
  return false;
}

double DepthOfMeeting(const Triangle3& a, const Triangle3& b)
{
  constexpr double Parallel = 1e-6; // a sine below which cross products are noise
  Overlap overlap(a, b);
  const Point3 normalA = Cross(a[1] - a[0], a[2] - a[0]);
  const Point3 normalB = Cross(b[1] - b[0], b[2] - b[0]);
  overlap.Try(normalA, 0.0);
  overlap.Try(normalB, 0.0);
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Point3 sideA = a[(i + 1) % 3] - a[i];
    const Point3 sideB = b[(i + 1) % 3] - b[i];
    overlap.Try(Cross(normalA, sideA), 0.0);
    overlap.Try(Cross(normalB, sideB), 0.0);
    for (std::size_t j = 0; j < 3; ++j)
    {
      const Point3 other = b[(j + 1) % 3] - b[j];
      overlap.Try(Cross(sideA, other), Parallel * Length(sideA) * Length(other));
    }
  }
  return overlap.Least;
}

} // namespace biting
