// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BitesToPolyData.h"

#include "../Data/ArrayFromVector.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <array> // for corners
#include <cmath> // for atan2, cos, sin

namespace biting
{

namespace
{

constexpr double DrawingEnd = 0.7; // of the time
constexpr int CornersOfCircle = 32;

// Points, lines and polygons, with order and phase of each.
struct Outlines
{
  std::vector<Point2> Points;
  std::vector<Id> Lines;
  std::vector<Id> PolygonPoints;
  std::vector<Id> PolygonOffsets{ 0 };
  std::vector<Id> Orders;
  std::vector<BitePhase> Phases;
};

std::array<Point2, 4> CornersOfSquare(const Bites& bites, std::size_t square)
{
  const Point2 first = bites.HalfWidths[square] * bites.Axes[square];
  const Point2 second = Perpendicular(first);
  const Point2 none{};
  return { first + second, second - first, (none - first) - second, first - second };
}

// Distance of `offset` from the centre, measured so that the square's sides are at 1.
double SquareNorm(const Bites& bites, std::size_t square, const Point2& offset)
{
  const Point2& axis = bites.Axes[square];
  const double norm =
    std::max(std::abs(Dot(offset, axis)), std::abs(Dot(offset, Perpendicular(axis))));
  return norm / bites.HalfWidths[square];
}

bool IsCovered(const Bites& bites, std::size_t first, std::size_t end, const Point2& offset)
{
  constexpr double Inside = 1.0 - 1e-9; // corners and crossings lie at 1 up to rounding
  for (std::size_t square = first; square < end; ++square)
  {
    if (SquareNorm(bites, square, offset) < Inside)
    {
      return true;
    }
  }
  return false;
}

// Where the sides a0a1 and b0b1 cross; adds nothing where they do not.
void AddCrossing(const Point2& a0, const Point2& a1, const Point2& b0, const Point2& b1,
  std::vector<Point2>& outline)
{
  const double determinant = Cross(a1 - a0, b1 - b0);
  const double s = Cross(b0 - a0, b1 - b0) / determinant;
  const double t = Cross(b0 - a0, a1 - a0) / determinant;
  if (determinant != 0.0 && s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0)
  {
    outline.push_back(a0 + s * (a1 - a0));
  }
}

void AddCrossings(
  const Bites& bites, std::size_t one, std::size_t other, std::vector<Point2>& outline)
{
  const auto a = CornersOfSquare(bites, one);
  const auto b = CornersOfSquare(bites, other);
  for (std::size_t j = 0; j < 4; ++j)
  {
    for (std::size_t k = 0; k < 4; ++k)
    {
      AddCrossing(a[j], a[(j + 1) % 4], b[k], b[(k + 1) % 4], outline);
    }
  }
}

// Keeps the points on the outline of the union of the squares, in counterclockwise order.
void KeepUncovered(
  const Bites& bites, std::size_t first, std::size_t end, std::vector<Point2>& outline)
{
  const auto isCovered = [&bites, first, end](const Point2& offset)
  { return IsCovered(bites, first, end, offset); };
  outline.erase(std::remove_if(outline.begin(), outline.end(), isCovered), outline.end());
  std::sort(outline.begin(), outline.end(),
    [](const Point2& a, const Point2& b) { return std::atan2(a.Y, a.X) < std::atan2(b.Y, b.X); });
}

std::vector<Point2> PolygonOfCircle(const Point2& center, double radius)
{
  constexpr double DegreesToRadians = 3.14159265358979323846 / 180.0;
  std::vector<Point2> polygon;
  for (int k = 0; k < CornersOfCircle; ++k)
  {
    const double angle = 360.0 * k / CornersOfCircle * DegreesToRadians;
    polygon.push_back(center + radius * Point2{ std::cos(angle), std::sin(angle) });
  }
  return polygon;
}

void DrawBites(const Bites& bites, Outlines& outlines, Pulse& pulse)
{
  const PulsePart part(pulse, 0.0, DrawingEnd);
  Id end = 0;
  for (Id first = 0; first < bites.Size() && pulse.Beat(); first = end)
  {
    pulse.SetFraction(static_cast<double>(first) / bites.Size());
    do
    {
      ++end;
    } while (end < bites.Size() && bites.Orders[end] == bites.Orders[first]);
    for (const Point2& corner : OutlineOfBite(bites, first, end))
    {
      outlines.PolygonPoints.push_back(static_cast<Id>(outlines.Points.size()));
      outlines.Points.push_back(corner);
    }
    outlines.PolygonOffsets.push_back(static_cast<Id>(outlines.PolygonPoints.size()));
    outlines.Orders.push_back(bites.Orders[first]);
    outlines.Phases.push_back(bites.Phases[first]);
  }
}

void DrawFront(const std::vector<Point2>& front, Outlines& outlines, Pulse& pulse)
{
  for (std::size_t k = 0; k < front.size() && pulse.Beat(); ++k)
  {
    outlines.Lines.push_back(static_cast<Id>(outlines.Points.size()));
    outlines.Points.push_back(front[k]);
  }
  outlines.Orders.insert(outlines.Orders.end(), front.size() / 2, NoId);
  outlines.Phases.insert(outlines.Phases.end(), front.size() / 2, BitePhase::Front);
}

vtkSmartPointer<vtkPoints> PointsInSpace(
  const std::vector<Point2>& places, const PlaneFrame& frame, Pulse& pulse)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(places.size()));
  double* to = vtkDoubleArray::FastDownCast(points->GetData())->GetPointer(0);
  pulse.ForEach(places.size(),
    [&places, &frame, to](std::size_t k)
    {
      const Point3 mapped = frame.ToSpace(places[k]);
      std::copy_n(mapped.begin(), 3, to + 3 * k);
    });
  return points;
}

void CopyIds(const std::vector<Id>& from, vtkIdTypeArray* to, Pulse& pulse)
{
  to->SetNumberOfValues(static_cast<vtkIdType>(from.size()));
  vtkIdType* ids = to->GetPointer(0);
  pulse.ForEach(from.size(), [&from, ids](std::size_t k) { ids[k] = from[k]; });
}

vtkSmartPointer<vtkCellArray> PolygonsOf(const Outlines& outlines, Pulse& pulse)
{
  vtkNew<vtkIdTypeArray> points;
  CopyIds(outlines.PolygonPoints, points, pulse);
  vtkNew<vtkIdTypeArray> offsets;
  CopyIds(outlines.PolygonOffsets, offsets, pulse);
  auto polygons = vtkSmartPointer<vtkCellArray>::New();
  polygons->SetData(offsets, points);
  return polygons;
}

} // namespace

void BitesToPolyData(
  const BitingMesh& mesh, const PlaneFrame& frame, vtkPolyData* output, Pulse& pulse)
{
  Outlines outlines;
  DrawFront(mesh.Front, outlines, pulse);
  DrawBites(mesh.Bites, outlines, pulse);
  const PulsePart part(pulse, DrawingEnd, 1.0);
  vtkNew<vtkCellArray> lines;
  SetCells(lines, 2, outlines.Lines, pulse);
  output->SetPoints(PointsInSpace(outlines.Points, frame, pulse));
  output->SetLines(lines);
  output->SetPolys(PolygonsOf(outlines, pulse));
  AddArray<vtkIntArray>(output->GetCellData(), "BiteOrder", outlines.Orders, pulse);
  AddArray<vtkUnsignedCharArray>(output->GetCellData(), "Phase", outlines.Phases, pulse);
  output->GetCellData()->SetActiveScalars("Phase");
}

std::vector<Point2> OutlineOfBite(const Bites& bites, Id first, Id end)
{
  if (bites.IsCircle(first))
  {
    return PolygonOfCircle(bites.Centers[first], bites.HalfWidths[first]);
  }
  const auto begin = static_cast<std::size_t>(first);
  const auto stop = static_cast<std::size_t>(end);
  std::vector<Point2> outline;
  for (std::size_t square = begin; square < stop; ++square)
  {
    const auto corners = CornersOfSquare(bites, square);
    outline.insert(outline.end(), corners.begin(), corners.end());
    for (std::size_t other = begin; other < square; ++other)
    {
      AddCrossings(bites, square, other, outline);
    }
  }
  if (stop - begin > 1)
  {
    KeepUncovered(bites, begin, stop, outline);
  }
  for (Point2& corner : outline)
  {
    corner = bites.Centers[begin] + corner;
  }
  return outline;
}

} // namespace biting
