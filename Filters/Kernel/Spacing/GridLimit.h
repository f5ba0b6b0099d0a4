// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGridLimit_h
#define BitingGridLimit_h

#include "ConeCollector.h"

namespace biting
{

/// The grid with each node lowered to what a gradation allows, measured from all other nodes; the
/// grid itself where nothing is steep. Where cells are so wide that interpolation between nodes is not
/// enough, `cones` has what the largest Lipschitz function below the interpolant grows from: the
/// sides of steep cells, and within them the lines along which the bilinear interpolant is exactly as
/// steep as the gradation.
/// The grid has no holes. Null if the monitor asks to stop. Linear in the number of nodes.
///
/// Method: nodes hand on to their neighbors, in two sweeps, the node that bounds them (vector
/// propagation, after Danielsson 1980), so that distances are those of the plane and not of paths
/// along the grid.
std::shared_ptr<const GridSource> LimitGrid(const std::shared_ptr<const GridSource>& source,
  double gradation, ConeCollector& cones, Monitor& monitor);

} // namespace biting

#endif
