// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// How exact f is, and what it takes, for sources of all kinds.
//   BenchmarkFieldErrors [nodes along a side] [places] [part of a name]
// A row a source: CPU seconds of preparation, nanoseconds of an evaluation, and in brackets those
// without gradation; by how much f is too large in per cent, of 99 % of all places and the worst,
// and by how much it is too small.
//
// The reference is min over y of given(y) + g |x - y|, over all nodes of the source, a lattice as
// fine as these or 1/2080, and a finer one around x; outside of triangles, where strips of low
// values may be far thinner, also over lines that start all along the border, where they are
// nearest to x. It is above f where that misses a place.

#include "../Kernel/Spacing/SpacingSources.h"

#include <cstdio> // for tables
#include <ctime>  // for costs
#include <map>    // for sides
#include <string> // for names

namespace
{

using namespace biting;

struct Row
{
  std::string Name;
  SpacingOptions Options;
};

/// Nodes moved by up to half a step.
TriangulatedSource Jittered(int nodes, const Field& field)
{
  Sampler sampler(6);
  TriangulatedSource source = MakeTriangulation(nodes, field);
  for (Point2& point : source.Points)
  {
    point = point + (0.45 / nodes) * Point2{ sampler.Next(), sampler.Next() };
  }
  return source;
}

TriangulatedSource WithGaps(const TriangulatedSource& source)
{
  Sampler sampler(7);
  TriangulatedSource kept{ source.Points, source.Values, {} };
  for (std::size_t corner = 0; corner < source.Triangles.size(); corner += 3)
  {
    const auto first = source.Triangles.begin() + static_cast<std::ptrdiff_t>(corner);
    kept.Triangles.insert(kept.Triangles.end(), first, sampler.Next() < 0.6 ? first + 3 : first);
  }
  return kept;
}

/// A triangle of low values on others.
TriangulatedSource Sheets(TriangulatedSource source)
{
  const auto first = static_cast<Id>(source.Points.size());
  source.Points.insert(source.Points.end(), { { 0.2, 0.3 }, { 0.7, 0.4 }, { 0.4, 0.8 } });
  source.Values.insert(source.Values.end(), { 0.01, 0.02, 0.03 });
  source.Triangles.insert(source.Triangles.end(), { first, first + 1, first + 2 });
  source.MayOverlap = true;
  return source;
}

/// Triangles around one point.
TriangulatedSource Hub(Id count, const Field& field)
{
  TriangulatedSource source{ { { 0.5, 0.5 } }, { 0.01 }, {} };
  for (Id k = 0; k < count; ++k)
  {
    const double angle = 6.283185307179586 * k / count;
    source.Points.push_back({ 0.5 + 0.5 * std::cos(angle), 0.5 + 0.5 * std::sin(angle) });
    source.Values.push_back(field(source.Points.back()));
    source.Triangles.insert(source.Triangles.end(), { 0, 1 + k, 1 + (k + 1) % count });
  }
  return source;
}

std::vector<Row> Rows(int nodes)
{
  Sampler sampler(5);
  const double step = 1.0 / nodes;
  const Field smooth = [](const Point2& x) { return 0.05 + 0.1 * x.X * x.Y; };
  const Field jump = [](const Point2& x) {
    return Length(x - Point2{ 0.4, 0.45 }) < 0.3 + 0.05 * std::sin(9.0 * x.X) ? 0.01 : 0.4;
  };
  const Field waves = [](const Point2& x)
  { return 0.02 * std::exp(1.5 * std::sin(17.0 * x.X) * std::sin(13.0 * x.Y)); };
  const Field noise = [&sampler](const Point2&) { return 0.02 * std::exp(3.0 * sampler.Next()); };
  const Field fine = [&sampler, step](const Point2&)
  { return 2.0 * step * (0.1 + 1.8 * sampler.Next()); };
  const Field dots = [&sampler](const Point2&) { return sampler.Next() < 0.002 ? 0.003 : 0.1; };
  const Field fill = [&jump](const Point2& x)
  { return std::fmod(7.0 * x.X, 1.0) < 0.2 && x.Y > 0.3 ? 1e20 : jump(x); };
  const Field holes = [&waves](const Point2& x)
  { return std::fmod(7.0 * x.X, 1.0) < 0.4 && x.Y > 0.3 ? NotANumber : waves(x); };
  const auto grid = [nodes](const Field& field) { return With(MakeGrid(nodes, nodes, field)); };
  const int few = std::max(9, nodes / 8);
  std::vector<Row> rows{ { "smooth", grid(smooth) }, { "slope g", grid(AroundTheMiddle(0.3)) },
    { "slope 1.1 g", grid(AroundTheMiddle(0.33)) }, { "slope 2 g", grid(AroundTheMiddle(0.6)) },
    { "jump", grid(jump) }, { "waves", grid(waves) }, { "noise x 20", grid(noise) },
    { "noise 90 %", grid(fine) }, { "dots", grid(dots) }, { "fill values", grid(fill) },
    { "holes", grid(holes) }, { "triangles", With(MakeTriangulation(nodes, smooth)) },
    { "triangles, jump", With(MakeTriangulation(nodes, jump)) },
    { "triangles, 90 %", With(Jittered(nodes, fine)) },
    { "beside noise", With(OnAPart(Jittered(few, noise))) },
    { "gaps in noise", With(WithGaps(Jittered(nodes, fine))) },
    { "sheets", With(Sheets(MakeTriangulation(nodes, smooth))) },
    { "hub", With(Hub(4 * nodes, noise)) }, { "composite", grid(jump) } };
  rows.back().Options.Sources.emplace_back(Share(OnAPart(Jittered(few, noise))));
  return rows;
}

double Now()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// f, and what it took.
struct Timed
{
  Spacing F;
  double Preparation = 0.0;
  double Evaluation = 0.0;

  explicit Timed(const SpacingOptions& options)
  {
    const double begin = Now();
    this->F = MakeGoodSpacing(options);
    this->Preparation = Now() - begin;
    constexpr int Count = 100000;
    Sampler sampler(33);
    double sum = 0.0;
    for (int k = 0; k < Count; ++k)
    {
      sum += this->F(sampler.NextIn(UnitBox()));
    }
    this->Evaluation = sum > 0.0 ? (Now() - begin - this->Preparation) / Count : 0.0;
  }
};

void AddLattice(const Point2& middle, double step, int count, const Spacing& given,
  std::vector<std::pair<Point2, double>>& places)
{
  for (int k = 0; k <= count * (count + 2); ++k)
  {
    const Point2 y = middle +
      step *
        Point2{ k % (count + 1) - 0.5 * count, static_cast<double>(k / (count + 1)) - 0.5 * count };
    if (UnitBox().Contains(y))
    {
      places.emplace_back(y, given(y));
    }
  }
}

/// Along sides far longer than the lattice is wide.
void AddSides(const TriangulatedSource& source, double step, const Spacing& given,
  std::vector<std::pair<Point2, double>>& places)
{
  for (std::size_t k = 0; k < source.Triangles.size(); ++k)
  {
    const Point2& a = source.Points[static_cast<std::size_t>(source.Triangles[k])];
    const Point2& b =
      source.Points[static_cast<std::size_t>(source.Triangles[k % 3 == 2 ? k - 2 : k + 1])];
    const auto count = static_cast<int>(Distance(a, b) / step);
    for (int part = 1; part < count && count > 4; ++part)
    {
      const Point2 y = a + (static_cast<double>(part) / count) * (b - a);
      places.emplace_back(y, given(y));
    }
  }
}

/// A line from the border outward, and the value given where it starts.
struct Line
{
  Point2 Start;
  Point2 Direction;
  double Value;
};

/// Along the edges that have a triangle on one side only, and around their ends. Where a line leads
/// into triangles does not matter: what is given there counts.
std::vector<Line> LinesFrom(const TriangulatedSource& source)
{
  constexpr int PerEdge = 16;
  std::map<std::pair<Id, Id>, int> sides;
  for (std::size_t k = 0; k < source.Triangles.size(); ++k)
  {
    const Id start = source.Triangles[k];
    const Id end = source.Triangles[k % 3 == 2 ? k - 2 : k + 1];
    sides[{ std::min(start, end), std::max(start, end) }] += start < end ? 1 : 2;
  }
  std::vector<Line> lines;
  std::map<Id, std::vector<Point2>> normals; // of the edges at a point
  for (const auto& [ends, count] : sides)
  {
    const Point2 a = source.Points[static_cast<std::size_t>(ends.first)];
    const Point2 b = source.Points[static_cast<std::size_t>(ends.second)];
    const double values[2] = { source.Values[static_cast<std::size_t>(ends.first)],
      source.Values[static_cast<std::size_t>(ends.second)] };
    if (count == 3)
    {
      continue;
    }
    // Orientations differ, so the lines go to both sides: one of them is inside.
    const Point2 normal = (1.0 / Distance(a, b)) * Perpendicular(b - a);
    for (int k = 0; k <= 2 * PerEdge + 1; ++k)
    {
      // More of them near the ends, where values may be lowest.
      const double even = static_cast<double>(k / 2) / PerEdge;
      const double share = std::min(std::max(1e-7, even * even * (3.0 - 2.0 * even)), 1.0 - 1e-7);
      lines.push_back({ a + share * (b - a), (k % 2 == 0 ? 1.0 : -1.0) * normal,
        (1.0 - share) * values[0] + share * values[1] });
    }
    for (const Id end : { ends.first, ends.second })
    {
      normals[end].push_back(normal);
      normals[end].push_back(-1.0 * normal);
    }
  }
  for (const auto& [point, around] : normals)
  {
    for (int k = 0; k < 16 * static_cast<int>(around.size()) * static_cast<int>(around.size()); ++k)
    {
      const auto pair = static_cast<std::size_t>(k / 16);
      const double share = (k % 16 + 0.5) / 16.0;
      const Point2 sum =
        share * around[pair / around.size()] + (1.0 - share) * around[pair % around.size()];
      const auto id = static_cast<std::size_t>(point);
      if (Length(sum) > 0.1 && pair / around.size() < pair % around.size())
      {
        lines.push_back({ source.Points[id], (1.0 / Length(sum)) * sum, source.Values[id] });
      }
    }
  }
  return lines;
}

/// min over a line of given(y) + g |x - y|: where the line is nearest to x, or else near the last
/// place that is given the line's value.
double LeastOnLine(const Line& line, const Point2& x, const Spacing& given, double least)
{
  const double foot = std::max(Dot(x - line.Start, line.Direction), 0.0);
  const auto at = [&line](double length) { return line.Start + length * line.Direction; };
  if (line.Value + Gradation * Distance(at(foot), x) >= 0.999 * least)
  {
    return least;
  }
  double good = 0.0;
  for (double length = foot, bad = foot; bad - good > 1e-4 * line.Value;
       length = 0.5 * (good + bad))
  {
    const double value = given(at(length));
    least = std::min(least, value + Gradation * Distance(at(length), x));
    (value <= 1.0001 * line.Value ? good : bad) = length;
  }
  return least;
}

void Print(const Row& row, int nodes, int probes)
{
  const Timed used(row.Options);
  SpacingOptions asGiven = row.Options;
  asGiven.Gradation = 0.0;
  const Timed given(asGiven);
  const int steps = (nodes - 1) * std::max(1, 2080 / nodes);
  std::vector<std::pair<Point2, double>> places;
  std::vector<Line> lines;
  AddLattice({ 0.5, 0.5 }, 1.0 / steps, steps, given.F, places);
  for (const GivenSource& source : row.Options.Sources)
  {
    if (const auto* triangles = std::get_if<std::shared_ptr<const TriangulatedSource>>(&source))
    {
      for (const Point2& point : (*triangles)->Points)
      {
        places.emplace_back(point, given.F(point));
      }
      AddSides(**triangles, 1.0 / steps, given.F, places);
      lines = LinesFrom(**triangles);
    }
  }
  Sampler sampler(34);
  std::vector<double> above(1, 0.0);
  std::vector<double> below(1, 0.0);
  for (int probe = 0; probe < probes; ++probe)
  {
    const Point2 x = sampler.NextIn(UnitBox());
    std::vector<std::pair<Point2, double>> near;
    AddLattice(x, 0.2 / steps, 20, given.F, near);
    double least = given.F(x);
    for (const auto* some : { &near, &places })
    {
      for (const auto& [place, value] : *some)
      {
        least = value < least ? std::min(least, value + 0.3 * Distance(place, x)) : least;
      }
    }
    for (const Line& line : lines)
    {
      least = LeastOnLine(line, x, given.F, least);
    }
    above.push_back(100.0 * std::max(used.F(x) / least - 1.0, 0.0));
    below.push_back(100.0 * std::max(1.0 - used.F(x) / least, 0.0));
  }
  std::printf("| %-15s | %5d | %7.3f (%.3f) | %5.0f (%.0f) |", row.Name.c_str(), nodes,
    used.Preparation, given.Preparation, 1e9 * used.Evaluation, 1e9 * given.Evaluation);
  for (std::vector<double>* errors : { &above, &below })
  {
    std::sort(errors->begin(), errors->end());
    std::printf(" %5.1f %5.1f |", (*errors)[(99 * (errors->size() - 1)) / 100], errors->back());
  }
  std::printf("\n");
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  const int nodes = argc > 1 ? std::stoi(argv[1]) : 65;
  const int probes = argc > 2 ? std::stoi(argv[2]) : 300;
  for (const Row& row : Rows(nodes))
  {
    if (argc < 4 || row.Name.find(argv[3]) != std::string::npos)
    {
      Print(row, nodes, probes);
    }
  }
  return 0;
}
