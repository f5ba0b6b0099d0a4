// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGridPasses_h
#define BitingGridPasses_h

#include "../Base/Pulse.h"

namespace biting
{

/// Lowers values at the nodes of a grid, row by row, to the largest function below them that grows
/// no faster than `gradation`; between neighbors along x and along y it is linear. What it grows by
/// is too large by .35 % at most where cells are squares, by 1 % where they are five times as long
/// as wide, by more where longer. False, and the values are without meaning, if the monitor asks to
/// stop.
///
/// Method: what bounds a node does so along a straight way. So four passes from line to line of
/// nodes, to the right, to the left, up and down, see all of it. In each a node is offered what the
/// line before allows between its nodes, and, as that is too much near a node that bounds, what the
/// nodes of that line and of the two before it allow; of that line all within reach, where cells
/// are long. Linear in the number of nodes, but for a logarithm there. On one thread, but for the
/// transposition.
bool RunGridPasses(const std::vector<double>& columns, const std::vector<double>& rows,
  double gradation, std::vector<float>& values, Pulse& pulse);

} // namespace biting

#endif
