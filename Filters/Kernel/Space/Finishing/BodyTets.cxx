// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BodyTets.h"

#include <algorithm> // for copy, find, max, min, sort
#include <utility>   // for move

namespace biting
{

BodyTets::BodyTets(RelaxedBody& body, Pulse& pulse)
  : Body(body)
  , NumberOfGiven(static_cast<Id>(body.Points.size()))
  , FacetSlots(2 * body.FacetTags.size(), NoId)
  , KeptEnds(At(body.NumberOnLines),
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
  this->Mesh.Twins = std::move(body.Twins);
  this->Mesh.VertexCells.assign(this->Mesh.Points.size(), NoId);
  this->Touched.assign(this->Mesh.Points.size(), 0);
  this->TriedMoves.assign(this->Mesh.Points.size(), 0);
  this->NumberOfMoves.assign(this->Mesh.Points.size(), 0);
  this->ResizeCells();
  for (Id cell = 0; cell < this->Mesh.NumberOfSlots(); ++cell)
  {
    const Tetrahedron corners = this->CornersOf(cell);
    this->Badness[At(cell)] = this->BadnessOf(corners);
    for (Id slot = 4 * cell; slot < 4 * cell + 4; ++slot)
    {
      this->Mesh.VertexCells[At(this->VertexAt(slot))] = cell;
      const Id record = this->RecordOf(slot);
      if (record >= 0)
      {
        this->FacetSlots[At(2 * record + (this->FacetSlots[At(2 * record)] == NoId ? 0 : 1))] =
          slot;
      }
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

std::array<Id, 3> BodyTets::SortedCorners(Id slot) const
{
  std::array<Id, 3> corners = this->FacetCorners(slot);
  std::sort(corners.begin(), corners.end());
  return corners;
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
    if (vertex < this->Body.NumberOnBoundary || this->Mesh.VertexCells[At(vertex)] != NoId)
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
  for (std::size_t record = 0; record < this->Body.FacetTags.size(); ++record)
  {
    const Id* halves = &this->FacetSlots[2 * record];
    const auto regionOf = [this](Id slot) { return this->Mesh.Labels[At(slot >> 2)]; };
    const bool isSecond = halves[1] != NoId && regionOf(halves[1]) < regionOf(halves[0]);
    const std::array<Id, 3> corners = this->FacetCorners(halves[isSecond ? 1 : 0]);
    std::copy(corners.begin(), corners.end(), &this->Body.Facets[3 * record]);
  }
  this->DropFree(numbers);
  this->Body.Points = std::move(this->Mesh.Points);
  this->Body.Corners = std::move(this->Mesh.Corners);
  this->Body.Twins = std::move(this->Mesh.Twins);
  this->Body.Regions = std::move(this->Mesh.Labels);
}

/// Takes free cells away. `numbers`: of vertices, the new ones.
void BodyTets::DropFree(const std::vector<Id>& numbers)
{
  std::vector<double>().swap(this->Badness);
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
      this->Mesh.Twins[At(to)] = twin < 0 ? twin : 4 * places[At(twin >> 2)] + (twin & 3);
      this->Mesh.Labels[At(place)] = this->Mesh.Labels[At(slot >> 2)];
    }
  }
  this->Mesh.Corners.resize(4 * At(kept));
  this->Mesh.Twins.resize(4 * At(kept));
  this->Mesh.Labels.resize(At(kept));
}

} // namespace biting
