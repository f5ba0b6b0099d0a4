// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingWelding_h
#define BitingWelding_h

#include "../Base/Problem.h"
#include "Arrangement.h"
#include "Polylines.h"

namespace biting
{

/// The chains with coincident points made one vertex each, numbered by their first input point.
///
/// Points count as coincident where their coordinates are equal; those below LeastCoordinate in
/// magnitude count as zero. That chains share coordinates is ordinary and goes without a word.
/// Reported: consecutive points of a chain that are equal (ZeroLengthSegments where the point id
/// repeats, DuplicatePoints where two ids share the place), embedded points that repeat.
/// Precondition: the coordinates that chains use are finite. Cost O(n log n).
Arrangement WeldPolylines(
  const Polylines& input, const DomainOptions& options, ProblemList& problems, Pulse& pulse);

} // namespace biting

#endif
