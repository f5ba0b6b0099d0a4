// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "StructuredFromPieces.h"

#include "../Data/DoubleArray.h"
#include "../Data/GhostArrays.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm> // for all_of, any_of, equal, max, min

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
  std::vector<Origin>& origins = this->Origins[static_cast<std::size_t>(association)];
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
  vtkUnsignedCharArray* ghosts = association == vtkDataObject::CELL
    ? GhostsOf(this->Pieces[static_cast<std::size_t>(piece)], association)
    : nullptr;
  std::vector<Origin>& origins = this->Origins[static_cast<std::size_t>(association)];
  vtkIdType from = 0;
  for (int k = part.Box[4]; k <= part.Box[5]; ++k)
  {
    for (int j = part.Box[2]; j <= part.Box[3]; ++j)
    {
      for (int i = part.Box[0]; i <= part.Box[1]; ++i, ++from)
      {
        Origin& origin = origins[static_cast<std::size_t>(whole.NumberOf(i, j, k))];
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
    coordinates->InsertNextValue(
      this->Pieces[static_cast<std::size_t>(origin.Piece)]->GetPoint(origin.Number)[axis]);
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
    points->InsertNextPoint(
      this->Pieces[static_cast<std::size_t>(origin.Piece)]->GetPoint(origin.Number));
  }
  return points;
}

// Those that all pieces have.
void Assembly::CopyArrays(int association, vtkDataSet* whole) const
{
  const std::vector<Origin>& origins = this->Origins[static_cast<std::size_t>(association)];
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
    common.CopyData(origin.Piece,
      this->Pieces[static_cast<std::size_t>(origin.Piece)]->GetAttributes(association),
      origin.Number, attributes, to++);
  }
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
  Assembly assembly(pieces, extents);
  return assembly.HasGaps() ? nullptr : assembly.Whole();
}

} // namespace biting
