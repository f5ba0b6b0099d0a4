// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingNeededCones_h
#define BitingNeededCones_h

#include "SegmentCone.h"
#include "TriangleSides.h"
#include "ValueRange.h"

namespace biting
{

/// A part of an edge of a triangulation, up to its high end, from which f grows; or a point.
struct LowEdge
{
  Point2 Start; ///< at the low end, or between
  Point2 End;
  double StartValue;
  double EndValue;
  Id Low;  ///< the end where f is lower
  Id High; ///< the other one, or the same
};

/// Some triangles of a source.
struct TrianglePart
{
  const TriangulatedSource& Source;
  const std::vector<Id>& Triangles;
  const TriangleSides& Sides; ///< of these triangles
};

/// Leaves out edges whose cones limit f nowhere by more than a tolerance: because another cone
/// stands for them, nowhere in the plane above by more than CoverTolerance times the least value of
/// the edge; or because they are nowhere below the values by more than IdleTolerance times that.
///
/// From the lowest point up, each hands the cone that covers it on to those above. So a field that
/// is as steep as the gradation, or a little steeper, is left with cones of its low places, if any.
/// What covers an edge, but not the points on a way to it, is not found; values are looked at along
/// the sides of triangles, and where the largest value cuts them.
/// Cost: n log n for n triangles, few of them at each point.
constexpr double CoverTolerance = 0.005;
constexpr double IdleTolerance = 0.01;
std::vector<LowEdge> NeededCones(std::vector<LowEdge> edges, const TrianglePart& part,
  const ValueRange& range, double gradation, Pulse& pulse);

} // namespace biting

#endif
