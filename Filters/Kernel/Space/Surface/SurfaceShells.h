// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSurfaceShells_h
#define BitingSurfaceShells_h

#include "../../Base/Problem.h"
#include "SurfaceCrossings.h"

#include <vector> // for shells

namespace biting
{

/// Triangles that hang together by edges of two triangles.
struct SurfaceShell
{
  Id FirstTriangle = NoId;
  Id Triangles = 0;
  bool IsClosed = true; ///< each of its edges has two triangles
  bool IsOrientable = true;
  bool IsBounding = true; ///< orientable, and along each edge run as many triangles as against it
  double Volume = 0.0;    ///< enclosed, signed: above 0 where the triangles face outwards
  Id Depth = 0;           ///< of bounding ones: how many others of these are around it
};

struct SurfaceShells
{
  std::vector<Id> ShellOf; ///< of each triangle
  std::vector<SurfaceShell> Shells;
  std::vector<Id> RegionOf; ///< of each triangle: its part, which hangs together by vertices
  Id NumberOfParts = 0;
  bool AreBalanced = true; ///< of all triangles as many run along each crowded edge as against it

  const SurfaceShell& Of(std::size_t triangle) const
  {
    return this->Shells[static_cast<std::size_t>(this->ShellOf[triangle])];
  }

  /// Whether it has an inside, by its own triangles.
  bool IsSolid(std::size_t triangle) const
  {
    return this->Of(triangle).IsClosed && this->Of(triangle).IsOrientable;
  }
};

/// Finds shells and parts, and orients each shell as the majority of its triangles is; links
/// follow. Edges whose triangles were not oriented alike are told as InconsistentEdges, one problem
/// a shell; shells that have one side only (Moebius) as NotOrientable.
SurfaceShells FindShells(
  SurfaceMesh& mesh, SurfaceLinks& links, ProblemList& problems, Pulse& pulse);

/// Orients bounding shells by nesting: outwards where an even number of others is around them, else
/// inwards; links follow. Shells that cross are not around each other. Decided by exact signs along
/// a ray from a vertex; of shells that touch others, which may be within these in part, also from
/// the middles of triangles; all farther than the noise from others. `tree` has all triangles.
void OrientByNesting(SurfaceMesh& mesh, SurfaceLinks& links, const BoxTree<SurfaceItem, 3>& tree,
  const std::vector<SurfaceContact>& crossings, const std::vector<SurfaceContact>& touches,
  double noise, SurfaceShells& shells, Pulse& pulse);

} // namespace biting

#endif
