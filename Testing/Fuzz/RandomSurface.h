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

/// A surface of space, with options, made up from a seed.
struct SurfaceCase
{
  SurfaceMesh Input;
  std::vector<Id> Values; ///< of cells, for BodyMesherOptions; empty: none
  SurfaceCheckOptions Check;
  BodyMesherOptions Options; ///< Spacing is set, Regions are not
  double LargestSize = 0.0;  ///< of f
  bool IsFair = false;       ///< closed, and nothing is thinner than 3 f or sharper than 60 degrees
  std::string Words;         ///< what it is
};

/// Boxes, balls with bumps, tori, prisms with sharp and reflex edges, plates, shells within each
/// other, bodies that share walls, touch or cross; some of them with slivers, T-junctions, holes,
/// triangles that are turned or there twice, jittered, turned, moved, scaled, of float places.
SurfaceCase MakeSurfaceCase(FuzzNumbers& numbers);

/// As legacy VTK file.
void WriteLegacyVtk(std::ostream& stream, const SurfaceCase& surface, const std::string& title);

} // namespace biting

#endif
