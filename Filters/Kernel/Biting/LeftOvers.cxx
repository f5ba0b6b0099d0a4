// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "LeftOvers.h"

#include "BiteOutline.h" // for Depth

#include <algorithm> // for clamp, max, min, max_element, min_element
#include <iterator>  // for begin, end
#include <limits>    // for infinity
#include <utility>   // for exchange

namespace biting
{

namespace
{

constexpr int MostTaken = 64;      // more than there are where f follows the domain
constexpr int MostHalvings = 40;   // of triangles: from the whole domain to far below f
constexpr int MostApproaches = 20; // to a corner: half of the way each
constexpr int LeastCrowd = 64;

// Order -> the first bite of it. Bites are numbered as the vertices say, but for several squares of
// a vertex, and shields.
std::vector<Id> FirstOfOrders(const Bites& placed, Id numberOfOrders)
{
  std::vector<Id> first(static_cast<std::size_t>(numberOfOrders), NoId);
  for (Id bite = placed.Size(); bite-- > 0;)
  {
    first[placed.Orders[bite]] = bite;
  }
  return first;
}

std::size_t OppositeLongestSide(const std::array<Point2, 3>& places)
{
  const Point2 sides[3] = { places[2] - places[1], places[0] - places[2], places[1] - places[0] };
  const auto* longest = std::max_element(std::begin(sides), std::end(sides),
    [](const Point2& a, const Point2& b) { return Dot(a, a) < Dot(b, b); });
  return static_cast<std::size_t>(longest - sides);
}

// Of the bite's outline, to a place outside.
Point2 NearestPlace(const Bites& bites, Id bite, const Point2& p)
{
  const Point2& center = bites.Centers[bite];
  const double halfWidth = bites.HalfWidths[bite];
  const Point2 offset = p - center;
  if (bites.IsCircle(bite))
  {
    return center + halfWidth / Length(offset) * offset;
  }
  const Point2& axis = bites.Axes[bite];
  const double along = std::clamp(Dot(offset, axis), -halfWidth, halfWidth);
  const double across = std::clamp(Cross(axis, offset), -halfWidth, halfWidth);
  return center + along * axis + across * Perpendicular(axis);
}

} // namespace

LeftOvers::LeftOvers(BitingState& state)
  : State(state)
{
}

std::vector<Point2> LeftOvers::FindPlaces()
{
  if (!this->HasBegun)
  {
    this->Begin();
  }
  this->Found.clear();
  if (this->State.Placed.Size() == std::exchange(this->LastSize, this->State.Placed.Size()))
  {
    this->Doubtful.insert(this->Doubtful.end(), this->Gaps.begin(), this->Gaps.end());
    return this->Found;
  }
  this->CutsLeft = this->State.Placed.Size();
  for (const Id triangle : std::exchange(this->Gaps, {}))
  {
    if (!this->State.Progress.Beat())
    {
      break;
    }
    const std::size_t before = this->Found.size();
    if (!this->IsCovered(triangle))
    {
      (this->Found.size() > before ? this->Gaps : this->Doubtful).push_back(triangle);
    }
  }
  return this->Found;
}

std::vector<Id> LeftOvers::FindBites()
{
  const bool isWhole = this->State.Result.Triangulated.IsWhole();
  std::vector<std::uint8_t> isMarked(
    static_cast<std::size_t>(this->State.Placed.Size()), isWhole ? 0 : 1);
  this->CutsLeft = this->State.Placed.Size();
  for (const Id triangle : this->Doubtful)
  {
    if (!this->State.Progress.Beat())
    {
      break;
    }
    if (!this->IsCovered(triangle))
    {
      this->MarkAbout(triangle, isMarked);
    }
  }
  std::vector<Id> marked;
  for (Id bite = 0; bite < this->State.Placed.Size(); ++bite)
  {
    if (isMarked[bite] != 0)
    {
      marked.push_back(bite);
    }
  }
  return marked;
}

void LeftOvers::Begin()
{
  this->HasBegun = true;
  this->State.Result.Triangulated = MakeConstrainedMesh(this->State.Result.Points,
    ConstraintsOf(this->State.Result, this->State.Geometry), this->State.Options.Phi,
    this->State.Progress);
  const ConstrainedMesh& made = this->State.Result.Triangulated;
  if (!made.IsWhole() || this->State.Progress.HasStopped())
  {
    return;
  }
  const std::vector<double>& halfWidths = this->State.Placed.HalfWidths;
  this->LeastHalfWidth = *std::min_element(halfWidths.begin(), halfWidths.end());
  this->OfOrder = FirstOfOrders(this->State.Placed, this->State.NumberOfBites);
  const Id count = made.Inserted.Mesh.NumberOfTriangles;
  for (Id triangle = 0; triangle < count && this->State.Progress.Beat(1); ++triangle)
  {
    if (this->MayHaveGap(triangle))
    {
      this->Gaps.push_back(triangle);
    }
  }
}

Box2 LeftOvers::BoxOf(Id triangle) const
{
  return Box2::Around(this->PlacesOf(triangle));
}

std::array<Id, 3> LeftOvers::BitesOf(Id triangle) const
{
  const InsertionResult& inserted = this->State.Result.Triangulated.Inserted;
  const Id* corners = &inserted.Mesh.Corners[HalfEdgeMesh::FirstEdge(triangle)];
  const auto biteOf = [this, &inserted](Id corner)
  { return this->OfOrder[this->State.Result.BiteOrders[inserted.Order[corner]]]; };
  return { biteOf(corners[0]), biteOf(corners[1]), biteOf(corners[2]) };
}

LeftOvers::Triangle LeftOvers::PlacesOf(Id triangle) const
{
  const HalfEdgeMesh& mesh = this->State.Result.Triangulated.Inserted.Mesh;
  const Id* corners = &mesh.Corners[HalfEdgeMesh::FirstEdge(triangle)];
  return { mesh.PointAt(corners[0]), mesh.PointAt(corners[1]), mesh.PointAt(corners[2]) };
}

bool LeftOvers::MayHaveGap(Id triangle) const
{
  if (this->State.Result.Triangulated.Inserted.Mesh.IsGhost(triangle))
  {
    return false;
  }
  const Triangle places = this->PlacesOf(triangle);
  if (IsWithinOfCorners(places, this->LeastHalfWidth))
  {
    return false; // nearly all where f is uniform
  }
  const std::array<Id, 3> bites = this->BitesOf(triangle);
  const std::vector<double>& halfWidths = this->State.Placed.HalfWidths;
  const double least =
    std::min({ halfWidths[bites[0]], halfWidths[bites[1]], halfWidths[bites[2]] });
  return !IsWithinOfCorners(places, least) && !CoverTriangle(this->State.Placed, bites) &&
    !this->IsOutside(triangle);
}

// No constraint crosses it: its middle tells.
bool LeftOvers::IsOutside(Id triangle) const
{
  const InsertionResult& inserted = this->State.Result.Triangulated.Inserted;
  const Id* corners = &inserted.Mesh.Corners[HalfEdgeMesh::FirstEdge(triangle)];
  for (int k = 0; k < 3; ++k)
  {
    const Id point = inserted.Order[corners[k]];
    if (point >= this->State.Geometry.NumberOfVertices() && this->State.SegmentOf(point) == NoId)
    {
      return false;
    }
  }
  const Triangle places = this->PlacesOf(triangle);
  return !this->State.Locator.IsInside(
    places[0] + 1.0 / 3.0 * ((places[1] - places[0]) + (places[2] - places[0])));
}

// The bites of the corners are taken away first, as they take most.
bool LeftOvers::IsCovered(Id triangle)
{
  return this->IsCovered(this->PlacesOf(triangle), this->BitesOf(triangle), MostHalvings);
}

// A triangle over which there are many bites is halved across its longest side, so that what each
// of them takes is looked for in few pieces, and few bites reach over both halves, also where it is
// flat: cost is linear in the bites, of which there are as many as cuts, at most.
bool LeftOvers::IsCovered(const Triangle& places, const std::array<Id, 3>& first, int halvings)
{
  const std::size_t before = this->Found.size();
  const Outcome outcome = this->TakeAll(places, first);
  if (outcome != Outcome::HasTooMany || halvings == 0 || this->CutsLeft == 0)
  {
    return outcome == Outcome::Covered;
  }
  --this->CutsLeft;
  this->Found.resize(before);
  const std::size_t apex = OppositeLongestSide(places);
  const Point2& from = places[(apex + 1) % 3];
  const Point2& to = places[(apex + 2) % 3];
  const Point2 middle = Midpoint(from, to);
  bool isCovered = true;
  for (const Triangle& half :
    { Triangle{ places[apex], from, middle }, Triangle{ places[apex], middle, to } })
  {
    isCovered =
      this->State.Progress.Beat() && this->IsCovered(half, first, halvings - 1) && isCovered;
  }
  return isCovered;
}

// After those three, for each piece that is left, the bite which its middle lies deepest in. Where
// that lies in none there is a gap; where that takes nothing the piece is less than rounding, or
// than a circle is beyond its polygon.
LeftOvers::Outcome LeftOvers::TakeAll(const Triangle& places, const std::array<Id, 3>& first)
{
  const biting::Bites& placed = this->State.Placed;
  this->Left.Begin(places);
  for (const Id bite : first)
  {
    this->Left.TakeAway(placed, bite, this->State.Slack(bite));
  }
  Outcome outcome = Outcome::Covered;
  for (int taken = 0; !this->Left.IsEmpty(); ++taken)
  {
    if (taken == MostTaken)
    {
      return Outcome::HasTooMany;
    }
    const Point2 middle = this->Left.MiddleOfLast();
    const Id bite = this->DeepestAt(middle);
    if (bite != NoId && this->Left.TakeAway(placed, bite, this->State.Slack(bite)))
    {
      continue;
    }
    outcome = Outcome::NotCovered;
    if (bite == NoId)
    {
      this->PutPlaceBeside(middle, first);
    }
    this->Left.DropLast();
  }
  return outcome;
}

// Of the bites that p lies in, or of the first of these where they crowd.
Id LeftOvers::DeepestAt(const Point2& p) const
{
  Id deepest = NoId;
  double most = 0.0;
  int looked = 0;
  this->State.Grid.VisitLeaf(p,
    [this, &p, &deepest, &most, &looked](Id bite)
    {
      const double depth = Depth(this->State.Placed, bite, p);
      deepest = depth > most ? bite : deepest;
      most = std::max(most, depth);
      return ++looked >= LeastCrowd && deepest != NoId;
    });
  return deepest;
}

// Where no bite is near, goes towards the nearest corner until one is: what lies between is of the
// domain.
void LeftOvers::PutPlaceBeside(const Point2& p, const std::array<Id, 3>& atCorners)
{
  const auto squareTo = [this, &p](Id bite)
  {
    const Point2 offset = this->State.Placed.Centers[bite] - p;
    return Dot(offset, offset);
  };
  const Id corner = *std::min_element(atCorners.begin(), atCorners.end(),
    [&squareTo](Id a, Id b) { return squareTo(a) < squareTo(b); });
  Point2 uncovered = p;
  Point2 covered = this->State.Placed.Centers[corner];
  bool isFound = this->FindPlaceBeside(uncovered);
  for (int halving = 0; halving < MostApproaches && !isFound; ++halving)
  {
    const Point2 middle = Midpoint(uncovered, covered);
    const bool isCovered = this->DeepestAt(middle) != NoId;
    (isCovered ? covered : uncovered) = middle;
    isFound = !isCovered && this->FindPlaceBeside(middle);
  }
}

// The place of all outlines that is nearest to p, which no bite covers: nothing between the two is
// covered either. False where no bite is near.
bool LeftOvers::FindPlaceBeside(const Point2& p)
{
  Point2 place;
  double least = std::numeric_limits<double>::infinity();
  this->State.Grid.VisitNear(p, NeighborRange(this->State.Options),
    [this, &p, &place, &least](Id bite)
    {
      const Point2 nearest = NearestPlace(this->State.Placed, bite, p);
      const double square = Dot(nearest - p, nearest - p);
      place = square < least ? nearest : place;
      least = std::min(least, square);
      return false;
    });
  const bool isFound = least < std::numeric_limits<double>::infinity();
  if (isFound && this->State.Locator.IsInside(place))
  {
    this->Found.push_back(place);
  }
  return isFound;
}

void LeftOvers::MarkAbout(Id triangle, std::vector<std::uint8_t>& isMarked) const
{
  const Box2 box = this->BoxOf(triangle);
  this->State.Grid.VisitSquare(Midpoint(box.Low, box.High),
    0.5 * std::max(box.Width(), box.Height()),
    [&isMarked](Id bite)
    {
      isMarked[bite] = 1;
      return false;
    });
}

} // namespace biting
