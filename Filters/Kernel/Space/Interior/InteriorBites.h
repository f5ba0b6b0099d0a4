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

/// The boundary of a body as it is filled.
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

/// Of cubes: unit, at right angles to each other.
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
/// First in, first out from the boundary: a candidate is where the surfaces of three bites meet; it
/// becomes a bite where no earlier one has it within its guard, .9 of the bite, nor an empty ball
/// has it inside. Empty balls are no bites, but their spheres have candidates, too: so all corners
/// of what is not taken have been candidates. Then nothing is left. All balls of positive guard are
/// apart, so that the number of bites is finite where f is above a positive number.
/// Vertices of the boundary are bites of the same shape; no center is in the ball of a weight, nor
/// nearer to a vertex than .15 of the radius of an empty ball at it.
///
/// Only candidates with a parent on the boundary are asked to be inside: bites and empty balls of
/// the boundary are a wall thicker than the radius of a sphere. Cubes and larger spheres reach
/// beyond it: all their candidates are asked.
///
/// `constant`: radius of a sphere, or half the side of a cube, in f; 0: the one for which edges of
/// the mesh are as long as f in the mean. Bites of the boundary have that one in any case.
/// More than `mostBites`: the result is incomplete. Without threads; deterministic.
/// Cost: O(n log n) by the depth of a tree; some 10 us a bite, of cubes ten times that.
/// Memory: some 300 bytes a bite. (Not measured.)
InteriorBites BiteInterior(const BodyBoundary& boundary, SpaceBiteShape shape,
  std::size_t mostBites, Pulse& pulse, double constant = 0.0);

} // namespace biting

#endif
