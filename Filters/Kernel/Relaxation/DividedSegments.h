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

/// 1024 times the rounding of a vertex (Domain::Resolution), in input length units: parts of
/// segments that are longer are hardly turned by it, so that together they stay as long as the
/// segment within 1e-6. Vertices come, slide and go only on such parts.
double LeastSlidingLength(const Domain& domain);

/// Whether a part of that length is one of these.
inline bool IsFarAboveRounding(double length, const Domain& domain)
{
  return length > LeastSlidingLength(domain);
}

/// 1 for the segments on which vertices may lie anywhere: a vertex is off its segment by rounding,
/// and what lies beyond the border is not triangulated, so nothing there would notice if the parts
/// of two segments met. Segments nearer to another than rounding can bridge have 0, and so have
/// two that leave a vertex so close together that they are that near at a quarter of the spacing;
/// and those that are not far above rounding themselves.
/// `spacings` begins with those of the vertices of the domain.
/// Cost O(n log n). Where the monitor wants to stop the result has no meaning.
std::vector<std::uint8_t> FindDividedSegments(
  const Domain& domain, const std::vector<double>& spacings, Pulse& pulse);

} // namespace biting

#endif
