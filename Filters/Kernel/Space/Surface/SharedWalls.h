// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSharedWalls_h
#define BitingSharedWalls_h

#include "../../Base/Problem.h"
#include "../../Base/Pulse.h"
#include "SurfaceMesh.h"

namespace biting
{

/// Makes the walls alike that two regions give, each on its own, with the same vertices but other
/// triangles: as contours of labels have them. They overlap in one plane, cross or enclose slivers
/// of space otherwise.
///
/// An edge of one region's surface whose ends are vertices of another region's surface becomes an
/// edge of that, too: the strip of at most four triangles between its ends is divided anew. Edges
/// that several regions have stay, so that each change makes one more of these, and changes end. A
/// strip is divided only where its edges are nearer to the new one than a quarter of the length of
/// that. Then triangles of two regions that share an edge and lie on each other, nearer than a
/// twentieth of their sides: the sides that cross get a common vertex, so that the triangle below
/// it is of both. No vertex moves, and each surface stays as closed as it is; its volume changes by
/// the space between old and new triangles. Each change is told as DuplicateTriangles.
/// Nothing changes where a region's surface is open, as that of a tag of a part of a surface is, or
/// where triangles of two regions are given. Cost O(n log n) a round.
void JoinSharedWalls(SurfaceMesh& mesh, ProblemList& problems, Pulse& pulse);

} // namespace biting

#endif
