// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OutsideJumps.h"

#include "../Base/Numbers.h"
#include "../Base/Tasks.h"
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

/// A gradation above this one counts as this one, as nobody sees such slopes on a part of f.
constexpr double LargestSeenGradation = 1.0;

/// Jumps by less than this share of f do not matter.
constexpr double LeastJump = 0.002;

/// How far ends of rays are apart at first; but no more halvings are made for that.
constexpr double StepOfFirstRays = 0.25;
constexpr int FirstHalvings = 3;
constexpr double LargestTurn = 1.6; ///< radians between the first two rays from a corner

/// How far a jump may be from the segment that stands for it, which is the border itself in narrow
/// gaps, and its end from where it was found.
constexpr double LargestBend = 0.01;
constexpr double EndPrecision = 0.003;

/// Nothing is looked for between ends that are as near as this; or as this where f is low at none.
constexpr double LastStep = 0.02;
constexpr double LastStepOfNone = 0.1;
constexpr int MostHalvings = 20;
constexpr double MostRaysOfEdge = 100.0; ///< in the mean of those of a task
constexpr std::size_t EdgesPerTask = 256;

/// Steps to the length of a ray, and the room for rounding in comparing lengths.
constexpr int LengthSteps = 32;
constexpr double GrowthOfBall = 8.0;
constexpr double SameLength = 1e-6;

/// How far an empty ball may reach over the border: shares of its radius and of coordinates.
constexpr double EmptyBall = 1e-10;
constexpr double Rounding = 1e-14;

/// A straight way from a point of the border to where that ceases to be the nearest one.
struct Ray
{
  Point2 Foot;
  double Value = 0.0; ///< given there
  Point2 Direction;
  Point2 End{};
  double Length = 0.0;
  double Spacing = 0.0;
  bool IsLow = false; ///< f is larger beyond
  Id FarStart = NoId; ///< of the edge that is nearest there
  Id FarEnd = NoId;
};

Point2 Turned(const Point2& direction, double angle)
{
  return std::cos(angle) * direction + std::sin(angle) * Perpendicular(direction);
}

Ray RayFrom(const BorderEdge& edge, double share, const Point2& direction)
{
  return { edge.Start + share * (edge.End - edge.Start),
    (1.0 - share) * edge.StartValue + share * edge.EndValue, direction };
}

bool HaveOneBeyond(const Ray& a, const Ray& b)
{
  return a.FarStart == b.FarStart && a.FarEnd == b.FarEnd;
}

bool IsStraight(const Ray& a, const Ray& middle, const Ray& b, double unit)
{
  const Point2 along = b.End - a.End;
  const Point2 toMiddle = middle.End - a.End;
  const double share = Dot(toMiddle, along) / Dot(along, along);
  const double room = std::max(LargestBend * unit, 4.0 * SameLength * (a.Length + b.Length));
  const double least = HaveOneBeyond(a, b) ? 0.0 : 0.25; // else much may be between
  return Length(toMiddle - std::min(std::max(share, least), 1.0 - least) * along) <= room;
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
    , Traced(bounds)
    , Gradation(gradation)
    , SeenGradation(std::min(gradation, LargestSeenGradation))
    , Cones(cones)
    , Beats(monitor)
  {
    this->Traced.Grow(bounds.Diagonal());
  }

  /// Those before the edges [begin, end).
  void Run(std::size_t begin, std::size_t end)
  {
    const std::vector<BorderEdge>& edges = this->Field.BorderEdges();
    const auto count = static_cast<double>(end - begin);
    this->RaysLeft = MostRaysOfEdge * count;
    for (std::size_t k = begin; k < end && this->Beats.Beat(); ++k)
    {
      this->Beats.SetFraction(static_cast<double>(k - begin) / count);
      const BorderEdge& edge = edges[k];
      if (this->Field.HasOverlaps())
      {
        this->AddAlong(edge); // triangles that end there may lie on others anywhere along it
      }
      const double length = Distance(edge.Start, edge.End);
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
  /// How far it is along a unit vector to the end of the traced box; 0 where that is behind.
  double Reach(const Point2& start, const Point2& direction) const
  {
    const auto along = [](double from, double slope, double low, double high)
    {
      const double end = slope > 0.0 ? high : low;
      return slope == 0.0 ? Infinity : (end - from) / slope;
    };
    const double reach =
      std::min(along(start.X, direction.X, this->Traced.Low.X, this->Traced.High.X),
        along(start.Y, direction.Y, this->Traced.Low.Y, this->Traced.High.Y));
    return std::isfinite(reach) ? std::max(reach, 0.0) : 0.0;
  }

  /// How far along a unit vector a point of the border stays the nearest one: a ball that touches
  /// it there shrinks until no other point is within (after Ma, Bae and Choi 2012). It begins with
  /// a `likely` length, and grows where that is too short.
  double LengthAlong(const Point2& start, const Point2& direction, double unit, double likely)
  {
    const double reach = this->Reach(start, direction);
    double length = std::min(likely, reach);
    bool isLarge = false;
    for (int step = 0; length > 0.0 && step < LengthSteps && this->Beats.Beat(64); ++step)
    {
      const NearestValue nearest =
        this->Field.NearestOfBorder(start + length * direction, { length, 0.0, start });
      const Point2 within = nearest.Foot - start;
      const double room = EmptyBall * length + Rounding * (std::abs(start.X) + std::abs(start.Y));
      const bool isEmpty = nearest.Distance >= length - room;
      if (isEmpty && (isLarge || length == reach))
      {
        return length;
      }
      const double next = isEmpty ? std::min(GrowthOfBall * length, reach)
                                  : 0.5 * Dot(within, within) / Dot(within, direction);
      if (!isEmpty && length - next <= std::max(EndPrecision * unit, SameLength * likely))
      {
        return next;
      }
      length = next;
      isLarge = !isEmpty;
    }
    return length;
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
      const Point2 start = RayFrom(edge, isRising ? weight : 1.0 - weight, normal).Foot;
      const double reach =
        this->LengthAlong(start, normal, this->UnitOf(low / range.Scale), length);
      this->Cones.AddSegment(
        start, start + reach * normal, std::max(low, range.Least), std::max(low, range.Least));
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
    const Point2 aside = SameLength * length * normal;
    if (this->Field.Nearest(Midpoint(edge.Start, edge.End) + aside).Distance == 0.0)
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
    const BorderEdge part = this->PartBeforeBounds(edge);
    if (part.Start != part.End && this->IsBeforeBounds(edge.Start, normal, normal))
    {
      this->AddPerpendicular(part, normal);
      this->Sweep(part, normal, 0.0, length);
    }
    const double turn = this->Turns.TurnAround(edge);
    if (turn > 0.0 && this->IsBeforeBounds(edge.End, normal, Turned(normal, turn)))
    {
      this->Sweep({ edge.End, edge.End, edge.EndValue, edge.EndValue }, normal, turn, length);
    }
  }

  /// Whether rays from a place in two directions, or in those between, may reach the bounds.
  bool IsBeforeBounds(const Point2& start, const Point2& a, const Point2& b) const
  {
    return std::any_of(this->Corners.begin(), this->Corners.end(),
      [&start, &a, &b](const Point2& corner)
      { return std::max(Dot(corner - start, a), Dot(corner - start, b)) > 0.0; });
  }

  /// That part of an edge whose perpendiculars meet the bounds: a point, where none does.
  BorderEdge PartBeforeBounds(const BorderEdge& edge) const
  {
    const Point2 along = edge.End - edge.Start;
    double first = 1.0;
    double last = 0.0;
    for (const Point2& corner : this->Corners)
    {
      const double share = Dot(corner - edge.Start, along) / Dot(along, along);
      first = std::min(first, std::max(share, 0.0));
      last = std::max(last, std::min(share, 1.0));
    }
    const Ray start = RayFrom(edge, first, {});
    const Ray end = RayFrom(edge, last, {});
    return { start.Foot, end.Foot, start.Value, end.Value };
  }

  /// The jumps at the ends of rays from an edge, which turn on the way along it.
  void Sweep(const BorderEdge& edge, const Point2& direction, double turn, double likely)
  {
    Ray last = this->FindEnd(RayFrom(edge, 0.0, direction), likely);
    const double parts = std::max(std::ceil(turn / LargestTurn), 1.0);
    for (double part = 1.0; part <= parts && !this->Beats.HasStopped(); part += 1.0)
    {
      const double share = part / parts;
      const Ray next = this->FindEnd(
        RayFrom(edge, share, Turned(direction, turn * share)), std::max(2.0 * last.Length, likely));
      this->Trace(last, next, 0);
      last = next;
    }
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
      const Ray from = RayFrom(edge, share, aside);
      if (range(this->Field(from.Foot + aside)) > (1.0 + LeastJump) * range(from.Value))
      {
        this->AddAlong(edge);
        return;
      }
    }
  }

  double UnitOf(double value) const { return this->Cones.Values()(value) / this->SeenGradation; }

  Ray FindEnd(Ray ray, double likely)
  {
    this->RaysLeft -= 1.0;
    const double reach = this->Reach(ray.Foot, ray.Direction);
    const double unit = this->UnitOf(ray.Value);
    ray.Spacing = this->Cones.Values()(ray.Value);
    ray.Length = this->LengthAlong(ray.Foot, ray.Direction, unit, likely);
    ray.End = ray.Foot + ray.Length * ray.Direction;
    if (ray.Length > 0.0 && ray.Length < reach)
    {
      const double margin = std::max(1000.0 * SameLength * ray.Length, 2.0 * EndPrecision * unit);
      const double beyond = std::min(ray.Length + margin, reach);
      const NearestValue nearest = this->Field.NearestOfBorder(
        ray.Foot + beyond * ray.Direction, { beyond, ray.Value, ray.Foot });
      ray.IsLow = this->Cones.Values()(nearest.Value) > (1.0 + LeastJump) * ray.Spacing;
      ray.FarStart = nearest.StartId;
      ray.FarEnd = nearest.EndId;
    }
    return ray;
  }

  Ray Between(const Ray& a, const Ray& b)
  {
    const Point2 direction = a.Direction + b.Direction;
    return this->FindEnd({ Midpoint(a.Foot, b.Foot), 0.5 * (a.Value + b.Value),
                           (1.0 / Length(direction)) * direction },
      std::max(2.0 * std::max(a.Length, b.Length), Distance(a.End, b.End)));
  }

  /// The jumps at the ends of the rays between two of them.
  void Trace(const Ray& a, const Ray& b, int halvings)
  {
    const double unit = this->UnitOf(std::min(a.Value, b.Value));
    const double step = Distance(a.End, b.End);
    const double last =
      LastStep * (HaveOneBeyond(a, b) ? unit : std::min(unit, a.Length + b.Length));
    const bool isNear = step <= std::max(last, SameLength * (a.Length + b.Length));
    const bool isFirst =
      halvings < FirstHalvings && std::max(step, Distance(a.Foot, b.Foot)) > StepOfFirstRays * unit;
    if (!isFirst && this->AreBeyondBounds(a.End, b.End))
    {
      return;
    }
    if (isNear || halvings == MostHalvings || this->RaysLeft < 0.0 || !this->Beats.Beat(64))
    {
      this->AddLow(a, b);
      return;
    }
    const Ray middle = this->Between(a, b);
    if (std::max({ a.Length, middle.Length, b.Length }) <= LargestBend * unit)
    {
      this->AddAlong({ a.Foot, b.Foot, a.Value, b.Value });
      return;
    }
    if (!isFirst && a.IsLow && middle.IsLow && b.IsLow && IsStraight(a, middle, b, unit))
    {
      this->Cones.AddSegment(a.End, b.End, a.Spacing, b.Spacing);
      return;
    }
    const bool isLowAtNone = !a.IsLow && !middle.IsLow && !b.IsLow;
    const bool isOne = HaveOneBeyond(a, middle) && HaveOneBeyond(middle, b);
    if (isFirst || !isLowAtNone || !(isOne || step <= LastStepOfNone * unit))
    {
      this->Trace(a, middle, halvings + 1);
      this->Trace(middle, b, halvings + 1);
    }
  }

  /// Both on one side, and what is between them presumably, too.
  bool AreBeyondBounds(const Point2& a, const Point2& b) const
  {
    Box2 box = Box2::Around(a, b);
    box.Grow(0.5 * box.Diagonal());
    return !this->Bounds.Meets(box);
  }

  void AddLow(const Ray& a, const Ray& b)
  {
    if (a.IsLow && b.IsLow && Distance(a.End, b.End) <= LastStep * this->UnitOf(a.Value))
    {
      this->Cones.AddSegment(a.End, b.End, a.Spacing, b.Spacing);
      return;
    }
    for (const Ray* ray : { &a, &b })
    {
      if (ray->IsLow)
      {
        this->Cones.AddSegment(ray->End, ray->End, ray->Spacing, ray->Spacing);
      }
    }
  }

  const TriangleInterpolator& Field;
  const BorderTurns& Turns;
  const Box2& Bounds;
  const std::array<Point2, 4> Corners; ///< of the bounds
  Box2 Traced;                         ///< what is narrow at its end is wide within the bounds
  const double Gradation;
  const double SeenGradation;
  ConeCollector& Cones;
  Pulse Beats;
  double RaysLeft = 0.0;
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
