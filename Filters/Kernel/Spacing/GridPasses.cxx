// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GridPasses.h"

#include "../Base/Numbers.h"

#include <array>  // for lines before
#include <cmath>  // for ceil, sqrt
#include <limits> // for the greatest float

namespace biting
{
namespace
{

/// A node is offered what others of the line before allow that are nearer along the line than so
/// many times the distance of the lines, and no more of them than that.
constexpr double ReachAlong = 7.0;
constexpr std::size_t MostBeside = 32;

/// No fewer of the line before, and just as many of the two before that one: what is nearer by way
/// of lines in between is offered there.
constexpr std::array<std::size_t, 3> LeastBeside = { 1, 1, 2 };

/// Where those reach less far than so many times what they should, all of the line before are
/// looked at: cells are long there.
constexpr double ShareOfReach = 2.0 / 3.0;

/// Lines are as far away as the last ones up to that share.
constexpr double RoundingOfDistance = 1e-6;

/// Beside lines: offered by nobody.
constexpr float GreatestFloat = std::numeric_limits<float>::max();

/// Nodes line by line, with the greatest values at both ends of each.
struct Lines
{
  Lines(std::size_t count, std::size_t size)
    : Count(count)
    , Size(size)
    , Beyond(std::min(size, MostBeside))
    , Stride(size + 2 * this->Beyond)
    , Values(count * this->Stride, GreatestFloat)
  {
  }

  float* At(std::size_t line) { return &this->Values[line * this->Stride + this->Beyond]; }

  std::size_t Count;
  std::size_t Size;   ///< of each
  std::size_t Beyond; ///< so many more at each end
  std::size_t Stride;
  std::vector<float> Values;
};

/// Between nodes of one line and those of another one.
class Ways
{
public:
  explicit Ways(const std::vector<double>& nodes)
    : Nodes(nodes)
  {
  }

  /// From a line so far away, to nodes up to `beside` along it.
  void Set(double distance, std::size_t beside)
  {
    for (std::size_t k = this->Squares.size(); k < beside; ++k)
    {
      this->AddSquares(k + 1);
    }
    if (std::abs(distance - this->Distance) <= RoundingOfDistance * distance &&
      this->Costs.size() == beside)
    {
      return;
    }
    this->Distance = distance;
    this->Costs.resize(beside);
    const auto square = static_cast<float>(distance * distance);
    for (std::size_t k = 0; k < beside; ++k)
    {
      const std::vector<float>& squares = this->Squares[k];
      this->Costs[k].resize(squares.size());
      for (std::size_t node = 0; node < squares.size(); ++node)
      {
        this->Costs[k][node] = std::sqrt(square + squares[node]);
      }
    }
  }

  /// From each node of one line to the next one of the other.
  const float* ToNext() const { return &this->Costs[0][MostBeside]; }

  /// What the nodes of a line allow at those of another one.
  void Offer(const float* from, float* to) const
  {
    for (std::size_t k = 1; k <= this->Costs.size(); ++k)
    {
      const float* cost = &this->Costs[k - 1][MostBeside];
      const float* left = from - k;
      const float* costLeft = cost - k;
      const float* right = from + k;
      for (std::size_t node = 0; node < this->Nodes.size(); ++node)
      {
        const float least = std::min(left[node] + costLeft[node], right[node] + cost[node]);
        to[node] = std::min(to[node], least);
      }
    }
  }

private:
  void AddSquares(std::size_t k)
  {
    std::vector<float> squares(this->Nodes.size() + MostBeside, 0.0f);
    for (std::size_t node = 0; node + k < this->Nodes.size(); ++node)
    {
      const double along = this->Nodes[node + k] - this->Nodes[node];
      squares[node + MostBeside] = static_cast<float>(along * along);
    }
    this->Squares.push_back(std::move(squares));
  }

  const std::vector<double>& Nodes;
  double Distance = -1.0;
  std::vector<std::vector<float>> Squares; ///< of lengths to the node k + 1 to the right
  std::vector<std::vector<float>> Costs;   ///< of ways there
};

/// From line to line.
class Pass
{
public:
  Pass(const std::vector<double>& nodes, const std::vector<double>& lines)
    : Nodes(nodes)
    , Places(lines)
    , Before{ Ways(nodes), Ways(nodes), Ways(nodes) }
    , Widths(nodes.size() + 1, 1.0f)
  {
    for (std::size_t node = 1; node < nodes.size(); ++node)
    {
      this->Widths[node] = static_cast<float>(nodes[node] - nodes[node - 1]);
    }
  }

  bool Run(Lines& lines, Pulse& pulse)
  {
    for (std::size_t line = 1; line < lines.Count && pulse.Beat(4 * lines.Size); ++line)
    {
      for (std::size_t away = 1; away <= std::min(line, LeastBeside.size()); ++away)
      {
        this->Step(lines, line - away, line, away);
      }
    }
    for (std::size_t line = lines.Count - 1; line > 0 && pulse.Beat(4 * lines.Size); --line)
    {
      for (std::size_t away = 1; away <= std::min(lines.Count - line, LeastBeside.size()); ++away)
      {
        this->Step(lines, line - 1 + away, line - 1, away);
      }
    }
    return !pulse.HasStopped();
  }

private:
  void Step(Lines& lines, std::size_t from, std::size_t to, std::size_t away)
  {
    const double distance = std::abs(this->Places[to] - this->Places[from]);
    const double meanWidth =
      (this->Nodes.back() - this->Nodes.front()) / static_cast<double>(this->Nodes.size() - 1);
    const double reach = std::ceil(ReachAlong * distance / meanWidth - RoundingOfDistance);
    const std::size_t beside = away > 1 || !(reach > 1.0)
      ? LeastBeside[away - 1]
      : std::min(this->Nodes.size(),
          static_cast<std::size_t>(std::min(reach, static_cast<double>(MostBeside))));
    Ways& ways = this->Before[away - 1];
    const bool isFar = away == 1 && this->LeastReach(beside) < ShareOfReach * ReachAlong * distance;
    ways.Set(distance, isFar ? LeastBeside[0] : beside);
    ways.Offer(lines.At(from), lines.At(to));
    if (away == 1)
    {
      this->OfferBetween(lines.At(from), static_cast<float>(distance), lines.At(to));
    }
    if (isFar)
    {
      const std::size_t last = this->Nodes.size() - 1;
      this->OfferAll(
        lines.At(from), static_cast<float>(distance), lines.At(to), { 0, last }, { 0, last });
    }
  }

  /// Of so many nodes along a line, wherever they begin.
  double LeastReach(std::size_t beside)
  {
    for (std::size_t k = this->LeastReaches.size(); k <= beside; ++k)
    {
      double least = Infinity;
      for (std::size_t node = k; node < this->Nodes.size(); ++node)
      {
        least = std::min(least, this->Nodes[node] - this->Nodes[node - k]);
      }
      this->LeastReaches.push_back(least);
    }
    return this->LeastReaches[beside];
  }

  /// First and last nodes of a line.
  using Part = std::array<std::size_t, 2>;

  /// What the part `among` of a line allows along a part of another one. As what ways cost is
  /// convex, those that are best for two nodes do not cross: so what is best for the middle one
  /// divides both parts.
  void OfferAll(const float* from, float distance, float* to, Part nodes, Part among) const
  {
    const std::size_t middle = nodes[0] + (nodes[1] - nodes[0]) / 2;
    const float square = distance * distance;
    float least = Infinity;
    std::size_t best = among[0];
    for (std::size_t k = among[0]; k <= among[1]; ++k)
    {
      const auto along = static_cast<float>(this->Nodes[k] - this->Nodes[middle]);
      const float offered = from[k] + std::sqrt(square + along * along);
      best = offered < least ? k : best;
      least = std::min(least, offered);
    }
    to[middle] = std::min(to[middle], least);
    if (middle > nodes[0])
    {
      this->OfferAll(from, distance, to, { nodes[0], middle - 1 }, { among[0], best });
    }
    if (middle < nodes[1])
    {
      this->OfferAll(from, distance, to, { middle + 1, nodes[1] }, { best, among[1] });
    }
  }

  /// Along a way at an angle a with the lines' normal, of which the sine is the slope p along the
  /// line, what is offered rises by cos a times the distance of the lines. The ways to neighbors
  /// are the steepest ones.
  void OfferBetween(const float* from, float distance, float* to) const
  {
    const float* width = this->Widths.data();
    const float* toLeft = this->Before[0].ToNext() - 1;
    const float* left = from - 1;
    for (std::size_t node = 0; node < this->Nodes.size(); ++node)
    {
      const float slopes[2] = { std::min(width[node] / toLeft[node],
                                  (from[node] - left[node]) / width[node]),
        std::min(
          width[node + 1] / toLeft[node + 1], (from[node] - left[node + 2]) / width[node + 1]) };
      const float slope = std::max(std::max(0.0f, slopes[0]), slopes[1]);
      to[node] = std::min(to[node], from[node] + distance * std::sqrt(1.0f - slope * slope));
    }
  }

  const std::vector<double>& Nodes;  ///< along a line
  const std::vector<double>& Places; ///< of the lines
  std::array<Ways, 3> Before;
  std::vector<float> Widths;        ///< from each node to the one before it; 1 at the ends
  std::vector<double> LeastReaches; ///< of 0, 1, ... nodes
};

void Transpose(const float* from, std::size_t fromStride, std::size_t lines, std::size_t size,
  float* to, std::size_t toStride)
{
  constexpr std::size_t Tile = 16;
  for (std::size_t line = 0; line < lines; line += Tile)
  {
    for (std::size_t node = 0; node < size; node += Tile)
    {
      const std::size_t lastLine = std::min(line + Tile, lines);
      const std::size_t lastNode = std::min(node + Tile, size);
      for (std::size_t k = node; k < lastNode; ++k)
      {
        for (std::size_t j = line; j < lastLine; ++j)
        {
          to[k * toStride + j] = from[j * fromStride + k];
        }
      }
    }
  }
}

std::vector<double> Times(std::vector<double> nodes, double factor)
{
  for (double& node : nodes)
  {
    node *= factor;
  }
  return nodes;
}

} // namespace

bool RunGridPasses(const std::vector<double>& columns, const std::vector<double>& rows,
  double gradation, std::vector<float>& values, Pulse& pulse)
{
  const std::vector<double> x = Times(columns, gradation);
  const std::vector<double> y = Times(rows, gradation);
  Lines byColumn(x.size(), y.size());
  Transpose(values.data(), x.size(), y.size(), x.size(), byColumn.At(0), byColumn.Stride);
  if (!Pass(y, x).Run(byColumn, pulse))
  {
    return false;
  }
  Lines byRow(y.size(), x.size());
  Transpose(byColumn.At(0), byColumn.Stride, x.size(), y.size(), byRow.At(0), byRow.Stride);
  if (!Pass(x, y).Run(byRow, pulse))
  {
    return false;
  }
  for (std::size_t row = 0; row < y.size(); ++row)
  {
    std::copy_n(byRow.At(row), x.size(), &values[row * x.size()]);
  }
  return true;
}

} // namespace biting
