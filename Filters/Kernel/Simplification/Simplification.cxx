// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Simplification.h"

#include "../Base/Numbers.h"
#include "../Base/Pulse.h"
#include "../Domain/AreaSum.h"
#include "ChainCorners.h"
#include "ChainReduction.h"
#include "DomainChains.h"
#include "SmallLoops.h"

#include <algorithm> // for max, min, sort
#include <cmath>     // for abs, ceil
#include <cstdint>   // for flags
#include <sstream>   // for the detail
#include <utility>   // for move
#include <vector>    // for the arrays

namespace biting
{

namespace
{

using SpacingFunction = std::function<double(const Point2&)>;
using Flags = std::vector<std::uint8_t>;

// Where steps end, as shares of the time.
constexpr double LoopsEnd = 0.1;
constexpr double TolerancesEnd = 0.2;
constexpr double FirstRoundEnd = 0.7;

// Corners are judged once the zigzag is gone that is finer than this share of the tolerance.
constexpr double ShareBeforeCorners = 0.125;

// Errors equal to the tolerance but for rounding are above it, in whatever direction they lie.
constexpr double BelowTies = 1.0 - 1.0 / (1 << 26);

constexpr double MostChangeOfArea = 0.05; // without a word

constexpr double MostSamples = 1024.0; // of f along a segment, half of f apart

// What is left of a domain: some of its segments, and others that stand for several.
class DomainSubset
{
public:
  explicit DomainSubset(const Domain& domain)
    : Whole(domain)
    , IsUsed(domain.Vertices.size(), 0)
  {
    for (std::size_t vertex = 0; vertex < domain.Vertices.size(); ++vertex)
    {
      this->IsUsed[vertex] = domain.IsEmbedded[vertex];
    }
  }

  // A segment between the vertices with all else as `like` has it.
  void Add(Id start, Id end, Id like)
  {
    this->IsUsed[start] = 1;
    this->IsUsed[end] = 1;
    this->Segments.push_back({ like, start, end });
  }

  Domain Make()
  {
    Domain part;
    part.Resolution = this->Whole.Resolution;
    part.Bounds = this->Whole.Bounds;
    const std::vector<Id> numbers = this->CopyVertices(part);
    std::sort(this->Segments.begin(), this->Segments.end(),
      [](const Segment& a, const Segment& b) { return a.Like < b.Like; });
    AreaSum sum(this->Whole.Vertices.front());
    for (const Segment& segment : this->Segments)
    {
      part.Starts.push_back(numbers[segment.Start]);
      part.Ends.push_back(numbers[segment.End]);
      part.Cells.push_back(this->Whole.Cells[segment.Like]);
      part.IsBoundary.push_back(this->Whole.IsBoundary[segment.Like]);
      part.LeftInside.push_back(this->Whole.LeftInside[segment.Like]);
      part.RightInside.push_back(this->Whole.RightInside[segment.Like]);
      if (part.IsBoundary.back())
      {
        const bool isLeft = part.LeftInside.back() != 0;
        sum.Add(this->Whole.Vertices[isLeft ? segment.Start : segment.End],
          this->Whole.Vertices[isLeft ? segment.End : segment.Start]);
      }
    }
    part.Area = sum.Area();
    return part;
  }

private:
  struct Segment
  {
    Id Like;
    Id Start;
    Id End;
  };

  // Returns their new numbers.
  std::vector<Id> CopyVertices(Domain& part) const
  {
    std::vector<Id> numbers(this->IsUsed.size(), NoId);
    for (std::size_t vertex = 0; vertex < this->IsUsed.size(); ++vertex)
    {
      if (this->IsUsed[vertex])
      {
        numbers[vertex] = part.NumberOfVertices();
        part.Vertices.push_back(this->Whole.Vertices[vertex]);
        part.VertexPoints.push_back(this->Whole.VertexPoints[vertex]);
        part.IsEmbedded.push_back(this->Whole.IsEmbedded[vertex]);
        part.HasPoint.push_back(this->Whole.HasPoint[vertex]);
      }
    }
    return numbers;
  }

  const Domain& Whole;
  Flags IsUsed;
  std::vector<Segment> Segments;
};

// The domain without the loops.
Domain WithoutLoops(
  const Domain& domain, const DomainChains& chains, const std::vector<SmallLoop>& loops)
{
  Flags isLeftOut(domain.Starts.size(), 0);
  for (const SmallLoop& loop : loops)
  {
    for (Id slot = chains.Firsts[loop.Chain]; slot < chains.Firsts[loop.Chain + 1]; ++slot)
    {
      isLeftOut[chains.Segments[slot]] = 1;
    }
  }
  DomainSubset rest(domain);
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    if (!isLeftOut[segment])
    {
      rest.Add(domain.Starts[segment], domain.Ends[segment], segment);
    }
  }
  return rest.Make();
}

void LeaveOutLoops(const Domain& domain, const SimplificationOptions& options,
  const SpacingFunction& spacing, SimplifiedDomain& result, ProblemList& problems, Pulse& pulse)
{
  const PulsePart part(pulse, 0.0, LoopsEnd);
  const DomainChains chains = MakeChains(domain, {}, pulse);
  SmallLoopFinder finder(domain, chains, pulse);
  const std::vector<SmallLoop> loops = finder.Find(options.MinimumLoopSize, spacing, pulse);
  for (const SmallLoop& loop : loops)
  {
    const Id segment = chains.Segments[chains.Firsts[loop.Chain]];
    problems.Add({ ProblemCode::SmallLoops, { domain.Cells[segment] }, loop.Bounds.Center(), {} });
    result.LeftOutArea += loop.Area;
  }
  result.LeftOutLoops = static_cast<Id>(loops.size());
  if (!loops.empty())
  {
    result.Drawing = WithoutLoops(domain, chains, loops);
  }
}

// The least f along a segment, seen at places at most half as far apart as f is at its ends.
double LeastAlong(
  const Point2& start, const Point2& end, double atEnds, const SpacingFunction& spacing)
{
  const double parts = std::min(MostSamples, std::ceil(2.0 * Distance(start, end) / atEnds));
  double least = atEnds;
  for (double k = 1.0; k < parts; k += 1.0)
  {
    least = std::min(least, spacing(start + (k / parts) * (end - start)));
  }
  return least;
}

// How far each vertex may be from what stands for it.
std::vector<double> MakeTolerances(
  const Domain& domain, double tolerance, const SpacingFunction& spacing, Pulse& pulse)
{
  const PulsePart part(pulse, LoopsEnd, TolerancesEnd);
  std::vector<double> values(domain.Vertices.size(), 0.0);
  for (std::size_t vertex = 0; vertex < values.size() && pulse.Beat(16); ++vertex)
  {
    values[vertex] = spacing(domain.Vertices[vertex]);
  }
  std::vector<double> least = values;
  for (Id segment = 0; segment < domain.NumberOfSegments() && pulse.Beat(16); ++segment)
  {
    const Id start = domain.Starts[segment];
    const Id end = domain.Ends[segment];
    const double along = LeastAlong(
      domain.Vertices[start], domain.Vertices[end], std::min(values[start], values[end]), spacing);
    least[start] = std::min(least[start], along);
    least[end] = std::min(least[end], along);
  }
  for (double& value : least)
  {
    value *= BelowTies * tolerance;
  }
  return least;
}

// The segments of the chains as they are left.
void TakeChains(const Domain& domain, const DomainChains& chains, SimplifiedDomain& result)
{
  DomainSubset rest(domain);
  for (Id slot = 0; slot < chains.NumberOfSlots(); ++slot)
  {
    if (chains.Goes[slot] || chains.Nexts[slot] == NoId)
    {
      continue;
    }
    const Id next = chains.Nexts[slot];
    Id first = chains.Segments[slot];
    bool isAlong = true;
    for (Id between = slot; between != next; between = chains.Following(between))
    {
      const Id segment = chains.Segments[between];
      if (segment <= first)
      {
        first = segment;
        isAlong = domain.Starts[segment] == chains.Vertices[between];
      }
    }
    rest.Add(chains.Vertices[isAlong ? slot : next], chains.Vertices[isAlong ? next : slot], first);
  }
  result.Drawing = rest.Make();
}

void ReduceChains(const Domain& domain, const SimplificationOptions& options,
  const std::vector<double>& tolerances, SimplifiedDomain& result, Pulse& pulse)
{
  DomainChains chains = MakeChains(domain, options.AreAlike, pulse);
  if (pulse.HasStopped())
  {
    return;
  }
  ChainReduction reduction(domain, tolerances, chains, pulse);
  {
    const PulsePart part(pulse, TolerancesEnd, FirstRoundEnd);
    reduction.ReduceTo(ShareBeforeCorners, pulse);
  }
  const PulsePart part(pulse, FirstRoundEnd, 1.0);
  const auto isFirst = [&reduction](Id slot, Id other) { return reduction.IsFirst(slot, other); };
  for (const Id corner :
    FindCorners(domain, chains, { tolerances, options.CornerAngle, isFirst }, pulse))
  {
    reduction.Keep(corner);
  }
  reduction.ReduceTo(1.0, pulse);
  result.RemovedVertices = reduction.NumberOfRemoved();
  TakeChains(domain, chains, result);
  for (Id segment = 0; result.RemovedVertices > 0 && segment < domain.NumberOfSegments(); ++segment)
  {
    result.DrawnEnds.push_back(domain.Vertices[domain.Starts[segment]]);
    result.DrawnEnds.push_back(domain.Vertices[domain.Ends[segment]]);
  }
}

} // namespace

SimplifiedDomain Simplify(const Domain& domain, const SimplificationOptions& options,
  const SpacingFunction& spacing, ProblemList& problems, Monitor& monitor)
{
  Pulse pulse(monitor);
  SimplifiedDomain result;
  if (options.MinimumLoopSize > 0.0)
  {
    LeaveOutLoops(domain, options, spacing, result, problems, pulse);
  }
  if (result.LeftOutLoops == 0)
  {
    result.Drawing = domain;
  }
  if (options.Tolerance > 0.0 && !pulse.HasStopped())
  {
    const Domain whole = std::move(result.Drawing);
    const std::vector<double> tolerances = MakeTolerances(whole, options.Tolerance, spacing, pulse);
    ReduceChains(whole, options, tolerances, result, pulse);
    if (!pulse.HasStopped())
    {
      ReportChangedArea(whole.Area, result.Drawing.Area, problems);
    }
  }
  return pulse.HasStopped() ? SimplifiedDomain() : std::move(result);
}

void ReportChangedArea(double before, double after, ProblemList& problems)
{
  const double change = after / before - 1.0;
  if (std::abs(change) > MostChangeOfArea)
  {
    std::ostringstream detail;
    detail.precision(3);
    detail << "from " << before << " to " << after << ", by " << std::showpos << 100.0 * change
           << " %";
    problems.Add({ ProblemCode::ChangedArea, {}, {}, detail.str() });
  }
}

SimplifiedDomain SimplifyChains(const Domain& domain, const SimplificationOptions& options,
  const std::vector<double>& spacings, Monitor& monitor)
{
  Pulse pulse(monitor);
  SimplifiedDomain result;
  std::vector<double> tolerances;
  tolerances.reserve(spacings.size());
  for (const double spacing : spacings)
  {
    tolerances.push_back(BelowTies * options.Tolerance * spacing);
  }
  ReduceChains(domain, options, tolerances, result, pulse);
  return pulse.HasStopped() ? SimplifiedDomain() : std::move(result);
}

} // namespace biting
