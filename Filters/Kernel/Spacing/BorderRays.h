// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBorderRays_h
#define BitingBorderRays_h

#include "TriangleInterpolator.h"
#include "ValueRange.h"

namespace biting
{

/// A straight way from a point of the border to where that ceases to be the nearest one.
struct BorderRay
{
  double Share; ///< of its front
  Point2 Foot;
  double Value; ///< given there
  Point2 Direction;
  double Length = 0.0;
  const BorderEdge* Far = nullptr; ///< what is as near as the foot at its end; none in the open
  double Spacing = 0.0;            ///< f there, or beyond where it is less
  bool IsJump = false;             ///< f differs beyond
  bool IsCovered = false;          ///< other triangles lie there

  Point2 End() const { return this->Foot + this->Length * this->Direction; }
};

/// Rays from an edge, or a corner, which turn on the way along it.
struct BorderFront
{
  BorderEdge Edge;
  Point2 Direction; ///< at the start
  double Turn = 0.0;

  static Point2 Turned(const Point2& direction, double angle)
  {
    return std::cos(angle) * direction + std::sin(angle) * Perpendicular(direction);
  }

  BorderRay At(double share) const
  {
    return { share, this->Edge.Start + share * (this->Edge.End - this->Edge.Start),
      (1.0 - share) * this->Edge.StartValue + share * this->Edge.EndValue,
      Turned(this->Direction, share * this->Turn) };
  }
};

/// Where rays from the border of a triangulated source end, and whether f jumps there. Lengths are
/// found within .003 f / g and a hundredth of themselves.
class BorderRays
{
public:
  /// Jumps by less than this share of f do not matter.
  static constexpr double LeastJump = 0.002;

  /// The room for rounding in comparing lengths, as a share.
  static constexpr double SameLength = 1e-6;

  /// What it refers to must outlive it.
  BorderRays(const TriangleInterpolator& field, const Box2& bounds, double gradation,
    const ValueRange& range, Pulse& pulse);

  /// f / g, the unit of lengths.
  double UnitOf(double spacing) const { return spacing / this->SeenGradation; }

  /// How far the foot of a ray stays the nearest point of the border: a ball that touches it there
  /// shrinks until no other point is within (after Ma, Bae and Choi 2012). It begins with a
  /// `likely` length, up to what is `far` presumably, and grows where that is too short.
  void Extend(BorderRay& ray, double likely, const BorderEdge* far) const;

  /// The same, with what is beyond: also a little farther, as many small jumps may be one.
  BorderRay FindEnd(BorderRay ray, double likely, const BorderEdge* far) const;

  /// The ray between two of them that is as far from what is beyond the one as beyond the other.
  BorderRay FindCrossing(const BorderFront& front, const BorderRay& a, const BorderRay& b) const;

  /// Where a ray would end if that were beyond it: nothing, in the open.
  NearestValue EndAt(const BorderRay& ray, const BorderEdge* far) const;

  /// Ends a ray there.
  void EndAtOnce(BorderRay& ray, const BorderEdge* far) const;

  /// Whether what is beyond one ray is beyond another one, too.
  bool IsBeyond(const BorderEdge* far, const BorderRay& ray) const;

  /// Tells f and jumps at the end of a ray, if that is beyond it.
  void LookBeyond(BorderRay& ray, const BorderEdge* far) const;

private:
  double Reach(const Point2& start, const Point2& direction) const;
  double RoomOf(const BorderRay& ray, double length) const;
  void Compare(BorderRay& ray, double value) const;

  const TriangleInterpolator& Field;
  Box2 Traced; ///< what is narrow at its end is wide within the bounds
  const double SeenGradation;
  const ValueRange Range;
  Pulse& Beats;
};

} // namespace biting

#endif
