// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshToPolyData.h"

#include "../Data/ArrayFromVector.h"
#include "QualityArrays.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

namespace biting
{

namespace
{

// Where steps end, as shares of the time.
constexpr double CellsEnd = 0.4;
constexpr double PointDataEnd = 0.65;

void SetTriangles(const BitingMesh& mesh, vtkCellArray* triangles, Pulse& pulse)
{
  const PulsePart part(pulse, 0.0, CellsEnd);
  SetCells(triangles, 3, mesh.Corners, pulse);
}

void AddPointData(const BitingMesh& mesh, vtkPointData* data, Pulse& pulse)
{
  const PulsePart part(pulse, CellsEnd, PointDataEnd);
  AddConformityArrays(mesh.Quality, mesh.Spacing, data, pulse);
  AddArray<vtkIntArray>(data, "BiteOrder", mesh.BiteOrders, pulse);
  AddArray<vtkUnsignedCharArray>(data, "VertexKind", mesh.Kinds, pulse);
  AddArray<vtkIdTypeArray>(data, "OriginalPointId", mesh.OriginalPoints, pulse);
}

void AddCellData(const BitingMesh& mesh, vtkCellData* data, Pulse& pulse)
{
  const PulsePart part(pulse, PointDataEnd, 1.0);
  AddArray<vtkIntArray>(data, "RegionId", mesh.Regions, pulse);
  AddShapeArrays(mesh.Quality, data, pulse);
  data->SetActiveScalars("MinimumAngle");
}

void AddRepairs(const ProblemList& problems, vtkFieldData* data)
{
  const auto add = [&problems, data](const char* name, ProblemCode code)
  { AddCount(data, name, problems.Count(code)); };
  add("RepairedDuplicatePoints", ProblemCode::DuplicatePoints);
  add("RepairedZeroLengthSegments", ProblemCode::ZeroLengthSegments);
  add("RepairedDuplicateSegments", ProblemCode::DuplicateSegments);
  add("RepairedCrossings", ProblemCode::Crossings);
  add("RepairedTouches", ProblemCode::Touches);
  add("OverlappingCells", ProblemCode::OverlappingCells);
  add("RepairedNearPoints", ProblemCode::NearPoints);
  add("RepairedOpenEnds", ProblemCode::JoinedEnds);
  add("RepairedFlatTriangles", ProblemCode::FlatTriangles);
  add("DroppedOutsidePoints", ProblemCode::OutsidePoints);
  add("DroppedOutsideInterfaces", ProblemCode::OutsideInterfaces);
}

void AddSimplification(const BitingMesh& mesh, vtkFieldData* data)
{
  AddCount(data, "RemovedVertices", mesh.RemovedVertices);
  AddCount(data, "LeftOutLoops", mesh.LeftOutLoops);
  AddFigure(data, "LeftOutArea", mesh.LeftOutArea);
  AddFigure(data, "ShareOfDrawing", mesh.ShareOfDrawing);
}

void AddGlobalIds(
  const char* name, const std::vector<std::int64_t>& ids, vtkDataSetAttributes* data, Pulse& pulse)
{
  AddArray<vtkIdTypeArray>(data, name, ids, pulse);
  data->SetActiveGlobalIds(name);
}

void AddGhosts(const std::vector<std::uint8_t>& levels, unsigned char mark,
  vtkDataSetAttributes* data, Pulse& pulse)
{
  std::vector<unsigned char> marks;
  marks.reserve(levels.size());
  for (const std::uint8_t level : levels)
  {
    marks.push_back(level != 0 ? mark : 0);
  }
  AddArray<vtkUnsignedCharArray>(data, vtkDataSetAttributes::GhostArrayName(), marks, pulse);
}

} // namespace

void AddPieceArrays(const MeshPiece& piece, bool hasGhosts, vtkPolyData* output, Pulse& pulse)
{
  AddGlobalIds("GlobalPointIds", piece.PointIds, output->GetPointData(), pulse);
  AddGlobalIds("GlobalCellIds", piece.TriangleIds, output->GetCellData(), pulse);
  AddGhosts(
    piece.ForeignPoints, vtkDataSetAttributes::DUPLICATEPOINT, output->GetPointData(), pulse);
  if (hasGhosts)
  {
    AddGhosts(piece.Levels, vtkDataSetAttributes::DUPLICATECELL, output->GetCellData(), pulse);
  }
}

vtkSmartPointer<vtkPoints> PointsInSpace(
  const BitingMesh& mesh, const PlanarInput& input, Pulse& pulse)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.Points.size()));
  double* places = vtkDoubleArray::FastDownCast(points->GetData())->GetPointer(0);
  pulse.ForEach(mesh.Points.size(),
    [&mesh, &input, places](std::size_t vertex)
    {
      const Id original = mesh.OriginalPoints[vertex];
      if (original != NoId)
      {
        std::copy_n(input.Place(original), 3, places + 3 * vertex);
      }
      else
      {
        const Point3 mapped = input.Frame.ToSpace(mesh.Points[vertex]);
        std::copy_n(mapped.begin(), 3, places + 3 * vertex);
      }
    });
  return points;
}

void MeshToPolyData(const BitingMesh& mesh, vtkPoints* points, const ProblemList& problems,
  vtkPolyData* output, Pulse& pulse)
{
  vtkNew<vtkCellArray> triangles;
  SetTriangles(mesh, triangles, pulse);
  output->SetPoints(points);
  output->SetPolys(triangles);
  AddPointData(mesh, output->GetPointData(), pulse);
  AddCellData(mesh, output->GetCellData(), pulse);
  AddShapeSummary(mesh.Quality, output->GetFieldData());
  AddConformitySummary(mesh.Quality, output->GetFieldData());
  AddCount(
    output->GetFieldData(), "NumberOfSharpCornerTriangles", mesh.NumberOfSharpCornerTriangles);
  AddFigure(output->GetFieldData(), "GivenLipschitz", mesh.GivenLipschitz);
  AddFigure(output->GetFieldData(), "UsedLipschitz", mesh.UsedLipschitz);
  AddRepairs(problems, output->GetFieldData());
  AddSimplification(mesh, output->GetFieldData());
}

} // namespace biting
