// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPoint2_h
#define BitingPoint2_h

#include <cmath> // for sqrt

namespace biting
{

/// A point or a vector of the plane, in input length units.
struct Point2
{
  double X = 0.0;
  double Y = 0.0;
};

inline Point2 operator+(const Point2& a, const Point2& b)
{
  return { a.X + b.X, a.Y + b.Y };
}

inline Point2 operator-(const Point2& a, const Point2& b)
{
  return { a.X - b.X, a.Y - b.Y };
}

inline Point2 operator*(double factor, const Point2& a)
{
  return { factor * a.X, factor * a.Y };
}

inline bool operator==(const Point2& a, const Point2& b)
{
  return a.X == b.X && a.Y == b.Y;
}

inline bool operator!=(const Point2& a, const Point2& b)
{
  return !(a == b);
}

/// Lexicographic order, x first: the order of a sweep from left to right.
inline bool operator<(const Point2& a, const Point2& b)
{
  return a.X < b.X || (a.X == b.X && a.Y < b.Y);
}

inline double Dot(const Point2& a, const Point2& b)
{
  return a.X * b.X + a.Y * b.Y;
}

/// Cross product, rounded: for lengths and constructions, never for decisions on topology.
inline double Cross(const Point2& a, const Point2& b)
{
  return a.X * b.Y - a.Y * b.X;
}

inline double Length(const Point2& a)
{
  return std::sqrt(Dot(a, a));
}

inline double Distance(const Point2& a, const Point2& b)
{
  return Length(b - a);
}

/// The vector turned by 90 degrees counterclockwise.
inline Point2 Perpendicular(const Point2& a)
{
  return { -a.Y, a.X };
}

inline Point2 Midpoint(const Point2& a, const Point2& b)
{
  return { a.X + 0.5 * (b.X - a.X), a.Y + 0.5 * (b.Y - a.Y) };
}

} // namespace biting

#endif
