// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingEdgeOperations_h
#define BitingEdgeOperations_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "DelaunayMesh.h"
#include "MutableMesh.h"

namespace biting
{

/// Puts a vertex on the middle of the edge and returns it: free, or sliding where the edge has a
/// mark. NoId where rounding would leave a triangle without area.
Id SplitEdge(MutableMesh& mesh, Id edge);

/// Merges the two ends of the edge into one vertex and returns it: at the end with the lower
/// Freedom, or in the middle where both are the same. NoId, and nothing is changed, where
/// constraints or areas do not allow it.
Id CollapseEdge(MutableMesh& mesh, Id edge);

/// Splits inner edges of more than `longest` spacings, the longest first, and smooths around the
/// new vertices. Between held vertices, which smoothing cannot move, this keeps edges within the
/// limits without releasing a vertex. A split is kept if the worst triangle near by is not worse
/// than before or within `greatestCotangent`, and if no edge of the new vertex is shorter than
/// 0.75 spacings. Edges beside vertices with more triangles than a Star holds stay.
void SplitLongEdges(DelaunayMesh& mesh, double longest, double greatestCotangent, Pulse& pulse);

} // namespace biting

#endif
