// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FrontVertices.h"

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

} // namespace biting
