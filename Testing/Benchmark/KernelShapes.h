// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingKernelShapes_h
#define BitingKernelShapes_h

#include "BitingMesh.h"

#include <benchmark/benchmark.h>

#include <cmath>   // for sqrt, sin, cos
#include <cstdint> // for random numbers
#include <map>     // for meshes already made
#include <vector>  // for points

namespace biting
{

// What the benchmarks of the rooms share.

constexpr Id NumberOfQueries = 1 << 16;

// Points of the unit square, the same everywhere.
inline std::vector<Point2> RandomPoints(Id count)
{
  std::vector<Point2> points;
  std::uint64_t state = 1;
  const auto roll = [&state]()
  {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state >> 33) * 0x1p-31;
  };
  for (Id i = 0; i < count; ++i)
  {
    const double x = roll();
    points.push_back({ x, roll() });
  }
  return points;
}

inline Polylines Loop(const std::vector<Point2>& points)
{
  Polylines loop;
  loop.Points = points;
  for (std::size_t i = 0; i <= points.size(); ++i)
  {
    loop.Connectivity.push_back(static_cast<Id>(i % points.size()));
  }
  loop.Offsets.push_back(static_cast<Id>(loop.Connectivity.size()));
  loop.Kinds = { ChainKind::Automatic };
  loop.Cells = { 0 };
  return loop;
}

inline Polylines Square(double side)
{
  return Loop({ { 0, 0 }, { side, 0 }, { side, side }, { 0, side } });
}

// A coast: a closed curve with bays of all lengths, without crossings.
inline Polylines Coast(Id numberOfPoints)
{
  std::vector<Point2> points;
  for (Id i = 0; i < numberOfPoints; ++i)
  {
    const double angle = 6.283185307179586 * i / numberOfPoints;
    double radius = 0.4;
    for (int wave = 3; wave < 1000; wave *= 3)
    {
      radius += 0.1 / wave * std::sin(wave * angle + wave);
    }
    points.push_back({ 0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle) });
  }
  return Loop(points);
}

inline Domain DomainOf(const Polylines& input)
{
  ProblemList problems;
  SilentMonitor monitor;
  return MakeDomain(input, {}, problems, monitor);
}

inline BitingMeshOptions UniformOptions(double vertices)
{
  BitingMeshOptions options;
  options.Spacing.Uniform = std::sqrt(1.25 / vertices);
  return options;
}

inline const BitingMesh& UniformMesh(std::int64_t vertices)
{
  static std::map<std::int64_t, BitingMesh> meshes;
  const auto [entry, isNew] = meshes.try_emplace(vertices);
  if (isNew)
  {
    ProblemList problems;
    SilentMonitor monitor;
    entry->second =
      MakeBitingMesh(Square(1.0), UniformOptions(static_cast<double>(vertices)), problems, monitor);
  }
  return entry->second;
}

// An open chain of its own.
inline void AddSegment(const Point2& start, const Point2& end, Polylines& lines)
{
  for (const Point2& p : { start, end })
  {
    lines.Connectivity.push_back(static_cast<Id>(lines.Points.size()));
    lines.Points.push_back(p);
  }
  lines.Offsets.push_back(static_cast<Id>(lines.Connectivity.size()));
  lines.Kinds.push_back(ChainKind::Interface);
  lines.Cells.push_back(static_cast<Id>(lines.Cells.size()));
}

// Long interfaces side by side, which no vertex of another is near.
inline Polylines Hatches(Id count)
{
  Polylines lines = Square(1.0);
  for (Id i = 0; i < count; ++i)
  {
    const double x = 0.05 + 0.4 * i / count;
    AddSegment({ x, 0.25 }, { x + 0.4, 0.75 }, lines);
  }
  return lines;
}

template <typename Count>
void Report(benchmark::State& state, Count pointsPerIteration)
{
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pointsPerIteration));
}

} // namespace biting

#endif
