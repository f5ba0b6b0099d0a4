// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshFileFromDataSet.h"

#include "../Data/CellShapes.h"
#include "../Data/GhostArrays.h"
#include "ValueGroups.h"
#include "WrittenParts.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm> // for all_of, any_of
#include <array>     // for places
#include <cmath>     // for isfinite

namespace biting
{

namespace
{

// What the mesher itself adds to its boundary edges.
constexpr const char* OwnArrays[] = { "OriginalCellId", "Kind" };

std::string ReadPoints(vtkDataSet* mesh, const WrittenParts& parts, MeshFile& file)
{
  for (const vtkIdType point : parts.Points())
  {
    std::array<double, 3> place;
    mesh->GetPoint(point, place.data());
    file.Points.push_back(place);
    if (!std::all_of(place.begin(), place.end(), [](double x) { return std::isfinite(x); }))
    {
      return "The coordinates of point " + std::to_string(point) + " are not finite.";
    }
  }
  return {};
}

void AddTriangles(vtkDataSet* mesh, const WrittenParts& parts, MeshFile& file)
{
  vtkSmartPointer<vtkDataArray> regions = mesh->GetCellData()->GetArray("RegionId");
  if (!regions)
  {
    regions = vtkSmartPointer<vtkIntArray>::New();
    regions->SetNumberOfTuples(mesh->GetNumberOfCells());
    regions->Fill(0.0);
  }
  const ValueGroups groups(regions);
  file.Regions = groups.Named(1, "Region ", EndsOfNames);
  vtkNew<vtkIdList> corners;
  for (const vtkIdType cell : parts.Cells())
  {
    if (mesh->GetCellType(cell) == VTK_TRIANGLE)
    {
      mesh->GetCellPoints(cell, corners);
      file.Triangles.push_back({ parts.NumberOf(corners->GetId(0)),
        parts.NumberOf(corners->GetId(1)), parts.NumberOf(corners->GetId(2)) });
      file.RegionOfTriangle.push_back(groups.IndexOf(cell));
    }
  }
}

bool IsFlat(const MeshFile& file)
{
  return std::all_of(file.Points.begin(), file.Points.end(),
    [&file](const std::array<double, 3>& point) { return point[2] == file.Points.front()[2]; });
}

} // namespace

std::string RefusalOfCells(vtkDataSet* mesh)
{
  using Shape = CellShape;
  const GhostArrays ghosts(mesh);
  vtkNew<vtkIdList> points;
  std::string refusal;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells() && refusal.empty(); ++cell)
  {
    mesh->GetCellPoints(cell, points);
    const vtkIdType size = points->GetNumberOfIds();
    const int type = mesh->GetCellType(cell);
    const Shape shape = ShapeOf(type);
    refusal =
      MissingPointText("the mesh", cell, size, points->GetPointer(0), mesh->GetNumberOfPoints());
    if (refusal.empty() && type != VTK_TRIANGLE && shape != Shape::Nothing &&
      shape != Shape::Points && shape != Shape::Line &&
      !ghosts.LeaveOut(cell, size, points->GetPointer(0)))
    {
      refusal = "Cell " + std::to_string(cell) + " is a " +
        vtkCellTypes::GetClassNameFromTypeId(type) +
        "; only triangles are written (apply Extract Surface and Triangulate).";
    }
  }
  return refusal;
}

std::string ReadTriangles(vtkDataSet* mesh, const WrittenParts& parts, MeshFile& file)
{
  const std::string refusal = ReadPoints(mesh, parts, file);
  AddTriangles(mesh, parts, file);
  return refusal.empty() && file.Triangles.empty() ? "There are no triangles to write." : refusal;
}

std::string MakePlanar(MeshFile& file)
{
  if (!IsFlat(file))
  {
    return "This format has two coordinates, and the mesh is not in a plane of constant z.";
  }
  OrientUpwards(file);
  return IsBoundaryOfLoops(file) ? "" : "Triangles overlap, or there are some twice.";
}

std::string ReadDepths(
  vtkDataSet* mesh, const WrittenParts& parts, const std::string& name, MeshFile& file)
{
  vtkDataArray* depths = mesh->GetPointData()->GetArray(name.c_str());
  if (!depths || depths->GetNumberOfComponents() != 1)
  {
    const bool mayLack = !depths && (name.empty() || name == DefaultDepths);
    return mayLack ? ""
                   : "The mesh has no point array of numbers named " + name +
        " with one component, for the depths.";
  }
  for (const vtkIdType point : parts.Points())
  {
    file.Depths.push_back(depths->GetComponent(point, 0));
    if (!std::isfinite(file.Depths.back()))
    {
      return "The depth of point " + std::to_string(point) + ", in the array " + name +
        ", is not finite.";
    }
  }
  return {};
}

vtkAbstractArray* FindTags(vtkCellData* data, const std::string& chosen)
{
  if (!chosen.empty())
  {
    return data->GetAbstractArray(chosen.c_str());
  }
  if (vtkAbstractArray* tags = data->GetAbstractArray("Tag"))
  {
    return tags;
  }
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = data->GetAbstractArray(k);
    const std::string name = array->GetName() ? array->GetName() : "";
    const bool isOwn = std::any_of(
      std::begin(OwnArrays), std::end(OwnArrays), [&name](const char* own) { return name == own; });
    if (!isOwn && array->GetNumberOfComponents() == 1)
    {
      return array;
    }
  }
  return data->GetAbstractArray("Kind");
}

void ReadEdges(
  vtkPolyData* edges, const WrittenParts& parts, const ValueGroups& groups, MeshFile& file)
{
  vtkDataArray* ids = edges->GetPointData()->GetArray("MeshPointId");
  vtkNew<vtkIdList> ends;
  for (vtkIdType cell = 0; cell < edges->GetNumberOfCells(); ++cell)
  {
    edges->GetCellPoints(cell, ends);
    if (ends->GetNumberOfIds() == 2 && groups.Has(cell))
    {
      file.Edges.push_back({ parts.NumberOf(static_cast<vtkIdType>(ids->GetTuple1(ends->GetId(0)))),
        parts.NumberOf(static_cast<vtkIdType>(ids->GetTuple1(ends->GetId(1)))) });
      file.TagOfEdge.push_back(groups.IndexOf(cell));
    }
  }
}

} // namespace biting
