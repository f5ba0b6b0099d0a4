// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/NearVertices.h"

#include <gtest/gtest.h>

#include <algorithm> // for includes, min, minmax
#include <numeric>   // for iota
#include <random>    // for places
#include <set>       // for pairs

namespace biting
{

namespace
{

std::set<std::pair<Id, Id>> Ordered(const std::vector<std::pair<Id, Id>>& pairs)
{
  std::set<std::pair<Id, Id>> ordered;
  for (const auto& [one, other] : pairs)
  {
    ordered.insert(std::minmax(one, other));
  }
  return ordered;
}

/// Of each vertex, the least one that pairs connect it with.
std::vector<Id> LeastOf(std::size_t count, const std::set<std::pair<Id, Id>>& pairs)
{
  std::vector<Id> least(count);
  std::iota(least.begin(), least.end(), 0);
  for (bool isOver = false; !isOver;)
  {
    isOver = true;
    for (const auto& [one, other] : pairs)
    {
      const Id both = std::min(least[one], least[other]);
      isOver = isOver && least[one] == both && least[other] == both;
      least[one] = both;
      least[other] = both;
    }
  }
  return least;
}

} // namespace

TEST(NearVertices, AreThoseThatAllPairsTell)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  for (const double nearest : { 0.0, 0.01, 0.2, 1e300 })
  {
    std::vector<Point2> points;
    std::vector<Id> vertices;
    std::set<std::pair<Id, Id>> wanted;
    for (Id vertex = 0; vertex < 300; ++vertex)
    {
      const bool isAgain = vertex > 0 && random() % 4 == 0;
      points.push_back(
        isAgain ? points[random() % points.size()] : Point2{ place(random), place(random) });
      vertices.push_back(vertex);
      for (Id other = 0; other < vertex; ++other)
      {
        if (Distance(points[other], points[vertex]) <= nearest)
        {
          wanted.insert({ other, vertex });
        }
      }
    }
    EXPECT_FALSE(wanted.empty());
    const std::set<std::pair<Id, Id>> found = Ordered(FindNearVertices(points, vertices, nearest));
    EXPECT_TRUE(std::includes(wanted.begin(), wanted.end(), found.begin(), found.end()));
    EXPECT_EQ(LeastOf(points.size(), found), LeastOf(points.size(), wanted));
  }
}

TEST(NearVertices, OnOneLineAreFound)
{
  // All x are the same, as on an upright side; 10^5 would take minutes if all pairs were compared.
  std::vector<Point2> points;
  std::vector<Id> vertices;
  for (Id vertex = 0; vertex < 100000; ++vertex)
  {
    points.push_back({ 1.0, static_cast<double>(vertex) });
    vertices.push_back(vertex);
  }
  points[70000].Y = 69999.1;
  vertices.push_back(5); // twice the same is no pair
  EXPECT_EQ(Ordered(FindNearVertices(points, vertices, 0.25)),
    (std::set<std::pair<Id, Id>>{ { 69999, 70000 } }));
}

TEST(NearVertices, OfManyAtOnePlaceThereAreFewPairs)
{
  // As in a fan of triangles with points of their own.
  const std::vector<Point2> points(1000, Point2{ 1.0, 2.0 });
  std::vector<Id> vertices(points.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  for (const double nearest : { 0.0, 1e-16, 1.0 })
  {
    const std::vector<std::pair<Id, Id>> pairs = FindNearVertices(points, vertices, nearest);
    EXPECT_LT(pairs.size(), 2 * points.size());
    EXPECT_EQ(Ordered(pairs).size(), points.size() - 1);
  }
}

} // namespace biting
