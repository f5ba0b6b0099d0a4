// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Quality/NearestQueries.h"

#include <gtest/gtest.h>

#include <algorithm> // for min
#include <random>    // for places

namespace biting
{

TEST(NearestQueries, AreAnsweredAsByAllPairsButForTheirOwnVertex)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(0.0, 1.0);
  std::vector<Point2> points(500);
  for (Point2& point : points)
  {
    point = { coordinate(random), coordinate(random) };
  }
  std::vector<NearestQuery> queries;
  for (Id k = 0; k < 400; ++k)
  {
    const bool isVertex = k % 2 == 0;
    const Point2 place =
      isVertex ? points[static_cast<std::size_t>(k)] : Point2{ coordinate(random), 0.5 };
    queries.push_back({ place, 0.1 * coordinate(random), isVertex ? k : Id{ NoId } });
  }
  const std::vector<double> answers = NearestDistances(points, queries);
  for (std::size_t k = 0; k < queries.size(); ++k)
  {
    double least = queries[k].Distance;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const bool isOwn = static_cast<Id>(i) == queries[k].Vertex;
      least = isOwn ? least : std::min(least, Distance(points[i], queries[k].Place));
    }
    EXPECT_EQ(answers[k], least);
  }
}

TEST(NearestQueries, KnowNothingNewWithoutPoints)
{
  EXPECT_EQ(NearestDistances({}, { { { 0.0, 0.0 }, 2.5, NoId } }), std::vector<double>{ 2.5 });
}

} // namespace biting
