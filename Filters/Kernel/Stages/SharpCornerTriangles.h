// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSharpCornerTriangles_h
#define BitingSharpCornerTriangles_h

#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Biting/BitingScheme.h"
#include "../Delaunay/Triangulation.h"
#include "../Domain/Domain.h"

namespace biting
{

/// How many triangles are poor only because the input is: with an angle below 30 degrees, and all
/// vertices on the two sides of one corner of the domain that is below 60 degrees. A mesh that
/// keeps to f cannot have much better ones there (Biting/SharpCorners.h).
/// `mesh` refers to the points of `bites`. Cost O(n), little of it for triangles within the domain.
Id CountSharpCornerTriangles(
  const Domain& domain, const BitingResult& bites, const Triangulation& mesh, Monitor& monitor);

} // namespace biting

#endif
