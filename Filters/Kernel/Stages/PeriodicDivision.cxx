// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PeriodicDivision.h"

#include "../Base/Directory.h"
#include "../Base/DisjointSets.h"
#include "../Base/Pulse.h"
#include "../Biting/EdgeDivision.h"

#include <algorithm> // for lower_bound, max, min, reverse, sort
#include <memory>    // for sources
#include <utility>   // for move, pair

namespace biting
{

namespace
{

// Roundings of two points and of the translation.
constexpr double RoundingsOfImage = 4.0;

constexpr double StepOfSamples = 0.5; // of f along a side

struct Line
{
  Point2 Start;
  Point2 End;

  Point2 At(double t) const { return this->Start + t * (this->End - this->Start); }
};

Line LineOf(const Domain& domain, Id segment)
{
  return { domain.Vertices[domain.Starts[segment]], domain.Vertices[domain.Ends[segment]] };
}

// The second segment of a pair, in the direction of the first.
Line ImageOf(const Domain& domain, const PeriodicSides::Pair& pair)
{
  const Line line = LineOf(domain, pair.Second);
  return AreParallel(domain, pair) ? line : Line{ line.End, line.Start };
}

// Where f differs between the sides.
void AddLower(const Line& first, const Line& second, const Spacing& f, double scale,
  SegmentSource& source, Pulse& pulse)
{
  const auto lower = [&first, &second, &f](double t)
  { return std::min(f(first.At(t)), f(second.At(t))); };
  const double length = Distance(first.Start, first.End);
  double last = 0.0;
  double lastValue = lower(0.0);
  while (last < 1.0 && pulse.Beat(64))
  {
    const double next = std::min(1.0, last + StepOfSamples * lastValue / length);
    const double value = lower(next);
    for (const Line& line : { first, second })
    {
      if (lastValue < f(line.At(last)) || value < f(line.At(next)))
      {
        source.Add(line.At(last), line.At(next), lastValue / scale, value / scale);
      }
    }
    last = next;
    lastValue = value;
  }
}

// Of whole segments, whose parts are in a row.
void PairParts(const std::vector<Id>& old, const Domain& domain, PeriodicSides& sides)
{
  const auto begin = [&old](Id segment)
  { return static_cast<Id>(std::lower_bound(old.begin(), old.end(), segment) - old.begin()); };
  std::vector<PeriodicSides::Pair> pairs;
  for (const PeriodicSides::Pair& pair : sides.Pairs)
  {
    const Id first = begin(pair.First);
    const Id second = begin(pair.Second);
    const Id parts = begin(pair.First + 1) - first;
    const bool areParallel = AreParallel(domain, { first, second, pair.Translation });
    for (Id part = 0; part < parts; ++part)
    {
      pairs.push_back(
        { first + part, second + (areParallel ? part : parts - 1 - part), pair.Translation });
    }
  }
  sides.Pairs = std::move(pairs);
}

} // namespace

PeriodicSides FindPeriodicSides(Domain& domain, const Polylines& input,
  const BitingMeshOptions& options, ProblemList& problems, Monitor& monitor)
{
  Pulse pulse(monitor);
  const double rounding = std::max({ domain.Resolution, input.Rounding.X, input.Rounding.Y });
  const double merged = options.Domain.MergeTolerance * domain.Bounds.Diagonal();
  return MatchSides(domain, options.PeriodicTranslations,
    std::max({ RoundingsOfImage * rounding, input.SeamNoise, merged }), problems, pulse);
}

// f as it is stays the lower bound of the cap by feature sizes: a quarter of what is given would be
// less each time.
BitingMeshOptions WithLowerOfSides(const BitingMeshOptions& options, const Domain& domain,
  const PeriodicSides& sides, const Spacing& f, Monitor& monitor)
{
  Pulse pulse(monitor);
  BitingMeshOptions result = options;
  SpacingOptions& spacing = result.Spacing;
  auto lower = std::make_shared<SegmentSource>();
  for (const PeriodicSides::Pair& pair : sides.Pairs)
  {
    AddLower(LineOf(domain, pair.First), ImageOf(domain, pair), f, spacing.Scale, *lower, pulse);
  }
  if (lower->Points.empty() || pulse.HasStopped())
  {
    return result;
  }
  if (spacing.Uniform == 0.0 && spacing.Sources.empty())
  {
    spacing.Uniform = f.BeforeFeatures(domain.Vertices.front()) / spacing.Scale;
  }
  spacing.Sources.emplace_back(std::move(lower));
  return result;
}

// The first of segments that are alike is divided, and the others as it is.
void DivideSides(const Spacing& f, const BitingOptions& options, PeriodicSides& sides,
  Domain& domain, Monitor& monitor)
{
  Pulse pulse(monitor);
  const std::size_t count = domain.Starts.size();
  DisjointSets alike(count);
  domain.IsPreserved.resize(count, 0);
  for (const PeriodicSides::Pair& pair : sides.Pairs)
  {
    alike.Unite(pair.First, pair.Second);
    domain.IsPreserved[pair.First] = 1;
    domain.IsPreserved[pair.Second] = 1;
  }
  EdgeDivider divider(f, options.BitingConstant, options.PartLength, pulse);
  DivisionPoints points;
  std::vector<std::vector<double>> parameters(count);
  for (Id segment = 0; segment < domain.NumberOfSegments() && !pulse.HasStopped(); ++segment)
  {
    const Id first = alike.SetOf(segment);
    const Line line = LineOf(domain, segment);
    if (alike.SizeOf(first) == 1)
    {
      continue;
    }
    if (first == segment)
    {
      divider.Divide(
        line.Start, line.End, static_cast<Id>(options.MaximumNumberOfVertices), points);
      parameters[segment] = points.Parameters;
    }
    else
    {
      parameters[segment] = parameters[first];
      if (!AreParallel(domain, { first, segment, 0 }))
      {
        std::reverse(parameters[segment].begin(), parameters[segment].end());
        for (double& parameter : parameters[segment])
        {
          parameter = 1.0 - parameter;
        }
      }
    }
  }
  if (!pulse.HasStopped())
  {
    PairParts(DivideSegments(parameters, domain), domain, sides);
  }
}

// By places: what is preserved is where it was.
void TellPartners(
  const Domain& domain, const PeriodicSides& sides, std::size_t translations, BitingMesh& mesh)
{
  Directory<Point2> places;
  for (std::size_t edge = 0; edge < mesh.EdgeStarts.size(); ++edge)
  {
    for (const Id vertex : { mesh.EdgeStarts[edge], mesh.EdgeEnds[edge] })
    {
      places.Add(mesh.Points[vertex], vertex);
    }
  }
  places.Sort();
  mesh.Partners.assign(translations, std::vector<Id>(mesh.Points.size(), NoId));
  for (const PeriodicSides::Pair& pair : sides.Pairs)
  {
    const Line first = LineOf(domain, pair.First);
    const Line second = ImageOf(domain, pair);
    std::vector<Id>& partners = mesh.Partners[pair.Translation];
    for (const auto& [place, image] :
      { std::make_pair(first.Start, second.Start), std::make_pair(first.End, second.End) })
    {
      const Id vertex = places[place];
      const Id partner = places[image];
      if (vertex != NoId && partner != NoId)
      {
        partners[vertex] = partner;
        partners[partner] = partners[partner] == NoId ? vertex : partners[partner];
      }
    }
  }
}

} // namespace biting
