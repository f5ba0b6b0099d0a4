// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingQuality_h
#define BitingQuality_h

#include "../Base/Ids.h"
#include "../Base/Point2.h"

#include <cstdint> // for counts
#include <vector>  // for the arrays

namespace biting
{

/// What a mesh is worth, per vertex, per triangle and as a whole. Judges only: changes nothing.
struct MeshQuality
{
  // One a vertex.
  std::vector<double> NearestNeighborDistance; ///< N: distance to the nearest other vertex
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
  double ShareOfEdgesInBand = 0.0; ///< of edges with length within [1/sqrt(2), sqrt(2)] f, 0..1
};

/// A mesh to judge: vertices, the spacing wanted at each, and triangles (three vertex ids each).
struct MeshView
{
  const std::vector<Point2>& Points;
  const std::vector<double>& Spacing;
  const std::vector<Id>& Corners;
  const std::vector<Id>& Neighbors; ///< as in Triangulation: across the edge opposite each corner
};

/// Measures `mesh`. Cost O(n) for a Delaunay mesh.
/// N is exact also where the nearest vertex is not joined by an edge (across a hole or a slit).
MeshQuality MeasureQuality(const MeshView& mesh);

/// The three measures of one triangle, for tests and for other rooms.
double MinimumAngle(const Point2& a, const Point2& b, const Point2& c);
double RadiusEdgeRatio(const Point2& a, const Point2& b, const Point2& c);
double AspectRatio(const Point2& a, const Point2& b, const Point2& c);

} // namespace biting

#endif
