// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/NearVertices.h"

#include <gtest/gtest.h>

#include <algorithm> // for minmax
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
    EXPECT_EQ(Ordered(FindNearVertices(points, vertices, nearest)), wanted);
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

} // namespace biting
