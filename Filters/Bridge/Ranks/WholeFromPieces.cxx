// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "WholeFromPieces.h"

#include "../Data/Arrays.h"
#include "../Data/Cells.h"
#include "../Data/DataTree.h"

#include "vtkAppendFilter.h"
#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm> // for all_of, find_if, max, stable_sort, upper_bound
#include <array>     // for places
#include <map>       // for what is there already
#include <numeric>   // for iota
#include <string>    // for names
#include <utility>   // for pair

namespace biting
{

namespace
{

// Those that have anything, and a number of blocks.
Pieces Contributing(const Pieces& pieces)
{
  Pieces contributing;
  for (const auto& piece : pieces)
  {
    if (piece && !LeavesOf(piece).empty())
    {
      contributing.push_back(piece);
    }
  }
  return contributing;
}

vtkSmartPointer<vtkDataObject> FirstOf(const Pieces& pieces)
{
  const auto first =
    std::find_if(pieces.begin(), pieces.end(), [](const auto& piece) { return piece != nullptr; });
  return first == pieces.end() ? nullptr : *first;
}

Pieces LeavesOfAll(const Pieces& pieces)
{
  Pieces all;
  for (const auto& piece : pieces)
  {
    for (const auto& leaf : LeavesOf(piece))
    {
      all.emplace_back(leaf);
    }
  }
  return all;
}

bool AreTrees(const Pieces& pieces)
{
  const int type = pieces.front()->GetDataObjectType();
  return vtkDataObjectTree::SafeDownCast(pieces.front()) &&
    std::all_of(pieces.begin(), pieces.end(),
      [type](const auto& piece) { return piece->GetDataObjectType() == type; });
}

vtkSmartPointer<vtkDataObject> PartsAsOne(const Pieces& pieces)
{
  auto* like = vtkPartitionedDataSet::SafeDownCast(pieces.front());
  auto whole = vtk::TakeSmartPointer(like->NewInstance());
  whole->SetPartition(0, WholeFromPieces(LeavesOfAll(pieces)));
  return whole;
}

vtkSmartPointer<vtkDataObject> TreeFromPieces(const Pieces& pieces)
{
  if (vtkPartitionedDataSet::SafeDownCast(pieces.front()))
  {
    return PartsAsOne(pieces);
  }
  auto* like = vtkDataObjectTree::SafeDownCast(pieces.front());
  auto whole = vtk::TakeSmartPointer(like->NewInstance());
  unsigned int count = 0;
  for (const auto& piece : pieces)
  {
    count = std::max(count, NumberOfChildren(vtkDataObjectTree::SafeDownCast(piece)));
  }
  for (unsigned int child = 0; child < count; ++child)
  {
    Pieces children;
    std::string name;
    for (const auto& piece : pieces)
    {
      auto* tree = vtkDataObjectTree::SafeDownCast(piece);
      const bool isThere = child < NumberOfChildren(tree);
      children.emplace_back(isThere ? ChildOf(tree, child) : nullptr);
      name = isThere && name.empty() ? NameOfChild(tree, child) : name;
    }
    SetChild(whole, child, WholeFromPieces(children), name);
  }
  return whole;
}

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
  std::vector<double> KeyOf(vtkIdType cell) const;
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

// Points of one piece stay apart, as they are in the whole: the k-th of a piece at a place is the
// k-th of any other piece there.
void Merger::MergePoints()
{
  using Place = std::array<double, 3>;
  std::map<std::pair<Place, std::size_t>, vtkIdType> first;  // by place and k
  std::map<Place, std::pair<std::size_t, std::size_t>> last; // piece, and its points so far
  for (vtkIdType point = 0; point < this->All->GetNumberOfPoints(); ++point)
  {
    Place place{};
    this->All->GetPoint(point, place.data());
    this->Merged.push_back(point);
    if (AreFinite(place.data()))
    {
      const std::size_t piece = this->PieceOf(point);
      auto& [lastPiece, count] = last[place];
      count = lastPiece == piece ? count + 1 : 1;
      lastPiece = piece;
      this->Merged.back() = first.emplace(std::make_pair(place, count), point).first->second;
    }
  }
}

bool Merger::IsGhost(vtkIdType cell) const
{
  return this->Ghosts && (this->Ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0;
}

// Cells of one piece stay, also where they are equal: so they are in the whole.
void Merger::ChooseCells()
{
  vtkNew<vtkIdList> corners;
  std::map<std::vector<double>, std::size_t> firstPieces;
  this->Offsets.push_back(0);
  for (vtkIdType cell = 0; cell < this->All->GetNumberOfCells(); ++cell)
  {
    this->All->GetCellPoints(cell, corners);
    for (const vtkIdType corner : *corners)
    {
      this->CornerIds.push_back(this->Merged[corner]);
    }
    this->Offsets.push_back(static_cast<vtkIdType>(this->CornerIds.size()));
    if (this->IsGhost(cell) || corners->GetNumberOfIds() == 0)
    {
      continue;
    }
    const std::size_t piece = this->PieceOf(corners->GetId(0));
    if (firstPieces.emplace(this->KeyOf(cell), piece).first->second == piece)
    {
      this->Kept.push_back(cell);
    }
  }
  if (this->CellIds)
  {
    std::stable_sort(this->Kept.begin(), this->Kept.end(),
      [this](vtkIdType a, vtkIdType b)
      {
        const int groups[2] = { this->Group(a), this->Group(b) };
        return groups[0] != groups[1]
          ? groups[0] < groups[1]
          : this->CellIds->GetComponent(a, 0) < this->CellIds->GetComponent(b, 0);
      });
  }
}

// What makes cells of different pieces the same: the global id, else type and points.
std::vector<double> Merger::KeyOf(vtkIdType cell) const
{
  if (this->CellIds)
  {
    return { this->CellIds->GetComponent(cell, 0) };
  }
  const auto corners = this->CornerIds.begin();
  std::vector<double> key(
    corners + this->Offsets[cell], corners + this->Offsets[static_cast<std::size_t>(cell) + 1]);
  key.push_back(this->All->GetCellType(cell));
  return key;
}

// The cells of a polydata are ordered by dimension, and strips come last.
int Merger::Group(vtkIdType cell) const
{
  if (!vtkPolyData::SafeDownCast(this->All))
  {
    return 0;
  }
  switch (ShapeOf(this->All->GetCellType(cell)))
  {
    case CellShape::Points:
      return 0;
    case CellShape::Line:
      return 1;
    case CellShape::Strip:
      return 3;
    default:
      return 2;
  }
}

// The points that kept cells use, in their new order; returns the new number of each point.
Numbers Merger::NumberPoints(Numbers& kept) const
{
  Numbers numbers(this->Merged.size(), -1);
  for (const vtkIdType cell : this->Kept)
  {
    const auto first = static_cast<std::size_t>(this->Offsets[cell]);
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
      numbers[kept[k]] = static_cast<vtkIdType>(k);
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
    vtkIdType& owner = owners[this->Merged[static_cast<std::size_t>(point)]];
    owner = isOwn(owner) || !isOwn(point) ? owner : point;
  }
  Numbers ofKept;
  for (const vtkIdType point : kept)
  {
    ofKept.push_back(owners[point]);
  }
  return ofKept;
}

void CopyArrays(vtkDataSetAttributes* from, const Numbers& tuples, vtkDataSetAttributes* to)
{
  vtkNew<vtkIdList> list;
  list->SetNumberOfIds(static_cast<vtkIdType>(tuples.size()));
  std::copy(tuples.begin(), tuples.end(), list->GetPointer(0));
  vtkNew<vtkIdList> places;
  places->SetNumberOfIds(list->GetNumberOfIds());
  std::iota(places->GetPointer(0), places->GetPointer(0) + tuples.size(), 0);
  to->CopyAllOn();
  to->CopyAllocate(from, list->GetNumberOfIds());
  to->CopyData(from, list, places); // the one that older VTK has
  to->RemoveArray(GlobalIdsName);
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
    for (auto k = this->Offsets[cell]; k < this->Offsets[static_cast<std::size_t>(cell) + 1]; ++k)
    {
      const vtkIdType corner = this->CornerIds[k];
      corners.push_back(numbers[corner]);
    }
    result->InsertNextCell(
      this->All->GetCellType(cell), static_cast<int>(corners.size()), corners.data());
  }
  CopyArrays(this->All->GetPointData(), this->OwnersOf(keptPoints), result->GetPointData());
  CopyArrays(this->All->GetCellData(), this->Kept, result->GetCellData());
  return result;
}

// A polydata of polydata, an unstructured grid of others; with the arrays that all pieces have.
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

using DataSets = std::vector<vtkSmartPointer<vtkDataSet>>;
using Extent = std::array<int, 6>;

// Points or cells of a box, numbered along x first.
struct Lattice
{
  Extent Box;

  vtkIdType Size(std::size_t axis) const
  {
    return this->Box[2 * axis + 1] - this->Box[2 * axis] + 1;
  }
  vtkIdType Size() const { return this->Size(0) * this->Size(1) * this->Size(2); }
  vtkIdType NumberOf(int i, int j, int k) const
  {
    return (i - this->Box[0]) +
      this->Size(0) * ((j - this->Box[2]) + this->Size(1) * (k - this->Box[4]));
  }
};

// The points of an extent, or its cells; along axes of one point these are as many as points.
Lattice LatticeOf(const Extent& points, int association)
{
  Lattice lattice{ points };
  for (std::size_t axis = 0; axis < 3 && association == vtkDataObject::CELL; ++axis)
  {
    lattice.Box[2 * axis + 1] -= lattice.Size(axis) > 1 ? 1 : 0;
  }
  return lattice;
}

bool HaveSameAxes(vtkImageData* a, vtkImageData* b)
{
  const double* first = a->GetDirectionMatrix()->GetData();
  return std::equal(a->GetOrigin(), a->GetOrigin() + 3, b->GetOrigin()) &&
    std::equal(a->GetSpacing(), a->GetSpacing() + 3, b->GetSpacing()) &&
    std::equal(first, first + 9, b->GetDirectionMatrix()->GetData());
}

bool AreAlike(vtkDataSet* a, vtkDataSet* b)
{
  auto* image = vtkImageData::SafeDownCast(a);
  return a->GetDataObjectType() == b->GetDataObjectType() &&
    (!image || HaveSameAxes(image, vtkImageData::SafeDownCast(b)));
}

Extent UnionOf(const std::vector<Extent>& extents)
{
  Extent whole = extents.front();
  for (const Extent& extent : extents)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      whole[2 * axis] = std::min(whole[2 * axis], extent[2 * axis]);
      whole[2 * axis + 1] = std::max(whole[2 * axis + 1], extent[2 * axis + 1]);
    }
  }
  return whole;
}

// Which piece a point or a cell of the whole is taken from, and its number there.
struct Origin
{
  int Piece = -1;
  vtkIdType Number = 0;
};

// Puts the pieces into one extent.
class Assembly
{
public:
  Assembly(const DataSets& pieces, const std::vector<Extent>& extents);

  bool HasGaps() const { return this->Gaps; }
  vtkSmartPointer<vtkDataSet> Whole();

private:
  void FindOrigins(int association, const std::vector<Extent>& extents);
  void Take(int piece, bool areGhosts, int association, const Lattice& part, const Lattice& whole);
  void SetGeometry(vtkDataSet* whole);
  vtkSmartPointer<vtkDataArray> CoordinatesAlong(std::size_t axis) const;
  vtkSmartPointer<vtkPoints> PointsOfAll() const;
  void CopyArrays(int association, vtkDataSet* whole) const;

  const DataSets& Pieces;
  Extent Box;
  std::array<std::vector<Origin>, 2> Origins; // of points, of cells
  bool Gaps = false;
};

Assembly::Assembly(const DataSets& pieces, const std::vector<Extent>& extents)
  : Pieces(pieces)
  , Box(UnionOf(extents))
{
  vtkIdType most = 0;
  for (const Extent& extent : extents)
  {
    most += Lattice{ extent }.Size();
  }
  this->Gaps = most < Lattice{ this->Box }.Size();
  for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    if (!this->Gaps)
    {
      this->FindOrigins(association, extents);
    }
  }
}

// Of points the first piece that has it, of cells the first where it is no ghost, else the first.
void Assembly::FindOrigins(int association, const std::vector<Extent>& extents)
{
  const Lattice whole = LatticeOf(this->Box, association);
  std::vector<Origin>& origins = this->Origins[association];
  origins.resize(static_cast<std::size_t>(whole.Size()));
  for (const bool areGhosts : { false, true })
  {
    for (std::size_t piece = 0; piece < extents.size(); ++piece)
    {
      const Lattice part = LatticeOf(extents[piece], association);
      this->Take(static_cast<int>(piece), areGhosts, association, part, whole);
    }
  }
  this->Gaps = std::any_of(
    origins.begin(), origins.end(), [](const Origin& origin) { return origin.Piece < 0; });
}

void Assembly::Take(
  int piece, bool areGhosts, int association, const Lattice& part, const Lattice& whole)
{
  vtkUnsignedCharArray* ghosts =
    association == vtkDataObject::CELL ? GhostsOf(this->Pieces[piece], association) : nullptr;
  std::vector<Origin>& origins = this->Origins[association];
  vtkIdType from = 0;
  for (int k = part.Box[4]; k <= part.Box[5]; ++k)
  {
    for (int j = part.Box[2]; j <= part.Box[3]; ++j)
    {
      for (int i = part.Box[0]; i <= part.Box[1]; ++i, ++from)
      {
        Origin& origin = origins[whole.NumberOf(i, j, k)];
        const bool isGhost =
          ghosts && (ghosts->GetValue(from) & vtkDataSetAttributes::DUPLICATECELL) != 0;
        if (isGhost == areGhosts && origin.Piece < 0)
        {
          origin = { piece, from };
        }
      }
    }
  }
}

vtkSmartPointer<vtkDataSet> Assembly::Whole()
{
  auto whole = vtk::TakeSmartPointer(this->Pieces.front()->NewInstance());
  this->SetGeometry(whole);
  this->CopyArrays(vtkDataObject::POINT, whole);
  this->CopyArrays(vtkDataObject::CELL, whole);
  whole->GetFieldData()->ShallowCopy(this->Pieces.front()->GetFieldData());
  ForgetDuplicates(whole);
  return whole;
}

void Assembly::SetGeometry(vtkDataSet* whole)
{
  if (auto* image = vtkImageData::SafeDownCast(whole))
  {
    auto* first = vtkImageData::SafeDownCast(this->Pieces.front());
    image->SetExtent(this->Box.data());
    image->SetOrigin(first->GetOrigin());
    image->SetSpacing(first->GetSpacing());
    image->SetDirectionMatrix(first->GetDirectionMatrix());
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(whole))
  {
    rectilinear->SetExtent(this->Box.data());
    rectilinear->SetXCoordinates(this->CoordinatesAlong(0));
    rectilinear->SetYCoordinates(this->CoordinatesAlong(1));
    rectilinear->SetZCoordinates(this->CoordinatesAlong(2));
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(whole))
  {
    structured->SetExtent(this->Box.data());
    structured->SetPoints(this->PointsOfAll());
  }
}

vtkSmartPointer<vtkDataArray> Assembly::CoordinatesAlong(std::size_t axis) const
{
  const Lattice points{ this->Box };
  auto coordinates = vtkSmartPointer<vtkDoubleArray>::New();
  std::array<int, 3> place{ this->Box[0], this->Box[2], this->Box[4] };
  for (; place[axis] <= this->Box[2 * axis + 1]; ++place[axis])
  {
    const auto number = static_cast<std::size_t>(points.NumberOf(place[0], place[1], place[2]));
    const Origin& origin = this->Origins[vtkDataObject::POINT][number];
    coordinates->InsertNextValue(this->Pieces[origin.Piece]->GetPoint(origin.Number)[axis]);
  }
  return coordinates;
}

// Of the type that all pieces have, else double.
vtkSmartPointer<vtkPoints> Assembly::PointsOfAll() const
{
  const int type = TypeOfCoordinates(this->Pieces.front());
  const bool isType = std::all_of(this->Pieces.begin(), this->Pieces.end(),
    [type](vtkDataSet* piece) { return TypeOfCoordinates(piece) == type; });
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(isType ? type : VTK_DOUBLE);
  for (const Origin& origin : this->Origins[vtkDataObject::POINT])
  {
    points->InsertNextPoint(this->Pieces[origin.Piece]->GetPoint(origin.Number));
  }
  return points;
}

// Those that all pieces have.
void Assembly::CopyArrays(int association, vtkDataSet* whole) const
{
  const std::vector<Origin>& origins = this->Origins[association];
  vtkDataSetAttributes* attributes = whole->GetAttributes(association);
  vtkDataSetAttributes::FieldList common;
  for (vtkDataSet* piece : this->Pieces)
  {
    common.IntersectFieldList(piece->GetAttributes(association));
  }
  attributes->CopyAllOn();
  common.CopyAllocate(
    attributes, vtkDataSetAttributes::COPYTUPLE, static_cast<vtkIdType>(origins.size()), 0);
  vtkIdType to = 0;
  for (const Origin& origin : origins)
  {
    common.CopyData(origin.Piece, this->Pieces[origin.Piece]->GetAttributes(association),
      origin.Number, attributes, to++);
  }
}

} // namespace

vtkSmartPointer<vtkDataObject> WholeFromPieces(const Pieces& pieces)
{
  const Pieces contributing = Contributing(pieces);
  if (contributing.size() < 2)
  {
    return contributing.empty() ? FirstOf(pieces) : contributing.front();
  }
  if (AreTrees(contributing))
  {
    return TreeFromPieces(contributing);
  }
  std::vector<vtkSmartPointer<vtkDataSet>> leaves;
  for (const auto& leaf : LeavesOfAll(contributing))
  {
    leaves.emplace_back(vtkDataSet::SafeDownCast(leaf));
  }
  MakeArraysAlike(leaves);
  const auto structured = StructuredFromPieces(leaves);
  return structured ? structured : MeshFromPieces(leaves);
}

bool FindExtent(vtkDataSet* piece, std::array<int, 6>& extent)
{
  if (auto* image = vtkImageData::SafeDownCast(piece))
  {
    image->GetExtent(extent.data());
    return true;
  }
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(piece))
  {
    grid->GetExtent(extent.data());
    return true;
  }
  if (auto* grid = vtkStructuredGrid::SafeDownCast(piece))
  {
    grid->GetExtent(extent.data());
    return true;
  }
  return false;
}

vtkSmartPointer<vtkDataSet> StructuredFromPieces(const DataSets& pieces)
{
  std::vector<Extent> extents;
  for (const auto& piece : pieces)
  {
    Extent extent;
    if (!AreAlike(pieces.front(), piece) || !FindExtent(piece, extent))
    {
      return nullptr;
    }
    extents.push_back(extent);
  }
  Assembly assembly(pieces, extents);
  return assembly.HasGaps() ? nullptr : assembly.Whole();
}

} // namespace biting
