// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCellGradation_h
#define BitingCellGradation_h

#include "SizeCells.h"

#include <cstdint> // for marks

namespace biting
{

/// Cuts the cells of a SizeTree, and gives each corner its f and its origin. Returns of each cell
/// whether it is a leaf where f is as given. Incomplete if the pulse stops.
///
/// Cells are cut in rounds, the largest first. After each round, origins go from corner to corner,
/// the lowest first (a priority queue, as in Dijkstra's algorithm). A cell whose diagonal is longer
/// than f is cut where
/// - a low place of a source is in it;
/// - f is below what is given at its corners, and their origins are so far apart that an origin
///   between them may be lower;
/// - what is given is extended from a border, and not linear in the cell: it jumps there;
/// - a corner of a smaller neighbor, on its side, has an origin that is lower than all of its own.
template <std::size_t D>
std::vector<std::uint8_t> GradeCells(SizeCells<D>& cells, const GivenAt<D>& givenAt, bool hasGaps,
  const Box<D>& bounds, double gradation, Pulse& pulse);

} // namespace biting

#endif
