// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Spacing, what is made once and what is asked several times for each vertex: a part of
// BenchmarkKernel.

#include "KernelShapes.h"
#include "PaperSpacing.h"

#include "Domain/DomainLocator.h"
#include "Spacing/Spacing.h"

#include <benchmark/benchmark.h>

#include <algorithm> // for max
#include <cmath>     // for sqrt, sin, cos, floor
#include <memory>    // for sources
#include <utility>   // for move
#include <vector>    // for points

namespace biting
{

namespace
{

SpacingOptions UniformSource()
{
  SpacingOptions options;
  options.Uniform = 0.01;
  return options;
}

SpacingOptions GridOfNodes()
{
  constexpr int Intervals = 1000;
  auto grid = std::make_shared<GridSource>();
  for (int i = 0; i <= Intervals; ++i)
  {
    grid->XNodes.push_back(1.0 * i / Intervals);
    grid->YNodes.push_back(1.0 * i / Intervals);
  }
  for (const double y : grid->YNodes)
  {
    for (const double x : grid->XNodes)
    {
      grid->Values.push_back(0.01 * (1.0 + 0.5 * std::sin(9.0 * x) * std::cos(7.0 * y)));
    }
  }
  SpacingOptions options;
  options.Sources.emplace_back(grid);
  return options;
}

SpacingOptions TrianglesOfSource()
{
  const BitingMesh& mesh = UniformMesh(100000);
  auto source = std::make_shared<TriangulatedSource>();
  source->Points = mesh.Points;
  source->Triangles = mesh.Corners;
  for (const Point2& p : mesh.Points)
  {
    source->Values.push_back(0.01 * (1.0 + 0.5 * std::sin(9.0 * p.X) * std::cos(7.0 * p.Y)));
  }
  SpacingOptions options;
  options.Sources.emplace_back(source);
  return options;
}

SpacingOptions SegmentsOfCoast()
{
  const Polylines coast = Coast(10000);
  auto source = std::make_shared<SegmentSource>();
  source->Points = coast.Points;
  source->Values.assign(coast.Points.size(), 0.001);
  for (std::size_t i = 0; i + 1 < coast.Connectivity.size(); ++i)
  {
    source->Segments.push_back(coast.Connectivity[i]);
    source->Segments.push_back(coast.Connectivity[i + 1]);
  }
  SpacingOptions options;
  options.Sources.emplace_back(source);
  return options;
}

Spacing SpacingOf(const SpacingOptions& options)
{
  ProblemList problems;
  SilentMonitor monitor;
  return MakeSpacing(options, { { 0, 0 }, { 1, 1 } }, problems, monitor);
}

void SpacingPreparation(benchmark::State& state, SpacingOptions (*source)())
{
  const SpacingOptions options = source();
  for (auto step : state)
  {
    static_cast<void>(step);
    benchmark::DoNotOptimize(SpacingOf(options)({ 0.5, 0.5 }));
  }
}
BENCHMARK_CAPTURE(SpacingPreparation, Grid1M, GridOfNodes)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(SpacingPreparation, Triangles200k, TrianglesOfSource)
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(SpacingPreparation, Segments10k, SegmentsOfCoast)->Unit(benchmark::kMillisecond);

// Sources by kind and size: items per second are pixels, triangles or segments.

enum FieldKind
{
  Smooth,
  Slope09,
  Slope1,
  Slope101,
  Slope2,
  Noise20,
  Noise90,
  Jump,
  Holes,
  Fill,
  NumberOfFieldKinds
};

// Distances to seven by seven holes, times `slope`.
double AroundHoles(const Point2& x, double slope)
{
  const Point2 offset{ 7.0 * x.X - std::floor(7.0 * x.X) - 0.5,
    7.0 * x.Y - std::floor(7.0 * x.Y) - 0.5 };
  return 0.003 + slope * std::max(Length(offset) / 7.0 - 0.02, 0.0);
}

double FieldValue(int kind, const Point2& x, double random)
{
  const double wave = 0.02 + 0.01 * std::sin(9.0 * x.X) * std::cos(7.0 * x.Y);
  const bool isIn = Length(x - Point2{ 0.4, 0.45 }) < 0.3;
  constexpr double Slopes[] = { 0.0, 0.27, 0.3, 0.303, 0.6 };
  switch (kind)
  {
    case Smooth:
      return wave;
    case Noise20:
      return 0.02 * (0.8 + 0.4 * random);
    case Noise90:
      return 0.02 * (0.1 + 1.8 * random);
    case Jump:
      return isIn ? 0.002 : 0.1;
    case Holes:
      return isIn ? std::nan("") : wave;
    case Fill:
      return isIn ? 1e20 : wave;
    default:
      return AroundHoles(x, Slopes[kind]);
  }
}

void SpacingOfImage(benchmark::State& state)
{
  const auto size = static_cast<Id>(state.range(1));
  auto grid = std::make_shared<GridSource>();
  for (Id i = 0; i < size; ++i)
  {
    grid->XNodes.push_back(i / (size - 1.0));
    grid->YNodes.push_back(i / (size - 1.0));
  }
  const std::vector<Point2> random = RandomPoints(size * size);
  for (Id k = 0; k < size * size; ++k)
  {
    const Point2 x{ grid->XNodes[static_cast<std::size_t>(k % size)],
      grid->YNodes[static_cast<std::size_t>(k / size)] };
    const double chance = random[static_cast<std::size_t>(k)].X;
    grid->Values.push_back(FieldValue(static_cast<int>(state.range(0)), x, chance));
  }
  SpacingOptions options;
  options.Sources.emplace_back(grid);
  for (auto step : state)
  {
    static_cast<void>(step);
    benchmark::DoNotOptimize(SpacingOf(options)({ 0.5, 0.5 }));
  }
  Report(state, grid->Values.size());
}
BENCHMARK(SpacingOfImage)
  ->ArgNames({ "kind", "size" })
  ->ArgsProduct({ benchmark::CreateDenseRange(0, NumberOfFieldKinds - 1, 1), { 257, 1025, 4097 } })
  ->Unit(benchmark::kMillisecond);

enum LongTriangles
{
  Slivers,
  Star,
  NumberOfLongKinds
};

// Triangles far longer than wide, with corners of their own, one beside the other; or spikes that
// meet in a hub. Items per second are triangles.
void SpacingOfLongTriangles(benchmark::State& state)
{
  const auto count = static_cast<Id>(state.range(1));
  const std::vector<Point2> random = RandomPoints(count);
  auto source = std::make_shared<TriangulatedSource>();
  source->MayOverlap = true;
  const auto add = [&source](double x, double y, double value)
  {
    source->Points.push_back({ x, y });
    source->Values.push_back(value);
    return static_cast<Id>(source->Points.size()) - 1;
  };
  const Id hub = add(0.5, 0.5, 0.02);
  for (Id k = 0; k < count; ++k)
  {
    const Point2& chance = random[static_cast<std::size_t>(k)];
    const double value = 0.005 + 0.025 * chance.X;
    if (state.range(0) == Star)
    {
      const double step = 6.283185307179586 / count;
      const double length = 0.1 + 0.4 * chance.Y;
      const auto addTip = [&add, length, value](double angle)
      { return add(0.5 + length * std::cos(angle), 0.5 + length * std::sin(angle), value); };
      source->Triangles.insert(
        source->Triangles.end(), { hub, addTip(k * step), addTip((k + 0.5) * step) });
    }
    else
    {
      const double y = 0.1 + 0.4 * k / count;
      const Id left = add(0.05 + 0.1 * chance.Y, y, value);
      const Id right = add(0.9 - 0.1 * chance.X, y + 0.3, value);
      source->Triangles.insert(
        source->Triangles.end(), { left, right, add(0.5, y + 0.15 + 0.1 / count, value) });
    }
  }
  SpacingOptions options;
  options.Sources.emplace_back(source);
  for (auto step : state)
  {
    static_cast<void>(step);
    benchmark::DoNotOptimize(SpacingOf(options)({ 0.5, 0.5 }));
  }
  Report(state, count);
}
BENCHMARK(SpacingOfLongTriangles)
  ->ArgNames({ "kind", "triangles" })
  ->ArgsProduct({ benchmark::CreateDenseRange(0, NumberOfLongKinds - 1, 1), { 500, 4000 } })
  ->Unit(benchmark::kMillisecond);

void SpacingOfBoundary(benchmark::State& state)
{
  const Polylines coast = Coast(static_cast<Id>(state.range(0)));
  auto source = std::make_shared<SegmentSource>();
  source->Points = coast.Points;
  for (std::size_t i = 0; i + 1 < coast.Connectivity.size(); ++i)
  {
    source->Segments.push_back(coast.Connectivity[i]);
    source->Segments.push_back(coast.Connectivity[i + 1]);
    const Point2& x = coast.Points[i];
    source->Values.push_back(0.01 + 0.005 * std::sin(20.0 * x.X) * std::cos(17.0 * x.Y));
  }
  SpacingOptions options;
  options.Sources.emplace_back(source);
  for (auto step : state)
  {
    static_cast<void>(step);
    benchmark::DoNotOptimize(SpacingOf(options)({ 0.5, 0.5 }));
  }
  Report(state, state.range(0));
}
BENCHMARK(SpacingOfBoundary)
  ->RangeMultiplier(10)
  ->Range(1000, 1000000)
  ->Unit(benchmark::kMillisecond);

void SpacingQueries(benchmark::State& state, SpacingOptions (*source)())
{
  const Spacing spacing = SpacingOf(source());
  const std::vector<Point2> points = RandomPoints(NumberOfQueries);
  for (auto step : state)
  {
    static_cast<void>(step);
    double sum = 0.0;
    for (const Point2& p : points)
    {
      sum += spacing(p);
    }
    benchmark::DoNotOptimize(sum);
  }
  Report(state, points.size());
}
BENCHMARK_CAPTURE(SpacingQueries, Uniform, UniformSource);
BENCHMARK_CAPTURE(SpacingQueries, Grid1M, GridOfNodes);
BENCHMARK_CAPTURE(SpacingQueries, Triangles200k, TrianglesOfSource);
BENCHMARK_CAPTURE(SpacingQueries, Segments10k, SegmentsOfCoast);

} // namespace

} // namespace biting
