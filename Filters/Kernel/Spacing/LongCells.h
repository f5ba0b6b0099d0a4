// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingLongCells_h
#define BitingLongCells_h

#include "GridBounds.h"
#include "GridInterpolator.h"

namespace biting
{

/// What f is within cells that are many times as long as wide, where it grows by more than a share
/// of itself from one long side to the other: what the nodes along these two sides allow, and the
/// short sides between them.
///
/// Method: nodes are looked at one by one, away from a place on both sides; runs of 8, 64 ... nodes
/// are left out where their least values lower f by no more than .4 %. So where nodes are much
/// denser than f it is mostly runs that are looked at, some hundreds at worst.
class LongCells
{
public:
  /// `values` are f at the nodes, limited already. All is referred to.
  LongCells(const GridSource& source, const ValueRange& range, double gradation,
    const GridBounds& bounds, const std::vector<float>& values);

  /// At x, from what is nearer along the long sides than `reach`; or `limit`, if that is less.
  double Bound(
    const GridInterpolator::Place& place, const Point2& x, double reach, double limit) const;

private:
  /// Of one node, or of a run.
  struct Least
  {
    float Limited = std::numeric_limits<float>::max();
    float Given = std::numeric_limits<float>::max();
  };

  /// The nodes as lines along x, or along y.
  struct Lines
  {
    const std::vector<double>& Nodes;
    const std::vector<double>& Places; ///< of the lines
    std::size_t ToNext;                ///< from a value to that of the next node
    std::size_t ToNextLine;
    std::vector<std::vector<Least>> Runs; ///< of 8, 64, ... nodes: of all lines, run by run
  };

  struct Between;

  Least At(std::size_t node) const;
  void AddRuns(Lines& lines) const;

  const GridSource& Source;
  const ValueRange& Range;
  const double Gradation;
  const GridBounds& Bounds;
  const std::vector<float>& Values;
  Lines AlongX;
  Lines AlongY;
};

} // namespace biting

#endif
