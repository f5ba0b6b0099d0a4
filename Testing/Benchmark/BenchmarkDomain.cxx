// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Predicates and domains: a part of BenchmarkKernel.

#include "KernelShapes.h"

#include "Domain/DomainLocator.h"
#include "Predicates/Predicates.h"

#include <benchmark/benchmark.h>

#include <algorithm> // for max
#include <cmath>     // for sqrt, sin, cos, floor
#include <vector>    // for points

namespace biting
{

namespace
{

// Points of a lattice of `state.range(0)` steps: the coarser, the more are collinear or cocircular.
std::vector<Point2> LatticePoints(double steps)
{
  std::vector<Point2> points = RandomPoints(NumberOfQueries);
  for (Point2& p : points)
  {
    p = { std::floor(p.X * steps) / steps, std::floor(p.Y * steps) / steps };
  }
  return points;
}

void PredicatesOrient2D(benchmark::State& state)
{
  const std::vector<Point2> points = LatticePoints(static_cast<double>(state.range(0)));
  for (auto step : state)
  {
    static_cast<void>(step);
    int sum = 0;
    for (std::size_t i = 2; i < points.size(); ++i)
    {
      sum += Orient2D(points[i - 2], points[i - 1], points[i]);
    }
    benchmark::DoNotOptimize(sum);
  }
  Report(state, points.size() - 2);
}
BENCHMARK(PredicatesOrient2D)->Arg(1 << 30)->Arg(16);

void PredicatesInCircle(benchmark::State& state)
{
  const std::vector<Point2> points = LatticePoints(static_cast<double>(state.range(0)));
  for (auto step : state)
  {
    static_cast<void>(step);
    int sum = 0;
    for (std::size_t i = 3; i < points.size(); ++i)
    {
      sum += InCircle(points[i - 3], points[i - 2], points[i - 1], points[i]);
    }
    benchmark::DoNotOptimize(sum);
  }
  Report(state, points.size() - 3);
}
BENCHMARK(PredicatesInCircle)->Arg(1 << 30)->Arg(16);

// Domain.

void DomainOfCoast(benchmark::State& state)
{
  const Polylines coast = Coast(static_cast<Id>(state.range(0)));
  for (auto step : state)
  {
    static_cast<void>(step);
    benchmark::DoNotOptimize(DomainOf(coast).Area);
  }
  Report(state, state.range(0));
}
BENCHMARK(DomainOfCoast)->RangeMultiplier(10)->Range(10000, 1000000)->Unit(benchmark::kMillisecond);

// As many crossings as the square of the number of lines each way.
Polylines CrossingLines(Id numberOfCrossings)
{
  const Id count = static_cast<Id>(std::sqrt(static_cast<double>(numberOfCrossings)));
  Polylines lines = Square(1.0);
  for (const Point2& p : RandomPoints(count))
  {
    AddSegment({ 0.0, p.X }, { 1.0, p.X + 0.01 / count }, lines);
    AddSegment({ p.Y, 0.0 }, { p.Y + 0.01 / count, 1.0 }, lines);
  }
  return lines;
}

// Random segments, each of which crosses about one other.
Polylines ShortSegments(Id count)
{
  const double length = 1.2 / std::sqrt(static_cast<double>(count));
  const std::vector<Point2> places = RandomPoints(2 * count);
  Polylines lines = Square(1.0);
  for (std::size_t i = 0; i + 1 < places.size(); i += 2)
  {
    AddSegment(places[i], places[i] + length * (places[i + 1] - Point2{ 0.5, 0.5 }), lines);
  }
  return lines;
}

// Spokes from one point across one long segment.
Polylines Spokes(Id count)
{
  Polylines lines = Square(1.0);
  for (Id i = 0; i < count; ++i)
  {
    AddSegment({ 0.5, 0.25 }, { (i + 0.5) / count, 0.875 }, lines);
  }
  AddSegment({ 0.0, 0.6 }, { 1.0, 0.65 }, lines);
  return lines;
}

// One loop with long teeth side by side.
Polylines Comb(Id numberOfTeeth)
{
  std::vector<Point2> points{ { 1.0, 0.0 }, { 0.0, 0.0 } };
  for (Id i = 0; i < numberOfTeeth; ++i)
  {
    points.push_back({ (i + 0.25) / numberOfTeeth, 1.0 });
    points.push_back({ (i + 0.75) / numberOfTeeth, 0.5 });
  }
  return Loop(points);
}

// Items are segments of the arrangement.
void MeasureDomain(benchmark::State& state, Polylines (*draw)(Id))
{
  const Polylines input = draw(static_cast<Id>(state.range(0)));
  Id segments = 0;
  for (auto step : state)
  {
    static_cast<void>(step);
    segments = DomainOf(input).NumberOfSegments();
  }
  Report(state, segments);
}
BENCHMARK_CAPTURE(MeasureDomain, CrossingLines, CrossingLines)
  ->RangeMultiplier(10)
  ->Range(10000, 1000000)
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(MeasureDomain, ShortSegments, ShortSegments)
  ->RangeMultiplier(10)
  ->Range(10000, 100000)
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(MeasureDomain, Spokes, Spokes)
  ->RangeMultiplier(10)
  ->Range(1000, 10000)
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(MeasureDomain, Comb, Comb)
  ->RangeMultiplier(10)
  ->Range(10000, 100000)
  ->Unit(benchmark::kMillisecond);

void DomainLocatorOfComb(benchmark::State& state)
{
  const Domain domain = DomainOf(Comb(static_cast<Id>(state.range(0))));
  for (auto step : state)
  {
    static_cast<void>(step);
    Pulse unheard(NoMonitor());
    const DomainLocator locator(domain, unheard);
    benchmark::DoNotOptimize(locator.IsInside({ 0.5, 0.25 }));
  }
  Report(state, domain.NumberOfSegments());
}
BENCHMARK(DomainLocatorOfComb)
  ->RangeMultiplier(10)
  ->Range(10000, 100000)
  ->Unit(benchmark::kMillisecond);

void DomainLocatorQueries(benchmark::State& state)
{
  const Domain domain = DomainOf(Coast(static_cast<Id>(state.range(0))));
  Pulse unheard(NoMonitor());
  const DomainLocator locator(domain, unheard);
  const std::vector<Point2> points = RandomPoints(NumberOfQueries);
  for (auto step : state)
  {
    static_cast<void>(step);
    int inside = 0;
    for (const Point2& p : points)
    {
      inside += locator.IsInside(p) ? 1 : 0;
    }
    benchmark::DoNotOptimize(inside);
  }
  Report(state, points.size());
}
BENCHMARK(DomainLocatorQueries)->Arg(10000)->Arg(100000);

} // namespace

} // namespace biting
