// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingLongEdges_h
#define BitingLongEdges_h

#include "../Base/Pulse.h"
#include "DelaunayMesh.h"

namespace biting
{

/// Splits inner edges of more than `longest` spacings, the longest first, and smooths around the
/// new vertices. Between held vertices, which smoothing cannot move, this keeps edges within the
/// limits without releasing a vertex. A split is kept if the worst triangle near by is not worse
/// than before or within `greatestCotangent`, and if no edge of the new vertex is shorter than
/// 0.75 spacings. Edges beside vertices with more triangles than a Star holds stay.
void SplitLongEdges(DelaunayMesh& mesh, double longest, double greatestCotangent, Pulse& pulse);

} // namespace biting

#endif
