// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshFromPieces.h"

#include "../Data/GhostArrays.h"

#include "vtkAppendFilter.h"
#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm> // for all_of, equal, sort
#include <array>     // for places
#include <cmath>     // for isfinite
#include <numeric>   // for iota
#include <string>    // for names
#include <utility>   // for move

namespace biting
{

namespace
{

using DataSets = std::vector<vtkSmartPointer<vtkDataSet>>;
using Numbers = std::vector<vtkIdType>;

// Appending makes no promise of active attributes; as plain arrays they come through.
constexpr const char* GlobalIdsName = "BitingGlobalIds";

void KeepGlobalIds(vtkDataSetAttributes* attributes)
{
  vtkDataArray* ids = attributes->GetGlobalIds();
  if (ids)
  {
    auto copy = vtk::TakeSmartPointer(ids->NewInstance());
    copy->ShallowCopy(ids);
    copy->SetName(GlobalIdsName);
    attributes->AddArray(copy);
  }
}

template <typename Appender, typename Mesh>
vtkSmartPointer<vtkDataSet> Appended(const DataSets& pieces)
{
  vtkNew<Appender> append;
  for (const auto& piece : pieces)
  {
    auto copy = vtk::TakeSmartPointer(piece->NewInstance());
    copy->ShallowCopy(piece);
    KeepGlobalIds(copy->GetPointData());
    KeepGlobalIds(copy->GetCellData());
    append->AddInputData(Mesh::SafeDownCast(copy));
  }
  append->Update();
  return append->GetOutput();
}

bool ArePolyData(const DataSets& pieces)
{
  return std::all_of(pieces.begin(), pieces.end(),
    [](vtkDataSet* piece) { return vtkPolyData::SafeDownCast(piece) != nullptr; });
}

// What pieces have together, as it was before anything was left out, and what of it is kept.
class Merger
{
public:
  Merger(vtkDataSet* all, const DataSets& pieces);

  bool HasPolyhedra() const;
  void MergePoints();
  void ChooseCells();

  template <typename Mesh>
  vtkSmartPointer<vtkDataSet> Result();

private:
  std::size_t PieceOf(vtkIdType point) const;
  bool IsGhost(vtkIdType cell) const;
  void MergeEqualPlaces(const Numbers& group);
  int Compare(vtkIdType a, vtkIdType b) const;
  void LeaveOutRepeated(Numbers& cells) const;
  int Group(vtkIdType cell) const;
  Numbers NumberPoints(Numbers& kept) const;
  Numbers OwnersOf(const Numbers& kept) const;

  vtkDataSet* All;
  Numbers PointEnds; ///< of each piece
  Numbers Merged;    ///< of each point, the one that stands for it
  Numbers Offsets;   ///< of each cell's corners
  Numbers CornerIds; ///< merged points
  Numbers Kept;      ///< cells
  vtkDataArray* PointIds;
  vtkDataArray* CellIds;
  vtkUnsignedCharArray* Ghosts;
};

Merger::Merger(vtkDataSet* all, const DataSets& pieces)
  : All(all)
  , Merged(static_cast<std::size_t>(all->GetNumberOfPoints()))
  , PointIds(all->GetPointData()->GetArray(GlobalIdsName))
  , CellIds(all->GetCellData()->GetArray(GlobalIdsName))
  , Ghosts(all->GetCellGhostArray())
{
  vtkIdType end = 0;
  for (const auto& piece : pieces)
  {
    end += piece->GetNumberOfPoints();
    this->PointEnds.push_back(end);
  }
  std::iota(this->Merged.begin(), this->Merged.end(), vtkIdType{ 0 });
}

bool Merger::HasPolyhedra() const
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(this->All);
  return grid && grid->GetFaces() != nullptr;
}

std::size_t Merger::PieceOf(vtkIdType point) const
{
  const auto end = std::upper_bound(this->PointEnds.begin(), this->PointEnds.end(), point);
  return static_cast<std::size_t>(end - this->PointEnds.begin());
}

// Points of one piece stay apart: they are so in the whole.
void Merger::MergePoints()
{
  using Place = std::pair<std::array<double, 3>, vtkIdType>;
  std::vector<Place> places;
  places.reserve(this->Merged.size());
  for (vtkIdType point = 0; point < this->All->GetNumberOfPoints(); ++point)
  {
    Place place;
    place.second = point;
    this->All->GetPoint(point, place.first.data());
    if (std::all_of(place.first.begin(), place.first.end(),
          [](double coordinate) { return std::isfinite(coordinate); }))
    {
      places.push_back(place);
    }
  }
  std::sort(places.begin(), places.end());
  Numbers group;
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    group.push_back(places[k].second);
    if (k + 1 == places.size() || places[k + 1].first != places[k].first)
    {
      this->MergeEqualPlaces(group);
      group.clear();
    }
  }
}

// The k-th of a later piece is the k-th of the first one.
void Merger::MergeEqualPlaces(const Numbers& group)
{
  const std::size_t firstPiece = this->PieceOf(group.front());
  Numbers first;
  std::size_t number = 0;
  std::size_t piece = firstPiece;
  for (const vtkIdType point : group)
  {
    const std::size_t own = this->PieceOf(point);
    if (own == firstPiece)
    {
      first.push_back(point);
      continue;
    }
    number = own == piece ? number + 1 : 0;
    piece = own;
    this->Merged[static_cast<std::size_t>(point)] = first[std::min(number, first.size() - 1)];
  }
}

bool Merger::IsGhost(vtkIdType cell) const
{
  return this->Ghosts && (this->Ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0;
}

void Merger::ChooseCells()
{
  vtkNew<vtkIdList> corners;
  this->Offsets.push_back(0);
  for (vtkIdType cell = 0; cell < this->All->GetNumberOfCells(); ++cell)
  {
    this->All->GetCellPoints(cell, corners);
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
    {
      this->CornerIds.push_back(this->Merged[static_cast<std::size_t>(corners->GetId(k))]);
    }
    this->Offsets.push_back(static_cast<vtkIdType>(this->CornerIds.size()));
    if (!this->IsGhost(cell) && corners->GetNumberOfIds() > 0)
    {
      this->Kept.push_back(cell);
    }
  }
  this->LeaveOutRepeated(this->Kept);
  const auto isBefore = [this](vtkIdType a, vtkIdType b)
  {
    const bool isSameGroup = this->Group(a) == this->Group(b);
    return isSameGroup ? this->CellIds->GetComponent(a, 0) < this->CellIds->GetComponent(b, 0)
                       : this->Group(a) < this->Group(b);
  };
  std::sort(this->Kept.begin(), this->Kept.end());
  if (this->CellIds)
  {
    std::stable_sort(this->Kept.begin(), this->Kept.end(), isBefore);
  }
}

// The cells of a polydata are ordered by dimension, and strips come last.
int Merger::Group(vtkIdType cell) const
{
  if (!vtkPolyData::SafeDownCast(this->All))
  {
    return 0;
  }
  switch (this->All->GetCellType(cell))
  {
    case VTK_VERTEX:
    case VTK_POLY_VERTEX:
      return 0;
    case VTK_LINE:
    case VTK_POLY_LINE:
      return 1;
    case VTK_TRIANGLE_STRIP:
      return 3;
    default:
      return 2;
  }
}

// By what makes cells of different pieces the same.
int Merger::Compare(vtkIdType a, vtkIdType b) const
{
  if (this->CellIds)
  {
    const double first = this->CellIds->GetComponent(a, 0);
    const double second = this->CellIds->GetComponent(b, 0);
    return first < second ? -1 : (second < first ? 1 : 0);
  }
  const int types[2] = { this->All->GetCellType(a), this->All->GetCellType(b) };
  if (types[0] != types[1])
  {
    return types[0] < types[1] ? -1 : 1;
  }
  const auto corners = this->CornerIds.begin();
  const auto first = corners + this->Offsets[static_cast<std::size_t>(a)];
  const auto firstEnd = corners + this->Offsets[static_cast<std::size_t>(a) + 1];
  const auto second = corners + this->Offsets[static_cast<std::size_t>(b)];
  const auto secondEnd = corners + this->Offsets[static_cast<std::size_t>(b) + 1];
  if (std::lexicographical_compare(first, firstEnd, second, secondEnd))
  {
    return -1;
  }
  return std::lexicographical_compare(second, secondEnd, first, firstEnd) ? 1 : 0;
}

// Cells of one piece stay, also where they are equal: so they are in the whole.
void Merger::LeaveOutRepeated(Numbers& cells) const
{
  std::sort(cells.begin(), cells.end(),
    [this](vtkIdType a, vtkIdType b)
    {
      const int order = this->Compare(a, b);
      return order != 0 ? order < 0 : a < b;
    });
  Numbers kept;
  std::size_t piece = 0;
  vtkNew<vtkIdList> corners;
  for (const vtkIdType cell : cells)
  {
    this->All->GetCellPoints(cell, corners);
    const std::size_t own = this->PieceOf(corners->GetId(0));
    if (kept.empty() || this->Compare(kept.back(), cell) != 0)
    {
      piece = own;
    }
    if (own == piece)
    {
      kept.push_back(cell);
    }
  }
  cells = std::move(kept);
}

// The points that kept cells use, in their new order; returns the new number of each point.
Numbers Merger::NumberPoints(Numbers& kept) const
{
  Numbers numbers(this->Merged.size(), -1);
  for (const vtkIdType cell : this->Kept)
  {
    const auto first = static_cast<std::size_t>(this->Offsets[static_cast<std::size_t>(cell)]);
    const auto end = static_cast<std::size_t>(this->Offsets[static_cast<std::size_t>(cell) + 1]);
    for (std::size_t k = first; k < end; ++k)
    {
      const auto point = static_cast<std::size_t>(this->CornerIds[k]);
      if (numbers[point] < 0)
      {
        numbers[point] = static_cast<vtkIdType>(kept.size());
        kept.push_back(this->CornerIds[k]);
      }
    }
  }
  if (this->PointIds)
  {
    std::stable_sort(kept.begin(), kept.end(),
      [this](vtkIdType a, vtkIdType b)
      { return this->PointIds->GetComponent(a, 0) < this->PointIds->GetComponent(b, 0); });
    for (std::size_t k = 0; k < kept.size(); ++k)
    {
      numbers[static_cast<std::size_t>(kept[k])] = static_cast<vtkIdType>(k);
    }
  }
  return numbers;
}

// Of all points that are one, one that its piece owns, if there is such: what a filter made there
// of cells all around is right.
Numbers Merger::OwnersOf(const Numbers& kept) const
{
  vtkUnsignedCharArray* ghosts = this->All->GetPointGhostArray();
  if (!ghosts)
  {
    return kept;
  }
  const auto isOwn = [ghosts](vtkIdType point)
  { return (ghosts->GetValue(point) & vtkDataSetAttributes::DUPLICATEPOINT) == 0; };
  Numbers owners(this->Merged.size());
  std::iota(owners.begin(), owners.end(), vtkIdType{ 0 });
  for (vtkIdType point = 0; point < this->All->GetNumberOfPoints(); ++point)
  {
    vtkIdType& owner =
      owners[static_cast<std::size_t>(this->Merged[static_cast<std::size_t>(point)])];
    owner = isOwn(owner) || !isOwn(point) ? owner : point;
  }
  Numbers ofKept;
  for (const vtkIdType point : kept)
  {
    ofKept.push_back(owners[static_cast<std::size_t>(point)]);
  }
  return ofKept;
}

// Arrays of other kinds than those that appending keeps are lost with it.
void CopyArrays(vtkDataSetAttributes* from, const Numbers& tuples, vtkDataSetAttributes* to)
{
  vtkNew<vtkIdList> list;
  list->SetNumberOfIds(static_cast<vtkIdType>(tuples.size()));
  std::copy(tuples.begin(), tuples.end(), list->GetPointer(0));
  for (int k = 0; k < from->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* given = from->GetAbstractArray(k);
    const std::string name = given->GetName() ? given->GetName() : "";
    if (name == GlobalIdsName)
    {
      continue;
    }
    auto array = vtk::TakeSmartPointer(given->NewInstance());
    array->SetName(given->GetName());
    array->SetNumberOfComponents(given->GetNumberOfComponents());
    array->CopyComponentNames(given);
    array->SetNumberOfTuples(list->GetNumberOfIds());
    given->GetTuples(list, array);
    const int index = to->AddArray(array);
    const int attribute = from->IsArrayAnAttribute(k);
    if (attribute >= 0)
    {
      to->SetActiveAttribute(index, attribute);
    }
  }
}

template <typename Mesh>
vtkSmartPointer<vtkDataSet> Merger::Result()
{
  Numbers keptPoints;
  const Numbers numbers = this->NumberPoints(keptPoints);
  vtkNew<vtkPoints> points;
  points->SetDataType(Mesh::SafeDownCast(this->All)->GetPoints()->GetDataType());
  points->SetNumberOfPoints(static_cast<vtkIdType>(keptPoints.size()));
  for (std::size_t k = 0; k < keptPoints.size(); ++k)
  {
    points->SetPoint(static_cast<vtkIdType>(k), this->All->GetPoint(keptPoints[k]));
  }
  auto result = vtkSmartPointer<Mesh>::New();
  result->SetPoints(points);
  result->Allocate(static_cast<vtkIdType>(this->Kept.size()));
  Numbers corners;
  for (const vtkIdType cell : this->Kept)
  {
    corners.clear();
    for (auto k = this->Offsets[static_cast<std::size_t>(cell)];
         k < this->Offsets[static_cast<std::size_t>(cell) + 1]; ++k)
    {
      const vtkIdType corner = this->CornerIds[static_cast<std::size_t>(k)];
      corners.push_back(numbers[static_cast<std::size_t>(corner)]);
    }
    result->InsertNextCell(
      this->All->GetCellType(cell), static_cast<int>(corners.size()), corners.data());
  }
  CopyArrays(this->All->GetPointData(), this->OwnersOf(keptPoints), result->GetPointData());
  CopyArrays(this->All->GetCellData(), this->Kept, result->GetCellData());
  return result;
}

} // namespace

vtkSmartPointer<vtkDataSet> MeshFromPieces(const DataSets& pieces)
{
  const bool isPolyData = ArePolyData(pieces);
  const auto all = isPolyData ? Appended<vtkAppendPolyData, vtkPolyData>(pieces)
                              : Appended<vtkAppendFilter, vtkDataSet>(pieces);
  Merger merger(all, pieces);
  if (merger.HasPolyhedra())
  {
    return all;
  }
  merger.MergePoints();
  merger.ChooseCells();
  const auto whole =
    isPolyData ? merger.Result<vtkPolyData>() : merger.Result<vtkUnstructuredGrid>();
  whole->GetFieldData()->ShallowCopy(pieces.front()->GetFieldData());
  ForgetDuplicates(whole);
  return whole;
}

} // namespace biting
