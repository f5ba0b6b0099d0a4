// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "EdgeCones.h"

namespace biting
{

void AddEdgeCones(const EdgeEnd& start, const EdgeEnd& end, const ValueRange& range,
  double gradation, std::vector<SegmentCone>& cones)
{
  const EdgeEnd& low = end.Value < start.Value ? end : start;
  const EdgeEnd& high = end.Value < start.Value ? start : end;
  const double least = range.Scale * low.Value;
  const double rise = range.Scale * (high.Value - low.Value);
  const double slope = rise / Distance(start.Place, end.Place);
  const auto placeOf = [&low, &high, least, rise](double value)
  { return low.Place + ((value - least) / rise) * (high.Place - low.Place); };
  const bool isCutLow = least < range.Least;
  const bool isCutHigh = least + rise > range.Most;
  const bool isLow = !(least + rise > range.Least);
  const Point2 from = isLow ? high.Place : isCutLow ? placeOf(range.Least) : low.Place;
  const Point2 to = isCutHigh && rise > 0.0 ? placeOf(range.Most) : high.Place;
  if (isCutLow && !(from == low.Place))
  {
    cones.emplace_back(low.Place, from, range.Least, range.Least, gradation);
  }
  if (!isLow && least < range.Most && slope < gradation && !(from == to))
  {
    cones.emplace_back(from, to, range(low.Value), range(high.Value), gradation);
  }
}

} // namespace biting
