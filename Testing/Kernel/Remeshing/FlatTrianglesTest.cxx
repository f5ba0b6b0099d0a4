// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/FlatTriangles.h"
#include "Predicates/Predicates.h"
#include "Remeshing/OldMesh.h"

#include <gtest/gtest.h>

#include <random> // for places

namespace biting
{

namespace
{

double AreaOf(const std::vector<Point2>& points, const std::vector<Id>& corners)
{
  double area = 0.0;
  for (std::size_t k = 0; k < corners.size(); k += 3)
  {
    const Point2& a = points[corners[k]];
    area += 0.5 * std::abs(Cross(points[corners[k + 1]] - a, points[corners[k + 2]] - a));
  }
  return area;
}

/// Whether they form a mesh, and cover what `before` did.
void ExpectMesh(
  const std::vector<Point2>& points, const std::vector<Id>& corners, const std::vector<Id>& before)
{
  RemeshInput input;
  input.Points = points;
  input.Corners = corners;
  ProblemList problems;
  EXPECT_FALSE(ReadOldMesh(input, 0.0, problems, NoMonitor()).Corners.empty());
  EXPECT_NEAR(AreaOf(points, corners), AreaOf(points, before), 1e-12 * AreaOf(points, before));
}

} // namespace

// Each has the longest side of the one above it.
TEST(FlatTriangles, GoInTurnHoweverManyLieUponEachOther)
{
  constexpr Id Count = 300;
  std::vector<Point2> points{ { 0, 0 }, { 1000, 0 }, { 400, 500 }, { 400, -500 } };
  std::vector<Id> corners{ 0, 1, 2 };
  Id start = 0;
  Id end = 1;
  for (Id k = 0; k < Count; ++k)
  {
    const bool isAtStart = k % 2 == 0;
    const Id next = static_cast<Id>(points.size());
    points.push_back({ isAtStart ? 1.0 + k : 1000.0 - k, 0.0 });
    corners.insert(corners.end(), { start, end, next });
    corners.insert(
      corners.end(), { isAtStart ? start : next, isAtStart ? next : end, 3 }); // below it
    (isAtStart ? start : end) = next;
  }
  corners.insert(corners.end(), { start, end, 3 });
  const std::vector<Id> before = corners;
  const FlatTriangleRepair repair = RepairFlatTriangles(points, 0.0, corners);
  EXPECT_EQ(repair.Flat.size(), static_cast<std::size_t>(Count));
  ExpectMesh(points, corners, before);
}

// The same triangles come back after each few rounds.
TEST(FlatTriangles, ThatDivideEachOtherForEverAreLeft)
{
  const std::vector<Point2> points{ { 0.10508746646614335, 1e-17 }, { 0.29170115382410439, -0.5 },
    { 0.98202217787373547, 0 }, { 0.83575632126498189, 0 }, { 0.73832003412404668, 2e-17 },
    { 0.27779703955381851, 0 }, { 0.67300603548551508, 0 }, { 0.62841580668094676, 0 } };
  std::vector<Id> corners{ 6, 0, 1, 0, 6, 3, 3, 5, 2, 5, 3, 4, 3, 2, 0, 4, 2, 5, 4, 1, 2, 7, 4, 3,
    6, 7, 3, 4, 7, 6, 1, 4, 6 };
  const FlatTriangleRepair repair = RepairFlatTriangles(points, 1e-15, corners);
  EXPECT_EQ(repair.Flat.size(), 8U);
  EXPECT_LT(repair.Divided.size(), 1000U);
}

TEST(FlatTriangles, CornersAtOnePlaceBecomeOne)
{
  const std::vector<Point2> points{ { 0, 0 }, { 1, 0 }, { 2, 1 }, { 0, 1 }, { 1, 0 }, { 2, 0 } };
  const std::vector<Id> before{ 0, 1, 3, 4, 2, 3, 1, 4, 3, 4, 5, 2 };
  std::vector<Id> corners = before;
  const FlatTriangleRepair repair = RepairFlatTriangles(points, 0.0, corners);
  EXPECT_EQ(corners, (std::vector<Id>{ 0, 1, 3, 1, 2, 3, 1, 5, 2 }));
  EXPECT_EQ(repair.Welded, (std::vector<std::pair<Id, Id>>{ { 4, 1 } }));
  EXPECT_EQ(repair.IsNew, (std::vector<std::uint8_t>{ 0, 1, 1 }));
  ExpectMesh(points, corners, before);
}

TEST(FlatTriangles, AreThoseThatRoundingTurnedOver)
{
  // The middle vertex of one side lies beyond it.
  for (const double offset : { 1e-9, 1e-3 })
  {
    const std::vector<Point2> points{ { 0, 0 }, { 2, 0 }, { 1, 1 }, { 1, -1 }, { 1, offset } };
    const std::vector<Id> before{ 0, 1, 2, 0, 4, 1, 0, 3, 4, 3, 1, 4 };
    std::vector<Id> corners = before;
    const FlatTriangleRepair repair = RepairFlatTriangles(points, 1e-6, corners);
    EXPECT_EQ(repair.Flat.size(), offset < 1e-6 ? 1u : 0u);
    EXPECT_EQ(corners == before, offset > 1e-6);
  }
}

TEST(FlatTriangles, AreFoundWhateverTheOrientationsAre)
{
  const std::vector<Point2> points{ { 0, 0 }, { 2, 0 }, { 1, 1 }, { 1, -1 }, { 1, 1e-9 } };
  for (unsigned turned = 0; turned < 16; ++turned)
  {
    std::vector<Id> before{ 0, 4, 2, 4, 1, 2, 0, 4, 1, 0, 3, 1 }; // the third one is flat, and fits
    std::vector<Id> over{ 0, 1, 2, 0, 4, 1, 0, 3, 4, 3, 1, 4 }; // the second one lies on the first
    for (std::size_t triangle = 0; triangle < 4; ++triangle)
    {
      if ((turned >> triangle) % 2 == 1)
      {
        std::swap(before[3 * triangle], before[3 * triangle + 1]);
        std::swap(over[3 * triangle], over[3 * triangle + 1]);
      }
    }
    EXPECT_TRUE(RepairFlatTriangles(points, 1e-6, before).Flat.empty()) << turned;
    const FlatTriangleRepair repair = RepairFlatTriangles(points, 1e-6, over);
    ASSERT_EQ(repair.Flat.size(), 1u) << turned;
    EXPECT_EQ(repair.Flat[0].Triangle, 1);
    EXPECT_EQ(repair.IsNew, (std::vector<std::uint8_t>{ 1, 1, 0, 0 }));
  }
}

// Vertices of a strip are put on lines by chance, as many at one place as may be.
TEST(FlatTriangles, OfAnyStripLeaveAMeshOrAreLeft)
{
  std::mt19937 random(7);
  for (int repetition = 0; repetition < 400; ++repetition)
  {
    std::vector<Point2> points{ { 0, 0 }, { 20, 0 }, { 10, 9 }, { 10, -9 } };
    std::vector<Id> above{ 0 };
    std::vector<Id> below{ 0 };
    for (Id place = 1; place < 20; ++place)
    {
      for (std::vector<Id>* line : { &above, &below })
      {
        if (random() % 3 == 0)
        {
          line->push_back(static_cast<Id>(points.size()));
          points.push_back({ static_cast<double>(place), 0.0 });
        }
      }
    }
    above.push_back(1);
    below.push_back(1);
    std::vector<Id> corners;
    for (std::size_t k = 1; k < above.size(); ++k)
    {
      corners.insert(corners.end(), { above[k - 1], above[k], 2 });
    }
    for (std::size_t k = 1; k < below.size(); ++k)
    {
      corners.insert(corners.end(), { below[k], below[k - 1], 3 });
    }
    // What is between both lines has no area.
    std::size_t up = 0;
    std::size_t down = 0;
    while (up + 1 < above.size() || down + 1 < below.size())
    {
      const bool isUp = down + 1 == below.size() || (up + 1 < above.size() && random() % 2 == 0);
      const Id next = isUp ? above[up + 1] : below[down + 1];
      if (next != above[up] && next != below[down] && above[up] != below[down])
      {
        corners.insert(corners.end(), { above[up], below[down], next });
      }
      ++(isUp ? up : down);
    }
    const std::vector<Id> before = corners;
    const FlatTriangleRepair repair = RepairFlatTriangles(points, 0.0, corners);
    ExpectMesh(points, corners, before);
    EXPECT_EQ(3 * repair.Origins.size(), repair.Origins.empty() ? 0 : corners.size());
  }
}

} // namespace biting
