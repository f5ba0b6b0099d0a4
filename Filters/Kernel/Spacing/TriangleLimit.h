// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTriangleLimit_h
#define BitingTriangleLimit_h

#include "../Base/Pulse.h"
#include "EdgeBound.h"
#include "EdgeCones.h"
#include "LookedAt.h"
#include "SourceEdges.h"
#include "TriangleInterpolator.h"

#include <array>      // for corners
#include <functional> // for greater
#include <queue>      // for the order of values
#include <utility>    // for pair

namespace biting
{

/// What f is on triangles that are steeper than the gradation: as GridLimit, with the edges of
/// triangles in place of the sides of cells. Outside, f is the nearest border value, limited by
/// what bounds the ends of the nearest edge; where that jumps, see OutsideJumps.h.
///
/// Method: points hand on to their neighbors the point whose edges bound them, lowest first (the
/// order of Dijkstra), so that distances are those of the plane and not of paths along edges. Where
/// a triangle is wide, and larger than f, it lists the cones that may be lowest in it.
/// Cost: n log n for n triangles that are to be lowered, linear for all others.
class TriangleLimit
{
public:
  /// Without meaning if the monitor asks to stop.
  TriangleLimit(std::shared_ptr<const TriangulatedSource> source, double gradation,
    const ValueRange& range, Monitor& monitor);

  /// Whether anything is steep. Where not, there is nothing to be asked for.
  bool IsNeeded() const { return !this->Points.empty(); }

  /// f, scaled and clamped. `triangles` are those of the source.
  double operator()(const Point2& x, const TriangleInterpolator& triangles) const;

private:
  /// What bounds f at a point: the edges around another one, or its own value. Single precision is
  /// more than anybody sees.
  struct Point
  {
    float Value;
    Id Source;
  };

  /// Of Cones.
  struct ConeRange
  {
    Id First;
    Id Last; ///< 0: they are not made yet
  };

  /// What f is on a triangle; or where a wide one has its list in Lists.
  enum Kind : Id
  {
    AsGiven = -1,
    Small = -2, ///< linear between bounded corners
    Wide = -3,  ///< the lowest of what bounds the points around
    Steep = -4  ///< while it is not known what it will be
  };

  /// A value of a point, which may have become lower.
  using Entry = std::pair<float, Id>;

  /// A cone, and its value at the center of a triangle.
  using Candidate = std::pair<double, Id>;

  struct TriangleInside
  {
    std::array<Point2, 3> Corners;
    /// The spacing there, not cut at its most: then it is linear between, or lower.
    std::array<double, 3> Given;
    Point2 Center;
    double Radius = 0.0;
    double Least = std::numeric_limits<double>::infinity(); ///< that its corners are bounded by
  };

  const Point2& PlaceOf(Id point) const
  {
    return this->Source->Points[static_cast<std::size_t>(point)];
  }
  double Raw(Id point) const { return this->Source->Values[static_cast<std::size_t>(point)]; }
  Point& At(Id point) { return this->Points[static_cast<std::size_t>(point)]; }
  const Point& At(Id point) const { return this->Points[static_cast<std::size_t>(point)]; }
  const Id* CornersOf(Id triangle) const
  {
    return &this->Source->Triangles[3 * static_cast<std::size_t>(triangle)];
  }

  double ConeAt(Id cone, const Point2& x) const
  {
    return this->Cones[static_cast<std::size_t>(cone)](x, this->Gradation);
  }

  void SetGiven(Pulse& pulse);
  std::vector<Entry> LowPoints() const;
  void HandOnAll(Pulse& pulse);
  void HandOn(Id from, Id to);
  void Classify(Pulse& pulse);
  void ForgetSlight(std::size_t at);
  Kind KindOf(Id triangle, const std::vector<bool>& isOfSteep) const;
  double ErrorBetween(const Id* corners) const;
  Id ListCones(Id triangle);
  TriangleInside InsideOf(const Id* corners) const;
  bool IsAbove(const Candidate& candidate, const TriangleInside& inside,
    const std::array<double, 3>& values) const;
  void FindSources(Id triangle);
  ConeRange ConesOf(Id source);
  double BoundFrom(Id source, const Point2& x) const;
  double LowestOfList(const Point2& x, Id start) const;
  double ValueInWide(const Point2& x, Id triangle, double given) const;
  double LowerFrom(Id point, const Point2& x, LookedAt<Id>& looked, double least) const;

  std::shared_ptr<const TriangulatedSource> Source;
  const double Gradation;
  const ValueRange Range;
  const EdgeBound Bound;
  std::vector<Id> Kinds; ///< of each triangle
  SourceEdges EdgesOf;
  std::vector<Point> Points;
  std::vector<Id> Lists; ///< of wide triangles: each is a count, and as many cones
  std::vector<SegmentCone> Cones;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> Waiting;

  // While lists are made.
  std::vector<ConeRange> ConesOfPoints;
  std::vector<Id> SourcesAround; ///< of the points around a triangle
  std::vector<Candidate> Candidates;
};

} // namespace biting

#endif
