// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// The kernel room by room, in points per second of CPU time (items_per_second). What a point is,
// the name says: a vertex of the mesh, a point of a query, a call of a predicate. Links to
// BitingKernel (as the kernel tests do: -ffp-contract=off, include folder Filters/Kernel) and
// benchmark::benchmark; needs no VTK.

#include "PaperSpacing.h"

#include "Biting/BitingScheme.h"
#include "Biting/VertexEstimate.h"
#include "BitingMesh.h"
#include "Delaunay/Triangulation.h"
#include "Domain/DomainLocator.h"
#include "Predicates/Predicates.h"
#include "Quality/MeshCheck.h"
#include "Quality/Quality.h"
#include "Relaxation/Relaxation.h"

#include <benchmark/benchmark.h>

#include <algorithm> // for max
#include <cmath>     // for sqrt, sin, cos, floor
#include <cstdint>   // for random numbers
#include <map>       // for meshes already made
#include <memory>    // for sources
#include <tuple>     // for tie
#include <utility>   // for pair, move
#include <vector>    // for points

namespace biting
{

namespace
{

constexpr Id NumberOfQueries = 1 << 16;

// Points of the unit square, the same everywhere.
std::vector<Point2> RandomPoints(Id count)
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

Polylines Loop(const std::vector<Point2>& points)
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

Polylines Square(double side)
{
  return Loop({ { 0, 0 }, { side, 0 }, { side, side }, { 0, side } });
}

// A coast: a closed curve with bays of all lengths, without crossings.
Polylines Coast(Id numberOfPoints)
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

Domain DomainOf(const Polylines& input)
{
  ProblemList problems;
  SilentMonitor monitor;
  return MakeDomain(input, {}, problems, monitor);
}

BitingMeshOptions UniformOptions(double vertices)
{
  BitingMeshOptions options;
  options.Spacing.Uniform = std::sqrt(1.25 / vertices);
  return options;
}

const BitingMesh& UniformMesh(std::int64_t vertices)
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

template <typename Count>
void Report(benchmark::State& state, Count pointsPerIteration)
{
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pointsPerIteration));
}

// Predicates.

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

// An open chain of its own.
void AddSegment(const Point2& start, const Point2& end, Polylines& lines)
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

// Long interfaces side by side, which no vertex of another is near.
Polylines Hatches(Id count)
{
  Polylines lines = Square(1.0);
  for (Id i = 0; i < count; ++i)
  {
    const double x = 0.05 + 0.4 * i / count;
    AddSegment({ x, 0.25 }, { x + 0.4, 0.75 }, lines);
  }
  return lines;
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
    const DomainLocator locator(domain);
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
  const DomainLocator locator(domain);
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

// Spacing: what is made once, and what is asked several times for each vertex.

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
  options.Grid = grid;
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
  options.Triangulation = source;
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
  options.Segments = source;
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

// Images and boundary values by kind and size: items per second are pixels, or segments.

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
  options.Grid = grid;
  for (auto step : state)
  {
    static_cast<void>(step);
    benchmark::DoNotOptimize(SpacingOf(options)({ 0.5, 0.5 }));
  }
  Report(state, grid->Values.size());
}
BENCHMARK(SpacingOfImage)
  ->ArgNames({ "kind", "size" })
  ->ArgsProduct({ benchmark::CreateDenseRange(0, NumberOfFieldKinds - 1, 1), { 257, 1025 } })
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
  options.Segments = source;
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
  options.Grid = grid;
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
  BitingOptions biting;
  std::tie(biting.Shape, biting.Placement) = bites;
  biting.FollowSlope = true;
  const Domain domain = DomainOf(input);
  ProblemList problems;
  SilentMonitor monitor;
  const Spacing spacing = MakeSpacing(options, domain.Bounds, problems, monitor);
  std::size_t vertices = 0;
  for (auto step : state)
  {
    static_cast<void>(step);
    const DomainLocator locator(domain);
    const double density = IntegrateDensity(domain, locator, spacing);
    const double estimate = EstimateNumberOfVertices(density, biting);
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
  const DomainLocator locator(domain);
  const double density = IntegrateDensity(domain, locator, spacing);
  BitingResult bites =
    BiteDomain(domain, locator, spacing, EstimateNumberOfVertices(density, {}), {}, monitor);
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
