// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "DividedQuads.h"

#include "../../Kernel/Quality/QuadDiagonal.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

namespace biting
{

namespace
{

// Whether the cell is a quad; its corners are put in the order around it.
bool IsQuad(int type, vtkIdList* points)
{
  const bool isQuad =
    points->GetNumberOfIds() == 4 && (type == VTK_QUAD || type == VTK_PIXEL || type == VTK_POLYGON);
  if (isQuad && type == VTK_PIXEL)
  {
    const vtkIdType third = points->GetId(2);
    points->SetId(2, points->GetId(3));
    points->SetId(3, third);
  }
  return isQuad;
}

QuadDiagonal DiagonalOf(vtkDataSet* data, vtkIdList* points)
{
  std::array<std::array<double, 3>, 4> places{};
  for (vtkIdType k = 0; k < 4; ++k)
  {
    const vtkIdType point = points->GetId(k);
    if (point < 0 || point >= data->GetNumberOfPoints())
    {
      return QuadDiagonal::None;
    }
    data->GetPoint(point, places[k].data());
  }
  return FindQuadDiagonal(places);
}

// Polyhedra are refused later, so they end the search.
bool HasQuads(vtkDataSet* data)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  vtkCellArray* cells = grid ? grid->GetCells() : static_cast<vtkPolyData*>(data)->GetPolys();
  bool hasQuads = false;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells() && !hasQuads; ++cell)
  {
    const int type = grid ? grid->GetCellType(cell) : VTK_POLYGON;
    if (type == VTK_POLYHEDRON)
    {
      return false;
    }
    hasQuads = cells->GetCellSize(cell) == 4 &&
      (type == VTK_QUAD || type == VTK_PIXEL || type == VTK_POLYGON);
  }
  return hasQuads;
}

void AddCell(vtkDataSet* target, int type, vtkIdType size, const vtkIdType* points)
{
  if (auto* polyData = vtkPolyData::SafeDownCast(target))
  {
    polyData->InsertNextCell(type, static_cast<int>(size), points);
  }
  else
  {
    static_cast<vtkUnstructuredGrid*>(target)->InsertNextCell(type, size, points);
  }
}

} // namespace

DividedQuads::DividedQuads(vtkDataSet* data)
  : Whole(data)
{
  if (!vtkPolyData::SafeDownCast(data) && !vtkUnstructuredGrid::SafeDownCast(data))
  {
    return;
  }
  if (HasQuads(data))
  {
    // Asking poly data for a cell would build something in it.
    const auto copy = vtk::TakeSmartPointer(data->NewInstance());
    copy->ShallowCopy(data);
    this->Divide(copy);
  }
}

void DividedQuads::Divide(vtkDataSet* data)
{
  auto divided = vtk::TakeSmartPointer(vtkPointSet::SafeDownCast(data->NewInstance()));
  divided->SetPoints(vtkPointSet::SafeDownCast(data)->GetPoints());
  divided->GetPointData()->ShallowCopy(data->GetPointData());
  divided->GetFieldData()->ShallowCopy(data->GetFieldData());
  const vtkIdType size = data->GetNumberOfCells();
  if (auto* polyData = vtkPolyData::SafeDownCast(divided))
  {
    polyData->AllocateEstimate(size, 3);
  }
  else
  {
    static_cast<vtkUnstructuredGrid*>(divided.Get())->Allocate(size);
  }
  divided->GetCellData()->CopyAllocate(data->GetCellData(), size);
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < size; ++cell)
  {
    data->GetCellPoints(cell, points);
    const int type = data->GetCellType(cell);
    const QuadDiagonal diagonal =
      IsQuad(type, points) ? DiagonalOf(data, points) : QuadDiagonal::None;
    if (diagonal == QuadDiagonal::None)
    {
      data->GetCellPoints(cell, points);
      AddCell(divided, type, points->GetNumberOfIds(), points->GetPointer(0));
      this->Cells.push_back(cell);
      continue;
    }
    for (const auto& triangle : TrianglesOfQuad(diagonal))
    {
      const vtkIdType corners[] = { points->GetId(triangle[0]), points->GetId(triangle[1]),
        points->GetId(triangle[2]) };
      AddCell(divided, VTK_TRIANGLE, 3, corners);
      this->Cells.push_back(cell);
    }
    ++this->Count;
  }
  vtkIdType next = 0;
  for (const vtkIdType cell : this->Cells)
  {
    divided->GetCellData()->CopyData(data->GetCellData(), cell, next++);
  }
  this->Whole = divided;
}

std::string DividedQuads::Remark() const
{
  return this->Count == 0
    ? ""
    : "The input has quads (" + std::to_string(this->Count) + "): each is two triangles.";
}

void DividedQuads::RestoreIds(vtkDataSet* output) const
{
  vtkDataArray* ids = output ? output->GetCellData()->GetArray("OriginalCellId") : nullptr;
  for (vtkIdType k = 0; ids && this->Count > 0 && k < ids->GetNumberOfTuples(); ++k)
  {
    const auto cell = static_cast<vtkIdType>(ids->GetComponent(k, 0));
    if (cell >= 0)
    {
      ids->SetComponent(k, 0, static_cast<double>(this->Cells[cell]));
    }
  }
}

} // namespace biting
