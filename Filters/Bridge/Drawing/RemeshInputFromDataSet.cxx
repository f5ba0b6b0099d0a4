// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RemeshInputFromDataSet.h"

#include "../../Kernel/Base/Directory.h"
#include "../../Kernel/Base/Pulse.h"
#include "../Data/Arrays.h"
#include "../Data/Cells.h"
#include "CellTags.h"
#include "FacesFromDataSet.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm> // for equal
#include <utility>   // for move

namespace biting
{

namespace
{

constexpr double EmbeddedKind = 3.0; // of the point array VertexKind

bool IsNone(const std::string& name)
{
  return name.empty() || name == "None";
}

void TakeFaces(vtkDataSet* mesh, PlanarFaces& faces, PlanarMesh& result)
{
  RemeshInput& input = result.Input;
  input.Points = std::move(faces.Points);
  input.Corners = std::move(faces.Corners);
  input.Rounding = faces.Rounding;
  input.PointIds.assign(faces.PointIds.begin(), faces.PointIds.end());
  input.CellIds.assign(faces.CellIds.begin(), faces.CellIds.end());
  input.IsFixed.assign(input.Points.size(), 0);
  input.IsFrozen.assign(input.CellIds.size(), 0);
  result.PointIds = std::move(faces.PointIds);
  result.CellIds = std::move(faces.CellIds);
  result.Planar.Frame = faces.Frame;
  result.Planar.Coordinates = CoordinatesOf(mesh);
  result.Planar.IsUsed.assign(static_cast<std::size_t>(mesh->GetNumberOfPoints()), 1);
}

void MarkWhere(vtkDataArray* values, const std::vector<vtkIdType>& ids, double value, bool isEqual,
  std::vector<std::uint8_t>& marks)
{
  for (std::size_t k = 0; k < ids.size(); ++k)
  {
    marks[k] |= (values->GetComponent(ids[k], 0) == value) == isEqual;
  }
}

void MarkEmbedded(vtkDataSet* mesh, PlanarMesh& result)
{
  if (vtkDataArray* kinds = mesh->GetPointData()->GetArray("VertexKind"))
  {
    MarkWhere(kinds, result.PointIds, EmbeddedKind, true, result.Input.IsFixed);
  }
}

std::string MarkFrozen(
  vtkDataSet* mesh, vtkDataSet* lines, const std::string& name, PlanarMesh& result)
{
  if (IsNone(name))
  {
    return {};
  }
  vtkDataArray* ofPoints = mesh->GetPointData()->GetArray(name.c_str());
  vtkDataArray* ofCells = mesh->GetCellData()->GetArray(name.c_str());
  if (ofPoints)
  {
    MarkWhere(ofPoints, result.PointIds, 0.0, false, result.Input.IsFixed);
  }
  if (ofCells)
  {
    MarkWhere(ofCells, result.CellIds, 0.0, false, result.Input.IsFrozen);
  }
  const bool isOfLines = lines && lines->GetCellData()->GetArray(name.c_str());
  return ofPoints || ofCells || isOfLines ? ""
                                          : "The input has no numeric point or cell array named " +
      name + ", which Frozen Array asks for.";
}

// The array RegionId need not be there.
std::string NumberRegions(
  vtkDataSet* mesh, const std::string& name, PlanarMesh& result, Pulse& pulse)
{
  const bool isDefault = name == "RegionId";
  if (IsNone(name) || (isDefault && !mesh->GetCellData()->HasArray(name.c_str())))
  {
    return {};
  }
  std::vector<Id> numbers;
  const std::string refusal = FindRegionNumbers(ReadDrawing(mesh), name, numbers, pulse);
  for (std::size_t k = 0; refusal.empty() && !pulse.HasStopped() && k < result.CellIds.size(); ++k)
  {
    result.Input.Regions.push_back(numbers[result.CellIds[k]]);
  }
  return refusal;
}

Point3 PointAt(const double* place)
{
  return { place[0], place[1], place[2] };
}

// Vertices by their places in space.
Directory<Point3> VerticesByPlace(const PlanarMesh& mesh)
{
  Directory<Point3> vertices;
  for (std::size_t vertex = 0; vertex < mesh.PointIds.size(); ++vertex)
  {
    const double* place = mesh.Planar.Place(static_cast<Id>(mesh.PointIds[vertex]));
    vertices.Add(PointAt(place), static_cast<Id>(vertex));
  }
  vertices.Sort();
  return vertices;
}

// Asking poly data for a cell would build something in it.
vtkSmartPointer<vtkDataSet> CopyOf(vtkDataSet* data)
{
  auto copy = vtk::TakeSmartPointer(data->NewInstance());
  copy->ShallowCopy(data);
  return copy;
}

// Each segment of a line is one of its own, with the cell of the line.
std::string ReadLines(vtkDataSet* given, const std::string& frozen, PlanarMesh& result)
{
  const vtkSmartPointer<vtkDataSet> data = CopyOf(given);
  const Directory<Point3> vertices = VerticesByPlace(result);
  const auto coordinates = CoordinatesOf(data);
  RemeshInput& input = result.Input;
  vtkDataArray* isFrozen = IsNone(frozen) ? nullptr : data->GetCellData()->GetArray(frozen.c_str());
  vtkNew<vtkIdList> points;
  std::vector<vtkIdType> along;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    if (ShapeOf(data->GetCellType(cell)) != CellShape::Line)
    {
      continue;
    }
    data->GetCellPoints(cell, points);
    const std::string missing = MissingPointText("the tagged lines", cell, points->GetNumberOfIds(),
      points->GetPointer(0), data->GetNumberOfPoints());
    if (!missing.empty())
    {
      return missing;
    }
    PointsAlong(data->GetCellType(cell), points->GetNumberOfIds(), points->GetPointer(0), along);
    for (std::size_t k = 1; k < along.size(); ++k)
    {
      const Id start = vertices[PointAt(coordinates->GetPointer(3 * along[k - 1]))];
      const Id end = vertices[PointAt(coordinates->GetPointer(3 * along[k]))];
      if (start != NoId && end != NoId && start != end)
      {
        input.LineStarts.push_back(start);
        input.LineEnds.push_back(end);
        input.LineCells.push_back(static_cast<Id>(cell));
        input.IsFrozenLine.push_back(isFrozen && isFrozen->GetComponent(cell, 0) != 0.0);
      }
    }
  }
  return {};
}

constexpr int BoundaryEdges = 1; // the port of all that have them, or the boundary's triangles

bool HasEdges(vtkAlgorithm* producer)
{
  return producer->IsA("vtkBitingMesher") || producer->IsA("vtkBitingRemesher") ||
    producer->IsA("vtkBitingSurfaceMesher") || producer->IsA("vtkBitingTetrahedralizer") ||
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

std::string RemeshInputFromDataSet(vtkDataSet* mesh, vtkDataSet* lines, const RemeshArrays& arrays,
  PlanarMesh& result, Monitor& monitor)
{
  PlanarFaces faces;
  faces.IsOnGlobe = result.Planar.IsOnGlobe;
  std::string refusal = FacesFromDataSet(mesh, FaceRule::Triangles, faces, monitor);
  if (!refusal.empty() || faces.CellIds.empty())
  {
    return refusal;
  }
  Pulse pulse(monitor);
  TakeFaces(mesh, faces, result);
  MarkEmbedded(mesh, result);
  refusal = MarkFrozen(mesh, lines, arrays.Frozen, result);
  refusal = refusal.empty() ? NumberRegions(mesh, arrays.Region, result, pulse) : refusal;
  vtkDataSet* tags = lines ? lines : mesh;
  const bool hasOthers = tags->GetNumberOfCells() > static_cast<vtkIdType>(result.CellIds.size());
  if (refusal.empty() && (lines || hasOthers))
  {
    result.Lines = ReadDrawing(tags);
    refusal = ReadLines(tags, arrays.Frozen, result);
    result.Input.AreAlike = CompareTags(result.Lines, Polylines());
  }
  else
  {
    result.Lines.CellArrays = vtkSmartPointer<vtkFieldData>::New();
  }
  return refusal;
}

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
