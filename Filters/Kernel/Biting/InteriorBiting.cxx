// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "InteriorBiting.h"

#include "BalancedTop.h"
#include "ReachFactor.h"

#include <algorithm> // for min

namespace biting
{

namespace
{

constexpr double TieTolerance = 1e-12; // of a half-width: a point this near a side lies on it

// Of a half-width: where bites are as small as the rounding of places, each takes something away
// all the same.
constexpr double GreatestSlack = 0.5;

} // namespace

InteriorBiting::InteriorBiting(BitingState& state)
  : State(state)
  , IsUniform(state.F.IsUniform())
  , Points(state.Placed, state.Grid, state.PartLength / state.BitingConstant,
      UsedTolerance(state.Options), state.Geometry.Resolution)
  , Front(state)
  , Queue(state.Options.Order)
{
}

// Once all of the boundary is bitten: most corners of its bites are covered by then.
void InteriorBiting::SeedFront()
{
  for (Id bite = 0;
       bite < this->State.Placed.Size() && this->State.Result.End == BitingEnd::Complete; ++bite)
  {
    this->PutCandidates(bite);
    this->State.Step();
  }
}

void InteriorBiting::Run()
{
  this->SeedFront();
  while (this->State.MayBite() && (!this->Queue.IsEmpty() || this->PutLeftOvers()))
  {
    this->BiteCandidate(this->Queue.Take());
    this->State.Step();
  }
}

void InteriorBiting::BiteCandidate(const Candidate& candidate)
{
  if (!this->IsUncovered(candidate))
  {
    return;
  }
  const Id vertex = this->State.AddVertex(candidate.Place, this->State.F(candidate.Place), NoId);
  this->State.Bite(
    vertex, this->AxisOf(candidate), this->ShareOf(candidate, vertex), BitePhase::Interior);
  this->PutCandidates(this->State.Placed.Size() - 1);
  this->State.FinishBite();
}

// The bond of the two bites that the candidate stands on.
Point2 InteriorBiting::AxisOf(const Candidate& candidate) const
{
  if (candidate.Parents[0] == NoId)
  {
    return { 1.0, 0.0 };
  }
  const Point2 bond = this->State.Placed.Centers[candidate.Parents[1]] -
    this->State.Placed.Centers[candidate.Parents[0]];
  return 1.0 / Length(bond) * bond;
}

// The half-width of the bite at the candidate, in units of c_b f.
double InteriorBiting::ShareOf(const Candidate& candidate, Id vertex) const
{
  if (!this->State.Options.FollowSlope || candidate.Parents[0] == NoId)
  {
    return 1.0;
  }
  const Id left = candidate.Parents[0];
  const Id right = candidate.Parents[1];
  return ReachFactor(this->State.Options.Shape, this->State.Options.Order,
    { this->State.Placed.Centers[left], this->State.Placed.Centers[right], candidate.Place,
      this->State.PlacedSpacings[left], this->State.PlacedSpacings[right],
      this->State.Result.Spacings[vertex] });
}

void InteriorBiting::PutCandidates(Id bite)
{
  if (this->State.Options.Placement == Placement::Corners)
  {
    this->PutFrontVertices(bite);
  }
  else
  {
    this->PutBisectorPoints(bite);
  }
}

void InteriorBiting::PutBisectorPoints(Id bite)
{
  const Id newest = this->State.Placed.Size() - 1;
  this->Points.VisitPoints(bite,
    [this, bite, newest](const BisectorPoint& point)
    {
      this->Queue.Put({ this->PlaceOf(bite, point), newest, { bite, point.Neighbor },
        this->Queue.ClassOf(point.Misfit) });
    });
}

// Squares go where f asks for them, unless one of the two bites covers that; circles are made
// larger or smaller instead (ReachFactor.h).
Point2 InteriorBiting::PlaceOf(Id bite, const BisectorPoint& point) const
{
  if (!this->State.Options.FollowSlope || this->State.Options.Shape != BiteShape::Square)
  {
    return point.Place;
  }
  const Id other = point.Neighbor;
  const double left = this->State.PlacedSpacings[bite];
  const double right = this->State.PlacedSpacings[other];
  const double share =
    (this->State.Placed.HalfWidths[bite] + this->State.Placed.HalfWidths[other]) /
    (this->State.BitingConstant * (left + right));
  const Point2 top =
    BalancedTop({ this->State.Placed.Centers[bite], this->State.Placed.Centers[other], point.Place,
                  left, right, this->IsUniform ? left : this->State.F(point.Place) },
      share * this->State.PartLength);
  const bool isCovered =
    this->Points.IsCoveredBy(bite, top) || this->Points.IsCoveredBy(other, top);
  return isCovered ? point.Place : top;
}

void InteriorBiting::PutFrontVertices(Id bite)
{
  const Id newest = this->State.Placed.Size() - 1;
  for (const Point2& place : this->Front.Find(bite))
  {
    this->Queue.Put({ place, newest, { NoId, NoId }, 0 });
  }
}

// The vertices of the front on bites that are not all covered, once there are no other candidates.
// All bites are looked at once: a vertex that another bite makes later is one of that bite too.
bool InteriorBiting::PutLeftOvers()
{
  const bool isLastResort = this->State.Options.Placement != Placement::Corners;
  while (isLastResort && this->Queue.IsEmpty() &&
    this->NumberOfChecked < this->State.Placed.Size() && this->State.MayBite())
  {
    const Id bite = this->NumberOfChecked++;
    if (!this->Front.IsEnclosed(bite))
    {
      this->PutFrontVertices(bite);
    }
    this->State.Step();
  }
  return !this->Queue.IsEmpty();
}

// Against the bites since the candidate's birth first: most candidates end there.
bool InteriorBiting::IsUncovered(const Candidate& candidate) const
{
  if (candidate.Parents[0] != NoId)
  {
    return !this->Points.IsCovered(candidate.Place) &&
      this->State.Locator.IsInside(candidate.Place);
  }
  bool isCovered = false;
  this->State.Grid.VisitLeaf(candidate.Place,
    [this, &candidate, &isCovered](Id bite)
    {
      isCovered = bite > candidate.Birth &&
        Depth(this->State.Placed, bite, candidate.Place) > this->Slack(bite);
      return isCovered || bite <= candidate.Birth;
    });
  return !isCovered && !this->IsSurrounded(candidate.Place);
}

bool InteriorBiting::IsSurrounded(const Point2& p) const
{
  DirectionMask mask;
  this->State.Grid.VisitLeaf(p,
    [this, &p, &mask](Id bite)
    {
      mask.Add(this->State.Placed, bite, p, this->Slack(bite));
      return mask.IsFull();
    });
  return mask.IsFull();
}

double InteriorBiting::Slack(Id bite) const
{
  const double halfWidth = this->State.Placed.HalfWidths[bite];
  return TieTolerance * halfWidth +
    std::min(this->State.Geometry.Resolution, GreatestSlack * halfWidth);
}

} // namespace biting
