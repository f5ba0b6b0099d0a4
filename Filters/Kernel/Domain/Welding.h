// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingWelding_h
#define BitingWelding_h

#include "../Base/Problem.h"
#include "Arrangement.h"
#include "Polylines.h"

namespace biting
{

/// The chains with coincident points made one vertex each, numbered by their places; edges are
/// directed from the lesser number to the greater.
///
/// Points count as coincident where their coordinates are equal; those below LeastCoordinate in
/// magnitude count as zero. That chains share coordinates is ordinary and goes without a word.
/// Reported: consecutive points of a chain that are equal (ZeroLengthSegments where the point id
/// repeats, DuplicatePoints where two ids share the place), embedded points that repeat.
///
/// Points that are not further apart than the rounding of their coordinates, or than MergeTolerance
/// times the diagonal of their box, are one, too, and reported (NearPoints). Vertices stay where
/// input points are. Points are taken in the order of their places, those that boundaries use
/// before those of interfaces, then open ends, then embedded ones; a point becomes a vertex where
/// none is that near, otherwise it goes to the nearest vertex in the end. Laws: no two vertices are
/// that near; no point moves further than that; neither the order of points nor that of chains
/// matters.
/// Then open ends are joined with what they nearly touch (OpenEnds.h).
/// Precondition: the coordinates that chains use are finite. Cost O(n log n).
Arrangement WeldPolylines(
  const Polylines& input, const DomainOptions& options, ProblemList& problems, Pulse& pulse);

} // namespace biting

#endif
