// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../../Fuzz/EvenOddArea.h"
#include "../Support/PolylineShapes.h"

#include <gtest/gtest.h>

#include <algorithm> // for generate
#include <cmath>     // for ldexp, sqrt

namespace biting
{

namespace
{

/// Loops on a small grid, where everything touches, crosses and overlaps; interfaces and points.
Polylines RandomDrawing(std::uint64_t seed)
{
  TestNumbers numbers(seed);
  const int size = 3 + numbers.Below(7);
  const auto place = [&numbers, size]()
  {
    const double x = numbers.Below(size);
    return Point2{ x, static_cast<double>(numbers.Below(size)) };
  };
  PolylineBuilder builder;
  const int loops = 1 + numbers.Below(3);
  for (int loop = 0; loop < loops; ++loop)
  {
    std::vector<Point2> places(static_cast<std::size_t>(3 + numbers.Below(4)));
    std::generate(places.begin(), places.end(), place);
    builder.Loop(places, ChainKind::Boundary);
  }
  builder.Chain({ place(), place(), place() }, ChainKind::Interface);
  builder.Chain({ place(), place() }, ChainKind::EmbeddedPoint);
  return builder.Lines();
}

void ExpectExactArea(const MadeDomain& made, double area)
{
  EXPECT_EQ(made.Violation, "");
  EXPECT_NEAR(made.Domain.Area, area, 1e-12);
  EXPECT_EQ(made.Problems.HasErrors(), area < 1e-12); // it is known to 2^-200
  EXPECT_FALSE(made.Problems.Has(ProblemCode::NotResolved));
}

TEST(DomainOracle, RandomDrawingsHaveTheExactArea)
{
  for (std::uint64_t seed = 1; seed <= 1000; ++seed)
  {
    SCOPED_TRACE(seed);
    const Polylines input = RandomDrawing(seed);
    const double area = MeasureEvenOddArea(ReadDrawing(input)).Area.convert_to<double>();
    ExpectExactArea(Make(input), area);
    ExpectExactArea(Make(Unmerge(input)), area);
  }
}

/// A drawing turned by an angle that has no exact sine, and moved: no place is exact any more.
TEST(DomainOracle, TurnedDrawingsKeepTheAreaToRounding)
{
  const double cosine = std::sqrt(0.9);
  const double sine = std::sqrt(0.1);
  const auto turn = [cosine, sine](const Point2& p) {
    return Point2{ cosine * p.X - sine * p.Y + 7.1, sine * p.X + cosine * p.Y - 3.3 };
  };
  for (std::uint64_t seed = 1; seed <= 5000; ++seed)
  {
    SCOPED_TRACE(seed);
    const Polylines input = RandomDrawing(seed);
    const MadeDomain straight = Make(input);
    const MadeDomain turned = Make(Move(input, turn));
    EXPECT_EQ(straight.Violation + turned.Violation, "");
    EXPECT_NEAR(straight.Domain.Area, turned.Domain.Area, 1e-11);
    EXPECT_FALSE(turned.Problems.Has(ProblemCode::NotResolved));
  }
}

/// Open chains of automatic kind in any confusion: whatever bounds, it bounds something.
TEST(DomainOracle, RandomOpenChainsGiveAValidDomain)
{
  int domains = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed)
  {
    SCOPED_TRACE(seed);
    TestNumbers numbers(seed);
    const int size = 3 + numbers.Below(6);
    PolylineBuilder builder;
    for (int chain = 4 + numbers.Below(14); chain > 0; --chain)
    {
      const double x = numbers.Below(size);
      const double y = numbers.Below(size);
      builder.Chain({ { x, y }, { x + numbers.Below(5) - 2, y + numbers.Below(5) - 2 } });
    }
    const MadeDomain made = Make(builder);
    const bool isRefused =
      made.Problems.Has(ProblemCode::NoClosedLoop) || made.Problems.Has(ProblemCode::OpenOutlines);
    EXPECT_EQ(made.Violation, "");
    EXPECT_EQ(made.Domain.Area > 0.0, !isRefused);
    EXPECT_EQ(made.Problems.HasErrors(), isRefused);
    domains += isRefused ? 0 : 1;
  }
  EXPECT_GT(domains, 500);
}

/// Coordinates so coarse that most vertices lie within rounding of several segments.
TEST(DomainOracle, DrawingsOfAFewUlpAreResolved)
{
  const double ulp = std::ldexp(1.0, -52);
  const auto shrink = [ulp](const Point2& p) { return Point2{ 1.0 + ulp * p.X, 1.0 + ulp * p.Y }; };
  for (std::uint64_t seed = 1; seed <= 2000; ++seed)
  {
    SCOPED_TRACE(seed);
    const MadeDomain made = Make(Move(RandomDrawing(seed), shrink));
    EXPECT_EQ(made.Violation, "");
    EXPECT_FALSE(made.Problems.Has(ProblemCode::NotResolved));
  }
}

} // namespace

} // namespace biting
