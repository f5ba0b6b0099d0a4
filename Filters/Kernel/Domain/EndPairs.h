// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingEndPairs_h
#define BitingEndPairs_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "Arrangement.h"

#include <cstdint> // for flags
#include <vector>  // for the lists

namespace biting
{

/// A vertex at which nothing goes on, and the other one at its gap.
struct OpenEnd
{
  Id Vertex = NoId;
  Id Cell = NoId; ///< of its edge
  Id Partner = NoId;
  double Gap = 0.0;
};

/// The open ends of edges that are not `isKept`, those with the widest gaps first.
///
/// The two that are nearest to each other are partners, then the two of the rest, and so on; where
/// more than 10000 ends are open they have none. Where the other end of the same cell is nearer, it
/// is the partner: what else ends there, it is not open.
std::vector<OpenEnd> PairOpenEnds(
  const Arrangement& arrangement, const std::vector<std::uint8_t>& isKept, Pulse& pulse);

} // namespace biting

#endif
