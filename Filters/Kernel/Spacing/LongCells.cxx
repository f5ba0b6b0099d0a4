// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "LongCells.h"

#include "../Base/Numbers.h"

#include <algorithm> // for min, max
#include <array>     // for runs
#include <cmath>     // for abs, sqrt
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
  , AlongX{ Times(source.XNodes, gradation), Times(source.YNodes, gradation), 1,
    source.XNodes.size(), {} }
  , AlongY{ Times(source.YNodes, gradation), Times(source.XNodes, gradation), source.XNodes.size(),
    1, {} }
{
  this->AddRuns(this->AlongX);
  this->AddRuns(this->AlongY);
}

/// Values along a side that is as steep as f may be bound f at its lower end alone, or at the end
/// of the plateau.
inline void LongCells::AddSide(double width, double here, double there, Least& run) const
{
  const double rise = std::abs(there - here);
  const double least = std::min(here, there);
  if (rise < width)
  {
    const auto lower = [](float& given, double value)
    { given = static_cast<float>(std::min(value, static_cast<double>(given))); };
    lower(run.Given[0], here);
    lower(run.Given[1], 0.5 * (here + there));
    lower(run.Given[2], there);
    run.Slope = std::max(run.Slope, static_cast<float>(rise / width));
  }
  if (least < this->Range.Least)
  {
    const double below = this->Range.Least - least;
    float& plateau = here < there ? run.Plateau : run.PlateauBefore;
    plateau = std::max(plateau, static_cast<float>(below < rise ? below / rise * width : width));
  }
}

void LongCells::AddRuns(Lines& lines) const
{
  const std::size_t count = lines.Places.size();
  if (StepsOf(lines.Places).second < LongCell * StepsOf(lines.Nodes).first)
  {
    return;
  }
  lines.Runs.push_back(this->RunsOfNodes(lines));
  while (lines.Runs.back().size() > count)
  {
    const std::vector<Least>& parts = lines.Runs.back();
    std::vector<Least> runs((parts.size() / count + RunLength - 1) / RunLength * count);
    for (std::size_t k = 0; k < parts.size(); ++k)
    {
      runs[k / count / RunLength * count + k % count].Add(parts[k]);
    }
    lines.Runs.push_back(std::move(runs));
  }
}

/// In the order of the nodes.
std::vector<LongCells::Least> LongCells::RunsOfNodes(const Lines& lines) const
{
  const std::size_t count = lines.Places.size();
  const std::size_t size = (lines.Nodes.size() + RunLength - 1) / RunLength;
  std::vector<Least> runs(size * count);
  const bool isByLine = lines.ToNext == 1;
  for (std::size_t k = 0; k < (isByLine ? count : size); ++k)
  {
    for (std::size_t m = 0; m < (isByLine ? size : count); ++m)
    {
      const std::size_t line = isByLine ? k : m;
      const std::size_t run = isByLine ? m : k;
      runs[run * count + line] = this->RunFrom(lines, line, run * RunLength);
    }
  }
  return runs;
}

/// Of nodes, from the first one on.
LongCells::Least LongCells::RunFrom(const Lines& lines, std::size_t line, std::size_t first) const
{
  Least run;
  const bool hasSides = line + 1 < lines.Places.size();
  const double width = hasSides ? lines.Places[line + 1] - lines.Places[line] : 0.0;
  const std::size_t end = std::min(first + RunLength, lines.Nodes.size());
  for (std::size_t node = first; node < end; ++node)
  {
    const std::size_t at = line * lines.ToNextLine + node * lines.ToNext;
    run.Limited = std::min(run.Limited, this->Values[at]);
    if (hasSides)
    {
      this->AddSide(width, this->Range.Scale * this->Source.Values[at],
        this->Range.Scale * this->Source.Values[at + lines.ToNextLine], run);
    }
  }
  return run;
}

void LongCells::Least::Add(const Least& other)
{
  this->Limited = std::min(this->Limited, other.Limited);
  for (std::size_t k = 0; k < 3; ++k)
  {
    this->Given[k] = std::min(this->Given[k], other.Given[k]);
  }
  this->Slope = std::max(this->Slope, other.Slope);
  this->Plateau = std::max(this->Plateau, other.Plateau);
  this->PlateauBefore = std::max(this->PlateauBefore, other.PlateauBefore);
}

/// Of what bounds f at a place between two lines. Lengths are in what f grows by.
class LongCells::Search
{
public:
  /// `place` is across the lines, and along them.
  Search(const LongCells& cells, const Lines& lines, std::size_t line, const Point2& place,
    double reach, const Point2& x, double limit)
    : Cells(cells)
    , Along(lines)
    , Line(line)
    , ToLow(place.X - lines.Places[line])
    , ToHigh(lines.Places[line + 1] - place.X)
    , Place(place.Y)
    , Reach(reach)
    , X(x)
    , Limit(limit)
  {
  }

  double Run()
  {
    this->LookInto(this->Along.Runs.size() - 1, 0);
    return this->Limit;
  }

private:
  /// What is in a run of the level allows no less.
  double BoundOf(std::size_t level, std::size_t run) const
  {
    const std::size_t length = std::size_t(1) << (3 * level + 3);
    const std::vector<double>& nodes = this->Along.Nodes;
    const double first = nodes[run * length];
    const double last = nodes[std::min((run + 1) * length, nodes.size()) - 1];
    const double growth = std::max({ first - this->Place, this->Place - last, 0.0 });
    const Least* least = &this->Along.Runs[level][run * this->Along.Places.size() + this->Line];
    return growth < this->Reach
      ? std::min(this->FromNodes(least[0].Limited, least[1].Limited, growth),
          this->FromSides(least[0], growth))
      : Infinity;
  }

  double FromNodes(double low, double high, double growth) const
  {
    return std::min(low + Length({ this->ToLow, growth }), high + Length({ this->ToHigh, growth }));
  }

  double FromSides(const Least& least, double growth) const
  {
    const double weight = 2.0 * this->ToLow / (this->ToLow + this->ToHigh);
    const double given = weight < 1.0 ? Blend(least.Given[0], least.Given[1], weight)
                                      : Blend(least.Given[1], least.Given[2], weight - 1.0);
    // Along a way by which f grows to a side this is the sine of the angle with its normal.
    const double cosine = std::sqrt(std::max(1.0f - least.Slope * least.Slope, 0.0f));
    double bound = std::max(given + cosine * growth,
      static_cast<double>(std::min(least.Given[0], least.Given[2])) + growth);
    const auto lower = [this, &bound, growth](double across) {
      bound = std::min(bound, this->Cells.Range.Least + Length({ std::max(across, 0.0), growth }));
    };
    if (least.Plateau >= 0.0f)
    {
      lower(this->ToLow - least.Plateau);
    }
    if (least.PlateauBefore >= 0.0f)
    {
      lower(this->ToHigh - least.PlateauBefore);
    }
    return bound;
  }

  /// What promises most first.
  void LookInto(std::size_t level, std::size_t run)
  {
    const std::size_t begin = run * RunLength;
    if (level == 0)
    {
      const std::size_t end = std::min(begin + RunLength, this->Along.Nodes.size());
      for (std::size_t node = begin; node < end; ++node)
      {
        this->LookAt(node);
      }
      return;
    }
    const std::size_t count = this->Along.Runs[level - 1].size() / this->Along.Places.size();
    const std::size_t size = std::min(RunLength, count - begin);
    std::array<double, RunLength> bounds;
    for (std::size_t k = 0; k < size; ++k)
    {
      bounds[k] = this->BoundOf(level - 1, begin + k);
    }
    for (std::size_t k = 0; k < size; ++k)
    {
      double* next = std::min_element(bounds.data(), bounds.data() + size);
      if (*next >= (1.0 - LeastDifference) * this->Limit)
      {
        return;
      }
      *next = Infinity;
      this->LookInto(level - 1, begin + static_cast<std::size_t>(next - bounds.data()));
    }
  }

  void LookAt(std::size_t node)
  {
    const double growth = std::abs(this->Along.Nodes[node] - this->Place);
    if (growth >= this->Reach || growth >= this->Limit)
    {
      return;
    }
    const std::size_t at = node * this->Along.ToNext + this->Line * this->Along.ToNextLine;
    const std::size_t next = at + this->Along.ToNextLine;
    this->Limit = std::min(
      this->Limit, this->FromNodes(this->Cells.Values[at], this->Cells.Values[next], growth));
    const std::vector<double>& given = this->Cells.Source.Values;
    const ValueRange& range = this->Cells.Range;
    const double share = this->ToLow / (this->ToLow + this->ToHigh);
    if (range.Scale * std::min(given[at], given[next]) < range.Least ||
      range.Scale * Blend(given[at], given[next], share) < this->Limit)
    {
      this->Limit = this->Along.ToNextLine == 1
        ? this->Cells.Bounds.FromRow(this->Line, node, this->X, this->Limit)
        : this->Cells.Bounds.FromColumn(node, this->Line, this->X, this->Limit);
    }
  }

  const LongCells& Cells;
  const Lines& Along;
  const std::size_t Line;
  const double ToLow;
  const double ToHigh;
  const double Place;
  const double Reach;
  const Point2& X;
  double Limit;
};

double LongCells::BoundAlongX(
  const GridInterpolator::Place& place, const Point2& x, double reach, double limit) const
{
  return this->Bound(this->AlongX, place.Row, { x.Y, x.X }, x, reach, limit);
}

double LongCells::BoundAlongY(
  const GridInterpolator::Place& place, const Point2& x, double reach, double limit) const
{
  return this->Bound(this->AlongY, place.Column, x, x, reach, limit);
}

double LongCells::Bound(const Lines& lines, std::size_t line, const Point2& acrossAndAlong,
  const Point2& x, double reach, double limit) const
{
  const Point2 place = this->Gradation * acrossAndAlong;
  return lines.Runs.empty()
    ? limit
    : Search(*this, lines, line, place, this->Gradation * reach, x, limit).Run();
}

} // namespace biting
