// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/BorderTree.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

std::vector<BorderEdge> ScatteredEdges(int count)
{
  Sampler sampler(1);
  std::vector<BorderEdge> edges;
  for (int edge = 0; edge < count; ++edge)
  {
    const Point2 start = sampler.NextIn(UnitBox());
    edges.push_back({ start, start + 0.1 * sampler.NextIn(UnitBox()), sampler.Next(),
      sampler.Next(), 2 * edge, 2 * edge + 1 });
  }
  return edges;
}

/// Spokes of a hub with short edges at their ends.
std::vector<BorderEdge> Hub(int spokes)
{
  std::vector<BorderEdge> edges;
  const auto placeAt = [spokes](double spoke)
  {
    const double angle = 6.283185307179586 * spoke / spokes;
    return Point2{ 0.5 + 0.45 * std::cos(angle), 0.5 + 0.45 * std::sin(angle) };
  };
  for (int spoke = 0; spoke < spokes; ++spoke)
  {
    edges.push_back({ { 0.5, 0.5 }, placeAt(spoke), 0.0, 1.0 * spoke, spokes, spoke });
    if (spoke % 2 == 0)
    {
      edges.push_back(
        { placeAt(spoke), placeAt(spoke + 1), 1.0 * spoke, 1.0 + spoke, spoke, spoke + 1 });
    }
  }
  return edges;
}

/// Some of the spokes are short.
std::vector<BorderEdge> RaggedHub(int spokes)
{
  std::vector<BorderEdge> edges = Hub(spokes);
  Sampler sampler(6);
  for (BorderEdge& edge : edges)
  {
    edge.End = edge.Start + (0.3 + 0.7 * sampler.Next()) * (edge.End - edge.Start);
  }
  return edges;
}

/// One beside the other, slanted, and not all of one length.
std::vector<BorderEdge> Stripes(int count)
{
  std::vector<BorderEdge> edges;
  Sampler sampler(7);
  for (int k = 0; k < count; ++k)
  {
    const Point2 start{ 0.1 + 0.2 * sampler.Next(), 0.5 * k / count };
    edges.push_back({ start, start + (0.3 + 0.3 * sampler.Next()) * Point2{ 1.0, 0.8 }, 0.0, 1.0,
      2 * k, 2 * k + 1 });
  }
  return edges;
}

/// Of random places.
double MeanLooks(const BorderTree& tree)
{
  constexpr int Probes = 1000;
  int looks = 0;
  Sampler sampler(4);
  for (int probe = 0; probe < Probes; ++probe)
  {
    const Point2 x = sampler.NextIn(UnitBox());
    tree.Search(x, Infinity,
      [&x, &looks](const BorderEdge& edge, double limit)
      {
        ++looks;
        return std::min(limit, NearestOnEdge(edge, x).Distance);
      });
  }
  return static_cast<double>(looks) / Probes;
}

/// Where edges share ends, rounding may tell which of them is nearer.
void ExpectNearest(const std::vector<BorderEdge>& edges, double rounding = 0.0)
{
  Pulse pulse(NoMonitor());
  const BorderTree tree(edges, pulse);
  Sampler sampler(2);
  for (int probe = 0; probe < 1000; ++probe)
  {
    const Point2 x = sampler.NextIn({ { -1.0, -1.0 }, { 2.0, 2.0 } });
    NearestValue nearest{ std::numeric_limits<double>::infinity(), 0.0 };
    for (const BorderEdge& edge : edges)
    {
      const NearestValue found = NearestOnEdge(edge, x);
      nearest = found.Distance < nearest.Distance ? found : nearest;
    }
    const NearestValue found = tree.Nearest(x, { std::numeric_limits<double>::infinity(), 0.0 });
    EXPECT_NEAR(found.Distance, nearest.Distance, rounding);
    EXPECT_NEAR(found.Value, nearest.Value, rounding);
    EXPECT_EQ(NearestOnEdge(*found.Edge, x).Distance, found.Distance);
  }
}

} // namespace

TEST(BorderTree, FindsTheNearestOfAllEdges)
{
  ExpectNearest(ScatteredEdges(200));
}

TEST(BorderTree, FindsTheNearestOfEdgesOfVeryDifferentLengths)
{
  std::vector<BorderEdge> edges = ScatteredEdges(300);
  for (std::size_t k = 0; k < edges.size(); ++k)
  {
    const double factor = std::exp2(-static_cast<double>(k % 60));
    edges[k].End = edges[k].Start + factor * (edges[k].End - edges[k].Start);
  }
  ExpectNearest(edges);
}

TEST(BorderTree, FindsTheNearestOfEdgesThatMeetInAHub)
{
  ExpectNearest(Hub(100), 1e-12);
}

TEST(BorderTree, LooksAtFewEdgesHoweverManyMeetInAHub)
{
  Pulse pulse(NoMonitor());
  const double few = MeanLooks(BorderTree(Hub(200), pulse));
  const double many = MeanLooks(BorderTree(Hub(6400), pulse));
  EXPECT_LT(few, 20.0);
  EXPECT_LT(many, 3.0 * few);
}

TEST(BorderTree, LooksAtFewEdgesOfARaggedHub)
{
  Pulse pulse(NoMonitor());
  ExpectNearest(RaggedHub(100), 1e-12);
  const double few = MeanLooks(BorderTree(RaggedHub(200), pulse));
  const double many = MeanLooks(BorderTree(RaggedHub(6400), pulse));
  EXPECT_LT(few, 20.0);
  EXPECT_LT(many, 3.0 * few);
}

/// Their boxes all overlap.
TEST(BorderTree, LooksAtFewEdgesOfLongOnesBesideEachOther)
{
  Pulse pulse(NoMonitor());
  ExpectNearest(Stripes(100));
  const double few = MeanLooks(BorderTree(Stripes(200), pulse));
  const double many = MeanLooks(BorderTree(Stripes(6400), pulse));
  EXPECT_LT(few, 10.0);
  EXPECT_LT(many, 5.0 * few);
}

TEST(BorderTree, LeavesWhatIsKnownWhereNothingIsNearer)
{
  Pulse pulse(NoMonitor());
  const BorderTree tree(ScatteredEdges(20), pulse);
  const NearestValue known{ 1.0, 7.0, { 9.0, 9.0 } };
  EXPECT_EQ(tree.Nearest({ 10.0, 9.0 }, known).Value, 7.0);
  EXPECT_EQ(BorderTree().Nearest({ 10.0, 9.0 }, known).Value, 7.0);
}

TEST(BorderTree, HasTheValueOfThePlaceOnAnEdge)
{
  const BorderEdge edge{ { 0.0, 0.0 }, { 2.0, 0.0 }, 1.0, 3.0 };
  EXPECT_DOUBLE_EQ(NearestOnEdge(edge, { 0.5, 4.0 }).Value, 1.5);
  EXPECT_DOUBLE_EQ(NearestOnEdge(edge, { 0.5, 4.0 }).Distance, 4.0);
  EXPECT_DOUBLE_EQ(NearestOnEdge(edge, { 5.0, 4.0 }).Value, 3.0);
  EXPECT_DOUBLE_EQ(NearestOnEdge(edge, { 5.0, 4.0 }).Distance, 5.0);
  EXPECT_DOUBLE_EQ(
    NearestOnEdge({ { 1.0, 1.0 }, { 1.0, 1.0 }, 2.0, 2.0 }, { 4.0, 5.0 }).Value, 2.0);
}
