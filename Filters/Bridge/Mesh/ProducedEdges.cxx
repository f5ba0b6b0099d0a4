// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ProducedEdges.h"

#include "vtkAlgorithm.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm> // for equal

namespace biting
{

namespace
{

constexpr int BoundaryEdges = 1; // the port of all that have them

bool HasEdges(vtkAlgorithm* producer)
{
  return producer->IsA("vtkBitingMesher") || producer->IsA("vtkBitingRemesher") ||
    producer->IsA("vtkBitingMeshReader");
}

vtkAlgorithm* FirstInputOf(vtkAlgorithm* algorithm)
{
  const bool hasInput =
    algorithm->GetNumberOfInputPorts() > 0 && algorithm->GetNumberOfInputConnections(0) > 0;
  return hasInput ? algorithm->GetInputAlgorithm(0, 0) : nullptr;
}

bool HasLines(vtkDataSet* mesh)
{
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const int type = mesh->GetCellType(cell);
    if (type == VTK_LINE || type == VTK_POLY_LINE)
    {
      return true;
    }
  }
  return false;
}

} // namespace

vtkPolyData* FindProducedEdges(vtkAlgorithm* consumer)
{
  vtkAlgorithm* producer = FirstInputOf(consumer);
  while (producer && !HasEdges(producer))
  {
    producer = FirstInputOf(producer);
  }
  return producer ? vtkPolyData::SafeDownCast(producer->GetOutputDataObject(BoundaryEdges))
                  : nullptr;
}

bool AreEdgesOf(vtkPolyData* edges, vtkDataSet* mesh)
{
  vtkDataArray* ids = edges->GetPointData()->GetArray("MeshPointId");
  for (vtkIdType point = 0; ids && point < edges->GetNumberOfPoints(); ++point)
  {
    const auto id = static_cast<vtkIdType>(ids->GetTuple1(point));
    if (id < 0 || id >= mesh->GetNumberOfPoints())
    {
      return false;
    }
    double own[3];
    double other[3];
    edges->GetPoint(point, own);
    mesh->GetPoint(id, other);
    if (!std::equal(own, own + 3, other))
    {
      return false;
    }
  }
  return ids != nullptr;
}

vtkPolyData* FindTaggedEdges(vtkAlgorithm* consumer, vtkDataSet* mesh)
{
  vtkPolyData* edges = mesh && !HasLines(mesh) ? FindProducedEdges(consumer) : nullptr;
  return edges && AreEdgesOf(edges, mesh) ? edges : nullptr;
}

} // namespace biting
