// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingOrientation_h
#define BitingOrientation_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Base/Pulse.h"
#include "../Domain/Domain.h"

#include <vector> // for the arrays

namespace biting
{

/// The axes of the bites at the vertices of a domain (paper, section 3.1 and figure 7).
/// Vertex v has the axes Axes[Offsets[v]] .. Axes[Offsets[v + 1] - 1], at least one: a unit vector
/// parallel to two sides of a square.
struct VertexAxes
{
  std::vector<Id> Offsets;
  std::vector<Point2> Axes;
};

/// For each sector between neighbouring segments of a vertex that lies inside the domain: where its
/// angle is within 135..225 degrees a side of the square is aligned with its bisector, otherwise
/// the diagonal. Sectors that ask for the same square share it. An embedded point is bitten along
/// the axes of the plane.
VertexAxes OrientVertexBites(const Domain& domain, Pulse& pulse);

/// The axis of a square in the sector that begins at direction `first` and ends, counterclockwise,
/// at direction `last` (unit vectors).
Point2 SectorAxis(const Point2& first, const Point2& last);

} // namespace biting

#endif
