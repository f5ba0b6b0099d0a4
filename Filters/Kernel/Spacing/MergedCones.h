// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMergedCones_h
#define BitingMergedCones_h

#include "SegmentCone.h"

namespace biting
{

/// As MakeCones, but fewer where segments are much shorter than f / g: the minimum of the cones is
/// that of all segments to within MergingTolerance of itself.
/// - Segments that follow each other become one, as long as their ends are so near to it, and their
///   values to the linear ones along it, that f changes by less than half the tolerance.
/// - A cone is left out where one shortly before or after it is below its values, but for another
///   half.
/// Values are positive. Linear in the number of segments, given in the order of their chains.
constexpr double MergingTolerance = 0.006;
std::vector<SegmentCone> MergeCones(
  const SegmentSource& source, double scale, double slope, Pulse& pulse);

} // namespace biting

#endif
