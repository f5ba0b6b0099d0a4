// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Arrangement.h"

#include <algorithm> // for min
#include <utility>   // for pair

namespace biting
{

namespace
{

/// Lines come before faces.
Id FirstCell(const ArrangementEdge& a, const ArrangementEdge& b)
{
  if (a.HasLine() != b.HasLine())
  {
    return a.HasLine() ? a.Cell : b.Cell;
  }
  return std::min(a.Cell, b.Cell);
}

} // namespace

void Absorb(ArrangementEdge& kept, const ArrangementEdge& other)
{
  kept.Cell = FirstCell(kept, other);
  kept.BoundaryCount += other.BoundaryCount;
  kept.OpenCount += other.OpenCount;
  kept.IsInterface = kept.IsInterface || other.IsInterface;
  kept.IsNew = kept.IsNew && other.IsNew;
  kept.Faces.Absorb(other.Faces, kept.Ends.Start != other.Ends.Start);
}

bool Arrangement::DividesRegions(const ArrangementEdge& edge) const
{
  const auto [first, second] = this->Regions.empty() ? std::pair(NoId, NoId) : edge.Faces.OddPair();
  return first != NoId && this->Regions[first] != this->Regions[second];
}

bool Arrangement::IsNothing(const ArrangementEdge& edge) const
{
  return edge.Faces.Count % 2 == 0 && !edge.Faces.Stays && !edge.HasLine() &&
    !this->DividesRegions(edge);
}

std::vector<SegmentEnds> Arrangement::EdgeEnds() const
{
  std::vector<SegmentEnds> ends;
  ends.reserve(this->Edges.size());
  for (const ArrangementEdge& edge : this->Edges)
  {
    ends.push_back(edge.Ends);
  }
  return ends;
}

} // namespace biting
