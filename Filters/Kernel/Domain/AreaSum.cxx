// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "AreaSum.h"

namespace biting
{

void AreaSum::Add(const Point2& start, const Point2& end)
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

void AreaSum::AddMagnitude(const AreaSum& other)
{
  this->Sum.Join(other.Sum, other.Area() < 0.0 ? -1.0 : 1.0);
}

void AreaSum::AddProduct(double a, double b)
{
  const DoubleDouble product = TwoProduct(a, b);
  this->Sum.Add(product.High);
  this->Sum.AddLost(product.Low);
}

} // namespace biting
