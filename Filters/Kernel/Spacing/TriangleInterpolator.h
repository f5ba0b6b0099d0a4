// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTriangleInterpolator_h
#define BitingTriangleInterpolator_h

#include "../Base/BoxTree.h"
#include "Source.h"
#include "TriangleBuckets.h"

#include <memory>   // for buckets, shared sources
#include <optional> // for values

namespace biting
{

/// Values given at the ends of an edge, linear between. Its triangles lie left of start -> end.
struct BorderEdge
{
  Point2 Start;
  Point2 End;
  double StartValue = 0.0;
  double EndValue = 0.0;
  Id StartId = NoId; ///< of the points that it joins
  Id EndId = NoId;

  // For a BoxTree.
  Box2 Box() const { return Box2::Around(this->Start, this->End); }
  double Least() const { return 0.0; }
};

/// The value at the place of the border nearest to a point.
struct NearestValue
{
  double Distance;
  double Value;
  Point2 Foot{};                    ///< that place
  const BorderEdge* Edge = nullptr; ///< with that place; lives in the tree that was searched
};

/// The nearest point of an edge, and its value.
inline NearestValue NearestOnEdge(const BorderEdge& edge, const Point2& x)
{
  const Point2 direction = edge.End - edge.Start;
  const Point2 offset = x - edge.Start;
  const double length = Dot(direction, direction);
  const double along = length > 0.0 ? Dot(offset, direction) / length : 0.0;
  const double weight = std::min(std::max(0.0, along), 1.0);
  const Point2 toFoot = weight * direction;
  return { Length(offset - toFoot), (1.0 - weight) * edge.StartValue + weight * edge.EndValue,
    edge.Start + toFoot, &edge };
}

/// The value at the nearest point of all edges, or `known` where none is nearer than that.
inline NearestValue Nearest(const BoxTree<BorderEdge>& border, const Point2& x, NearestValue known)
{
  border.Search(x, 1.0, known.Distance,
    [&x, &known](const BorderEdge& edge, double)
    {
      const NearestValue found = NearestOnEdge(edge, x);
      known = found.Distance < known.Distance ? found : known;
      return known.Distance;
    });
  return known;
}

/// The piecewise linear interpolant of a triangulated source, which it shares; in its holes and
/// outside the value of the nearest point of it. Where triangles leave a gap by rounding, that is
/// the value beside the gap. Where triangles overlap the smallest value counts, if the source says
/// that they may.
class TriangleInterpolator : public Source
{
public:
  /// Leaves out triangles that have no area or have a corner that is NaN.
  /// Incomplete if the monitor asks to stop: it must not be evaluated then.
  explicit TriangleInterpolator(
    std::shared_ptr<const TriangulatedSource> source, Monitor& monitor = NoMonitor());

  /// No triangle is left: it must not be evaluated.
  bool IsEmpty() const { return this->Corners.empty(); }

  double operator()(const Point2& x) const override
  {
    const std::optional<double> value = this->ValueInside(x);
    return value ? *value : Nearest(this->Border, x, { Infinity, this->ValueOf(0, 0) }).Value;
  }

  /// None outside of the triangles.
  std::optional<double> ValueInside(const Point2& x) const;

  /// Outside of them also where the nearest value of the border jumps, unless the source covers the
  /// domain.
  double AddLowEdges(const SteepRule& rule, SegmentSource& edges, Pulse& pulse) const override;

  const BoxTree<BorderEdge>& BorderEdges() const { return this->Border; }

private:
  std::size_t PointOf(Id triangle, std::size_t corner) const
  {
    return static_cast<std::size_t>(this->Corners[3 * static_cast<std::size_t>(triangle) + corner]);
  }
  const Point2& PlaceOf(Id triangle, std::size_t corner) const
  {
    return this->Triangles->Points[this->PointOf(triangle, corner)];
  }
  double ValueOf(Id triangle, std::size_t corner) const
  {
    return this->Triangles->Values[this->PointOf(triangle, corner)];
  }

  std::shared_ptr<const TriangulatedSource> Triangles;
  std::vector<Id> Corners; ///< three a triangle that is a source, counterclockwise
  std::unique_ptr<TriangleBuckets> Buckets;
  BoxTree<BorderEdge> Border;
};

/// Adds what limits f outside of triangles, where the value is v(y), y the nearest place of their
/// border. A ray from y along the normal ends where another place is as near: rays from the low
/// ends of steep edges, and chords of the curves on which rays end, where v jumps or is steep.
/// `most` bounds f at each point of the source, infinite where not known: what is above this
/// bound, grown with the slope, is left out.
void AddJumpsOutside(const TriangleInterpolator& source, const std::vector<double>& most,
  const SteepRule& rule, SegmentSource& edges, Pulse& pulse);

} // namespace biting

#endif
