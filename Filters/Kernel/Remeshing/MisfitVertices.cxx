// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MisfitVertices.h"

#include "KeepRules.h"

#include <algorithm> // for all_of, min
#include <cmath>     // for abs
#include <cstddef>   // for sizes

namespace biting
{

namespace
{

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
