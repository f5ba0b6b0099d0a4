// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshFileFromDataSet.h"

#include "../Data/Arrays.h"
#include "../Data/Cells.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"

#include <algorithm> // for find, max, replace_if
#include <array>     // for places
#include <cmath>     // for abs, floor, isnan
#include <cstdint>   // for global ids
#include <map>       // for what has an id
#include <numeric>   // for iota
#include <set>       // for names that were changed

namespace biting
{

namespace
{

// From here on there are whole numbers that are no double: 2^53.
constexpr double LeastInexact = 9007199254740992.0;

std::string WithoutForbidden(std::string name, const std::string& forbidden)
{
  std::replace_if(
    name.begin(), name.end(),
    [&forbidden](char c) { return forbidden.find(c) != std::string::npos; }, '_');
  return name;
}

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

// What the meshers themselves add to their boundary.
constexpr const char* OwnArrays[] = { "OriginalCellId", "Kind", "MeshCellId", "RegionId",
  "Deviation", "MinimumAngle", "RadiusEdgeRatio", "AspectRatio" };

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

// The corners of a cell, of points with numbers.
template <std::size_t Size, typename Number>
std::array<MeshFile::Vertex, Size> CornersOf(vtkIdList* points, Number numberOf)
{
  std::array<MeshFile::Vertex, Size> corners{};
  const vtkIdType* const first = points->GetPointer(0);
  std::transform(first, first + Size, corners.begin(), numberOf);
  return corners;
}

// Cells without a text are a group of their own, the last one.
void AddCells(vtkDataSet* mesh, const WrittenParts& parts, vtkAbstractArray* regions, bool isChosen,
  MeshFile& file)
{
  const ValueGroups groups(regions);
  file.Regions = groups.Named(isChosen ? 0 : 1, isChosen ? "" : "Region ", EndsOfNames);
  const std::size_t unnamed = file.Regions.size();
  vtkNew<vtkIdList> corners;
  const auto numberOf = [&parts](vtkIdType point) { return parts.NumberOf(point); };
  for (const vtkIdType cell : parts.Cells())
  {
    const int type = mesh->GetCellType(cell);
    if (type == VTK_TRIANGLE || type == VTK_TETRA)
    {
      mesh->GetCellPoints(cell, corners);
      type == VTK_TRIANGLE ? file.Triangles.push_back(CornersOf<3>(corners, numberOf))
                           : file.Tetrahedra.push_back(CornersOf<4>(corners, numberOf));
      file.RegionOfCell.push_back(groups.Has(cell) ? groups.IndexOf(cell) : unnamed);
    }
  }
  if (std::find(file.RegionOfCell.begin(), file.RegionOfCell.end(), unnamed) !=
    file.RegionOfCell.end())
  {
    std::int64_t highest = 0;
    for (const MeshGroup& region : file.Regions)
    {
      highest = std::max(highest, region.Number);
    }
    file.Regions.push_back({ highest + 1, "" });
  }
}

// Of the first corner of a tetrahedron.
std::string PlaceOf(const MeshFile& file, std::size_t tetrahedron)
{
  const auto corner = static_cast<std::size_t>(file.Tetrahedra[tetrahedron].front());
  const std::array<double, 3>& place = file.Points[corner];
  return "(" + ShortText(place[0]) + ", " + ShortText(place[1]) + ", " + ShortText(place[2]) + ").";
}

bool IsFlat(const MeshFile& file)
{
  return std::all_of(file.Points.begin(), file.Points.end(),
    [&file](const std::array<double, 3>& point) { return point[2] == file.Points.front()[2]; });
}

} // namespace

ValueGroups::ValueGroups(vtkAbstractArray* values)
  : Values(values)
  , Numbers(vtkDataArray::SafeDownCast(values))
{
  for (vtkIdType k = 0; k < values->GetNumberOfTuples(); ++k)
  {
    if (this->Has(k))
    {
      this->Indices.emplace(this->KeyOf(k), 0);
    }
  }
  std::size_t index = 0;
  for (auto& entry : this->Indices)
  {
    entry.second = index++;
  }
}

std::vector<MeshGroup> ValueGroups::Named(
  std::int64_t shift, const std::string& prefix, const std::string& forbidden) const
{
  std::int64_t highest = 0;
  for (const auto& entry : this->Indices)
  {
    highest = std::max(highest, NumberOf(entry.first) + shift);
  }
  std::set<std::string> changed;
  std::vector<MeshGroup> groups;
  for (const auto& entry : this->Indices)
  {
    const std::int64_t own = NumberOf(entry.first) + shift;
    const std::string given = this->NameOf(entry.first);
    std::string name = WithoutForbidden(given, forbidden);
    while (name != given && (this->Indices.count({ 0.0, name }) || !changed.insert(name).second))
    {
      name += '_';
    }
    groups.push_back({ own > 0 ? own : ++highest, prefix + name });
  }
  return groups;
}

ValueGroups::Key ValueGroups::KeyOf(vtkIdType item) const
{
  const double number = this->Numbers ? this->Numbers->GetComponent(item, 0) : std::nan("");
  const int type = this->Values->GetDataType();
  const bool isReal = type == VTK_FLOAT || type == VTK_DOUBLE;
  if (!std::isnan(number) && (isReal || std::abs(number) < LeastInexact))
  {
    return { number, std::string() };
  }
  const vtkIdType first = item * this->Values->GetNumberOfComponents();
  return { std::isnan(number) ? 0.0 : number, this->Values->GetVariantValue(first).ToString() };
}

// Far below 0 where it is no whole number.
std::int64_t ValueGroups::NumberOf(const Key& key)
{
  const bool isWhole = key.second.empty() && std::floor(key.first) == key.first;
  return isWhole && std::abs(key.first) < 1e9 ? static_cast<std::int64_t>(key.first) : -2000000000;
}

// Whole numbers have all of their digits.
std::string ValueGroups::NameOf(const Key& key) const
{
  const double value = key.first;
  if (!key.second.empty() || (std::floor(value) == value && std::abs(value) < LeastInexact))
  {
    return key.second.empty() ? std::to_string(static_cast<std::int64_t>(value)) : key.second;
  }
  return this->Values->GetDataType() == VTK_FLOAT ? ShortText(static_cast<float>(value))
                                                  : ShortText(value);
}

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

std::string RefusalOfCells(vtkDataSet* mesh)
{
  using Shape = CellShape;
  int written = VTK_EMPTY_CELL; // the type of the first one
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
    const bool isSeen = refusal.empty() && shape != Shape::Nothing && shape != Shape::Points &&
      shape != Shape::Line && !ghosts.LeaveOut(cell, size, points->GetPointer(0));
    const bool isWritten = type == VTK_TRIANGLE || type == VTK_TETRA;
    written = isSeen && written == VTK_EMPTY_CELL ? type : written;
    if (isSeen && (!isWritten || type != written))
    {
      refusal = "Cell " + std::to_string(cell) + " is a " +
        vtkCellTypes::GetClassNameFromTypeId(type) +
        "; only triangles alone or tetrahedra alone are written (apply Extract Cells By Type, "
        "Tetrahedralize, or Extract Surface and Triangulate).";
    }
  }
  return refusal;
}

std::string ReadCells(
  vtkDataSet* mesh, const WrittenParts& parts, const std::string& regions, MeshFile& file)
{
  const bool isChosen = !regions.empty() && regions != "None";
  vtkSmartPointer<vtkAbstractArray> values =
    mesh->GetCellData()->GetAbstractArray(isChosen ? regions.c_str() : "RegionId");
  if (isChosen && !values)
  {
    return "The mesh has no cell array named " + regions + ", for the regions.";
  }
  if (!vtkDataArray::SafeDownCast(values) && !isChosen)
  {
    vtkNew<vtkIntArray> zeros;
    zeros->SetNumberOfTuples(mesh->GetNumberOfCells());
    zeros->Fill(0.0);
    values = zeros;
  }
  const std::string refusal = ReadPoints(mesh, parts, file);
  AddCells(mesh, parts, values, isChosen, file);
  return refusal.empty() && file.NumberOfCells() == 0
    ? "There are no triangles or tetrahedra to write."
    : refusal;
}

std::string OrientCells(MeshFile& file)
{
  constexpr const char* overlap = "Cells overlap, or there are some twice.";
  if (file.IsSolid())
  {
    const std::size_t flat = OrientTetrahedra(file);
    return flat < file.Tetrahedra.size() ? "A tetrahedron has no volume: " + PlaceOf(file, flat)
      : IsBoundaryClosed(file)           ? ""
                                         : overlap;
  }
  if (!IsFlat(file))
  {
    return "This format has two coordinates, and the mesh is not in a plane of constant z.";
  }
  OrientUpwards(file);
  return IsBoundaryClosed(file) ? "" : overlap;
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

vtkSmartPointer<vtkAbstractArray> OneTag(vtkIdType numberOfSides)
{
  const auto tags = vtkSmartPointer<vtkStringArray>::New();
  for (vtkIdType side = 0; side < numberOfSides; ++side)
  {
    tags->InsertNextValue("boundary");
  }
  return tags;
}

void ReadSides(
  vtkPolyData* sides, const WrittenParts& parts, const ValueGroups& groups, MeshFile& file)
{
  vtkDataArray* ids = sides->GetPointData()->GetArray("MeshPointId");
  const auto numberOf = [ids, &parts](vtkIdType point)
  { return parts.NumberOf(static_cast<vtkIdType>(ids->GetTuple1(point))); };
  const vtkIdType size = file.IsSolid() ? 3 : 2;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < sides->GetNumberOfCells(); ++cell)
  {
    sides->GetCellPoints(cell, corners);
    if (corners->GetNumberOfIds() == size && groups.Has(cell))
    {
      file.IsSolid() ? file.Triangles.push_back(CornersOf<3>(corners, numberOf))
                     : file.Edges.push_back(CornersOf<2>(corners, numberOf));
      file.TagOfSide.push_back(groups.IndexOf(cell));
    }
  }
}

} // namespace biting
