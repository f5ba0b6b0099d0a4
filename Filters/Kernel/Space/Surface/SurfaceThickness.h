// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSurfaceThickness_h
#define BitingSurfaceThickness_h

#include "../../Base/BoxTree.h"
#include "../../Base/Pulse.h"
#include "SurfaceShells.h"

namespace biting
{

/// The smallest thickness that was found, and where.
struct SurfaceThickness
{
  double Value = 0.0; ///< the diameter of the ball; 0 where none was found
  Point3 Place;       ///< its centre
  Id First = NoId;    ///< the triangles that it touches
  Id Second = NoId;
};

/// The smallest ball that touches a closed surface from inside at two places that face each other:
/// shrinking balls (Ma, Bae, Choi, "3D medial axis point approximation using nearest neighbors and
/// the normal field", 2012), which begin below the smallest diameter found so far.
///
/// An approximation: balls touch at the middles of triangles; walls face each other if their
/// normals are opposite within 20 degrees and they have no common corner, so that wedges and
/// creases are no thin places; of two places that differ by less than 4 % either may be told. At
/// most 100,000 triangles, evenly taken, are looked at, and the search ends once four million pairs
/// of balls and triangles were tested.
SurfaceThickness SmallestThickness(const SurfaceMesh& mesh, const BoxTree<SurfaceItem, 3>& tree,
  const SurfaceShells& shells, Pulse& pulse);

} // namespace biting

#endif
