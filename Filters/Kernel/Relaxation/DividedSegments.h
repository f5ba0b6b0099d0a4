// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDividedSegments_h
#define BitingDividedSegments_h

#include "../Base/Pulse.h"
#include "../Domain/Domain.h"

#include <cstdint> // for flags
#include <vector>  // for the result

namespace biting
{

/// 1024 times the rounding of a vertex (Domain::Resolution), in input length units. Rounding turns
/// a longer part of a segment by at most 2 / 1024, so the parts are together as long as the
/// segment, within (2 / 1024)^2 / 2 = 2e-6. Vertices come, slide and go only on such parts.
double LeastSlidingLength(const Domain& domain);

/// Whether a part of that length is one of these.
inline bool IsFarAboveRounding(double length, const Domain& domain)
{
  return length > LeastSlidingLength(domain);
}

/// 1 for the segments on which vertices may lie anywhere. A vertex is off its segment by rounding,
/// and no triangles beyond the border keep the parts of two segments from meeting. So 0 is for
/// segments that are
/// - nearer to another one than twice the rounding on either side;
/// - at a vertex, if another one there is as near at a quarter of the spacing from the vertex;
/// - not far above rounding themselves.
/// `spacings` begins with those of the vertices of the domain.
/// Cost O(n log n). Where the monitor wants to stop the result has no meaning.
std::vector<std::uint8_t> FindDividedSegments(
  const Domain& domain, const std::vector<double>& spacings, Pulse& pulse);

} // namespace biting

#endif
