// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PointFamilies.h"

#include <gtest/gtest.h>

#include <algorithm> // for min, max, next_permutation
#include <array>     // for quadruples
#include <cmath>     // for ldexp, nextafter, signbit
#include <limits>    // for infinity
#include <vector>    // for lists of cases

namespace
{

using namespace predicates_test;

// Helpers of the laws.

/// Parity of a permutation: +1 even, -1 odd.
template <std::size_t N>
int ParityOf(const std::array<std::size_t, N>& order)
{
  int parity = 1;
  for (std::size_t i = 0; i < N; ++i)
  {
    for (std::size_t j = i + 1; j < N; ++j)
    {
      parity = order[i] > order[j] ? -parity : parity;
    }
  }
  return parity;
}

/// The same two segments, given in the eight possible ways.
std::vector<Quadruple> WaysToGive(const Quadruple& q)
{
  const auto [a, b, c, d] = q;
  return { { a, b, c, d }, { b, a, c, d }, { a, b, d, c }, { b, a, d, c }, { c, d, a, b },
    { d, c, a, b }, { c, d, b, a }, { d, c, b, a } };
}

bool HasDistinctEnds(const Quadruple& q)
{
  return q[0] != q[1] && q[2] != q[3];
}

Meeting Meet(const Quadruple& q)
{
  return biting::Meet(q[0], q[1], q[2], q[3]);
}

Point2 CrossingPoint(const Quadruple& q)
{
  return biting::CrossingPoint(q[0], q[1], q[2], q[3]);
}

bool IsInBox(const Point2& p, const Point2& a, const Point2& b)
{
  return std::min(a.X, b.X) <= p.X && p.X <= std::max(a.X, b.X) && std::min(a.Y, b.Y) <= p.Y &&
    p.Y <= std::max(a.Y, b.Y);
}

bool IsSameToTheLastBit(const Point2& p, const Point2& q)
{
  return p == q && std::signbit(p.X) == std::signbit(q.X) && std::signbit(p.Y) == std::signbit(q.Y);
}

/// Two nearly parallel segments that cross: one is the other, its ends moved to opposite sides.
Quadruple ThinCross(Sampler& sampler)
{
  const Point2 a = sampler.UnitPoint();
  const Point2 b = sampler.UnitPoint();
  const Point2 shift = std::ldexp(sampler.Unit(), -30 - sampler.Below(25)) * Perpendicular(b - a);
  return { a, b, a + shift, b - shift };
}

/// A wide cross of one level segment and one upright one.
Quadruple UprightCross(Sampler& sampler)
{
  const Point2 p = sampler.UnitPoint();
  return { Point2{ p.X - sampler.Unit(), p.Y }, Point2{ p.X + sampler.Unit(), p.Y },
    Point2{ p.X, p.Y - sampler.Unit() }, Point2{ p.X, p.Y + sampler.Unit() } };
}

void ExpectGoodCrossing(const Quadruple& q)
{
  const Point2 p = CrossingPoint(q);
  const FractionPoint truth = TrueCrossing(q);
  EXPECT_TRUE(IsInBox(p, q[0], q[1]) && IsInBox(p, q[2], q[3]));
  EXPECT_TRUE(IsWithinOneUlp(p.X, truth.X));
  EXPECT_TRUE(IsWithinOneUlp(p.Y, truth.Y));
  for (const Quadruple& way : WaysToGive(q))
  {
    EXPECT_TRUE(IsSameToTheLastBit(CrossingPoint(way), p));
  }
}

} // namespace

TEST(Orient2D, KnowsLeftFromRight)
{
  EXPECT_EQ(biting::Orient2D({ 0, 0 }, { 1, 0 }, { 0, 1 }), 1);
  EXPECT_EQ(biting::Orient2D({ 0, 0 }, { 0, 1 }, { 1, 0 }), -1);
  EXPECT_EQ(biting::Orient2D({ 0, 0 }, { 1, 1 }, { 3, 3 }), 0);
}

TEST(Orient2D, AgreesWithExactIntegers)
{
  ForAllFamilies(1500,
    [](const Quadruple& q)
    {
      EXPECT_EQ(biting::Orient2D(q[0], q[1], q[2]), TrueOrient2D(q[0], q[1], q[2]));
      EXPECT_EQ(biting::Orient2D(q[3], q[1], q[2]), TrueOrient2D(q[3], q[1], q[2]));
    });
}

TEST(Orient2D, RotationKeepsAndExchangeNegates)
{
  ForAllFamilies(300,
    [](const Quadruple& q)
    {
      const int sign = biting::Orient2D(q[0], q[1], q[2]);
      std::array<std::size_t, 3> order{ 0, 1, 2 };
      do
      {
        EXPECT_EQ(biting::Orient2D(q[order[0]], q[order[1]], q[order[2]]), ParityOf(order) * sign);
      } while (std::next_permutation(order.begin(), order.end()));
    });
}

TEST(Orient2D, IsZeroForRepeatedPoints)
{
  ForAllFamilies(100,
    [](const Quadruple& q)
    {
      EXPECT_EQ(biting::Orient2D(q[0], q[1], q[1]), 0);
      EXPECT_EQ(biting::Orient2D(q[0], q[1], q[0]), 0);
      EXPECT_EQ(biting::Orient2D(q[0], q[0], q[0]), 0);
    });
}

TEST(Orient2D, SeesAStepOfOneUlp)
{
  const Point2 a{ 0.5, 0.5 };
  const Point2 b{ 12.0, 12.0 };
  const Point2 c{ 24.0, std::nextafter(24.0, 25.0) };
  EXPECT_EQ(biting::Orient2D(a, b, c), 1);
  EXPECT_EQ(biting::Orient2D(a, b, { c.Y, c.X }), -1);
}

TEST(InCircle, KnowsInsideFromOutside)
{
  EXPECT_EQ(biting::InCircle({ 0, 0 }, { 1, 0 }, { 0, 1 }, { 0.5, 0.5 }), 1);
  EXPECT_EQ(biting::InCircle({ 0, 0 }, { 1, 0 }, { 0, 1 }, { 2, 2 }), -1);
  EXPECT_EQ(biting::InCircle({ 0, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 }), 0);
}

TEST(InCircle, AgreesWithExactIntegers)
{
  ForAllFamilies(1500,
    [](const Quadruple& q)
    { EXPECT_EQ(biting::InCircle(q[0], q[1], q[2], q[3]), TrueInCircle(q[0], q[1], q[2], q[3])); });
}

TEST(InCircle, EvenPermutationsKeepAndOddOnesNegate)
{
  ForAllFamilies(100,
    [](const Quadruple& q)
    {
      const int sign = biting::InCircle(q[0], q[1], q[2], q[3]);
      std::array<std::size_t, 4> order{ 0, 1, 2, 3 };
      do
      {
        EXPECT_EQ(biting::InCircle(q[order[0]], q[order[1]], q[order[2]], q[order[3]]),
          ParityOf(order) * sign);
      } while (std::next_permutation(order.begin(), order.end()));
    });
}

TEST(InCircle, IsZeroForRepeatedPoints)
{
  ForAllFamilies(100,
    [](const Quadruple& q)
    {
      EXPECT_EQ(biting::InCircle(q[0], q[1], q[2], q[0]), 0);
      EXPECT_EQ(biting::InCircle(q[0], q[1], q[1], q[2]), 0);
    });
}

TEST(InCircle, IsZeroForRectangles)
{
  Sampler sampler;
  for (int i = 0; i < 1000; ++i)
  {
    const Quadruple q = FullBitRectangle(sampler);
    EXPECT_EQ(biting::InCircle(q[0], q[1], q[2], q[3]), 0);
  }
}

TEST(InCircle, SeesAStepOfOneUlp)
{
  const double inward = std::nextafter(1.0, 0.0);
  const double outward = std::nextafter(1.0, 2.0);
  EXPECT_EQ(biting::InCircle({ 0, 0 }, { 1, 0 }, { 0, 1 }, { inward, 1 }), 1);
  EXPECT_EQ(biting::InCircle({ 0, 0 }, { 1, 0 }, { 0, 1 }, { outward, 1 }), -1);
}

TEST(Meet, AnswersEveryCase)
{
  struct Case
  {
    Quadruple Segments;
    Meeting Expected;
  };
  const Point2 a{ 0, 0 };
  const Point2 b{ 4, 2 };
  const Case cases[] = {
    { { a, b, { 0, 2 }, { 4, 0 } }, Meeting::Crossing },
    { { a, b, { 0, 2 }, { 2, 1 } }, Meeting::Touch },     // an end of cd inside ab
    { { a, b, { -1, 1 }, { 1, -1 } }, Meeting::Touch },   // an end of ab inside cd
    { { a, b, b, { 5, 0 } }, Meeting::Endpoint },         // with an angle
    { { a, b, b, { 8, 4 } }, Meeting::Endpoint },         // straight on
    { { a, b, { 2, 1 }, { 8, 4 } }, Meeting::Overlap },   // in part
    { { a, b, { 2, 1 }, { 3, 1.5 } }, Meeting::Overlap }, // cd inside ab
    { { a, b, { -2, -1 }, { 6, 3 } }, Meeting::Overlap }, // ab inside cd
    { { a, b, a, { 2, 1 } }, Meeting::Overlap },          // from one end
    { { a, b, a, b }, Meeting::Overlap },                 // equal
    { { a, b, { 6, 3 }, { 8, 4 } }, Meeting::None },      // on the same line
    { { a, b, { 0, 1 }, { 4, 3 } }, Meeting::None },      // parallel
    { { a, b, { 6, 0 }, { 6, 9 } }, Meeting::None },      // cd crosses the line of ab
    { { a, b, { 1, 2 }, { 0, 4 } }, Meeting::None },      // ab crosses the line of cd
    { { a, b, { 6, 3 }, { 7, 0 } }, Meeting::None },      // an end of cd on the line of ab
    { { Point2{ 1, 0 }, { 1, 4 }, { 1, 3 }, { 1, 9 } }, Meeting::Overlap }, // upright
    { { Point2{ 1, 0 }, { 1, 4 }, { 1, 5 }, { 1, 9 } }, Meeting::None },
    { { Point2{ 1, 0 }, { 1, 4 }, { 1, 4 }, { 1, 9 } }, Meeting::Endpoint },
  };
  for (const Case& each : cases)
  {
    SCOPED_TRACE(&each - cases);
    for (const Quadruple& way : WaysToGive(each.Segments))
    {
      EXPECT_EQ(Meet(way), each.Expected);
    }
  }
}

TEST(Meet, AgreesWithExactFractions)
{
  ForAllFamilies(400,
    [](const Quadruple& q)
    {
      if (HasDistinctEnds(q))
      {
        EXPECT_EQ(Meet(q), TrueMeet(q));
      }
    });
}

TEST(Meet, ForgetsTheOrderInWhichSegmentsAreGiven)
{
  ForAllFamilies(200,
    [](const Quadruple& q)
    {
      if (HasDistinctEnds(q))
      {
        for (const Quadruple& way : WaysToGive(q))
        {
          EXPECT_EQ(Meet(way), Meet(q));
        }
      }
    });
}

TEST(IsOnSegment, HoldsForEndsAndExactMiddlesOnly)
{
  const Point2 a{ 0, 0 };
  const Point2 b{ 4, 2 };
  EXPECT_TRUE(biting::IsOnSegment(a, a, b));
  EXPECT_TRUE(biting::IsOnSegment(b, a, b));
  EXPECT_TRUE(biting::IsOnSegment({ 2, 1 }, a, b));
  EXPECT_FALSE(biting::IsOnSegment({ 2, std::nextafter(1.0, 2.0) }, a, b));
  EXPECT_FALSE(biting::IsOnSegment({ 6, 3 }, a, b));
  EXPECT_FALSE(biting::IsOnSegment({ -2, -1 }, a, b));
}

TEST(IsOnSegment, HoldsForTheOnlyPointOfAnEmptySegment)
{
  EXPECT_TRUE(biting::IsOnSegment({ 1, 2 }, { 1, 2 }, { 1, 2 }));
  EXPECT_FALSE(biting::IsOnSegment({ 1, 3 }, { 1, 2 }, { 1, 2 }));
}

TEST(IsOnSegment, AgreesWithMeet)
{
  ForAllFamilies(300,
    [](const Quadruple& q)
    {
      if (HasDistinctEnds(q) && Meet(q) == Meeting::None)
      {
        EXPECT_FALSE(biting::IsOnSegment(q[2], q[0], q[1]));
        EXPECT_FALSE(biting::IsOnSegment(q[3], q[0], q[1]));
      }
      if (HasDistinctEnds(q) && Meet(q) == Meeting::Touch)
      {
        EXPECT_TRUE(biting::IsOnSegment(q[0], q[2], q[3]) ||
          biting::IsOnSegment(q[1], q[2], q[3]) || biting::IsOnSegment(q[2], q[0], q[1]) ||
          biting::IsOnSegment(q[3], q[0], q[1]));
      }
    });
}

TEST(CrossingPoint, IsExactWhereItCanBe)
{
  const Point2 p = biting::CrossingPoint({ -1, -1 }, { 3, 3 }, { 0, 2 }, { 2, 0 });
  EXPECT_EQ(p.X, 1.0);
  EXPECT_EQ(p.Y, 1.0);
}

TEST(CrossingPoint, IsWithinAnUlpInBothBoxesAndSymmetric)
{
  ForAllFamilies(400,
    [](const Quadruple& q)
    {
      if (HasDistinctEnds(q) && Meet(q) == Meeting::Crossing)
      {
        ExpectGoodCrossing(q);
      }
    });
}

TEST(CrossingPoint, IsGoodForThinCrosses)
{
  Sampler sampler;
  int crossings = 0;
  for (int i = 0; i < 1000 && !HasFailure(); ++i)
  {
    const Quadruple q = ThinCross(sampler);
    if (HasDistinctEnds(q) && Meet(q) == Meeting::Crossing)
    {
      ExpectGoodCrossing(q);
      ++crossings;
    }
  }
  EXPECT_GT(crossings, 500);
}

TEST(CrossingPoint, HasNoNegativeZeros)
{
  const Quadruple throughOrigin[] = {
    { Point2{ -1, -1 }, { 1, 1 }, { -1, 1 }, { 1, -1 } },
    { Point2{ -1, -3 }, { 1, 3 }, { -1, -1 }, { 1, 1 } },
    { Point2{ -1, -0.0 }, { 1, -0.0 }, { -0.0, -1 }, { -0.0, 1 } },
    { Point2{ -1, -0.0 }, { 1, 0.0 }, { 0.0, -1 }, { -0.0, 1 } },
  };
  for (const Quadruple& q : throughOrigin)
  {
    for (const Quadruple& way : WaysToGive(q))
    {
      EXPECT_TRUE(IsSameToTheLastBit(CrossingPoint(way), Point2{ 0.0, 0.0 }));
    }
  }
}

TEST(CrossingPoint, StaysOnLevelAndUprightSegments)
{
  Sampler sampler;
  for (int i = 0; i < 1000; ++i)
  {
    const Quadruple q = UprightCross(sampler);
    EXPECT_EQ(CrossingPoint(q), (Point2{ q[2].X, q[0].Y }));
  }
}

TEST(Predicates, SurviveWhatIsNotFinite)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : { infinity, nan, std::numeric_limits<double>::max() })
  {
    biting::Orient2D({ bad, 0 }, { 1, bad }, { 0, 1 });
    biting::InCircle({ bad, 0 }, { 1, bad }, { 0, 1 }, { 1, 1 });
  }
}

#ifdef BITING_COUNT_PREDICATES
TEST(Predicates, AnswerOrdinaryCallsInTheFirstStage)
{
  constexpr int Count = 20000;
  Sampler sampler;
  const biting::PredicateCounts before = biting::GetPredicateCounts();
  for (int i = 0; i < Count; ++i)
  {
    const Quadruple q = OrdinaryPoints(sampler);
    biting::Orient2D(q[0], q[1], q[2]);
    biting::InCircle(q[0], q[1], q[2], q[3]);
  }
  const biting::PredicateCounts after = biting::GetPredicateCounts();
  EXPECT_EQ(after.Calls - before.Calls, 2 * Count);
  EXPECT_LT(1000 * (after.Widened - before.Widened), 2 * Count);
  EXPECT_EQ(after.Exact, before.Exact);
}

TEST(Predicates, AnswerNearlyCocircularCallsWithoutExpansions)
{
  constexpr int Count = 5000;
  Sampler sampler;
  const biting::PredicateCounts before = biting::GetPredicateCounts();
  for (int i = 0; i < Count; ++i)
  {
    const Quadruple q = NearlyCocircularPoints(sampler);
    biting::InCircle(q[0], q[1], q[2], q[3]);
  }
  const biting::PredicateCounts after = biting::GetPredicateCounts();
  EXPECT_GT(20 * (after.Widened - before.Widened), Count);
  EXPECT_LT(1000 * (after.Exact - before.Exact), Count);
}

TEST(InCircle, IsZeroForMirroredPairsWithoutExpansions)
{
  Sampler sampler;
  const biting::PredicateCounts before = biting::GetPredicateCounts();
  for (int i = 0; i < 1000; ++i)
  {
    const Quadruple q = MirroredPairs(sampler);
    EXPECT_EQ(biting::InCircle(q[0], q[1], q[2], q[3]), 0);
    EXPECT_EQ(biting::InCircle(q[0], q[3], q[1], q[2]), 0);
    EXPECT_EQ(biting::InCircle(q[2], q[0], q[1], q[3]), 0);
  }
  EXPECT_EQ(biting::GetPredicateCounts().Exact, before.Exact);
}
#endif
