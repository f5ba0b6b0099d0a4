// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CrossingEstimate.h"

#include "../Predicates/Predicates.h"

#include <algorithm> // for max, min
#include <cmath>     // for sqrt
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
  CrossingSampler(const std::vector<Point2>& vertices, const std::vector<SegmentEnds>& edges,
    const SegmentTree& tree, Pulse& pulse)
    : Vertices(vertices)
    , Edges(edges)
    , Tree(tree)
    , Beats(pulse)
  {
  }

  CrossingEstimate EstimateAbove(double most);

private:
  std::size_t CountCrossings(Id edge, std::size_t most);
  bool DoCross(const SegmentEnds& a, const SegmentEnds& b) const;

  const Point2& At(Id vertex) const { return this->Vertices[vertex]; }

  const std::vector<Point2>& Vertices;
  const std::vector<SegmentEnds>& Edges;
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
  const std::size_t count = this->Edges.size();
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
  const SegmentEnds& ends = this->Edges[edge];
  std::size_t count = 0;
  const auto test = [this, edge, &ends, &count, most](Id other)
  {
    ++this->Tests;
    const bool isOpen = count < most && this->Beats.Beat();
    if (isOpen && this->DoCross(ends, this->Edges[other]))
    {
      ++count;
      this->Result.First = std::min(edge, other);
      this->Result.Second = std::max(edge, other);
    }
  };
  this->Tree.Visit(SlantedBox(this->At(ends.Start), this->At(ends.End)), ends, test);
  return count;
}

bool CrossingSampler::DoCross(const SegmentEnds& a, const SegmentEnds& b) const
{
  return Meet(this->At(a.Start), this->At(a.End), this->At(b.Start), this->At(b.End)) ==
    Meeting::Crossing;
}

} // namespace

CrossingEstimate EstimateCrossingsAbove(std::size_t most, const std::vector<Point2>& vertices,
  const std::vector<SegmentEnds>& edges, const SegmentTree& tree, Pulse& pulse)
{
  const double count = static_cast<double>(edges.size());
  if (0.5 * count * (count - 1.0) <= static_cast<double>(most))
  {
    return {};
  }
  return CrossingSampler(vertices, edges, tree, pulse).EstimateAbove(static_cast<double>(most));
}

} // namespace biting
