// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCellOverlaps_h
#define BitingCellOverlaps_h

#include "../Base/Problem.h"
#include "../Base/Pulse.h"
#include "Arrangement.h"
#include "Polylines.h"

namespace biting
{

/// Adds a problem for each place where faces of `input` lie on top of each other, by the edges that
/// are left of them in `arrangement`, where `area` is covered by an odd number of faces.
///
/// Faces that were joined over their common edges are one surface. A surface within another that is
/// a single face is a hole of it: NestedCells, where no OverlappingCells are known. These are, with
/// the first of the cells: two faces on the same side of an edge; a surface whose outline lies
/// partly within others and partly not; a surface within another of several faces, which may divide
/// them.
///
/// Where all faces together have the area that is covered, nothing overlaps: then the cost is O(1)
/// a edge, else that of a sweep, O(n log n). The orientation of faces plays no part; one that
/// crosses itself may hide what lies on it.
void ReportCellOverlaps(const Arrangement& arrangement, const Polylines& input, double area,
  ProblemList& problems, Pulse& pulse);

} // namespace biting

#endif
