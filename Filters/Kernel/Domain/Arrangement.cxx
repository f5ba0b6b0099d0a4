// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Arrangement.h"

#include <algorithm> // for find, sort
#include <cstddef>   // for size_t
#include <utility>   // for pair

namespace biting
{

namespace
{

constexpr Id KeptInPlace = 3;

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

std::vector<Id> FaceEdge::OddFaces() const
{
  std::vector<Id> odd;
  for (Id k = 0; k < this->Count; ++k)
  {
    const Id face = FaceOf(this->RunAt(k));
    const auto known = std::find(odd.begin(), odd.end(), face);
    if (known == odd.end())
    {
      odd.push_back(face);
    }
    else
    {
      odd.erase(known);
    }
  }
  return odd;
}

/// The ordinary edge allocates nothing.
std::pair<Id, Id> FaceEdge::OddPair() const
{
  const std::pair<Id, Id> none{ NoId, NoId };
  if (this->Count == 2)
  {
    return this->First() != this->Second() ? std::pair(this->First(), this->Second()) : none;
  }
  const std::vector<Id> odd = this->Count > 2 ? this->OddFaces() : std::vector<Id>();
  return odd.size() == 2 ? std::pair(odd[0], odd[1]) : none;
}

void FaceEdge::AddRun(Id run)
{
  for (Id k = 0; k < this->Count; ++k)
  {
    if (this->RunAt(k) == OtherSide(run))
    {
      for (; k + 1 < this->Count; ++k)
      {
        this->RunAt(k) = this->RunAt(k + 1);
      }
      this->RunAt(k) = NoId;
      --this->Count;
      this->MoreRuns.resize(static_cast<std::size_t>(std::max(this->Count - KeptInPlace, 0)));
      return;
    }
  }
  ++this->Count;
  this->MoreRuns.resize(static_cast<std::size_t>(std::max(this->Count - KeptInPlace, 0)));
  this->RunAt(this->Count - 1) = run;
}

void FaceEdge::Absorb(const FaceEdge& other, bool isReversed)
{
  this->Stays = this->Stays || other.Stays;
  this->Turn += isReversed ? -other.Turn : other.Turn;
  for (Id k = 0; k < other.Count; ++k)
  {
    const Id run = other.RunAt(k);
    this->AddRun(isReversed ? OtherSide(run) : run);
  }
}

Id FaceEdge::RunAt(Id k) const
{
  return k < KeptInPlace ? this->Runs[k] : this->MoreRuns[k - KeptInPlace];
}

Id& FaceEdge::RunAt(Id k)
{
  return k < KeptInPlace ? this->Runs[k] : this->MoreRuns[k - KeptInPlace];
}

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
