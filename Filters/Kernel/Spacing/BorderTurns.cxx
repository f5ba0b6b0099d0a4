// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BorderTurns.h"

#include "../Base/SortInSteps.h"

#include <algorithm>  // for bounds
#include <cmath>      // for atan2
#include <functional> // for less

namespace biting
{
namespace
{

constexpr double FullTurn = 6.283185307179586;

double AngleOf(const Point2& direction)
{
  return std::atan2(direction.Y, direction.X);
}

} // namespace

BorderTurns::BorderTurns(const std::vector<BorderEdge>& edges, Pulse& pulse)
{
  this->Ends.reserve(2 * edges.size());
  for (const BorderEdge& edge : edges)
  {
    this->Ends.emplace_back(edge.StartId, AngleOf(edge.End - edge.Start));
    this->Ends.emplace_back(edge.EndId, AngleOf(edge.Start - edge.End));
  }
  SortInSteps(this->Ends, std::less<>(), pulse);
}

double BorderTurns::TurnAround(const BorderEdge& edge) const
{
  const std::pair<Id, double> back(edge.EndId, AngleOf(edge.Start - edge.End));
  const auto first = std::lower_bound(
    this->Ends.begin(), this->Ends.end(), std::pair<Id, double>(edge.EndId, -FullTurn));
  const auto next = std::upper_bound(first, this->Ends.end(), back);
  const bool isLast = next == this->Ends.end() || next->first != edge.EndId;
  return (isLast ? first->second + FullTurn : next->second) - back.second - 0.5 * FullTurn;
}

} // namespace biting
