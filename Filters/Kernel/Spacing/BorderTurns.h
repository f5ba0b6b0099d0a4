// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBorderTurns_h
#define BitingBorderTurns_h

#include "../Base/Pulse.h"
#include "BorderTree.h"

#include <utility> // for pairs
#include <vector>  // for ends of edges

namespace biting
{

/// In which directions the edges of a border leave each of its points.
class BorderTurns
{
public:
  /// Incomplete if the pulse stops.
  BorderTurns(const std::vector<BorderEdge>& edges, Pulse& pulse);

  /// What is outside lies right of an edge: the angle from its normal there, at its end,
  /// counterclockwise to the normal of the edge that follows. Negative where these cross.
  double TurnAround(const BorderEdge& edge) const;

private:
  std::vector<std::pair<Id, double>> Ends; ///< points, and angles
};

} // namespace biting

#endif
