// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "KeptVertices.h"

#include <algorithm> // for all_of, max, min, sort
#include <cstddef>   // for sizes
#include <utility>   // for pairs

namespace biting
{

namespace
{

// Acceptance radius in units of f, measured: what is left of a finer mesh has the best shapes.
constexpr double RadiusOfCrowded = 0.9;

// How far from where an old lattice ends its rest may go, in vertices: measured, more gain little.
constexpr int RoundsAlongBorders = 2;

class Front
{
public:
  Front(const OldMesh& mesh, const ChangedRegion& region, const RegionEdges& edges,
    const std::vector<double>& spacings, const KeepRules& rules)
    : Mesh(mesh)
    , Region(region)
    , Spacings(spacings)
    , Rules(rules)
    , IsKept(edges.IsKept)
    , IsHeld(edges.IsGone)
    , Stamps(region.Vertices.size(), NoId)
  {
  }

  std::vector<std::uint8_t> Run()
  {
    const Id count = this->Region.NumberOfVertices();
    this->DropThoseInTheWay();
    for (int round = 0; round < RoundsAlongBorders; ++round)
    {
      this->DropAlongBorders();
    }
    for (Id vertex = 0; vertex < count; ++vertex)
    {
      if (this->IsKept[vertex])
      {
        this->Bite(vertex);
      }
    }
    this->Empty();
    for (Id vertex = 0; vertex < count; ++vertex)
    {
      this->Queue.push_back(vertex);
      this->Empty();
    }
    return std::move(this->IsKept);
  }

private:
  void DropThoseInTheWay();
  void DropAlongBorders();
  double ChangeAround(Id vertex) const;
  bool MayBeDivided(Id vertex) const;
  double LengthBetween(Id one, Id other) const;
  double ShareInTheWay(Id vertex) const;
  void Empty();
  void Bite(Id vertex);
  void LookAt(Id vertex, Id near);

  const OldMesh& Mesh;
  const ChangedRegion& Region;
  const std::vector<double>& Spacings;
  const KeepRules& Rules;
  std::vector<std::uint8_t> IsKept;
  std::vector<std::uint8_t> IsHeld;
  std::vector<Id> Stamps;                    ///< the last bite that looked at the vertex
  std::vector<Id> Held;                      ///< by the bite at hand
  std::vector<std::pair<double, Id>> Beyond; ///< the bite at hand: distances in units of f
  std::vector<Id> Queue;
  std::size_t NextInQueue = 0;
};

void Front::DropThoseInTheWay()
{
  for (Id vertex = 0; vertex < this->Region.NumberOfVertices(); ++vertex)
  {
    this->IsKept[vertex] |= !this->Region.IsInside[vertex];
    this->IsHeld[vertex] |= !this->IsKept[vertex] &&
      this->Rules.IsInTheWay(
        this->Region.Lengths[vertex], this->ChangeAround(vertex), this->MayBeDivided(vertex));
  }
}

// All at once: the order of vertices does not matter.
void Front::DropAlongBorders()
{
  std::vector<Id> dropped;
  for (Id vertex = 0; vertex < this->Region.NumberOfVertices(); ++vertex)
  {
    if (!this->IsKept[vertex] && !this->IsHeld[vertex] &&
      this->ShareInTheWay(vertex) > this->Rules.GreatestShareInTheWay)
    {
      dropped.push_back(vertex);
    }
  }
  for (const Id vertex : dropped)
  {
    this->IsHeld[vertex] = 1;
  }
}

double Front::ShareInTheWay(Id vertex) const
{
  const Id first = this->Region.Offsets[vertex];
  const Id end = this->Region.Offsets[vertex + 1];
  Id count = 0;
  for (Id n = first; n < end; ++n)
  {
    count += this->IsHeld[this->Region.Neighbors[n]];
  }
  return static_cast<double>(count) / static_cast<double>(end - first);
}

// The largest f of the vertex and its neighbors in units of the least.
double Front::ChangeAround(Id vertex) const
{
  double least = this->Spacings[vertex];
  double greatest = least;
  for (Id n = this->Region.Offsets[vertex]; n < this->Region.Offsets[vertex + 1]; ++n)
  {
    const double near = this->Spacings[this->Region.Neighbors[n]];
    least = std::min(least, near);
    greatest = std::max(greatest, near);
  }
  return greatest / least;
}

bool Front::MayBeDivided(Id vertex) const
{
  const Id first = this->Region.Offsets[vertex];
  const Id end = this->Region.Offsets[vertex + 1];
  return std::all_of(this->Region.Neighbors.begin() + first, this->Region.Neighbors.begin() + end,
    [this, vertex](Id near)
    {
      const double half = 0.5 * this->LengthBetween(vertex, near);
      return KeepRules::IsGoodHalf(half * half);
    });
}

// In units of the mean f of the two.
double Front::LengthBetween(Id one, Id other) const
{
  return 2.0 *
    Distance(this->Mesh.Points[this->Region.Vertices[one]],
      this->Mesh.Points[this->Region.Vertices[other]]) /
    (this->Spacings[one] + this->Spacings[other]);
}

void Front::Empty()
{
  while (this->NextInQueue < this->Queue.size())
  {
    const Id vertex = this->Queue[this->NextInQueue++];
    if (!this->IsKept[vertex] && !this->IsHeld[vertex])
    {
      this->IsKept[vertex] = 1;
      this->Bite(vertex);
    }
  }
}

void Front::Bite(Id vertex)
{
  this->Held.assign(1, vertex);
  this->Beyond.clear();
  this->Stamps[vertex] = vertex;
  std::size_t next = 0;
  while (next < this->Held.size())
  {
    const Id held = this->Held[next++];
    for (Id n = this->Region.Offsets[held]; n < this->Region.Offsets[held + 1]; ++n)
    {
      const Id near = this->Region.Neighbors[n];
      if (this->Stamps[near] != vertex)
      {
        this->Stamps[near] = vertex;
        this->LookAt(vertex, near);
      }
    }
  }
  std::sort(this->Beyond.begin(), this->Beyond.end());
  for (const auto& [distance, beyond] : this->Beyond)
  {
    this->Queue.push_back(beyond);
  }
}

void Front::LookAt(Id vertex, Id near)
{
  const double distance = this->LengthBetween(vertex, near);
  const bool isCrowded = this->Region.Lengths[near] < this->Rules.Lowest;
  if (distance < (isCrowded ? RadiusOfCrowded : KeepRules::RadiusOfFitting))
  {
    this->IsHeld[near] = 1;
    this->Held.push_back(near);
  }
  else if (!this->IsKept[near] && !this->IsHeld[near])
  {
    this->Beyond.emplace_back(distance, near);
  }
}

} // namespace

std::vector<std::uint8_t> ChooseKeptVertices(const OldMesh& mesh, const ChangedRegion& region,
  const RegionEdges& edges, const std::vector<double>& spacings, const KeepRules& rules)
{
  return Front(mesh, region, edges, spacings, rules).Run();
}

} // namespace biting
