// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGridInterpolator_h
#define BitingGridInterpolator_h

#include "Source.h"
#include "Spacing.h"

namespace biting
{

/// From low, at weight 0, to high, at weight 1.
inline double Blend(double low, double high, double weight)
{
  return (1.0 - weight) * low + weight * high;
}

/// Finds the cell of a coordinate among ascending nodes: constant cost where the nodes are about
/// evenly spaced, logarithmic at worst.
class GridAxis
{
public:
  /// Cell i lies between nodes i and i + 1; Weight in [0, 1] is that of node i + 1.
  struct Place
  {
    std::size_t Cell;
    double Weight;
  };

  explicit GridAxis(const std::vector<double>& nodes);

  /// The nearest place inside, for a coordinate outside (or NaN).
  Place Find(double coordinate) const;

private:
  std::size_t BucketOf(double coordinate) const;

  std::vector<double> Nodes;      ///< at least two; a single one is doubled
  std::vector<Id> LastNodeBefore; ///< last node in a bucket before this one, or 0; one past the end
  double BucketsPerLength = 0.0;
};

/// The bilinear interpolant of a grid without holes, which it shares. Outside it is the nearest
/// value of the border. A single row or column counts twice, so that there are cells.
class GridInterpolator : public Source<2>
{
public:
  /// Where a point is in its cell, whose low node is (Column, Row).
  struct Place
  {
    std::size_t Column;
    std::size_t Row;
    double X; ///< weight of the nodes to the right
    double Y; ///< weight of the nodes above
  };

  explicit GridInterpolator(std::shared_ptr<const GridSource> source);

  double operator()(const Point2& x) const { return this->At(this->Find(x)); }

  Sample At(const Point<2>& x) const override;
  std::vector<LowPlace<2>> LowPlaces(
    double slope, const ValueRange& range, Pulse& pulse) const override;

  Place Find(const Point2& x) const;
  double At(const Place& place) const;

private:
  std::size_t NodeAt(std::size_t column, std::size_t row) const
  {
    return column + row * this->Grid->XNodes.size();
  }

  std::shared_ptr<const GridSource> Grid;
  GridAxis XAxis;
  GridAxis YAxis;
  std::size_t ToRight; ///< from a value to that of the next column
  std::size_t ToNextRow;
};

} // namespace biting

#endif
