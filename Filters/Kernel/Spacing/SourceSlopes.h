// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSourceSlopes_h
#define BitingSourceSlopes_h

#include "Spacing.h"

namespace biting
{

/// The largest slope of the given values, without their scale; holes and degenerate cells count
/// nothing.
/// Grid: over each cell, the length of the largest slopes along x and along y.
/// Triangulation: the length of the gradient. Segments: the slope along them.
/// Of what was seen, if the monitor asks to stop.
double LargestSlope(const GridSource& source, Monitor& monitor = NoMonitor());
double LargestSlope(const TriangulatedSource& source, Monitor& monitor = NoMonitor());
double LargestSlope(const SegmentSource& source);

/// The gradient in the triangle with three corners; 0 where it is not known.
Point2 GradientOfTriangle(const TriangulatedSource& source, const Id* corners);

} // namespace biting

#endif
