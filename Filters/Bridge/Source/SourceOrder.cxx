// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SourceOrder.h"

#include "../../Kernel/Base/SortInSteps.h"

#include <algorithm>  // for sort, unique
#include <array>      // for corners
#include <cmath>      // for isnan
#include <cstddef>    // for size_t
#include <functional> // for less
#include <vector>     // for the arrays

namespace biting
{

namespace
{

struct Node
{
  Point2 Place;
  double Value;
  Id Number;
};

// NaN comes last.
bool IsValueBefore(double a, double b)
{
  return std::isnan(b) ? !std::isnan(a) : a < b;
}

bool IsBefore(const Node& a, const Node& b)
{
  return a.Place != b.Place ? a.Place < b.Place : IsValueBefore(a.Value, b.Value);
}

std::vector<Node> SortedNodes(
  const std::vector<Point2>& points, const std::vector<double>& values, Pulse& pulse)
{
  std::vector<Node> nodes;
  nodes.reserve(points.size());
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    // Of zeros the positive one.
    nodes.push_back({ { points[k].X + 0.0, points[k].Y + 0.0 }, values[k], static_cast<Id>(k) });
  }
  SortInSteps(nodes, IsBefore, pulse);
  return nodes;
}

// Sorts the points and makes equal ones one; returns the new number of each.
std::vector<Id> SortPoints(std::vector<Point2>& points, std::vector<double>& values, Pulse& pulse)
{
  const std::vector<Node> nodes = SortedNodes(points, values, pulse);
  std::vector<Id> numbers(points.size(), 0);
  points.clear();
  values.clear();
  for (std::size_t k = 0; k < nodes.size() && !pulse.HasStopped(); ++k)
  {
    if (k == 0 || IsBefore(nodes[k - 1], nodes[k]))
    {
      points.push_back(nodes[k].Place);
      values.push_back(nodes[k].Value);
    }
    numbers[static_cast<std::size_t>(nodes[k].Number)] = static_cast<Id>(points.size()) - 1;
  }
  return numbers;
}

// Renumbers and sorts the corners of cells with `Size` of them, and drops what occurs again.
template <std::size_t Size>
std::vector<std::array<Id, Size>> SortCells(
  const std::vector<Id>& corners, const std::vector<Id>& numbers, Pulse& pulse)
{
  std::vector<std::array<Id, Size>> cells(corners.size() / Size);
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    cells[k / Size][k % Size] = numbers[static_cast<std::size_t>(corners[k])];
  }
  for (auto& cell : cells)
  {
    std::sort(cell.begin(), cell.end());
  }
  SortInSteps(cells, std::less<>(), pulse);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

} // namespace

void SortSource(TriangulatedSource& source, Pulse& pulse)
{
  const std::vector<Id> numbers = SortPoints(source.Points, source.Values, pulse);
  const auto triangles = SortCells<3>(source.Triangles, numbers, pulse);
  source.Triangles.clear();
  for (const auto& [a, b, c] : triangles)
  {
    if (a != b && b != c)
    {
      source.Triangles.insert(source.Triangles.end(), { a, b, c });
    }
  }
}

void SortSource(SegmentSource& source, Pulse& pulse)
{
  const std::vector<Id> numbers = SortPoints(source.Points, source.Values, pulse);
  const auto segments = SortCells<2>(source.Segments, numbers, pulse);
  source.Segments.clear();
  for (const auto& [a, b] : segments)
  {
    source.Segments.insert(source.Segments.end(), { a, b });
  }
}

} // namespace biting
