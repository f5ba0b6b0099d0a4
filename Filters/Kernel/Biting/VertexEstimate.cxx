// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "VertexEstimate.h"

#include "../Base/Pulse.h"
#include "DensitySamples.h"

#include <algorithm> // for min, max
#include <cmath>     // for ceil, log
#include <limits>    // for infinity
#include <numeric>   // for accumulate
#include <vector>    // for rules

namespace biting
{

namespace
{

constexpr double SquaresInAll = 2048.0; // of the integral, roughly
constexpr double LeastShare = 0.25;     // of the integral, that is worth a square
constexpr std::size_t MostSquares = 100000;
constexpr int LeastDepth = 3;                // of squares: 64 of them
constexpr double SegmentPanel = 3.0;         // of a segment, in spacings
constexpr double NearlyLevel = 1e-3;         // growth of f in a panel, as a share of it
constexpr double MostPanels = 64.0;          // along a segment
constexpr double MostPanelsInAll = 300000.0; // but at least one a segment

// Where no sample is inside.
double MeanDensityOfSegments(const Domain& domain, const Spacing& spacing, Pulse& pulse)
{
  double sum = 0.0;
  for (Id segment = 0; segment < domain.NumberOfSegments() && pulse.Beat(); ++segment)
  {
    const double f = spacing(
      Midpoint(domain.Vertices[domain.Starts[segment]], domain.Vertices[domain.Ends[segment]]));
    sum += 1.0 / (f * f);
  }
  return sum / std::max(1, domain.NumberOfSegments());
}

// How 1/f is integrated along a segment.
struct SegmentRule
{
  double AtStart = 0.0; ///< f
  double AtEnd = 0.0;
  double Panels = 1.0;
};

// Most segments begin where the one before ends.
std::vector<SegmentRule> MakeRules(const Domain& domain, const Spacing& spacing, Pulse& pulse)
{
  std::vector<SegmentRule> rules;
  rules.reserve(domain.Starts.size());
  Id last = NoId;
  double atLast = 0.0;
  for (Id segment = 0; segment < domain.NumberOfSegments() && pulse.Beat(); ++segment)
  {
    const Id start = domain.Starts[segment];
    const double atStart = start == last ? atLast : spacing(domain.Vertices[start]);
    last = domain.Ends[segment];
    atLast = spacing(domain.Vertices[last]);
    const double length = Distance(domain.Vertices[start], domain.Vertices[last]);
    const double panels = length / (SegmentPanel * std::min(atStart, atLast));
    rules.push_back({ atStart, atLast, std::max(1.0, std::min(MostPanels, panels)) });
  }
  return rules;
}

// Of 1/f, between two places where it is known and linear between: small at one of them, as at the
// tip of a cone, it would outweigh all else if 1/f were linear.
double MeanInverse(double first, double last)
{
  const double growth = last - first;
  return std::abs(growth) > NearlyLevel * first ? std::log(last / first) / growth
                                                : 2.0 / (first + last);
}

// Of 1/f along a segment.
double IntegrateInverse(const Domain& domain, Id segment, const SegmentRule& rule, int panels,
  const Spacing& spacing, Pulse& pulse)
{
  const Point2& a = domain.Vertices[domain.Starts[segment]];
  const Point2& b = domain.Vertices[domain.Ends[segment]];
  double sum = 0.0;
  double last = rule.AtStart;
  for (int k = 1; k <= panels && pulse.Beat(); ++k)
  {
    const double next = k < panels
      ? spacing(a + static_cast<double>(k) / static_cast<double>(panels) * (b - a))
      : rule.AtEnd;
    sum += MeanInverse(last, next);
    last = next;
  }
  return sum / panels * Distance(a, b);
}

} // namespace

double IntegrateDensity(
  const Domain& domain, const DomainLocator& locator, const Spacing& spacing, Monitor& monitor)
{
  if (spacing.IsUniform())
  {
    const double f = spacing(domain.Bounds.Center());
    return domain.Area / (f * f);
  }
  Pulse pulse(monitor);
  const auto sum = [&](double most)
  {
    DensitySample whole;
    for (const DensitySample& sample :
      SampleDensity(domain, locator, spacing, { most, MostSquares, LeastDepth }, pulse))
    {
      whole.Area += sample.Area;
      whole.Density += sample.Density;
    }
    return whole;
  };
  const double roughly = sum(std::numeric_limits<double>::infinity()).Density;
  pulse.SetFraction(0.1);
  const DensitySample whole = sum(std::max(LeastShare, roughly / SquaresInAll));
  // The area is known: it corrects what samples make of it, so that a sliver is not lost.
  const double mean =
    whole.Area > 0.0 ? whole.Density / whole.Area : MeanDensityOfSegments(domain, spacing, pulse);
  return mean * domain.Area;
}

double EstimateDivisionPoints(
  const Domain& domain, const Spacing& spacing, double partLength, Monitor& monitor)
{
  Pulse pulse(monitor);
  const std::vector<SegmentRule> rules = MakeRules(domain, spacing, pulse);
  const double panels = std::accumulate(rules.begin(), rules.end(), 0.0,
    [](double sum, const SegmentRule& rule) { return sum + rule.Panels; });
  const double share = std::min(1.0, MostPanelsInAll / panels);
  double points = 0.0;
  for (std::size_t k = 0; k < rules.size() && pulse.Beat(); ++k)
  {
    pulse.SetFraction(static_cast<double>(k) / static_cast<double>(rules.size()));
    const int count = static_cast<int>(std::ceil(share * rules[k].Panels));
    const double parts =
      IntegrateInverse(domain, static_cast<Id>(k), rules[k], count, spacing, pulse) / partLength;
    points += std::max(0.0, parts - 1.0);
  }
  return points;
}

} // namespace biting
