// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "LongCells.h"

#include <algorithm> // for min, max
#include <cmath>     // for abs
#include <numeric>   // for adjacent_difference
#include <utility>   // for pair

namespace biting
{
namespace
{

/// Of nodes, and of runs.
constexpr std::size_t RunLength = 8;

/// What lowers f by no more than this share of it is left out.
constexpr double LeastDifference = 0.004;

/// Where cells are not so many times as long as wide there are no runs.
constexpr double LongCell = 4.0;

/// The least one, and the largest one.
std::pair<double, double> StepsOf(const std::vector<double>& nodes)
{
  std::vector<double> steps(nodes.size());
  std::adjacent_difference(nodes.begin(), nodes.end(), steps.begin());
  const auto [least, most] = std::minmax_element(steps.begin() + 1, steps.end());
  return { *least, *most };
}

} // namespace

LongCells::LongCells(const GridSource& source, const ValueRange& range, double gradation,
  const GridBounds& bounds, const std::vector<float>& values)
  : Source(source)
  , Range(range)
  , Gradation(gradation)
  , Bounds(bounds)
  , Values(values)
  , AlongX{ source.XNodes, source.YNodes, 1, source.XNodes.size(), {} }
  , AlongY{ source.YNodes, source.XNodes, source.XNodes.size(), 1, {} }
{
  this->AddRuns(this->AlongX);
  this->AddRuns(this->AlongY);
}

inline LongCells::Least LongCells::At(std::size_t node) const
{
  return { this->Values[node], static_cast<float>(this->Range(this->Source.Values[node])) };
}

void LongCells::AddRuns(Lines& lines) const
{
  const std::size_t count = lines.Places.size();
  if (StepsOf(lines.Places).second < LongCell * StepsOf(lines.Nodes).first)
  {
    return;
  }
  for (std::size_t size = lines.Nodes.size(); size > RunLength;
       size = lines.Runs.back().size() / count)
  {
    std::vector<Least> runs((size + RunLength - 1) / RunLength * count);
    for (std::size_t k = 0; k < size; ++k)
    {
      Least* run = &runs[k / RunLength * count];
      for (std::size_t line = 0; line < count; ++line)
      {
        const Least least = lines.Runs.empty()
          ? this->At(k * lines.ToNext + line * lines.ToNextLine)
          : lines.Runs.back()[k * count + line];
        run[line].Limited = std::min(run[line].Limited, least.Limited);
        run[line].Given = std::min(run[line].Given, least.Given);
      }
    }
    lines.Runs.push_back(std::move(runs));
  }
}

/// Where a place is between two lines, and what opposite nodes of these allow there at least. The
/// nodes are as far ahead, or back, as f grows by `growth` on.
struct LongCells::Between
{
  std::size_t Line; ///< the lower one
  double Weight;    ///< of the other one
  double ToLow;     ///< in what f grows by
  double ToHigh;

  double FromNodes(const Least& low, const Least& high, double growth) const
  {
    return std::min(low.Limited + Length({ this->ToLow, growth }),
      high.Limited + Length({ this->ToHigh, growth }));
  }

  double FromSides(const Least& low, const Least& high, double growth) const
  {
    return std::max(
      Blend(low.Given, high.Given, this->Weight), std::min(low.Given, high.Given) + growth);
  }

  /// The longest run that begins with a node and allows no less than `enough`; else 1.
  std::size_t LeftOut(
    const Lines& lines, std::size_t node, bool isAhead, double growth, double enough) const
  {
    std::size_t length = 1;
    for (const std::vector<Least>& runs : lines.Runs)
    {
      const std::size_t next = length * RunLength;
      const Least* run = &runs[node / next * lines.Places.size() + this->Line];
      if ((isAhead ? node : node + 1) % next != 0 ||
        this->FromNodes(run[0], run[1], growth) < enough ||
        this->FromSides(run[0], run[1], growth) < enough)
      {
        break;
      }
      length = next;
    }
    return length;
  }
};

double LongCells::Bound(
  const GridInterpolator::Place& place, const Point2& x, double reach, double limit) const
{
  const std::vector<double>& columns = this->Source.XNodes;
  const std::vector<double>& rows = this->Source.YNodes;
  const bool areUpright =
    columns[place.Column + 1] - columns[place.Column] > rows[place.Row + 1] - rows[place.Row];
  const Lines& lines = areUpright ? this->AlongY : this->AlongX;
  const std::size_t line = areUpright ? place.Column : place.Row;
  const std::size_t cell = areUpright ? place.Row : place.Column;
  const double across = areUpright ? x.X : x.Y;
  const Between between{ line, areUpright ? place.X : place.Y,
    this->Gradation * (across - lines.Places[line]),
    this->Gradation * (lines.Places[line + 1] - across) };
  for (const bool isAhead : { false, true })
  {
    std::size_t length = 1;
    for (std::size_t node = isAhead ? cell + 1 : cell; node < lines.Nodes.size();
         node = isAhead ? node + length : node - length)
    {
      const double away = std::abs(lines.Nodes[node] - (areUpright ? x.Y : x.X));
      const double growth = this->Gradation * away;
      if (away >= reach || growth >= limit)
      {
        break;
      }
      const double enough = (1.0 - LeastDifference) * limit;
      length = between.LeftOut(lines, node, isAhead, growth, enough);
      if (length > 1)
      {
        continue;
      }
      const std::size_t at = node * lines.ToNext + line * lines.ToNextLine;
      const Least low = this->At(at);
      const Least high = this->At(at + lines.ToNextLine);
      limit = std::min(limit, between.FromNodes(low, high, growth));
      if (between.FromSides(low, high, growth) < enough)
      {
        limit = areUpright ? this->Bounds.FromRow(line, node, x, limit)
                           : this->Bounds.FromColumn(node, line, x, limit);
      }
    }
  }
  return limit;
}

} // namespace biting
