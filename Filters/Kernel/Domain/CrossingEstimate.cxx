// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CrossingEstimate.h"

#include "../Predicates/Predicates.h"

#include <algorithm> // for max, min
#include <cmath>     // for sqrt
#include <limits>    // for any length
#include <numeric>   // for gcd

namespace biting
{

namespace
{

constexpr std::size_t LeastSample = 32;
constexpr std::size_t MostTests = 4000000; // about half a second
constexpr double GoldenRatio = 0.6180339887498949;
constexpr double StandardErrors = 4.0;
constexpr double MostInMeans = 16.0; // an edge counts as that many times the mean asked for

/// The mean of what was counted, and how far it may be from that of all.
struct Sample
{
  std::size_t Size = 0;
  double Sum = 0.0;
  double SumOfSquares = 0.0;

  void Add(double count)
  {
    ++this->Size;
    this->Sum += count;
    this->SumOfSquares += count * count;
  }

  double Mean() const { return this->Sum / static_cast<double>(this->Size); }

  /// With equal counts there may still be others, which would be seen once in so many.
  double Error() const
  {
    const double size = static_cast<double>(this->Size);
    const double variance = this->SumOfSquares / size - this->Mean() * this->Mean();
    return StandardErrors * (std::sqrt(std::max(variance, 0.0) / size) + this->Mean() / size);
  }
};

class CrossingSampler
{
public:
  CrossingSampler(const Arrangement& arrangement, const SegmentTree& tree, Pulse& pulse)
    : Input(arrangement)
    , Tree(tree)
    , Beats(pulse)
  {
  }

  CrossingEstimate EstimateAbove(double most);

private:
  std::size_t CountCrossings(Id edge, std::size_t most);
  bool DoCross(const SegmentEnds& a, const SegmentEnds& b) const;

  const Arrangement& Input;
  const SegmentTree& Tree;
  Pulse& Beats;
  std::size_t Tests = 0;
  CrossingEstimate Result;
};

/// Steps of the golden ratio of all edges are spread over them, wherever one stops.
std::size_t StepThrough(std::size_t count)
{
  auto step = static_cast<std::size_t>(GoldenRatio * static_cast<double>(count));
  while (std::gcd(step, count) != 1)
  {
    ++step;
  }
  return step;
}

CrossingEstimate CrossingSampler::EstimateAbove(double most)
{
  const std::size_t count = this->Input.Edges.size();
  const double edges = static_cast<double>(count);
  const double askedMean = 2.0 * most / edges;
  const auto mostOfOne = static_cast<std::size_t>(MostInMeans * (1.0 + askedMean));
  const std::size_t step = StepThrough(count);
  Sample sample;
  for (std::size_t edge = 0; sample.Size < count && this->Beats.Ask(); edge = (edge + step) % count)
  {
    sample.Add(static_cast<double>(this->CountCrossings(static_cast<Id>(edge), mostOfOne)));
    if (sample.Size < LeastSample)
    {
      continue;
    }
    if (sample.Mean() - sample.Error() > askedMean)
    {
      this->Result.Count = 0.5 * sample.Mean() * edges;
      return this->Result;
    }
    if (sample.Mean() + sample.Error() < askedMean || this->Tests > MostTests)
    {
      break;
    }
  }
  return {};
}

std::size_t CrossingSampler::CountCrossings(Id edge, std::size_t most)
{
  const SegmentEnds& ends = this->Input.Edge(edge).Ends;
  std::size_t count = 0;
  const auto test = [this, edge, &ends, &count, most](Id other)
  {
    ++this->Tests;
    const bool isOpen = count < most && this->Beats.Beat();
    if (isOpen && this->DoCross(ends, this->Input.Edge(other).Ends))
    {
      ++count;
      this->Result.First = std::min(edge, other);
      this->Result.Second = std::max(edge, other);
    }
  };
  this->Tree.VisitAlong(this->Input.At(ends.Start), this->Input.At(ends.End),
    std::numeric_limits<double>::infinity(), ends, test);
  return count;
}

bool CrossingSampler::DoCross(const SegmentEnds& a, const SegmentEnds& b) const
{
  return Meet(this->Input.At(a.Start), this->Input.At(a.End), this->Input.At(b.Start),
           this->Input.At(b.End)) == Meeting::Crossing;
}

} // namespace

CrossingEstimate EstimateCrossingsAbove(
  std::size_t most, const Arrangement& arrangement, const SegmentTree& tree, Pulse& pulse)
{
  const double edges = static_cast<double>(arrangement.Edges.size());
  if (0.5 * edges * (edges - 1.0) <= static_cast<double>(most))
  {
    return {};
  }
  return CrossingSampler(arrangement, tree, pulse).EstimateAbove(static_cast<double>(most));
}

} // namespace biting
