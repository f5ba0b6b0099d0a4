// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSharpSectors_h
#define BitingSharpSectors_h

#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Base/Problem.h"
#include "../Base/Pulse.h"
#include "../Biting/BitingScheme.h"
#include "../Delaunay/Triangulation.h"
#include "../Domain/Domain.h"

// What the sharp corners of the drawing (Biting/Spokes.h) do to the mesh, whatever the spacing.

namespace biting
{

/// Adds a problem for each angle of the domain between two segments that is below 0.01 degrees
/// (ProblemCode::NarrowAngles): the triangle there is as thin. Cost O(n log n).
void ReportNarrowAngles(const Domain& domain, ProblemList& problems, Pulse& pulse);

/// How many triangles are poor only because the input is: with an angle below 30 degrees, and all
/// vertices on the two sides of one corner of the domain that is below 60 degrees. A mesh that
/// keeps to f cannot have much better ones there (Biting/SharpCorners.h).
/// `mesh` refers to the points of `bites`. Cost O(n), little of it for triangles within the domain.
Id CountSharpCornerTriangles(
  const Domain& domain, const BitingResult& bites, const Triangulation& mesh, Monitor& monitor);

} // namespace biting

#endif
