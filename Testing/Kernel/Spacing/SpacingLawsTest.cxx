// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// The laws that Spacing.h states, of sources made at random: bounds are exact, the gradation holds
// for nearly all pairs of places that are at least f/2 apart.

#include "SpacingSources.h"

#include <gtest/gtest.h>

#include <array> // for choices

namespace
{

using namespace biting;

constexpr int NumberOfCases = 120;
constexpr int Pairs = 1500;

template <typename Number, std::size_t Size>
Number OneOf(const std::array<Number, Size>& numbers, Sampler& sampler)
{
  return numbers[static_cast<std::size_t>(static_cast<double>(Size) * sampler.Next())];
}

bool Chance(double share, Sampler& sampler)
{
  return sampler.Next() < share;
}

/// Waves, cones, noise, jumps.
Field MakeField(double least, double gradation, Sampler& sampler)
{
  const double slope =
    gradation * OneOf(std::array<double, 5>{ 0.9, 1.0, 1.01, 2.0, 10.0 }, sampler);
  const double jump = std::exp(6.0 * sampler.Next());
  const double waves = 1.0 + 10.0 * sampler.Next();
  switch (OneOf(std::array<int, 5>{ 0, 1, 2, 3, 4 }, sampler))
  {
    case 0:
      return [=](const Point2& x)
      { return least * std::exp(3.0 * std::sin(waves * x.X) * std::sin(waves * x.Y)); };
    case 1:
      return [=](const Point2& x) {
        return least + slope * std::abs(Length(x - Point2{ 0.4, 0.3 }) - 0.25);
      };
    case 2:
      return [=, &sampler](const Point2&) { return least * std::exp(4.0 * sampler.Next()); };
    case 3:
      return [=, &sampler](const Point2&) { return least * (1.0 + 0.4 * sampler.Next()); };
    default:
      return [=](const Point2& x)
      { return std::sin(waves * x.X) + std::cos(waves * x.Y) > 0.0 ? least * jump : least; };
  }
}

/// A value in some of all cases, at a share of the nodes.
void Spoil(std::vector<double>& values, double value, Sampler& sampler)
{
  const double share = Chance(0.3, sampler) ? 0.2 * sampler.Next() : 0.0;
  for (std::size_t node = 3; node < values.size(); ++node)
  {
    values[node] = Chance(share, sampler) ? value : values[node];
  }
}

/// Some triangles go, but the first one.
void AddGaps(TriangulatedSource& source, Sampler& sampler)
{
  const double share = Chance(0.4, sampler) ? 0.3 * sampler.Next() : 0.0;
  std::vector<Id> kept(source.Triangles.begin(), source.Triangles.begin() + 3);
  for (std::size_t first = 3; first < source.Triangles.size(); first += 3)
  {
    if (!Chance(share, sampler))
    {
      kept.insert(kept.end(), source.Triangles.begin() + static_cast<std::ptrdiff_t>(first),
        source.Triangles.begin() + static_cast<std::ptrdiff_t>(first) + 3);
    }
  }
  source.Triangles = kept;
}

SpacingOptions MakeOptions(Sampler& sampler)
{
  SpacingOptions options;
  options.Gradation = OneOf(std::array<double, 6>{ 0.0, 0.05, 0.1, 0.3, 1.0, 10.0 }, sampler);
  const double least = 0.3 * std::exp(-5.0 * sampler.Next());
  const Field field = MakeField(least, options.Gradation > 0.0 ? options.Gradation : 0.3, sampler);
  const int columns =
    2 + static_cast<int>(OneOf(std::array<double, 2>{ 11, 50 }, sampler) * sampler.Next());
  const double fill = OneOf(std::array<double, 2>{ 1e20, 9.97e36 }, sampler);
  const double power = OneOf(std::array<double, 3>{ 1.0, 0.6, 2.0 }, sampler);
  if (Chance(0.6, sampler))
  {
    GridSource grid =
      MakeGrid(columns, 2 + static_cast<int>(columns * sampler.Next()), field, power);
    Spoil(grid.Values, NotANumber, sampler);
    Spoil(grid.Values, fill, sampler);
    options.Sources.emplace_back(Share(std::move(grid)));
  }
  else
  {
    TriangulatedSource source = MakeTriangulation(columns, field, power);
    AddGaps(source, sampler);
    Spoil(source.Values, fill, sampler);
    options.Sources.emplace_back(Share(std::move(source)));
  }
  options.Minimum = Chance(0.4, sampler) ? least * std::exp(3.0 * sampler.Next() - 2.0) : 0.0;
  options.Maximum = Chance(0.3, sampler)
    ? std::max(options.Minimum, least * std::exp(3.0 * sampler.Next() - 1.0))
    : 0.0;
  options.Scale = Chance(0.3, sampler) ? std::exp(3.0 * sampler.Next() - 1.5) : 1.0;
  return options;
}

void ExpectLaws(const SpacingOptions& options, const Box2& bounds, Sampler& sampler)
{
  const Spacing f = MakeGoodSpacing(options, bounds);
  SpacingOptions asGiven = options;
  asGiven.Gradation = 0.0;
  const Spacing given = MakeGoodSpacing(asGiven, bounds);
  int lowered = 0;
  int misses = 0;
  for (int pair = 0; pair < Pairs; ++pair)
  {
    const Point2 x = sampler.NextIn(bounds);
    const double here = f(x);
    ASSERT_GT(here, 0.0);
    ASSERT_GE(here, options.Minimum);
    ASSERT_TRUE(options.Maximum == 0.0 || here <= options.Maximum);
    ASSERT_LE(here, given(x) * (1.0 + 1e-12));
    lowered += here < 0.98 * given(x) ? 1 : 0;
    const double reach = here * 0.5 * std::exp(5.0 * sampler.Next());
    const double angle = 6.283185307179586 * sampler.Next();
    const Point2 y = x + reach * Point2{ std::cos(angle), std::sin(angle) };
    if (options.Gradation > 0.0 && bounds.Contains(y))
    {
      const double most = options.Gradation * reach + 0.1 * std::min(here, f(y));
      misses += std::abs(here - f(y)) > most ? 1 : 0;
    }
  }
  EXPECT_LE(misses, Pairs / 200);
  EXPECT_TRUE(options.Gradation > 0.0 || lowered <= Pairs / 100);
}

} // namespace

TEST(SpacingLaws, HoldForSourcesMadeAtRandom)
{
  for (std::uint64_t seed = 1; seed <= NumberOfCases && !HasFatalFailure(); ++seed)
  {
    SCOPED_TRACE(seed);
    Sampler sampler(seed);
    const SpacingOptions options = MakeOptions(sampler);
    const double beyond = Chance(0.3, sampler) ? 0.3 * sampler.Next() : 0.0;
    ExpectLaws(options, { { -beyond, 0.0 }, { 1.0, 1.0 + beyond } }, sampler);
  }
}

/// Then the bounds end anywhere in what is outside of triangles.
TEST(SpacingLaws, HoldForTrianglesThatAreTurnedAndReachBeyondTheBounds)
{
  for (std::uint64_t seed = 1; seed <= NumberOfCases && !HasFatalFailure(); ++seed)
  {
    SCOPED_TRACE(seed);
    Sampler sampler(seed);
    SpacingOptions options = MakeOptions(sampler);
    if (const auto* triangles = First<TriangulatedSource>(options))
    {
      TriangulatedSource source = *triangles;
      for (Point2& point : source.Points)
      {
        point = Point2{ 0.3, 0.45 } +
          Point2{ 0.64 * point.X - 0.48 * point.Y, 0.48 * point.X + 0.64 * point.Y };
      }
      options.Sources = { Share(std::move(source)) };
      ExpectLaws(options, UnitBox(), sampler);
    }
  }
}

/// On a small part of their sides only.
TEST(SpacingLaws, HoldWhereValuesReachTheMaximumBesideACornerOfATriangle)
{
  SpacingOptions options = With(
    MakeTriangulation(5, [](const Point2& x) { return x.X < 0.4 && x.Y < 0.6 ? 0.0025 : 1e20; }));
  options.Maximum = 0.005;
  Sampler sampler(3);
  ExpectLaws(options, UnitBox(), sampler);
}
