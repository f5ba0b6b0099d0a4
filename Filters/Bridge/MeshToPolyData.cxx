// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshToPolyData.h"

#include "ArrayFromVector.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

namespace biting
{

namespace
{

void AddPointData(const BitingMesh& mesh, vtkPointData* data)
{
  AddArray<vtkDoubleArray>(data, "Spacing", mesh.Spacing);
  AddArray<vtkDoubleArray>(data, "NearestNeighborDistance", mesh.Quality.NearestNeighborDistance);
  AddArray<vtkDoubleArray>(data, "Conformity", mesh.Quality.Conformity);
  AddArray<vtkIntArray>(data, "BiteOrder", mesh.BiteOrders);
  AddArray<vtkUnsignedCharArray>(data, "VertexKind", mesh.Kinds);
  AddArray<vtkIdTypeArray>(data, "OriginalPointId", mesh.OriginalPoints);
}

void AddCellData(const BitingMesh& mesh, vtkCellData* data)
{
  AddArray<vtkIntArray>(data, "RegionId", mesh.Regions);
  AddArray<vtkDoubleArray>(data, "MinimumAngle", mesh.Quality.MinimumAngle);
  AddArray<vtkDoubleArray>(data, "RadiusEdgeRatio", mesh.Quality.RadiusEdgeRatio);
  AddArray<vtkDoubleArray>(data, "AspectRatio", mesh.Quality.AspectRatio);
}

void AddCount(vtkFieldData* data, const char* name, std::int64_t count)
{
  AddArray<vtkIdTypeArray>(data, name, std::vector<std::int64_t>{ count });
}

void AddFigure(vtkFieldData* data, const char* name, double figure)
{
  AddArray<vtkDoubleArray>(data, name, std::vector<double>{ figure });
}

void AddSummary(const BitingMesh& mesh, vtkFieldData* data)
{
  const MeshQuality& quality = mesh.Quality;
  AddCount(data, "NumberOfVertices", quality.NumberOfVertices);
  AddCount(data, "NumberOfTriangles", quality.NumberOfTriangles);
  AddFigure(data, "SmallestAngle", quality.SmallestAngle);
  AddFigure(data, "LargestRadiusEdgeRatio", quality.LargestRadiusEdgeRatio);
  AddFigure(data, "SmallestConformity", quality.SmallestConformity);
  AddFigure(data, "MeanConformity", quality.MeanConformity);
  AddFigure(data, "MeanRelativeLength", quality.MeanRelativeLength);
  AddFigure(data, "ShareOfEdgesInBand", quality.ShareOfEdgesInBand);
  AddFigure(data, "GivenLipschitz", mesh.GivenLipschitz);
  AddFigure(data, "UsedLipschitz", mesh.UsedLipschitz);
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
  add("DroppedOutsidePoints", ProblemCode::OutsidePoints);
  add("DroppedOutsideInterfaces", ProblemCode::OutsideInterfaces);
}

} // namespace

vtkSmartPointer<vtkPoints> PointsInSpace(const BitingMesh& mesh, const PlanarInput& input)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.Points.size()));
  double* place = vtkDoubleArray::FastDownCast(points->GetData())->GetPointer(0);
  for (std::size_t vertex = 0; vertex < mesh.Points.size(); ++vertex, place += 3)
  {
    const Id original = mesh.OriginalPoints[vertex];
    if (original != NoId)
    {
      std::copy_n(input.Place(original), 3, place);
    }
    else
    {
      const Point3 mapped = input.Frame.ToSpace(mesh.Points[vertex]);
      std::copy_n(mapped.begin(), 3, place);
    }
  }
  return points;
}

void MeshToPolyData(
  const BitingMesh& mesh, vtkPoints* points, const ProblemList& problems, vtkPolyData* output)
{
  vtkNew<vtkCellArray> triangles;
  SetCells(triangles, 3, mesh.Corners);
  output->SetPoints(points);
  output->SetPolys(triangles);
  AddPointData(mesh, output->GetPointData());
  AddCellData(mesh, output->GetCellData());
  AddSummary(mesh, output->GetFieldData());
  AddRepairs(problems, output->GetFieldData());
}

} // namespace biting
