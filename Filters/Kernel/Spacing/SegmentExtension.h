// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSegmentExtension_h
#define BitingSegmentExtension_h

#include "BoxTree.h"
#include "Spacing.h"

#include <algorithm> // for min, max
#include <limits>    // for infinity

namespace biting
{

/// The Lipschitz extension of values along one segment: min over y on it of f(y) + g |x - y|.
///
/// With u and h the coordinates of x along and across the segment, f(y) = Value + Slope t, the
/// minimum over the line is where (u - t) / |x - y| = Slope / g, that is t = u - h Lean with
/// Lean = (Slope / g) / sqrt(1 - (Slope / g)^2); over the segment, which is a convex problem, t is
/// that clamped to [0, Length]. Data as steep as g or steeper are a cone at their lower end.
/// Eight numbers: 64 bytes.
struct SegmentCone
{
  Point2 Start;
  Point2 Direction{ 1.0, 0.0 };
  double Length = 0.0;
  double Value = 0.0; ///< at Start
  double Slope = 0.0;
  double Lean = 0.0;

  double operator()(const Point2& x, double gradation) const
  {
    const Point2 offset = x - this->Start;
    const double along = Dot(offset, this->Direction);
    const double across = std::abs(Cross(offset, this->Direction));
    const double foot = std::min(std::max(along - across * this->Lean, 0.0), this->Length);
    return this->Value + this->Slope * foot + gradation * Length2(along - foot, across);
  }

private:
  static double Length2(double x, double y) { return std::sqrt(x * x + y * y); }
};

/// A cone, and its value at some point.
struct LowestCone
{
  double Value = std::numeric_limits<double>::infinity();
  Id Cone = NoId;
};

/// The extension of a segment source: the minimum of its cones. It is g-Lipschitz, equals the given
/// values wherever these are, and is below them where they are steeper or a segment nearby asks for
/// less. Cones that are nowhere the lowest are left out.
class SegmentExtension
{
public:
  /// `gradation` 0: the largest slope along the segments themselves; where they are all level, the
  /// default of SpacingOptions.
  /// Empty if the monitor asks to stop: it must not be evaluated then.
  SegmentExtension(const SegmentSource& source, double gradation, Monitor& monitor = NoMonitor());

  bool IsEmpty() const { return this->Cones.empty(); }

  double Gradation() const { return this->Slope; }

  /// The value of one cone. Cones near each other have numbers near each other.
  double ConeAt(Id cone, const Point2& x) const
  {
    return this->Cones[static_cast<std::size_t>(cone)](x, this->Slope);
  }

  /// All cones, or those that matter in some region.
  using Part = BoxTree::Part;
  Part Whole() const { return this->Tree.Whole(); }

  /// The cones of a part that may be not above `limit` at x, and perhaps some more.
  Part Narrow(const Part& part, const Point2& x, double limit) const
  {
    return this->Tree.Narrow(part, x, this->Slope, limit);
  }

  /// The lowest cone of a part at x if it is below `known`, otherwise `known`. Cones that are lower
  /// by less than `slack`, relative to the value, may be missed: far from a finely cut line so many
  /// are nearly lowest that telling them apart is most of the work.
  LowestCone Evaluate(
    const Part& part, const Point2& x, const LowestCone& known, double slack) const;

  /// The minimum, exact.
  double operator()(const Point2& x) const
  {
    return this->Evaluate(this->Whole(), x, LowestCone(), 0.0).Value;
  }

  /// The cones of a part that are not above `limit` at x, but no more than `most` of them.
  void FindBelow(const Part& part, const Point2& x, double limit, std::size_t most,
    std::vector<Id>& found) const;

private:
  void File(Pulse& pulse);
  void KeepOnly(const std::vector<Id>& ascending);
  bool IsBounded(Id cone) const;

  double Slope;
  BoxTree Tree;
  std::vector<SegmentCone> Cones; ///< in the order of the tree
};

} // namespace biting

#endif
