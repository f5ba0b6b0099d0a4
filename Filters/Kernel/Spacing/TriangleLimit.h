// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTriangleLimit_h
#define BitingTriangleLimit_h

#include "../Base/Pulse.h"
#include "EdgeBound.h"
#include "EdgeCones.h"
#include "TriangleInterpolator.h"

#include <functional> // for greater
#include <queue>      // for the order of values
#include <utility>    // for pair

namespace biting
{

/// What f is on triangles that are steeper than the gradation: as GridLimit, with the edges of
/// triangles in place of the sides of cells. Outside, f is the nearest border value, limited by what
/// bounds the ends of the nearest edge; where that jumps, see OutsideJumps.h.
///
/// Method: points hand on to their neighbors the point whose edges bound them, lowest first (the order
/// of Dijkstra), so that distances are those of the plane and not of paths along edges.
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

  /// From a point, which is not among what it knows.
  struct Edge
  {
    Point2 Along;
    double End; ///< the value there, as given
    Id To;
    bool IsSteep; ///< a triangle beside it is
  };

  struct EdgeRange
  {
    const Edge* First;
    const Edge* Last;
    const Edge* begin() const { return this->First; }
    const Edge* end() const { return this->Last; }
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
    Wide = -3,  ///< while it has no list: the lowest bound of points around
    Steep = -4  ///< while it is not known what it will be
  };

  /// A value of a point, which may have become lower.
  using Entry = std::pair<float, Id>;

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

  EdgeRange EdgesOf(Id point) const
  {
    const Id* first = &this->FirstEdges[static_cast<std::size_t>(point)];
    return { this->Edges.data() + first[0], this->Edges.data() + first[1] };
  }

  void FileEdges(Pulse& pulse);
  void AddEdges(Id point, Id triangle);
  void SetGiven(Pulse& pulse);
  std::vector<Entry> LowPoints() const;
  void HandOnAll(Pulse& pulse);
  void HandOn(Id from, Id to);
  void Classify(Pulse& pulse);
  void ForgetSlight(std::size_t at);
  Kind KindOf(Id triangle, const std::vector<bool>& isOfSteep) const;
  double ErrorBetween(const Id* corners) const;
  Id ListCones(Id triangle);
  void FindSources(const Id* corners);
  ConeRange ConesOf(Id source);
  double BoundFrom(Id source, const Point2& x) const;

  std::shared_ptr<const TriangulatedSource> Source;
  const double Gradation;
  const ValueRange Range;
  const EdgeBound Bound;
  std::vector<Id> Kinds;      ///< of each triangle
  std::vector<Id> FirstEdges; ///< those of point p are FirstEdges[p] to FirstEdges[p + 1]
  std::vector<Edge> Edges;
  std::vector<Point> Points;
  std::vector<Id> Lists; ///< of wide triangles: each is a count, and as many cones
  std::vector<SegmentCone> Cones;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> Waiting;

  // While lists are made.
  std::vector<ConeRange> ConesOfPoints;
  std::vector<Id> SourcesAround;                 ///< of the points around a triangle
  std::vector<std::pair<double, Id>> Candidates; ///< cones, and their values at its center
};

} // namespace biting

#endif
