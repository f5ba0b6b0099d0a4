// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleSides.h"

#include <algorithm> // for sort
#include <numeric>   // for partial_sum

namespace biting
{

/// Distributed to their lower ends; those of one point are few.
TriangleSides::TriangleSides(
  const TriangulatedSource& source, const std::vector<Id>& triangles, Pulse& pulse)
  : Source(source)
  , Sides(3 * triangles.size())
{
  std::vector<std::size_t> ends(source.Points.size() + 1, 0);
  const auto sideOf = [&triangles](std::size_t k)
  { return static_cast<Id>(3 * triangles[k / 3] + static_cast<Id>(k % 3)); };
  const auto endOf = [this, &ends](Id side) -> std::size_t&
  { return ends[static_cast<std::size_t>(this->LowEnd(side))]; };
  pulse.ForEach(this->Sides.size(), [&](std::size_t k) { ++endOf(sideOf(k)); });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  pulse.ForEach(
    this->Sides.size(), [&](std::size_t k) { this->Sides[--endOf(sideOf(k))] = sideOf(k); });
  pulse.ForEach(source.Points.size(),
    [this, &ends](std::size_t point)
    {
      const auto begin = this->Sides.begin();
      std::sort(begin + static_cast<std::ptrdiff_t>(ends[point]),
        begin + static_cast<std::ptrdiff_t>(ends[point + 1]),
        [this](Id a, Id b)
        { return std::make_pair(this->HighEnd(a), a) < std::make_pair(this->HighEnd(b), b); });
    });
}

} // namespace biting
