// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Source.h"

#include <algorithm> // for min
#include <utility>   // for swap

namespace biting
{
namespace
{

/// Where values between two nodes, which are linear, reach a value.
CellNode Between(const CellNode& low, const CellNode& high, double value)
{
  const double share = (value - low.Scaled) / (high.Scaled - low.Scaled);
  return { low.At + share * (high.At - low.At), value, value };
}

} // namespace

double DistanceOfPoints(double length, double slope)
{
  constexpr double UsualSlope = 0.3;
  return length * std::min(1.0, UsualSlope / std::min(slope, 1.0));
}

void AddLowEdge(CellNode low, CellNode high, const SteepRule& rule, SegmentSource& edges)
{
  constexpr double LengthOfPoint = 0.25;
  if (high.Scaled < low.Scaled)
  {
    std::swap(low, high);
  }
  if (low.Scaled < rule.Range.Most && high.Scaled > rule.Range.Most)
  {
    high = Between(low, high, rule.Range.Most);
  }
  if (low.Scaled < rule.Range.Least && high.Scaled > rule.Range.Least)
  {
    const CellNode least = Between(low, high, rule.Range.Least);
    edges.Add(low.At, least.At, least.Value, least.Value);
    low = least;
  }
  const double length = Distance(low.At, high.At);
  if (high.Value - low.Value <= rule.Slope * length &&
    length > DistanceOfPoints(LengthOfPoint, rule.Slope) * low.Value)
  {
    edges.Add(low.At, high.At, low.Value, high.Value);
  }
}

void AddLevelLine(const std::vector<CellNode>& nodes, const ValueRange& range, SegmentSource& edges)
{
  std::vector<Point2> crossings;
  for (std::size_t k = 0; k < nodes.size(); ++k)
  {
    const CellNode& next = nodes[(k + 1) % nodes.size()];
    if ((nodes[k].Scaled < range.Least) != (next.Scaled < range.Least))
    {
      crossings.push_back(Between(nodes[k], next, range.Least).At);
    }
  }
  for (std::size_t k = 0; k < crossings.size(); k += 2)
  {
    edges.Add(crossings[k], crossings[k + 1], range.Least, range.Least);
  }
}

} // namespace biting
