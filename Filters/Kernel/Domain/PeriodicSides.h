// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPeriodicSides_h
#define BitingPeriodicSides_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Base/Problem.h"
#include "../Base/Pulse.h"
#include "Domain.h"

#include <vector> // for the pairs

namespace biting
{

/// Segments of the boundary that a translation maps onto each other, the domain on opposite sides
/// of them: where a solution is to be periodic.
struct PeriodicSides
{
  /// Second is First, moved by the translation with that number, but for rounding.
  struct Pair
  {
    Id First;
    Id Second;
    std::size_t Translation;
  };

  std::vector<Pair> Pairs;

  bool IsEmpty() const { return this->Pairs.empty(); }
};

/// The vertex of `pair.Second` that belongs to the start of `pair.First`; the other one belongs to
/// its end.
bool AreParallel(const Domain& domain, const PeriodicSides::Pair& pair);

/// Finds the sides of `domain` that each of the translations maps onto each other. Where a side has
/// a vertex, the other gets one, so that pairs are whole segments.
///
/// Points that are not further apart than `tolerance` belong together. Refused with
/// ProblemCode::UnmatchedSides, and nothing is returned: a translation that maps no segment onto
/// another; a segment of which only a part is mapped; a segment that is mapped beside one, within
/// 1 % of the translation's length and 10 degrees.
/// Cost O(n log n).
PeriodicSides MatchSides(Domain& domain, const std::vector<Point2>& translations, double tolerance,
  ProblemList& problems, Pulse& pulse);

/// Divides segments of `domain` at ascending parameters in (0, 1), one list a segment. The parts
/// take the place of their segment, new vertices come last. Returns of each new segment the old.
std::vector<Id> DivideSegments(const std::vector<std::vector<double>>& parameters, Domain& domain);

} // namespace biting

#endif
