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
double LargestSlope(const GridSource& source);
double LargestSlope(const TriangulatedSource& source);
double LargestSlope(const SegmentSource& source);

} // namespace biting

#endif
