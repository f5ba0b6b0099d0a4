// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OutsideJumps.h"

#include "../Base/Pulse.h"

#include <algorithm> // for min, max
#include <array>     // for samples
#include <cmath>     // for sqrt
#include <vector>    // for squares

namespace biting
{
namespace
{

/// Perpendiculars along an edge: so many f / g apart, but no more than so many.
constexpr double FootDistance = 0.1;
constexpr double MostFeet = 16.0;

/// Jumps by less than this share of f do not matter.
constexpr double LeastJump = 0.002;

/// Squares that are searched first, along the longer side of the bounds: more of them where the border
/// has more edges, as each has at most a few of the lines along which f jumps.
constexpr double LeastFirstSquares = 16.0;
constexpr double MostFirstSquares = 64.0;
constexpr double EdgesPerFirstSquare = 0.0625;

/// The last ones: g / f times their side, where g above 1 counts as 1, as nobody sees slopes on less
/// than a thirtieth of f.
constexpr double LastSquare = 0.03;
constexpr int DeepestLevel = 24;

/// Where jumps are so long, in units of f, that more squares are needed, all of them stay larger: then f
/// is lowered beside the jump by what it could rise across a square, but to no less than a share of it.
constexpr std::size_t MostSquares = 1 << 19;
constexpr double LeastShare = 0.25;
constexpr double LongestWay = 1.42; ///< in a square, in units of its side

/// Feet farther apart than this many times the points themselves belong to two parts of the border.
constexpr double LargestExpansion = 1.5;

/// Ends of neighboring perpendiculars that are farther apart than so many times their feet or their
/// lengths may have anything between them.
constexpr double LargestStep = 4.0;

/// Steps to the length of a perpendicular, and the room for rounding in comparing lengths.
constexpr int LengthSteps = 16;
constexpr double SameLength = 1e-6;

/// Where a perpendicular ends, and the value along it.
struct RayEnd
{
  Point2 Foot;
  Point2 Place;
  double Spacing = 0.0;
  bool IsLow = false; ///< f is larger beyond
};

class JumpFinder
{
public:
  JumpFinder(const TriangleInterpolator& field, const Box2& bounds, double gradation,
    ConeCollector& cones, Monitor& monitor)
    : Field(field)
    , Bounds(bounds)
    , Gradation(gradation)
    , Cones(cones)
    , Beats(monitor)
  {
  }

  bool Run()
  {
    for (const BorderEdge& edge : this->Field.BorderEdges())
    {
      const double length = Distance(edge.Start, edge.End);
      if (!this->Beats.Beat() || !(length > 0.0))
      {
        continue;
      }
      const Point2 normal = (1.0 / length) * Perpendicular(edge.End - edge.Start);
      for (double side : { -1.0, 1.0 })
      {
        if (this->LeavesTriangles(Midpoint(edge.Start, edge.End), side * normal, length))
        {
          this->AddPerpendicular(edge, side * normal);
          this->AddEnds(edge, side * normal);
        }
      }
    }
    this->SearchAll();
    return !this->Beats.HasStopped();
  }

private:
  double SpacingAt(const Point2& x) const
  {
    return this->Cones.Values()(this->Field.Nearest(x).Value);
  }

  /// Whether a direction leads from the border to the outside, within the bounds.
  bool LeavesTriangles(const Point2& start, const Point2& direction, double length) const
  {
    const double step = std::min(SameLength * length, 0.5 * this->Reach(start, direction));
    return step > 0.0 && this->Field.Nearest(start + step * direction).Distance > 0.0;
  }

  /// How far it is along a unit vector to the end of the bounds; 0 where that is behind.
  double Reach(const Point2& start, const Point2& direction) const
  {
    const auto along = [](double from, double slope, double low, double high)
    {
      const double end = slope > 0.0 ? high : low;
      return slope == 0.0 ? std::numeric_limits<double>::infinity() : (end - from) / slope;
    };
    const double reach =
      std::min(along(start.X, direction.X, this->Bounds.Low.X, this->Bounds.High.X),
        along(start.Y, direction.Y, this->Bounds.Low.Y, this->Bounds.High.Y));
    return std::isfinite(reach) ? std::max(reach, 0.0) : 0.0;
  }

  /// How far along a unit vector a point of the border stays the nearest one: a ball that touches it
  /// there shrinks until no other point is within (after Ma, Bae and Choi 2012).
  double LengthAlong(const Point2& start, const Point2& direction)
  {
    double length = this->Reach(start, direction);
    for (int step = 0; step < LengthSteps && this->Beats.Beat(64); ++step)
    {
      const NearestValue nearest =
        this->Field.Nearest(start + length * direction, { length, 0.0, start });
      const Point2 within = nearest.Foot - start;
      if (nearest.Distance >= (1.0 - SameLength) * length)
      {
        return length;
      }
      length = 0.5 * Dot(within, within) / Dot(within, direction);
    }
    return length;
  }

  /// From the lower end of a steep edge.
  void AddPerpendicular(const BorderEdge& edge, const Point2& normal)
  {
    const ValueRange& range = this->Cones.Values();
    const bool isRising = edge.StartValue < edge.EndValue;
    const Point2& lowEnd = isRising ? edge.Start : edge.End;
    const Point2& highEnd = isRising ? edge.End : edge.Start;
    const double low = range.Scale * std::min(edge.StartValue, edge.EndValue);
    const double high = range.Scale * std::max(edge.StartValue, edge.EndValue);
    const bool isSteep = high - low > this->Gradation * Distance(lowEnd, highEnd);
    if (isSteep && low < range.Most && high > range.Least)
    {
      const double weight = std::max(0.0, (range.Least - low) / (high - low));
      const Point2 start = lowEnd + weight * (highEnd - lowEnd);
      const Point2 end = start + this->LengthAlong(start, normal) * normal;
      this->Cones.AddSegment(start, end, std::max(low, range.Least), std::max(low, range.Least));
    }
  }

  /// The jumps before an edge.
  void AddEnds(const BorderEdge& edge, const Point2& normal)
  {
    const double least = this->Cones.Values()(std::min(edge.StartValue, edge.EndValue));
    const double length = Distance(edge.Start, edge.End);
    const double feet =
      std::min(std::ceil(length * this->Gradation / (FootDistance * least)), MostFeet);
    RayEnd last;
    for (double foot = 0.0; foot <= feet && !this->Beats.HasStopped(); foot += 1.0)
    {
      const RayEnd next =
        this->FindEnd(edge.Start + (foot / feet) * (edge.End - edge.Start), normal);
      this->Connect(last, next, foot > 0.0);
      last = next;
    }
  }

  RayEnd FindEnd(const Point2& foot, const Point2& direction)
  {
    const double reach = this->Reach(foot, direction);
    const double length = this->LengthAlong(foot, direction);
    RayEnd end;
    end.Foot = foot;
    end.Place = foot + length * direction;
    end.Spacing = this->SpacingAt(foot);
    const double beyond = std::min((1.0 + 1000.0 * SameLength) * length, reach);
    end.IsLow =
      length<reach&& this->SpacingAt(foot + beyond * direction)>(1.0 + LeastJump) * end.Spacing;
    return end;
  }

  void Connect(const RayEnd& last, const RayEnd& next, bool hasLast)
  {
    const double step = Distance(last.Place, next.Place);
    const double usual = std::max(Distance(last.Foot, next.Foot),
      0.25 * std::min(Distance(last.Place, last.Foot), Distance(next.Place, next.Foot)));
    if (hasLast && last.IsLow && next.IsLow && step <= LargestStep * usual)
    {
      this->Cones.AddSegment(last.Place, next.Place, last.Spacing, next.Spacing);
    }
    else if (next.IsLow)
    {
      this->Cones.AddPoint(next.Place, next.Spacing);
    }
  }

  // What corners of the border are nearest to has no perpendiculars: squares find the jumps.

  void SearchAll()
  {
    const double edges = static_cast<double>(this->Field.BorderEdges().size());
    const double wanted = std::sqrt(edges / EdgesPerFirstSquare);
    const double count = std::min(std::max(wanted, LeastFirstSquares), MostFirstSquares);
    double size = std::max(this->Bounds.Width(), this->Bounds.Height()) / count;
    std::vector<Point2> squares = this->FirstSquares(size);
    for (int level = 0; !squares.empty() && !this->Beats.HasStopped(); ++level, size *= 0.5)
    {
      this->Beats.SetFraction(0.5 + 0.5 * level / (DeepestLevel + 1.0));
      this->NumberOfSquares += squares.size();
      const bool isLast = level == DeepestLevel || this->NumberOfSquares > MostSquares;
      squares = this->Search(squares, size, isLast);
    }
  }

  /// Their lower left corners.
  std::vector<Point2> FirstSquares(double size) const
  {
    std::vector<Point2> squares;
    for (int row = 0; row * size < this->Bounds.Height(); ++row)
    {
      for (int column = 0; column * size < this->Bounds.Width(); ++column)
      {
        squares.push_back(this->Bounds.Low + Point2{ column * size, row * size });
      }
    }
    return squares;
  }

  struct Sample
  {
    Point2 Place;
    NearestValue Nearest;
    double Spacing;
  };
  using Samples = std::array<Sample, 5>; ///< the corners, and the center

  Samples TakeSamples(const Point2& low, double size)
  {
    Samples samples;
    for (std::size_t k = 0; k < samples.size(); ++k)
    {
      const Point2 offset = k == 4
        ? Point2{ 0.5 * size, 0.5 * size }
        : Point2{ static_cast<double>(k % 2) * size, static_cast<double>(k / 2) * size };
      samples[k].Place = low + offset;
      samples[k].Nearest = this->Field.Nearest(samples[k].Place);
      samples[k].Spacing = this->Cones.Values()(samples[k].Nearest.Value);
    }
    this->Beats.Beat(64);
    return samples;
  }

  /// The quarters of those that are to be searched more finely.
  std::vector<Point2> Search(const std::vector<Point2>& squares, double size, bool isLast)
  {
    std::vector<Point2> quarters;
    for (std::size_t square = 0; square < squares.size() && !this->Beats.HasStopped(); ++square)
    {
      const Samples samples = this->TakeSamples(squares[square], size);
      if (!this->AnyApart(samples))
      {
        continue;
      }
      const double rise = std::min(this->Gradation, 1.0) * size;
      const bool isFine = rise <= LastSquare * LeastOf(samples);
      if (isFine || isLast)
      {
        this->AddLowSides(samples, isFine ? 0.0 : LongestWay * rise);
        continue;
      }
      for (int quarter = 0; quarter < 4; ++quarter)
      {
        const Point2 offset{ 0.5 * size * (quarter % 2), 0.5 * size * (quarter / 2) };
        quarters.push_back(squares[square] + offset);
      }
    }
    return quarters;
  }

  static double LeastOf(const Samples& samples)
  {
    double least = samples[0].Spacing;
    for (const Sample& sample : samples)
    {
      least = std::min(least, sample.Spacing);
    }
    return least;
  }

  bool AnyApart(const Samples& samples) const
  {
    for (std::size_t k = 1; k < samples.size(); ++k)
    {
      for (std::size_t other = 0; other < k; ++other)
      {
        if (AreApart(samples[k], samples[other]))
        {
          return true;
        }
      }
    }
    return false;
  }

  static bool AreApart(const Sample& a, const Sample& b)
  {
    const double jump = std::abs(a.Spacing - b.Spacing);
    return a.Nearest.Distance + b.Nearest.Distance > 0.0 &&
      jump > LeastJump * std::min(a.Spacing, b.Spacing) &&
      Distance(a.Nearest.Foot, b.Nearest.Foot) > LargestExpansion * Distance(a.Place, b.Place);
  }

  void AddLowSides(const Samples& samples, double lowering)
  {
    for (const Sample& sample : samples)
    {
      const bool isLow = std::any_of(samples.begin(), samples.end(),
        [this, &sample](const Sample& other) {
          return other.Spacing >
            sample.Spacing + this->Gradation * Distance(sample.Place, other.Place);
        });
      if (isLow)
      {
        this->Cones.AddPoint(
          sample.Place, std::max(sample.Spacing - lowering, LeastShare * sample.Spacing));
      }
    }
  }

  const TriangleInterpolator& Field;
  const Box2& Bounds;
  const double Gradation;
  ConeCollector& Cones;
  Pulse Beats;
  std::size_t NumberOfSquares = 0;
};

} // namespace

bool AddOutsideJumps(const TriangleInterpolator& field, const Box2& bounds, double gradation,
  ConeCollector& cones, Monitor& monitor)
{
  return !(bounds.Diagonal() > 0.0) || JumpFinder(field, bounds, gradation, cones, monitor).Run();
}

} // namespace biting
