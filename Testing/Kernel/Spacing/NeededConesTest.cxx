// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/NeededCones.h"

#include "SpacingSources.h"

#include "Spacing/SegmentExtension.h"

#include <gtest/gtest.h>

#include <numeric> // for iota

namespace
{

using namespace biting;

constexpr double Gradation = 0.3;
const ValueRange AnyValue{ 1.0, 0.0, 1e9 };

/// Those of all edges, and of all points.
std::vector<LowEdge> AllEdges(const TriangulatedSource& source)
{
  std::vector<LowEdge> edges;
  const auto add = [&source, &edges](Id a, Id b)
  {
    const auto low = static_cast<std::size_t>(a);
    const auto high = static_cast<std::size_t>(b);
    edges.push_back(
      { source.Points[low], source.Points[high], source.Values[low], source.Values[high], a, b });
  };
  for (std::size_t corner = 0; corner < source.Triangles.size(); ++corner)
  {
    const Id start = source.Triangles[corner];
    const Id end = source.Triangles[corner % 3 == 2 ? corner - 2 : corner + 1];
    const bool isRising =
      source.Values[static_cast<std::size_t>(start)] < source.Values[static_cast<std::size_t>(end)];
    add(isRising ? start : end, isRising ? end : start);
    add(start, start);
  }
  return edges;
}

std::vector<LowEdge> NeededOf(const TriangulatedSource& source, const ValueRange& range = AnyValue)
{
  Pulse pulse(NoMonitor());
  std::vector<Id> triangles(source.Triangles.size() / 3);
  std::iota(triangles.begin(), triangles.end(), 0);
  const TriangleSides sides(source, triangles, pulse);
  return NeededCones(AllEdges(source), { source, triangles, sides }, range, Gradation, pulse);
}

SegmentExtension LimitOf(const std::vector<LowEdge>& edges)
{
  Pulse pulse(NoMonitor());
  std::vector<SegmentCone> cones;
  for (const LowEdge& edge : edges)
  {
    cones.emplace_back(edge.Start, edge.End, edge.StartValue, edge.EndValue, Gradation);
  }
  return SegmentExtension(std::move(cones), Gradation, pulse);
}

/// The distance from the middle.
Field AroundTheMiddle(double slope)
{
  return [slope](const Point2& x) {
    return 0.01 + slope * std::max(Length(x - Point2{ 0.5, 0.5 }) - 0.1, 0.0);
  };
}

TriangulatedSource Noisy(std::uint64_t seed)
{
  Sampler sampler(seed);
  return MakeTriangulation(
    14, [&sampler](const Point2&) { return 0.02 * std::exp(3.0 * sampler.Next()); });
}

/// At the middles of sides, f as all edges limit it, against that of the needed ones.
void ExpectTheSameLimit(const TriangulatedSource& source)
{
  const SegmentExtension all = LimitOf(AllEdges(source));
  const SegmentExtension needed = LimitOf(NeededOf(source));
  for (std::size_t corner = 0; corner < source.Triangles.size(); ++corner)
  {
    const auto start = static_cast<std::size_t>(source.Triangles[corner]);
    const auto end =
      static_cast<std::size_t>(source.Triangles[corner % 3 == 2 ? corner - 2 : corner + 1]);
    const Point2 place = Midpoint(source.Points[start], source.Points[end]);
    const double given = 0.5 * (source.Values[start] + source.Values[end]);
    const double expected = std::min(given, all(place));
    const double limit = std::min(given, needed(place));
    EXPECT_GE(limit, expected * (1.0 - 1e-12));
    EXPECT_LE(limit, expected * (1.0 + CoverTolerance + IdleTolerance));
  }
}

} // namespace

TEST(NeededCones, LimitAsAllCones)
{
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
  {
    ExpectTheSameLimit(Noisy(seed));
  }
  for (const double slope : { 0.5, 0.9, 1.0, 1.01, 1.1, 2.0 })
  {
    ExpectTheSameLimit(MakeTriangulation(40, AroundTheMiddle(slope * Gradation)));
  }
}

TEST(NeededCones, AreNoneWhereNothingIsSteep)
{
  for (const double slope : { 0.0, 0.5, 0.9 })
  {
    EXPECT_TRUE(NeededOf(MakeTriangulation(40, AroundTheMiddle(slope * Gradation))).empty());
  }
}

TEST(NeededCones, OfAFieldALittleTooSteepAreAtItsLowestPlacesOnly)
{
  const std::vector<LowEdge> needed =
    NeededOf(MakeTriangulation(61, AroundTheMiddle(1.05 * Gradation)));
  EXPECT_FALSE(needed.empty());
  for (const LowEdge& edge : needed)
  {
    EXPECT_LE(Length(edge.Start - Point2{ 0.5, 0.5 }), 0.2);
  }
}

/// What is clamped to the least value is level there.
TEST(NeededCones, AreJudgedByTheSpacingAndNotByTheValues)
{
  const TriangulatedSource source = MakeTriangulation(40, AroundTheMiddle(2.0 * Gradation));
  EXPECT_FALSE(NeededOf(source).empty());
  EXPECT_TRUE(NeededOf(source, { 1.0, 0.0, 0.01 }).empty());
}

// Of this triangle no side is steep, but its gradient is.
TEST(NeededCones, AreThoseOfSidesWhereTheLargestValueCutsTheTriangle)
{
  TriangulatedSource source;
  source.Points = { { 0.0, 0.0 }, { 0.2, 0.2 }, { 0.2, -0.2 } };
  source.Values = { 0.02, 0.1, 0.1 };
  source.Triangles = { 0, 1, 2 };
  const ValueRange range{ 1.0, 0.0, 0.05 };
  const std::vector<LowEdge> needed = NeededOf(source, range);
  ASSERT_FALSE(needed.empty());
  const SegmentExtension limit = LimitOf(needed);
  EXPECT_NEAR(limit({ 0.07, 0.0 }), 0.02 + Gradation * 0.07, 1e-12); // 0.048 is given
}
