// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// The simplification alone, in segments of the drawing per second of CPU time. Part of
// BenchmarkKernel.

#include "KernelShapes.h"
#include "Simplification/Simplification.h"

#include <benchmark/benchmark.h>

#include <cmath>   // for sin, cos, pow
#include <cstdint> // for random numbers
#include <vector>  // for points

namespace biting
{

namespace
{

constexpr int NumberOfSides = 6;
constexpr double Tolerance = 0.2;

// A random Koch curve: each segment becomes four of equal length, with a peak on one side or the
// other. All that comes of a segment lies in the rhombus with half the angle of the peak's foot at
// its ends; below 60 degrees these rhombi meet at ends only, so that nothing crosses. The dimension
// is log 4 / log(2 (1 + cos a)) = 1.21, as of coasts.
class FractalCoast
{
public:
  explicit FractalCoast(int levels)
  {
    Point2 start = this->Corner(0);
    for (int side = 1; side <= NumberOfSides; ++side)
    {
      const Point2 end = this->Corner(side);
      this->Divide(start, end, levels);
      start = end;
    }
  }

  std::vector<Point2> Points;

private:
  static constexpr double FootAngle = 0.9599310885968813; // 55 degrees

  static Point2 Corner(int side)
  {
    const double angle = 6.283185307179586 * (side % NumberOfSides) / NumberOfSides;
    return { std::cos(angle), std::sin(angle) };
  }

  void Divide(const Point2& start, const Point2& end, int levels)
  {
    if (levels == 0)
    {
      this->Points.push_back(start);
      return;
    }
    const Point2 along = end - start;
    const double share = 0.5 / (1.0 + std::cos(FootAngle));
    const double height = (this->Roll() ? share : -share) * std::sin(FootAngle);
    const Point2 places[] = { start, start + share * along,
      start + 0.5 * along + height * Point2{ -along.Y, along.X }, end - share * along, end };
    for (int part = 0; part < 4; ++part)
    {
      this->Divide(places[part], places[part + 1], levels - 1);
    }
  }

  bool Roll()
  {
    this->State = this->State * 6364136223846793005u + 1442695040888963407u;
    return (this->State >> 63) != 0;
  }

  std::uint64_t State = 1;
};

// 6 * 4^levels segments; the radius over the spacing.
void SimplificationOfFractalCoast(benchmark::State& state)
{
  ProblemList problems;
  SilentMonitor monitor;
  const Domain coast =
    MakeDomain(Loop(FractalCoast(static_cast<int>(state.range(0))).Points), {}, problems, monitor);
  const double spacing = 1.0 / static_cast<double>(state.range(1));
  SimplificationOptions options;
  options.Tolerance = Tolerance;
  Id left = 0;
  for (auto _ : state)
  {
    const SimplifiedDomain simplified = Simplify(
      coast, options, [spacing](const Point2&) { return spacing; }, problems, monitor);
    left = simplified.Drawing.NumberOfSegments();
  }
  state.counters["left"] = left;
  state.SetItemsProcessed(state.iterations() * coast.NumberOfSegments());
}
BENCHMARK(SimplificationOfFractalCoast)
  ->ArgNames({ "levels", "spacings" })
  ->ArgsProduct({ { 5, 6, 7, 8, 9 }, { 20, 100, 1000 } })
  ->Unit(benchmark::kMillisecond);

} // namespace

} // namespace biting
