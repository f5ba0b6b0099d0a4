// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBitingScheme_h
#define BitingBitingScheme_h

#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Base/Point.h"
#include "../Delaunay/ConstrainedMesh.h"
#include "../Domain/Domain.h"
#include "../Domain/DomainLocator.h"
#include "../Spacing/Spacing.h"
#include "Bites.h"
#include "FrontOrder.h"

#include <cstdint> // for limits
#include <vector>  // for the arrays

namespace biting
{

/// How a domain is bitten. All are values: where the user leaves c_b open, 0 = automatic, the
/// constructor has chosen it, and nobody below asks again.
struct BitingOptions
{
  /// `bitingConstant` 0: c_b is such that the mean edge length of the mesh is f, on average over
  /// domains.
  explicit BitingOptions(BiteShape shape = BiteShape::Square,
    biting::Placement placement = biting::Placement::Corners, FrontOrder order = FrontOrder::Layers,
    double bitingConstant = 0.0);

  BiteShape Shape;
  biting::Placement Placement;
  FrontOrder Order;
  double BitingConstant; ///< c_b
  double PartLength;     ///< wanted length of edges, on the boundary and inside, in units of f

  /// True: the mean edge length is to be f, whatever f: so it is where c_b is automatic. With
  /// Bisectors inner bites are larger or smaller than c_b f then by what the slope of f does to
  /// lengths, and squares are shifted by it (BiteTriangle.h). False: the half-width of inner bites
  /// is c_b f, as in the paper.
  bool FollowSlope;

  /// With FollowSlope, squares: by which factor inner edges are longer than f, so that a whole
  /// number of rows fills the domain. About 1.
  double Stretch = 1.0;

  /// t: with Bisectors an inner bite covers its concentric core, t times as wide, in (0, 1], and
  /// vertices on a segment may be as near as EdgeDivider::BalancedPart of PartLength. The best
  /// shapes have 0.9 for squares and 0.8 for circles. 1: the laws to the letter, as at corners.
  double Tolerance;
  std::int64_t MaximumNumberOfBites = -1; ///< -1 = until the front is empty
  std::int64_t MaximumNumberOfVertices = 20000000;
  bool KeepFront = false; ///< fill Front

  double Phi = 1.0; ///< of the triangulation of the result (TriangulationOptions)

  /// True: no segment is divided. Shields cover what the bites of its ends do not: squares along it
  /// that make no vertex and keep those of the interior away.
  bool PreserveBoundary = false;
};

enum class BitingEnd
{
  Complete, ///< the front is empty, or the wanted number of bites is made
  Aborted,
  TooManyVertices
};

/// The vertices of the mesh and the edges that it must have.
struct BitingResult
{
  // Vertices: those of the domain in their order, then new ones in the order of their bites.
  std::vector<Point2> Points;
  std::vector<double> Spacings;
  std::vector<Id> BiteOrders; ///< NoId where biting stopped before
  std::vector<Id> Segments;   ///< of a new vertex: the domain segment that it lies on, or NoId

  // The parts into which the segments are divided.
  std::vector<Id> EdgeStarts;
  std::vector<Id> EdgeEnds;
  std::vector<Id> EdgeSegments;

  /// The triangulation in which left-overs were looked for, with all vertices and edges; without
  /// triangles where they were not, and not whole where edges cross.
  ConstrainedMesh Triangulated;

  biting::Bites Bites;
  std::vector<Point2> Front; ///< two points a piece; empty once the front is
  BitingEnd End = BitingEnd::Complete;
};

/// The edges of the result as constraints of a triangulation of its points.
ConstraintEdges ConstraintsOf(const BitingResult& bites, const Domain& domain);

/// How many vertices the mesh will have, by the integral of 1/f^2 (see VertexEstimate.h).
double EstimateNumberOfVertices(double integratedDensity, double partLength = 1.0);

/// Bites the domain until nothing is left of it (paper, section 3.1): the vertices of the domain,
/// points on its segments, then places of the front, each bite a square of half-width c_b f or a
/// circle with that radius.
///
/// Laws (PAPER-NOTES; alpha the Lipschitz constant of f): no centre lies inside an earlier bite,
/// except that all input vertices are bitten however near they are; every point of the domain lies
/// in a bite. The front is kept as the set of its uncovered vertices: it needs no linked list, no
/// priority search tree, no cuts at holes (paper, section 5).
/// With PreserveBoundary the shields of segments are bites of the second phase: they count, and no
/// centre lies inside them, but they make no vertex. All else holds, but for theorem 4.6 and lemma
/// 4.11, which need vertices along the edges.
/// With Bisectors a centre may lie in an inner bite, but not in its core, t times as wide; all
/// points of the domain lie in a bite all the same: what bisector points leave over, is bitten at
/// places of the front (LeftOvers.h). Inner squares are turned to the bond of the two bites that
/// they stand on. With N the distance to the nearest vertex, t c_b f / (1 + t alpha c_b) <= N <= 2
/// r c_b f / (1 - r alpha c_b) then stands for theorem 4.6, c_p = t c_b / (2 + t alpha c_b) for
/// that of lemma 4.2, and R/l <= r / (t (1 - 2 r alpha c_b)) for lemma 4.10; r is sqrt(2) for
/// squares, 1 for circles. With FollowSlope all c_b in these are the least of any bite for what is
/// bounded below by it, and the greatest for what is bounded above: c_b times the bounds of
/// ReachFactor for alpha. BestFirst at corners is the same as Layers. Cost O(n) for Layers and
/// BestFirst, O(n log n) for LargestY.
BitingResult BiteDomain(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
  double expectedVertices, const BitingOptions& options, Monitor& monitor);

} // namespace biting

#endif
