// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingNearVertices_h
#define BitingNearVertices_h

#include "../Base/Ids.h"
#include "../Base/Point.h"

#include <utility> // for pairs
#include <vector>  // for the arrays

namespace biting
{

/// Pairs of different `vertices` that are not further apart than `nearest`, which may be 0: so many
/// that all are connected by them that are by such distances. Each pair once or twice, in an order
/// that depends on places and numbers alone. Cost O(n log n) where few places are that near to one,
/// however many vertices are at each.
std::vector<std::pair<Id, Id>> FindNearVertices(
  const std::vector<Point2>& points, std::vector<Id> vertices, double nearest);

} // namespace biting

#endif
