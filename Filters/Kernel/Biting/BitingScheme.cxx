// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BitingScheme.h"

#include "../Base/PointOnSegment.h"
#include "../Base/Pulse.h"
#include "BalancedTop.h"
#include "Bisectors.h"
#include "BiteGrid.h"
#include "BiteOutline.h"
#include "EdgeDivision.h"
#include "FrontTrace.h"
#include "Orientation.h"
#include "OutlineCover.h"
#include "ReachFactor.h"
#include "RingCover.h"
#include "SharpCorners.h"

#include <algorithm> // for min, max, all_of
#include <iterator>  // for begin, end
#include <numeric>   // for iota

namespace biting
{

namespace
{

// c_b for a mean edge length f, and vertices per integral of 1/f^2 then, measured: corners over uniform
// and graded fields, bisectors where f is level (elsewhere see ReachFactor.h).
constexpr double SquareCornerConstant = 0.77;
constexpr double SquareCornerSweepConstant = 0.80;
constexpr double SquareBisectorConstant = 0.824;
constexpr double CircleCornerConstant = 0.91;
constexpr double CircleBisectorConstant = 0.995;
constexpr double VerticesPerDensity = 1.21;

constexpr double SquareTolerance = 0.9;
constexpr double CircleTolerance = 0.8;

constexpr double TieTolerance = 1e-12; // of a half-width: a point this near a side lies on it

// Of a half-width: where bites are as small as the rounding of places, each takes something away all
// the same.
constexpr double GreatestSlack = 0.5;

// Of the parts of an edge that is not divided: their least length and the wanted one, in units of
// c_b f. Where long edges meet short ones, smaller shields leave thinner triangles on the edges, and
// larger ones thinner triangles beside these.
constexpr double LeastShieldLength = 1.7;
constexpr double ShieldLength = 2.6;
constexpr double ShieldOverlap = 1.0625;    // of neighbours: their common border lies inside both
constexpr std::int64_t FewShields = 200000; // for which no limit of vertices is meant

constexpr std::size_t CheapStepsPerBite = 32; // where bites are crowded: thousands
constexpr int LeastCrowd = 64;                // more bites than overlap where f follows the domain
constexpr double GreatestReach = 2.83; // of half-widths: equal bites further apart do not meet

class BitingRun
{
public:
  BitingRun(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
    double expectedVertices, const BitingOptions& options, Monitor& monitor);

  BitingResult Run();

private:
  void CopyDomain(double expectedVertices);
  void ProtectVertices();
  void ProtectEdges();
  void ProtectEdge(Id segment, const SharpCorners& corners);
  void ShieldEdges();
  void ShieldEdge(Id segment, EdgeDivider& divider);
  void ShieldPart(Id segment, double from, double to);
  bool IsHeld(Id segment, const Point2& center, const Point2& along) const;
  bool IsWithinBite(const Point2& first, const Point2& last, Id vertex, const Point2& across) const;
  void SeedFront();
  void BiteInterior();
  void BiteCandidate(const Candidate& candidate);
  Id AddVertex(const Point2& place, double spacing, Id segment);
  void AddEdge(Id start, Id end, Id segment);
  void Bite(Id vertex, const Point2& axis, double reach, BitePhase phase);
  void AddBite(
    const Point2& center, const Point2& axis, double halfWidth, double spacing, BitePhase phase);
  void PutCandidates(Id bite);
  void PutBisectorPoints(Id bite);
  Point2 PlaceOf(Id bite, const BisectorPoint& point) const;
  void PutFrontVertices(Id bite);
  bool PutLeftOvers();
  bool IsEnclosed(Id bite) const;
  bool IsRinged(Id bite) const;
  Point2 AxisOf(const Candidate& candidate) const;
  double ReachOf(const Candidate& candidate, Id vertex) const;
  bool IsHidden(Id bite, double reach);
  bool HideGaps(Id bite);
  bool Look(Id bite, Id other);
  bool IsUncovered(const Candidate& candidate) const;
  bool IsSurrounded(const Point2& p) const;
  double Slack(Id bite) const;
  bool MayBite() const;
  void Advance();
  void Step();
  BitingEnd ReasonNotToDivide() const;

  const Domain& Geometry;
  const DomainLocator& Locator;
  const Spacing& F;
  const BitingOptions& Options;
  Pulse Progress;
  double BitingConstant;
  double PartLength; ///< wanted length of boundary edges in units of f
  double ExpectedVertices;
  bool IsUniform; ///< f is one constant
  BitingResult Result;
  Bites& Placed; ///< the bites so far
  Box2 Reach;    ///< the box of the domain, and what rounding may add to it
  BiteGrid Grid;
  Bisectors Points; ///< where bites may sit, with Placement::Bisectors
  CandidateQueue Queue;
  EdgeDivider Divider;
  DivisionPoints Division;            ///< of the edge at hand
  BiteOutline Outline;                ///< of the bite at hand
  VertexAxes Axes;                    ///< of the bites of input vertices, which come first
  std::vector<double> PlacedSpacings; ///< f at each bite, where reaches follow its slope
  std::vector<Id> Seen;               ///< per bite: the last bite whose outline it was asked for
  Id NumberOfBites = 0;
  Id NumberOfChecked = 0; ///< bites that have nothing left over, from the first
};

double UsedBitingConstant(const BitingOptions& options)
{
  return options.BitingConstant > 0.0 ? options.BitingConstant : AutomaticBitingConstant(options);
}

double UsedTolerance(const BitingOptions& options)
{
  return options.Tolerance > 0.0 ? options.Tolerance : AutomaticTolerance(options);
}

// The wanted length of edges, in units of f.
double UsedPartLength(const BitingOptions& options)
{
  return options.PartLength > 0.0 ? options.PartLength
                                  : UsedBitingConstant(options) / AutomaticBitingConstant(options);
}

// How far the grid finds neighbours: as far as the placement asks for them.
double NearReach(const BitingOptions& options)
{
  return options.Placement == Placement::Corners
    ? 0.0
    : Bisectors::GreatestBond * UsedPartLength(options) / UsedBitingConstant(options);
}

// How near centres on one edge may be, in half-widths.
double LeastPart(const BitingOptions& options)
{
  const double tolerance = UsedTolerance(options);
  const bool isExact = options.Placement == Placement::Corners || tolerance == 1.0;
  const double balanced =
    EdgeDivider::BalancedPart * UsedPartLength(options) / UsedBitingConstant(options);
  return isExact ? EdgeDivider::LeastPart : std::min(balanced, tolerance * EdgeDivider::LeastPart);
}

// For circles: one bite a vertex.
VertexAxes WithoutAxes(Id numberOfVertices)
{
  VertexAxes none;
  none.Axes.resize(numberOfVertices);
  none.Offsets.resize(static_cast<std::size_t>(numberOfVertices) + 1);
  std::iota(none.Offsets.begin(), none.Offsets.end(), 0);
  return none;
}

BitingRun::BitingRun(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
  double expectedVertices, const BitingOptions& options, Monitor& monitor)
  : Geometry(domain)
  , Locator(locator)
  , F(spacing)
  , Options(options)
  , Progress(monitor)
  , BitingConstant(UsedBitingConstant(options))
  , PartLength(UsedPartLength(options))
  , ExpectedVertices(expectedVertices)
  , IsUniform(spacing.IsUniform())
  , Placed(Result.Bites)
  , Reach(domain.Bounds)
  , Grid(Result.Bites, domain.Bounds, expectedVertices - domain.NumberOfVertices(),
      NearReach(options), domain.Resolution)
  , Points(
      Result.Bites, Grid, PartLength / BitingConstant, UsedTolerance(options), domain.Resolution)
  , Queue(options.Order)
  , Divider(spacing, BitingConstant, PartLength, Progress, LeastPart(options))
{
  this->Reach.Grow(domain.Resolution);
}

BitingResult BitingRun::Run()
{
  this->CopyDomain(this->ExpectedVertices);
  this->ProtectVertices();
  if (this->Options.PreserveBoundary)
  {
    this->ShieldEdges();
  }
  else
  {
    this->ProtectEdges();
  }
  this->SeedFront();
  this->BiteInterior();
  const bool isStopped = this->Result.End == BitingEnd::Complete && !this->MayBite();
  if (this->Options.KeepFront && isStopped)
  {
    this->Result.Front =
      TraceFront(this->Geometry, this->Locator, this->Placed, this->Grid, this->Progress);
    this->Step();
  }
  this->Grid.Release(this->Progress);
  ReleaseInSteps(this->Progress, this->Seen, this->PlacedSpacings);
  return std::move(this->Result);
}

void BitingRun::CopyDomain(double expectedVertices)
{
  const std::size_t expected = static_cast<std::size_t>(1.25 * expectedVertices) + 16;
  this->Result.Points.reserve(expected);
  this->Result.Spacings.reserve(expected);
  this->Placed.Centers.reserve(expected);
  this->Placed.Axes.reserve(expected);
  this->Placed.HalfWidths.reserve(expected);
  for (const Point2& vertex : this->Geometry.Vertices)
  {
    this->AddVertex(vertex, this->F(vertex), NoId);
    this->Step();
  }
}

void BitingRun::ProtectVertices()
{
  this->Axes = this->Options.Shape == BiteShape::Circle
    ? WithoutAxes(this->Geometry.NumberOfVertices())
    : OrientVertexBites(this->Geometry, this->Progress);
  for (Id vertex = 0; vertex < this->Geometry.NumberOfVertices() && this->MayBite(); ++vertex)
  {
    for (Id k = this->Axes.Offsets[vertex]; k < this->Axes.Offsets[vertex + 1]; ++k)
    {
      this->Bite(vertex, this->Axes.Axes[k], 1.0, BitePhase::VertexProtection);
    }
    ++this->NumberOfBites;
    this->Advance();
  }
}

// Where biting stops before, the edges that are left stay undivided.
void BitingRun::ProtectEdges()
{
  const SharpCorners corners(this->Geometry, this->F, this->PartLength,
    static_cast<Id>(this->Options.MaximumNumberOfVertices), this->Progress);
  for (Id segment = 0; segment < this->Geometry.NumberOfSegments(); ++segment)
  {
    if (this->MayBite())
    {
      this->ProtectEdge(segment, corners);
    }
    else
    {
      this->AddEdge(this->Geometry.Starts[segment], this->Geometry.Ends[segment], segment);
    }
  }
}

void BitingRun::ProtectEdge(Id segment, const SharpCorners& corners)
{
  const Id start = this->Geometry.Starts[segment];
  const Id end = this->Geometry.Ends[segment];
  const Point2 a = this->Geometry.Vertices[start];
  const Point2 b = this->Geometry.Vertices[end];
  const auto limit = this->Options.MaximumNumberOfVertices - this->Result.Points.size();
  if (!this->Divider.Divide(
        a, b, corners.ShellsOn(segment), static_cast<Id>(limit), this->Division))
  {
    this->Result.End = this->ReasonNotToDivide();
    return;
  }
  const Point2 axis = 1.0 / Distance(a, b) * (b - a);
  Id last = start;
  for (std::size_t k = 0; k < this->Division.Parameters.size() && this->MayBite(); ++k)
  {
    const double spacing = this->Division.Spacings[k];
    const Point2 place = PointOnSegment(a, b, this->Division.Parameters[k], spacing);
    const Id vertex = this->AddVertex(place, spacing, segment);
    this->Bite(vertex, axis, 1.0, BitePhase::EdgeProtection);
    ++this->NumberOfBites;
    this->AddEdge(last, vertex, segment);
    last = vertex;
    this->Advance();
  }
  this->AddEdge(last, end, segment);
}

// Instead of vertices on the edges, squares that make none, one for each part of an edge. Their size
// follows f as that of bites does, so that they hide little of what is behind the edges, and the
// front rises from the ends of a long edge as f does.
void BitingRun::ShieldEdges()
{
  EdgeDivider divider(this->F, LeastShieldLength * this->BitingConstant,
    ShieldLength * this->BitingConstant, this->Progress);
  for (Id segment = 0; segment < this->Geometry.NumberOfSegments(); ++segment)
  {
    this->AddEdge(this->Geometry.Starts[segment], this->Geometry.Ends[segment], segment);
    if (this->MayBite())
    {
      this->ShieldEdge(segment, divider);
    }
  }
}

void BitingRun::ShieldEdge(Id segment, EdgeDivider& divider)
{
  const Point2& a = this->Geometry.Vertices[this->Geometry.Starts[segment]];
  const Point2& b = this->Geometry.Vertices[this->Geometry.Ends[segment]];
  const std::int64_t limit =
    std::max(this->Options.MaximumNumberOfVertices, FewShields) - this->Placed.Size();
  if (!divider.Divide(a, b, static_cast<Id>(std::max<std::int64_t>(limit, 0)), this->Division))
  {
    this->Result.End = this->ReasonNotToDivide();
    return;
  }
  // Where f is steep, rounding may exchange neighbours.
  this->Division.Parameters.push_back(1.0);
  double last = 0.0;
  for (const double parameter : this->Division.Parameters)
  {
    if (parameter > last)
    {
      this->ShieldPart(segment, last, parameter);
      last = parameter;
    }
  }
}

void BitingRun::ShieldPart(Id segment, double from, double to)
{
  const Point2& a = this->Geometry.Vertices[this->Geometry.Starts[segment]];
  const Point2& b = this->Geometry.Vertices[this->Geometry.Ends[segment]];
  const double length = Distance(a, b);
  const double halfWidth = 0.5 * ShieldOverlap * (to - from) * length;
  const Point2 center = a + 0.5 * (from + to) * (b - a);
  const Point2 axis = 1.0 / length * (b - a);
  if (this->MayBite() && !this->IsHeld(segment, center, halfWidth * axis))
  {
    this->AddBite(center, axis, halfWidth, this->F(center), BitePhase::EdgeProtection);
    ++this->NumberOfBites;
    this->Advance();
  }
}

// Whether the bites of the segment's ends cover the square about `center` that reaches `along` to
// the middle of a side: each half of it lies in one of them.
bool BitingRun::IsHeld(Id segment, const Point2& center, const Point2& along) const
{
  const Point2 across = Perpendicular(along);
  const Id start = this->Geometry.Starts[segment];
  const Id end = this->Geometry.Ends[segment];
  const auto isHeld = [this, &center, &across, start, end](const Point2& side)
  {
    return this->IsWithinBite(side, center, start, across) ||
      this->IsWithinBite(side, center, end, across);
  };
  return isHeld(center - along) && isHeld(center + along);
}

// Whether the rectangle about the line from `first` to `last`, reaching `across` to both sides, lies
// in one of the squares of an input vertex.
bool BitingRun::IsWithinBite(
  const Point2& first, const Point2& last, Id vertex, const Point2& across) const
{
  const Point2 corners[4] = { first + across, first - across, last + across, last - across };
  for (Id bite = this->Axes.Offsets[vertex]; bite < this->Axes.Offsets[vertex + 1]; ++bite)
  {
    const auto isInside = [this, bite](const Point2& p)
    { return Depth(this->Placed, bite, p) >= 0.0; };
    if (std::all_of(std::begin(corners), std::end(corners), isInside))
    {
      return true;
    }
  }
  return false;
}

// Once all of the boundary is bitten: most corners of its bites are covered by then.
void BitingRun::SeedFront()
{
  for (Id bite = 0; bite < this->Placed.Size() && this->Result.End == BitingEnd::Complete; ++bite)
  {
    this->PutCandidates(bite);
    this->Step();
  }
}

void BitingRun::BiteInterior()
{
  while (this->MayBite() && (!this->Queue.IsEmpty() || this->PutLeftOvers()))
  {
    this->BiteCandidate(this->Queue.Take());
    this->Step();
  }
}

void BitingRun::BiteCandidate(const Candidate& candidate)
{
  if (!this->IsUncovered(candidate))
  {
    return;
  }
  const Id vertex = this->AddVertex(candidate.Place, this->F(candidate.Place), NoId);
  this->Bite(
    vertex, this->AxisOf(candidate), this->ReachOf(candidate, vertex), BitePhase::Interior);
  ++this->NumberOfBites;
  this->PutCandidates(this->Placed.Size() - 1);
  this->Advance();
}

// The bond of the two bites that the candidate stands on.
Point2 BitingRun::AxisOf(const Candidate& candidate) const
{
  if (candidate.Parents[0] == NoId)
  {
    return { 1.0, 0.0 };
  }
  const Point2 bond =
    this->Placed.Centers[candidate.Parents[1]] - this->Placed.Centers[candidate.Parents[0]];
  return 1.0 / Length(bond) * bond;
}

// The half-width of the bite at the candidate, in units of c_b f.
double BitingRun::ReachOf(const Candidate& candidate, Id vertex) const
{
  if (!this->Options.FollowSlope || candidate.Parents[0] == NoId)
  {
    return 1.0;
  }
  const Id left = candidate.Parents[0];
  const Id right = candidate.Parents[1];
  return ReachFactor(this->Options.Shape, this->Options.Order,
    { this->Placed.Centers[left], this->Placed.Centers[right], candidate.Place,
      this->PlacedSpacings[left], this->PlacedSpacings[right], this->Result.Spacings[vertex] });
}

Id BitingRun::AddVertex(const Point2& place, double spacing, Id segment)
{
  this->Result.Points.push_back(place);
  this->Result.Spacings.push_back(spacing);
  this->Result.BiteOrders.push_back(NoId);
  this->Result.Segments.push_back(segment);
  return static_cast<Id>(this->Result.Points.size()) - 1;
}

void BitingRun::AddEdge(Id start, Id end, Id segment)
{
  this->Result.EdgeStarts.push_back(start);
  this->Result.EdgeEnds.push_back(end);
  this->Result.EdgeSegments.push_back(segment);
}

// A bite of half-width `reach` c_b f.
void BitingRun::Bite(Id vertex, const Point2& axis, double reach, BitePhase phase)
{
  const double spacing = this->Result.Spacings[vertex];
  this->AddBite(this->Result.Points[vertex],
    this->Options.Shape == BiteShape::Circle ? Point2{} : axis,
    reach * this->BitingConstant * spacing, spacing, phase);
  this->Result.BiteOrders[vertex] = this->NumberOfBites;
}

void BitingRun::AddBite(
  const Point2& center, const Point2& axis, double halfWidth, double spacing, BitePhase phase)
{
  const Id bite = this->Placed.Size();
  this->Placed.Centers.push_back(center);
  this->Placed.Axes.push_back(axis);
  this->Placed.HalfWidths.push_back(halfWidth);
  this->Placed.Orders.push_back(this->NumberOfBites);
  this->Placed.Phases.push_back(phase);
  this->Seen.push_back(NoId);
  if (this->Options.FollowSlope)
  {
    this->PlacedSpacings.push_back(spacing);
  }
  this->Grid.File(bite);
}

void BitingRun::PutCandidates(Id bite)
{
  if (this->Options.Placement == Placement::Corners)
  {
    this->PutFrontVertices(bite);
  }
  else
  {
    this->PutBisectorPoints(bite);
  }
}

void BitingRun::PutBisectorPoints(Id bite)
{
  const Id newest = this->Placed.Size() - 1;
  this->Points.VisitPoints(bite,
    [this, bite, newest](const BisectorPoint& point)
    {
      this->Queue.Put({ this->PlaceOf(bite, point), newest, { bite, point.Neighbor },
        this->Queue.ClassOf(point.Misfit) });
    });
}

// Squares go where f asks for them, unless one of the two bites covers that; circles are made larger
// or smaller instead (ReachFactor.h).
Point2 BitingRun::PlaceOf(Id bite, const BisectorPoint& point) const
{
  if (!this->Options.FollowSlope || this->Options.Shape != BiteShape::Square)
  {
    return point.Place;
  }
  const Id other = point.Neighbor;
  const double left = this->PlacedSpacings[bite];
  const double right = this->PlacedSpacings[other];
  const double reach = (this->Placed.HalfWidths[bite] + this->Placed.HalfWidths[other]) /
    (this->BitingConstant * (left + right));
  const Point2 top =
    BalancedTop({ this->Placed.Centers[bite], this->Placed.Centers[other], point.Place, left, right,
                  this->IsUniform ? left : this->F(point.Place) },
      reach * this->PartLength);
  const bool isCovered =
    this->Points.IsCoveredBy(bite, top) || this->Points.IsCoveredBy(other, top);
  return isCovered ? point.Place : top;
}

// The vertices of the front on bites that are not all covered, once there are no other candidates.
// All bites are looked at once: a vertex that another bite makes later is one of that bite too.
bool BitingRun::PutLeftOvers()
{
  const bool isLastResort = this->Options.Placement != Placement::Corners;
  while (isLastResort && this->Queue.IsEmpty() && this->NumberOfChecked < this->Placed.Size() &&
    this->MayBite())
  {
    const Id bite = this->NumberOfChecked++;
    if (!this->IsEnclosed(bite))
    {
      this->PutFrontVertices(bite);
    }
    this->Step();
  }
  return !this->Queue.IsEmpty();
}

// Whether other bites cover the bite's outline, as far as a cheap test can tell: mostly the nearest
// ones do.
bool BitingRun::IsEnclosed(Id bite) const
{
  if (this->IsRinged(bite))
  {
    return true;
  }
  OutlineCover cover(this->Placed, bite);
  for (const double reach : { NearReach(this->Options), GreatestReach })
  {
    int looked = 0;
    this->Grid.VisitNear(this->Placed.Centers[bite], reach,
      [bite, &cover, &looked](Id other)
      {
        if (other != bite)
        {
          cover.Cover(other);
        }
        return ++looked == LeastCrowd || cover.IsFull();
      });
    if (cover.IsFull())
    {
      return true;
    }
  }
  return false;
}

// Whether a cheaper test can tell.
bool BitingRun::IsRinged(Id bite) const
{
  RingCover ring(this->Placed, bite);
  int looked = 0;
  this->Grid.VisitNear(this->Placed.Centers[bite], NearReach(this->Options),
    [bite, &ring, &looked](Id other)
    {
      if (other != bite)
      {
        ring.Cover(other);
      }
      return ++looked == LeastCrowd;
    });
  return ring.IsFull();
}

// The vertices of the front that the bite makes: its uncovered corners, and where the sides of other
// bites cross its own.
void BitingRun::PutFrontVertices(Id bite)
{
  this->Outline.Begin(this->Placed, bite);
  const Point2 center = this->Placed.Centers[bite];
  const Point2 axis = this->Placed.Axes[bite];
  const double spread = this->Placed.IsCircle(bite) ? 1.0 : std::abs(axis.X) + std::abs(axis.Y);
  const double reach = this->Placed.HalfWidths[bite] * spread;
  this->Seen[bite] = bite;
  if (this->IsHidden(bite, reach))
  {
    return;
  }
  Box2 box;
  box.Add(center);
  box.Grow(reach);
  const bool isClear = this->Locator.IsClear(box);
  const Id newest = this->Placed.Size() - 1;
  this->Outline.VisitEnds(
    [this, isClear, newest](const Point2& place)
    {
      if (isClear || this->Locator.IsInside(place))
      {
        this->Queue.Put({ place, newest, { NoId, NoId }, 0 });
      }
    });
}

// Finds the gaps of the bite's outline. Where bites are crowded, some of them hide it as well as all
// do, and there is nothing of it within the domain, whatever is left to look at.
bool BitingRun::IsHidden(Id bite, double reach)
{
  const Point2& center = this->Placed.Centers[bite];
  int looked = 0;
  const auto makesCrowd = [this, bite, &looked](Id other)
  {
    looked += this->Look(bite, other) ? 1 : 0;
    return looked == LeastCrowd;
  };
  if (this->Grid.VisitSquare(center, reach, makesCrowd))
  {
    do
    {
      this->Outline.Finish();
      if (this->Outline.IsHiddenWithin(this->Reach))
      {
        return true;
      }
    } while (this->HideGaps(bite));
    this->Grid.VisitSquare(center, reach,
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
bool BitingRun::HideGaps(Id bite)
{
  for (int side = 0; side < 4; ++side)
  {
    for (const BiteOutline::Interval& gap : this->Outline.Gaps(side))
    {
      const BiteOutline::Interval part = this->Outline.PartWithin(side, gap, this->Reach);
      const Point2 middle = this->Outline.At(side, 0.5 * (part.Low + part.High));
      const auto hides = [this, bite, &middle](Id other)
      { return Depth(this->Placed, other, middle) > 0.0 && this->Look(bite, other); };
      const Id deepest = this->Grid.DeepestOfLeaf(middle);
      if (part.Low < part.High && !(deepest != NoId && hides(deepest)) &&
        !this->Grid.VisitLeaf(middle, hides))
      {
        return false;
      }
    }
  }
  return true;
}

// Takes away what `other` covers, unless it has been asked before.
bool BitingRun::Look(Id bite, Id other)
{
  if (this->Seen[other] == bite)
  {
    return false;
  }
  this->Seen[other] = bite;
  this->Outline.Cover(this->Placed, other);
  return true;
}

// Against the bites since the candidate's birth first: most candidates end there.
bool BitingRun::IsUncovered(const Candidate& candidate) const
{
  if (candidate.Parents[0] != NoId)
  {
    return !this->Points.IsCovered(candidate.Place) && this->Locator.IsInside(candidate.Place);
  }
  bool isCovered = false;
  this->Grid.VisitLeaf(candidate.Place,
    [this, &candidate, &isCovered](Id bite)
    {
      isCovered =
        bite > candidate.Birth && Depth(this->Placed, bite, candidate.Place) > this->Slack(bite);
      return isCovered || bite <= candidate.Birth;
    });
  return !isCovered && !this->IsSurrounded(candidate.Place);
}

bool BitingRun::IsSurrounded(const Point2& p) const
{
  DirectionMask mask;
  this->Grid.VisitLeaf(p,
    [this, &p, &mask](Id bite)
    {
      mask.Add(this->Placed, bite, p, this->Slack(bite));
      return mask.IsFull();
    });
  return mask.IsFull();
}

double BitingRun::Slack(Id bite) const
{
  const double halfWidth = this->Placed.HalfWidths[bite];
  return TieTolerance * halfWidth + std::min(this->Geometry.Resolution, GreatestSlack * halfWidth);
}

bool BitingRun::MayBite() const
{
  const std::int64_t most = this->Options.MaximumNumberOfBites;
  return this->Result.End == BitingEnd::Complete && (most < 0 || this->NumberOfBites < most);
}

void BitingRun::Advance()
{
  if (static_cast<std::int64_t>(this->Result.Points.size()) > this->Options.MaximumNumberOfVertices)
  {
    this->Result.End = BitingEnd::TooManyVertices;
  }
  this->Step();
}

void BitingRun::Step()
{
  this->Progress.SetFraction(std::min(this->NumberOfBites / this->ExpectedVertices, 1.0));
  if (!this->Progress.Beat(CheapStepsPerBite))
  {
    this->Result.End = BitingEnd::Aborted;
  }
}

BitingEnd BitingRun::ReasonNotToDivide() const
{
  return this->Progress.HasStopped() ? BitingEnd::Aborted : BitingEnd::TooManyVertices;
}

} // namespace

double AutomaticBitingConstant(const BitingOptions& options)
{
  const bool isCircle = options.Shape == BiteShape::Circle;
  if (options.Placement == Placement::Bisectors)
  {
    return isCircle ? CircleBisectorConstant : SquareBisectorConstant;
  }
  const bool isSweep = options.Order == FrontOrder::LargestY;
  const double square = isSweep ? SquareCornerSweepConstant : SquareCornerConstant;
  return isCircle ? CircleCornerConstant : square;
}

double AutomaticTolerance(const BitingOptions& options)
{
  if (options.Placement == Placement::Corners)
  {
    return 1.0;
  }
  return options.Shape == BiteShape::Circle ? CircleTolerance : SquareTolerance;
}

double EstimateNumberOfVertices(double integratedDensity, const BitingOptions& options)
{
  const double length = UsedBitingConstant(options) / AutomaticBitingConstant(options);
  return VerticesPerDensity * integratedDensity / (length * length);
}

BitingResult BiteDomain(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
  double expectedVertices, const BitingOptions& options, Monitor& monitor)
{
  return BitingRun(domain, locator, spacing, expectedVertices, options, monitor).Run();
}

} // namespace biting
