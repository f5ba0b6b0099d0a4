// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingInteriorBites_h
#define BitingInteriorBites_h

#include "../../Base/Ids.h"
#include "../../Base/Point.h"
#include "../../Base/Pulse.h"

#include <array>      // for axes
#include <cstddef>    // for counts
#include <cstdint>    // for kinds
#include <functional> // for f
#include <vector>     // for the arrays

namespace biting
{

enum class SpaceBiteShape : std::uint8_t
{
  Sphere = 0,
  Cube = 1 ///< axes of the nearest flat boundary for the first layers, then those of the world
};

/// A ball that stays empty: its facet is in the Delaunay triangulation of the boundary's vertices.
struct EmptyBall
{
  Point3 Center;
  double Radius = 0.0;
};

/// The boundary of a body to be filled. A ball of radius 0 has no effect.
struct BodyBoundary
{
  std::vector<Point3> Centers;  ///< of the bites of the boundary, which are its vertices
  std::vector<double> Sizes;    ///< f there
  std::vector<double> Weights;  ///< in the regular triangulation
  std::vector<Id> Facets;       ///< three vertices each
  std::vector<EmptyBall> Balls; ///< of each facet: no interior bite has its center within it

  /// Whether a place that no boundary bite takes lies in the body; any number of threads may ask.
  std::function<bool(const Point3&)> IsInside;

  /// f at any place; any number of threads may ask.
  std::function<double(const Point3&)> Spacing;
};

/// Axes of a cube: unit vectors at right angles to each other.
using CubeAxes = std::array<Point3, 3>;

struct InteriorBites
{
  std::vector<Point3> Centers; ///< in the order of biting
  std::vector<double> Sizes;   ///< f there
  std::vector<double> Radii;   ///< of spheres; half of the sides of cubes
  std::vector<CubeAxes> Axes;  ///< of cubes; none of spheres
};

/// Bites the inside of a body until all of it is taken (paper, section 6).
///
/// First in, first out from the boundary. A candidate is where the surfaces of three bites meet. It
/// becomes a bite where it is in no guard: .9 of an earlier bite, an empty ball, the ball of the
/// weight of a vertex, .15 of the radius of an empty ball about each of its vertices. So centers of
/// bites are apart, and there are finitely many where f is above a positive number.
///
/// Vertices of the boundary are bites of the same shape. Among spheres, empty balls have candidates
/// as bites have. So nothing is left: a part of the body outside of all spheres would have a corner
/// inside the body, as bites and empty balls cover the boundary, and each such corner was a
/// candidate. Among cubes, empty balls are guards only: there this is tested, not proven.
///
/// A candidate with a parent on the boundary is tested to be inside. Others need no test: bites and
/// empty balls of the boundary are a wall thicker than the radius of a sphere. Cubes, and spheres
/// of a larger `constant`, reach beyond it: all their candidates are tested.
///
/// `constant`: radius of a sphere, or half the side of a cube, in f; 0: the shape's BitingConstant,
/// for a mean edge length f. Bites of the boundary always have that one.
/// More than `mostBites`: the result is incomplete. Deterministic; uses no threads.
/// Cost: 8 to 12 us a bite, of cubes ten times that; 300 bytes a bite. (Measured at 4 10^5 bites.)
InteriorBites BiteInterior(const BodyBoundary& boundary, SpaceBiteShape shape,
  std::size_t mostBites, Pulse& pulse, double constant = 0.0);

} // namespace biting

#endif
