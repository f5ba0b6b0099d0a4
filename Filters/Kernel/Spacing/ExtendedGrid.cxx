// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ExtendedGrid.h"

#include "GridInterpolator.h"

#include <cmath> // for sqrt

namespace biting
{
namespace
{

/// Within coarse cells, too, are places that f grows from: none is longer or wider than one of so
/// many squares with the area of the source, or than this share of its larger extent.
constexpr double Squares = 16384.0;
constexpr double LeastShare = 1.0 / 1024.0;

/// There are so many nodes at most, or so many times as many as without: more would cost more than
/// what is found faster by them. Where few columns of very many rows are left as they are, cells
/// are long (LongCells).
constexpr double MostNodes = 1 << 17;
constexpr double MostTimes = 1.4;

/// Into so many a cell is divided.
double PartsOf(double cell, double largestStep)
{
  constexpr double roomForRounding = 1.0 - 1e-9;
  const double steps = roomForRounding * cell / largestStep;
  return steps > 1.0 ? std::ceil(steps) : 1.0;
}

/// Of the steps outside, one after the other.
constexpr double StepGrowth = 1.2;

/// The first step outside is as long as the last one before it, but this share of the way.
constexpr double ShortestShare = 1.0 / 1024.0;

/// Nodes along x or y, and where each is among those of the source.
struct ExtendedAxis
{
  std::vector<double> Nodes;
  std::vector<GridAxis::Place> Places;

  void Add(double node, const GridAxis::Place& place)
  {
    this->Nodes.push_back(node);
    this->Places.push_back(place);
  }
};

/// How far nodes outside are from the border, the farthest first.
std::vector<double> Outside(double last, double way)
{
  std::vector<double> distances;
  double step = std::max(last, ShortestShare * way);
  for (double distance = step; distance < way; distance += step)
  {
    distances.insert(distances.begin(), distance);
    step *= StepGrowth;
  }
  if (way > 0.0)
  {
    distances.insert(distances.begin(), way);
  }
  return distances;
}

ExtendedAxis ExtendedTo(
  const std::vector<double>& nodes, double low, double high, double largestStep)
{
  ExtendedAxis axis;
  axis.Nodes.reserve(nodes.size());
  axis.Places.reserve(nodes.size());
  const std::size_t cells = nodes.size() - 1;
  const double first = cells > 0 ? std::min(nodes[1] - nodes[0], largestStep) : 0.0;
  for (const double distance : Outside(first, nodes.front() - low))
  {
    axis.Add(nodes.front() - distance, { 0, 0.0 });
  }
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    const double parts = PartsOf(nodes[cell + 1] - nodes[cell], largestStep);
    for (double part = 0.0; part < parts; part += 1.0)
    {
      axis.Add(Blend(nodes[cell], nodes[cell + 1], part / parts), { cell, part / parts });
    }
  }
  const GridAxis::Place end =
    cells > 0 ? GridAxis::Place{ cells - 1, 1.0 } : GridAxis::Place{ 0, 0.0 };
  axis.Add(nodes.back(), end);
  const double last = cells > 0 ? std::min(nodes[cells] - nodes[cells - 1], largestStep) : 0.0;
  const std::vector<double> beyond = Outside(last, high - nodes.back());
  for (auto distance = beyond.rbegin(); distance != beyond.rend(); ++distance)
  {
    axis.Add(nodes.back() + *distance, end);
  }
  if (axis.Nodes.size() == 1)
  {
    axis.Add(nodes.back(), end);
  }
  return axis;
}

struct ExtendedAxes
{
  ExtendedAxes(const GridSource& source, const Box2& bounds, double largestStep)
    : Columns(ExtendedTo(source.XNodes, bounds.Low.X, bounds.High.X, largestStep))
    , Rows(ExtendedTo(source.YNodes, bounds.Low.Y, bounds.High.Y, largestStep))
  {
  }

  double CountNodes() const
  {
    return static_cast<double>(this->Columns.Nodes.size()) *
      static_cast<double>(this->Rows.Nodes.size());
  }

  ExtendedAxis Columns;
  ExtendedAxis Rows;
};

/// With coarse cells divided as far as there may be nodes.
ExtendedAxes DividedAxes(const GridSource& source, const Box2& bounds)
{
  const double width = source.XNodes.back() - source.XNodes.front();
  const double height = source.YNodes.back() - source.YNodes.front();
  const double extent = std::max(width, height);
  const ExtendedAxes undivided(source, bounds, extent);
  const double most = std::max(MostNodes, MostTimes * undivided.CountNodes());
  for (double step = std::max(std::sqrt(width / Squares * height), LeastShare * extent);
       step < extent; step *= 2.0)
  {
    ExtendedAxes divided(source, bounds, step);
    if (divided.CountNodes() <= most)
    {
      return divided;
    }
  }
  return undivided;
}

} // namespace

std::shared_ptr<const GridSource> ExtendedGrid(
  const std::shared_ptr<const GridSource>& source, const Box2& bounds)
{
  auto [columns, rows] = DividedAxes(*source, bounds);
  if (columns.Nodes.size() == source->XNodes.size() && rows.Nodes.size() == source->YNodes.size())
  {
    return source;
  }
  const GridInterpolator given(source);
  auto extended = std::make_shared<GridSource>();
  extended->Values.reserve(columns.Nodes.size() * rows.Nodes.size());
  for (const GridAxis::Place& row : rows.Places)
  {
    for (const GridAxis::Place& column : columns.Places)
    {
      extended->Values.push_back(given.At({ column.Cell, row.Cell, column.Weight, row.Weight }));
    }
  }
  extended->XNodes = std::move(columns.Nodes);
  extended->YNodes = std::move(rows.Nodes);
  return extended;
}

} // namespace biting
