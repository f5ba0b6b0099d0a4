// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleEdges.h"

#include <algorithm> // for sort
#include <cstdint>   // for sides
#include <numeric>   // for partial_sum

namespace biting
{
namespace
{

/// The higher end of a side, and whether its triangle goes up there, as one number.
using Side = std::uint32_t;

Side SideTo(Id high, bool isUp)
{
  return 2 * static_cast<Side>(high) + (isUp ? 1 : 0);
}

} // namespace

/// Sides are distributed to their lower ends; those of one point are few, and sorted.
TriangleEdges::TriangleEdges(const std::vector<Id>& corners, std::size_t points, Pulse& pulse,
  const std::vector<double>& heights)
  : Firsts(points + 1, 0)
{
  const auto isLower = [&heights](Id a, Id b)
  {
    const double ownHeight = heights.empty() ? 0.0 : heights[static_cast<std::size_t>(a)];
    const double otherHeight = heights.empty() ? 0.0 : heights[static_cast<std::size_t>(b)];
    return ownHeight < otherHeight || (!(otherHeight < ownHeight) && a < b);
  };
  std::vector<std::size_t> begins(points + 1, 0);
  std::vector<Side> sides(corners.size());
  const auto forEachSide = [&corners, &pulse, &isLower](auto visit)
  {
    pulse.ForEach(corners.size() / 3,
      [&corners, &isLower, &visit](std::size_t triangle)
      {
        const Id* own = &corners[3 * triangle];
        for (std::size_t k = 0; k < 3; ++k)
        {
          const Id next = own[k == 2 ? 0 : k + 1];
          const bool isUp = isLower(own[k], next);
          visit(static_cast<std::size_t>(isUp ? own[k] : next), SideTo(isUp ? next : own[k], isUp));
        }
      });
  };
  forEachSide([&begins](std::size_t low, Side) { ++begins[low]; });
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  forEachSide([&begins, &sides](std::size_t low, Side side) { sides[--begins[low]] = side; });
  this->HighEnds.reserve(corners.size() / 2);
  this->AreBorder.reserve(corners.size() / 2);
  pulse.ForEach(points,
    [this, &begins, &sides](std::size_t point)
    {
      Side* first = sides.data() + begins[point];
      Side* last = sides.data() + begins[point + 1];
      std::sort(first, last);
      while (first < last)
      {
        const Side own = *first;
        for (; first < last && *first / 2 == own / 2; ++first)
        {
        }
        this->HighEnds.push_back(static_cast<Id>(own / 2));
        this->AreBorder.push_back(first[-1] == own);
      }
      this->Firsts[point + 1] = this->HighEnds.size();
    });
}

} // namespace biting
