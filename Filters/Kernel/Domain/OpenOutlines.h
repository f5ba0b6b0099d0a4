// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingOpenOutlines_h
#define BitingOpenOutlines_h

#include "../Base/Problem.h"
#include "../Base/Pulse.h"
#include "Arrangement.h"

#include <cstdint> // for flags
#include <vector>  // for flags

namespace biting
{

/// Refuses a drawing in which nothing bounds a domain. Says where chains could be closed: one
/// problem for each open end, with its gap, those of the widest gaps first; a single
/// problem where no end is open.
/// Returns the EndTolerance that closes all gaps; infinity where it is not known.
double RefuseOpenDrawing(const Arrangement& arrangement, const DomainOptions& options,
  ProblemList& problems, Pulse& pulse);

/// Refuses a drawing of which chains are left out that would bound a domain, but for gaps: closed
/// over their gaps, they make a loop, or they go from what is kept to what is kept, and
/// - the gaps are no more than a hundredth of the length of what is left out there,
/// - or a tenth, where it is one gap, of a loop or between the ends of one cell,
/// - or a quarter, or half where it is one, of a loop in which something is kept.
/// Each is a problem of kind OpenOutlines. Returns the EndTolerance that closes them all; 0 where
/// there is none, infinity where it is not known.
double RefuseOpenOutlines(const Arrangement& arrangement, const std::vector<std::uint8_t>& isKept,
  const DomainOptions& options, ProblemList& problems, Pulse& pulse);

} // namespace biting

#endif
