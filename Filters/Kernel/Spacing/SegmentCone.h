// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSegmentCone_h
#define BitingSegmentCone_h

#include "../Base/BoxTree.h"
#include "Spacing.h"

#include <algorithm> // for min, max
#include <cmath>     // for sqrt
#include <vector>    // for cones

namespace biting
{

/// The distance of a place from the line through the origin.
inline double DistanceAcross(const Point2& offset, const Point2& direction)
{
  return std::abs(Cross(offset, direction));
}
inline double DistanceAcross(const Point3& offset, const Point3& direction)
{
  return Length(Cross(offset, direction));
}

/// The Lipschitz extension of values along one segment: min over y on it of f(y) + g |x - y|.
///
/// With u and h the coordinates of x along and across the segment, f(y) = Value + Slope t, the
/// minimum over the line is where (u - t) / |x - y| = Slope / g, that is t = u - h Lean with
/// Lean = (Slope / g) / sqrt(1 - (Slope / g)^2); over the segment, which is a convex problem, t is
/// that clamped to [0, Length]. Data as steep as g or steeper are a cone at their lower end.
/// In the plane eight numbers: 64 bytes.
template <std::size_t D>
struct Cone
{
  Point<D> Start;
  Point<D> Direction;
  double Length = 0.0;
  double Value = 0.0; ///< at Start
  double Slope = 0.0;
  double Lean = 0.0;

  Cone() { this->Direction[0] = 1.0; }

  /// Of two places and the values there; `gradation` is positive.
  Cone(const Point<D>& start, const Point<D>& end, double startValue, double endValue,
    double gradation)
    : Cone()
  {
    const bool isRising = !(endValue < startValue);
    const Point<D>& low = isRising ? start : end;
    const Point<D>& high = isRising ? end : start;
    const double length = Distance(start, end);
    this->Start = low;
    this->SetValues(
      length, std::min(startValue, endValue), std::abs(endValue - startValue), gradation);
    for (std::size_t d = 0; d<D&& this->Length> 0.0; ++d)
    {
      this->Direction[d] = (high[d] - low[d]) / length;
    }
  }

  /// From `value` at its start up by `rise` over its length; a point if that is too steep.
  void SetValues(double length, double value, double rise, double gradation)
  {
    this->Value = value;
    const double steepness = rise / (gradation * length);
    if (steepness < 1.0)
    {
      this->Length = length;
      this->Slope = steepness * gradation;
      this->Lean = steepness / std::sqrt((1.0 - steepness) * (1.0 + steepness));
    }
  }

  double operator()(const Point<D>& x, double gradation) const
  {
    const Point<D> offset = x - this->Start;
    const double along = Dot(offset, this->Direction);
    const double across = DistanceAcross(offset, this->Direction);
    const double foot = this->FootAt(along, across);
    const double ahead = along - foot;
    return this->Value + this->Slope * foot +
      gradation * std::sqrt(ahead * ahead + across * across);
  }

  /// The foot of x, the point y of the segment where the minimum is taken: the value there, and the
  /// way from there to x. The cone's gradient at x is the unit vector along that way, times g.
  struct View
  {
    double Value;
    Point<D> Away;
  };
  View From(const Point<D>& x) const
  {
    const Point<D> offset = x - this->Start;
    const double foot =
      this->FootAt(Dot(offset, this->Direction), DistanceAcross(offset, this->Direction));
    return { this->Value + this->Slope * foot, offset - foot * this->Direction };
  }

  /// Whether this cone is nowhere above `other` by more than `room`. Two tests suffice, at the ends
  /// of other's segment: between them this cone is convex, beyond no cone grows faster than g.
  bool StandsFor(const Cone& other, double gradation, double room) const
  {
    return (*this)(other.Start, gradation) <= other.Value + room &&
      (*this)(other.End(), gradation) <= other.Value + other.Slope * other.Length + room;
  }

  Point<D> End() const { return this->Start + this->Length * this->Direction; }

  // For a BoxTree.
  biting::Box<D> Box() const { return biting::Box<D>::Around(this->Start, this->End()); }
  double Least() const { return this->Value; }

private:
  double FootAt(double along, double across) const
  {
    // A branch for what is negative would be guessed wrong as often as not, and take as long again.
    const double foot = along - across * this->Lean;
    const double ahead = 0.5 * (foot + std::abs(foot));
    return ahead < this->Length ? ahead : this->Length;
  }
};

using SegmentCone = Cone<2>;

/// The cones of the segments of a source, with the values times `scale`. Their minimum differs from
/// that over all segments by at most the share `tolerance`. Where segments are much shorter than
/// f / g there are fewer cones than segments:
/// - consecutive segments become one, where that changes f by less than tolerance / 2;
/// - DropHigh drops cones, with the other half of the tolerance.
/// Linear in the number of segments, given in the order of their chains.
std::vector<SegmentCone> MakeCones(const SegmentSource& source, double scale, double gradation,
  Pulse& pulse, double tolerance = 0.0);

/// Drops each cone for which the last one kept stands, with room = tolerance / 2 of its value. Goes
/// from the first cone to the last, then back.
template <std::size_t D>
void DropHigh(double slope, double tolerance, std::vector<Cone<D>>& cones, Pulse& pulse)
{
  for (int direction = 0; direction < 2; ++direction)
  {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < cones.size() && pulse.Beat(1); ++k)
    {
      const Cone<D> cone = cones[k];
      if (kept == 0 || !cones[kept - 1].StandsFor(cone, slope, 0.5 * tolerance * cone.Value))
      {
        cones[kept++] = cone;
      }
    }
    cones.resize(kept);
    std::reverse(cones.begin(), cones.end());
  }
}

/// The largest slope along segments; segments without length do not count.
double LargestSlope(const SegmentSource& source);

/// The slope with which values grow from their segments: `gradation`, or the largest slope along
/// them where that is 0, or the default of SpacingOptions where they are all level.
///
/// The largest slope is cut at (M - m) / m, with m and M the smallest and the largest value: edges
/// of the mesh are no shorter than m, so a steeper rise, as on segments as short as rounding, is a
/// jump to them.
double SlopeOfCones(const SegmentSource& source, double gradation);

/// The minimum of many cones of one slope, exact: the Lipschitz extension of the values along
/// segments. For a few evaluations per segment: ConeTree takes longer to build, and a tenth of the
/// time to evaluate. The cost of a call is logarithmic, and constant where all cones are above
/// `known`.
class SegmentExtension
{
public:
  /// Without cones if the pulse stops: it must not be evaluated then.
  SegmentExtension(const std::vector<SegmentCone>& cones, double slope, Pulse& pulse)
    : Slope(slope)
    , Tree(cones, pulse)
  {
  }

  /// min(known, minimum of the cones at x).
  double operator()(const Point2& x, double known = Infinity) const
  {
    this->Tree.Search(x, this->Slope, known,
      [this, &x, &known](const SegmentCone& cone, double)
      {
        known = std::min(known, cone(x, this->Slope));
        return known;
      });
    return known;
  }

private:
  double Slope;
  BoxTree<SegmentCone> Tree;
};

} // namespace biting

#endif
