// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Quality/ExactSum.h"

#include <gtest/gtest.h>

#include <algorithm> // for reverse, shuffle
#include <cmath>     // for ldexp
#include <limits>    // for the infinite
#include <random>    // for terms
#include <vector>    // for terms

namespace biting
{

namespace
{

double SumOf(const std::vector<double>& terms)
{
  ExactSum sum;
  for (const double term : terms)
  {
    sum.Add(term);
  }
  return sum.Value();
}

} // namespace

TEST(ExactSum, OfOneTermIsTheTerm)
{
  const std::vector<double> terms{ 0.0, 1.0, 0.1, 1e300, 1e-300, 5e-324, 3.0 * 5e-324,
    std::numeric_limits<double>::max(), std::numeric_limits<double>::min(), 123456789.123456789 };
  for (const double term : terms)
  {
    EXPECT_EQ(SumOf({ term }), term);
  }
}

TEST(ExactSum, OfWholeNumbersIsExact)
{
  ExactSum sum;
  for (int k = 1; k <= 100000; ++k)
  {
    sum.Add(k);
  }
  EXPECT_EQ(sum.Value(), 5000050000.0);
}

TEST(ExactSum, LosesNothingOfSmallTerms)
{
  ExactSum sum;
  sum.Add(std::ldexp(1.0, 60));
  for (int k = 0; k < 256; ++k)
  {
    sum.Add(1.0);
  }
  EXPECT_EQ(sum.Value(), std::ldexp(1.0, 60) + 256.0);
}

TEST(ExactSum, IsTheSameInWhateverOrderAndParts)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-40.0, 40.0);
  std::vector<double> terms(5000);
  for (double& term : terms)
  {
    term = std::exp2(exponent(random));
  }
  const double wanted = SumOf(terms);
  std::reverse(terms.begin(), terms.end());
  EXPECT_EQ(SumOf(terms), wanted);
  std::shuffle(terms.begin(), terms.end(), random);
  EXPECT_EQ(SumOf(terms), wanted);
  ExactSum joined;
  for (std::size_t first = 0; first < terms.size(); first += 700)
  {
    ExactSum part;
    for (std::size_t k = first; k < std::min(terms.size(), first + 700); ++k)
    {
      part.Add(terms[k]);
    }
    joined.Join(part);
  }
  EXPECT_EQ(joined.Value(), wanted);
}

TEST(ExactSum, WithAnInfiniteTermIsInfinite)
{
  EXPECT_EQ(SumOf({ 1.0, std::numeric_limits<double>::infinity() }),
    std::numeric_limits<double>::infinity());
}

} // namespace biting
