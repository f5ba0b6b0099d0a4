// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/DrawnLengths.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

#include <algorithm> // for min
#include <limits>    // for infinity

namespace
{

using namespace biting;

constexpr double Slope = 0.3;

/// Two segments, which stand for paths of these lengths, and one that stands for itself.
FeatureSource Paths(const std::vector<double>& first, const std::vector<double>& second)
{
  FeatureSource source;
  source.PathLengths = first;
  source.PathLengths.insert(source.PathLengths.end(), second.begin(), second.end());
  source.PathOffsets = { 0, static_cast<Id>(first.size()),
    static_cast<Id>(first.size() + second.size()) };
  return source;
}

/// The definition: the least of all segments of the path, each grown by its distance along it.
double BoundAt(const std::vector<double>& path, double along, double slope)
{
  double bound = std::numeric_limits<double>::infinity();
  double start = 0.0;
  for (const double length : path)
  {
    const double before = std::max(0.0, start - along);
    const double after = std::max(0.0, along - (start + length));
    bound = std::min(bound, length + slope * (before + after));
    start += length;
  }
  return bound;
}

} // namespace

TEST(DrawnLengths, AreThoseOfTheSegmentsOfAPathGrownByTheirDistance)
{
  Sampler sampler(12);
  for (int repeat = 0; repeat < 50; ++repeat)
  {
    std::vector<double> path;
    double total = 0.0;
    for (int k = 0; k <= repeat; ++k)
    {
      const double share = sampler.Next();
      path.push_back(share * share * share + 1e-6);
      total += path.back();
    }
    const FeatureSource source = Paths({ 2.0, 1.0 }, path);
    const DrawnLengths lengths(source, Slope);
    for (int k = 0; k <= 200; ++k)
    {
      const double share = k / 200.0;
      ASSERT_NEAR(lengths(1, share), BoundAt(path, share * total, Slope), 1e-12);
    }
  }
}

TEST(DrawnLengths, ThoseOfAPathOfOneSegmentAreItsLength)
{
  const FeatureSource source = Paths({ 2.0 }, { 0.5 });
  const DrawnLengths lengths(source, Slope);
  for (const double share : { 0.0, 0.3, 1.0 })
  {
    EXPECT_EQ(lengths(0, share), 2.0);
    EXPECT_EQ(lengths(1, share), 0.5);
  }
}

TEST(DrawnLengths, AreUnboundedWhereASegmentStandsForNothingElse)
{
  const FeatureSource source = Paths({ 2.0 }, { 0.5 });
  EXPECT_EQ(DrawnLengths(source, Slope)(2, 0.5), std::numeric_limits<double>::infinity());
  EXPECT_EQ(DrawnLengths({}, Slope)(0, 0.5), std::numeric_limits<double>::infinity());
}
