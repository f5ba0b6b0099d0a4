// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingAreaSum_h
#define BitingAreaSum_h

#include "../Base/Point.h"
#include "../Predicates/CompensatedSum.h"

namespace biting
{

/// The area enclosed by directed segments, as the sum of triangles with one reference point.
/// Products and sums carry their rounding errors along, so that the result is correct to a few ulp
/// even where the area is tiny against the distances.
class AreaSum
{
public:
  explicit AreaSum(const Point2& reference)
    : Reference(reference)
  {
  }

  /// Adds the segment from `start` to `end`, with the area on its left.
  void Add(const Point2& start, const Point2& end)
  {
    const DoubleDouble startX = TwoDifference(start.X, this->Reference.X);
    const DoubleDouble startY = TwoDifference(start.Y, this->Reference.Y);
    const DoubleDouble endX = TwoDifference(end.X, this->Reference.X);
    const DoubleDouble endY = TwoDifference(end.Y, this->Reference.Y);
    this->AddProduct(startX.High, endY.High);
    this->AddProduct(-startY.High, endX.High);
    this->Sum.AddLost(startX.High * endY.Low + startX.Low * endY.High);
    this->Sum.AddLost(-(startY.High * endX.Low + startY.Low * endX.High));
  }

  /// Adds the area of another sum, whatever its sign.
  void AddMagnitude(const AreaSum& other)
  {
    this->Sum.Join(other.Sum, other.Area() < 0.0 ? -1.0 : 1.0);
  }

  double Area() const { return 0.5 * this->Sum.Value(); }

private:
  void AddProduct(double a, double b)
  {
    const DoubleDouble product = TwoProduct(a, b);
    this->Sum.Add(product.High);
    this->Sum.AddLost(product.Low);
  }

  Point2 Reference;
  CompensatedSum Sum;
};

} // namespace biting

#endif
