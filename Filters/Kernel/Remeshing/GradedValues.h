// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGradedValues_h
#define BitingGradedValues_h

#include "../Base/Monitor.h"
#include "OldMesh.h"

#include <vector> // for values

namespace biting
{

/// Lowers `values`, one a vertex, until they grow by `gradation` at most through the mesh, to 2 %
/// of it: to the largest that are nowhere above what is given, or above these, by 5 % at most
/// where all grow from one vertex. Distances are those of the plane where triangles have no
/// obtuse angles, along edges where they have; none leads through holes. A gradation of 0 lowers
/// nothing.
///
/// Method: points hand on what they allow to the corners of the triangles around them, lowest
/// first, over the edge across (Kimmel and Sethian, "Computing geodesic paths on manifolds",
/// 1998). Cost: one pass over the triangles; where something is steep, O(n) once more, and O(m
/// log m) for m vertices that are lowered. Where the monitor asks to stop the values have no
/// meaning.
void LowerToGradation(
  const OldMesh& mesh, double gradation, std::vector<double>& values, Monitor& monitor);

/// Whether linear interpolation keeps to `gradation`, as far as triangles of ordinary shape let it:
/// no gradient is above twice that. It is at a vertex whose value is least, with an angle of 120
/// degrees. In thinner triangles it may be anything.
bool IsGradedBetween(
  const OldMesh& mesh, double gradation, const std::vector<double>& values, Monitor& monitor);

} // namespace biting

#endif
