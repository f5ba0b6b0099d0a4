// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGridHoles_h
#define BitingGridHoles_h

#include "Spacing.h"

namespace biting
{

/// The grid with the value of the nearest given node at each node whose value is NaN; the grid
/// itself where there is none. At least one value is given. Linear in the number of nodes. Null if
/// the monitor asks to stop.
/// Method: nodes hand on the node that is nearest (vector propagation, after Danielsson 1980).
/// Where two are nearly as near it may be the other one.
std::shared_ptr<const GridSource> FillHoles(
  std::shared_ptr<const GridSource> source, Monitor& monitor = NoMonitor());

/// The same spacing on a grid that reaches to the border of `bounds`, with a row or column of nodes
/// there; the grid itself where it reaches so far.
std::shared_ptr<const GridSource> ReachingOver(
  const std::shared_ptr<const GridSource>& source, const Box2& bounds);

} // namespace biting

#endif
