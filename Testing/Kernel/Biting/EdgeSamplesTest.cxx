// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Biting/EdgeSamples.h"
#include "../Support/MeshShapes.h"

#include <gtest/gtest.h>

#include <cmath>  // for abs
#include <memory> // for sources

namespace biting
{

namespace
{

using Sample = EdgeSamples::Sample;

const Point2 Start{ 0.3, 0.0 };
const Point2 End{ 0.3, 1.0 };

/// Linear between values at places along the edge.
SpacingOptions Along(std::vector<double> places, std::vector<double> values)
{
  auto grid = std::make_shared<GridSource>();
  grid->XNodes = { 0.0 };
  grid->YNodes = std::move(places);
  grid->Values = std::move(values);
  SpacingOptions options;
  options.Gradation = 0.0;
  options.Grid = grid;
  return options;
}

/// Those of the edge, with its start.
std::vector<Sample> SamplesOf(const Spacing& f)
{
  EdgeSamples samples(f);
  samples.Begin(Start, End, f(Start), f(End));
  std::vector<Sample> all{ { 0.0, f(Start) } };
  while (all.back().Parameter < 1.0 && all.size() < 100000)
  {
    all.push_back(samples.Next());
  }
  return all;
}

/// The most that f differs from the lines between the samples, as a share of f.
double WorstOf(const Spacing& f, const std::vector<Sample>& samples)
{
  double worst = 0.0;
  for (std::size_t k = 1; k < samples.size(); ++k)
  {
    for (double share = 0.05; share < 1.0; share += 0.05)
    {
      const Sample& a = samples[k - 1];
      const Sample& b = samples[k];
      const double t = a.Parameter + share * (b.Parameter - a.Parameter);
      const double wanted = f(Start + t * (End - Start));
      const double found = a.Spacing + share * (b.Spacing - a.Spacing);
      worst = std::max(worst, std::abs(found - wanted) / wanted);
    }
  }
  return worst;
}

} // namespace

TEST(EdgeSamples, AscendToTheEndWithTheSpacingThere)
{
  const Spacing f =
    SpacingAroundUnitSquare(Along({ 0.0, 0.3, 0.34, 1.0 }, { 0.05, 0.02, 0.06, 0.01 }));
  const std::vector<Sample> samples = SamplesOf(f);
  for (std::size_t k = 1; k < samples.size(); ++k)
  {
    EXPECT_GT(samples[k].Parameter, samples[k - 1].Parameter);
    EXPECT_EQ(samples[k].Spacing, f(Start + samples[k].Parameter * (End - Start)));
  }
  EXPECT_EQ(samples.back().Parameter, 1.0);
}

TEST(EdgeSamples, OfAConstantAreTheEnds)
{
  EXPECT_EQ(SamplesOf(SpacingAroundUnitSquare(UniformSpacing(0.01))).size(), 2u);
}

TEST(EdgeSamples, AreAFewOnALine)
{
  const Spacing f = SpacingAroundUnitSquare(LinearSpacing(0.02, 0.1, 1.0));
  const std::vector<Sample> samples = SamplesOf(f);
  const double integral = std::log(6.0) / 0.1;
  EXPECT_LE(static_cast<double>(samples.size()), 1.2 * integral);
  EXPECT_LT(WorstOf(f, samples), 1e-12);
}

TEST(EdgeSamples, FollowWhatIsRound)
{
  for (const double slope : { 0.1, 0.3 })
  {
    const Spacing f = SpacingAroundUnitSquare(RadialSpacing({ 0.32, 0.41 }, 0.01, slope));
    EXPECT_LT(WorstOf(f, SamplesOf(f)), 0.03) << slope;
  }
}

TEST(EdgeSamples, FollowEdgesOfTheSpacing)
{
  for (double top = 0.2; top < 0.8; top += 0.0123)
  {
    const double low = 0.02;
    const Spacing f = SpacingAroundUnitSquare(
      Along({ 0.0, top, 1.0 }, { low + 0.15 * top, low, low + 0.15 * (1.0 - top) }));
    EXPECT_LT(WorstOf(f, SamplesOf(f)), 0.06) << top;
  }
}

TEST(EdgeSamples, AreNearEachOtherWhereTheSpacingJumps)
{
  const double place = 0.41;
  for (const double ratio : { 3.0, 30.0, 1.0 / 30.0 })
  {
    const double low = 0.03;
    const Spacing f =
      SpacingAroundUnitSquare(Along({ place, std::nextafter(place, 1.0) }, { low, ratio * low }));
    const std::vector<Sample> samples = SamplesOf(f);
    std::size_t numberOfJumps = 0;
    for (std::size_t k = 1; k < samples.size(); ++k)
    {
      // On either side f is a blend of equal values, so it differs by rounding.
      const double step = std::abs(samples[k].Spacing - samples[k - 1].Spacing);
      const bool isJump = step > 1e-12 * low;
      const double width = samples[k].Parameter - samples[k - 1].Parameter;
      EXPECT_TRUE(!isJump || width <= 1e-3 * std::max(1.0, ratio) * low) << ratio;
      numberOfJumps += isJump ? 1 : 0;
    }
    EXPECT_EQ(numberOfJumps, 1u) << ratio;
    const double integral = place / low + (1.0 - place) / (ratio * low);
    EXPECT_LT(static_cast<double>(samples.size()), 1.2 * integral + 30.0) << ratio;
  }
}

} // namespace biting
