// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RemeshedData.h"

#include "../../Kernel/Remeshing/OldPlaces.h"
#include "../Data/ArrayFromVector.h"
#include "../Data/CarriedArrays.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <algorithm> // for copy, max
#include <numeric>   // for iota
#include <string>    // for names

namespace biting
{

namespace
{

bool IsTransferred(
  vtkDataSetAttributes* from, vtkAbstractArray* given, vtkIdType size, vtkFieldData* to)
{
  const std::string name = given->GetName() ? given->GetName() : "";
  return given->GetNumberOfTuples() >= size && !name.empty() && !to->HasArray(name.c_str()) &&
    name != vtkDataSetAttributes::GhostArrayName() && given != from->GetGlobalIds();
}

/// Carries arrays from the points and cells of an old mesh to those of a new one.
class Transfer
{
public:
  void CarryPoints(vtkDataSet* from, vtkPointData* to);
  void CarryCells(vtkDataSet* from, const std::string& region, vtkCellData* to);

  const RemeshResult& Result;
  const PlanarMesh& Mesh;
  Pulse& Beats;

private:
  std::vector<OldPlace> PlacesOfNewVertices() const;
  void Carry(vtkAbstractArray* given, const std::vector<OldPlace>& places, vtkAbstractArray* array);
  std::vector<vtkIdType> CellsAtMiddles() const;
  std::vector<vtkIdType> CellsOfRegions() const;
  vtkIdType PointAt(const OldPlace& place, int corner) const
  {
    return this->Mesh.PointIds[this->Result.Old.Corners[3 * place.Triangle + corner]];
  }
};

void Transfer::CarryPoints(vtkDataSet* from, vtkPointData* to)
{
  const std::vector<OldPlace> places = this->PlacesOfNewVertices();
  vtkPointData* given = from->GetPointData();
  for (int k = 0; k < given->GetNumberOfArrays() && this->Beats.Ask(); ++k)
  {
    vtkAbstractArray* old = given->GetAbstractArray(k);
    if (IsTransferred(given, old, from->GetNumberOfPoints(), to))
    {
      const auto array = NewArrayLike(old, static_cast<vtkIdType>(this->Result.Mesh.Points.size()));
      this->Carry(old, places, array);
      to->AddArray(array);
    }
  }
}

std::vector<OldPlace> Transfer::PlacesOfNewVertices() const
{
  const BitingMesh& mesh = this->Result.Mesh;
  std::vector<Point2> places;
  for (std::size_t vertex = 0; vertex < mesh.Points.size(); ++vertex)
  {
    if (mesh.OriginalPoints[vertex] == NoId)
    {
      places.push_back(mesh.Points[vertex]);
    }
  }
  return FindOldPlaces(this->Result.Old, this->Result.ChangedTriangles, places, this->Beats);
}

void Transfer::Carry(
  vtkAbstractArray* given, const std::vector<OldPlace>& places, vtkAbstractArray* array)
{
  const std::vector<Id>& originals = this->Result.Mesh.OriginalPoints;
  std::size_t next = 0;
  for (std::size_t vertex = 0; vertex < originals.size() && this->Beats.Beat(); ++vertex)
  {
    const auto tuple = static_cast<vtkIdType>(vertex);
    if (originals[vertex] != NoId)
    {
      array->SetTuple(tuple, originals[vertex], given);
    }
    else
    {
      const OldPlace& place = places[next++];
      TupleMix mix;
      for (int corner = 0; corner < 3; ++corner)
      {
        mix.Add(this->PointAt(place, corner), place.Weights[corner]);
      }
      SetMixed(array, tuple, mix, given);
    }
  }
}

void Transfer::CarryCells(vtkDataSet* from, const std::string& region, vtkCellData* to)
{
  const std::vector<vtkIdType> atMiddles = this->CellsAtMiddles();
  const std::vector<vtkIdType> ofRegions = this->CellsOfRegions();
  vtkCellData* given = from->GetCellData();
  for (int k = 0; k < given->GetNumberOfArrays() && this->Beats.Ask(); ++k)
  {
    vtkAbstractArray* old = given->GetAbstractArray(k);
    if (IsTransferred(given, old, from->GetNumberOfCells(), to))
    {
      const auto array = NewArrayLike(old, static_cast<vtkIdType>(atMiddles.size()));
      const bool isRegion = region == old->GetName();
      const std::vector<vtkIdType>& cells = isRegion ? ofRegions : atMiddles;
      for (std::size_t cell = 0; cell < cells.size(); ++cell)
      {
        array->SetTuple(static_cast<vtkIdType>(cell), cells[cell], old);
      }
      to->AddArray(array);
    }
  }
}

std::vector<vtkIdType> Transfer::CellsAtMiddles() const
{
  const BitingMesh& mesh = this->Result.Mesh;
  std::vector<Point2> middles;
  for (std::size_t triangle = 0; triangle < mesh.Regions.size(); ++triangle)
  {
    if (this->Result.OriginalTriangles[triangle] == NoId)
    {
      const Id* corners = mesh.Corners.data() + 3 * triangle;
      middles.push_back((1.0 / 3.0) *
        (mesh.Points[corners[0]] + mesh.Points[corners[1]] + mesh.Points[corners[2]]));
    }
  }
  const std::vector<OldPlace> places =
    FindOldPlaces(this->Result.Old, this->Result.ChangedTriangles, middles, this->Beats);
  std::vector<vtkIdType> cells = this->CellsOfRegions();
  std::size_t next = 0;
  for (std::size_t triangle = 0; triangle < cells.size(); ++triangle)
  {
    const Id original = this->Result.OriginalTriangles[triangle];
    const bool isNew = original == NoId && next < places.size();
    const Id cell = isNew ? places[next].Triangle : std::max(original, 0);
    // Beside a simplified interface a middle may lie in another region.
    if (this->Result.Old.Regions[cell] == mesh.Regions[triangle])
    {
      cells[triangle] = this->Mesh.CellIds[cell];
    }
    next += isNew;
  }
  return cells;
}

// For each triangle one of the old cells of its region.
std::vector<vtkIdType> Transfer::CellsOfRegions() const
{
  std::vector<vtkIdType> first;
  for (std::size_t triangle = 0; triangle < this->Result.Old.Regions.size(); ++triangle)
  {
    const auto region = static_cast<std::size_t>(this->Result.Old.Regions[triangle]);
    first.resize(std::max(first.size(), region + 1), -1);
    first[region] = first[region] < 0 ? this->Mesh.CellIds[triangle] : first[region];
  }
  std::vector<vtkIdType> cells;
  for (const Id region : this->Result.Mesh.Regions)
  {
    cells.push_back(first[region]);
  }
  return cells;
}

void AddCounts(std::int64_t old, std::int64_t kept, std::int64_t whole, vtkFieldData* data)
{
  AddCount(data, "KeptVertices", kept);
  AddCount(data, "RemovedVertices", old - kept);
  AddCount(data, "NewVertices", whole - kept);
}

} // namespace

void TransferData(const RemeshResult& result, const PlanarMesh& mesh, vtkDataSet* from,
  const std::string& region, vtkPolyData* output, Pulse& pulse)
{
  if (from->GetCellData()->HasArray(region.c_str()))
  {
    output->GetCellData()->RemoveArray(region.c_str());
  }
  Transfer transfer{ result, mesh, pulse };
  transfer.CarryPoints(from, output->GetPointData());
  transfer.CarryCells(from, region, output->GetCellData());
}

void AddOriginals(const RemeshResult& result, const PlanarMesh& mesh, vtkPolyData* output)
{
  std::vector<vtkIdType> cells;
  std::int64_t keptTriangles = 0;
  for (const Id triangle : result.OriginalTriangles)
  {
    cells.push_back(triangle == NoId ? -1 : mesh.CellIds[triangle]);
    keptTriangles += triangle != NoId;
  }
  const std::vector<Id>& points = result.Mesh.OriginalPoints;
  const auto kept =
    static_cast<std::int64_t>(points.size()) - std::count(points.begin(), points.end(), NoId);
  AddArray<vtkIdTypeArray>(output->GetCellData(), "OriginalCellId", cells);
  AddCounts(static_cast<std::int64_t>(mesh.PointIds.size()), kept,
    static_cast<std::int64_t>(points.size()), output->GetFieldData());
  AddCount(output->GetFieldData(), "KeptTriangles", keptTriangles);
}

void PassThrough(const PlanarMesh& mesh, vtkDataSet* from, vtkPolyData* output)
{
  if (vtkPolyData::SafeDownCast(from))
  {
    output->ShallowCopy(from);
  }
  else
  {
    std::vector<Id> corners;
    for (const Id corner : mesh.Input.Corners)
    {
      corners.push_back(static_cast<Id>(mesh.PointIds[corner]));
    }
    vtkNew<vtkCellArray> triangles;
    SetCells(triangles, 3, corners);
    output->SetPoints(vtkPointSet::SafeDownCast(from)->GetPoints());
    output->SetPolys(triangles);
    output->GetPointData()->ShallowCopy(from->GetPointData());
    output->GetCellData()->CopyAllOn();
    output->GetCellData()->CopyAllocate(
      from->GetCellData(), static_cast<vtkIdType>(mesh.CellIds.size()));
    vtkIdType triangle = 0;
    for (const vtkIdType cell : mesh.CellIds)
    {
      output->GetCellData()->CopyData(from->GetCellData(), cell, triangle++);
    }
    output->GetFieldData()->ShallowCopy(from->GetFieldData());
  }
  std::vector<vtkIdType> ids(static_cast<std::size_t>(output->GetNumberOfPoints()));
  std::iota(ids.begin(), ids.end(), 0);
  AddArray<vtkIdTypeArray>(output->GetPointData(), "OriginalPointId", ids);
  const bool isPolyData = vtkPolyData::SafeDownCast(from) != nullptr;
  ids.resize(static_cast<std::size_t>(output->GetNumberOfCells()));
  std::iota(ids.begin(), ids.end(), 0);
  AddArray<vtkIdTypeArray>(
    output->GetCellData(), "OriginalCellId", isPolyData ? ids : mesh.CellIds);
  const auto kept = static_cast<std::int64_t>(mesh.PointIds.size());
  AddCounts(kept, kept, kept, output->GetFieldData());
  AddCount(output->GetFieldData(), "KeptTriangles", static_cast<std::int64_t>(mesh.CellIds.size()));
}

} // namespace biting
