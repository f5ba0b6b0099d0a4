// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BoundaryEdgesToPolyData.h"

#include "ArrayFromVector.h"
#include "CarriedArrays.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm> // for copy_n

namespace biting
{

namespace
{

// The edges over vertices of their own: those of the mesh that an edge uses, in ascending order.
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
      newIds[static_cast<std::size_t>(mesh.EdgeStarts[edge])] = 0;
      newIds[static_cast<std::size_t>(mesh.EdgeEnds[edge])] = 0;
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
      vertices.Connectivity.push_back(newIds[static_cast<std::size_t>(mesh.EdgeStarts[edge])]);
      vertices.Connectivity.push_back(newIds[static_cast<std::size_t>(mesh.EdgeEnds[edge])]);
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

// Those of the whole, where `mesh` is the border of a mesh in pieces.
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
