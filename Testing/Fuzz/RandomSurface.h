// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRandomSurface_h
#define BitingRandomSurface_h

#include "FuzzNumbers.h"
#include "Space/Meshing/BodyMesher.h"

#include <ostream> // for files
#include <string>  // for words
#include <vector>  // for values

namespace biting
{

/// What is made up.
enum class SurfaceSort
{
  Body,  ///< closed, but for what Spoil does; few triangles, f for 11 to 128 vertices on them
  Open,  ///< the same, and open ones, and values by place: to be meshed, not filled
  Large, ///< for up to 6000 vertices; one in 50 of the others is of this sort
};

/// A surface of space, with options, made up from a seed.
struct SurfaceCase
{
  SurfaceMesh Input;
  std::vector<Id> Values; ///< of cells, for BodyMesherOptions; empty: none
  SurfaceCheckOptions Check;
  BodyMesherOptions Options; ///< Spacing is set, Regions are not
  double LargestSize = 0.0;  ///< of f
  double Volume = -1.0;      ///< within, by how it was made; below 0: not known
  bool IsToMesh = true;      ///< its surface alone
  bool IsToFill = true;
  bool IsFair = false; ///< closed, and nothing is thinner than 3 f or sharper than 60 degrees
  std::string Words;   ///< what it is
};

/// Boxes, balls with bumps, tori, prisms with sharp and reflex edges, plates, shells within each
/// other, bodies that share walls, touch or cross; some of them with slivers, T-junctions, holes,
/// triangles that are turned or there twice, jittered, turned, moved, scaled, of float places.
/// Small ones: parts of a lattice of cubes or tetrahedra, of one material or three, too; twins as
/// near as rounding, noise, patches.
SurfaceCase MakeSurfaceCase(FuzzNumbers& numbers, SurfaceSort sort);

/// As legacy VTK file.
void WriteLegacyVtk(std::ostream& stream, const SurfaceCase& surface, const std::string& title);

} // namespace biting

#endif
