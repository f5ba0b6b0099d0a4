// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGridSteps_h
#define BitingGridSteps_h

#include <algorithm> // for fill_n
#include <array>     // for lines before
#include <cmath>     // for abs
#include <cstddef>   // for counts
#include <limits>    // for the greatest float
#include <memory>    // for values
#include <vector>    // for nodes

namespace biting
{

/// No node of a line is offered anything by one that is more nodes away along it, but where cells
/// are long.
constexpr std::size_t MostBesideNode = 32;

/// Nodes line by line, with the greatest values at both ends of each. Without values at first: who
/// touches memory first waits for it.
struct GridLines
{
  GridLines(std::size_t count, std::size_t size)
    : Count(count)
    , Size(size)
    , Beyond(std::min(size, MostBesideNode))
    , Stride(size + 2 * this->Beyond)
    , Values(new float[count * this->Stride])
  {
  }

  float* At(std::size_t line) { return &this->Values[line * this->Stride + this->Beyond]; }

  void SetEnds(std::size_t line)
  {
    constexpr float greatest = std::numeric_limits<float>::max();
    std::fill_n(this->At(line) - this->Beyond, this->Beyond, greatest);
    std::fill_n(this->At(line) + this->Size, this->Beyond, greatest);
  }

  std::size_t Count;
  std::size_t Size;   ///< of each
  std::size_t Beyond; ///< so many more at each end
  std::size_t Stride;
  std::unique_ptr<float[]> Values;
};

/// From a node on, and to before another one.
struct NodeRange
{
  std::size_t Begin;
  std::size_t End;
};

/// Nodes along a line, and lines, of which there are two at least each; lengths are in what f grows
/// by.
struct GridAxes
{
  GridAxes(const std::vector<double>& nodes, const std::vector<double>& lines);

  double DistanceOf(std::size_t line, std::size_t other) const
  {
    return std::abs(this->Places[line] - this->Places[other]);
  }

  /// How many nodes to each side are offered something from a line that is the next, or the one
  /// after that, or yet another one away.
  std::size_t Beside(double distance, std::size_t away) const;

  /// Those to which so many nodes reach much less far than they should, and what lies between:
  /// cells are long there.
  NodeRange FarFrom(double distance) const;

  /// Those with all that should be offered something from there.
  NodeRange Around(const NodeRange& nodes, double distance) const;

  const std::vector<double>& Nodes;
  const std::vector<double>& Places; ///< of the lines
  std::vector<float> Widths;         ///< from each node to the one before it; 1 at the ends
  std::vector<double> LeastReaches;  ///< of 0, 1, ... nodes, wherever they begin
};

/// Goes from one line to the next: each is offered what lines before allow.
class GridSteps
{
public:
  /// So many lines before are asked.
  static constexpr std::size_t LinesBefore = 3;

  explicit GridSteps(const GridAxes& axes)
    : Axes(axes)
    , Offers(axes.Nodes.size())
    , Before{ Ways(axes.Nodes), Ways(axes.Nodes), Ways(axes.Nodes) }
  {
  }

  /// From a line to one that is `away` lines further.
  void Step(GridLines& lines, std::size_t from, std::size_t to, std::size_t away);

private:
  /// Between nodes of one line and those of another one.
  class Ways
  {
  public:
    explicit Ways(const std::vector<double>& nodes)
      : Nodes(nodes)
    {
    }

    /// From a line so far away, to nodes up to `beside` along it.
    void Set(double distance, std::size_t beside);

    /// From the nodes of one line to the next ones of the other.
    const float* ToNext() const { return this->CostsTo(1); }

    /// What the nodes of a line allow at those of another one.
    void Offer(const float* from, float* to) const;

  private:
    void AddSquares(std::size_t k);

    const float* CostsTo(std::size_t k) const { return &this->Costs[k - 1][MostBesideNode]; }

    const std::vector<double>& Nodes;
    double Distance = -1.0;
    std::vector<std::vector<float>> Squares; ///< of lengths to the node k + 1 to the right
    std::vector<std::vector<float>> Costs;   ///< of ways there
  };

  void OfferBetween(const float* from, float distance, float* to) const;
  void OfferFar(const float* from, float distance, float* to, const NodeRange& far);
  void OfferAll(
    const float* from, float distance, float* to, const NodeRange& nodes, const NodeRange& among);
  std::size_t BestOf(const float* from, float square, std::size_t node, const NodeRange& among);

  const GridAxes& Axes;
  std::vector<float> Offers;            ///< of the nodes of a line to one of the next
  std::array<Ways, LinesBefore> Before; ///< to the line before, to the one before that ...
};

} // namespace biting

#endif
