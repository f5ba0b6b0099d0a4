// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Quality/Histogram.h"
#include "Base/Numbers.h"

#include <gtest/gtest.h>

#include <limits>  // for what is no number
#include <numeric> // for sums

namespace
{

using biting::Histogram;
using biting::Infinity;
using biting::MakeHistogram;

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

TEST(Histogram, CountsEachValueOnceInTheBinThatHoldsIt)
{
  const Histogram histogram = MakeHistogram({ 0.0, 0.5, 1.0, 1.5, 3.999 }, 0.0, 4.0, 4);
  EXPECT_EQ(histogram.Centers, (std::vector<double>{ 0.5, 1.5, 2.5, 3.5 }));
  EXPECT_EQ(histogram.Percents, (std::vector<double>{ 40.0, 40.0, 0.0, 20.0 }));
}

TEST(Histogram, HoldsWhatIsOutsideInItsFirstAndLastBin)
{
  const Histogram histogram = MakeHistogram({ -1.0, -Infinity, 4.0, 9.0, Infinity }, 0.0, 4.0, 2);
  EXPECT_EQ(histogram.Percents, (std::vector<double>{ 40.0, 60.0 }));
}

TEST(Histogram, DoesNotCountWhatIsNoNumber)
{
  const Histogram histogram = MakeHistogram({ NotANumber, 1.0, NotANumber, 3.0 }, 0.0, 4.0, 2);
  EXPECT_EQ(histogram.Percents, (std::vector<double>{ 50.0, 50.0 }));
}

TEST(Histogram, AddsUpToAHundred)
{
  std::vector<double> values;
  for (int k = 0; k < 997; ++k)
  {
    values.push_back(0.37 * k);
  }
  const Histogram histogram = MakeHistogram(values, 10.0, 300.0, 7);
  EXPECT_NEAR(
    std::accumulate(histogram.Percents.begin(), histogram.Percents.end(), 0.0), 100.0, 1e-9);
}

TEST(Histogram, OfNothingIsZero)
{
  const Histogram histogram = MakeHistogram({}, 0.0, 1.0, 3);
  EXPECT_EQ(histogram.Centers.size(), 3u);
  EXPECT_EQ(histogram.Percents, (std::vector<double>{ 0.0, 0.0, 0.0 }));
}

} // namespace
