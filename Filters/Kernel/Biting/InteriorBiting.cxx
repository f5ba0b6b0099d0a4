// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "InteriorBiting.h"

#include "BiteTriangle.h"

#include <cmath> // for abs

namespace biting
{

namespace
{

constexpr int MostOverlapping = 64; // more bites than overlap where f follows the domain

} // namespace

FrontVertices::FrontVertices(const BitingState& state)
  : State(state)
  , Bounds(state.Geometry.Bounds)
{
  this->Bounds.Grow(state.Geometry.Resolution);
}

const std::vector<Point2>& FrontVertices::Find(Id bite)
{
  this->Found.clear();
  this->Seen.resize(static_cast<std::size_t>(this->State.Placed.Size()), NoId);
  this->Outline.Begin(this->State.Placed, bite);
  const Point2 center = this->State.Placed.Centers[bite];
  const Point2 axis = this->State.Placed.Axes[bite];
  const double spread =
    this->State.Placed.IsCircle(bite) ? 1.0 : std::abs(axis.X) + std::abs(axis.Y);
  const double reach = this->State.Placed.HalfWidths[bite] * spread;
  this->Seen[bite] = bite;
  if (this->IsHidden(bite, reach))
  {
    return this->Found;
  }
  Box2 box = Box2::Around(center, center);
  box.Grow(reach);
  const bool isClear = this->State.Locator.IsClear(box);
  this->Outline.VisitEnds(
    [this, isClear](const Point2& place)
    {
      if (isClear || this->State.Locator.IsInside(place))
      {
        this->Found.push_back(place);
      }
    });
  return this->Found;
}

// Finds the gaps of the bite's outline. Where bites are crowded, some of them hide it as well as
// all do, and there is nothing of it within the domain, whatever is left to look at.
bool FrontVertices::IsHidden(Id bite, double reach)
{
  const Point2& center = this->State.Placed.Centers[bite];
  int looked = 0;
  const auto makesCrowd = [this, bite, &looked](Id other)
  {
    looked += this->Look(bite, other) ? 1 : 0;
    return looked == MostOverlapping;
  };
  if (this->State.Grid.VisitSquare(center, reach, makesCrowd))
  {
    do
    {
      this->Outline.Finish();
      if (this->Outline.IsHiddenWithin(this->Bounds))
      {
        return true;
      }
    } while (this->HideGaps(bite));
    this->State.Grid.VisitSquare(center, reach,
      [this, bite](Id other)
      {
        this->Look(bite, other);
        return false;
      });
  }
  this->Outline.Finish();
  return false;
}

// Looks for a bite on the middle of each gap, as far as it matters. False where there is none that
// was not asked before.
bool FrontVertices::HideGaps(Id bite)
{
  for (int side = 0; side < 4; ++side)
  {
    for (const BiteOutline::Interval& gap : this->Outline.Gaps(side))
    {
      const BiteOutline::Interval part = this->Outline.PartWithin(side, gap, this->Bounds);
      const Point2 middle = this->Outline.At(side, 0.5 * (part.Low + part.High));
      const auto hides = [this, bite, &middle](Id other)
      { return Depth(this->State.Placed, other, middle) > 0.0 && this->Look(bite, other); };
      if (part.Low < part.High && !this->State.Grid.VisitLeaf(middle, hides))
      {
        return false;
      }
    }
  }
  return true;
}

// Takes away what `other` covers, unless it has been asked before.
bool FrontVertices::Look(Id bite, Id other)
{
  if (this->Seen[other] == bite)
  {
    return false;
  }
  this->Seen[other] = bite;
  this->Outline.Cover(this->State.Placed, other);
  return true;
}

InteriorBiting::InteriorBiting(BitingState& state)
  : State(state)
  , IsUniform(state.F.IsUniform())
  , Points(state.Placed, state.Grid, state.Options.PartLength / state.Options.BitingConstant,
      state.Options.Tolerance, state.Geometry.Resolution)
  , Front(state)
  , Queue(state.Options.Order)
  , Rest(state)
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

void InteriorBiting::BiteCandidate(Candidate candidate)
{
  const bool isBisector = candidate.Parents[0] != NoId;
  if (isBisector && this->Points.IsDeep(candidate.Place, candidate.Birth))
  {
    return;
  }
  const double known = isBisector ? this->Shift(candidate) : 0.0;
  if (!this->IsUncovered(candidate))
  {
    return;
  }
  const double spacing = known > 0.0 ? known : this->State.F(candidate.Place);
  const Id vertex = this->State.AddVertex(candidate.Place, spacing, NoId);
  this->State.Bite(
    vertex, this->AxisOf(candidate), this->ShareOf(candidate, vertex), BitePhase::Interior);
  this->PutCandidates(this->State.Placed.Size() - 1);
  this->State.FinishBite();
}

// Squares go where f asks for them, unless one of the two bites covers that; circles are made
// larger or smaller instead (BiteTriangle.h). Most candidates are covered by then, and f is asked
// for the others only. Returns f where the candidate comes to lie, 0 where it was not asked there.
double InteriorBiting::Shift(Candidate& candidate) const
{
  if (!this->State.Options.FollowSlope || this->State.Options.Shape != BiteShape::Square)
  {
    return 0.0;
  }
  const auto [bite, other] = candidate.Parents;
  const double left = this->State.PlacedSpacings[bite];
  const double right = this->State.PlacedSpacings[other];
  const double here = this->IsUniform ? left : this->State.F(candidate.Place);
  const BiteTriangle triangle{ this->State.Placed.Centers[bite], this->State.Placed.Centers[other],
    candidate.Place, left, right, here };
  const double share =
    (this->State.Placed.HalfWidths[bite] + this->State.Placed.HalfWidths[other]) /
    (this->State.Options.BitingConstant * (left + right));
  const Point2 top =
    BalancedTop(triangle, share * this->State.Options.Stretch * this->State.Options.PartLength);
  if (top == candidate.Place || this->Points.IsCoveredBy(bite, top) ||
    this->Points.IsCoveredBy(other, top))
  {
    return here;
  }
  candidate.Place = top;
  return this->IsUniform ? here : 0.0;
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
  const bool isInner = this->State.Placed.Phases[bite] == BitePhase::Interior;
  this->Points.VisitPoints(bite,
    [this, bite, newest, isInner](const BisectorPoint& point)
    {
      if (!isInner && !this->State.Locator.IsInside(point.Place))
      {
        return; // about half of those on the boundary
      }
      this->Queue.Put(
        { point.Place, newest, { bite, point.Neighbor }, this->Queue.ClassOf(point.Misfit) });
    });
}

void InteriorBiting::PutFrontVertices(Id bite)
{
  const Id newest = this->State.Placed.Size() - 1;
  for (const Point2& place : this->Front.Find(bite))
  {
    this->Queue.Put({ place, newest, { NoId, NoId }, 0 });
  }
}

// Looks for left-overs of bisectors once the queue is empty. Returns whether there are candidates
// again.
bool InteriorBiting::PutLeftOvers()
{
  if (this->State.Options.Placement == Placement::Corners)
  {
    return false;
  }
  if (!this->AreGapsBitten)
  {
    const Id newest = this->State.Placed.Size() - 1;
    for (const Point2& place : this->Rest.FindPlaces())
    {
      this->Queue.Put({ place, newest, { NoId, NoId }, 0 });
    }
    this->AreGapsBitten = this->Queue.IsEmpty();
  }
  while (this->Queue.IsEmpty() && this->State.MayBite() && this->HasOpen())
  {
    const Id next = this->NextOpen++;
    const Id count = static_cast<Id>(this->Open.size());
    this->PutFrontVertices(next < count ? this->Open[next] : this->FirstNew + next - count);
    this->State.Step();
  }
  return !this->Queue.IsEmpty();
}

// Whether there is a bite whose outline may have a gap: those about doubtful places, and all that
// come after these. Each is looked at once: a vertex of the front that another bite makes later is
// one of that bite too.
bool InteriorBiting::HasOpen()
{
  if (this->FirstNew == NoId)
  {
    this->Open = this->Rest.FindBites();
    this->FirstNew = this->State.Placed.Size();
  }
  const Id numberOfNew = this->State.Placed.Size() - this->FirstNew;
  return this->NextOpen < static_cast<Id>(this->Open.size()) + numberOfNew;
}

// Against the bites since the candidate's birth first: most candidates end there.
bool InteriorBiting::IsUncovered(const Candidate& candidate)
{
  if (candidate.Parents[0] != NoId)
  {
    return !this->Points.IsCovered(candidate.Place) &&
      this->State.Locator.IsInside(candidate.Place);
  }
  const bool isCovered = this->State.Grid.VisitLeaf(
    candidate.Place,
    [this, &candidate](Id bite)
    { return Depth(this->State.Placed, bite, candidate.Place) > this->State.Slack(bite); },
    candidate.Birth);
  return !isCovered && !this->IsSurrounded(candidate.Place);
}

bool InteriorBiting::IsSurrounded(const Point2& p) const
{
  DirectionMask mask;
  this->State.Grid.VisitLeaf(p,
    [this, &p, &mask](Id bite)
    {
      mask.Add(this->State.Placed, bite, p, this->State.Slack(bite));
      return mask.IsFull();
    });
  return mask.IsFull();
}

} // namespace biting
