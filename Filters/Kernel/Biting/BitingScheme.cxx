// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BitingScheme.h"

#include "BiteGrid.h"
#include "BiteOutline.h"
#include "EdgeDivision.h"
#include "FrontTrace.h"
#include "Orientation.h"

#include <algorithm> // for min

namespace biting
{

namespace
{

// Mean edge length / (f c_b) of the raw mesh, and vertices per integral of 1/(c_b f)^2, measured
// over uniform and graded fields; see Testing/Benchmark.
constexpr double LayersLength = 1.0 / 0.77;
constexpr double SweepLength = 1.0 / 0.80;
constexpr double VerticesPerDensity = 0.72;

constexpr double TieTolerance = 1e-12; // of a half-width: a point this near a side lies on it
constexpr Id AdvanceInterval = 1000;
constexpr int LeastCrowd = 64; // more bites than overlap where f follows the domain

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
  void ProtectEdge(Id segment);
  void SeedFront();
  void BiteInterior();
  void BiteCandidate(const Candidate& candidate);
  Id AddVertex(const Point2& place, double spacing, Id segment);
  void AddEdge(Id start, Id end, Id segment);
  void Bite(Id vertex, const Point2& axis, BitePhase phase);
  void PutCandidates(Id bite);
  bool IsHidden(Id bite, double reach);
  bool HideGaps(Id bite);
  bool Look(Id bite, Id other);
  bool IsUncovered(const Candidate& candidate) const;
  bool IsSurrounded(const Point2& p) const;
  double Slack(Id bite) const;
  bool MayBite() const;
  void Advance();
  void AdvanceSometimes(Id steps);

  const Domain& Geometry;
  const DomainLocator& Locator;
  const Spacing& F;
  const BitingOptions& Options;
  Monitor& Progress;
  double BitingConstant;
  double PartLength; ///< wanted length of boundary edges in units of f
  double ExpectedVertices;
  BitingResult Result;
  Bites& Squares;
  Box2 Reach; ///< the box of the domain, and what rounding may add to it
  BiteGrid Grid;
  CandidateQueue Queue;
  EdgeDivider Divider;
  DivisionPoints Division; ///< of the edge at hand
  BiteOutline Outline;     ///< of the bite at hand
  std::vector<Id> Seen;    ///< per bite: the last bite whose outline it was asked for
  Id NumberOfBites = 0;
};

double LengthPerBitingConstant(FrontOrder order)
{
  return order == FrontOrder::Layers ? LayersLength : SweepLength;
}

double UsedBitingConstant(const BitingOptions& options)
{
  return options.BitingConstant > 0.0 ? options.BitingConstant
                                      : AutomaticBitingConstant(options.Order);
}

BitingRun::BitingRun(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
  double expectedVertices, const BitingOptions& options, Monitor& monitor)
  : Geometry(domain)
  , Locator(locator)
  , F(spacing)
  , Options(options)
  , Progress(monitor)
  , BitingConstant(UsedBitingConstant(options))
  , PartLength(options.PartLength > 0.0 ? options.PartLength
                                        : BitingConstant * LengthPerBitingConstant(options.Order))
  , ExpectedVertices(expectedVertices)
  , Squares(Result.Bites)
  , Reach(domain.Bounds)
  , Grid(Result.Bites, domain.Bounds, expectedVertices - domain.NumberOfVertices())
  , Queue(options.Order)
  , Divider(spacing, BitingConstant, PartLength)
{
  this->Reach.Grow(domain.Resolution);
}

BitingResult BitingRun::Run()
{
  this->CopyDomain(this->ExpectedVertices);
  this->ProtectVertices();
  this->ProtectEdges();
  this->SeedFront();
  this->BiteInterior();
  const bool isStopped = this->Result.End == BitingEnd::Complete && !this->MayBite();
  if (this->Options.KeepFront && isStopped)
  {
    this->Result.Front = TraceFront(this->Geometry, this->Locator, this->Squares, this->Grid);
  }
  return std::move(this->Result);
}

void BitingRun::CopyDomain(double expectedVertices)
{
  const std::size_t expected = static_cast<std::size_t>(1.05 * expectedVertices) + 16;
  this->Result.Points.reserve(expected);
  this->Result.Spacings.reserve(expected);
  this->Squares.Centers.reserve(expected);
  this->Squares.Axes.reserve(expected);
  this->Squares.HalfWidths.reserve(expected);
  for (const Point2& vertex : this->Geometry.Vertices)
  {
    this->AddVertex(vertex, this->F(vertex), NoId);
  }
}

void BitingRun::ProtectVertices()
{
  const VertexAxes axes = OrientVertexBites(this->Geometry);
  for (Id vertex = 0; vertex < this->Geometry.NumberOfVertices() && this->MayBite(); ++vertex)
  {
    for (Id k = axes.Offsets[vertex]; k < axes.Offsets[vertex + 1]; ++k)
    {
      this->Bite(vertex, axes.Axes[k], BitePhase::VertexProtection);
    }
    ++this->NumberOfBites;
    this->Advance();
  }
}

// Where biting stops before, the edges that are left stay undivided.
void BitingRun::ProtectEdges()
{
  for (Id segment = 0; segment < this->Geometry.NumberOfSegments(); ++segment)
  {
    if (this->MayBite())
    {
      this->ProtectEdge(segment);
    }
    else
    {
      this->AddEdge(this->Geometry.Starts[segment], this->Geometry.Ends[segment], segment);
    }
  }
}

void BitingRun::ProtectEdge(Id segment)
{
  const Id start = this->Geometry.Starts[segment];
  const Id end = this->Geometry.Ends[segment];
  const Point2 a = this->Geometry.Vertices[start];
  const Point2 b = this->Geometry.Vertices[end];
  const auto limit = this->Options.MaximumNumberOfVertices - this->Result.Points.size();
  if (!this->Divider.Divide(a, b, static_cast<Id>(limit), this->Division))
  {
    this->Result.End = BitingEnd::TooManyVertices;
    return;
  }
  const Point2 axis = 1.0 / Distance(a, b) * (b - a);
  Id last = start;
  for (std::size_t k = 0; k < this->Division.Parameters.size() && this->MayBite(); ++k)
  {
    const Point2 place = a + this->Division.Parameters[k] * (b - a);
    const Id vertex = this->AddVertex(place, this->Division.Spacings[k], segment);
    this->Bite(vertex, axis, BitePhase::EdgeProtection);
    ++this->NumberOfBites;
    this->AddEdge(last, vertex, segment);
    last = vertex;
    this->Advance();
  }
  this->AddEdge(last, end, segment);
}

// Once all of the boundary is bitten: most corners of its bites are covered by then.
void BitingRun::SeedFront()
{
  for (Id bite = 0; bite < this->Squares.Size() && this->Result.End == BitingEnd::Complete; ++bite)
  {
    this->PutCandidates(bite);
    this->AdvanceSometimes(bite);
  }
}

void BitingRun::BiteInterior()
{
  while (!this->Queue.IsEmpty() && this->MayBite())
  {
    this->BiteCandidate(this->Queue.Take());
  }
}

void BitingRun::BiteCandidate(const Candidate& candidate)
{
  if (!this->IsUncovered(candidate))
  {
    return;
  }
  const Id vertex = this->AddVertex(candidate.Place, this->F(candidate.Place), NoId);
  this->Bite(vertex, { 1.0, 0.0 }, BitePhase::Interior);
  ++this->NumberOfBites;
  this->PutCandidates(this->Squares.Size() - 1);
  this->Advance();
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

void BitingRun::Bite(Id vertex, const Point2& axis, BitePhase phase)
{
  const Id bite = this->Squares.Size();
  this->Squares.Centers.push_back(this->Result.Points[vertex]);
  this->Squares.Axes.push_back(axis);
  this->Squares.HalfWidths.push_back(this->BitingConstant * this->Result.Spacings[vertex]);
  this->Squares.Orders.push_back(this->NumberOfBites);
  this->Squares.Phases.push_back(phase);
  this->Result.BiteOrders[vertex] = this->NumberOfBites;
  this->Seen.push_back(NoId);
  this->Grid.File(bite);
}

// The vertices of the front that the bite makes: its uncovered corners, and where the sides of other
// bites cross its own.
void BitingRun::PutCandidates(Id bite)
{
  this->Outline.Begin(this->Squares, bite);
  const Point2 center = this->Squares.Centers[bite];
  const Point2 axis = this->Squares.Axes[bite];
  const double reach = this->Squares.HalfWidths[bite] * (std::abs(axis.X) + std::abs(axis.Y));
  this->Seen[bite] = bite;
  if (this->IsHidden(bite, reach))
  {
    return;
  }
  Box2 box;
  box.Add(center);
  box.Grow(reach);
  const bool isClear = this->Locator.IsClear(box);
  const Id newest = this->Squares.Size() - 1;
  this->Outline.VisitEnds(
    [this, isClear, newest](const Point2& place)
    {
      if (isClear || this->Locator.IsInside(place))
      {
        this->Queue.Put({ place, newest });
      }
    });
}

// Finds the gaps of the bite's outline. Where bites are crowded, some of them hide it as well as all
// do, and there is nothing of it within the domain, whatever is left to look at.
bool BitingRun::IsHidden(Id bite, double reach)
{
  const Point2& center = this->Squares.Centers[bite];
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
      { return Depth(this->Squares, other, middle) > 0.0 && this->Look(bite, other); };
      if (part.Low < part.High && !this->Grid.VisitLeaf(middle, hides))
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
  this->Outline.Cover(this->Squares, other);
  return true;
}

// Against the bites since the candidate's birth first: most candidates end there.
bool BitingRun::IsUncovered(const Candidate& candidate) const
{
  bool isCovered = false;
  this->Grid.VisitLeaf(candidate.Place,
    [this, &candidate, &isCovered](Id bite)
    {
      isCovered =
        bite > candidate.Birth && Depth(this->Squares, bite, candidate.Place) > this->Slack(bite);
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
      mask.Add(this->Squares, bite, p, this->Slack(bite));
      return mask.IsFull();
    });
  return mask.IsFull();
}

double BitingRun::Slack(Id bite) const
{
  return TieTolerance * this->Squares.HalfWidths[bite] + this->Geometry.Resolution;
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
  this->AdvanceSometimes(this->NumberOfBites);
}

void BitingRun::AdvanceSometimes(Id steps)
{
  const double done = this->NumberOfBites / this->ExpectedVertices;
  if (steps % AdvanceInterval == 0 && !this->Progress.Advance(std::min(done, 1.0)))
  {
    this->Result.End = BitingEnd::Aborted;
  }
}

} // namespace

double AutomaticBitingConstant(FrontOrder order)
{
  return 1.0 / LengthPerBitingConstant(order);
}

double EstimateNumberOfVertices(double integratedDensity, const BitingOptions& options)
{
  const double bitingConstant = UsedBitingConstant(options);
  return VerticesPerDensity * integratedDensity / (bitingConstant * bitingConstant);
}

BitingResult BiteDomain(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
  double expectedVertices, const BitingOptions& options, Monitor& monitor)
{
  return BitingRun(domain, locator, spacing, expectedVertices, options, monitor).Run();
}

} // namespace biting
