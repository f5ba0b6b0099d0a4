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

} // namespace biting

#endif
