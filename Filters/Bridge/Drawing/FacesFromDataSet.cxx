// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FacesFromDataSet.h"

#include "../../Kernel/Base/Box.h"
#include "../../Kernel/Base/Pulse.h"
#include "../../Kernel/Predicates/Predicates.h" // for LeastCoordinate, GreatestCoordinate
#include "../Data/Arrays.h"
#include "../Data/Cells.h"
#include "../Run/ProblemReport.h"
#include "CoordinateRounding.h"
#include "Globe.h"
#include "PolylinesFromDrawing.h"

#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkDataSet.h"

#include <algorithm> // for all_of, max, min_element, rotate, stable_sort
#include <cmath>     // for abs
#include <limits>    // for the size check
#include <numeric>   // for iota

namespace biting
{

namespace
{

bool IsFace(const SeenCell& cell, FaceRule rule)
{
  const int type = cell.Type;
  const bool isTriangle =
    cell.Size == 3 && (type == VTK_TRIANGLE || type == VTK_POLYGON || type == VTK_TRIANGLE_STRIP);
  const bool isPolygon =
    cell.Size > 3 && (type == VTK_POLYGON || type == VTK_QUAD || type == VTK_PIXEL);
  return isTriangle || (rule == FaceRule::Polygons && isPolygon);
}

std::string RefusalOfCell(const SeenCell& cell, FaceRule rule)
{
  const char* name = vtkCellTypes::GetClassNameFromTypeId(cell.Type);
  const char* wanted = rule == FaceRule::Triangles
    ? "the input must consist of linear triangles (apply Triangulate, or Extract Surface before "
      "it)."
    : "the input must consist of linear faces in a plane (apply Triangulate, or Slice a volume).";
  return "Cell " + std::to_string(cell.Id) + " is a " + name + " with " +
    std::to_string(cell.Size) + " points; " + wanted;
}

// The corners are ids of points.
std::string AddFace(const SeenCell& cell, PlanarFaces& faces)
{
  constexpr std::size_t Limit = std::numeric_limits<Id>::max();
  for (vtkIdType k = 0; k < cell.Size; ++k)
  {
    faces.Corners.push_back(static_cast<Id>(cell.Points[k]));
  }
  faces.Offsets.push_back(static_cast<Id>(faces.Corners.size()));
  faces.CellIds.push_back(cell.Id);
  return faces.Corners.size() > Limit ? "The input has more corners than 32-bit ids can number."
                                      : "";
}

std::string ReadFaces(vtkDataSet* data, FaceRule rule, PlanarFaces& faces, Pulse& pulse)
{
  const GhostArrays ghosts(data);
  return VisitCells(
    data,
    [data, rule, &faces, &ghosts](const SeenCell& cell)
    {
      const CellShape shape = ShapeOf(cell.Type);
      const bool isIgnored =
        shape == CellShape::Nothing || shape == CellShape::Points || shape == CellShape::Line;
      const std::string missing =
        MissingPointText("the input", cell.Id, cell.Size, cell.Points, data->GetNumberOfPoints());
      if (!missing.empty() || isIgnored || ghosts.LeaveOut(cell.Id, cell.Size, cell.Points))
      {
        return missing;
      }
      return IsFace(cell, rule) ? AddFace(cell, faces) : RefusalOfCell(cell, rule);
    },
    pulse);
}

// Makes the corners vertices, which are the points in use.
std::vector<Id> NumberVertices(vtkIdType numberOfPoints, PlanarFaces& faces)
{
  std::vector<Id> numbers(static_cast<std::size_t>(numberOfPoints), NoId);
  for (const Id corner : faces.Corners)
  {
    numbers[corner] = 0;
  }
  std::vector<Id> used;
  for (std::size_t point = 0; point < numbers.size(); ++point)
  {
    if (numbers[point] != NoId)
    {
      numbers[point] = static_cast<Id>(used.size());
      used.push_back(static_cast<Id>(point));
    }
  }
  for (Id& corner : faces.Corners)
  {
    corner = numbers[corner];
  }
  faces.PointIds.assign(used.begin(), used.end());
  return used;
}

bool AreNotTooLarge(const double* place)
{
  return std::all_of(
    place, place + 3, [](double value) { return std::abs(value) <= GreatestCoordinate; });
}

std::string RefuseCoordinates(const std::vector<Id>& points, const double* coordinates)
{
  const std::string refusal = RefuseWhereNot(AreFinite, points, coordinates,
    "Coordinates that are not finite", "Correct or remove these points.");
  return !refusal.empty() ? refusal
                          : RefuseWhereNot(AreNotTooLarge, points, coordinates,
                              "Coordinates that are too large to compute with", "Scale the input.");
}

// The ends of all sides, as points.
std::vector<Id> SidesOf(const PlanarFaces& faces)
{
  std::vector<Id> ends;
  ends.reserve(2 * faces.Corners.size());
  const auto add = [&faces, &ends](Id corner)
  {
    const Id vertex = faces.Corners[corner];
    ends.push_back(static_cast<Id>(faces.PointIds[vertex]));
  };
  for (std::size_t face = 0; face < faces.CellIds.size(); ++face)
  {
    for (Id k = faces.Offsets[face]; k < faces.Offsets[face + 1]; ++k)
    {
      add(k);
      add(k + 1 < faces.Offsets[face + 1] ? k + 1 : faces.Offsets[face]);
    }
  }
  return ends;
}

std::string MapToPlane(
  const std::vector<Id>& points, vtkDataSet* data, PlanarFaces& faces, Pulse& pulse)
{
  const auto doubles = CoordinatesOf(data);
  const double* coordinates = doubles->GetPointer(0);
  const std::string refusal = RefuseCoordinates(points, coordinates);
  if (!refusal.empty())
  {
    return refusal;
  }
  const double rounding =
    RoundingOfCoordinates(TypeOfCoordinates(data), coordinates, points, pulse).Most;
  faces.Rounding = faces.IsOnGlobe ? MetresPerDegree * rounding : rounding;
  faces.Frame =
    faces.IsOnGlobe ? PlaneFrame() : PlaneFrame::FitTo(coordinates, points, rounding, pulse);
  const std::string beyond =
    faces.IsOnGlobe ? FitGlobe(coordinates, points, SidesOf(faces), faces.Frame) : "";
  if (!beyond.empty())
  {
    return beyond;
  }
  Box2 box;
  for (const Id point : points)
  {
    faces.Points.push_back(faces.Frame.ToPlane(coordinates + 3 * static_cast<std::size_t>(point)));
    box.Add(faces.Points.back());
  }
  if (box.Diagonal() > 0.0 && box.Diagonal() < LeastCoordinate)
  {
    return "Coordinates that are too close together to compute with. Scale the input.";
  }
  const double farthest = std::max(PlanarTolerance * box.Diagonal(), rounding);
  const PlaneFrame& frame = faces.Frame;
  return RefuseWhereNot([&frame, farthest](const double* place)
    { return std::abs(frame.Distance(place)) <= farthest; },
    points, coordinates, "The input is not planar; points off the fitted plane",
    "Project the input onto a plane.");
}

std::vector<std::size_t> FromZeroTo(std::size_t count)
{
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{ 0 });
  return numbers;
}

void OrderVertices(PlanarFaces& faces)
{
  const PlanarFaces before = faces;
  std::vector<std::size_t> order = FromZeroTo(before.Points.size());
  std::stable_sort(order.begin(), order.end(),
    [&before](std::size_t a, std::size_t b) { return before.Points[a] < before.Points[b]; });
  std::vector<Id> numbers(order.size());
  for (std::size_t vertex = 0; vertex < order.size(); ++vertex)
  {
    numbers[order[vertex]] = static_cast<Id>(vertex);
    faces.Points[vertex] = before.Points[order[vertex]];
    faces.PointIds[vertex] = before.PointIds[order[vertex]];
  }
  for (Id& corner : faces.Corners)
  {
    corner = numbers[corner];
  }
}

void OrderFaces(PlanarFaces& faces)
{
  const auto beginOf = [](PlanarFaces& of, std::size_t face)
  { return of.Corners.begin() + of.Offsets[face]; };
  std::vector<std::size_t> order = FromZeroTo(faces.CellIds.size());
  for (const std::size_t face : order)
  {
    const auto begin = beginOf(faces, face);
    const auto end = beginOf(faces, face + 1);
    std::rotate(begin, std::min_element(begin, end), end);
  }
  PlanarFaces before = faces;
  std::stable_sort(order.begin(), order.end(),
    [&before, &beginOf](std::size_t a, std::size_t b)
    {
      return std::lexicographical_compare(
        beginOf(before, a), beginOf(before, a + 1), beginOf(before, b), beginOf(before, b + 1));
    });
  faces.Corners.clear();
  for (std::size_t place = 0; place < order.size(); ++place)
  {
    const std::size_t face = order[place];
    faces.Corners.insert(faces.Corners.end(), beginOf(before, face), beginOf(before, face + 1));
    faces.Offsets[place + 1] = static_cast<Id>(faces.Corners.size());
    faces.CellIds[place] = before.CellIds[face];
  }
}

} // namespace

std::string FacesFromDataSet(vtkDataSet* data, FaceRule rule, PlanarFaces& faces, Monitor& monitor)
{
  constexpr vtkIdType Limit = std::numeric_limits<Id>::max();
  if (data->GetNumberOfPoints() > Limit || data->GetNumberOfCells() > Limit)
  {
    return "The input has more points or cells than 32-bit ids can number.";
  }
  Pulse pulse(monitor);
  const std::string refusal = ReadFaces(data, rule, faces, pulse);
  if (!refusal.empty() || faces.CellIds.empty() || pulse.HasStopped())
  {
    return refusal;
  }
  const std::vector<Id> points = NumberVertices(data->GetNumberOfPoints(), faces);
  return MapToPlane(points, data, faces, pulse);
}

void OrderByPlace(PlanarFaces& faces)
{
  OrderVertices(faces);
  OrderFaces(faces);
}

Polylines OutlinesOf(const PlanarFaces& faces)
{
  Polylines outlines;
  outlines.Points = faces.Points;
  for (std::size_t face = 0; face + 1 < faces.Offsets.size(); ++face)
  {
    const auto first = faces.Corners.begin() + faces.Offsets[face];
    const auto end = faces.Corners.begin() + faces.Offsets[face + 1];
    outlines.Connectivity.insert(outlines.Connectivity.end(), first, end);
    outlines.Connectivity.push_back(*first);
    outlines.Offsets.push_back(static_cast<Id>(outlines.Connectivity.size()));
    outlines.Kinds.push_back(ChainKind::Boundary);
    outlines.Cells.push_back(static_cast<Id>(face));
  }
  return outlines;
}

} // namespace biting
