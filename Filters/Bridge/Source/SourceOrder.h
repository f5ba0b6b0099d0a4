// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSourceOrder_h
#define BitingSourceOrder_h

#include "../../Kernel/Base/Pulse.h"
#include "../../Kernel/Spacing/Spacing.h"

namespace biting
{

/// Sorts the points of a source by place and value, and its triangles or segments by the numbers of
/// their corners. Points of the same place and value become one; what then occurs again, and
/// triangles of less than three points, go. Law: what a source says does not depend on the order in
/// which its points and cells were read, nor on whether cells share points. Cost O(n log n). Where
/// the monitor asks to stop the source has no meaning.
void SortSource(TriangulatedSource& source, Pulse& pulse);
void SortSource(SegmentSource& source, Pulse& pulse);

} // namespace biting

#endif
