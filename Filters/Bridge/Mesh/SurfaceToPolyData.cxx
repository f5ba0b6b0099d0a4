// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceToPolyData.h"

#include "../Data/ArrayFromVector.h"
#include "../Data/CarriedArrays.h"
#include "../Run/ProblemReport.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath> // for isnan

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
    Id& number = numbers[static_cast<std::size_t>(end)];
    if (number == NoId)
    {
      number = static_cast<Id>(used.size());
      used.push_back(end);
      points->InsertNextPoint(places[static_cast<std::size_t>(end)].Data());
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

} // namespace biting
