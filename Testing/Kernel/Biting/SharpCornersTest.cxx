// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Biting/SharpCorners.h"
#include "../Support/BitingSettings.h"
#include "../Support/MeshRun.h"
#include "../Support/MeshShapes.h"

#include <gtest/gtest.h>

#include <algorithm> // for sort, min, max
#include <array>     // for triangles
#include <cmath>     // for abs, acos

namespace biting
{

namespace
{

/// Of a corner: how far apart its sides are, per distance from it.
double WidthOf(double angle)
{
  return Distance(UnitVector(0.0), UnitVector(angle));
}

/// A corner at the origin that opens into a hall where its sides are `width` apart; one of them is
/// longer than the other.
std::vector<Point2> WedgeWithHall(double angle, double width)
{
  const double length = width / WidthOf(angle);
  const Point2 first = length * UnitVector(0.0);
  const Point2 last = 1.2 * length * UnitVector(angle);
  return { { 0.0, 0.0 }, first, first + 0.5 * UnitVector(-90.0), { last.X + 1.0, -0.5 },
    { last.X + 1.0, last.Y + 0.5 }, last + 0.5 * UnitVector(angle + 90.0), last };
}

/// The distances from the corner of the vertices on the side toward `end`, ascending.
std::vector<double> DistancesOnSide(const BitingMesh& mesh, const Point2& end)
{
  std::vector<double> distances;
  for (std::size_t vertex = 0; vertex < mesh.Points.size(); ++vertex)
  {
    const Point2& p = mesh.Points[vertex];
    if (mesh.Kinds[vertex] == VertexKind::Boundary && std::abs(Cross(end, p)) < 1e-12)
    {
      distances.push_back(Length(p));
    }
  }
  std::sort(distances.begin(), distances.end());
  return distances;
}

/// How many of two lists are the same, from the first.
std::size_t CountSame(const std::vector<double>& first, const std::vector<double>& last)
{
  std::size_t count = 0;
  while (
    count < std::min(first.size(), last.size()) && std::abs(first[count] - last[count]) < 1e-12)
  {
    ++count;
  }
  return count;
}

double LargestAngle(const std::array<Point2, 3>& corners)
{
  double cosine = 1.0;
  for (int k = 0; k < 3; ++k)
  {
    const Point2 u = corners[(k + 1) % 3] - corners[k];
    const Point2 v = corners[(k + 2) % 3] - corners[k];
    cosine = std::min(cosine, Dot(u, v) / (Length(u) * Length(v)));
  }
  return std::acos(cosine) * DegreesPerTurn / 6.283185307179586;
}

class SharpCornersOf : public testing::TestWithParam<BitingSetting>
{
protected:
  static constexpr double F = 0.03; ///< where it is uniform

  static MeshRun RunRaw(const std::vector<Point2>& loop, const SpacingOptions& spacing)
  {
    BitingMeshOptions options;
    options.Spacing = spacing;
    options.Relaxation = false;
    options.LimitByFeatureSize = false;
    GetParam().SetIn(options);
    return RunMesh(PolylineBuilder().Loop(loop).Lines(), options);
  }

  /// Calls visit(corners, smallest angle) for the triangles of the mesh.
  template <typename Visit>
  static void VisitTriangles(const BitingMesh& mesh, const Visit& visit)
  {
    for (std::size_t k = 0; k < mesh.Corners.size(); k += 3)
    {
      const std::array<Point2, 3> corners{ mesh.Points[mesh.Corners[k]],
        mesh.Points[mesh.Corners[k + 1]], mesh.Points[mesh.Corners[k + 2]] };
      visit(corners, mesh.Quality.MinimumAngle[k / 3]);
    }
  }
};

double FarthestCorner(const std::array<Point2, 3>& corners)
{
  return std::max({ Length(corners[0]), Length(corners[1]), Length(corners[2]) });
}

INSTANTIATE_TEST_SUITE_P(SharpCorners, SharpCornersOf, testing::ValuesIn(BitingSettings()));

// Until these are f apart, or nearly to the end of the shorter one.
TEST_P(SharpCornersOf, HaveVerticesAtEqualDistancesOnBothSides)
{
  for (const SpacingOptions& spacing :
    { UniformSpacing(F), LinearSpacing(F, 0.05, 1.0), RadialSpacing({ 0.4, 0.2 }, F, 0.1) })
  {
    for (const double angle : { 1.0, 5.0, 11.0, 20.0, 35.0, 59.0 })
    {
      const std::vector<Point2> loop = WedgeWithHall(angle, 9.0 * F);
      const MeshRun run = RunRaw(loop, spacing);
      ASSERT_EQ(run.Error(), "") << angle;
      const std::vector<double> first = DistancesOnSide(run.Mesh, loop[1]);
      const std::size_t count = CountSame(first, DistancesOnSide(run.Mesh, loop.back()));
      ASSERT_GT(count, 0u) << angle;
      const double step = first[count - 1] - (count > 1 ? first[count - 2] : 0.0);
      EXPECT_TRUE(first[count - 1] * WidthOf(angle) > 0.9 * step ||
        first[count - 1] + 3.0 * step > Length(loop[1]))
        << angle << " " << count;
    }
  }
}

TEST_P(SharpCornersOf, HaveNoObtuseTrianglesWhereTheyAreNarrow)
{
  for (const double angle : { 1.0, 5.0, 12.0, 25.0 })
  {
    const double narrow = 0.5 * F / WidthOf(angle);
    const MeshRun run = RunRaw(WedgeWithHall(angle, 6.0 * F), UniformSpacing(F));
    ASSERT_EQ(run.Error(), "");
    VisitTriangles(run.Mesh,
      [angle, narrow](const std::array<Point2, 3>& corners, double)
      {
        EXPECT_TRUE(
          FarthestCorner(corners) > narrow || LargestAngle(corners) <= 90.0 + 0.5 * angle + 1e-6)
          << angle << " " << LargestAngle(corners);
      });
  }
}

TEST_P(SharpCornersOf, ShareASegmentWithTheOneAtItsOtherEnd)
{
  const std::vector<Point2> needle{ { 0.0, 0.0 }, { 1.0, 0.04 }, { 2.0, 0.0 } };
  const MeshRun run = RunRaw(needle, UniformSpacing(F));
  ASSERT_EQ(run.Error(), "");
  const std::vector<double> shells = DistancesOnSide(run.Mesh, needle[2]);
  const std::vector<double> side = DistancesOnSide(run.Mesh, needle[1]);
  EXPECT_GT(CountSame(shells, side), 10u);
  for (std::size_t k = 0; k < shells.size(); ++k)
  {
    EXPECT_NEAR(shells[k], 2.0 - shells[shells.size() - 1 - k], 1e-9);
  }
}

// Beyond the first shells where the sides are f apart. Measured: 24 degrees.
TEST_P(SharpCornersOf, SpoilNoTriangleElsewhere)
{
  for (const double angle : { 1.0, 8.0, 15.0, 24.0, 42.0, 59.0 })
  {
    const MeshRun run = RunRaw(WedgeWithHall(angle, 6.0 * F), UniformSpacing(F));
    ASSERT_EQ(run.Error(), "");
    const double end = F / WidthOf(angle) + 2.0 * F;
    double least = 90.0;
    VisitTriangles(run.Mesh,
      [end, &least](const std::array<Point2, 3>& corners, double smallest)
      {
        if (FarthestCorner(corners) > end)
        {
          least = std::min(least, smallest);
        }
      });
    EXPECT_GT(least, 20.0) << angle;
  }
}

} // namespace

} // namespace biting
