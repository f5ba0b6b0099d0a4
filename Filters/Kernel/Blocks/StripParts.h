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

/// The width of a strip in steps across edges, from the triangles that it surrounds. Two steps are
/// about one ring of vertices.
constexpr int StripSteps = 6;

/// The triangles with a corner among `seeds`, and those at most `steps` across edges from these.
/// `vertices` is the number of vertices of the mesh.
TriangleList TrianglesAround(const Triangulation& mesh, std::size_t vertices,
  const std::vector<Id>& seeds, Pulse& pulse, int steps = StripSteps);

/// Parts of a mesh without common vertices. Each part grows across edges, from where another one
/// ended, to `most` triangles. Triangles between parts belong to no part.
std::vector<TriangleList> DivideIntoParts(
  const Triangulation& mesh, std::size_t vertices, std::size_t most, Pulse& pulse);

/// The connected components of `triangles`: triangles with a common vertex are in one component.
std::vector<TriangleList> ConnectedParts(
  const Triangulation& mesh, std::size_t vertices, const TriangleList& triangles, Pulse& pulse);

} // namespace biting

#endif
