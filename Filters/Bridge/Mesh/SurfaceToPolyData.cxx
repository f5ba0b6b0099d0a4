// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceToPolyData.h"

#include "../../Kernel/Base/Numbers.h"
#include "../../Kernel/Quality/Quality.h"
#include "../Data/ArrayFromVector.h"
#include "../Data/CarriedArrays.h"
#include "../Run/ProblemReport.h"
#include "MeshToPolyData.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm> // for max, min, sort, transform, unique
#include <cmath>     // for isnan, round
#include <numeric>   // for iota
#include <utility>   // for edges

namespace biting
{

namespace
{

void AddFigures(const CheckedSurface& surface, const ProblemList& problems, vtkFieldData* data)
{
  const SurfaceFigures& figures = surface.Figures;
  AddCount(data, "NumberOfVertices", static_cast<std::int64_t>(surface.Mesh.Points.size()));
  AddCount(data, "NumberOfTriangles", static_cast<std::int64_t>(surface.Mesh.NumberOfTriangles()));
  AddCount(data, "OpenEdges", figures.OpenEdges);
  AddCount(data, "NonManifoldEdges", figures.NonManifoldEdges);
  AddCount(data, "PinchedVertices", problems.Count(ProblemCode::PinchedVertices));
  AddCount(data, "Folds", problems.Count(ProblemCode::Folds));
  AddCount(data, "SelfCrossings", problems.Count(ProblemCode::SelfCrossings));
  AddCount(data, "Touches", problems.Count(ProblemCode::SurfaceTouches));
  AddCount(data, "FlatTriangles", problems.Count(ProblemCode::FlatTriangles));
  AddCount(data, "DuplicateTriangles", problems.Count(ProblemCode::DuplicateTriangles));
  AddCount(data, "WeldedPoints", figures.WeldedPoints);
  AddCount(data, "Parts", figures.Parts);
  AddCount(data, "Cavities", figures.Cavities);
  AddCount(data, "EulerNumber", figures.EulerNumber);
  AddFigure(data, "Area", figures.Area);
  AddFigure(data, "Volume", figures.Volume);
  AddFigure(data, "SmallestThickness", surface.Thickness.Value);
  AddArray<vtkDoubleArray>(data, "SmallestThicknessPlace",
    std::vector<double>(surface.Thickness.Place.begin(), surface.Thickness.Place.end()));
  HideFromChoices(data, "SmallestThicknessPlace");
}

struct SurfaceQuality : MeshQuality
{
  double LargestDeviation = 0.0;
  double Edges = 0.0;

  explicit SurfaceQuality(const BitingSurface& mesh);

private:
  void AddTriangle(const BitingSurface& mesh, std::size_t triangle);
};

SurfaceQuality::SurfaceQuality(const BitingSurface& mesh)
{
  this->NearestNeighborDistance.assign(mesh.Points.size(), Infinity);
  this->SmallestAngle = 180.0;
  std::vector<std::pair<Id, Id>> edges;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    this->AddTriangle(mesh, t);
    for (std::size_t k = 0; k < 3; ++k)
    {
      edges.push_back(std::minmax({ mesh.Corners[3 * t + k], mesh.Corners[3 * t + (k + 1) % 3] }));
    }
  }
  std::sort(edges.begin(), edges.end());
  this->Edges = static_cast<double>(std::unique(edges.begin(), edges.end()) - edges.begin());
  this->Conformity.reserve(mesh.Points.size());
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    const double ratio = this->NearestNeighborDistance[v] / mesh.Spacing[v];
    this->Conformity.push_back(std::min(ratio, 1.0 / ratio));
    this->MeanConformity += this->Conformity[v] / static_cast<double>(mesh.Points.size());
  }
  for (const double deviation : mesh.Deviations)
  {
    this->LargestDeviation = std::max(this->LargestDeviation, deviation);
  }
}

void SurfaceQuality::AddTriangle(const BitingSurface& mesh, std::size_t triangle)
{
  const Id* corners = &mesh.Corners[3 * triangle];
  const auto at = [&mesh, corners](std::size_t k) -> const Point3&
  { return mesh.Points[corners[k % 3]]; };
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double length = Distance(at(k), at(k + 1));
    for (const std::size_t end : { k, (k + 1) % 3 })
    {
      double& nearest = this->NearestNeighborDistance[corners[end]];
      nearest = std::min(nearest, length);
    }
  }
  // The triangle in its own plane.
  const Point3 side = at(1) - at(0);
  const Point3 other = at(2) - at(0);
  const double length = Length(side);
  const Point2 a;
  const Point2 b{ length, 0.0 };
  const Point2 c{ Dot(side, other) / length, Length(Cross(side, other)) / length };
  this->MinimumAngle.push_back(biting::MinimumAngle(a, b, c));
  this->RadiusEdgeRatio.push_back(biting::RadiusEdgeRatio(a, b, c));
  this->AspectRatio.push_back(biting::AspectRatio(a, b, c));
  this->SmallestAngle = std::min(this->SmallestAngle, this->MinimumAngle.back());
}

// The values of `of` at the places that `ids` number.
std::vector<Id> Picked(const std::vector<Id>& of, const std::vector<Id>& ids)
{
  std::vector<Id> picked(ids.size());
  std::transform(ids.begin(), ids.end(), picked.begin(), [&of](Id id) { return of[At(id)]; });
  return picked;
}

double EulerNumberOf(const BitingSurface& mesh, const SurfaceQuality& quality)
{
  return static_cast<double>(mesh.Points.size() + mesh.Triangles.size()) - quality.Edges;
}

void AddFigures(const BitingSurface& mesh, const SurfaceQuality& quality, vtkFieldData* data)
{
  AddCount(data, "NumberOfVertices", static_cast<std::int64_t>(mesh.Points.size()));
  AddCount(data, "NumberOfTriangles", static_cast<std::int64_t>(mesh.Triangles.size()));
  AddCount(data, "EulerNumber", static_cast<std::int64_t>(EulerNumberOf(mesh, quality)));
  AddFigure(data, "SmallestAngle", quality.SmallestAngle);
  AddFigure(data, "MeanConformity", quality.MeanConformity);
  AddFigure(data, "LargestDeviation", quality.LargestDeviation);
}

std::string SummaryOf(const BitingSurface& mesh, const SurfaceQuality& quality)
{
  return std::to_string(mesh.Points.size()) + " vertices, " +
    std::to_string(mesh.Triangles.size()) +
    " triangles\nEuler number: " + Figure(EulerNumberOf(mesh, quality), 9) + "\nSmallest angle " +
    Figure(quality.SmallestAngle) + " degrees\nMean conformity " + Figure(quality.MeanConformity) +
    " (best: 1)\nLargest deviation from the surface " + Figure(quality.LargestDeviation) +
    " spacings\n" + CapsText(mesh.AskedVertices, mesh.Points.size());
}

} // namespace

vtkSmartPointer<vtkPoints> MakePoints(const std::vector<Point3>& places, int type, Pulse& pulse)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(type);
  points->SetNumberOfPoints(static_cast<vtkIdType>(places.size()));
  pulse.ForEach(places.size(),
    [&points, &places](std::size_t point)
    { points->SetPoint(static_cast<vtkIdType>(point), places[point].Data()); });
  return points;
}

void SetTriangles(const std::vector<Point3>& places, const std::vector<Id>& corners, int type,
  vtkPolyData* output, Pulse& pulse)
{
  output->Initialize();
  output->SetPoints(MakePoints(places, type, pulse));
  vtkNew<vtkCellArray> cells;
  SetCells(cells, 3, corners, pulse);
  output->SetPolys(cells);
}

void SurfaceToPolyData(const CheckedSurface& surface, const ProblemList& problems,
  const Drawing& drawing, vtkPolyData* output, Pulse& pulse)
{
  const SurfaceMesh& mesh = surface.Mesh;
  SetTriangles(mesh.Points, mesh.Corners,
    drawing.CoordinateType() == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE, output, pulse);
  vtkPointData* pointData = output->GetPointData();
  CarryArrays(
    drawing.Points->GetPointData(), drawing.NumberOfPoints, mesh.PointIds, pointData, pulse);
  AddArray<vtkIdTypeArray>(pointData, "OriginalPointId", mesh.PointIds, pulse);
  vtkCellData* cellData = output->GetCellData();
  CarryArrays(drawing.CellArrays, drawing.NumberOfCells, mesh.Cells, cellData, pulse);
  AddArray<vtkIdTypeArray>(cellData, "OriginalCellId", mesh.Cells, pulse);
  AddArray<vtkIdTypeArray>(cellData, "RegionId", surface.Shells.RegionOf, pulse);
  cellData->SetActiveScalars(surface.Figures.Parts > 1 ? "RegionId" : nullptr);
  AddFigures(surface, problems, output->GetFieldData());
}

void EdgesToPolyData(const std::vector<Point3>& places, const std::vector<Id>& given,
  const std::vector<SurfaceEdgeKind>& edgeKinds, vtkPolyData* mesh, vtkPolyData* output)
{
  output->Initialize();
  std::vector<Id> numbers(places.size(), NoId);
  std::vector<Id> used;
  std::vector<Id> ends;
  ends.reserve(given.size());
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  for (const Id end : given)
  {
    Id& number = numbers[end];
    if (number == NoId)
    {
      number = static_cast<Id>(used.size());
      used.push_back(end);
      points->InsertNextPoint(places[end].Data());
    }
    ends.push_back(number);
  }
  output->SetPoints(points);
  vtkNew<vtkCellArray> lines;
  SetCells(lines, 2, ends);
  output->SetLines(lines);
  AddArray<vtkIdTypeArray>(output->GetPointData(), "MeshPointId", used);
  AddArray<vtkUnsignedCharArray>(output->GetCellData(), "EdgeKind", edgeKinds);
  output->GetCellData()->SetActiveScalars("EdgeKind");
}

std::string SummaryOf(const CheckedSurface& surface, const ProblemList& problems)
{
  const SurfaceFigures& figures = surface.Figures;
  std::string text = std::to_string(surface.Mesh.Points.size()) + " vertices, " +
    std::to_string(surface.Mesh.NumberOfTriangles()) +
    " triangles\nParts: " + std::to_string(figures.Parts) +
    ", cavities: " + std::to_string(figures.Cavities) +
    "\nEuler number: " + std::to_string(figures.EulerNumber) +
    "\nArea: " + Figure(figures.Area, 6) +
    (std::isnan(figures.Volume) ? "" : "\nVolume: " + Figure(figures.Volume, 6)) + "\n";
  if (surface.Thickness.Value > 0.0)
  {
    text += "Smallest thickness: about " + Figure(surface.Thickness.Value, 6) + " at " +
      PlaceText(surface.Thickness.Place) + "\n";
  }
  const bool isGood = !problems.HasErrors();
  text += isGood ? "The surface is closed and does not cross itself.\n" : "";
  if (figures.OpenEdges > 0)
  {
    text += "Open edges in all: " + std::to_string(figures.OpenEdges) + "\n";
  }
  for (const ProblemGroup& group : problems.Groups())
  {
    const Problem& first = group.First.front();
    text += HeadingOf(group) + ", first at " + PlaceText(first.Place) +
      (first.Detail.empty() ? "" : ": " + first.Detail) + "\n";
  }
  return text;
}

std::string CapsText(double asked, std::size_t made)
{
  constexpr double Worth = 2.0;
  constexpr double Few = 100.0; // any body has some
  const auto count = static_cast<double>(made);
  return count > Worth * asked + Few ? "Walls, features and curvature made " +
      Figure(std::round(count / asked)) + " times the vertices that the spacing asks for.\n"
                                     : "";
}

std::string BitingSurfaceToPolyData(const BitingSurface& mesh, const CheckedSurface& surface,
  const Drawing& drawing, vtkPolyData* output, Pulse& pulse)
{
  SetTriangles(mesh.Points, mesh.Corners, VTK_DOUBLE, output, pulse);
  const SurfaceQuality quality(mesh);
  vtkPointData* pointData = output->GetPointData();
  AddConformityArrays(quality, mesh.Spacing, pointData, pulse);
  AddArray<vtkIntArray>(pointData, "BiteOrder", mesh.BiteOrders, pulse);
  AddArray<vtkUnsignedCharArray>(pointData, "VertexKind", mesh.Kinds, pulse);
  AddArray<vtkIdTypeArray>(pointData, "OriginalPointId", mesh.OriginalPoints, pulse);
  vtkCellData* cellData = output->GetCellData();
  const std::vector<Id> original = Picked(surface.Mesh.Cells, mesh.Triangles);
  CarryArrays(drawing.CellArrays, drawing.NumberOfCells, original, cellData, pulse);
  AddArray<vtkIdTypeArray>(cellData, "OriginalCellId", original, pulse);
  AddArray<vtkIdTypeArray>(cellData, "RegionId", mesh.Regions, pulse);
  AddArray<vtkDoubleArray>(cellData, "Deviation", mesh.Deviations, pulse);
  AddShapeArrays(quality, cellData, pulse);
  cellData->SetActiveScalars("MinimumAngle");
  AddFigures(mesh, quality, output->GetFieldData());
  return SummaryOf(mesh, quality);
}

void SpheresToPolyData(
  const std::vector<Point3>& centers, const std::vector<double>& radii, vtkPolyData* output)
{
  Pulse pulse(NoMonitor());
  output->Initialize();
  output->SetPoints(MakePoints(centers, VTK_DOUBLE, pulse));
  std::vector<Id> order(centers.size());
  std::iota(order.begin(), order.end(), 0);
  vtkNew<vtkCellArray> cells;
  SetCells(cells, 1, order);
  output->SetVerts(cells);
  AddArray<vtkIntArray>(output->GetPointData(), "BiteOrder", order);
  AddArray<vtkDoubleArray>(output->GetPointData(), "Radius", radii);
  output->GetPointData()->SetActiveScalars("Radius");
}

} // namespace biting
