// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BoundaryEdgesToPolyData.h"

#include "ArrayFromVector.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <string> // for names

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

EdgeVertices VerticesOfEdges(const BitingMesh& mesh)
{
  std::vector<Id> newIds(mesh.Points.size(), NoId);
  for (std::size_t edge = 0; edge < mesh.EdgeStarts.size(); ++edge)
  {
    newIds[static_cast<std::size_t>(mesh.EdgeStarts[edge])] = 0;
    newIds[static_cast<std::size_t>(mesh.EdgeEnds[edge])] = 0;
  }
  EdgeVertices vertices;
  for (std::size_t vertex = 0; vertex < newIds.size(); ++vertex)
  {
    if (newIds[vertex] != NoId)
    {
      newIds[vertex] = static_cast<Id>(vertices.MeshIds.size());
      vertices.MeshIds.push_back(static_cast<Id>(vertex));
    }
  }
  for (std::size_t edge = 0; edge < mesh.EdgeStarts.size(); ++edge)
  {
    vertices.Connectivity.push_back(newIds[static_cast<std::size_t>(mesh.EdgeStarts[edge])]);
    vertices.Connectivity.push_back(newIds[static_cast<std::size_t>(mesh.EdgeEnds[edge])]);
  }
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

// Any kind of array, numbers or not; never as the active attribute that it may be in the input,
// since an id that is unique there is not unique here.
void CarryCellArrays(const BitingMesh& mesh, vtkCellData* from, vtkCellData* to)
{
  vtkNew<vtkIdList> cells;
  cells->SetNumberOfIds(static_cast<vtkIdType>(mesh.EdgeCells.size()));
  std::copy(mesh.EdgeCells.begin(), mesh.EdgeCells.end(), cells->GetPointer(0));
  for (int k = 0; k < from->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* given = from->GetAbstractArray(k);
    const std::string name = given->GetName() ? given->GetName() : "";
    if (name == vtkDataSetAttributes::GhostArrayName())
    {
      continue;
    }
    auto carried = vtk::TakeSmartPointer(given->NewInstance());
    carried->SetName(given->GetName());
    carried->SetNumberOfComponents(given->GetNumberOfComponents());
    carried->CopyComponentNames(given);
    carried->SetNumberOfTuples(cells->GetNumberOfIds());
    given->GetTuples(cells, carried);
    to->AddArray(carried);
  }
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

} // namespace

void BoundaryEdgesToPolyData(
  const BitingMesh& mesh, vtkPoints* points, vtkPolyData* input, vtkPolyData* output)
{
  const EdgeVertices vertices = VerticesOfEdges(mesh);
  vtkNew<vtkCellArray> lines;
  SetCells(lines, 2, vertices.Connectivity);
  output->SetPoints(PointsOf(vertices, points));
  output->SetLines(lines);
  AddArray<vtkIdTypeArray>(output->GetPointData(), "MeshPointId", vertices.MeshIds);
  CarryCellArrays(mesh, input->GetCellData(), output->GetCellData());
  AddArray<vtkIdTypeArray>(output->GetCellData(), "OriginalCellId", mesh.EdgeCells);
  AddArray<vtkUnsignedCharArray>(output->GetCellData(), "Kind", KindsOf(mesh));
}

} // namespace biting
