// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingStripParts_h
#define BitingStripParts_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "../Delaunay/Triangulation.h"

#include <cstddef> // for counts
#include <vector>  // for lists

namespace biting
{

/// Triangles of a mesh, in their order.
using TriangleList = std::vector<Id>;

/// How many steps across edges strips are wide, from what they are around; two are about a ring of
/// vertices.
constexpr int StripSteps = 6;

/// Of a mesh of so many vertices: the triangles with a corner among `seeds`, and those at most
/// `steps` across edges from these.
TriangleList TrianglesAround(const Triangulation& mesh, std::size_t vertices,
  const std::vector<Id>& seeds, Pulse& pulse, int steps = StripSteps);

/// Parts of a mesh of so many vertices, no two with a vertex in common: each grows across edges,
/// from where another one ended, to `most` triangles. Triangles between parts are of none.
std::vector<TriangleList> DivideIntoParts(
  const Triangulation& mesh, std::size_t vertices, std::size_t most, Pulse& pulse);

/// Some triangles as parts: those with a vertex in common are of one.
std::vector<TriangleList> ConnectedParts(
  const Triangulation& mesh, std::size_t vertices, const TriangleList& triangles, Pulse& pulse);

} // namespace biting

#endif
