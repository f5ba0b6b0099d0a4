// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingInteriorBites_h
#define BitingInteriorBites_h

#include "../../Base/Ids.h"
#include "../../Base/Point.h"
#include "../../Base/Pulse.h"

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
  std::vector<double> Weights;  ///< of the vertices in the regular triangulation
  std::vector<Id> Facets;       ///< three vertices each
  std::vector<EmptyBall> Balls; ///< of each facet: no interior bite has its center within it

  /// Whether a place that no boundary bite takes lies in the body; any number of threads may ask.
  std::function<bool(const Point3&)> IsInside;

  /// f at any place; any number of threads may ask.
  std::function<double(const Point3&)> Spacing;
};

struct InteriorBites
{
  std::vector<Point3> Centers; ///< in the order of biting
  std::vector<double> Sizes;   ///< f there
  std::vector<double> Radii;   ///< of spheres; half of the sides of cubes
};

/// Bites the inside of a body until all of it is taken (paper, section 6).
///
/// First in, first out from the boundary: a candidate is where the surfaces of three bites meet; it
/// becomes a bite where no earlier one, nor an empty ball, has it inside.
/// More than `mostBites`: the result is incomplete.
InteriorBites BiteInterior(
  const BodyBoundary& boundary, SpaceBiteShape shape, std::size_t mostBites, Pulse& pulse);

} // namespace biting

#endif
