// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingNearMisses_h
#define BitingNearMisses_h

#include "../Base/Problem.h"
#include "../Base/Pulse.h"
#include "../Domain/Domain.h"
#include "../Spacing/Spacing.h"

namespace biting
{

/// Adds a problem for each vertex of `domain` that nearly meets a segment or an embedded point
/// (ProblemCode::NearMisses): nearer than 0.01 f, with f before its limit by feature size. The
/// detail of the first has the smallest and the largest distance, and the MergeTolerance that joins
/// them, relative to the diagonal of `input`.
///
/// Two segments nearly meet where both are at least 57 times as long as they are apart: triangles
/// between them have angles below 1 degree. So the short edges of a fine drawing are no near
/// misses. Segments that a chain joins on a way as short as the distance are none either, unless
/// the domain between them is as thin all along. Segments that share a vertex count where they are
/// two sides of a triangle: a sharp corner is no near miss. Cost O(n log n).
void ReportNearMisses(const Domain& domain, const Spacing& spacing, const Polylines& input,
  ProblemList& problems, Pulse& pulse);

} // namespace biting

#endif
