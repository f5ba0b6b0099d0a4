// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BodyTets.h"

#include <algorithm> // for sort, min, max
#include <utility>   // for move

namespace biting
{

namespace
{

void SortThree(std::array<Id, 3>& c)
{
  if (c[1] < c[0])
  {
    std::swap(c[0], c[1]);
  }
  if (c[2] < c[1])
  {
    std::swap(c[1], c[2]);
  }
  if (c[1] < c[0])
  {
    std::swap(c[0], c[1]);
  }
}

} // namespace

void BodyTets::Change::Clear()
{
  this->Cells.clear();
  this->Filling.clear();
  this->Regions.clear();
  this->Facets.clear();
}

BodyTets::BodyTets(RelaxedBody& body, Pulse& pulse)
  : Body(body)
  , FacetSlots(2 * body.FacetTags.size(), NoId)
  , KeptEnds(body.Points.size(),
      [&body](const auto& add)
      {
        for (std::size_t k = 0; k < body.PieceEnds.size(); k += 2)
        {
          add(std::min(body.PieceEnds[k], body.PieceEnds[k + 1]),
            std::max(body.PieceEnds[k], body.PieceEnds[k + 1]));
        }
      })
{
  this->Mesh.Points = std::move(body.Points);
  this->Mesh.Corners = std::move(body.Corners);
  this->Mesh.Labels = std::move(body.Regions);
  this->Mesh.Twins.assign(this->Mesh.Corners.size(), NoId);
  this->Mesh.VertexCells.assign(this->Mesh.Points.size(), NoId);
  this->LinkAll(pulse);
  this->Touched.assign(this->Mesh.Points.size(), 0);
  this->TriedMoves.assign(this->Mesh.Points.size(), 0);
  this->ResizeCells();
  for (Id cell = 0; cell < this->Mesh.NumberOfSlots(); ++cell)
  {
    const Tetrahedron corners = this->CornersOf(cell);
    this->Badness[At(cell)] = this->BadnessOf(corners);
    for (const Id vertex : corners)
    {
      this->Mesh.VertexCells[At(vertex)] = cell;
    }
    pulse.Beat(1);
  }
}

Id BodyTets::AddVertex(const Point3& place, double size)
{
  this->Mesh.Points.push_back(place);
  this->Mesh.VertexCells.push_back(NoId);
  this->Body.Sizes.push_back(size);
  this->Touched.push_back(0);
  this->TriedMoves.push_back(0);
  return this->Mesh.NumberOfVertices() - 1;
}

void BodyTets::ResizeCells()
{
  const std::size_t count = At(this->Mesh.NumberOfSlots());
  this->Badness.resize(count);
  this->Tried.resize(count, 0);
  this->Stamps.resize(count, 0);
}

/// Facets with the same lowest vertex are found together: slots, and codes of records.
void BodyTets::LinkAll(Pulse& pulse)
{
  const IdLists buckets(this->Mesh.Points.size(),
    [this](const auto& add)
    {
      for (Id record = 0; record < static_cast<Id>(this->Body.FacetTags.size()); ++record)
      {
        add(this->SortedCorners(CodeOf(record))[0], CodeOf(record));
      }
      for (Id slot = 0; slot < 4 * this->Mesh.NumberOfSlots(); ++slot)
      {
        add(this->SortedCorners(slot)[0], slot);
      }
    });
  for (Id vertex = 0; vertex < this->Mesh.NumberOfVertices(); ++vertex)
  {
    this->LinkBucket(buckets[vertex]);
    pulse.Beat();
  }
}

/// Records come first in a bucket. A facet of one tetrahedron without a record gets one, of no patch.
void BodyTets::LinkBucket(const IdLists::List& items)
{
  for (const Id* item = items.begin(); item < items.end(); ++item)
  {
    if (!this->IsOpen(*item))
    {
      continue;
    }
    const std::array<Id, 3> corners = this->SortedCorners(*item);
    Id half = 0;
    for (const Id* other = item + 1; other < items.end() && half < 2; ++other)
    {
      if (*other < 0 || !this->IsOpen(*other) || this->SortedCorners(*other) != corners)
      {
        continue;
      }
      if (*item < 0)
      {
        this->Attach(-2 - *item, half++, *other);
      }
      else
      {
        this->Mesh.Link(*item, *other);
        half = 2;
      }
    }
    if (*item >= 0 && half == 0)
    {
      this->FacetSlots.insert(this->FacetSlots.end(), 2, NoId);
      this->Body.Facets.insert(this->Body.Facets.end(), corners.begin(), corners.end());
      this->Body.FacetTags.push_back(NoId);
      this->Attach(static_cast<Id>(this->Body.FacetTags.size()) - 1, 0, *item);
    }
  }
}

std::array<Id, 3> BodyTets::SortedCorners(Id item) const
{
  const Id* facet = item < 0 ? &this->Body.Facets[At(3 * (-2 - item))] : nullptr;
  std::array<Id, 3> corners =
    facet == nullptr ? this->FacetCorners(item) : std::array<Id, 3>{ facet[0], facet[1], facet[2] };
  SortThree(corners);
  return corners;
}

void BodyTets::Attach(Id record, Id half, Id slot)
{
  this->FacetSlots[At(2 * record + half)] = slot;
  this->Mesh.Twins[At(slot)] = CodeOf(record);
}

Id BodyTets::Across(Id slot) const
{
  const Id twin = this->Mesh.Twins[At(slot)];
  if (twin >= 0)
  {
    return twin;
  }
  const Id* halves = &this->FacetSlots[At(2 * (-2 - twin))];
  return halves[0] == slot ? halves[1] : halves[0];
}

bool BodyTets::IsKept(Id a, Id b) const
{
  if (std::max(a, b) >= this->Body.NumberOnLines)
  {
    return false;
  }
  const IdLists::List ends = this->KeptEnds[std::min(a, b)];
  return std::find(ends.begin(), ends.end(), std::max(a, b)) != ends.end();
}

const std::vector<Id>& BodyTets::StarOf(Id vertex)
{
  this->Star.clear();
  ++this->Stamp;
  const auto add = [this, vertex](Id cell)
  {
    if (this->Stamps[At(cell)] != this->Stamp)
    {
      this->Stamps[At(cell)] = this->Stamp;
      Id slot = 4 * cell;
      while (this->VertexAt(slot) != vertex)
      {
        ++slot;
      }
      this->Star.push_back(slot);
    }
  };
  if (this->Mesh.VertexCells[At(vertex)] != NoId)
  {
    add(this->Mesh.VertexCells[At(vertex)]);
  }
  for (std::size_t k = 0; k < this->Star.size(); ++k)
  {
    const Id own = this->Star[k];
    for (Id slot = own & ~3; slot < (own & ~3) + 4; ++slot)
    {
      const Id across = slot == own ? NoId : this->Across(slot);
      if (across != NoId)
      {
        add(TetMesh::CellOf(across));
      }
    }
  }
  return this->Star;
}

/// Facets of the cavity's border and of the filling that are the same are linked.
void BodyTets::Apply(const Change& change)
{
  this->Sides.clear();
  ++this->Clock;
  this->AddWalls(change);
  for (const NewFacet& facet : change.Facets)
  {
    std::array<Id, 3> corners = facet.Corners;
    SortThree(corners);
    this->Sides.push_back({ corners, NoId, facet.Record, NoId });
    this->FacetSlots[At(2 * facet.Record)] = NoId;
    this->FacetSlots[At(2 * facet.Record + 1)] = NoId;
  }
  for (const Id cell : change.Cells)
  {
    this->Mesh.FreeCell(cell);
  }
  this->AddFilling(change);
  this->LinkSides();
}

void BodyTets::AddWalls(const Change& change)
{
  ++this->Stamp;
  for (const Id cell : change.Cells)
  {
    this->Stamps[At(cell)] = this->Stamp;
    for (const Id corner : this->CornersOf(cell))
    {
      this->Mesh.VertexCells[At(corner)] = NoId;
      this->Touched[At(corner)] = this->Clock;
    }
  }
  const auto isGiven = [&change](Id record)
  {
    return std::any_of(change.Facets.begin(), change.Facets.end(),
      [record](const NewFacet& facet) { return facet.Record == record; });
  };
  for (const Id cell : change.Cells)
  {
    for (Id slot = 4 * cell; slot < 4 * cell + 4; ++slot)
    {
      const Id record = this->RecordOf(slot);
      const Id twin = this->Mesh.Twins[At(slot)];
      if (record >= 0 && !isGiven(record))
      {
        const Id half = this->FacetSlots[At(2 * record)] == slot ? 0 : 1;
        this->Sides.push_back({ this->SortedCorners(slot), NoId, record, half });
      }
      else if (record < 0 && this->Stamps[At(TetMesh::CellOf(twin))] != this->Stamp)
      {
        this->Sides.push_back({ this->SortedCorners(slot), twin, NoId, NoId });
      }
    }
  }
  for (const Side& side : this->Sides)
  {
    for (const Id corner : side.Corners)
    {
      this->Mesh.VertexCells[At(corner)] =
        side.Slot != NoId ? TetMesh::CellOf(side.Slot) : this->Mesh.VertexCells[At(corner)];
    }
  }
}

void BodyTets::AddFilling(const Change& change)
{
  for (std::size_t k = 0; k < change.Filling.size(); ++k)
  {
    const Tetrahedron& corners = change.Filling[k];
    const Id cell = this->Mesh.NewCell();
    this->ResizeCells();
    this->Tried[At(cell)] = 0;
    std::copy(corners.begin(), corners.end(), &this->Mesh.Corners[At(4 * cell)]);
    this->Mesh.Labels[At(cell)] = change.Regions[k];
    this->Badness[At(cell)] = this->BadnessOf(corners);
    for (Id slot = 4 * cell; slot < 4 * cell + 4; ++slot)
    {
      this->Mesh.VertexCells[At(this->VertexAt(slot))] = cell;
      this->Sides.push_back({ this->SortedCorners(slot), slot, NoId, NoId });
    }
  }
}

void BodyTets::LinkSides()
{
  std::sort(this->Sides.begin(), this->Sides.end(),
    [](const Side& a, const Side& b)
    { return a.Corners != b.Corners ? a.Corners < b.Corners : a.Record > b.Record; });
  for (std::size_t k = 0; k < this->Sides.size(); ++k)
  {
    const Side& first = this->Sides[k];
    if (first.Record == NoId)
    {
      this->Mesh.Link(first.Slot, this->Sides[++k].Slot);
      continue;
    }
    Id half = first.Half == NoId ? 0 : first.Half;
    while (k + 1 < this->Sides.size() && this->Sides[k + 1].Corners == first.Corners)
    {
      this->Attach(first.Record, half++, this->Sides[++k].Slot);
    }
  }
}

void BodyTets::GiveBack()
{
  for (std::size_t record = 0; record < this->Body.FacetTags.size(); ++record)
  {
    Id* halves = &this->FacetSlots[2 * record];
    const auto regionOf = [this](Id slot) { return this->Mesh.Labels[At(slot >> 2)]; };
    const bool isSecond = halves[1] != NoId && regionOf(halves[1]) < regionOf(halves[0]);
    for (int k = 0; k < 3; ++k)
    {
      this->Body.Facets[3 * record + static_cast<std::size_t>(k)] =
        this->Mesh.FacetCorner(halves[isSecond ? 1 : 0], k);
    }
  }
  std::size_t kept = 0;
  for (Id cell = 0; cell < this->Mesh.NumberOfSlots(); ++cell)
  {
    if (!this->Mesh.IsFree(cell))
    {
      std::copy_n(&this->Mesh.Corners[At(4 * cell)], 4, &this->Mesh.Corners[4 * kept]);
      this->Mesh.Labels[kept++] = this->Mesh.Labels[At(cell)];
    }
  }
  this->Mesh.Corners.resize(4 * kept);
  this->Mesh.Labels.resize(kept);
  this->Body.Points = std::move(this->Mesh.Points);
  this->Body.Corners = std::move(this->Mesh.Corners);
  this->Body.Regions = std::move(this->Mesh.Labels);
}

} // namespace biting
