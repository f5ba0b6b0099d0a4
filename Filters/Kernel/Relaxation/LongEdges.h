// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingLongEdges_h
#define BitingLongEdges_h

#include "../Base/Pulse.h"
#include "DelaunayMesh.h"

namespace biting
{

/// Splits inner edges of more than `longest` spacings, the longest first, and smooths around the
/// new vertices: what smoothing cannot mend between vertices that are held, a vertex more may, so
/// that none of them has to go. A split is kept where no triangle near by then is both worse than
/// the worst one was and beyond `greatestCotangent`, and no edge of the new vertex is shorter than
/// 0.75 spacings. Edges beside vertices with more triangles than a Star holds stay.
void SplitLongEdges(DelaunayMesh& mesh, double longest, double greatestCotangent, Pulse& pulse);

} // namespace biting

#endif
