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
  void DropThoseInTheWay()
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
  void DropAlongBorders()
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

  // The largest f of the vertex and its neighbors in units of the least.
  double ChangeAround(Id vertex) const
  {
    double least = this->Spacings[vertex];
    double greatest = least;
    for (const Id near : this->Region.Neighbors[vertex])
    {
      least = std::min(least, this->Spacings[near]);
      greatest = std::max(greatest, this->Spacings[near]);
    }
    return greatest / least;
  }

  bool MayBeDivided(Id vertex) const
  {
    const IdLists::List neighbors = this->Region.Neighbors[vertex];
    return std::all_of(neighbors.begin(), neighbors.end(),
      [this, vertex](Id near)
      {
        const double half = 0.5 * this->LengthBetween(vertex, near);
        return KeepRules::IsGoodHalf(half * half);
      });
  }

  // In units of the mean f of the two.
  double LengthBetween(Id one, Id other) const
  {
    return 2.0 *
      Distance(this->Mesh.Points[this->Region.Vertices[one]],
        this->Mesh.Points[this->Region.Vertices[other]]) /
      (this->Spacings[one] + this->Spacings[other]);
  }

  double ShareInTheWay(Id vertex) const
  {
    Id count = 0;
    for (const Id near : this->Region.Neighbors[vertex])
    {
      count += this->IsHeld[near];
    }
    return static_cast<double>(count) / static_cast<double>(this->Region.Neighbors[vertex].Size());
  }

  void Empty()
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

  void Bite(Id vertex)
  {
    this->Held.assign(1, vertex);
    this->Beyond.clear();
    this->Stamps[vertex] = vertex;
    std::size_t next = 0;
    while (next < this->Held.size())
    {
      const Id held = this->Held[next++];
      for (const Id near : this->Region.Neighbors[held])
      {
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

  void LookAt(Id vertex, Id near)
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

class Dividing
{
public:
  Dividing(const OldMesh& mesh, const ChangedRegion& region,
    const std::vector<std::uint8_t>& isKept, const std::vector<double>& spacings)
    : Mesh(mesh)
    , Region(region)
    , IsKept(isKept)
    , Spacings(spacings)
    , IsDivisible(mesh.Regions.size(), 0)
    , IsDivided(mesh.Corners.size(), 0)
  {
  }

  std::vector<Point2> Run()
  {
    for (const Id triangle : this->Region.Triangles)
    {
      const Id first = 3 * triangle;
      this->IsDivisible[triangle] = this->HasGoodHalves(first) && this->HasGoodHalves(first + 1) &&
        this->HasGoodHalves(first + 2);
      for (Id slot = first; this->IsDivisible[triangle] != 0 && slot < first + 3; ++slot)
      {
        if (this->IsLastOfInner(slot) && this->IsDivisible[this->Mesh.Neighbors[slot]] != 0)
        {
          this->Divide(slot, this->Mesh.Across(slot));
        }
      }
    }
    return std::move(this->Middles);
  }

private:
  double SpacingAt(Id vertex) const { return this->Spacings[this->Region.Numbers[vertex]]; }
  double MeanSpacing(Id slot) const
  {
    return 0.5 * (this->SpacingAt(this->Mesh.Start(slot)) + this->SpacingAt(this->Mesh.End(slot)));
  }
  Point2 Middle(Id slot) const
  {
    const Point2& start = this->Mesh.Points[this->Mesh.Start(slot)];
    return start + 0.5 * (this->Mesh.Points[this->Mesh.End(slot)] - start);
  }

  // Each edge between two changed triangles once, but for marked ones: with the second triangle.
  bool IsLastOfInner(Id slot) const
  {
    const Id neighbor = this->Mesh.Neighbors[slot];
    return this->Mesh.Marks[slot] == NoId && neighbor != NoId && neighbor < slot / 3 &&
      this->Region.IsChanged[neighbor] != 0;
  }

  bool HasGoodHalves(Id slot) const
  {
    const Id start = this->Mesh.Start(slot);
    const Id end = this->Mesh.End(slot);
    const double half = 0.5 * Distance(this->Mesh.Points[start], this->Mesh.Points[end]);
    const double part = half / this->MeanSpacing(slot);
    return this->IsKept[this->Region.Numbers[start]] != 0 &&
      this->IsKept[this->Region.Numbers[end]] != 0 && KeepRules::IsGoodHalf(part * part);
  }

  // In the triangle of the slot: above the edge, and beside the middles of its other edges.
  bool HasRoom(Id slot, const Point2& middle, double room) const
  {
    const Point2& start = this->Mesh.Points[this->Mesh.Start(slot)];
    const Point2 along = this->Mesh.Points[this->Mesh.End(slot)] - start;
    const Point2 up = this->Mesh.Points[this->Mesh.Corners[slot]] - start;
    bool hasRoom = Cross(along, up) >= room * Length(along);
    for (Id other = slot - slot % 3; other < slot - slot % 3 + 3; ++other)
    {
      hasRoom &= this->IsDivided[other] == 0 || Distance(middle, this->Middle(other)) >= room;
    }
    return hasRoom;
  }

  void Divide(Id slot, Id across)
  {
    const Point2 middle = this->Middle(slot);
    const double room = KeepRules::RadiusOfFitting * this->MeanSpacing(slot);
    if (this->HasRoom(slot, middle, room) && this->HasRoom(across, middle, room))
    {
      this->IsDivided[slot] = 1;
      this->IsDivided[across] = 1;
      this->Middles.push_back(middle);
    }
  }

  const OldMesh& Mesh;
  const ChangedRegion& Region;
  const std::vector<std::uint8_t>& IsKept;
  const std::vector<double>& Spacings;
  std::vector<std::uint8_t> IsDivisible; ///< one a triangle
  std::vector<std::uint8_t> IsDivided;   ///< one a slot
  std::vector<Point2> Middles;
};

} // namespace

std::vector<std::uint8_t> ChooseKeptVertices(const OldMesh& mesh, const ChangedRegion& region,
  const RegionEdges& edges, const std::vector<double>& spacings, const KeepRules& rules)
{
  return Front(mesh, region, edges, spacings, rules).Run();
}

std::vector<Point2> FindMiddles(const OldMesh& mesh, const ChangedRegion& region,
  const std::vector<std::uint8_t>& isKept, const std::vector<double>& spacings)
{
  return Dividing(mesh, region, isKept, spacings).Run();
}

} // namespace biting
