// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingChainKinds_h
#define BitingChainKinds_h

#include "Arrangement.h"

#include <cstdint> // for flags
#include <vector>  // for flags

namespace biting
{

/// Which edges bound the domain: 1 where inside and outside change. Every vertex ends an even
/// number of these.
///
/// Faces bound by parity, and apart from them boundary chains; where these leave ends open, what
/// remains closed of them does. Open chains of automatic kind are judged by their components
/// (BoundaryComponents.h), apart from the boundary chains: a river from coast to coast bounds
/// nothing. A component that is not a simple loop and lies within the domain of all the others only
/// divides it: interfaces that cross, the borders of states within a coast.
std::vector<std::uint8_t> FindBoundary(const Arrangement& arrangement, Pulse& pulse);

/// The same by `options.Rule`, which is not EvenOdd. Loops and faces are the runs of the edges
/// (FaceEdge.h). The cover of a place is the set of all that enclose it, each by its own parity. A
/// place is inside
/// - by OuterMinusOthers where the cover is the one of the largest area alone,
/// - by Union where the cover is not empty.
/// By Union what divides the domain stays as an interface: edges on whose sides the last of the
/// cover differs, in region where regions are given. The others no longer count as edges of faces.
/// Cost O(n (log n + c)) for covers of c loops and faces.
std::vector<std::uint8_t> FindBoundaryByRule(
  Arrangement& arrangement, const DomainOptions& options, Pulse& pulse);

} // namespace biting

#endif
