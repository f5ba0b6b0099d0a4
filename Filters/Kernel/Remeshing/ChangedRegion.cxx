// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ChangedRegion.h"

#include <algorithm> // for all_of, min, minmax, none_of, sort
#include <cmath>     // for abs
#include <utility>   // for move

namespace biting
{

namespace
{

using Flags = std::vector<std::uint8_t>;

// Adds the triangles at the vertices that are marked, and marks their vertices. Whether there were
// any to add.
bool AddRing(const OldMesh& mesh, Flags& isMarked, Flags& isChanged)
{
  bool isLarger = false;
  for (Id triangle = 0; triangle < mesh.NumberOfTriangles(); ++triangle)
  {
    const Id* corners = mesh.Corners.data() + 3 * static_cast<std::size_t>(triangle);
    const bool isAt = isMarked[corners[0]] || isMarked[corners[1]] || isMarked[corners[2]];
    const bool isIn = isAt && !mesh.IsFrozen[triangle];
    isLarger = isLarger || (isIn && isChanged[triangle] == 0);
    isChanged[triangle] = isIn;
  }
  for (Id triangle = 0; triangle < mesh.NumberOfTriangles(); ++triangle)
  {
    for (Id slot = 3 * triangle; isChanged[triangle] && slot < 3 * triangle + 3; ++slot)
    {
      isMarked[mesh.Corners[slot]] = 1;
    }
  }
  return isLarger;
}

void NumberRegion(const OldMesh& mesh, ChangedRegion& region)
{
  region.Numbers.assign(mesh.Points.size(), NoId);
  for (Id triangle = 0; triangle < mesh.NumberOfTriangles(); ++triangle)
  {
    if (region.IsChanged[triangle])
    {
      region.Triangles.push_back(triangle);
      for (Id slot = 3 * triangle; slot < 3 * triangle + 3; ++slot)
      {
        region.Numbers[mesh.Corners[slot]] = 0;
      }
    }
  }
  for (Id vertex = 0; vertex < mesh.NumberOfVertices(); ++vertex)
  {
    if (region.Numbers[vertex] != NoId)
    {
      region.Numbers[vertex] = region.NumberOfVertices();
      region.Vertices.push_back(vertex);
    }
  }
}

void FindInside(const OldMesh& mesh, ChangedRegion& region)
{
  for (const Id vertex : region.Vertices)
  {
    region.IsInside.push_back(mesh.IsFixed[vertex] == 0);
  }
  for (Id triangle = 0; triangle < mesh.NumberOfTriangles(); ++triangle)
  {
    for (Id slot = 3 * triangle; !region.IsChanged[triangle] && slot < 3 * triangle + 3; ++slot)
    {
      const Id number = region.Numbers[mesh.Corners[slot]];
      if (number != NoId)
      {
        region.IsInside[number] = 0;
      }
    }
  }
}

// Each edge once: of two changed triangles, the one with the larger number counts.
template <typename Visit>
void ForEachEdge(const OldMesh& mesh, const ChangedRegion& region, const Visit& visit)
{
  for (const Id triangle : region.Triangles)
  {
    for (Id slot = 3 * triangle; slot < 3 * triangle + 3; ++slot)
    {
      const Id neighbor = mesh.Neighbors[slot];
      if (neighbor < triangle || !region.IsChanged[neighbor])
      {
        visit(region.Numbers[mesh.Start(slot)], region.Numbers[mesh.End(slot)]);
      }
    }
  }
}

// All that follows from the triangles that are changed.
void Describe(const OldMesh& mesh, const std::vector<double>& lengths, ChangedRegion& region)
{
  NumberRegion(mesh, region);
  FindInside(mesh, region);
  for (const Id vertex : region.Vertices)
  {
    region.Lengths.push_back(lengths[vertex]);
  }
  region.Neighbors = IdLists(region.Vertices.size(),
    [&mesh, &region](const auto& add)
    {
      ForEachEdge(mesh, region,
        [&add](Id start, Id end)
        {
          add(start, end);
          add(end, start);
        });
    });
}

void MarkRepaired(const OldMesh& mesh, Flags& isMarked)
{
  for (std::size_t triangle = 0; triangle < mesh.IsRepaired.size(); ++triangle)
  {
    for (std::size_t slot = 3 * triangle; mesh.IsRepaired[triangle] && slot < 3 * triangle + 3;
         ++slot)
    {
      isMarked[mesh.Corners[slot]] = 1;
    }
  }
  for (const Id vertex : mesh.RepairedVertices)
  {
    isMarked[vertex] = 1;
  }
}

/// Each edge once.
bool IsFirstSlot(const OldMesh& mesh, Id slot)
{
  return mesh.Neighbors[slot] < slot / 3;
}

/// Tells which vertices may go.
class Goers
{
public:
  Goers(const OldMesh& mesh, const EdgeFreedom& freedom)
    : Mesh(mesh)
    , Freedom(freedom)
    , Ends(mesh.Points.size())
  {
    for (Id slot = 0; slot < static_cast<Id>(mesh.Corners.size()); ++slot)
    {
      if (mesh.Marks[slot] != NoId && IsFirstSlot(mesh, slot))
      {
        this->Add(mesh.Start(slot), mesh.End(slot), slot);
        this->Add(mesh.End(slot), mesh.Start(slot), slot);
      }
    }
  }

  bool MayGo(Id vertex) const
  {
    const MarkedEnds& ends = this->Ends[vertex];
    const bool mayLeaveEdges = ends.Count == 0 ||
      (this->Freedom.Policy == EdgePolicy::Free && ends.Count == 2 &&
        (this->Freedom.MayBend || this->IsStraight(vertex)));
    return mayLeaveEdges && this->Mesh.IsFixed[vertex] == 0;
  }

private:
  /// The other ends of the marked edges at a vertex.
  struct MarkedEnds
  {
    Id One = NoId;
    Id Two = NoId;
    Id Count = 0;
  };

  void Add(Id vertex, Id other, Id slot)
  {
    MarkedEnds& ends = this->Ends[vertex];
    (ends.Count == 0 ? ends.One : ends.Two) = other;
    ends.Count = this->Mesh.IsFrozenEdge(this->Mesh.Marks[slot]) ? 3 : std::min(ends.Count + 1, 3);
  }

  bool IsStraight(Id vertex) const
  {
    const Point2& place = this->Mesh.Points[vertex];
    const Point2 before = this->Mesh.Points[this->Ends[vertex].One] - place;
    const Point2 after = this->Mesh.Points[this->Ends[vertex].Two] - place;
    return Dot(before, after) < 0.0 &&
      std::abs(Cross(before, after)) <= this->Mesh.Rounding * Length(after - before);
  }

  const OldMesh& Mesh;
  const EdgeFreedom& Freedom;
  std::vector<MarkedEnds> Ends;
};

} // namespace

std::vector<double> MeanLengths(const OldMesh& mesh, const std::vector<double>& spacings)
{
  std::vector<double> sums(mesh.Points.size(), 0.0);
  std::vector<Id> counts(mesh.Points.size(), 0);
  for (Id slot = 0; slot < static_cast<Id>(mesh.Corners.size()); ++slot)
  {
    if (mesh.Neighbors[slot] < slot / 3)
    {
      const Id a = mesh.Start(slot);
      const Id b = mesh.End(slot);
      const double length =
        2.0 * Distance(mesh.Points[a], mesh.Points[b]) / (spacings[a] + spacings[b]);
      for (const Id end : { a, b })
      {
        sums[end] += length;
        ++counts[end];
      }
    }
  }
  for (std::size_t vertex = 0; vertex < sums.size(); ++vertex)
  {
    sums[vertex] /= counts[vertex] > 0 ? counts[vertex] : 1;
  }
  return sums;
}

ChangedRegion FindChangedRegion(const OldMesh& mesh, const std::vector<double>& lengths,
  std::vector<std::uint8_t> isMarked, int rings)
{
  MarkRepaired(mesh, isMarked);
  ChangedRegion region;
  if (std::none_of(isMarked.begin(), isMarked.end(), [](std::uint8_t is) { return is != 0; }))
  {
    return region;
  }
  region.IsChanged.assign(mesh.Regions.size(), 0);
  bool isLarger = true;
  for (int ring = 0; ring <= rings && isLarger; ++ring)
  {
    isLarger = AddRing(mesh, isMarked, region.IsChanged);
  }
  Describe(mesh, lengths, region);
  return region;
}

bool ChangedRegion::Covers(const ChangedRegion& other) const
{
  return std::all_of(other.Triangles.begin(), other.Triangles.end(),
    [this](Id triangle) { return this->IsChanged[triangle] != 0; });
}

ChangedRegion LargerRegion(
  const OldMesh& mesh, const ChangedRegion& one, const ChangedRegion& other, int rings)
{
  Flags isMarked(mesh.Points.size(), 0);
  for (const ChangedRegion* region : { &one, &other })
  {
    for (const Id vertex : region->Vertices)
    {
      isMarked[vertex] = 1;
    }
  }
  return FindChangedRegion(
    mesh, std::vector<double>(mesh.Points.size(), 1.0), std::move(isMarked), rings);
}

std::vector<std::pair<Id, Id>> FreeEdgesOfRest(const OldMesh& mesh, const ChangedRegion& region)
{
  std::vector<std::pair<Id, Id>> edges;
  for (Id slot = 0; slot < static_cast<Id>(mesh.Corners.size()); ++slot)
  {
    const Id start = mesh.Start(slot);
    const Id end = mesh.End(slot);
    if (mesh.Neighbors[slot] == NoId && !region.IsChanged[slot / 3] &&
      region.Numbers[start] != NoId && region.Numbers[end] != NoId)
    {
      edges.push_back(std::minmax(start, end));
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

ChangedRegion WholeRegion(const OldMesh& mesh, const std::vector<double>& lengths)
{
  ChangedRegion region;
  Flags isMarked(mesh.Points.size(), 1);
  region.IsChanged.assign(mesh.Regions.size(), 0);
  AddRing(mesh, isMarked, region.IsChanged);
  Describe(mesh, lengths, region);
  return region;
}

// Edges between two vertices that are as they are wanted say nothing: few are left to look at.
std::vector<std::uint8_t> FindMisfits(const OldMesh& mesh, const std::vector<double>& spacings,
  const std::vector<double>& lengths, const EdgeFreedom& freedom)
{
  std::vector<std::uint8_t> isMisfit(mesh.Points.size(), 0);
  if (std::all_of(lengths.begin(), lengths.end(), KeepRules::IsUnchanged))
  {
    return isMisfit;
  }
  const Goers goers(mesh, freedom);
  for (Id slot = 0; slot < static_cast<Id>(mesh.Corners.size()); ++slot)
  {
    const Id start = mesh.Start(slot);
    const Id end = mesh.End(slot);
    if ((KeepRules::IsUnchanged(lengths[start]) && KeepRules::IsUnchanged(lengths[end])) ||
      !IsFirstSlot(mesh, slot))
    {
      continue;
    }
    const Point2 along = mesh.Points[end] - mesh.Points[start];
    const double mean = 0.5 * (spacings[start] + spacings[end]);
    const double square = Dot(along, along) / (mean * mean);
    const Id mark = mesh.Marks[slot];
    const bool mayBeDivided =
      mark == NoId || (freedom.Policy != EdgePolicy::Frozen && !mesh.IsFrozenEdge(mark));
    const bool mayBeShorter = square > KeepRules::GreatestSquare && mayBeDivided;
    const bool mayBeLonger =
      square < KeepRules::LeastSquare && (goers.MayGo(start) || goers.MayGo(end));
    for (const Id vertex : { start, end })
    {
      const bool isLong = lengths[vertex] > KeepRules::HighestUnchanged;
      const bool isShort = lengths[vertex] < KeepRules::LowestUnchanged;
      isMisfit[vertex] |= (isLong && mayBeShorter) || (isShort && mayBeLonger) ? 1 : 0;
    }
  }
  return isMisfit;
}

} // namespace biting
