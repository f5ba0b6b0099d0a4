// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingWholeCheck_h
#define BitingWholeCheck_h

#include "../../Base/Ids.h"
#include "../../Base/Point.h"
#include "../Surface/SurfaceCheck.h"

#include <string> // for the reason
#include <vector> // for the arrays

namespace biting
{

/// Whether two meshes of one surface agree, part by part. A part is connected through vertices.
struct WholeVerdict
{
  bool IsSame = true;
  bool IsCoarse = false; ///< the same topology: area or volume differ
  Point3 Place;          ///< on the part that differs
  Id Triangle = 0;       ///< of the surface, there
  std::string What;      ///< the figures that differ
};

/// Whether the mesh has the parts of the surface, each with the same Euler number, nearly the same
/// area and, if the surface is closed, volume. `below`: of each triangle of the mesh, the triangle
/// of the surface.
WholeVerdict CheckWhole(const CheckedSurface& surface, const std::vector<Point3>& points,
  const std::vector<Id>& corners, const std::vector<Id>& below, Pulse& pulse);

} // namespace biting

#endif
