// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPoint_h
#define BitingPoint_h

#include <cmath>   // for sqrt
#include <cstddef> // for dimensions

namespace biting
{

/// A point or a vector of the plane (D = 2) or of space (D = 3), in input length units.
template <std::size_t D>
struct Point;

template <>
struct Point<3>
{
  double X = 0.0;
  double Y = 0.0;
  double Z = 0.0;

  double operator[](std::size_t d) const { return d == 0 ? this->X : d == 1 ? this->Y : this->Z; }
  double& operator[](std::size_t d) { return d == 0 ? this->X : d == 1 ? this->Y : this->Z; }

  // The coordinates as an array.
  const double* begin() const { return &this->X; }
  const double* end() const { return &this->X + 3; }
  double* begin() { return &this->X; }
  double* end() { return &this->X + 3; }
  double* Data() { return &this->X; }
  const double* Data() const { return &this->X; }
};

template <>
struct Point<2>
{
  double X = 0.0;
  double Y = 0.0;

  double operator[](std::size_t d) const { return d == 0 ? this->X : this->Y; }
  double& operator[](std::size_t d) { return d == 0 ? this->X : this->Y; }

  /// The plane lies in space at z = 0.
  operator Point<3>() const { return { this->X, this->Y, 0.0 }; }
};

using Point2 = Point<2>;
using Point3 = Point<3>;

/// The foot of a point of space on the plane z = 0.
inline Point2 InPlane(const Point3& p)
{
  return { p.X, p.Y };
}

template <std::size_t D>
Point<D> operator+(Point<D> a, const Point<D>& b)
{
  for (std::size_t d = 0; d < D; ++d)
  {
    a[d] += b[d];
  }
  return a;
}

template <std::size_t D>
Point<D> operator-(Point<D> a, const Point<D>& b)
{
  for (std::size_t d = 0; d < D; ++d)
  {
    a[d] -= b[d];
  }
  return a;
}

template <std::size_t D>
Point<D> operator*(double factor, Point<D> a)
{
  for (std::size_t d = 0; d < D; ++d)
  {
    a[d] *= factor;
  }
  return a;
}

template <std::size_t D>
bool operator==(const Point<D>& a, const Point<D>& b)
{
  bool isEqual = true;
  for (std::size_t d = 0; d < D; ++d)
  {
    isEqual = isEqual && a[d] == b[d];
  }
  return isEqual;
}

template <std::size_t D>
bool operator!=(const Point<D>& a, const Point<D>& b)
{
  return !(a == b);
}

/// Lexicographic order, x first: the order of a sweep from left to right.
template <std::size_t D>
bool operator<(const Point<D>& a, const Point<D>& b)
{
  std::size_t d = 0;
  while (d + 1 < D && a[d] == b[d])
  {
    ++d;
  }
  return a[d] < b[d];
}

template <std::size_t D>
double Dot(const Point<D>& a, const Point<D>& b)
{
  double sum = a[0] * b[0];
  for (std::size_t d = 1; d < D; ++d)
  {
    sum += a[d] * b[d];
  }
  return sum;
}

/// Cross product, rounded: for lengths and constructions, never for decisions on topology.
inline double Cross(const Point2& a, const Point2& b)
{
  return a.X * b.Y - a.Y * b.X;
}

inline Point3 Cross(const Point3& a, const Point3& b)
{
  return { a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X };
}

template <std::size_t D>
double Length(const Point<D>& a)
{
  return std::sqrt(Dot(a, a));
}

template <std::size_t D>
double Distance(const Point<D>& a, const Point<D>& b)
{
  return Length(b - a);
}

/// The vector turned by 90 degrees counterclockwise.
inline Point2 Perpendicular(const Point2& a)
{
  return { -a.Y, a.X };
}

template <std::size_t D>
Point<D> Midpoint(const Point<D>& a, const Point<D>& b)
{
  return a + 0.5 * (b - a);
}

} // namespace biting

#endif
