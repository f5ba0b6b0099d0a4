// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ConeCollector.h"

#include <utility> // for swap

namespace biting
{
namespace
{

Point2 PointAt(const Point2& start, const Point2& end, double weight)
{
  return start + weight * (end - start);
}

} // namespace

void ConeCollector::AddPoint(const Point2& place, double spacing)
{
  const auto point = static_cast<Id>(this->Source.Points.size());
  this->Source.Points.push_back(place);
  this->Source.Values.push_back(spacing);
  this->Source.Segments.insert(this->Source.Segments.end(), { point, point });
}

void ConeCollector::AddSegment(
  const Point2& start, const Point2& end, double startSpacing, double endSpacing)
{
  const auto point = static_cast<Id>(this->Source.Points.size());
  this->Source.Points.insert(this->Source.Points.end(), { start, end });
  this->Source.Values.insert(this->Source.Values.end(), { startSpacing, endSpacing });
  this->Source.Segments.insert(this->Source.Segments.end(), { point, point + 1 });
}

void ConeCollector::AddGiven(
  const Point2& start, const Point2& end, double startValue, double endValue)
{
  Point2 low = start;
  Point2 high = end;
  double lowest = this->Range.Scale * startValue;
  double highest = this->Range.Scale * endValue;
  if (highest < lowest)
  {
    std::swap(low, high);
    std::swap(lowest, highest);
  }
  const double rise = highest - lowest;
  if (lowest >= this->Range.Most)
  {
    return;
  }
  if (highest > this->Range.Most)
  {
    high = PointAt(low, high, (this->Range.Most - lowest) / rise);
    highest = this->Range.Most;
  }
  if (highest <= this->Range.Least)
  {
    this->AddSegment(low, high, this->Range.Least, this->Range.Least);
    return;
  }
  if (lowest < this->Range.Least)
  {
    const Point2 bend = PointAt(low, high, (this->Range.Least - lowest) / (highest - lowest));
    this->AddSegment(low, bend, this->Range.Least, this->Range.Least);
    low = bend;
    lowest = this->Range.Least;
  }
  this->AddSegment(low, high, lowest, highest);
}

} // namespace biting
