// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGradedValues_h
#define BitingGradedValues_h

#include "../Base/Monitor.h"
#include "OldMesh.h"

#include <vector> // for values

namespace biting
{

/// Lowers `values` v, one a vertex, to the largest with v(b) - v(a) <= gradation * d(a, b) through
/// the mesh, to 2 % of the gradation; where all grow from one vertex they may be 5 % above that. d
/// is the distance in the plane where triangles have no obtuse angles, along edges where they have;
/// no way leads through holes. The linear interpolation between the vertices is at most twice as
/// steep where no angle is above 120 degrees. In other triangles it may be steeper. A gradation of
/// 0 lowers nothing.
///
/// Method: the eikonal equation by fast marching. Vertices hand on what they allow to the corners
/// of the triangles around them, lowest first, over the edge across (Kimmel and Sethian, "Computing
/// geodesic paths on manifolds", 1998). Cost: one pass over the triangles; where something is
/// steep, O(n) once more, and O(m log m) for m vertices that are lowered. Where the monitor asks to
/// stop the values have no meaning.
void LowerToGradation(
  const OldMesh& mesh, double gradation, std::vector<double>& values, Monitor& monitor);

} // namespace biting

#endif
