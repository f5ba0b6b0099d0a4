// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshToPolyData.h"

#include "../Data/ArrayFromVector.h"
#include "../Data/CarriedArrays.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm> // for find, max
#include <limits>    // for NaN
#include <string>    // for names

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
  for (std::size_t k = 0; k < mesh.Partners.size(); ++k)
  {
    const char* name = k == 0 ? "PeriodicPartner" : "PeriodicPartner2";
    AddArray<vtkIdTypeArray>(data, name, mesh.Partners[k], pulse);
  }
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

// The edges, and the vertices of the mesh that they use, in ascending order.
struct EdgeVertices
{
  std::vector<Id> MeshIds;
  std::vector<Id> Connectivity;
};

EdgeVertices VerticesOfEdges(const BitingMesh& mesh, Pulse& pulse)
{
  std::vector<Id> newIds(mesh.Points.size(), NoId);
  pulse.ForEach(mesh.EdgeStarts.size(),
    [&mesh, &newIds](std::size_t edge)
    {
      newIds[mesh.EdgeStarts[edge]] = 0;
      newIds[mesh.EdgeEnds[edge]] = 0;
    });
  EdgeVertices vertices;
  pulse.ForEach(newIds.size(),
    [&newIds, &vertices](std::size_t vertex)
    {
      if (newIds[vertex] != NoId)
      {
        newIds[vertex] = static_cast<Id>(vertices.MeshIds.size());
        vertices.MeshIds.push_back(static_cast<Id>(vertex));
      }
    });
  pulse.ForEach(mesh.EdgeStarts.size(),
    [&mesh, &newIds, &vertices](std::size_t edge)
    {
      vertices.Connectivity.push_back(newIds[mesh.EdgeStarts[edge]]);
      vertices.Connectivity.push_back(newIds[mesh.EdgeEnds[edge]]);
    });
  return vertices;
}

vtkSmartPointer<vtkPoints> PointsOf(const EdgeVertices& vertices, vtkPoints* meshPoints)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(vertices.MeshIds.size()));
  double* to = vtkDoubleArray::FastDownCast(points->GetData())->GetPointer(0);
  const double* from = vtkDoubleArray::FastDownCast(meshPoints->GetData())->GetPointer(0);
  for (const Id vertex : vertices.MeshIds)
  {
    to = std::copy_n(from + 3 * static_cast<std::size_t>(vertex), 3, to);
  }
  return points;
}

std::vector<std::uint8_t> KindsOf(const BitingMesh& mesh)
{
  std::vector<std::uint8_t> kinds;
  for (const std::uint8_t isBoundary : mesh.EdgeIsBoundary)
  {
    const ChainKind kind = isBoundary ? ChainKind::Boundary : ChainKind::Interface;
    kinds.push_back(static_cast<std::uint8_t>(kind));
  }
  return kinds;
}

// Where `mesh` is the border of a mesh in pieces: point ids of the whole mesh.
void AddMeshPointIds(
  const BitingMesh& mesh, const std::vector<Id>& vertices, vtkPointData* data, Pulse& pulse)
{
  std::vector<std::int64_t> ids(vertices.begin(), vertices.end());
  for (std::size_t k = 0; k < ids.size() && mesh.Piece.IsPart && pulse.Beat(); ++k)
  {
    ids[k] = mesh.Piece.PointIds[vertices[k]];
  }
  AddArray<vtkIdTypeArray>(data, "MeshPointId", ids, pulse);
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
        double* place = std::copy_n(input.Place(original), 3, places + 3 * vertex) - 3;
        place[0] = input.Frame.IsOnGlobe() ? input.Frame.TurnedLongitude(place[0]) : place[0];
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

void AddConformityArrays(
  const MeshQuality& quality, const std::vector<double>& spacing, vtkFieldData* data, Pulse& pulse)
{
  AddArray<vtkDoubleArray>(data, "Spacing", spacing, pulse);
  AddArray<vtkDoubleArray>(data, "NearestNeighborDistance", quality.NearestNeighborDistance, pulse);
  AddArray<vtkDoubleArray>(data, "Conformity", quality.Conformity, pulse);
}

void AddShapeArrays(const MeshQuality& quality, vtkFieldData* data, Pulse& pulse)
{
  AddArray<vtkDoubleArray>(data, "MinimumAngle", quality.MinimumAngle, pulse);
  AddArray<vtkDoubleArray>(data, "RadiusEdgeRatio", quality.RadiusEdgeRatio, pulse);
  AddArray<vtkDoubleArray>(data, "AspectRatio", quality.AspectRatio, pulse);
}

void AddShapeSummary(const MeshQuality& quality, vtkFieldData* data)
{
  AddCount(data, "NumberOfVertices", quality.NumberOfVertices);
  AddCount(data, "NumberOfTriangles", quality.NumberOfTriangles);
  AddFigure(data, "SmallestAngle", quality.SmallestAngle);
  AddFigure(data, "LargestRadiusEdgeRatio", quality.LargestRadiusEdgeRatio);
}

void AddConformitySummary(const MeshQuality& quality, vtkFieldData* data)
{
  AddFigure(data, "SmallestConformity", quality.SmallestConformity);
  AddFigure(data, "MeanConformity", quality.MeanConformity);
  AddFigure(data, "MeanRelativeLength", quality.MeanRelativeLength);
  AddFigure(data, "ShareOfEdgesInBand", quality.ShareOfEdgesInBand);
}

void BoundaryEdgesToPolyData(const BitingMesh& mesh, vtkPoints* points, const Drawing& drawing,
  vtkPolyData* output, Pulse& pulse)
{
  const EdgeVertices vertices = VerticesOfEdges(mesh, pulse);
  vtkNew<vtkCellArray> lines;
  SetCells(lines, 2, vertices.Connectivity, pulse);
  output->SetPoints(PointsOf(vertices, points));
  output->SetLines(lines);
  AddMeshPointIds(mesh, vertices.MeshIds, output->GetPointData(), pulse);
  CarryArrays(
    drawing.CellArrays, drawing.NumberOfCells, mesh.EdgeCells, output->GetCellData(), pulse);
  AddArray<vtkIdTypeArray>(output->GetCellData(), "OriginalCellId", mesh.EdgeCells, pulse);
  AddArray<vtkUnsignedCharArray>(output->GetCellData(), "Kind", KindsOf(mesh), pulse);
}

} // namespace biting
