// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSpatialOrder_h
#define BitingSpatialOrder_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Base/Pulse.h"

#include <vector> // for the order

namespace biting
{

/// An order in which `points` are inserted fast: a permutation of 0 .. n-1.
/// Rounds of quadrupling size, to which points belong by a hash of their index, keep the structure
/// balanced; within a round points follow a Hilbert curve, so each is near the one before.
/// The curve is refined where points crowd, whatever the grading. Deterministic. Cost O(n) for
/// coordinates of bounded grading.
/// Source: N. Amenta, S. Choi, G. Rote, "Incremental constructions con BRIO", 2003.
/// On abort the order has no meaning. Of points of the plane (D = 2) or of space (D = 3).
template <std::size_t D>
std::vector<Id> SpatialOrder(const std::vector<Point<D>>& points, Pulse& pulse);

} // namespace biting

#endif
