// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BodyTets.h"

#include <algorithm> // for sort, min, max
#include <utility>   // for move

namespace biting
{

BodyTets::BodyTets(RelaxedBody& body, Pulse& pulse)
  : Body(body)
  , NumberOfGiven(static_cast<Id>(body.Points.size()))
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
  this->NumberOfMoves.assign(this->Mesh.Points.size(), 0);
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
  this->NumberOfMoves.push_back(0);
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
  for (Id vertex = 0; vertex < this->Mesh.NumberOfVertices() && pulse.Beat(64); ++vertex)
  {
    this->LinkBucket(buckets[vertex]);
  }
  this->IsLinked = !pulse.HasStopped();
}

/// Records come first in a bucket.
void BodyTets::LinkBucket(const IdLists::List& items)
{
  const auto isOpen = [this](Id item) { return item < 0 || this->Mesh.Twins[At(item)] == NoId; };
  for (const Id* item = items.begin(); item < items.end(); ++item)
  {
    if (!isOpen(*item))
    {
      continue;
    }
    const std::array<Id, 3> corners = this->SortedCorners(*item);
    Id half = 0;
    for (const Id* other = item + 1; other < items.end() && half < 2; ++other)
    {
      if (*other < 0 || !isOpen(*other) || this->SortedCorners(*other) != corners)
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
  }
}

std::array<Id, 3> BodyTets::SortedCorners(Id item) const
{
  const Id* facet = item < 0 ? &this->Body.Facets[At(3 * (-2 - item))] : nullptr;
  std::array<Id, 3> corners =
    facet == nullptr ? this->FacetCorners(item) : std::array<Id, 3>{ facet[0], facet[1], facet[2] };
  std::sort(corners.begin(), corners.end());
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
  std::size_t next = 0;
  while (next < this->Star.size())
  {
    const Id own = this->Star[next++];
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

/// Takes vertices inside away that no cell has. The new numbers of the others.
std::vector<Id> BodyTets::DropUnused()
{
  std::vector<Id> numbers(this->Mesh.Points.size(), NoId);
  this->Body.Origins.clear();
  for (Id vertex = 0; vertex < this->Mesh.NumberOfVertices(); ++vertex)
  {
    if (vertex < this->Body.NumberOnBoundary || !this->IsLinked ||
      this->Mesh.VertexCells[At(vertex)] != NoId)
    {
      numbers[At(vertex)] = static_cast<Id>(this->Body.Origins.size());
      this->Mesh.Points[this->Body.Origins.size()] = this->Mesh.PointAt(vertex);
      this->Body.Sizes[this->Body.Origins.size()] = this->Body.Sizes[At(vertex)];
      this->Body.Origins.push_back(vertex < this->NumberOfGiven ? vertex : NoId);
    }
  }
  this->Mesh.Points.resize(this->Body.Origins.size());
  this->Body.Sizes.resize(this->Body.Origins.size());
  return numbers;
}

void BodyTets::GiveBack()
{
  const std::vector<Id> numbers = this->DropUnused();
  for (std::size_t record = 0; this->IsLinked && record < this->Body.FacetTags.size(); ++record)
  {
    const Id* halves = &this->FacetSlots[2 * record];
    const auto regionOf = [this](Id slot) { return this->Mesh.Labels[At(slot >> 2)]; };
    const bool isSecond = halves[1] != NoId && regionOf(halves[1]) < regionOf(halves[0]);
    const std::array<Id, 3> corners = this->FacetCorners(halves[isSecond ? 1 : 0]);
    std::copy(corners.begin(), corners.end(), &this->Body.Facets[3 * record]);
  }
  std::size_t kept = 0;
  for (Id cell = 0; cell < this->Mesh.NumberOfSlots(); ++cell)
  {
    if (!this->Mesh.IsFree(cell))
    {
      for (std::size_t k = 0; k < 4; ++k)
      {
        const Id corner = this->Mesh.Corners[At(4 * cell) + k];
        this->Mesh.Corners[4 * kept + k] = numbers[At(corner)];
      }
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
