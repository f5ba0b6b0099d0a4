// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OutsideJumps.h"

#include "../Base/Tasks.h"
#include "BorderRays.h"
#include "BorderTurns.h"

#include <algorithm> // for min, max, bounds
#include <array>     // for corners
#include <cmath>     // for ceil
#include <limits>    // for what does not overflow
#include <utility>   // for move

namespace biting
{
namespace
{

// Lengths are in units of f / g.

/// How far a jump may be from the segment that stands for it, and how much f may differ there, as a
/// share.
constexpr double LargestBend = 0.01;
constexpr double LargestMisfit = 0.01;

/// Nothing is looked for between ends that are as near as this; or as this where none is a jump.
constexpr double LastStep = 0.02;
constexpr double LastStepOfNone = 0.1;
constexpr int MostDivisions = 48;

/// From one front; some tens are usual. Where rounding makes more the rest is left as it is.
constexpr int MostRays = 10000;

/// Between places on the border that are farther apart something may be hidden from two rays.
constexpr double LargestHidden = 0.25;
constexpr int DivisionsForHidden = 3;
constexpr double LargestTurn = 1.6; ///< radians between the first two rays from a corner
constexpr std::size_t EdgesPerTask = 256;

/// Where it is looked whether other triangles lie at an edge, as shares of it.
constexpr std::array<double, 7> PlacesOnEdge{ 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99 };

bool IsStraight(const BorderRay& a, const BorderRay& middle, const BorderRay& b, double unit)
{
  const Point2 along = b.End() - a.End();
  const Point2 toMiddle = middle.End() - a.End();
  const double length = Dot(along, along);
  const double share = length > 0.0 ? Dot(toMiddle, along) / length : 0.0;
  const double room =
    std::max(LargestBend * unit, 4.0 * BorderRays::SameLength * (a.Length + b.Length));
  if (std::abs(middle.Spacing - 0.5 * (a.Spacing + b.Spacing)) > LargestMisfit * middle.Spacing)
  {
    return false;
  }
  return Length(toMiddle - std::min(std::max(share, 0.0), 1.0) * along) <= room;
}

class JumpTracer
{
public:
  JumpTracer(const TriangleInterpolator& field, const BorderTurns& turns, const Box2& bounds,
    double gradation, ConeCollector& cones, Monitor& monitor)
    : Field(field)
    , Turns(turns)
    , Bounds(bounds)
    , Corners{ bounds.Low, { bounds.High.X, bounds.Low.Y }, bounds.High,
      { bounds.Low.X, bounds.High.Y } }
    , Gradation(gradation)
    , Cones(cones)
    , Beats(monitor)
    , Rays(field, bounds, gradation, cones.Values(), this->Beats)
  {
  }

  /// Those before the edges [begin, end).
  void Run(std::size_t begin, std::size_t end)
  {
    const std::vector<BorderEdge>& edges = this->Field.BorderEdges();
    const auto count = static_cast<double>(end - begin);
    for (std::size_t k = begin; k < end && this->Beats.Beat(); ++k)
    {
      this->Beats.SetFraction(static_cast<double>(k - begin) / count);
      const BorderEdge& edge = edges[k];
      const double length = Distance(edge.Start, edge.End);
      if (this->Field.HasOverlaps() && this->IsOnOthers(edge, length))
      {
        this->AddAlong(edge); // triangles that end there lie on others, maybe along a part of it
      }
      for (const bool isLeft : { false, true })
      {
        // The border goes on from the start of an edge whose outside is on its left.
        const BorderEdge turned{ edge.End, edge.Start, edge.EndValue, edge.StartValue, edge.EndId,
          edge.StartId };
        this->AddSide(isLeft ? turned : edge, length);
      }
    }
  }

private:
  /// Whether there are triangles on both sides of a border edge, which has one of its own.
  bool IsOnOthers(const BorderEdge& edge, double length) const
  {
    const Point2 aside = BorderRays::SameLength * Perpendicular(edge.End - edge.Start);
    return length > 0.0 &&
      std::any_of(PlacesOnEdge.begin(), PlacesOnEdge.end(),
        [this, &edge, &aside](double share)
        {
          const Point2 place = edge.Start + share * (edge.End - edge.Start);
          return this->Field.Covers(place + aside) && this->Field.Covers(place - aside);
        });
  }

  /// From the lower end of a steep edge.
  void AddPerpendicular(const BorderEdge& edge, const Point2& normal)
  {
    const ValueRange& range = this->Cones.Values();
    const double length = Distance(edge.Start, edge.End);
    const bool isRising = edge.StartValue < edge.EndValue;
    const double low = range.Scale * std::min(edge.StartValue, edge.EndValue);
    const double high = range.Scale * std::max(edge.StartValue, edge.EndValue);
    if (high - low > this->Gradation * length && low < range.Most && high > range.Least)
    {
      const double weight = std::max(0.0, (range.Least - low) / (high - low));
      BorderRay ray = BorderFront{ edge, normal }.At(isRising ? weight : 1.0 - weight);
      ray.Spacing = range(ray.Value);
      this->Rays.Extend(ray, length, nullptr);
      this->Cones.AddSegment(
        ray.Foot, ray.End(), std::max(low, range.Least), std::max(low, range.Least));
    }
  }

  /// What is right of an edge, and around its end.
  void AddSide(const BorderEdge& edge, double length)
  {
    const Point2 along = (1.0 / length) * (edge.End - edge.Start);
    const Point2 normal = -1.0 * Perpendicular(along);
    if (!(length > 0.0))
    {
      return;
    }
    const Point2 aside = BorderRays::SameLength * length * normal;
    if (this->Field.Covers(Midpoint(edge.Start, edge.End) + aside))
    {
      this->AddSheet(edge, aside);
    }
    else
    {
      this->AddOutside(edge, normal, length);
    }
  }

  /// The jumps before an edge, and before its end up to the perpendicular of the next one.
  void AddOutside(const BorderEdge& edge, const Point2& normal, double length)
  {
    if (this->IsBeforeBounds(edge.Start, normal, normal))
    {
      this->AddPerpendicular(edge, normal);
      this->Sweep({ edge, normal }, length);
    }
    const double turn = this->Turns.TurnAround(edge);
    if (turn > 0.0 && this->IsBeforeBounds(edge.End, normal, BorderFront::Turned(normal, turn)))
    {
      const BorderEdge corner{ edge.End, edge.End, edge.EndValue, edge.EndValue };
      const double parts = std::ceil(turn / LargestTurn);
      for (double k = 0.0; k < parts; k += 1.0)
      {
        const double angle = turn / parts;
        this->Sweep({ corner, BorderFront::Turned(normal, k * angle), angle }, length);
      }
    }
  }

  /// Whether rays from a place in two directions, or in those between, may reach the bounds.
  bool IsBeforeBounds(const Point2& start, const Point2& a, const Point2& b) const
  {
    return std::any_of(this->Corners.begin(), this->Corners.end(),
      [&start, &a, &b](const Point2& corner)
      { return std::max(Dot(corner - start, a), Dot(corner - start, b)) > 0.0; });
  }

  /// The jumps at the ends of the rays of a front.
  void Sweep(const BorderFront& front, double likely)
  {
    this->RaysLeft = MostRays;
    const BorderRay first = this->Rays.FindEnd(front.At(0.0), likely, nullptr);
    this->Trace(front, first,
      this->Rays.FindEnd(front.At(1.0), std::max(2.0 * first.Length, likely), nullptr), 0);
  }

  /// What f is along an edge. Where values are raised to the least one, is a part of its own.
  void AddAlong(const BorderEdge& edge)
  {
    constexpr double Greatest = std::numeric_limits<double>::max();
    const ValueRange& range = this->Cones.Values();
    const double start = std::min(range.Scale * edge.StartValue, Greatest);
    const double end = std::min(range.Scale * edge.EndValue, Greatest);
    Point2 from = edge.Start;
    double value = std::max(start, range.Least);
    if (std::min(start, end) < range.Least && range.Least < std::max(start, end))
    {
      from = edge.Start + (range.Least - start) / (end - start) * (edge.End - edge.Start);
      this->Cones.AddSegment(edge.Start, from, value, range.Least);
      value = range.Least;
    }
    this->Cones.AddSegment(from, edge.End, value, std::max(end, range.Least));
  }

  /// An edge of triangles beside others that have corners of their own.
  void AddSheet(const BorderEdge& edge, const Point2& aside)
  {
    const ValueRange& range = this->Cones.Values();
    for (const double share : { 0.25, 0.75 })
    {
      const BorderRay from = BorderFront{ edge, aside }.At(share);
      if (range(this->Field(from.Foot + aside)) > (1.0 + BorderRays::LeastJump) * range(from.Value))
      {
        this->AddAlong(edge);
        return;
      }
    }
  }

  /// Whether something small may lie between two rays with one edge beyond, near that or near the
  /// border where they begin, seen by none: two balls leave so much of these.
  bool MayHide(const BorderRay& a, const BorderRay& b, const BorderEdge* far, double unit) const
  {
    const double beyond =
      far ? Distance(this->Rays.EndAt(a, far).Foot, this->Rays.EndAt(b, far).Foot) : 0.0;
    const double gap = std::max(Distance(a.Foot, b.Foot), beyond);
    return gap > LargestHidden * unit &&
      gap * gap > 8.0 * LargestBend * unit * std::min(a.Length, b.Length);
  }

  /// The jumps at the ends of the rays between two of them. Of two edges beyond, one takes the
  /// place of the other where both are as near: a ray to there sees whether something else is
  /// nearer yet.
  void Trace(const BorderFront& front, const BorderRay& a, const BorderRay& b, int divisions)
  {
    const double unit = this->Rays.UnitOf(std::min(a.Spacing, b.Spacing));
    const double step = Distance(a.End(), b.End());
    const double lengths = a.Length + b.Length;
    const bool isLast = divisions == MostDivisions || this->RaysLeft-- <= 0;
    if ((a.IsCovered && b.IsCovered) || isLast || !this->Beats.Beat(64) ||
      step <= std::max(LastStep * std::min(unit, lengths), BorderRays::SameLength * lengths))
    {
      this->AddJump(a, b);
      return;
    }
    const bool isCovered = a.IsCovered || b.IsCovered;
    const bool isBeyondA = !isCovered && this->Rays.IsBeyond(b.Far, a);
    const bool isOne = isBeyondA || (!isCovered && this->Rays.IsBeyond(a.Far, b));
    if (isOne)
    {
      const BorderEdge* far = isBeyondA ? b.Far : a.Far;
      if (divisions >= DivisionsForHidden || !this->MayHide(a, b, far, unit))
      {
        BorderRay first = a;
        BorderRay last = b;
        this->Rays.LookBeyond(first, far);
        this->Rays.LookBeyond(last, far);
        first.IsJump || last.IsJump ? this->AddArc(front, first, last, far, 0)
                                    : this->AddJump(a, b);
        return;
      }
    }
    else if (!a.IsJump && !b.IsJump && step <= LastStepOfNone * unit)
    {
      return;
    }
    const bool isHalf = isCovered || isOne;
    const BorderRay middle = isHalf ? this->Rays.FindEnd(front.At(0.5 * (a.Share + b.Share)),
                                        std::max({ a.Length, b.Length, step }), nullptr)
                                    : this->Rays.FindCrossing(front, a, b);
    if (!(a.Share < middle.Share && middle.Share < b.Share))
    {
      this->AddJump(a, b);
      return;
    }
    this->Trace(front, a, middle, divisions + 1);
    this->Trace(front, middle, b, divisions + 1);
  }

  /// Where one edge is beyond all rays between two of them.
  void AddArc(const BorderFront& front, const BorderRay& a, const BorderRay& b,
    const BorderEdge* far, int divisions)
  {
    if (!far || this->AreBeyondBounds(a.End(), b.End()))
    {
      return;
    }
    BorderRay middle = front.At(0.5 * (a.Share + b.Share));
    this->Rays.EndAtOnce(middle, far);
    const double unit = this->Rays.UnitOf(std::min(a.Spacing, b.Spacing));
    const int jumps = int(a.IsJump) + int(middle.IsJump) + int(b.IsJump);
    if (jumps == 0)
    {
      return;
    }
    if (divisions == MostDivisions || Distance(a.End(), b.End()) <= LastStep * unit ||
      (jumps == 3 && IsStraight(a, middle, b, unit)))
    {
      this->AddJump(a, b);
    }
    else
    {
      this->AddArc(front, a, middle, far, divisions + 1);
      this->AddArc(front, middle, b, far, divisions + 1);
    }
  }

  /// Both on one side, and what is between them presumably, too.
  bool AreBeyondBounds(const Point2& a, const Point2& b) const
  {
    Box2 box = Box2::Around(a, b);
    box.Grow(0.5 * box.Diagonal());
    return !this->Bounds.Meets(box);
  }

  /// Along the line between the ends of two rays, if both are at jumps.
  void AddJump(const BorderRay& a, const BorderRay& b)
  {
    if (a.IsJump && b.IsJump)
    {
      this->Cones.AddSegment(a.End(), b.End(), a.Spacing, b.Spacing);
      return;
    }
    for (const BorderRay* ray : { &a, &b })
    {
      if (ray->IsJump)
      {
        this->Cones.AddSegment(ray->End(), ray->End(), ray->Spacing, ray->Spacing);
      }
    }
  }

  const TriangleInterpolator& Field;
  const BorderTurns& Turns;
  const Box2& Bounds;
  const std::array<Point2, 4> Corners; ///< of the bounds
  const double Gradation;
  ConeCollector& Cones;
  Pulse Beats;
  BorderRays Rays;
  int RaysLeft = 0; ///< from the front at work
};

} // namespace

bool AddOutsideJumps(const TriangleInterpolator& field, const Box2& bounds, double gradation,
  ConeCollector& cones, Monitor& monitor)
{
  if (!(bounds.Diagonal() > 0.0))
  {
    return true;
  }
  Pulse pulse(monitor);
  const std::size_t edges = field.BorderEdges().size();
  const BorderTurns turns(field.BorderEdges(), pulse);
  std::vector<ConeCollector> parts(
    (edges + EdgesPerTask - 1) / EdgesPerTask, ConeCollector(cones.Values()));
  const auto trace = [&field, &turns, &bounds, gradation, edges, &parts](
                       std::size_t k, Monitor& own)
  {
    ConeCollector part(parts[k].Values());
    JumpTracer(field, turns, bounds, gradation, part, own)
      .Run(k * EdgesPerTask, std::min(edges, (k + 1) * EdgesPerTask));
    parts[k] = std::move(part);
  };
  const bool isDone = DoTasks(pulse, parts.size(), trace);
  for (const ConeCollector& part : parts)
  {
    cones.AddAll(part);
  }
  return isDone;
}

} // namespace biting
