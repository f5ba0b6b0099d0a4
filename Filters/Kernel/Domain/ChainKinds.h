// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingChainKinds_h
#define BitingChainKinds_h

#include "../Base/Ids.h"
#include "../Base/Point2.h"
#include "SegmentTree.h" // for SegmentEnds

#include <cstdint> // for flags
#include <vector>  // for the arrays

namespace biting
{

/// Which segments of a graph bound, by even-odd parity; 1 where the inside changes.
///
/// `counts` says how often each segment is drawn; 0: it does not belong to the graph. Segments meet
/// at common ends only. Bridges do not bound. A component that is left after the bridges are taken
/// away bounds by parity where all its vertices have even degree (counted as often as drawn), else
/// by its outline: the segments that its outer face touches. In the result every vertex has even
/// degree. Where the input has that already, the result is the parity of the counts.
/// Cost O(n log n). Source: R. Tarjan, "A note on finding the bridges of a graph", 1974.
std::vector<std::uint8_t> FindBoundary(const std::vector<Point2>& vertices,
  const std::vector<SegmentEnds>& segments, const std::vector<Id>& counts);

} // namespace biting

#endif
