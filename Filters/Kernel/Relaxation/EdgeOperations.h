// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingEdgeOperations_h
#define BitingEdgeOperations_h

#include "../Base/Ids.h"
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

} // namespace biting

#endif
