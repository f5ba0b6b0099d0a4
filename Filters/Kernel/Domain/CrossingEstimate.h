// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCrossingEstimate_h
#define BitingCrossingEstimate_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "SegmentTree.h"

#include <cstddef> // for size_t
#include <vector>  // for the edges

namespace biting
{

/// How many pairs of edges cross, and one of them, for a message.
struct CrossingEstimate
{
  double Count = 0.0;
  Id First = NoId;
  Id Second = NoId;
};

/// About how many pairs of edges cross, where these are beyond doubt more than `most`; else none,
/// also where the monitor wants to stop. `tree` has the `edges`.
///
/// Counts the crossings of some edges, spread over all, until the mean number is on one side of
/// what `most` would give by four standard errors. An edge that crosses far more than the others
/// counts as less than it does, so that a few of them decide nothing. Takes tenths of a second
/// where counting all of the crossings may take ten.
CrossingEstimate EstimateCrossingsAbove(std::size_t most, const std::vector<Point2>& vertices,
  const std::vector<SegmentEnds>& edges, const SegmentTree& tree, Pulse& pulse);

} // namespace biting

#endif
