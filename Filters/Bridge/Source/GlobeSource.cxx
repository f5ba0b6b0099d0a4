// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GlobeSource.h"

#include "SpacingValues.h"

#include <algorithm> // for clamp, none_of
#include <cstddef>   // for steps
#include <cstdint>   // for marks
#include <utility>   // for move

namespace biting
{

namespace
{

constexpr double LeastLevel = -0.996; // about the cosine of 175 degrees

// In degrees: each cell two triangles.
TriangulatedSource TrianglesOf(const GridSource& grid)
{
  TriangulatedSource source;
  source.Values = grid.Values;
  source.Points.reserve(grid.Values.size());
  source.Triangles.reserve(6 * grid.Values.size());
  for (const double y : grid.YNodes)
  {
    for (const double x : grid.XNodes)
    {
      source.Points.push_back({ x, y });
    }
  }
  const auto width = static_cast<Id>(grid.XNodes.size());
  for (Id row = 1; row < static_cast<Id>(grid.YNodes.size()); ++row)
  {
    for (Id k = row * width + 1; k < (row + 1) * width; ++k)
    {
      const Id below = k - width;
      source.Triangles.insert(source.Triangles.end(), { below - 1, below, k, below - 1, k, k - 1 });
    }
  }
  return source;
}

} // namespace

std::shared_ptr<const TriangulatedSource> SourceOnGlobe(
  const PlaneFrame& frame, const GivenSource& source, Pulse& pulse)
{
  const auto* grid = std::get_if<std::shared_ptr<const GridSource>>(&source);
  auto mapped = std::make_shared<TriangulatedSource>(
    grid ? TrianglesOf(**grid) : *std::get<std::shared_ptr<const TriangulatedSource>>(source));
  std::vector<std::uint8_t> isFar;
  isFar.reserve(mapped->Points.size());
  for (Point2& point : mapped->Points)
  {
    const Point3 degrees{ point.X, std::clamp(point.Y, -90.0, 90.0), 0.0 };
    isFar.push_back(frame.LevelOf(degrees.Data()) < LeastLevel);
    point = isFar.back() ? Point2() : frame.ToPlane(degrees.Data());
  }
  std::vector<Id> near;
  near.reserve(mapped->Triangles.size());
  for (std::size_t k = 0; k < mapped->Triangles.size() && pulse.Beat(); k += 3)
  {
    const auto first = mapped->Triangles.begin() + static_cast<std::ptrdiff_t>(k);
    if (std::none_of(first, first + 3, [&isFar](Id point) { return isFar[point] != 0; }))
    {
      near.insert(near.end(), first, first + 3);
    }
  }
  mapped->Triangles = std::move(near);
  SortSource(*mapped, pulse);
  mapped->MayOverlap = true;
  return mapped;
}

} // namespace biting
