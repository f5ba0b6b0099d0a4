// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/KeptVertices.h"
#include "../Support/MeshShapes.h"
#include "../Support/PolylineShapes.h"
#include "../Support/RemeshLaws.h"
#include "BitingMesh.h"

#include <gtest/gtest.h>

#include <algorithm> // for clamp, max
#include <cmath>     // for abs, exp, round, turns
#include <utility>   // for pairs

namespace biting
{

namespace
{

OldMesh UniformSquare(double spacing)
{
  BitingMeshOptions meshing;
  meshing.Spacing.Uniform = spacing;
  ProblemList problems;
  const BitingMesh mesh = MakeBitingMesh(
    PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Lines(), meshing, problems, NoMonitor());
  SilentMonitor monitor;
  return ReadOldMesh(RemeshInputOf(mesh, 1e-15), 0.0, problems, monitor);
}

/// Of the inner vertices of a mesh of a square, the share that is chosen where edges are to be so
/// many times shorter. With a slope f grows to the right about the middle, and is that there.
double ShareOfChosen(double ratio, double slope = 0.0, const KeepRules& rules = {})
{
  const OldMesh old = UniformSquare(0.05);
  std::vector<double> wanted;
  for (const Point2& point : old.Points)
  {
    const double distance = std::clamp(point.X - 0.5, -0.1, 0.1);
    wanted.push_back(0.05 / ratio + slope * distance);
  }
  const ChangedRegion region = WholeRegion(old, MeanLengths(old, wanted));
  const RegionEdges edges = ThinnedEdges(old, region, wanted, rules, EdgePolicy::Free);
  const std::vector<std::uint8_t> isKept = ChooseKeptVertices(old, region, edges, wanted, rules);
  double inner = 0.0;
  double chosen = 0.0;
  for (Id vertex = 0; vertex < region.NumberOfVertices(); ++vertex)
  {
    const Id point = region.Vertices[vertex];
    const Point2& place = old.Points[point];
    const double half = slope > 0.0 ? 0.05 : 0.4;
    const bool isInner = std::abs(place.X - 0.5) < half && std::abs(place.Y - 0.5) < 0.4;
    inner += isInner ? 1.0 : 0.0;
    chosen += isInner && isKept[vertex] != 0 ? 1.0 : 0.0;
  }
  EXPECT_GT(inner, 30.0);
  return chosen / inner;
}

TEST(KeptVertices, AreAllThatFit)
{
  EXPECT_EQ(ShareOfChosen(1.0), 1.0);
  EXPECT_GT(ShareOfChosen(1.35), 0.75); // lengths differ: the mean of those of a few is above 1.4
}

TEST(KeptVertices, AreAllWhereOthersFitBetweenThem)
{
  EXPECT_EQ(ShareOfChosen(2.0), 1.0);
}

TEST(KeptVertices, AreFewThatLieTooWideForFAndTooCloseForOthers)
{
  EXPECT_LT(ShareOfChosen(1.5), 0.25);
}

// Of a lattice whose edges are half as long as f one of four; fewer where lattices meet.
TEST(KeptVertices, AreACoarserLatticeWhereThereAreTooMany)
{
  EXPECT_NEAR(ShareOfChosen(0.5), 0.25, 0.07);
}

TEST(KeptVertices, AreNoneOfALatticeOfAnotherSizeWhereFIsSteep)
{
  EXPECT_EQ(ShareOfChosen(2.0, 0.2), 0.0);
  EXPECT_EQ(ShareOfChosen(0.5, 0.3), 0.0);
}

TEST(KeptVertices, AreAllWhereFIsNearlyLevelOrTheyFit)
{
  EXPECT_EQ(ShareOfChosen(2.0, 0.05), 1.0);
  EXPECT_GT(ShareOfChosen(0.5, 0.05), 0.18);
  EXPECT_GT(ShareOfChosen(1.0, 0.2), 0.95);
}

/// The inner vertices that are chosen where f is half of what the mesh was made for, which grows by
/// a factor of exp(growth) for each unit of the square that it was (the exponential function is
/// conformal: it keeps the shapes).
double ShareOfChosenOfGraded(double growth)
{
  OldMesh old = UniformSquare(0.05);
  std::vector<double> wanted;
  for (Point2& point : old.Points)
  {
    const double scale = std::exp(growth * point.X);
    wanted.push_back(0.5 * 0.05 * growth * scale);
    point = { scale * std::cos(growth * point.Y), scale * std::sin(growth * point.Y) };
  }
  const ChangedRegion region = WholeRegion(old, MeanLengths(old, wanted));
  const RegionEdges edges = ThinnedEdges(old, region, wanted, {}, EdgePolicy::Free);
  const std::vector<std::uint8_t> isKept = ChooseKeptVertices(old, region, edges, wanted, {});
  double inner = 0.0;
  double chosen = 0.0;
  for (Id vertex = 0; vertex < region.NumberOfVertices(); ++vertex)
  {
    const bool isInner = !edges.IsKept[vertex] && !edges.IsGone[vertex];
    inner += isInner ? 1.0 : 0.0;
    chosen += isInner && isKept[vertex] != 0 ? 1.0 : 0.0;
  }
  return chosen / inner;
}

TEST(KeptVertices, AreAllWhereTheirEdgesMayBeDividedHoweverSteepFIs)
{
  EXPECT_GT(ShareOfChosenOfGraded(6.0), 0.99);
}

TEST(KeptVertices, AreKeptWhereFIsSteepIfThatIsPreferred)
{
  EXPECT_EQ(ShareOfChosen(2.0, 0.2, RulesFor(RemeshPreference::Keeping)), 1.0);
}

/// How many of the old vertices within a strip are chosen, where they fit; beside it none does.
Id NumberInStrip(double width, const KeepRules& rules)
{
  const OldMesh old = UniformSquare(0.02);
  std::vector<double> wanted;
  for (const Point2& point : old.Points)
  {
    wanted.push_back(0.02 / (std::abs(point.X - 0.5) < 0.5 * width ? 1.25 : 1.5));
  }
  const ChangedRegion region = WholeRegion(old, MeanLengths(old, wanted));
  const RegionEdges edges = ThinnedEdges(old, region, wanted, rules, EdgePolicy::Free);
  const std::vector<std::uint8_t> isKept = ChooseKeptVertices(old, region, edges, wanted, rules);
  Id count = 0;
  for (Id vertex = 0; vertex < region.NumberOfVertices(); ++vertex)
  {
    const Point2& place = old.Points[region.Vertices[vertex]];
    count += std::abs(place.X - 0.5) < 0.5 * width && std::abs(place.Y - 0.5) < 0.45 &&
      isKept[vertex] != 0;
  }
  return count;
}

TEST(KeptVertices, AreNoNarrowStripsBetweenOthersThatGo)
{
  KeepRules always;
  always.GreatestShareInTheWay = 2.0;
  EXPECT_GT(NumberInStrip(0.02, always), 20);
  EXPECT_LT(NumberInStrip(0.02, {}), NumberInStrip(0.02, always) / 4);
  EXPECT_GT(NumberInStrip(0.3, {}), 3 * NumberInStrip(0.3, always) / 4);
}

/// On the lower side of the square: how many stay, and how far they are at most from the ends of so
/// many equal parts, in parts.
std::pair<Id, double> CountOnSide(double parts, const KeepRules& rules)
{
  const OldMesh old = UniformSquare(0.05);
  const std::vector<double> wanted(old.Points.size(), 1.0 / parts);
  const ChangedRegion region = WholeRegion(old, MeanLengths(old, wanted));
  const RegionEdges edges = ThinnedEdges(old, region, wanted, rules, EdgePolicy::Free);
  std::pair<Id, double> result;
  for (Id vertex = 0; vertex < region.NumberOfVertices(); ++vertex)
  {
    const Point2& place = old.Points[region.Vertices[vertex]];
    if (place.Y == 0.0 && edges.IsKept[vertex] != 0)
    {
      const double end = parts * place.X;
      result.second = std::max(result.second, std::abs(end - std::round(end)));
      ++result.first;
    }
  }
  return result;
}

TEST(KeptVertices, OnStraightEdgesAreNearTheEndsOfEqualParts)
{
  const auto [count, farthest] = CountOnSide(13.0, {});
  EXPECT_GT(count, 2);
  EXPECT_LT(count, 14);
  EXPECT_LE(farthest, KeepRules().GreatestShift);
}

TEST(KeptVertices, OnStraightEdgesAreOneForEachPartIfKeepingIsPreferred)
{
  EXPECT_EQ(CountOnSide(13.0, RulesFor(RemeshPreference::Keeping)).first, 14);
}

} // namespace

} // namespace biting
