// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "StructuredFromPieces.h"

#include "../Data/DoubleArray.h"
#include "../Data/GhostArrays.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm> // for equal, max, min
#include <array>     // for extents
#include <utility>   // for move

namespace biting
{

namespace
{

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

// The cells of an extent of points; along axes of one point they are as many as points.
Lattice CellsOf(const Extent& points)
{
  Lattice cells{ points };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    cells.Box[2 * axis + 1] -= cells.Size(axis) > 1 ? 1 : 0;
  }
  return cells;
}

template <typename Function>
void ForEach(const Lattice& part, const Lattice& whole, Function visit)
{
  vtkIdType from = 0;
  for (int k = part.Box[4]; k <= part.Box[5]; ++k)
  {
    for (int j = part.Box[2]; j <= part.Box[3]; ++j)
    {
      for (int i = part.Box[0]; i <= part.Box[1]; ++i)
      {
        visit(from++, whole.NumberOf(i, j, k));
      }
    }
  }
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

void CopyCoordinates(
  vtkDataArray* from, int first, int wholeFirst, vtkIdType size, vtkSmartPointer<vtkDataArray>& to)
{
  if (!to)
  {
    to = vtk::TakeSmartPointer(from->NewInstance());
    to->SetNumberOfTuples(size);
  }
  else if (to->GetDataType() != from->GetDataType())
  {
    to = AsDoubles(to);
  }
  to->InsertTuples(first - wholeFirst, from->GetNumberOfTuples(), 0, from);
}

// What a piece gives: its own numbers, and those in the whole.
struct Part
{
  vtkNew<vtkIdList> From;
  vtkNew<vtkIdList> To;
};

void PlaceOne(std::vector<char>& isPlaced, Part& part, vtkIdType from, vtkIdType to)
{
  char& isThere = isPlaced[static_cast<std::size_t>(to)];
  if (!isThere)
  {
    isThere = 1;
    part.From->InsertNextId(from);
    part.To->InsertNextId(to);
  }
}

// Puts the pieces into one extent.
class Assembly
{
public:
  Assembly(const DataSets& pieces, std::vector<Extent> extents);

  bool HasGaps() const { return this->Gaps; }
  vtkSmartPointer<vtkDataSet> Whole() const;

private:
  void PlacePoints(std::size_t piece);
  void PlaceCells(std::size_t piece, bool areGhosts);
  void SetGeometry(vtkDataSet* whole) const;
  void SetImage(vtkImageData* whole) const;
  void SetRectilinearGrid(vtkRectilinearGrid* whole) const;
  void SetStructuredGrid(vtkStructuredGrid* whole) const;
  void CopyArrays(int association, vtkIdType size, vtkDataSet* whole) const;
  bool HaveAll(int association, vtkAbstractArray* like) const;
  vtkSmartPointer<vtkAbstractArray> ArrayOfAll(
    int association, vtkAbstractArray* like, vtkIdType size) const;

  const DataSets& Pieces;
  std::vector<Extent> Extents;
  Lattice Points;
  Lattice Cells;
  std::vector<char> IsPointPlaced;
  std::vector<char> IsCellPlaced;
  std::vector<Part> PointParts;
  std::vector<Part> CellParts;
  bool Gaps = false;
};

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

Assembly::Assembly(const DataSets& pieces, std::vector<Extent> extents)
  : Pieces(pieces)
  , Extents(std::move(extents))
  , Points{ UnionOf(this->Extents) }
  , Cells(CellsOf(this->Points.Box))
  , PointParts(pieces.size())
  , CellParts(pieces.size())
{
  vtkIdType most = 0;
  for (const Extent& extent : this->Extents)
  {
    most += Lattice{ extent }.Size();
  }
  this->Gaps = most < this->Points.Size();
  if (this->Gaps)
  {
    return;
  }
  this->IsPointPlaced.assign(static_cast<std::size_t>(this->Points.Size()), 0);
  this->IsCellPlaced.assign(static_cast<std::size_t>(this->Cells.Size()), 0);
  for (const bool areGhosts : { false, true })
  {
    for (std::size_t piece = 0; piece < pieces.size(); ++piece)
    {
      this->PlaceCells(piece, areGhosts);
    }
  }
  for (std::size_t piece = 0; piece < pieces.size(); ++piece)
  {
    this->PlacePoints(piece);
  }
  const auto isMissing = [](char isPlaced) { return isPlaced == 0; };
  this->Gaps = std::any_of(this->IsPointPlaced.begin(), this->IsPointPlaced.end(), isMissing) ||
    std::any_of(this->IsCellPlaced.begin(), this->IsCellPlaced.end(), isMissing);
}

void Assembly::PlacePoints(std::size_t piece)
{
  Part& part = this->PointParts[piece];
  ForEach(Lattice{ this->Extents[piece] }, this->Points,
    [this, &part](vtkIdType from, vtkIdType to) { PlaceOne(this->IsPointPlaced, part, from, to); });
}

void Assembly::PlaceCells(std::size_t piece, bool areGhosts)
{
  vtkUnsignedCharArray* ghosts = GhostsOf(this->Pieces[piece], vtkDataObject::CELL);
  Part& part = this->CellParts[piece];
  ForEach(CellsOf(this->Extents[piece]), this->Cells,
    [this, ghosts, areGhosts, &part](vtkIdType from, vtkIdType to)
    {
      const bool isGhost =
        ghosts && (ghosts->GetValue(from) & vtkDataSetAttributes::DUPLICATECELL) != 0;
      if (isGhost == areGhosts)
      {
        PlaceOne(this->IsCellPlaced, part, from, to);
      }
    });
}

vtkSmartPointer<vtkDataSet> Assembly::Whole() const
{
  auto whole = vtk::TakeSmartPointer(this->Pieces.front()->NewInstance());
  this->SetGeometry(whole);
  this->CopyArrays(vtkDataObject::POINT, this->Points.Size(), whole);
  this->CopyArrays(vtkDataObject::CELL, this->Cells.Size(), whole);
  whole->GetFieldData()->ShallowCopy(this->Pieces.front()->GetFieldData());
  ForgetDuplicates(whole);
  return whole;
}

void Assembly::SetGeometry(vtkDataSet* whole) const
{
  if (auto* image = vtkImageData::SafeDownCast(whole))
  {
    this->SetImage(image);
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(whole))
  {
    this->SetRectilinearGrid(rectilinear);
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(whole))
  {
    this->SetStructuredGrid(structured);
  }
}

void Assembly::SetImage(vtkImageData* whole) const
{
  auto* first = vtkImageData::SafeDownCast(this->Pieces.front());
  Extent box = this->Points.Box;
  whole->SetExtent(box.data());
  whole->SetOrigin(first->GetOrigin());
  whole->SetSpacing(first->GetSpacing());
  whole->SetDirectionMatrix(first->GetDirectionMatrix());
}

void Assembly::SetRectilinearGrid(vtkRectilinearGrid* whole) const
{
  std::array<vtkSmartPointer<vtkDataArray>, 3> coordinates;
  for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
  {
    auto* grid = vtkRectilinearGrid::SafeDownCast(this->Pieces[piece]);
    vtkDataArray* own[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
      grid->GetZCoordinates() };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      CopyCoordinates(own[axis], this->Extents[piece][2 * axis], this->Points.Box[2 * axis],
        this->Points.Size(axis), coordinates[axis]);
    }
  }
  Extent box = this->Points.Box;
  whole->SetExtent(box.data());
  whole->SetXCoordinates(coordinates[0]);
  whole->SetYCoordinates(coordinates[1]);
  whole->SetZCoordinates(coordinates[2]);
}

void Assembly::SetStructuredGrid(vtkStructuredGrid* whole) const
{
  const int type = TypeOfCoordinates(this->Pieces.front());
  const bool isType = std::all_of(this->Pieces.begin(), this->Pieces.end(),
    [type](vtkDataSet* piece) { return TypeOfCoordinates(piece) == type; });
  vtkNew<vtkPoints> points;
  points->SetDataType(isType ? type : VTK_DOUBLE);
  points->SetNumberOfPoints(this->Points.Size());
  for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
  {
    points->InsertPoints(this->PointParts[piece].To, this->PointParts[piece].From,
      vtkStructuredGrid::SafeDownCast(this->Pieces[piece])->GetPoints());
  }
  Extent box = this->Points.Box;
  whole->SetExtent(box.data());
  whole->SetPoints(points);
}

void Assembly::CopyArrays(int association, vtkIdType size, vtkDataSet* whole) const
{
  vtkDataSetAttributes* first = this->Pieces.front()->GetAttributes(association);
  for (int k = 0; k < first->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* like = first->GetAbstractArray(k);
    if (!this->HaveAll(association, like))
    {
      continue;
    }
    const int index =
      whole->GetAttributes(association)->AddArray(this->ArrayOfAll(association, like, size));
    const int attribute = first->IsArrayAnAttribute(k);
    if (attribute >= 0)
    {
      whole->GetAttributes(association)->SetActiveAttribute(index, attribute);
    }
  }
}

bool Assembly::HaveAll(int association, vtkAbstractArray* like) const
{
  const char* name = like->GetName();
  return name &&
    std::all_of(this->Pieces.begin(), this->Pieces.end(),
      [association, name, like](vtkDataSet* piece)
      {
        vtkAbstractArray* array = piece->GetAttributes(association)->GetAbstractArray(name);
        return array && array->GetNumberOfComponents() == like->GetNumberOfComponents();
      });
}

vtkSmartPointer<vtkAbstractArray> Assembly::ArrayOfAll(
  int association, vtkAbstractArray* like, vtkIdType size) const
{
  const bool isOfPoints = association == vtkDataObject::POINT;
  auto array = vtk::TakeSmartPointer(like->NewInstance());
  array->SetName(like->GetName());
  array->SetNumberOfComponents(like->GetNumberOfComponents());
  array->CopyComponentNames(like);
  array->SetNumberOfTuples(size);
  for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
  {
    const Part& part = isOfPoints ? this->PointParts[piece] : this->CellParts[piece];
    vtkDataSetAttributes* from = this->Pieces[piece]->GetAttributes(association);
    array->InsertTuples(part.To, part.From, from->GetAbstractArray(like->GetName()));
  }
  return array;
}

} // namespace

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
  const Assembly assembly(pieces, extents);
  return assembly.HasGaps() ? nullptr : assembly.Whole();
}

} // namespace biting
