// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ConeCollector.h"

namespace biting
{

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

} // namespace biting
