// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PointFamilies3.h"

#include <gtest/gtest.h>

#include <algorithm> // for max, next_permutation
#include <array>     // for permutations
#include <cmath>     // for isfinite, sqrt
#include <cstdlib>   // for the wanted number of cases
#include <limits>    // for infinity

namespace
{

using namespace predicates_test;

/// Cases of each family; BITING_PREDICATE_CASES asks for more.
int CasesOfFamily()
{
  const char* wanted = std::getenv("BITING_PREDICATE_CASES");
  return wanted ? std::atoi(wanted) : 600;
}

template <std::size_t N>
int SignOf(const std::array<std::size_t, N>& order)
{
  int sign = 1;
  for (std::size_t i = 0; i < N; ++i)
  {
    for (std::size_t j = i + 1; j < N; ++j)
    {
      sign = order[i] > order[j] ? -sign : sign;
    }
  }
  return sign;
}

int InSphere(const Five& p)
{
  return biting::InSphere(p[0].Place, p[1].Place, p[2].Place, p[3].Place, p[4].Place);
}

int PowerTest(const Five& p)
{
  return biting::PowerTest(p[0], p[1], p[2], p[3], p[4]);
}

int Orient(const Five& p)
{
  return biting::Orient3D(p[0].Place, p[1].Place, p[2].Place, p[3].Place);
}

int Tie(const Five& p)
{
  return biting::TieInSphere(p[0].Place, p[1].Place, p[2].Place, p[3].Place, p[4].Place);
}

Five WithoutWeights(Five five)
{
  for (WeightedPoint& point : five)
  {
    point.Weight = 0.0;
  }
  return five;
}

Five Permuted(const Five& five, const std::array<std::size_t, 5>& order)
{
  Five permuted;
  for (std::size_t k = 0; k < 5; ++k)
  {
    permuted[k] = five[order[k]];
  }
  return permuted;
}

bool HasDistinctPlaces(const Five& five)
{
  bool isSo = true;
  for (std::size_t i = 0; i < 5; ++i)
  {
    for (std::size_t j = i + 1; j < 5; ++j)
    {
      isSo = isSo && five[i].Place != five[j].Place;
    }
  }
  return isSo;
}

} // namespace

TEST(Orient3D, IsPositiveForTetrahedraOfVtk)
{
  EXPECT_EQ(biting::Orient3D({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }), 1);
  EXPECT_EQ(biting::Orient3D({ 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, 1 }), -1);
  EXPECT_EQ(biting::Orient3D({ 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 3, 4, 0 }), 0);
}

TEST(Orient3D, AgreesWithExactIntegers)
{
  ForAllFives(CasesOfFamily(),
    [](const Five& p)
    { EXPECT_EQ(Orient(p), TrueOrient3D(p[0].Place, p[1].Place, p[2].Place, p[3].Place)); });
}

TEST(Orient3D, EvenPermutationsKeepAndOddOnesNegate)
{
  ForAllFives(40,
    [](const Five& p)
    {
      const int sign = Orient(p);
      std::array<std::size_t, 5> order{ 0, 1, 2, 3, 4 };
      do
      {
        EXPECT_EQ(Orient(Permuted(p, order)), SignOf(order) * sign);
      } while (std::next_permutation(order.begin(), order.begin() + 4));
    });
}

TEST(Orient3D, SeesAStepOfOneUlp)
{
  const double above = std::nextafter(24.0, 25.0);
  EXPECT_EQ(biting::Orient3D({ 0.5, 0.5, 0.5 }, { 12, 12, 13 }, { 13, 12, 12 }, { 24, 24, 24 }),
    biting::Orient3D({ 0, 0, 0 }, { 12, 12, 13 }, { 13, 12, 12 }, { 24, 24, 24 }));
  EXPECT_EQ(biting::Orient3D({ 0.5, 0.5, 0.5 }, { 12, 12, 12 }, { 7, 7, 0 }, { 24, 24, 24 }), 0);
  EXPECT_EQ(biting::Orient3D({ 0.5, 0.5, 0.5 }, { 12, 12, 12 }, { 7, 7, 0 }, { 24, above, 24 }),
    -biting::Orient3D({ 0.5, 0.5, 0.5 }, { 12, 12, 12 }, { 7, 7, 0 }, { above, 24, 24 }));
}

TEST(InSphere, KnowsInsideFromOutside)
{
  const Point3 a{ 0, 0, 0 };
  const Point3 b{ 1, 0, 0 };
  const Point3 c{ 0, 1, 0 };
  const Point3 d{ 0, 0, 1 };
  EXPECT_EQ(biting::InSphere(a, b, c, d, { 0.5, 0.5, 0.5 }), 1);
  EXPECT_EQ(biting::InSphere(a, b, c, d, { 2, 2, 2 }), -1);
  EXPECT_EQ(biting::InSphere(a, b, c, d, { 1, 1, 1 }), 0);
  const double inward = std::nextafter(1.0, 0.0);
  const double outward = std::nextafter(1.0, 2.0);
  EXPECT_EQ(biting::InSphere(a, b, c, d, { 1, 1, inward }), 1);
  EXPECT_EQ(biting::InSphere(a, b, c, d, { 1, outward, 1 }), -1);
}

TEST(InSphere, AgreesWithExactIntegers)
{
  ForAllFives(CasesOfFamily(),
    [](const Five& p) { EXPECT_EQ(InSphere(p), TruePowerTest(WithoutWeights(p))); });
}

TEST(InSphere, IsPowerTestWithoutWeights)
{
  ForAllFives(300, [](const Five& p) { EXPECT_EQ(InSphere(p), PowerTest(WithoutWeights(p))); });
}

TEST(InSphere, IsZeroForRepeatedPoints)
{
  ForAllFives(40,
    [](const Five& p)
    {
      EXPECT_EQ(InSphere({ p[0], p[1], p[2], p[3], p[0] }), 0);
      EXPECT_EQ(InSphere({ p[0], p[1], p[2], p[2], p[3] }), 0);
    });
}

TEST(PowerTest, AgreesWithExactIntegers)
{
  ForAllFives(CasesOfFamily(), [](const Five& p) { EXPECT_EQ(PowerTest(p), TruePowerTest(p)); });
}

TEST(PowerTest, EvenPermutationsKeepAndOddOnesNegate)
{
  ForAllFives(15,
    [](const Five& p)
    {
      const int sign = PowerTest(p);
      std::array<std::size_t, 5> order{ 0, 1, 2, 3, 4 };
      do
      {
        EXPECT_EQ(PowerTest(Permuted(p, order)), SignOf(order) * sign);
      } while (std::next_permutation(order.begin(), order.end()));
    });
}

TEST(PowerTest, HidesAPointBelowHeavyOnes)
{
  Five p{ WeightedPoint{ { 0, 0, 0 }, 1 }, { { 1, 0, 0 }, 1 }, { { 0, 1, 0 }, 1 },
    { { 0, 0, 1 }, 1 }, { { 0.25, 0.25, 0.25 }, 1 } };
  EXPECT_EQ(PowerTest(p), 1);
  p[4].Weight = 0;
  EXPECT_EQ(PowerTest(p), -1);
}

// Where the lifts are moved by so much that rounding does not matter, the tie is what it says.
TEST(TieInSphere, AnswersAsLoweredWeightsDo)
{
  Sampler sampler;
  int ties = 0;
  for (int i = 0; i < 3000 && !HasFailure(); ++i)
  {
    const Five p = WithoutWeights(LatticeFive(sampler));
    if (Orient(p) <= 0 || InSphere(p) != 0 || !HasDistinctPlaces(p))
    {
      continue;
    }
    Five lowered = p;
    for (WeightedPoint& point : lowered)
    {
      int rank = 0; // of the greatest point 0
      for (const WeightedPoint& other : p)
      {
        rank += point.Place < other.Place ? 1 : 0;
      }
      point.Weight = -std::ldexp(1.0, -40 * (rank + 1)); // a determinant is below 2^30
    }
    ++ties;
    EXPECT_EQ(Tie(p), TruePowerTest(lowered));
  }
  EXPECT_GT(ties, 100);
}

TEST(TieInSphere, PermutationsKeepOrNegate)
{
  Sampler sampler;
  int ties = 0;
  for (int i = 0; i < 3000 && !HasFailure(); ++i)
  {
    const Five p = WithoutWeights(i % 2 == 0 ? LatticeFive(sampler) : BoxFive(sampler));
    if (Orient(p) <= 0 || InSphere(p) != 0 || !HasDistinctPlaces(p))
    {
      continue;
    }
    const int sign = Tie(p);
    ++ties;
    EXPECT_NE(sign, 0);
    std::array<std::size_t, 5> order{ 0, 1, 2, 3, 4 };
    do
    {
      const Five q = Permuted(p, order);
      if (Orient(q) > 0)
      {
        EXPECT_EQ(Tie(q), SignOf(order) * sign);
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
  EXPECT_GT(ties, 100);
}

// Near-singular centres: those of nearly flat tetrahedra are right, however far away they are.
TEST(PowerCenter, IsRightWhereTetrahedraAreNearlyFlat)
{
  ForAllFives(60,
    [](const Five& p)
    {
      if (Orient(p) == 0)
      {
        return;
      }
      const Point3 center = biting::PowerCenter(p[0], p[1], p[2], p[3]);
      const ExactRow rows[3] = { RowOf(p[1], p[0]), RowOf(p[2], p[0]), RowOf(p[3], p[0]) };
      const Integer volume = 2 * Determinant3(rows[0], rows[1], rows[2]);
      double size = 0.0;
      for (std::size_t k = 1; k < 4; ++k)
      {
        size = std::max(size, Length(p[k].Place - p[0].Place));
        size = std::max(size, std::sqrt(std::abs(p[k].Weight - p[0].Weight)));
      }
      for (std::size_t d = 0; d < 3; ++d)
      {
        ExactRow columns[3] = { rows[0], rows[1], rows[2] };
        for (ExactRow& column : columns)
        {
          column[d] = column[3];
        }
        const double truth = LengthOf(Determinant3(columns[0], columns[1], columns[2]), volume);
        if (std::isfinite(truth))
        {
          EXPECT_NEAR(center[d], truth, 1e-10 * size + 1e-15 * std::abs(truth));
        }
      }
    });
}

TEST(Predicates3, SurviveWhatIsNotFinite)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : { infinity, nan, std::numeric_limits<double>::max() })
  {
    const Five p{ WeightedPoint{ { bad, 0, 1 }, 1 }, { { 1, bad, 0 }, bad }, { { 0, 1, bad }, 1 },
      { { bad, 0, -bad }, 1 }, { { 0.25, 0.25, 0.25 }, 1 } };
    Orient(p);
    InSphere(p);
    PowerTest(p);
  }
}

#ifdef BITING_COUNT_PREDICATES
TEST(Predicates3, AnswerOrdinaryCallsInTheFirstStage)
{
  constexpr int Count = 20000;
  Sampler sampler;
  const biting::PredicateCounts before = biting::GetPredicateCounts();
  for (int i = 0; i < Count; ++i)
  {
    const Five p = OrdinaryFive(sampler);
    Orient(p);
    InSphere(p);
    PowerTest(p);
  }
  const biting::PredicateCounts after = biting::GetPredicateCounts();
  EXPECT_EQ(after.Calls - before.Calls, 3 * Count);
  EXPECT_LT(1000 * (after.Widened - before.Widened), 3 * Count);
}

TEST(Predicates3, UseAllStages)
{
  const biting::PredicateCounts before = biting::GetPredicateCounts();
  int calls = 0;
  ForAllFives(20,
    [&calls](const Five& p)
    {
      PowerTest(p);
      ++calls;
    });
  const biting::PredicateCounts after = biting::GetPredicateCounts();
  EXPECT_EQ(after.Calls - before.Calls, calls);
  EXPECT_GT(after.Widened - before.Widened, 20);
  EXPECT_GT(after.Exact - before.Exact, 20);
}
#endif
