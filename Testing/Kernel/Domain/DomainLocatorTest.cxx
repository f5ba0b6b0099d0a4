// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Domain/DomainLocator.h"
#include "../Support/MeshShapes.h"
#include "Predicates/Predicates.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

/// Even-odd parity over all boundary segments, exactly.
bool IsInsideByParity(const Domain& domain, const Point2& p)
{
  bool isInside = false;
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    if (!domain.IsBoundary[segment])
    {
      continue;
    }
    Point2 low = domain.Vertices[domain.Starts[segment]];
    Point2 high = domain.Vertices[domain.Ends[segment]];
    if (IsOnSegment(p, low, high))
    {
      return false;
    }
    if (high.Y < low.Y)
    {
      std::swap(low, high);
    }
    const bool isBeside = low.Y <= p.Y && p.Y < high.Y;
    isInside ^= isBeside && Orient2D(low, high, p) > 0;
  }
  return isInside;
}

/// A star-shaped loop with integer coordinates, radii from `least` to `greatest`.
std::vector<Point2> RandomStar(
  const Point2& center, int corners, int least, int greatest, TestNumbers& numbers)
{
  std::vector<Point2> places;
  for (int k = 0; k < corners; ++k)
  {
    const double radius = least + numbers.Below(greatest - least);
    const Point2 place = center + radius * UnitVector(DegreesPerTurn * k / corners);
    places.push_back({ std::round(place.X), std::round(place.Y) });
  }
  return places;
}

void CheckEverywhere(const Domain& domain, double step, TestNumbers& numbers)
{
  Pulse unheard(NoMonitor());
  const DomainLocator locator(domain, unheard);
  const Box2& box = domain.Bounds;
  for (double y = box.Low.Y - step; y <= box.High.Y + step; y += step)
  {
    for (double x = box.Low.X - step; x <= box.High.X + step; x += step)
    {
      const Point2 p{ x, y };
      ASSERT_EQ(locator.IsInside(p), IsInsideByParity(domain, p)) << x << " " << y;
    }
  }
  for (int k = 0; k < 500; ++k)
  {
    const Point2 p{ box.Low.X + numbers.Unit() * box.Width(),
      box.Low.Y + numbers.Unit() * box.Height() };
    ASSERT_EQ(locator.IsInside(p), IsInsideByParity(domain, p)) << p.X << " " << p.Y;
  }
}

TEST(DomainLocator, AgreesWithParityOnStarsWithHoles)
{
  TestNumbers numbers(1);
  for (int run = 0; run < 12; ++run)
  {
    PolylineBuilder builder;
    builder.Loop(RandomStar({ 0.0, 0.0 }, 5 + 9 * run, 40, 100, numbers));
    builder.Loop(RandomStar({ 3.0, -2.0 }, 4 + run, 10, 35, numbers));
    builder.Loop(RandomStar({ 3.0, -2.0 }, 6, 3, 9, numbers));
    const MadeDomain made = Make(builder);
    ASSERT_EQ(made.Violation, "");
    CheckEverywhere(made.Domain, 5.0, numbers);
  }
}

/// Long teeth side by side, of which a square cell of the grid holds parts of many.
TEST(DomainLocator, AgreesWithParityInACombEitherWay)
{
  TestNumbers numbers(7);
  for (const bool isUpright : { true, false })
  {
    std::vector<Point2> places;
    for (int tooth = 0; tooth < 400; ++tooth)
    {
      const double x = 4.0 * tooth + numbers.Below(3);
      const double y = tooth % 2 == 0 ? numbers.Below(200) : 1500 - numbers.Below(200);
      places.push_back(isUpright ? Point2{ x, y } : Point2{ y, x });
    }
    places.push_back({ isUpright ? 1600.0 : -10.0, isUpright ? -10.0 : 1600.0 });
    places.push_back({ isUpright ? -1.0 : -10.0, isUpright ? -10.0 : -1.0 });
    const MadeDomain made = Make(PolylineBuilder().Loop(places));
    ASSERT_EQ(made.Violation, "");
    CheckEverywhere(made.Domain, 31.0, numbers);
  }
}

TEST(DomainLocator, VerticesAndPointsOnSegmentsAreNotInside)
{
  TestNumbers numbers(2);
  const MadeDomain made = Make(
    PolylineBuilder().Loop(RandomStar({ 0.0, 0.0 }, 60, 200, 500, numbers)).Loop(EllShape(64.0)));
  Pulse unheard(NoMonitor());
  const DomainLocator locator(made.Domain, unheard);
  for (const Point2& vertex : made.Domain.Vertices)
  {
    EXPECT_FALSE(locator.IsInside(vertex));
  }
  for (Id segment = 0; segment < made.Domain.NumberOfSegments(); ++segment)
  {
    const Point2& a = made.Domain.Vertices[made.Domain.Starts[segment]];
    const Point2& b = made.Domain.Vertices[made.Domain.Ends[segment]];
    for (int k = 1; k < 16; ++k)
    {
      const Point2 p = a + (k / 16.0) * (b - a);
      EXPECT_FALSE(locator.IsInside(p));
    }
  }
}

// One unit in the last place on both sides of each segment's middle.
TEST(DomainLocator, AgreesWithParityNextToSegments)
{
  TestNumbers numbers(3);
  const MadeDomain made =
    Make(PolylineBuilder().Loop(RandomStar({ 0.0, 0.0 }, 40, 200, 500, numbers)));
  Pulse unheard(NoMonitor());
  const DomainLocator locator(made.Domain, unheard);
  for (Id segment = 0; segment < made.Domain.NumberOfSegments(); ++segment)
  {
    const Point2 middle = made.Domain.Vertices[made.Domain.Starts[segment]] +
      numbers.Unit() *
        (made.Domain.Vertices[made.Domain.Ends[segment]] -
          made.Domain.Vertices[made.Domain.Starts[segment]]);
    for (double side : { -1e9, 1e9 })
    {
      for (const Point2& p : { Point2{ std::nextafter(middle.X, side), middle.Y },
             Point2{ middle.X, std::nextafter(middle.Y, side) } })
      {
        EXPECT_EQ(locator.IsInside(p), IsInsideByParity(made.Domain, p));
      }
    }
  }
}

TEST(DomainLocator, AgreesWithParityFarFromTheOriginAndWhenFlat)
{
  TestNumbers numbers(4);
  const std::vector<Point2> star = RandomStar({ 0.0, 0.0 }, 50, 40, 100, numbers);
  const auto far = [](const Point2& p) { return Point2{ p.X + 0x1p40, p.Y - 0x1p38 }; };
  const auto flat = [](const Point2& p) { return Point2{ p.X, 0x1p-30 * p.Y }; };
  const Polylines input = PolylineBuilder().Loop(star).Lines();
  const MadeDomain farDomain = Make(Move(input, far));
  CheckEverywhere(farDomain.Domain, 5.0, numbers);
  const MadeDomain flatDomain = Make(Move(input, flat));
  Pulse unheard(NoMonitor());
  const DomainLocator locator(flatDomain.Domain, unheard);
  for (int k = 0; k < 2000; ++k)
  {
    const Point2 p = flat({ 200.0 * numbers.Unit() - 100.0, 200.0 * numbers.Unit() - 100.0 });
    ASSERT_EQ(locator.IsInside(p), IsInsideByParity(flatDomain.Domain, p));
  }
}

TEST(DomainLocator, InterfacesBoundNothing)
{
  const MadeDomain made =
    Make(PolylineBuilder().Box(0.0, 0.0, 4.0, 4.0).Chain({ { 0.0, 2.0 }, { 4.0, 2.0 } }));
  Pulse unheard(NoMonitor());
  const DomainLocator locator(made.Domain, unheard);
  EXPECT_TRUE(locator.IsInside({ 1.0, 1.0 }));
  EXPECT_TRUE(locator.IsInside({ 1.0, 2.0 }));
  EXPECT_TRUE(locator.IsInside({ 1.0, 3.0 }));
}

} // namespace

} // namespace biting
