// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/BorderRays.h"

#include "SpacingSources.h"
#include "Support/Monitors.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

/// Small triangles, no two of which are near each other.
TriangulatedSource ScatteredTriangles(int side)
{
  TriangulatedSource source;
  Sampler sampler(7);
  for (int triangle = 0; triangle < side * side; ++triangle)
  {
    const double turn = 6.283185307179586 * sampler.Next();
    const Point2 center{ (triangle % side + 0.5) / side, (triangle / side + 0.5) / side };
    for (int corner = 0; corner < 3; ++corner)
    {
      const double angle = turn + 2.0943951023931953 * corner;
      source.Triangles.push_back(static_cast<Id>(source.Points.size()));
      source.Points.push_back(center + 0.4 / side * Point2{ std::cos(angle), std::sin(angle) });
      source.Values.push_back(0.01 * (1.0 + sampler.Next()));
    }
  }
  return source;
}

class Rays
{
public:
  Rays()
    : Field(Share(ScatteredTriangles(5)))
    , Beats(NoMonitor())
    , Traced(this->Field, UnitBox(), 0.3, { 1.0, 0.0, 1e9 }, this->Beats)
  {
  }

  /// Calls visit(front) for the outer side of each edge.
  template <typename Visit>
  void ForEachFront(Visit visit) const
  {
    for (const BorderEdge& edge : this->Field.BorderEdges())
    {
      const Point2 along = (1.0 / Distance(edge.Start, edge.End)) * (edge.End - edge.Start);
      const Point2 normal = Perpendicular(along);
      const bool isInside = this->Field.Covers(Midpoint(edge.Start, edge.End) + 1e-6 * normal);
      visit(BorderFront{ edge, isInside ? -1.0 * normal : normal });
    }
  }

  double DistanceToBorder(const Point2& x) const
  {
    double least = Infinity;
    for (const BorderEdge& edge : this->Field.BorderEdges())
    {
      least = std::min(least, NearestOnEdge(edge, x).Distance);
    }
    return least;
  }

  const TriangleInterpolator Field;
  Pulse Beats;
  const BorderRays Traced;
};

} // namespace

TEST(BorderRays, EndWhereTheirFeetCeaseToBeNearest)
{
  const Rays rays;
  rays.ForEachFront(
    [&rays](const BorderFront& front)
    {
      for (const double share : { 0.1, 0.5, 0.8 })
      {
        const BorderRay ray = rays.Traced.FindEnd(front.At(share), 0.1, nullptr);
        EXPECT_NEAR(rays.DistanceToBorder(ray.End()), ray.Length, 0.02 * ray.Length);
        const Point2 beyond = ray.Foot + 1.05 * ray.Length * ray.Direction;
        EXPECT_TRUE(!ray.Far || rays.DistanceToBorder(beyond) < 1.049 * ray.Length);
      }
    });
}

TEST(BorderRays, EndAtTheSamePlaceWhateverLengthIsLikely)
{
  const Rays rays;
  rays.ForEachFront(
    [&rays](const BorderFront& front)
    {
      const BorderRay ray = rays.Traced.FindEnd(front.At(0.4), 0.1, nullptr);
      for (const double likely : { 1e-9, 0.01, 100.0 })
      {
        const BorderRay other = rays.Traced.FindEnd(front.At(0.4), likely, nullptr);
        EXPECT_NEAR(other.Length, ray.Length, 0.02 * ray.Length);
      }
    });
}

/// There a third one may be nearer.
TEST(BorderRays, CrossWhereBothEdgesBeyondAreAsNear)
{
  const Rays rays;
  int crossings = 0;
  rays.ForEachFront(
    [&rays, &crossings](const BorderFront& front)
    {
      const BorderRay a = rays.Traced.FindEnd(front.At(0.0), 0.1, nullptr);
      const BorderRay b = rays.Traced.FindEnd(front.At(1.0), 0.1, nullptr);
      if (!rays.Traced.IsBeyond(a.Far, b) && !rays.Traced.IsBeyond(b.Far, a))
      {
        const BorderRay between = rays.Traced.FindCrossing(front, a, b);
        const double first = rays.Traced.EndAt(between, a.Far).Distance;
        const double second = rays.Traced.EndAt(between, b.Far).Distance;
        EXPECT_NEAR(first, second, 0.02 * first);
        EXPECT_LE(between.Length, 1.02 * first);
        ++crossings;
      }
    });
  EXPECT_GT(crossings, 20);
}

TEST(BorderRays, TellOfJumpsToBothSides)
{
  const Rays rays;
  BorderRay ray = BorderFront{ { {}, { 1.0, 0.0 }, 0.02, 0.02 }, { 0.0, 1.0 } }.At(0.5);
  const BorderEdge low{ { 0.0, 0.5 }, { 1.0, 0.5 }, 0.01, 0.01 };
  rays.Traced.EndAtOnce(ray, &low);
  EXPECT_DOUBLE_EQ(ray.Length, 0.25);
  EXPECT_TRUE(ray.IsJump);
  EXPECT_EQ(ray.Spacing, 0.01);
  const BorderEdge high{ { 0.0, 0.5 }, { 1.0, 0.5 }, 0.03, 0.03 };
  rays.Traced.LookBeyond(ray, &high);
  EXPECT_TRUE(ray.IsJump);
  EXPECT_EQ(ray.Spacing, 0.02);
  const BorderEdge same{ { 0.0, 0.5 }, { 1.0, 0.5 }, 0.02, 0.02 };
  rays.Traced.LookBeyond(ray, &same);
  EXPECT_FALSE(ray.IsJump);
}
