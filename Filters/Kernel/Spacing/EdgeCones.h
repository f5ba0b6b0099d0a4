// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingEdgeCones_h
#define BitingEdgeCones_h

#include "SegmentCone.h"
#include "ValueRange.h"

#include <vector> // for cones

namespace biting
{

/// An end of an edge, and the value given there.
struct EdgeEnd
{
  Point2 Place;
  double Value;
};

/// Adds what the values along an edge of a source allow elsewhere, as EdgeBound, in cones: of the
/// part where the spacing is its least, and of the part where it grows along the edge. Nothing for
/// a part that is as steep as the gradation, as what it grows from is enough, or without a length.
void AddEdgeCones(const EdgeEnd& start, const EdgeEnd& end, const ValueRange& range,
  double gradation, std::vector<SegmentCone>& cones);

} // namespace biting

#endif
