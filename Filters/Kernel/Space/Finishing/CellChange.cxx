// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CellChange.h"

#include <algorithm> // for any_of, copy, sort

namespace biting
{

namespace
{

std::array<Id, 3> Sorted(std::array<Id, 3> corners)
{
  std::sort(corners.begin(), corners.end());
  return corners;
}

} // namespace

void CellChange::Clear()
{
  this->Cells.clear();
  this->Filling.clear();
  this->Regions.clear();
  this->Facets.clear();
}

/// Facets of the cavity's border and of the filling that are the same are linked.
void CellChange::Apply(BodyTets& tets)
{
  const CellChange inverse = tets.Log != nullptr ? this->Inverse(tets) : CellChange();
  this->Sides.clear();
  this->Made.clear();
  ++tets.Clock;
  this->AddWalls(tets);
  for (const NewFacet& facet : this->Facets)
  {
    const std::array<Id, 3> corners = Sorted(facet.Corners);
    if (corners[0] != NoId)
    {
      this->Sides.push_back({ corners, NoId, facet.Record, NoId });
    }
    tets.FacetSlots[At(2 * facet.Record)] = NoId;
    tets.FacetSlots[At(2 * facet.Record + 1)] = NoId;
  }
  for (const Id cell : this->Cells)
  {
    tets.Mesh.FreeCell(cell);
  }
  this->AddFilling(tets);
  this->LinkSides(tets);
  if (tets.Log != nullptr)
  {
    tets.Log->push_back(inverse);
    tets.Log->back().Cells.assign(this->Made.rbegin(), this->Made.rend());
  }
}

/// But for its cells. In reverse order: new cells get the numbers that were freed last, so that all
/// get theirs back.
CellChange CellChange::Inverse(const BodyTets& tets) const
{
  CellChange inverse;
  for (auto cell = this->Cells.rbegin(); cell != this->Cells.rend(); ++cell)
  {
    inverse.Filling.push_back(tets.CornersOf(*cell));
    inverse.Regions.push_back(tets.Mesh.Labels[At(*cell)]);
  }
  for (const NewFacet& facet : this->Facets)
  {
    const Id slot = tets.FacetSlots[At(2 * facet.Record)];
    const bool isNew = slot == NoId;
    inverse.Facets.push_back(
      { facet.Record, isNew ? std::array<Id, 3>{ NoId, NoId, NoId } : tets.FacetCorners(slot) });
  }
  return inverse;
}

void CellChange::AddWalls(BodyTets& tets)
{
  ++tets.Stamp;
  for (const Id cell : this->Cells)
  {
    tets.Stamps[At(cell)] = tets.Stamp;
    for (const Id corner : tets.CornersOf(cell))
    {
      tets.Mesh.VertexCells[At(corner)] = NoId;
      tets.Touched[At(corner)] = tets.Clock;
    }
  }
  const auto isGiven = [this](Id record)
  {
    return std::any_of(this->Facets.begin(), this->Facets.end(),
      [record](const NewFacet& facet) { return facet.Record == record; });
  };
  for (const Id cell : this->Cells)
  {
    for (Id slot = 4 * cell; slot < 4 * cell + 4; ++slot)
    {
      const Id record = tets.RecordOf(slot);
      const Id twin = tets.Mesh.Twins[At(slot)];
      if (record >= 0 && !isGiven(record))
      {
        const Id half = tets.FacetSlots[At(2 * record)] == slot ? 0 : 1;
        this->Sides.push_back({ Sorted(tets.FacetCorners(slot)), NoId, record, half });
      }
      else if (record < 0 && tets.Stamps[At(TetMesh::CellOf(twin))] != tets.Stamp)
      {
        this->Sides.push_back({ Sorted(tets.FacetCorners(slot)), twin, NoId, NoId });
      }
    }
  }
  // Where a change is taken back whose last cell at a facet went, the cell beyond has that facet.
  for (const NewFacet& facet : this->Facets)
  {
    for (const std::size_t half : { 0, 1 })
    {
      const Id slot = tets.FacetSlots[At(2 * facet.Record) + half];
      if (slot != NoId && tets.Stamps[At(TetMesh::CellOf(slot))] != tets.Stamp)
      {
        this->Sides.push_back({ Sorted(tets.FacetCorners(slot)), slot, NoId, NoId });
      }
    }
  }
  for (const Side& side : this->Sides)
  {
    for (const Id corner : side.Corners)
    {
      tets.Touched[At(corner)] = tets.Clock;
      tets.Mesh.VertexCells[At(corner)] =
        side.Slot != NoId ? TetMesh::CellOf(side.Slot) : tets.Mesh.VertexCells[At(corner)];
    }
  }
}

void CellChange::AddFilling(BodyTets& tets)
{
  for (std::size_t k = 0; k < this->Filling.size(); ++k)
  {
    const BodyTets::Tetrahedron& corners = this->Filling[k];
    const Id cell = tets.Mesh.NewCell();
    tets.ResizeCells();
    tets.Tried[At(cell)] = 0;
    this->Made.push_back(cell);
    std::copy(corners.begin(), corners.end(), &tets.Mesh.Corners[At(4 * cell)]);
    tets.Mesh.Labels[At(cell)] = this->Regions[k];
    tets.Badness[At(cell)] = tets.BadnessOf(corners);
    for (Id slot = 4 * cell; slot < 4 * cell + 4; ++slot)
    {
      tets.Mesh.VertexCells[At(tets.VertexAt(slot))] = cell;
      this->Sides.push_back({ Sorted(tets.FacetCorners(slot)), slot, NoId, NoId });
    }
  }
}

void CellChange::LinkSides(BodyTets& tets)
{
  std::sort(this->Sides.begin(), this->Sides.end(),
    [](const Side& a, const Side& b)
    { return a.Corners != b.Corners ? a.Corners < b.Corners : a.Record > b.Record; });
  for (std::size_t k = 0; k < this->Sides.size(); ++k)
  {
    const Side& first = this->Sides[k];
    if (first.Record == NoId)
    {
      tets.Mesh.Link(first.Slot, this->Sides[++k].Slot);
      continue;
    }
    Id half = first.Half == NoId ? 0 : first.Half;
    while (k + 1 < this->Sides.size() && this->Sides[k + 1].Corners == first.Corners)
    {
      tets.Attach(first.Record, half++, this->Sides[++k].Slot);
    }
  }
}

} // namespace biting
