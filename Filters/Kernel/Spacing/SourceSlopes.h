// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSourceSlopes_h
#define BitingSourceSlopes_h

#include "Spacing.h"

namespace biting
{

/// The slopes of a grid, without the scale of its values: squares of the length of the largest
/// slopes along x and along y, over each cell.
class GridSlopes
{
public:
  explicit GridSlopes(const GridSource& source);

  /// Of the cells between that row of nodes and the next one; beyond the last row and the last
  /// column they have one side. Holes and steps of no length count nothing. To be asked for each
  /// row, in their order.
  const std::vector<double>& SquaresOfRow(std::size_t row);

private:
  void FindAlong(std::size_t row, std::vector<double>& slopes) const;
  void FindAcross(std::size_t row);

  const GridSource& Source;
  std::vector<double> Columns; ///< 1 / width; 0 where there is none
  std::vector<double> Rows;
  std::vector<double> Low; ///< along the row of nodes below
  std::vector<double> High;
  std::vector<double> Across;
  std::vector<double> Squares;
};

/// The largest slope of the given values, without their scale; holes and degenerate cells count
/// nothing.
/// Grid: the largest one of GridSlopes.
/// Triangulation: the length of the gradient. Segments: the slope along them.
/// Of what was seen, if the monitor asks to stop.
double LargestSlope(const GridSource& source, Monitor& monitor = NoMonitor());
double LargestSlope(const TriangulatedSource& source, Monitor& monitor = NoMonitor());
double LargestSlope(const SegmentSource& source);

/// The gradient in the triangle whose corners start at `first`; 0 where it is not known.
Point2 GradientOfTriangle(const TriangulatedSource& source, std::size_t first);
double AreaOfTriangle(const TriangulatedSource& source, std::size_t first);

} // namespace biting

#endif
