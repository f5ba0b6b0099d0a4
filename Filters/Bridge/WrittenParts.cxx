// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "WrittenParts.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cstdint> // for global ids
#include <map>     // for what has an id
#include <numeric> // for iota

namespace biting
{

namespace
{

std::int64_t GlobalIdOf(vtkDataSetAttributes* data, vtkIdType item)
{
  vtkDataArray* ids = data->GetGlobalIds();
  return ids ? static_cast<std::int64_t>(ids->GetComponent(item, 0)) : item;
}

bool HasFlag(vtkDataArray* ghosts, vtkIdType item, int flags)
{
  return ghosts && (static_cast<int>(ghosts->GetComponent(item, 0)) & flags) != 0;
}

bool HasAnyFlag(vtkDataSetAttributes* data, vtkIdType size)
{
  vtkDataArray* ghosts = data->GetArray(vtkDataSetAttributes::GhostArrayName());
  bool isAny = false;
  for (vtkIdType item = 0; ghosts && item < size && !isAny; ++item)
  {
    isAny = HasFlag(ghosts, item, ~0);
  }
  return isAny;
}

} // namespace

WrittenParts::WrittenParts(vtkDataSet* mesh)
  : PointIds(static_cast<std::size_t>(mesh->GetNumberOfPoints()))
  , CellIds(static_cast<std::size_t>(mesh->GetNumberOfCells()))
{
  std::iota(this->PointIds.begin(), this->PointIds.end(), 0);
  std::iota(this->CellIds.begin(), this->CellIds.end(), 0);
  this->Numbers = this->PointIds;
  if (HasAnyFlag(mesh->GetPointData(), mesh->GetNumberOfPoints()) ||
    HasAnyFlag(mesh->GetCellData(), mesh->GetNumberOfCells()))
  {
    this->ListCells(mesh);
    this->ListPointsOfCells(mesh);
  }
}

void WrittenParts::ListCells(vtkDataSet* mesh)
{
  constexpr int NotHere = vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::DUPLICATECELL;
  vtkCellData* data = mesh->GetCellData();
  vtkDataArray* ghosts = data->GetArray(vtkDataSetAttributes::GhostArrayName());
  std::map<std::int64_t, vtkIdType> cells;
  for (const vtkIdType cell : this->CellIds)
  {
    if (!HasFlag(ghosts, cell, NotHere))
    {
      cells.emplace(GlobalIdOf(data, cell), cell);
    }
  }
  this->CellIds.clear();
  for (const auto& entry : cells)
  {
    this->CellIds.push_back(entry.second);
  }
}

void WrittenParts::ListPointsOfCells(vtkDataSet* mesh)
{
  std::map<std::int64_t, vtkIdType> points; // by global ids
  vtkNew<vtkIdList> corners;
  for (const vtkIdType cell : this->CellIds)
  {
    mesh->GetCellPoints(cell, corners);
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
    {
      const vtkIdType point = corners->GetId(k);
      points.emplace(GlobalIdOf(mesh->GetPointData(), point), point);
    }
  }
  this->PointIds.clear();
  for (auto& entry : points)
  {
    this->PointIds.push_back(entry.second);
    entry.second = static_cast<vtkIdType>(this->PointIds.size()) - 1;
  }
  for (vtkIdType& number : this->Numbers)
  {
    const auto found = points.find(GlobalIdOf(mesh->GetPointData(), number));
    number = found == points.end() ? -1 : found->second;
  }
}

} // namespace biting
