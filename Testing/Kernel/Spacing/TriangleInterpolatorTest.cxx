// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/TriangleInterpolator.h"
#include "SpacingSources.h"

#include <gtest/gtest.h>

#include <cmath>  // for directions
#include <random> // for slivers

namespace
{

using namespace biting;

double TiltedPlane(const Point2& x)
{
  return 2.0 + 0.5 * x.X - 0.75 * x.Y;
}

double LongWave(const Point2& x)
{
  return 1.0 + 0.3 * std::sin(7.0 * x.X) * std::cos(5.0 * x.Y);
}

/// The same triangles with points of their own, and those in another order.
TriangulatedSource Unmerged(const TriangulatedSource& source)
{
  TriangulatedSource unmerged;
  for (std::size_t corner = source.Triangles.size(); corner > 0; --corner)
  {
    const auto point = static_cast<std::size_t>(source.Triangles[corner - 1]);
    unmerged.Triangles.push_back(static_cast<Id>(unmerged.Points.size()));
    unmerged.Points.push_back(source.Points[point]);
    unmerged.Values.push_back(source.Values[point]);
  }
  return unmerged;
}

TriangulatedSource Turned(TriangulatedSource source, double degrees)
{
  const double angle = degrees * 3.141592653589793 / 180.0;
  for (Point2& point : source.Points)
  {
    point = { std::cos(angle) * point.X - std::sin(angle) * point.Y,
      std::sin(angle) * point.X + std::cos(angle) * point.Y };
  }
  return source;
}

double NearestOfAll(const TriangulatedSource& source, const Point2& x)
{
  NearestValue best{ std::numeric_limits<double>::infinity(), 0.0 };
  for (std::size_t corner = 0; corner < source.Triangles.size(); ++corner)
  {
    const auto next = corner % 3 == 2 ? corner - 2 : corner + 1;
    const auto a = static_cast<std::size_t>(source.Triangles[corner]);
    const auto b = static_cast<std::size_t>(source.Triangles[next]);
    const NearestValue found =
      NearestOnEdge({ source.Points[a], source.Points[b], source.Values[a], source.Values[b] }, x);
    best = found.Distance < best.Distance ? found : best;
  }
  return best.Value;
}

} // namespace

TEST(TriangleInterpolator, IsExactOnALinearFieldAlsoWhereGraded)
{
  for (double power : { 1.0, 2.0, 6.0 })
  {
    const TriangleInterpolator interpolate(Share(MakeTriangulation(33, TiltedPlane, power)));
    Sampler sampler(3);
    for (int probe = 0; probe < 20000; ++probe)
    {
      Point2 x = sampler.NextIn(UnitBox());
      x = probe % 2 == 0 ? x : Point2{ std::pow(x.X, power), std::pow(x.Y, power) };
      ASSERT_NEAR(interpolate(x), TiltedPlane(x), 1e-13);
    }
  }
}

TEST(TriangleInterpolator, IsExactFarFromTheOrigin)
{
  TriangulatedSource source = MakeTriangulation(20, TiltedPlane);
  const Point2 shift{ 1e6, -3e6 };
  for (Point2& point : source.Points)
  {
    point = point + shift;
  }
  const TriangleInterpolator interpolate(Share(source));
  Sampler sampler(4);
  for (int probe = 0; probe < 5000; ++probe)
  {
    const Point2 x = sampler.NextIn(UnitBox());
    ASSERT_NEAR(interpolate(x + shift), TiltedPlane(x), 1e-7);
  }
}

TEST(TriangleInterpolator, IsTheGivenValueAtEveryPoint)
{
  const TriangulatedSource source = Turned(MakeTriangulation(25, LongWave, 3.0), 29.0);
  const TriangleInterpolator interpolate(Share(source));
  for (std::size_t point = 0; point < source.Points.size(); ++point)
  {
    ASSERT_NEAR(interpolate(source.Points[point]), source.Values[point], 1e-12);
  }
}

TEST(TriangleInterpolator, IsContinuousAcrossEdges)
{
  const TriangulatedSource source = Turned(MakeTriangulation(16, LongWave), 11.0);
  const TriangleInterpolator interpolate(Share(source));
  Sampler sampler(5);
  for (std::size_t corner = 0; corner + 1 < source.Triangles.size(); ++corner)
  {
    const Point2 a = source.Points[static_cast<std::size_t>(source.Triangles[corner])];
    const Point2 b = source.Points[static_cast<std::size_t>(source.Triangles[corner + 1])];
    const Point2 on = a + sampler.Next() * (b - a);
    const Point2 aside = 1e-9 * Perpendicular(b - a);
    ASSERT_NEAR(interpolate(on), interpolate(on + aside), 1e-8);
    ASSERT_NEAR(interpolate(on), interpolate(on - aside), 1e-8);
  }
}

TEST(TriangleInterpolator, DoesNotNeedSharedPoints)
{
  const TriangulatedSource source = Turned(MakeTriangulation(12, LongWave), 31.0);
  const TriangleInterpolator merged(Share(source));
  const TriangleInterpolator unmerged(Share(Unmerged(source)));
  Sampler sampler(6);
  for (int probe = 0; probe < 5000; ++probe)
  {
    const Point2 x = sampler.NextIn({ { -1.0, -1.0 }, { 2.0, 2.0 } });
    ASSERT_NEAR(merged(x), unmerged(x), 1e-12);
  }
}

TEST(TriangleInterpolator, IsTheNearestBorderValueOutsideAndInHoles)
{
  TriangulatedSource source = MakeTriangulation(9, LongWave);
  source.Values[40] = NotANumber;
  TriangulatedSource usable = source;
  usable.Triangles.clear();
  for (std::size_t first = 0; first < source.Triangles.size(); first += 3)
  {
    const auto corners = source.Triangles.begin() + static_cast<std::ptrdiff_t>(first);
    if (std::find(corners, corners + 3, 40) == corners + 3)
    {
      usable.Triangles.insert(usable.Triangles.end(), corners, corners + 3);
    }
  }
  const TriangleInterpolator interpolate(Share(source));
  Sampler sampler(7);
  int outside = 0;
  for (int probe = 0; probe < 4000; ++probe)
  {
    const Point2 x = sampler.NextIn({ { -2.0, -2.0 }, { 3.0, 3.0 } });
    const Point2 inHole{ 0.5 + 0.05 * (x.X - 0.5), 0.5 + 0.02 * (x.Y - 0.5) };
    ASSERT_TRUE(std::isfinite(interpolate(inHole)));
    if (!UnitBox().Contains(x))
    {
      ++outside;
      ASSERT_NEAR(interpolate(x), NearestOfAll(usable, x), 1e-12);
    }
  }
  EXPECT_GT(outside, 1000);
  const Point2 nearCenter{ 0.5, 0.51 };
  EXPECT_NEAR(interpolate(nearCenter), NearestOfAll(usable, nearCenter), 1e-12);
}

TEST(TriangleInterpolator, IgnoresTrianglesWithoutArea)
{
  TriangulatedSource source = MakeTriangulation(5, TiltedPlane);
  source.Triangles.insert(source.Triangles.begin(), { 0, 1, 2, 3, 3, 3, 7, 8, 7 });
  const TriangleInterpolator interpolate(Share(source));
  Sampler sampler(8);
  for (int probe = 0; probe < 1000; ++probe)
  {
    const Point2 x = sampler.NextIn(UnitBox());
    ASSERT_NEAR(interpolate(x), TiltedPlane(x), 1e-13);
  }
  source.Triangles.resize(9);
  EXPECT_TRUE(TriangleInterpolator(Share(source)).IsEmpty());
}

TEST(TriangleInterpolator, TakesManyTrianglesAroundOnePoint)
{
  constexpr int sectors = 3000;
  TriangulatedSource fan;
  fan.Points.push_back({});
  fan.Values.push_back(TiltedPlane({}));
  for (Id sector = 0; sector < sectors; ++sector)
  {
    const double angle = 6.283185307179586 * sector / sectors;
    fan.Points.push_back({ std::cos(angle), std::sin(angle) });
    fan.Values.push_back(TiltedPlane(fan.Points.back()));
    fan.Triangles.insert(fan.Triangles.end(), { 0, sector + 1, (sector + 1) % sectors + 1 });
  }
  const TriangleInterpolator interpolate(Share(fan));
  Sampler sampler(9);
  for (int probe = 0; probe < 5000; ++probe)
  {
    const Point2 x = sampler.NextIn({ { -0.7, -0.7 }, { 0.7, 0.7 } });
    ASSERT_NEAR(interpolate(x), TiltedPlane(x), 1e-9);
  }
}

TEST(TriangleInterpolator, TakesNeedlesInAnyDirection)
{
  for (double degrees : { 0.0, 90.0, 33.0 })
  {
    TriangulatedSource source = MakeTriangulation(30, LongWave);
    for (Point2& point : source.Points)
    {
      point.Y *= 1e-5;
    }
    const TriangulatedSource turned = Turned(source, degrees);
    const TriangleInterpolator interpolate(Share(turned));
    for (std::size_t point = 0; point < turned.Points.size(); ++point)
    {
      ASSERT_NEAR(interpolate(turned.Points[point]), turned.Values[point], 1e-6);
    }
  }
}

// Their heights are below the rounding of coordinates, their weights without meaning beside them.
TEST(TriangleInterpolator, IsBetweenTheValuesOfSliversInAndBesideThem)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit;
  for (int sliver = 0; sliver < 2000; ++sliver)
  {
    const double angle = 6.283 * unit(random);
    const double length = std::exp2(-20.0 * unit(random));
    const Point2 along = length * Point2{ std::cos(angle), std::sin(angle) };
    TriangulatedSource source;
    source.Points = { { 14.0 + unit(random), 15.0 + unit(random) } };
    source.Points.push_back(source.Points[0] + along);
    source.Points.push_back(source.Points[0] + unit(random) * along);
    source.Triangles = { 0, 1, 2 };
    source.Values = { 1.0, 2.0, 3.0 };
    const TriangleInterpolator interpolator(Share(source));
    for (int place = 0; place < 20 && !interpolator.IsEmpty(); ++place)
    {
      const Point2 beside = 1e-15 * Point2{ 14.0 * unit(random), 14.0 * unit(random) };
      const double value = interpolator(source.Points[0] + unit(random) * along + beside);
      EXPECT_GE(value, 1.0 - 1e-12);
      EXPECT_LE(value, 3.0 + 1e-12);
    }
  }
}
