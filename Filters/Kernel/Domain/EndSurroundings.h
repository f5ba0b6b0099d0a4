// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingEndSurroundings_h
#define BitingEndSurroundings_h

#include "../Base/Box.h"
#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "PointWelding.h"
#include "Polylines.h"
#include "SegmentTree.h"
#include "VertexStars.h"

#include <cstdint> // for masks
#include <vector>  // for the arrays

namespace biting
{

/// The point of a segment that is nearest to an end.
struct Foot
{
  Id Segment = NoId;
  double Distance = 0.0;
  Point2 Place;
  double Along = 0.0; ///< share of the segment before it, from the lesser vertex
  Id End = NoId;
};

/// A segment of a chain, by the vertices at its ends, the lesser first.
struct ChainSegment
{
  SegmentEnds Ends;
  Id Place = NoId; ///< in the connectivity, where it begins
  Id Cell = NoId;
  bool IsReversed = false; ///< it begins at the greater one
};

/// The segments that join two vertices.
std::vector<ChainSegment> SegmentsOf(
  const Polylines& input, const WeldedPoints& points, Pulse& pulse);

/// The vertices at which one segment ends, by their numbers.
std::vector<Id> FindOpenEnds(const std::vector<ChainSegment>& segments, std::size_t vertices);

/// The segments of all chains, as open ends see them.
class EndSurroundings
{
public:
  /// Refers to the vertices of `points`.
  EndSurroundings(std::vector<ChainSegment> segments, const WeldedPoints& points, Pulse& pulse);

  const ChainSegment& Segment(Id segment) const { return this->Segments[segment]; }

  /// One that ends at the vertex.
  const ChainSegment& SegmentAt(Id vertex) const
  {
    return this->Segment(*this->Stars.Begin(vertex));
  }

  /// Calls visit(segment) for those whose boxes come within reach of the place.
  template <typename Visitor>
  void VisitNear(const Point2& place, double reach, Visitor&& visit) const
  {
    Box2 box = Box2::Around(place, place);
    box.Grow(reach);
    this->Tree.Visit(box, SegmentEnds(), visit);
  }

  Foot FootOn(Id segment, Id end) const;

  /// The other vertices within rounding of the segment that ends at the vertex.
  std::vector<Foot> VerticesOnSegmentAt(Id vertex) const;

  /// Adds the end, and all vertices that segments within `reach` of it join with it, to its own.
  void AddOwn(Id end, double reach);
  void ForgetOwn();
  bool IsOwn(Id vertex) const { return this->IsMarked[vertex] != 0; }

private:
  std::vector<SegmentEnds> Ends() const;
  const Point2& At(Id vertex) const { return this->Vertices[vertex]; }

  const std::vector<Point2>& Vertices;
  const double Rounding;
  Pulse& Beats;
  const std::vector<ChainSegment> Segments;
  const VertexStars Stars;
  const SegmentTree Tree;
  std::vector<std::uint8_t> IsMarked;
  std::vector<Id> Marked;
};

} // namespace biting

#endif
