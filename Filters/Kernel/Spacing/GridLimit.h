// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGridLimit_h
#define BitingGridLimit_h

#include "../Base/Box2.h"
#include "ConeCollector.h"

namespace biting
{

/// The grid with each node lowered to what a gradation allows, measured from all other nodes and the
/// sides of cells; the grid itself where nothing is steep. Outside of the grid the nearest border
/// value is what is given: as far as `bounds` reach it gets nodes there, before anything is limited.
/// Where cells are so wide that interpolation between nodes is not enough, `cones` has what the
/// largest Lipschitz function below the interpolant grows from (WideCells.h).
/// The grid has no holes. Null if the monitor asks to stop. Linear in the number of nodes.
///
/// Method: nodes hand on to their neighbors, in two sweeps, the place that bounds them (vector
/// propagation, after Danielsson 1980), so that distances are those of the plane and not of paths
/// along the grid.
std::shared_ptr<const GridSource> LimitGrid(const std::shared_ptr<const GridSource>& source,
  double gradation, const Box2& bounds, ConeCollector& cones, Monitor& monitor);

} // namespace biting

#endif
