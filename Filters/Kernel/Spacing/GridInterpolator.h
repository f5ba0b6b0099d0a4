// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGridInterpolator_h
#define BitingGridInterpolator_h

#include "Spacing.h"

namespace biting
{

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

/// The bilinear interpolant of a grid without holes, which it shares.
class GridInterpolator
{
public:
  explicit GridInterpolator(std::shared_ptr<const GridSource> source);
  double operator()(const Point2& x) const;

private:
  std::shared_ptr<const GridSource> Source;
  GridAxis X;
  GridAxis Y;
  std::size_t StepX; ///< from a node to the next in Values; 0 where there is only one
  std::size_t StepY;
};

} // namespace biting

#endif
