// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDomain_h
#define BitingDomain_h

#include "../Base/Box.h"
#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Base/Point.h"
#include "../Base/Problem.h"
#include "Polylines.h"

#include <cstdint>    // for flags
#include <functional> // for the spacing
#include <vector>     // for the arrays

namespace biting
{

/// The domain to mesh: a planar straight-line graph (PSLG) and which side of each segment is
/// inside.
///
/// Invariant, exact: segments meet at common end vertices only; no two vertices coincide; no vertex
/// lies on the interior of a segment. The inside is the even-odd region of all boundary segments,
/// each counted as often as it occurs in the input, whatever the orientation of the loops.
/// Coordinates are those of the input, so that what is exact here is exact in the output; but those
/// below LeastCoordinate in magnitude count as zero.
///
/// Of ChainKind::Automatic, closed chains bound. Open ones bound where they form loops together: of
/// their graph without its bridges, components of even degree by parity, others by their outline.
/// What crosses itself, or has odd degrees, and lies within the domain of the others only divides
/// it.
///
/// Where there are faces, the domain is the area that an odd number of them covers, whatever their
/// orientation, and chains of ChainKind::Automatic are interfaces. An edge between two faces is
/// dropped, with the vertices that only such edges have, unless the faces differ in region or
/// KeepCellEdges is on: then it is an interface. What a face shares with a line has the cell of the
/// line.
struct Domain
{
  // Vertices: ends of segments, and embedded points of the closed domain.
  std::vector<Point2> Vertices;
  std::vector<Id> VertexPoints; ///< first input point at each vertex; NoId where a crossing made it
  std::vector<std::uint8_t> IsEmbedded; ///< 1 where an embedded point belongs to no segment
  std::vector<std::uint8_t> HasPoint;   ///< 1 where there is an embedded point, also on segments

  // Segments, those outside of the domain dropped.
  std::vector<Id> Starts;
  std::vector<Id> Ends;
  std::vector<Id> Cells; ///< the input cell of each segment (where several, the first; lines first)
  std::vector<std::uint8_t> IsBoundary; ///< 1: inside differs across it; 0: interface
  std::vector<std::uint8_t>
    LeftInside; ///< 1: the domain lies left of start -> end; of boundary all
  std::vector<std::uint8_t> RightInside;

  /// 1 where the segment must stay one edge of the mesh; empty: any may be divided.
  std::vector<std::uint8_t> IsPreserved;

  Box2 Bounds;             ///< of the vertices
  double Area = 0.0;       ///< of the even-odd region
  double Resolution = 0.0; ///< rounding of vertices: 4 ulp of the largest magnitude

  Id NumberOfVertices() const { return static_cast<Id>(this->Vertices.size()); }
  Id NumberOfSegments() const { return static_cast<Id>(this->Starts.size()); }
  bool MustPreserve(Id segment) const
  {
    return !this->IsPreserved.empty() && this->IsPreserved[segment] != 0;
  }
};

/// What the domain is, of the areas that closed chains and faces enclose.
enum class DomainRule
{
  EvenOdd,          ///< what an odd number of them covers
  OuterMinusOthers, ///< the largest of them, less all others
  Union             ///< all of them; where they overlap the last one is on top
};

struct DomainOptions
{
  /// By the rules other than EvenOdd a loop is a closed chain, or chains that are joined end to end
  /// without an end left over, or a face; all other chains are interfaces. That loops cross or
  /// overlap is no problem then. By Union edges between loops are interfaces, by
  /// Polylines::Regions where these are given; what a later loop covers is dropped.
  DomainRule Rule = DomainRule::EvenOdd;

  /// True: crossings, touches, overlaps and duplicates are resolved into the arrangement and
  /// reported as repairs. False: they are reported, and followed by ProblemCode::NotResolved.
  bool Repair = true;

  /// Whether every edge of a face is an edge of the mesh, also between faces of one region.
  bool KeepCellEdges = false;

  /// Points that are not further apart than this, relative to the diagonal of the drawing's box,
  /// are one. Where it is less than the rounding of the coordinates, that counts.
  double MergeTolerance = 0.0;

  /// Open ends within that of another end, a vertex or a segment are joined with it (OpenEnds.h),
  /// in units of GivenSpacing there. Where MergeTolerance says more, that counts.
  double EndTolerance = 0.01;

  /// The spacing that was asked for at a place. Called only where ends are open. Empty: zero.
  std::function<double(const Point2&)> GivenSpacing;

  /// With more pairs of segments that cross, the input is refused with ProblemCode::NotResolved:
  /// they cost time and 100 bytes each, and the mesh would have as many vertices. So is one of
  /// which very many segments lie along one line: 1400 that all overlap are too many.
  std::int64_t MaximumNumberOfCrossings = 1000000;
};

/// Makes the domain of `input`: weld points that are equal or too near to be told apart, resolve
/// the arrangement, find what bounds, find the inside, drop the outside. Vertices and segments are
/// numbered along walks over the segments (SegmentWalk.h). Repairs and refusals are added to
/// `problems`; where these have errors the returned domain is empty. Cost O(n log n + k) for k
/// meetings of segments. Law: neither the order of points, chains and cells matters, nor directions
/// and first points of closed chains, nor whether points are shared; but to ids of points and
/// cells, and by DomainRule::Union, where the last one is on top.
Domain MakeDomain(
  const Polylines& input, const DomainOptions& options, ProblemList& problems, Monitor& monitor);

} // namespace biting

#endif
