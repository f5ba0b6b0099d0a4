// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// The kernel room by room, in points per second of CPU time (items_per_second). What a point is,
// the name says: a vertex of the mesh, a point of a query, a call of a predicate. Predicates,
// domains, spacing and simplification are in sources of their own. Links to BitingKernel (as the
// kernel tests do: -ffp-contract=off, include folder Filters/Kernel) and benchmark::benchmark;
// needs no VTK.

#include "KernelShapes.h"
#include "PaperSpacing.h"

#include "Biting/BitingScheme.h"
#include "Biting/VertexEstimate.h"
#include "BitingMesh.h"
#include "Delaunay/Triangulation.h"
#include "Domain/DomainLocator.h"
#include "Quality/MeshCheck.h"
#include "Quality/Quality.h"
#include "Relaxation/Relaxation.h"

#include <benchmark/benchmark.h>

#include <cmath>   // for sqrt
#include <cstdint> // for sizes
#include <memory>  // for sources
#include <utility> // for pair, move
#include <vector>  // for points

namespace biting
{

namespace
{

// Biting.

SpacingOptions PaperOptions(double vertices)
{
  auto grid = std::make_shared<GridSource>();
  grid->XNodes = { 0.0 };
  for (int i = 0; i <= PaperIntervals; ++i)
  {
    grid->YNodes.push_back(PaperSide * i / PaperIntervals);
    grid->Values.push_back(PaperSpacing(grid->YNodes.back()));
  }
  SpacingOptions options;
  options.Sources.emplace_back(grid);
  options.Scale = std::sqrt(3000.0 / vertices);
  options.Gradation = 0.0;
  return options;
}

constexpr std::pair<BiteShape, Placement> SquaresAtCorners{ BiteShape::Square, Placement::Corners };
constexpr std::pair<BiteShape, Placement> Squares{ BiteShape::Square, Placement::Bisectors };
constexpr std::pair<BiteShape, Placement> Circles{ BiteShape::Circle, Placement::Bisectors };

void Bite(benchmark::State& state, const Polylines& input, const SpacingOptions& options,
  const std::pair<BiteShape, Placement>& bites)
{
  const BitingOptions biting(bites.first, bites.second);
  const Domain domain = DomainOf(input);
  ProblemList problems;
  SilentMonitor monitor;
  const Spacing spacing = MakeSpacing(options, domain.Bounds, problems, monitor);
  std::size_t vertices = 0;
  for (auto step : state)
  {
    static_cast<void>(step);
    Pulse unheard(NoMonitor());
    const DomainLocator locator(domain, unheard);
    const double density = IntegrateDensity(domain, locator, spacing);
    const double estimate = EstimateNumberOfVertices(density);
    vertices = BiteDomain(domain, locator, spacing, estimate, biting, monitor).Points.size();
  }
  Report(state, vertices);
}

void BitingUniformVertices(benchmark::State& state, const std::pair<BiteShape, Placement>& bites)
{
  Bite(state, Square(1.0), UniformOptions(static_cast<double>(state.range(0))).Spacing, bites);
}
BENCHMARK_CAPTURE(BitingUniformVertices, SquaresAtCorners, SquaresAtCorners)
  ->RangeMultiplier(10)
  ->Range(10000, 1000000)
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BitingUniformVertices, Squares, Squares)
  ->RangeMultiplier(10)
  ->Range(10000, 1000000)
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BitingUniformVertices, Circles, Circles)
  ->RangeMultiplier(10)
  ->Range(10000, 1000000)
  ->Unit(benchmark::kMillisecond);

void BitingVerticesOfSectionSix(
  benchmark::State& state, const std::pair<BiteShape, Placement>& bites)
{
  Bite(state, Square(PaperSide), PaperOptions(static_cast<double>(state.range(0))), bites);
}
BENCHMARK_CAPTURE(BitingVerticesOfSectionSix, SquaresAtCorners, SquaresAtCorners)
  ->RangeMultiplier(10)
  ->Range(10000, 1000000)
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BitingVerticesOfSectionSix, Squares, Squares)
  ->RangeMultiplier(10)
  ->Range(10000, 1000000)
  ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BitingVerticesOfSectionSix, Circles, Circles)
  ->RangeMultiplier(10)
  ->Range(10000, 1000000)
  ->Unit(benchmark::kMillisecond);

// Delaunay.

ConstraintEdges BoundaryOf(const BitingMesh& mesh)
{
  return { mesh.EdgeStarts, mesh.EdgeEnds, mesh.EdgeIsBoundary };
}

void DelaunayVertices(benchmark::State& state)
{
  const BitingMesh& mesh = UniformMesh(state.range(0));
  const ConstraintEdges boundary = BoundaryOf(mesh);
  SilentMonitor monitor;
  for (auto step : state)
  {
    static_cast<void>(step);
    benchmark::DoNotOptimize(Triangulate(mesh.Points, boundary, {}, monitor).Mesh.Corners.data());
  }
  Report(state, mesh.Points.size());
}
BENCHMARK(DelaunayVertices)
  ->RangeMultiplier(10)
  ->Range(10000, 1000000)
  ->Unit(benchmark::kMillisecond);

void DelaunayRandomPoints(benchmark::State& state)
{
  std::vector<Point2> points = RandomPoints(static_cast<Id>(state.range(0)));
  const Id first = static_cast<Id>(points.size());
  points.insert(points.end(), { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } });
  const ConstraintEdges square{ { first, first + 1, first + 2, first + 3 },
    { first + 1, first + 2, first + 3, first }, { 1, 1, 1, 1 } };
  SilentMonitor monitor;
  for (auto step : state)
  {
    static_cast<void>(step);
    benchmark::DoNotOptimize(Triangulate(points, square, {}, monitor).Mesh.Corners.data());
  }
  Report(state, points.size());
}
BENCHMARK(DelaunayRandomPoints)
  ->RangeMultiplier(10)
  ->Range(10000, 1000000)
  ->Unit(benchmark::kMillisecond);

// Before the first hatch is an edge, it crosses as many as there are others.
void DelaunayHatches(benchmark::State& state)
{
  const Domain domain = DomainOf(Hatches(static_cast<Id>(state.range(0))));
  const ConstraintEdges segments{ domain.Starts, domain.Ends, domain.IsBoundary };
  SilentMonitor monitor;
  for (auto step : state)
  {
    static_cast<void>(step);
    benchmark::DoNotOptimize(
      Triangulate(domain.Vertices, segments, {}, monitor).Mesh.Corners.data());
  }
  Report(state, domain.Vertices.size());
}
BENCHMARK(DelaunayHatches)->RangeMultiplier(10)->Range(1000, 100000)->Unit(benchmark::kMillisecond);

// Relaxation: the mesh of section 6 as it was bitten.

RelaxationMesh BittenMesh(const Domain& domain, const Spacing& spacing)
{
  SilentMonitor monitor;
  Pulse unheard(NoMonitor());
  const DomainLocator locator(domain, unheard);
  const double density = IntegrateDensity(domain, locator, spacing);
  BitingResult bites = BiteDomain(
    domain, locator, spacing, EstimateNumberOfVertices(density), BitingOptions(), monitor);
  const std::vector<std::uint8_t> areBoundary(bites.EdgeStarts.size(), 1);
  RelaxationMesh mesh;
  mesh.Triangles =
    Triangulate(bites.Points, { bites.EdgeStarts, bites.EdgeEnds, areBoundary }, {}, monitor).Mesh;
  mesh.Points = std::move(bites.Points);
  mesh.Spacings = std::move(bites.Spacings);
  mesh.Segments = std::move(bites.Segments);
  mesh.EdgeStarts = std::move(bites.EdgeStarts);
  mesh.EdgeEnds = std::move(bites.EdgeEnds);
  mesh.EdgeSegments = std::move(bites.EdgeSegments);
  return mesh;
}

void RelaxedVerticesOfSectionSix(benchmark::State& state)
{
  const Domain domain = DomainOf(Square(PaperSide));
  ProblemList problems;
  SilentMonitor monitor;
  const Spacing spacing = MakeSpacing(
    PaperOptions(static_cast<double>(state.range(0))), domain.Bounds, problems, monitor);
  const RelaxationMesh bitten = BittenMesh(domain, spacing);
  for (auto step : state)
  {
    static_cast<void>(step);
    state.PauseTiming();
    RelaxationMesh mesh = bitten;
    state.ResumeTiming();
    benchmark::DoNotOptimize(Relax(domain, spacing, {}, mesh, monitor).Origins.data());
  }
  Report(state, bitten.Points.size());
}
BENCHMARK(RelaxedVerticesOfSectionSix)
  ->Arg(10000)
  ->Arg(100000)
  ->Arg(1000000)
  ->Unit(benchmark::kMillisecond);

// Quality.

void QualityMeasuredVertices(benchmark::State& state)
{
  const BitingMesh& mesh = UniformMesh(state.range(0));
  for (auto step : state)
  {
    static_cast<void>(step);
    benchmark::DoNotOptimize(
      MeasureQuality({ mesh.Points, mesh.Spacing, mesh.Corners, mesh.Neighbors }).MeanConformity);
  }
  Report(state, mesh.Points.size());
}
BENCHMARK(QualityMeasuredVertices)
  ->RangeMultiplier(10)
  ->Range(10000, 1000000)
  ->Unit(benchmark::kMillisecond);

void QualityCheckedVertices(benchmark::State& state)
{
  const BitingMesh& mesh = UniformMesh(state.range(0));
  const std::vector<Id> constraints(mesh.Corners.size(), 0);
  for (auto step : state)
  {
    static_cast<void>(step);
    const std::string violation =
      CheckMesh({ mesh.Points, mesh.Corners, mesh.Neighbors, constraints, 1.0 });
    if (!violation.empty())
    {
      state.SkipWithError(violation.c_str());
      break;
    }
  }
  Report(state, mesh.Points.size());
}
BENCHMARK(QualityCheckedVertices)
  ->RangeMultiplier(10)
  ->Range(10000, 1000000)
  ->Unit(benchmark::kMillisecond);

// All rooms in a row.

void FacadeVertices(benchmark::State& state)
{
  const BitingMeshOptions options = UniformOptions(static_cast<double>(state.range(0)));
  const Polylines square = Square(1.0);
  std::size_t vertices = 0;
  for (auto step : state)
  {
    static_cast<void>(step);
    ProblemList problems;
    SilentMonitor monitor;
    vertices = MakeBitingMesh(square, options, problems, monitor).Points.size();
  }
  Report(state, vertices);
}
BENCHMARK(FacadeVertices)
  ->RangeMultiplier(10)
  ->Range(10000, 1000000)
  ->Unit(benchmark::kMillisecond);

} // namespace

} // namespace biting

BENCHMARK_MAIN();
