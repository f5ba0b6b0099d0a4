// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRelaxation_h
#define BitingRelaxation_h

#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Base/Point.h"
#include "../Delaunay/Triangulation.h"
#include "../Domain/Domain.h"
#include "../Spacing/Spacing.h"

#include <cstdint>    // for flags
#include <functional> // for the search
#include <vector>     // for the arrays

namespace biting
{

/// Held vertices: they stay in place unless they spoil a triangle or an edge.
struct HoldOptions
{
  Id Count = 0; ///< the first vertices after those of the domain that are on no segment

  // A held vertex is released beside an angle with a larger cotangent, or an edge that is shorter
  // or longer than these, in units of f.
  double GreatestCotangent = 0.0;
  double ShortestEdge = 0.0;
  double LongestEdge = 0.0;

  int Rounds = 0; ///< of looking for vertices to release

  /// Flags of the held vertices, or empty. A flagged vertex is released only where no other held
  /// vertex can be.
  std::vector<std::uint8_t> AreLast = {};

  /// The place nearest to `place` to hold a vertex at, or null where none is within `reach`; empty:
  /// there are none.
  std::function<const Point2*(const Point2& place, double reach)> FindPlace = {};
  double ReachOfPlaces = 0.0;             ///< in units of the spacing
  double GreatestCotangentAtPlaces = 0.0; ///< beside a vertex that goes to one
};

struct RelaxationOptions
{
  /// False: no vertex is added on segments; those that are there may slide, or go.
  bool DividesSegments = true;

  /// False: the last attempts at single triangles are left out.
  bool TriesTopologies = true;

  /// Factor on the cotangents from which angles count as poor: below 1 more angles do.
  double PoorCotangents = 1.0;

  HoldOptions Hold = {};
};

/// A mesh of a domain, and the segments that bind it.
struct RelaxationMesh
{
  // Vertices: those of the domain in their order, then the others.
  std::vector<Point2> Points;
  std::vector<double> Spacings;
  std::vector<Id> Segments; ///< the domain segment on which a new vertex lies, or NoId

  // The parts into which the segments are divided; Triangles.Constraints refers to them.
  std::vector<Id> EdgeStarts;
  std::vector<Id> EdgeEnds;
  std::vector<Id> EdgeSegments;

  Triangulation Triangles;
};

struct RelaxationResult
{
  std::vector<Id> Origins; ///< of each vertex: what it was before, NoId where it is new
  bool WasAborted = false; ///< the mesh is empty then
};

/// Makes the triangles of `mesh` better: vertices are moved, inserted and removed, and edges flip.
///
/// - Collapses and splits of edges bring the number of triangles at each vertex towards six and the
///   lengths of edges towards the spacing.
/// - All vertices are smoothed for the mean ratio of the triangles around them.
/// - The worst triangles are improved one by one.
/// - Held vertices that spoil triangles are then released, round by round, and the mesh near them
///   is improved again. At the end each released vertex goes back to its place if its triangles
///   allow that, and other free vertices go to a place of HoldOptions::FindPlace if theirs do. The
///   vertices between held ones are smoothed once more, within the limits of the hold.
///
/// Vertices of the domain stay, bit for bit, and come first in their order; then those that were
/// there before, in their order; then new ones. Vertices on segments stay on them, to rounding, and
/// may slide, or be inserted and removed there, unless other segments are so near that rounding
/// could make them meet. Edges on segments are listed segment by segment, from start to end, each
/// the whole of one mesh edge.
///
/// Laws: all triangles are counterclockwise, exactly; the union of triangles, and that of the
/// edges on each segment, stay what they were, to rounding; the mesh is constrained Delaunay,
/// exactly, hence phi-Delaunay for any phi; no smallest angle falls below both 20 degrees and the
/// smallest of the mesh before; the result depends on the arguments alone. A mesh with nothing to
/// improve stays nearly the same.
/// Not promised: more than the input allows. A triangle in an input angle is no better than that
/// angle, and where input vertices are much nearer to each other than the spacing, edges there are
/// out of proportion to it.
/// Cost O(n): it grows with the share of triangles that are poor. Triangles that stay below 38
/// degrees are attempted singly (TopologyTrials.h): at most m = 8 + min(n / 60, 64) + n / 20000 of
/// them for n vertices. Where vertices are held and more than m stay below 38 degrees, only those
/// below 35 degrees, or below the angle of HoldOptions if larger.
/// Precondition: `mesh` passes CheckMesh (MeshCheck.h); it need not be Delaunay.
RelaxationResult Relax(const Domain& domain, const Spacing& spacing,
  const RelaxationOptions& options, RelaxationMesh& mesh, Monitor& monitor);

} // namespace biting

#endif
