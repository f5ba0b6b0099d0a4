// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// What preparing f costs, by kind and size of source, and how well f keeps the gradation. CPU times
// of one thread.
//   BenchmarkSpacing preparation [size [sources [kind]]]   tables, up to size x size nodes (1025);
//                                         of all sources, or images, grids, triangles or segments;
//                                         of all kinds, or one like "slope g", "Koch"
//   BenchmarkSpacing evaluation           ns a call
//   BenchmarkSpacing lipschitz [pairs]    the law |f(x) - f(y)| <= g |x - y| + 2 % of f (1000000)

#include "BitingMesh.h"

#include <algorithm>  // for sort
#include <cmath>      // for fields
#include <cstdio>     // for tables
#include <cstdlib>    // for arguments
#include <ctime>      // for CPU time
#include <functional> // for sources
#include <random>     // for noise
#include <string>     // for names

namespace
{

using namespace biting;

constexpr double Gradation = 0.3;

double Seconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Numbers in [0, 1).
class Random
{
public:
  double operator()() { return std::uniform_real_distribution<double>()(this->Engine); }

private:
  std::mt19937_64 Engine{ 1 };
};

// Fields over the unit square.

using Field = std::function<double(const Point2&, double random)>;

/// Distances to seven by seven holes, times `slope`.
Field AroundHoles(double slope)
{
  return [slope](const Point2& x, double)
  {
    const Point2 offset{ 7.0 * x.X - std::floor(7.0 * x.X) - 0.5,
      7.0 * x.Y - std::floor(7.0 * x.Y) - 0.5 };
    return 0.003 + slope * std::max(Length(offset) / 7.0 - 0.02, 0.0);
  };
}

Field Noise(double share)
{
  return [share](const Point2&, double random)
  { return 0.02 * (1.0 - share + 2.0 * share * random); };
}

double Wave(const Point2& x)
{
  return 0.02 + 0.01 * std::sin(9.0 * x.X) * std::cos(7.0 * x.Y);
}

/// `inside` within a disc, waves around it.
Field WithDisc(double inside)
{
  return [inside](const Point2& x, double) {
    return Length(x - Point2{ 0.4, 0.45 }) < 0.3 ? inside : Wave(x);
  };
}

struct Kind
{
  const char* Name;
  Field Value;
};

std::vector<Kind> Kinds()
{
  return { { "smooth", [](const Point2& x, double) { return Wave(x); } },
    { "slope .9 g", AroundHoles(0.9 * Gradation) }, { "slope g", AroundHoles(Gradation) },
    { "slope 1.01 g", AroundHoles(1.01 * Gradation) },
    { "slope 2 g", AroundHoles(2.0 * Gradation) }, { "noise 20 %", Noise(0.2) },
    { "noise 90 %", Noise(0.9) },
    { "jump by 50",
      [](const Point2& x, double) {
        return Length(x - Point2{ 0.4, 0.45 }) < 0.3 ? 0.002 : 0.1;
      } },
    { "holes of NaN", WithDisc(std::nan("")) }, { "fill values", WithDisc(1e20) } };
}

// Sources.

struct Case
{
  std::size_t Items; ///< pixels, triangles or segments
  SpacingOptions Options;
};

GridSource Grid(int size, double power, const Field& field)
{
  GridSource grid;
  for (int node = 0; node < size; ++node)
  {
    grid.XNodes.push_back(std::pow(node / (size - 1.0), power));
  }
  grid.YNodes = grid.XNodes;
  Random random;
  for (const double y : grid.YNodes)
  {
    for (const double x : grid.XNodes)
    {
      grid.Values.push_back(field({ x, y }, random()));
    }
  }
  return grid;
}

Case OfGrid(int size, double power, const Field& field)
{
  Case made;
  auto grid = std::make_shared<GridSource>(Grid(size, power, field));
  made.Items = grid->Values.size();
  made.Options.Sources.emplace_back(grid);
  return made;
}

Case OfTriangles(int size, double power, const Field& field)
{
  const GridSource grid = Grid(size + 1, power, [](const Point2&, double) { return 0.0; });
  auto source = std::make_shared<TriangulatedSource>();
  Random random;
  for (int node = 0; node < (size + 1) * (size + 1); ++node)
  {
    const int column = node % (size + 1);
    const int row = node / (size + 1);
    const double away = 0.4 / size * (column % size == 0 || row % size == 0 ? 0.0 : 1.0);
    source->Points.push_back({ grid.XNodes[static_cast<std::size_t>(column)] + away * random(),
      grid.YNodes[static_cast<std::size_t>(row)] + away * random() });
    source->Values.push_back(field(source->Points.back(), random()));
    if (column < size && row < size)
    {
      const Id corners[6] = { node, node + 1, node + size + 2, node, node + size + 2,
        node + size + 1 };
      source->Triangles.insert(source->Triangles.end(), corners, corners + 6);
    }
  }
  Case made;
  made.Items = source->Triangles.size() / 3;
  made.Options.Sources.emplace_back(source);
  return made;
}

Case OfImage(int size, const Field& field)
{
  return OfGrid(size, 1.0, field);
}

Case OfRectilinearGrid(int size, const Field& field)
{
  return OfGrid(size, 1.3, field);
}

Case OfTriangulation(int size, const Field& field)
{
  return OfTriangles(size, 1.0, field);
}

Case OfLine(std::vector<Point2> points, const std::function<double(const Point2&)>& value)
{
  auto source = std::make_shared<SegmentSource>();
  source->Points = std::move(points);
  for (std::size_t k = 0; k < source->Points.size(); ++k)
  {
    source->Values.push_back(value(source->Points[k]));
    source->Segments.push_back(static_cast<Id>(k));
    source->Segments.push_back(static_cast<Id>((k + 1) % source->Points.size()));
  }
  Case made;
  made.Items = source->Segments.size() / 2;
  made.Options.Sources.emplace_back(source);
  return made;
}

/// A wavy closed line, moved to its sides by up to half the noise.
Case OfLoop(int count, double noise, const std::function<double(const Point2&)>& value)
{
  Random random;
  std::vector<Point2> points;
  for (int k = 0; k < count; ++k)
  {
    const double angle = 6.283185307179586 * k / count;
    const double wave = 0.08 * std::sin(5.0 * angle) + 0.04 * std::cos(11.0 * angle);
    const double radius = 0.35 + wave + noise * (random() - 0.5);
    points.push_back({ 0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle) });
  }
  return OfLine(std::move(points), value);
}

Case OfBoundary(int count)
{
  return OfLoop(count, 0.0, Wave);
}

void AddKoch(const Point2& start, const Point2& end, int depth, std::vector<Point2>& points)
{
  if (depth == 0)
  {
    points.push_back(start);
    return;
  }
  const Point2 third = (1.0 / 3.0) * (end - start);
  const Point2 left = start + third;
  const Point2 right = end - third;
  const Point2 tip = Midpoint(start, end) - 0.8660254037844386 * Perpendicular(third);
  AddKoch(start, left, depth - 1, points);
  AddKoch(left, tip, depth - 1, points);
  AddKoch(tip, right, depth - 1, points);
  AddKoch(right, end, depth - 1, points);
}

/// The length of the segments of a Koch curve as its values.
Case OfKoch(int depth)
{
  const Point2 corners[3] = { { 0.1, 0.3 }, { 0.9, 0.3 }, { 0.5, 0.99 } };
  std::vector<Point2> points;
  for (int side = 0; side < 3; ++side)
  {
    AddKoch(corners[side], corners[(side + 1) % 3], depth, points);
  }
  const double length = Distance(points[0], points[1]);
  return OfLine(std::move(points), [length](const Point2&) { return length; });
}

// Measurements.

const Box2 Bounds{ { 0.0, 0.0 }, { 1.0, 1.0 } };

Spacing Prepare(const Case& source)
{
  ProblemList problems;
  SilentMonitor monitor;
  return MakeSpacing(source.Options, Bounds, problems, monitor);
}

/// ns an item: the median of three.
double Preparation(const Case& source)
{
  std::vector<double> times;
  for (int run = 0; run < 3; ++run)
  {
    const double start = Seconds();
    const Spacing spacing = Prepare(source);
    times.push_back(Seconds() - start);
  }
  std::sort(times.begin(), times.end());
  return 1e9 * times[1] / static_cast<double>(source.Items);
}

/// ns an item at each size, and the exponent of growth from the first to the last.
template <typename MakeCase>
void PrintRow(const std::string& name, const std::string& wanted, const std::vector<int>& sizes,
  MakeCase makeCase)
{
  if (!wanted.empty() && wanted != name)
  {
    return;
  }
  std::printf("| %-14s |", name.c_str());
  std::fflush(stdout);
  std::vector<double> items;
  std::vector<double> costs;
  for (const int size : sizes)
  {
    const Case source = makeCase(size);
    items.push_back(static_cast<double>(source.Items));
    costs.push_back(Preparation(source));
    std::printf(" %8.1f", costs.back());
    std::fflush(stdout);
  }
  const double growth = sizes.size() < 2
    ? 1.0
    : 1.0 + std::log(costs.back() / costs.front()) / std::log(items.back() / items.front());
  std::printf(" | %5.2f |\n", growth);
}

void PrintTable(const char* name, const std::string& wanted, const std::vector<int>& sizes,
  Case (*makeCase)(int, const Field&))
{
  std::printf("%s, ns an item, exponent of growth; nodes a side:", name);
  for (const int size : sizes)
  {
    std::printf(" %d%s", size, size == sizes.back() ? "\n" : "");
  }
  for (const Kind& kind : Kinds())
  {
    PrintRow(kind.Name, wanted, sizes, [&](int size) { return makeCase(size, kind.Value); });
  }
}

std::vector<int> SizesUpTo(int largest, int first)
{
  std::vector<int> sizes;
  for (int size = first; size <= largest; size = 2 * size - first % 2)
  {
    sizes.push_back(size);
  }
  return sizes;
}

void MeasurePreparation(int largest, const std::string& sources, const std::string& kind)
{
  const auto isWanted = [&sources](const char* name) { return sources.empty() || sources == name; };
  if (isWanted("images"))
  {
    PrintTable("Images", kind, SizesUpTo(largest, 257), OfImage);
  }
  if (isWanted("grids"))
  {
    PrintTable("Rectilinear grids", kind, SizesUpTo(largest, 257), OfRectilinearGrid);
  }
  if (isWanted("triangles"))
  {
    PrintTable("Triangulations", kind, SizesUpTo(std::min(largest, 1000), 125), OfTriangulation);
  }
  if (isWanted("segments"))
  {
    PrintRow("boundary", kind, { 1000, 10000, 100000, 1000000 }, OfBoundary);
    PrintRow("Koch", kind, { 4, 5, 6, 7, 8, 9 }, OfKoch);
    PrintRow("noise", kind, { 1000, 10000, 100000, 1000000 },
      [](int count)
      { return OfLoop(count, 2.5 / count, [count](const Point2&) { return 0.3 / count; }); });
  }
}

/// Of places as the mesher asks for them: each near the one before.
double Evaluation(const Case& source)
{
  const Spacing spacing = Prepare(source);
  constexpr int Calls = 2000000;
  Random random;
  Point2 x{ 0.5, 0.5 };
  double sum = 0.0;
  const double start = Seconds();
  for (int call = 0; call < Calls; ++call)
  {
    x = call % 32 == 0 ? Point2{ random(), random() } : x + Point2{ 1e-3, 7e-4 };
    sum += spacing(x);
  }
  const double time = Seconds() - start;
  return sum > 0.0 ? 1e9 * time / Calls : 0.0;
}

void MeasureEvaluation()
{
  std::printf("Evaluation, ns a call: images 513, triangulations 250\n");
  for (const Kind& kind : Kinds())
  {
    std::printf("| %-14s | %6.1f | %6.1f |\n", kind.Name, Evaluation(OfImage(513, kind.Value)),
      Evaluation(OfTriangulation(250, kind.Value)));
  }
  std::printf("| %-14s | %6.1f |\n", "boundary 10000", Evaluation(OfBoundary(10000)));
  std::printf("| %-14s | %6.1f |\n", "Koch 12288", Evaluation(OfKoch(6)));
}

struct Law
{
  double LargestExcess = 0.0; ///< of |f(x) - f(y)| - g |x - y|, in f
  double ShareBroken = 0.0;   ///< of the pairs, where it is above 2 %
  double LargestAbove = 0.0;  ///< of f above what is given, in that
};

Law MeasureLaw(const Case& source, int pairs)
{
  const Spacing f = Prepare(source);
  Case asGiven = source;
  asGiven.Options.Gradation = 0.0;
  const Spacing given = Prepare(asGiven);
  Random random;
  Law law;
  for (int pair = 0; pair < pairs; ++pair)
  {
    const Point2 x{ random(), random() };
    const double here = f(x);
    const double reach = here * std::exp(6.0 * random() - 3.0);
    const double angle = 6.283185307179586 * random();
    const Point2 y = x + reach * Point2{ std::cos(angle), std::sin(angle) };
    const double there = Bounds.Contains(y) ? f(y) : here;
    const double excess = (std::abs(here - there) - Gradation * reach) / std::min(here, there);
    law.LargestExcess = std::max(law.LargestExcess, excess);
    law.ShareBroken += excess > 0.02 ? 1.0 / pairs : 0.0;
    if (!std::holds_alternative<std::shared_ptr<const SegmentSource>>(source.Options.Sources[0]))
    {
      law.LargestAbove = std::max(law.LargestAbove, here / given(x) - 1.0);
    }
  }
  return law;
}

void MeasureLaws(int pairs)
{
  const auto print = [pairs](const std::string& name, const Case& source)
  {
    const Law law = MeasureLaw(source, pairs);
    std::printf("| %-28s | %7.4f | %9.6f | %7.4f |\n", name.c_str(), law.LargestExcess,
      law.ShareBroken, law.LargestAbove);
  };
  std::printf("largest excess over g |x - y| in f, share of pairs above .02, most above given\n");
  for (const Kind& kind : Kinds())
  {
    print(std::string("image ") + kind.Name, OfImage(129, kind.Value));
    print(std::string("triangles ") + kind.Name, OfTriangulation(64, kind.Value));
  }
  print("boundary 1000", OfBoundary(1000));
  print("Koch 3072", OfKoch(5));
}

} // namespace

int main(int argc, char** argv)
{
  const std::string what = argc > 1 ? argv[1] : "preparation";
  const int number = argc > 2 ? std::atoi(argv[2]) : 0;
  if (what == "preparation")
  {
    const int size = number > 0 ? number : 1025;
    MeasurePreparation(size, argc > 3 ? argv[3] : "", argc > 4 ? argv[4] : "");
  }
  else if (what == "evaluation")
  {
    MeasureEvaluation();
  }
  else if (what == "lipschitz")
  {
    MeasureLaws(number > 0 ? number : 1000000);
  }
  else
  {
    std::printf("What is to be measured: preparation, evaluation or lipschitz?\n");
    return 1;
  }
  return 0;
}
