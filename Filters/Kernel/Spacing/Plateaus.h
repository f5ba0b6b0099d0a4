// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPlateaus_h
#define BitingPlateaus_h

#include "../Base/Pulse.h"
#include "Spacing.h"
#include "ValueRange.h"

namespace biting
{

/// Lowers f at nodes of a grid to what it grows to from plateaus: where a side of a cell that is
/// many times as long as wide begins below the least value, f is that value up to where the side
/// exceeds it, which may be far from both nodes. `gradation` is positive; lengths times it do not
/// overflow when squared.
///
/// Method: of all places between two lines of nodes where a side exceeds the least value the
/// nearest one to each node of these lines, by the lower envelope of parabolas (Felzenszwalb and
/// Huttenlocher 2004). Linear in the number of nodes.
void LowerBesidePlateaus(const GridSource& grid, const ValueRange& range, double gradation,
  std::vector<float>& values, Pulse& pulse);

} // namespace biting

#endif
