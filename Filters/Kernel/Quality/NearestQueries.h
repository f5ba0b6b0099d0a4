// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingNearestQueries_h
#define BitingNearestQueries_h

#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Base/Point2.h"

#include <vector> // for the arrays

namespace biting
{

/// A place, and how near another vertex is known to be.
struct NearestQuery
{
  Point2 Place;
  double Distance;
  Id Vertex; ///< that it is the place of, among `points`; NoId: none
};

/// For each query the distance of the nearest of `points` but its own vertex, or what is known,
/// where none is nearer. Empty where the monitor asked to stop.
std::vector<double> NearestDistances(const std::vector<Point2>& points,
  const std::vector<NearestQuery>& queries, Monitor& monitor = NoMonitor());

} // namespace biting

#endif
