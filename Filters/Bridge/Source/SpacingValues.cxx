// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SpacingValues.h"

#include "../../Kernel/Base/SortInSteps.h"
#include "../Data/Arrays.h"
#include "../Run/ProblemReport.h"

#include "vtkDataSet.h"

#include <algorithm>  // for all_of, min, replace_if
#include <array>      // for corners
#include <cmath>      // for isfinite
#include <cstddef>    // for size_t
#include <functional> // for less
#include <vector>     // for the arrays

namespace biting
{

namespace
{

bool IsSpacing(double value, SpacingOwner owner)
{
  const bool isHole = owner == SpacingOwner::Source && std::isnan(value);
  return isHole || (value > 0.0 && std::isfinite(value));
}

std::string SubjectOf(vtkDataArray* array)
{
  return std::string("The spacing array ") + (array->GetName() ? array->GetName() : "");
}

std::string Describe(vtkIdType point, double value, const Point3& place)
{
  return "point " + std::to_string(point) + " with " + Figure(value, 6) + " at " + PlaceText(place);
}

void AddPlace(
  vtkIdType point, const Point3& place, const std::string& message, ProblemPlaces& places)
{
  ProblemPlace bad;
  bad.Kind = ProblemCode::BadSpacing;
  bad.FirstId = point;
  bad.Place = place;
  bad.Message = message;
  if (AreFinite(place.Data()) && places.Places.size() < ProblemList::KeptPerKind)
  {
    places.Places.push_back(bad);
  }
}

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
    numbers[nodes[k].Number] = static_cast<Id>(points.size()) - 1;
  }
  return numbers;
}

// Renumbers and sorts the corners of cells with `Size` corners, and drops repeated cells.
template <std::size_t Size>
std::vector<std::array<Id, Size>> SortCells(
  const std::vector<Id>& corners, const std::vector<Id>& numbers, Pulse& pulse)
{
  std::vector<std::array<Id, Size>> cells(corners.size() / Size);
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    cells[k / Size][k % Size] = numbers[corners[k]];
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

double LeastValue(const SpacingOptions& options)
{
  return options.Minimum / options.Scale;
}

std::string CheckShape(vtkDataSet* data, vtkDataArray* array)
{
  if (array->GetNumberOfComponents() != 1)
  {
    return SubjectOf(array) + " has " + std::to_string(array->GetNumberOfComponents()) +
      " components; it takes one.";
  }
  if (array->GetNumberOfTuples() < data->GetNumberOfPoints())
  {
    return SubjectOf(array) + " has " + std::to_string(array->GetNumberOfTuples()) +
      " values for " + std::to_string(data->GetNumberOfPoints()) + " points.";
  }
  return {};
}

std::string ReadOwnValues(vtkDataSet* data, vtkDataArray* array,
  const std::vector<vtkIdType>& points, double least, std::vector<double>& values,
  ProblemPlaces& places, Pulse& pulse)
{
  const std::string refusal = CheckShape(data, array);
  if (!refusal.empty())
  {
    return refusal;
  }
  values = ReadDoubles(array, data->GetNumberOfPoints());
  if (least > 0.0)
  {
    std::replace_if(
      values.begin(), values.end(), [](double value) { return value <= 0.0; }, least);
  }
  return CheckReadValues(data, array, values, &points, SpacingOwner::Input, places, pulse);
}

std::string CheckReadValues(vtkDataSet* data, vtkDataArray* array,
  const std::vector<double>& values, const std::vector<vtkIdType>* points, SpacingOwner owner,
  ProblemPlaces& places, Pulse& pulse)
{
  const std::string subject =
    SubjectOf(array) + (owner == SpacingOwner::Input ? " of the input: " : " of the source: ");
  std::vector<std::string> bad;
  std::int64_t count = 0;
  const std::size_t last = points ? points->size() : values.size();
  for (std::size_t k = 0; k < last; ++k)
  {
    if (!pulse.Beat(1))
    {
      return {};
    }
    const vtkIdType point = points ? (*points)[k] : static_cast<vtkIdType>(k);
    const double value = values[point];
    if (!IsSpacing(value, owner) && static_cast<std::size_t>(++count) <= ProblemList::KeptPerKind)
    {
      Point3 place;
      data->GetPoint(point, place.Data());
      bad.push_back(Describe(point, value, place));
      AddPlace(point, place, subject + bad.back(), places);
    }
  }
  if (count == 0)
  {
    return {};
  }
  places.Counts[static_cast<std::size_t>(ProblemCode::BadSpacing)] += count;
  bad.resize(std::min(bad.size(), ShownIds));
  return SubjectOf(array) + " has values that are zero, negative or not finite (" +
    std::to_string(count) + "): " + ListText(bad, count) + ". Spacing is an edge length.";
}

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
