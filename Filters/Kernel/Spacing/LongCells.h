// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingLongCells_h
#define BitingLongCells_h

#include "GridBounds.h"
#include "GridInterpolator.h"

#include <array>  // for values along sides
#include <limits> // for what there is none of

namespace biting
{

/// Cells that are no more than so many times as long as wide are not long.
constexpr double LongCell = 4.0;

/// What f is within and beside cells that are many times as long as wide, where it grows by more
/// than a share of itself from one long side to the other: what the nodes along two neighboring
/// lines allow, and the sides between them.
///
/// Method: a tree of runs of 8, 64 ... nodes, of which those that promise most are looked into
/// first, and those that lower f by no more than .4 % are not.
class LongCells
{
public:
  /// `values` are f at the nodes, limited already. All is referred to.
  LongCells(const GridSource& source, const ValueRange& range, double gradation,
    const GridBounds& bounds, const std::vector<float>& values);

  /// At x, from what is nearer than `reach` along the rows at its cell; or `limit`, if that is
  /// less.
  double BoundAlongX(
    const GridInterpolator::Place& place, const Point2& x, double reach, double limit) const;

  /// The same along the columns at its cell.
  double BoundAlongY(
    const GridInterpolator::Place& place, const Point2& x, double reach, double limit) const;

private:
  /// Of a node and the side from there to the next line; of a run, the least of each.
  struct Least
  {
    static constexpr float None = std::numeric_limits<float>::max();

    float Limited = None;                               ///< at the node
    std::array<float, 3> Given{ { None, None, None } }; ///< at both ends of the side, and between
    float Slope = 0.0f;          ///< along the side, as a share of the gradation; largest
    float Plateau = -1.0f;       ///< how far f is the least value, from this line on; largest
    float PlateauBefore = -1.0f; ///< and from the next line

    void Add(const Least& other);
  };

  /// The nodes as lines along x, or along y. Lengths are in what f grows by.
  struct Lines
  {
    std::vector<double> Nodes;
    std::vector<double> Places; ///< of the lines
    std::size_t ToNext;         ///< from a value to that of the next node
    std::size_t ToNextLine;
    std::vector<std::vector<Least>> Runs; ///< of 8, 64, ... nodes: of all lines, run by run
  };

  class Search;

  void AddRuns(Lines& lines) const;
  std::vector<Least> RunsOfNodes(const Lines& lines) const;
  Least RunFrom(const Lines& lines, std::size_t line, std::size_t first) const;
  void AddSide(double width, double here, double there, Least& run) const;
  double Bound(const Lines& lines, std::size_t line, const Point2& acrossAndAlong, const Point2& x,
    double reach, double limit) const;

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
