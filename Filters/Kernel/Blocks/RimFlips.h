// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRimFlips_h
#define BitingRimFlips_h

#include "../Base/Point.h"
#include "../Base/Pulse.h"
#include "../Delaunay/Triangulation.h"

#include <cstddef> // for slots
#include <vector>  // for the arrays

namespace biting
{

/// Makes the mesh constrained Delaunay by flips, exactly, given that all edges that may not be so
/// are opposite the corners `slots`. Where the monitor wants to stop the mesh is valid, no more.
/// False where they came to an edge with nothing across it and no constraint: what is there is
/// missing, and the mesh is not that of the whole.
bool FlipUntilDelaunay(const std::vector<Point2>& points, std::vector<std::size_t> slots,
  Triangulation& mesh, Pulse& pulse);

} // namespace biting

#endif
