// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMover_h
#define BitingMover_h

#include "Base/Point.h"
#include "FuzzNumbers.h"

#include <vector> // for places

namespace biting
{

using Places = std::vector<Point2>;

/// A turn without sine and cosine, which are not the same everywhere: t = tan of half the angle.
struct Turn
{
  double Cosine = 1.0;
  double Sine = 0.0;

  static Turn OfHalfTangent(double t)
  {
    return { (1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t) };
  }

  Point2 operator()(const Point2& p) const
  {
    return { this->Cosine * p.X - this->Sine * p.Y, this->Sine * p.X + this->Cosine * p.Y };
  }
};

/// Moves the drawing to where numbers are less friendly.
class Mover
{
public:
  explicit Mover(FuzzNumbers& numbers)
    : Numbers(numbers)
  {
  }

  void Move(Places& places);

private:
  void Shake(Places& places);
  double Shaken(double coordinate, int kind);
  void Shift(Places& places);
  void Scale(Places& places, double factorX, double factorY);
  void Poison(Places& places);

  FuzzNumbers& Numbers;
};

} // namespace biting

#endif
