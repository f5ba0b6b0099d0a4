// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Plateaus.h"

#include "../Base/Numbers.h"
#include "GridInterpolator.h"
#include "LongCells.h"

#include <algorithm> // for min
#include <cmath>     // for sqrt
#include <utility>   // for move

namespace biting
{
namespace
{

/// Of a plateau that does not reach a line of nodes.
struct PlateauEnd
{
  double Place;  ///< along the line
  double Square; ///< of the distance from the line
};

/// Which end of a plateau is the nearest one, along a line.
class NearestEnds
{
public:
  bool IsEmpty() const { return this->Parts.empty(); }

  /// By ascending places.
  void Add(const PlateauEnd& end)
  {
    double begin = -Infinity;
    while (!this->Parts.empty())
    {
      begin = WhereNearer(this->Parts.back().Nearest, end);
      if (begin > this->Parts.back().Begin)
      {
        break;
      }
      this->Parts.pop_back();
      begin = -Infinity;
    }
    if (begin < Infinity)
    {
      this->Parts.push_back({ begin, end });
    }
  }

  /// Lowers values at nodes, of which each is so far from the one before, to what grows from
  /// `least` there.
  void Lower(const std::vector<double>& nodes, double least, float* values, std::size_t toNext)
  {
    std::size_t part = 0;
    for (std::size_t node = 0; node < nodes.size(); ++node)
    {
      while (part + 1 < this->Parts.size() && this->Parts[part + 1].Begin <= nodes[node])
      {
        ++part;
      }
      const PlateauEnd& end = this->Parts[part].Nearest;
      const double along = nodes[node] - end.Place;
      float& value = values[node * toNext];
      value = std::min(value, static_cast<float>(least + std::sqrt(along * along + end.Square)));
    }
  }

private:
  struct Part
  {
    double Begin;
    PlateauEnd Nearest;
  };

  /// From where on that is so of the second one.
  static double WhereNearer(const PlateauEnd& first, const PlateauEnd& second)
  {
    const double way = second.Place - first.Place;
    const double rise = second.Square - first.Square;
    const double far = rise < 0.0 ? -Infinity : Infinity;
    return way > 0.0 ? 0.5 * (first.Place + second.Place + rise / way) : far;
  }

  std::vector<Part> Parts;
};

/// The sides that lead from each line of nodes, along x or along y, to the next one. Lengths are in
/// what f grows by.
class LongSides
{
public:
  LongSides(std::vector<double> nodes, const std::vector<double>& lines, std::size_t toNext,
    std::size_t toNextLine)
    : Nodes(std::move(nodes))
    , ToNext(toNext)
    , ToNextLine(toNextLine)
    , Widths(lines.size() - 1)
    , ToLow(lines.size() - 1)
    , ToHigh(lines.size() - 1)
  {
    for (std::size_t node = 1; node < this->Nodes.size(); ++node)
    {
      this->LeastStep = std::min(this->LeastStep, this->Nodes[node] - this->Nodes[node - 1]);
    }
    for (std::size_t line = 0; line < this->Widths.size(); ++line)
    {
      this->Widths[line] = lines[line + 1] - lines[line];
    }
  }

  /// The values are read in their order.
  bool FindPlateaus(const std::vector<double>& given, const ValueRange& range, Pulse& pulse)
  {
    const double longest = *std::max_element(this->Widths.begin(), this->Widths.end());
    const std::size_t lines = this->Widths.size();
    const bool isByNode = this->ToNextLine == 1;
    const std::size_t outer = isByNode ? this->Nodes.size() : lines;
    const std::size_t inner = isByNode ? lines : this->Nodes.size();
    for (std::size_t k = 0; longest > LongCell * this->LeastStep && k < outer; ++k)
    {
      for (std::size_t m = 0; m < inner; ++m)
      {
        this->AddPlateau(isByNode ? m : k, isByNode ? k : m, given, range);
      }
      if (!pulse.Beat(inner))
      {
        return false;
      }
    }
    return true;
  }

  void Lower(std::vector<float>& values, double least)
  {
    for (std::size_t line = 0; line < this->Widths.size(); ++line)
    {
      float* low = &values[line * this->ToNextLine];
      for (const bool isHigh : { false, true })
      {
        NearestEnds& ends = isHigh ? this->ToHigh[line] : this->ToLow[line];
        if (!ends.IsEmpty())
        {
          ends.Lower(this->Nodes, least, isHigh ? low + this->ToNextLine : low, this->ToNext);
        }
      }
    }
  }

private:
  void AddPlateau(
    std::size_t line, std::size_t node, const std::vector<double>& given, const ValueRange& range)
  {
    const double* at = &given[line * this->ToNextLine + node * this->ToNext];
    const double low = range.Scale * at[0];
    const double high = range.Scale * at[this->ToNextLine];
    if ((low < range.Least) == (high < range.Least) ||
      !(this->Widths[line] > LongCell * this->LeastStep))
    {
      return;
    }
    const double share = (range.Least - low) / (high - low); // of the side, from its low line
    const double away = this->Widths[line] * (low < high ? 1.0 - share : share);
    NearestEnds& ends = low < high ? this->ToHigh[line] : this->ToLow[line];
    ends.Add({ this->Nodes[node], away * away });
  }

  const std::vector<double> Nodes;
  const std::size_t ToNext; ///< from a value to that of the next node
  const std::size_t ToNextLine;
  double LeastStep = Infinity;
  std::vector<double> Widths; ///< of all that follows: of sides from a line to the next one
  std::vector<NearestEnds> ToLow;
  std::vector<NearestEnds> ToHigh;
};

} // namespace

void LowerBesidePlateaus(const GridSource& grid, const ValueRange& range, double gradation,
  std::vector<float>& values, Pulse& pulse)
{
  const std::vector<double> x = Times(grid.XNodes, gradation);
  const std::vector<double> y = Times(grid.YNodes, gradation);
  for (LongSides sides : { LongSides(y, x, x.size(), 1), LongSides(x, y, 1, x.size()) })
  {
    if (!sides.FindPlateaus(grid.Values, range, pulse))
    {
      return;
    }
    sides.Lower(values, range.Least);
  }
}

} // namespace biting
