// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "WrittenParts.h"

#include "../Data/GhostArrays.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm> // for remove_if, transform
#include <array>     // for places
#include <cstdint>   // for global ids
#include <map>       // for what has an id
#include <numeric>   // for iota

namespace biting
{

namespace
{

bool HasAnyGhosts(vtkDataSet* mesh)
{
  return HasGhosts(mesh, vtkDataObject::POINT, ~0) || HasGhosts(mesh, vtkDataObject::CELL, ~0);
}

std::int64_t IdIn(vtkDataArray* ids, vtkIdType item)
{
  return ids ? static_cast<std::int64_t>(ids->GetComponent(item, 0)) : item;
}

// Whether points of one id are at one place: not where meshes were appended that were numbered
// each by itself.
bool AreOfOnePlaceEach(vtkDataSet* mesh, vtkDataArray* ids)
{
  std::map<std::int64_t, std::array<double, 3>> places;
  bool areSo = true;
  for (vtkIdType point = 0; ids && point < mesh->GetNumberOfPoints() && areSo; ++point)
  {
    std::array<double, 3> place{};
    mesh->GetPoint(point, place.data());
    areSo = places.emplace(IdIn(ids, point), place).first->second == place;
  }
  return areSo;
}

} // namespace

WrittenParts::WrittenParts(vtkDataSet* mesh)
  : PointIds(static_cast<std::size_t>(mesh->GetNumberOfPoints()))
  , CellIds(static_cast<std::size_t>(mesh->GetNumberOfCells()))
{
  std::iota(this->PointIds.begin(), this->PointIds.end(), 0);
  std::iota(this->CellIds.begin(), this->CellIds.end(), 0);
  this->Numbers = this->PointIds;
  if (HasAnyGhosts(mesh))
  {
    this->ListCells(mesh);
    this->ListPointsOfCells(mesh);
  }
}

void WrittenParts::ListCells(vtkDataSet* mesh)
{
  const GhostArrays ghosts(mesh);
  vtkNew<vtkIdList> corners;
  const auto isElsewhere = [mesh, &ghosts, &corners](vtkIdType cell)
  {
    mesh->GetCellPoints(cell, corners);
    return ghosts.LeaveOut(cell, corners->GetNumberOfIds(), corners->GetPointer(0));
  };
  this->CellIds.erase(
    std::remove_if(this->CellIds.begin(), this->CellIds.end(), isElsewhere), this->CellIds.end());
  vtkDataArray* ids = mesh->GetCellData()->GetGlobalIds();
  std::map<std::int64_t, vtkIdType> cells;
  for (const vtkIdType cell : this->CellIds)
  {
    cells.emplace(IdIn(ids, cell), cell);
  }
  if (cells.size() == this->CellIds.size())
  {
    std::transform(cells.begin(), cells.end(), this->CellIds.begin(),
      [](const auto& entry) { return entry.second; });
  }
}

void WrittenParts::ListPointsOfCells(vtkDataSet* mesh)
{
  vtkDataArray* globalIds = mesh->GetPointData()->GetGlobalIds();
  vtkDataArray* ids = AreOfOnePlaceEach(mesh, globalIds) ? globalIds : nullptr;
  std::map<std::int64_t, vtkIdType> points;
  vtkNew<vtkIdList> corners;
  for (const vtkIdType cell : this->CellIds)
  {
    mesh->GetCellPoints(cell, corners);
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
    {
      const vtkIdType point = corners->GetId(k);
      points.emplace(IdIn(ids, point), point);
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
    const auto found = points.find(IdIn(ids, number));
    number = found == points.end() ? -1 : found->second;
  }
}

} // namespace biting
