// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSurfaceBites_h
#define BitingSurfaceBites_h

#include "../../Base/Pulse.h"
#include "../Features/SurfaceGround.h"

#include <vector> // for the arrays

namespace biting
{

/// Bites on a surface, in their order: first the corners, then the vertices of chains, then those
/// of the surface. A bite is the connected part of the surface within its ball that has its centre;
/// the bite of a centre on no feature ends at feature lines. So a bite has no part of an opposite
/// wall.
struct SurfaceBites
{
  std::vector<Point3> Centers;
  std::vector<double> Sizes;      ///< f; at features the length of the shortest piece there
  std::vector<double> Radii;      ///< of balls
  std::vector<double> Guards;     ///< while biting: no later centre in a bite is nearer to its
  std::vector<Id> Triangles;      ///< of the ground, where the centre lies
  std::vector<Id> GroundVertices; ///< of corners; else NoId
  Id NumberOfCorners = 0;
  Id NumberOnLines = 0; ///< of bites at corners and on chains

  // Pieces of chains: two bites each.
  std::vector<Id> PieceEnds;
  std::vector<Id> PieceChains;

  Id Size() const { return static_cast<Id>(this->Centers.size()); }

  /// Of the regular triangulation: vertices of features are balls, which touch along chains and
  /// keep them.
  double WeightOf(Id bite) const
  {
    const double size = WeightShare * this->Sizes[static_cast<std::size_t>(bite)];
    return bite < this->NumberOnLines ? size * size : 0.0;
  }

  static constexpr double WeightShare = 0.9;
};

/// Radius of a bite of the surface, in f, for a mean edge length f.
constexpr double SurfaceBitingConstant = 0.94;

/// Bites the surface, until all of it is taken.
///
/// Chains are divided by equal integrals of 1/f. Then first in, first out: a candidate is where the
/// spheres of two bites and the surface meet, or anywhere on the sphere of a bite that meets no
/// other; it becomes a bite where it lies in the guard of no earlier one. All of a patch is taken
/// once no candidate is left: a remaining part would be bounded by spheres, and its corners would
/// be candidates.
/// More than `mostBites`: the result is incomplete.
SurfaceBites BiteSurface(const SurfaceGround& ground, std::size_t mostBites, Pulse& pulse);

} // namespace biting

#endif
