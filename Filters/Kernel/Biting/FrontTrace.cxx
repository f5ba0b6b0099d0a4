// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FrontTrace.h"

#include "Bisectors.h" // for InsideOf
#include "BiteOutline.h"

#include <algorithm> // for max, min, sort
#include <cmath>     // for ceil
#include <utility>   // for pair

namespace biting
{

namespace
{

// Squares are seen a little larger, so that those side by side leave nothing between them; the
// older the larger, so that of two sides that coincide the older one is seen.
constexpr double GrowthOfOlder = 1.0 + 4e-9;
constexpr double GrowthOfTraced = 1.0 + 2e-9;
constexpr double GrowthOfNewer = 1.0 + 1e-9;
constexpr double ChordsPerHalfSide = 4.0;
constexpr double LeastPiece = 1e-8; // of a bite's half-width: shorter pieces are rounding

class FrontTracer
{
public:
  FrontTracer(const Domain& domain, const DomainLocator& locator, const Bites& bites,
    const BiteGrid& grid, Pulse& pulse)
    : Geometry(domain)
    , Locator(locator)
    , Squares(bites)
    , Grid(grid)
    , Beats(pulse)
  {
    for (double& halfWidth : this->Squares.HalfWidths)
    {
      halfWidth *= GrowthOfNewer;
    }
  }

  /// To be called for all bites, in their order.
  void TraceBite(Id bite);
  void TraceSegment(Id segment);

  std::vector<Point2> Pieces;

private:
  using Interval = std::pair<double, double>;

  void TraceGap(int side, const BiteOutline::Interval& gap, double chord);
  void KeepInside(const Point2& p, const Point2& q);
  std::vector<double> BoundaryCrossings(const Point2& p, const Point2& q) const;
  Interval CoveredPart(Id bite, const Point2& a, const Point2& b) const;

  const Domain& Geometry;
  const DomainLocator& Locator;
  Bites Squares; ///< grown, by less than the margin of their filing
  const BiteGrid& Grid;
  Pulse& Beats;
  BiteOutline Outline;
};

void FrontTracer::TraceBite(Id bite)
{
  double& halfWidth = this->Squares.HalfWidths[bite];
  halfWidth *= GrowthOfTraced / GrowthOfNewer;
  this->Outline.Begin(this->Squares, bite);
  this->Grid.VisitSquare(this->Squares.Centers[bite], 1.5 * halfWidth,
    [this, bite](Id other)
    {
      if (other != bite)
      {
        this->Outline.Cover(this->Squares, other);
      }
      return false;
    });
  this->Outline.Finish();
  for (int side = 0; side < 4; ++side)
  {
    for (const BiteOutline::Interval& gap : this->Outline.Gaps(side))
    {
      if (gap.High - gap.Low > LeastPiece * halfWidth)
      {
        this->TraceGap(
          side, gap, this->Squares.IsCircle(bite) ? halfWidth / ChordsPerHalfSide : 0.0);
      }
    }
  }
  halfWidth *= GrowthOfOlder / GrowthOfTraced;
}

// In one piece, or in as many chords as are needed that none is longer than `chord` along the side.
void FrontTracer::TraceGap(int side, const BiteOutline::Interval& gap, double chord)
{
  const double length = gap.High - gap.Low;
  const int pieces = chord > 0.0 ? static_cast<int>(std::ceil(length / chord)) : 1;
  Point2 last = this->Outline.At(side, gap.Low);
  for (int k = 1; k <= pieces; ++k)
  {
    const double place = k == pieces ? gap.High : gap.Low + k * length / pieces;
    const Point2 next = this->Outline.At(side, place);
    this->KeepInside(last, next);
    last = next;
  }
}

// Cuts pq where it crosses the boundary and keeps the parts whose middle is inside.
void FrontTracer::KeepInside(const Point2& p, const Point2& q)
{
  std::vector<double> cuts = this->BoundaryCrossings(p, q);
  cuts.push_back(0.0);
  cuts.push_back(1.0);
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t k = 1; k < cuts.size(); ++k)
  {
    const Point2 middle = p + 0.5 * (cuts[k - 1] + cuts[k]) * (q - p);
    if (cuts[k] - cuts[k - 1] > LeastPiece && this->Locator.IsInside(middle))
    {
      this->Pieces.push_back(p + cuts[k - 1] * (q - p));
      this->Pieces.push_back(p + cuts[k] * (q - p));
    }
  }
}

std::vector<double> FrontTracer::BoundaryCrossings(const Point2& p, const Point2& q) const
{
  std::vector<double> crossings;
  this->Locator.VisitSegments(Box2::Around(p, q),
    [&](Id segment)
    {
      const Point2& a = this->Geometry.Vertices[this->Geometry.Starts[segment]];
      const Point2 along = this->Geometry.Vertices[this->Geometry.Ends[segment]] - a;
      const double slope = Cross(along, q - p);
      const double t = slope != 0.0 ? Cross(a - p, along) / Cross(q - p, along) : -1.0;
      const double s = slope != 0.0 ? Cross(a - p, q - p) / Cross(q - p, along) : -1.0;
      if (t > 0.0 && t < 1.0 && s >= 0.0 && s <= 1.0)
      {
        crossings.push_back(t);
      }
      return false;
    });
  return crossings;
}

void FrontTracer::TraceSegment(Id segment)
{
  const Point2& a = this->Geometry.Vertices[this->Geometry.Starts[segment]];
  const Point2& b = this->Geometry.Vertices[this->Geometry.Ends[segment]];
  std::vector<Interval> covered;
  this->Grid.VisitSquare(Midpoint(a, b), 0.5 * Distance(a, b),
    [&](Id bite)
    {
      const Interval part = this->CoveredPart(bite, a, b);
      if (part.first < part.second)
      {
        covered.push_back(part);
      }
      return !this->Beats.Beat();
    });
  covered.push_back({ 1.0, 1.0 });
  std::sort(covered.begin(), covered.end());
  double end = 0.0;
  for (const Interval& part : covered)
  {
    if (part.first - end > LeastPiece)
    {
      this->Pieces.push_back(a + end * (b - a));
      this->Pieces.push_back(a + part.first * (b - a));
    }
    end = std::max(end, part.second);
  }
}

// The parameters in [0, 1] between which ab runs inside the bite; an empty interval at 1 where it
// does not.
FrontTracer::Interval FrontTracer::CoveredPart(Id bite, const Point2& a, const Point2& b) const
{
  const Bites& bites = this->Squares;
  const auto [enter, leave] =
    InsideOf(bites.Axes[bite], bites.HalfWidths[bite], a - bites.Centers[bite], b - a);
  const Interval part{ std::max(enter, 0.0), std::min(leave, 1.0) };
  return part.first < part.second ? part : Interval{ 1.0, 1.0 };
}

} // namespace

std::vector<Point2> TraceFront(const Domain& domain, const DomainLocator& locator,
  const Bites& bites, const BiteGrid& grid, Pulse& pulse)
{
  FrontTracer tracer(domain, locator, bites, grid, pulse);
  for (Id segment = 0; segment < domain.NumberOfSegments() && pulse.Beat(); ++segment)
  {
    if (domain.IsBoundary[segment])
    {
      tracer.TraceSegment(segment);
    }
  }
  for (Id bite = 0; bite < bites.Size() && pulse.Beat(); ++bite)
  {
    pulse.SetFraction(static_cast<double>(bite) / bites.Size());
    tracer.TraceBite(bite);
  }
  return std::move(tracer.Pieces);
}

} // namespace biting
