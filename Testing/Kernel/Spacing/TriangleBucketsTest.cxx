// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/TriangleBuckets.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

#include <array> // for corners

namespace
{

using namespace biting;

TriangulatedSource Graded(int columns, double power)
{
  return MakeTriangulation(
    columns, [](const Point2&) { return 1.0; }, power);
}

/// Long triangles of all directions, each around others.
TriangulatedSource Needles(int count)
{
  Sampler sampler(1);
  TriangulatedSource needles;
  for (int needle = 0; needle < count; ++needle)
  {
    const Point2 start = sampler.NextIn(UnitBox());
    const double angle = 6.283185307179586 * sampler.Next();
    const Point2 along{ std::cos(angle), std::sin(angle) };
    needles.Points.insert(needles.Points.end(),
      { start, start + along, start + 0.5 * along + 1e-4 * Perpendicular(along) });
    needles.Triangles.insert(
      needles.Triangles.end(), { 3 * needle, 3 * needle + 1, 3 * needle + 2 });
  }
  return needles;
}

std::array<Point2, 3> CornersOf(const TriangulatedSource& source, std::size_t triangle)
{
  std::array<Point2, 3> corners;
  for (std::size_t k = 0; k < 3; ++k)
  {
    corners[k] = source.Points[static_cast<std::size_t>(source.Triangles[3 * triangle + k])];
  }
  return corners;
}

bool Contains(const std::array<Point2, 3>& corners, const Point2& x)
{
  double sides[3];
  for (std::size_t k = 0; k < 3; ++k)
  {
    sides[k] = Cross(corners[(k + 1) % 3] - corners[k], x - corners[k]);
  }
  return (sides[0] > 0.0) == (sides[1] > 0.0) && (sides[1] > 0.0) == (sides[2] > 0.0);
}

void ExpectAllAreFound(const TriangulatedSource& source, double power)
{
  Pulse pulse(NoMonitor());
  const TriangleBuckets buckets(source.Points, source.Triangles, pulse);
  Sampler sampler(2);
  for (int probe = 0; probe < 2000; ++probe)
  {
    const Point2 place = sampler.NextIn(UnitBox());
    const Point2 x{ std::pow(place.X, power), std::pow(place.Y, power) };
    const TriangleBuckets::Range near = buckets.Near(x);
    for (std::size_t triangle = 0; triangle < source.Triangles.size() / 3; ++triangle)
    {
      if (Contains(CornersOf(source, triangle), x))
      {
        EXPECT_NE(std::find(near.begin(), near.end(), static_cast<Id>(triangle)), near.end());
      }
    }
  }
}

} // namespace

TEST(TriangleBuckets, HaveAllTrianglesThatContainAPoint)
{
  ExpectAllAreFound(Graded(12, 1.0), 1.0);
  ExpectAllAreFound(Graded(25, 6.0), 6.0);
  ExpectAllAreFound(Needles(300), 1.0);
  ExpectAllAreFound(Needles(1), 1.0);
}

TEST(TriangleBuckets, AreFewTrianglesWhereverTheyAreGraded)
{
  Pulse pulse(NoMonitor());
  for (const double power : { 1.0, 2.0, 3.0 })
  {
    const TriangulatedSource source = Graded(60, power);
    const TriangleBuckets buckets(source.Points, source.Triangles, pulse);
    for (std::size_t triangle = 0; triangle < source.Triangles.size() / 3; ++triangle)
    {
      const std::array<Point2, 3> corners = CornersOf(source, triangle);
      const Point2 center = (1.0 / 3.0) * (corners[0] + corners[1] + corners[2]);
      const TriangleBuckets::Range near = buckets.Near(center);
      EXPECT_LE(near.end() - near.begin(), 24);
    }
  }
}
