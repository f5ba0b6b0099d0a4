// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSurfaceCheck_h
#define BitingSurfaceCheck_h

#include "../../Base/Monitor.h"
#include "../../Base/Problem.h"
#include "SurfaceCrossings.h"
#include "SurfaceHoles.h"
#include "SurfaceShells.h"
#include "SurfaceThickness.h"

#include <cstdint> // for counts
#include <vector>  // for edges

// What is wrong with a surface, and where; and the surface as other rooms of space take it: welded,
// without flat and duplicate triangles, oriented by nesting. Open, crossing and non-manifold
// surfaces stay what they are, but for holes that are to be closed (SurfaceHoles.h). Topology is
// decided by exact signs; the one tolerance is the rounding of the coordinates. The result does not
// depend on the number of threads.

namespace biting
{

struct SurfaceCheckOptions
{
  Point3 Rounding;            ///< along each axis: vertices of open edges that near are one
  double Noise = 0.0;         ///< contacts that are not deeper only touch
  double FeatureAngle = 40.0; ///< degrees by which the surface turns at a feature
  bool TellsThickness = true; ///< the smallest, which is 0 else
  SpacingField Spacing;       ///< f: holes and slits that are narrow for it are closed; empty: none
};

enum class SurfaceEdgeKind : std::uint8_t
{
  Feature = 0,
  Border = 1,
  NonManifold = 2
};

struct SurfaceFigures
{
  std::int64_t WeldedPoints = 0; ///< at the place of others, or nearer to one than rounding
  std::int64_t Edges = 0;
  std::int64_t OpenEdges = 0;
  std::int64_t NonManifoldEdges = 0;
  std::int64_t Parts = 0;       ///< that hang together by vertices
  std::int64_t Cavities = 0;    ///< closed shells inside an odd number of others
  std::int64_t EulerNumber = 0; ///< vertices - edges + triangles
  std::int64_t Touches = 0;     ///< contacts that are not deeper than rounding
  double Area = 0.0;
  double Volume = 0.0; ///< enclosed; a number only where no edge is open
  double Diagonal = 0.0;
};

struct CheckedSurface
{
  SurfaceMesh Mesh;
  SurfaceShells Shells;
  std::vector<Id> EdgeEnds; ///< of feature edges, two vertices each
  std::vector<SurfaceEdgeKind> EdgeKinds;
  std::vector<SurfaceContact> Crossings; ///< deeper than noise, and folds
  std::vector<SurfaceContact> Touches;   ///< not deeper
  SurfaceFigures Figures;
  SurfaceThickness Thickness;
};

/// Checks a surface as it comes: one vertex a corner, or shared ones, or both. Problems get what is
/// wrong, with ids of cells and points of the input.
/// Cost O(n log n) but for pairs of triangles whose boxes meet.
/// Where the monitor asks to stop the result has no meaning, and Aborted is among the problems.
CheckedSurface CheckSurface(
  SurfaceMesh surface, const SurfaceCheckOptions& options, ProblemList& problems, Monitor& monitor);

} // namespace biting

#endif
