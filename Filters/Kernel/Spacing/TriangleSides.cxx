// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleSides.h"

#include <algorithm> // for sort
#include <cstdint>   // for keys
#include <numeric>   // for partial_sum

namespace biting
{

/// Distributed to their lower ends; those of one point are few, and sorted by their other ends.
TriangleSides::TriangleSides(
  const TriangulatedSource& source, const std::vector<Id>& triangles, Pulse& pulse)
  : Source(source)
{
  constexpr int IdBits = 32;
  std::vector<std::size_t> begins(source.Points.size() + 1, 0);
  std::vector<std::uint64_t> keys(3 * triangles.size());
  const auto forEachSide = [this, &triangles, &pulse](auto visit)
  {
    pulse.ForEach(triangles.size(),
      [this, &triangles, &visit](std::size_t k)
      {
        for (Id side = 3 * triangles[k]; side < 3 * triangles[k] + 3; ++side)
        {
          visit(side, static_cast<std::size_t>(this->LowEnd(side)));
        }
      });
  };
  forEachSide([&begins](Id, std::size_t low) { ++begins[low]; });
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  forEachSide(
    [this, &begins, &keys](Id side, std::size_t low)
    {
      keys[--begins[low]] = static_cast<std::uint64_t>(this->HighEnd(side)) << IdBits |
        static_cast<std::uint64_t>(side);
    });
  this->Sides.reserve(keys.size());
  this->Firsts.reserve(keys.size() / 2);
  pulse.ForEach(source.Points.size(),
    [this, &begins, &keys](std::size_t point)
    {
      const std::size_t begin = begins[point];
      std::sort(keys.begin() + static_cast<std::ptrdiff_t>(begin),
        keys.begin() + static_cast<std::ptrdiff_t>(begins[point + 1]));
      for (std::size_t k = begin; k < begins[point + 1]; ++k)
      {
        if (k == begin || keys[k] >> IdBits != keys[k - 1] >> IdBits)
        {
          this->Firsts.push_back(this->Sides.size());
        }
        this->Sides.push_back(static_cast<Id>(keys[k] & 0xFFFFFFFFu));
      }
    });
  this->Firsts.push_back(this->Sides.size());
}

} // namespace biting
