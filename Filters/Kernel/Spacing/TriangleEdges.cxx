// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleEdges.h"

#include <algorithm> // for sort
#include <numeric>   // for partial_sum

namespace biting
{

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
  std::vector<Id> highs(corners.size());
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
          visit(static_cast<std::size_t>(isUp ? own[k] : next), isUp ? next : own[k]);
        }
      });
  };
  forEachSide([&begins](std::size_t low, Id) { ++begins[low]; });
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  forEachSide([&begins, &highs](std::size_t low, Id high) { highs[--begins[low]] = high; });
  this->HighEnds.reserve(corners.size() / 2);
  this->AreBorder.reserve(corners.size() / 2);
  pulse.ForEach(points,
    [this, &begins, &highs](std::size_t point)
    {
      Id* first = highs.data() + begins[point];
      Id* last = highs.data() + begins[point + 1];
      std::sort(first, last);
      while (first < last)
      {
        const Id* own = first++;
        for (; first < last && *first == *own; ++first)
        {
        }
        this->HighEnds.push_back(*own);
        this->AreBorder.push_back(first - own == 1);
      }
      this->Firsts[point + 1] = this->HighEnds.size();
    });
}

} // namespace biting
