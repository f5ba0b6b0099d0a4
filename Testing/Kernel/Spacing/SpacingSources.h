// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSpacingSources_h
#define BitingSpacingSources_h

#include "Spacing/Spacing.h"

#include <algorithm>  // for max
#include <cmath>      // for circles
#include <functional> // for fields
#include <stdexcept>  // for what should not happen

namespace biting
{

/// Numbers in [0, 1) that are the same everywhere (a linear congruential generator).
class Sampler
{
public:
  explicit Sampler(std::uint64_t seed)
    : State(seed)
  {
  }

  double Next()
  {
    this->State = this->State * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(this->State >> 11) / 9007199254740992.0;
  }

  Point2 NextIn(const Box2& box)
  {
    const double u = this->Next();
    return { box.Low.X + u * box.Width(), box.Low.Y + this->Next() * box.Height() };
  }

private:
  std::uint64_t State;
};

using Field = std::function<double(const Point2&)>;

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Gradation = 0.3; // where any will do

inline Box2 UnitBox()
{
  return { { 0.0, 0.0 }, { 1.0, 1.0 } };
}

/// The distance from the middle, from a low value on.
inline Field AroundTheMiddle(double slope)
{
  return [slope](const Point2& x) {
    return 0.003 + slope * std::max(Length(x - Point2{ 0.5, 0.5 }) - 0.05, 0.0);
  };
}

/// Nodes of the unit interval, closer together near 0 where `power` exceeds 1.
inline std::vector<double> UnitNodes(int count, double power = 1.0)
{
  std::vector<double> nodes;
  for (int node = 0; node < count; ++node)
  {
    nodes.push_back(std::pow(node / (count - 1.0), power));
  }
  return nodes;
}

inline GridSource MakeGrid(int columns, int rows, const Field& field, double power = 1.0)
{
  GridSource grid{ UnitNodes(columns, power), UnitNodes(rows, power), {} };
  for (double y : grid.YNodes)
  {
    for (double x : grid.XNodes)
    {
      grid.Values.push_back(field({ x, y }));
    }
  }
  return grid;
}

/// The cells of a grid of the unit square, each cut into two triangles of opposite orientation.
inline TriangulatedSource MakeTriangulation(int columns, const Field& field, double power = 1.0)
{
  const GridSource grid = MakeGrid(columns, columns, field, power);
  TriangulatedSource source;
  source.Values = grid.Values;
  for (Id node = 0; node < columns * columns; ++node)
  {
    source.Points.push_back({ grid.XNodes[static_cast<std::size_t>(node % columns)],
      grid.YNodes[static_cast<std::size_t>(node / columns)] });
    if (node % columns < columns - 1 && node / columns < columns - 1)
    {
      source.Triangles.insert(source.Triangles.end(),
        { node, node + 1, node + columns + 1, node, node + columns + 1, node + columns });
      std::swap(source.Triangles.back(), source.Triangles[source.Triangles.size() - 2]);
    }
  }
  return source;
}

/// A wavy closed line around the middle of the unit square.
inline SegmentSource MakeLoop(int count, const std::function<double(double)>& valueAtAngle)
{
  SegmentSource source;
  for (Id point = 0; point < count; ++point)
  {
    const double angle = 6.283185307179586 * point / count;
    const double radius = 0.35 + 0.08 * std::sin(5.0 * angle) + 0.04 * std::cos(11.0 * angle);
    source.Points.push_back({ 0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle) });
    source.Values.push_back(valueAtAngle(angle));
    source.Segments.push_back(point);
    source.Segments.push_back((point + 1) % count);
  }
  return source;
}

/// Unconnected segments anywhere, some of them points.
inline SegmentSource MakeScatter(int count, double longest, std::uint64_t seed)
{
  Sampler sampler(seed);
  SegmentSource source;
  for (Id segment = 0; segment < count; ++segment)
  {
    const Point2 start = sampler.NextIn(UnitBox());
    const double length = segment % 7 == 0 ? 0.0 : longest * sampler.Next();
    const double angle = 6.283185307179586 * sampler.Next();
    source.Points.push_back(start);
    source.Points.push_back(start + length * Point2{ std::cos(angle), std::sin(angle) });
    source.Values.push_back(0.01 * std::exp(3.0 * sampler.Next()));
    source.Values.push_back(source.Values.back() + 0.4 * length * (sampler.Next() - 0.5) + 1e-3);
    source.Segments.push_back(2 * segment);
    source.Segments.push_back(2 * segment + 1);
  }
  for (double& value : source.Values)
  {
    value = std::max(value, 0.004);
  }
  return source;
}

/// Sources of all kinds, for what is made of segments.
inline std::vector<SegmentSource> SegmentCorpus()
{
  return { MakeScatter(1, 0.5, 1), MakeScatter(3, 0.5, 2), MakeScatter(40, 0.3, 3),
    MakeScatter(300, 0.02, 4), MakeScatter(300, 0.5, 5),
    MakeLoop(100, [](double angle) { return 0.02 + 0.01 * std::sin(angle); }),
    MakeLoop(400, [](double) { return 0.004; }) };
}

template <typename Source>
std::shared_ptr<const Source> Share(Source source)
{
  return std::make_shared<const Source>(std::move(source));
}

/// f, for options that are expected to be good.
inline Spacing MakeGoodSpacing(const SpacingOptions& options, const Box2& bounds = UnitBox())
{
  ProblemList problems;
  SilentMonitor monitor;
  Spacing spacing = MakeSpacing(options, bounds, problems, monitor);
  if (!problems.Groups().empty())
  {
    throw std::runtime_error(problems.Groups().front().First.front().Detail);
  }
  return spacing;
}

template <typename Source>
SpacingOptions With(Source source)
{
  SpacingOptions options;
  options.Sources.emplace_back(Share(std::move(source)));
  return options;
}

/// The first source, where it is of that kind; else null.
template <typename Kind>
const Kind* First(const SpacingOptions& options)
{
  const auto* kind = std::get_if<std::shared_ptr<const Kind>>(&options.Sources.front());
  return kind ? kind->get() : nullptr;
}

/// With `change` made to every source.
template <typename Change>
SpacingOptions Changed(SpacingOptions options, Change change)
{
  const auto changed = [&change](const auto& source) -> GivenSource
  {
    auto copy = *source;
    change(copy);
    return Share(std::move(copy));
  };
  for (GivenSource& source : options.Sources)
  {
    source = std::visit(changed, source);
  }
  return options;
}

/// Along both axes, then moved.
template <typename Source>
void Stretch(const Point2& factors, const Point2& shift, Source& source)
{
  const auto stretch = [&factors, &shift](std::size_t d, double& x)
  { x = factors[d] * x + shift[d]; };
  if constexpr (std::is_same_v<Source, GridSource>)
  {
    std::for_each(
      source.XNodes.begin(), source.XNodes.end(), [&stretch](double& x) { stretch(0, x); });
    std::for_each(
      source.YNodes.begin(), source.YNodes.end(), [&stretch](double& y) { stretch(1, y); });
  }
  else
  {
    for (Point2& point : source.Points)
    {
      stretch(0, point.X);
      stretch(1, point.Y);
    }
  }
}

template <typename Source>
Source OnAPart(Source source)
{
  Stretch({ 0.3, 0.4 }, { 0.3, 0.2 }, source);
  return source;
}

/// Exchanges x and y.
inline GridSource Transposed(const GridSource& grid)
{
  GridSource transposed{ grid.YNodes, grid.XNodes, {} };
  for (std::size_t node = 0; node < grid.Values.size(); ++node)
  {
    const std::size_t rows = grid.YNodes.size();
    transposed.Values.push_back(grid.Values[node / rows + node % rows * grid.XNodes.size()]);
  }
  return transposed;
}

} // namespace biting

#endif
