// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTetShape_h
#define BitingTetShape_h

#include "../../Base/Point.h"

#include <algorithm> // for max
#include <cmath>     // for abs

namespace biting
{

/// A change is accepted as better only where Badness falls by at least this much.
constexpr double LeastGain = 1e-4;

/// How bad a change may make tetrahedra, the worst of which has `badness`: not quite as bad, or
/// 10 degrees where it is made on trial.
inline double LimitOf(double badness, bool isTrial)
{
  constexpr double At10 = 0.9698463103929542;
  return isTrial ? std::max(badness, At10) : badness - LeastGain;
}

/// A tetrahedron seen from its first corner v: the sides to corners a, b, c, and the normals of the
/// faces opposite these, inwards where it is positive, as long as twice the areas.
struct TetShape
{
  TetShape(const Point3& v, const Point3& a, const Point3& b, const Point3& c)
    : SideA(Minus(a, v))
    , SideB(Minus(b, v))
    , SideC(Minus(c, v))
    , NormalA(Cross(this->SideB, this->SideC))
    , NormalB(Cross(this->SideC, this->SideA))
    , NormalC(Cross(this->SideA, this->SideB))
  {
  }

  /// The signed square of the cosine of the smallest dihedral angle: falls with the angle, 1 / 9
  /// for a regular tetrahedron, 3 / 4 at 30 degrees, 1 for a flat one. Faces i and j have the
  /// cosine -n_i . n_j / (|n_i| |n_j|).
  double Badness() const
  {
    const Point3 normalV{ -this->NormalA.X - this->NormalB.X - this->NormalC.X,
      -this->NormalA.Y - this->NormalB.Y - this->NormalC.Y,
      -this->NormalA.Z - this->NormalB.Z - this->NormalC.Z };
    const double squareA = Dot3(this->NormalA, this->NormalA);
    const double squareB = Dot3(this->NormalB, this->NormalB);
    const double squareC = Dot3(this->NormalC, this->NormalC);
    const double squareV = Dot3(normalV, normalV);
    const double all = (squareA * squareB) * (squareC * squareV);
    if (!(all > 0.0))
    {
      return 1.0;
    }
    const double perA = 1.0 / squareA;
    const double perB = 1.0 / squareB;
    const double perC = 1.0 / squareC;
    const double perV = 1.0 / squareV;
    const auto square = [](const Point3& m, const Point3& n)
    {
      const double dot = -Dot3(m, n);
      return dot * std::abs(dot);
    };
    const double atV = std::max(std::max(square(this->NormalA, this->NormalB) * perA * perB,
                                  square(this->NormalB, this->NormalC) * perB * perC),
      square(this->NormalC, this->NormalA) * perC * perA);
    const double beyond = perV *
      std::max(
        std::max(square(this->NormalA, normalV) * perA, square(this->NormalB, normalV) * perB),
        square(this->NormalC, normalV) * perC);
    return std::max(atV, beyond);
  }

  double SixVolumes() const { return Dot3(this->SideA, this->NormalA); }

  /// From v to the centre of the sphere through the corners, times 12 volumes.
  Point3 WeightedCenter() const
  {
    const double a = Dot3(this->SideA, this->SideA);
    const double b = Dot3(this->SideB, this->SideB);
    const double c = Dot3(this->SideC, this->SideC);
    return { a * this->NormalA.X + b * this->NormalB.X + c * this->NormalC.X,
      a * this->NormalA.Y + b * this->NormalB.Y + c * this->NormalC.Y,
      a * this->NormalA.Z + b * this->NormalB.Z + c * this->NormalC.Z };
  }

private:
  // Unrolled: millions are made.
  static Point3 Minus(const Point3& a, const Point3& b)
  {
    return { a.X - b.X, a.Y - b.Y, a.Z - b.Z };
  }
  static double Dot3(const Point3& a, const Point3& b) { return a.X * b.X + a.Y * b.Y + a.Z * b.Z; }

  Point3 SideA, SideB, SideC;
  Point3 NormalA, NormalB, NormalC;
};

} // namespace biting

#endif
