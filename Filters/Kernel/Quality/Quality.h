// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingQuality_h
#define BitingQuality_h

#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Base/Point.h"
#include "ExactSum.h"

#include <algorithm> // for min, max
#include <cstdint>   // for counts
#include <limits>    // for none
#include <vector>    // for the arrays

namespace biting
{

/// Sums over parts of a mesh. Joined in any order they have the same bits.
struct QualitySums
{
  std::int64_t Vertices = 0;
  std::int64_t Triangles = 0;
  std::int64_t Edges = 0;
  std::int64_t EdgesInBand = 0; ///< (MeshQuality::ShareOfEdgesInBand)
  double SmallestAngle = std::numeric_limits<double>::infinity();
  double LargestRadiusEdgeRatio = 0.0;
  double SmallestConformity = std::numeric_limits<double>::infinity();
  double LargestSlope = 0.0;
  ExactSum Conformities;
  ExactSum RelativeLengths; ///< of edges

  void Join(const QualitySums& other)
  {
    this->Vertices += other.Vertices;
    this->Triangles += other.Triangles;
    this->Edges += other.Edges;
    this->EdgesInBand += other.EdgesInBand;
    this->SmallestAngle = std::min(this->SmallestAngle, other.SmallestAngle);
    this->LargestRadiusEdgeRatio =
      std::max(this->LargestRadiusEdgeRatio, other.LargestRadiusEdgeRatio);
    this->SmallestConformity = std::min(this->SmallestConformity, other.SmallestConformity);
    this->LargestSlope = std::max(this->LargestSlope, other.LargestSlope);
    this->Conformities.Join(other.Conformities);
    this->RelativeLengths.Join(other.RelativeLengths);
  }
};

/// What a mesh is worth, per vertex, per triangle and as a whole. Judges only: changes nothing.
struct MeshQuality
{
  // One a vertex.
  std::vector<double> NearestNeighborDistance; ///< N: the length of the shortest edge at it
  std::vector<double> Conformity;              ///< min(N / f, f / N) (paper, definition 2.3)

  // One a triangle.
  std::vector<double> MinimumAngle;    ///< degrees
  std::vector<double> RadiusEdgeRatio; ///< circumradius / shortest edge; 0.577 is best
  std::vector<double> AspectRatio;     ///< radii, smallest containing circle / inscribed circle

  // The whole.
  std::int64_t NumberOfVertices = 0;
  std::int64_t NumberOfTriangles = 0;
  double SmallestAngle = 0.0; ///< degrees
  double LargestRadiusEdgeRatio = 0.0;
  double SmallestConformity = 0.0;
  double MeanConformity = 0.0;
  double MeanRelativeLength = 0.0; ///< mean over edges of length / mean f of its ends
  double LargestSlope = 0.0;       ///< as the function says
  double ShareOfEdgesInBand = 0.0; ///< of edges with length within [1/sqrt(2), sqrt(2)] f, 0..1

  QualitySums Sums; ///< from which the figures of the whole follow

  /// Makes the figures of the whole those of `sums`.
  void Conclude(const QualitySums& sums);
};

/// A mesh to judge: vertices, the spacing wanted at each, and triangles (three vertex ids each).
struct MeshView
{
  const std::vector<Point2>& Points;
  const std::vector<double>& Spacing;
  const std::vector<Id>& Corners;
  const std::vector<Id>& Neighbors; ///< as in Triangulation: across the edge opposite each corner

  /// The spacing at EdgeMiddles, in their order; null: the mean of that at the ends.
  const std::vector<double>* MiddleSpacing = nullptr;

  /// Flags of vertices, and of triangles, that do not count in sums, as ghosts do not. An edge
  /// counts with its triangle of the larger number. Null: all count.
  const std::vector<std::uint8_t>* ForeignVertices = nullptr;
  const std::vector<std::uint8_t>* ForeignTriangles = nullptr;

  bool CountsVertex(std::size_t vertex) const
  {
    return !this->ForeignVertices || (*this->ForeignVertices)[vertex] == 0;
  }
  bool CountsTriangle(std::size_t triangle) const
  {
    return !this->ForeignTriangles || (*this->ForeignTriangles)[triangle] == 0;
  }
};

/// Measures `mesh`. Cost O(n).
/// In a Delaunay mesh of a domain N is the distance to the nearest vertex in sight: the nearest of
/// all, but across a hole or a slit. Infinite for a vertex without triangles.
/// Triangles may overlap and need not be counterclockwise: `Neighbors` only tells which edges are
/// the same. An edge is counted at each slot where they have no or a smaller id than the triangle.
/// Where the monitor asks to stop the result has no meaning; so it is with all that is below.
MeshQuality MeasureQuality(const MeshView& mesh, Monitor& monitor = NoMonitor());

/// The middle of each edge, each edge once, in the order of the slots where it is counted.
std::vector<Point2> EdgeMiddles(const MeshView& mesh, Monitor& monitor = NoMonitor());

/// The length of each edge divided by the spacing at its middle, in the order of EdgeMiddles: by
/// the midpoint rule, the integral of 1 / f along the edge.
std::vector<double> RelativeLengths(const MeshView& mesh, Monitor& monitor = NoMonitor());

/// All angles in degrees, one a slot. 0 where a side has no length.
std::vector<double> AnglesOf(const MeshView& mesh, Monitor& monitor = NoMonitor());

/// The largest slope |f(u) - f(v)| / |u - v| of the spacing along edges that have a length.
double LargestSlope(const MeshView& mesh, Monitor& monitor = NoMonitor());

/// The three measures of one triangle, for tests and for other rooms.
double MinimumAngle(const Point2& a, const Point2& b, const Point2& c);
double RadiusEdgeRatio(const Point2& a, const Point2& b, const Point2& c);
double AspectRatio(const Point2& a, const Point2& b, const Point2& c);

} // namespace biting

#endif
