// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BodyTets.h"

#include <algorithm> // for copy, fill_n, sort
#include <utility>   // for move

namespace biting
{

BodyTets::BodyTets(RelaxedBody& body, Pulse& pulse)
  : Body(body)
  , Lines(body)
  , Kinds(body.Points.size(), Kind::Inside)
  , NumberOfGiven(static_cast<Id>(body.Points.size()))
  , FacetSlots(2 * body.FacetPlaces.size(), NoId)
{
  this->Mesh.Points = std::move(body.Points);
  this->Mesh.Corners = std::move(body.Corners);
  this->Mesh.Labels = std::move(body.Regions);
  this->Mesh.Twins = std::move(body.Twins);
  this->Mesh.VertexCells.assign(this->Mesh.Points.size(), NoId);
  std::fill_n(this->Kinds.begin(), body.NumberOnBoundary, Kind::OnPatch);
  std::fill_n(this->Kinds.begin(), body.NumberOnLines, Kind::OnLine);
  this->Touched.assign(this->Mesh.Points.size(), 0);
  this->TriedMoves.assign(this->Mesh.Points.size(), 0);
  this->NumberOfMoves.assign(this->Mesh.Points.size(), 0);
  this->ResizeCells();
  std::vector<std::size_t> counts(this->Mesh.Points.size(), 0); // of cells
  for (Id cell = 0; cell < this->Mesh.NumberOfSlots(); ++cell)
  {
    const Tetrahedron corners = this->CornersOf(cell);
    this->Badness[At(cell)] = this->BadnessOf(corners);
    for (Id slot = 4 * cell; slot < 4 * cell + 4; ++slot)
    {
      this->Mesh.VertexCells[At(this->VertexAt(slot))] = cell;
      ++counts[At(this->VertexAt(slot))];
      const Id record = this->RecordOf(slot);
      if (record >= 0)
      {
        this->FacetSlots[At(2 * record + (this->FacetSlots[At(2 * record)] == NoId ? 0 : 1))] =
          slot;
      }
    }
    pulse.Beat(1);
  }
  // Bodies that touch along a line have stars of several parts there, of which StarOf knows one.
  for (Id vertex = 0; vertex < body.NumberOnLines; ++vertex)
  {
    if (this->StarOf(vertex).size() != counts[At(vertex)])
    {
      this->Lines.Fix(vertex);
    }
  }
}

Id BodyTets::AddVertex()
{
  this->Kinds.push_back(Kind::Inside);
  this->Mesh.Points.emplace_back();
  this->Mesh.VertexCells.push_back(NoId);
  this->Body.Sizes.push_back(0.0);
  this->Touched.push_back(0);
  this->TriedMoves.push_back(0);
  this->NumberOfMoves.push_back(0);
  return this->Mesh.NumberOfVertices() - 1;
}

Id BodyTets::AddRecord(Id other)
{
  this->Body.FacetPlaces.push_back(this->Body.FacetPlaces[At(other)]);
  this->FacetSlots.resize(this->FacetSlots.size() + 2, NoId);
  return static_cast<Id>(this->Body.FacetPlaces.size()) - 1;
}

void BodyTets::ResizeCells()
{
  const std::size_t count = At(this->Mesh.NumberOfSlots());
  this->Badness.resize(count);
  this->Tried.resize(count, 0);
  this->Stamps.resize(count, 0);
}

void BodyTets::Attach(Id record, Id half, Id slot)
{
  this->FacetSlots[At(2 * record + half)] = slot;
  this->Mesh.Twins[At(slot)] = RelaxedBody::CodeOf(record);
}

Id BodyTets::Across(Id slot) const
{
  const Id twin = this->Mesh.Twins[At(slot)];
  if (twin >= 0)
  {
    return twin;
  }
  const Id* halves = &this->FacetSlots[At(2 * this->RecordOf(slot))];
  return halves[0] == slot ? halves[1] : halves[0];
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
      this->Star.push_back(this->SlotOf(cell, vertex));
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

std::vector<Id> BodyTets::FacetsAt(Id vertex)
{
  std::vector<Id> slots;
  for (const Id own : this->StarOf(vertex))
  {
    for (Id slot = own & ~3; slot < (own & ~3) + 4; ++slot)
    {
      const Id record = slot == own ? NoId : this->RecordOf(slot);
      if (record >= 0 && this->FacetSlots[At(2 * record)] == slot)
      {
        slots.push_back(slot);
      }
    }
  }
  return slots;
}

/// Takes vertices away that no cell has, and sorts the others by kind. Their new numbers.
std::vector<Id> BodyTets::DropUnused()
{
  std::vector<Id> numbers(this->Mesh.Points.size(), NoId);
  std::vector<Id>& order = this->Body.Origins;
  order.clear();
  for (const Kind kind : { Kind::OnLine, Kind::OnPatch, Kind::Inside })
  {
    for (Id vertex = 0; vertex < this->Mesh.NumberOfVertices(); ++vertex)
    {
      if (this->Kinds[At(vertex)] == kind && this->Mesh.VertexCells[At(vertex)] != NoId)
      {
        numbers[At(vertex)] = static_cast<Id>(order.size());
        order.push_back(vertex);
      }
    }
    const auto count = static_cast<Id>(order.size());
    this->Body.NumberOnLines = kind == Kind::OnLine ? count : this->Body.NumberOnLines;
    this->Body.NumberOnBoundary = kind == Kind::OnPatch ? count : this->Body.NumberOnBoundary;
  }
  const auto sort = [&order](auto& list)
  {
    const auto given = std::move(list);
    list.clear();
    list.reserve(order.size());
    for (const Id vertex : order)
    {
      list.push_back(given[At(vertex)]);
    }
  };
  sort(this->Mesh.Points);
  sort(this->Body.Sizes);
  this->Body.BoundaryPlaces.resize(numbers.size(), NoId);
  sort(this->Body.BoundaryPlaces);
  this->Body.BoundaryPlaces.resize(At(this->Body.NumberOnBoundary));
  for (Id& vertex : order)
  {
    vertex = vertex < this->NumberOfGiven ? vertex : NoId;
  }
  return numbers;
}

/// Facets that are gone leave the list. The new numbers of records.
std::vector<Id> BodyTets::GiveBackFacets()
{
  std::size_t kept = 0;
  std::vector<Id> numbers(this->Body.FacetPlaces.size(), NoId);
  this->Body.Facets.resize(3 * this->Body.FacetPlaces.size());
  for (std::size_t record = 0; record < this->Body.FacetPlaces.size(); ++record)
  {
    const Id* halves = &this->FacetSlots[2 * record];
    if (halves[0] != NoId)
    {
      const auto regionOf = [this](Id slot) { return this->Mesh.Labels[At(slot >> 2)]; };
      const bool isSecond = halves[1] != NoId && regionOf(halves[1]) < regionOf(halves[0]);
      const std::array<Id, 3> corners = this->FacetCorners(halves[isSecond ? 1 : 0]);
      std::copy(corners.begin(), corners.end(), &this->Body.Facets[3 * kept]);
      numbers[record] = static_cast<Id>(kept);
      this->Body.FacetPlaces[kept++] = this->Body.FacetPlaces[record];
    }
  }
  this->Body.Facets.resize(3 * kept);
  this->Body.FacetPlaces.resize(kept);
  return numbers;
}

void BodyTets::GiveBack()
{
  std::vector<double>().swap(this->Badness);
  std::vector<std::uint32_t>().swap(this->Stamps);
  const std::vector<Id> records = this->GiveBackFacets();
  const std::vector<Id> numbers = this->DropUnused();
  this->Lines.GiveBack(numbers);
  for (Id& corner : this->Body.Facets)
  {
    corner = numbers[At(corner)];
  }
  this->DropFree(numbers, records);
  this->Body.Points = std::move(this->Mesh.Points);
  this->Body.Corners = std::move(this->Mesh.Corners);
  this->Body.Twins = std::move(this->Mesh.Twins);
  this->Body.Regions = std::move(this->Mesh.Labels);
}

/// Takes free cells away. `numbers`, `records`: of vertices and of records, the new ones.
void BodyTets::DropFree(const std::vector<Id>& numbers, const std::vector<Id>& records)
{
  Id kept = 0;
  std::vector<Id> places(At(this->Mesh.NumberOfSlots()), NoId);
  for (Id cell = 0; cell < this->Mesh.NumberOfSlots(); ++cell)
  {
    places[At(cell)] = this->Mesh.IsFree(cell) ? NoId : kept++;
  }
  for (Id slot = 0; slot < 4 * this->Mesh.NumberOfSlots(); ++slot)
  {
    const Id place = places[At(slot >> 2)];
    if (place != NoId)
    {
      const Id twin = this->Mesh.Twins[At(slot)];
      const Id to = 4 * place + (slot & 3);
      this->Mesh.Corners[At(to)] = numbers[At(this->VertexAt(slot))];
      this->Mesh.Twins[At(to)] = twin < 0 ? RelaxedBody::CodeOf(records[At(this->RecordOf(slot))])
                                          : 4 * places[At(twin >> 2)] + (twin & 3);
      this->Mesh.Labels[At(place)] = this->Mesh.Labels[At(slot >> 2)];
    }
  }
  this->Mesh.Corners.resize(4 * At(kept));
  this->Mesh.Twins.resize(4 * At(kept));
  this->Mesh.Labels.resize(At(kept));
}

} // namespace biting
