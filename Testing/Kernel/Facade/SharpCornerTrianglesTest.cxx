// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Support/MeshRun.h"
#include "../Support/MeshShapes.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

/// An isosceles triangle.
MeshRun RunWedge(double angle, bool isRelaxed)
{
  BitingMeshOptions options;
  options.Spacing = UniformSpacing(0.05);
  options.LimitByFeatureSize = false;
  options.Relaxation = isRelaxed;
  const Polylines wedge =
    PolylineBuilder().Loop({ { 0.0, 0.0 }, UnitVector(5.0), UnitVector(5.0 + angle) }).Lines();
  return RunMesh(wedge, options);
}

Id NumberOfPoor(const BitingMesh& mesh)
{
  Id count = 0;
  for (const double angle : mesh.Quality.MinimumAngle)
  {
    count += angle < 30.0 ? 1 : 0;
  }
  return count;
}

TEST(SharpCornerTriangles, AreAllThePoorOnesOfANeedle)
{
  for (const bool isRelaxed : { false, true })
  {
    for (const double angle : { 0.5, 1.0, 2.0 })
    {
      const MeshRun run = RunWedge(angle, isRelaxed);
      ASSERT_EQ(run.Error(), "");
      EXPECT_EQ(run.Mesh.NumberOfSharpCornerTriangles, NumberOfPoor(run.Mesh)) << angle;
      EXPECT_GE(run.Mesh.NumberOfSharpCornerTriangles, 15) << angle;
    }
  }
}

TEST(SharpCornerTriangles, AreFewerTheWiderTheCorner)
{
  for (const bool isRelaxed : { false, true })
  {
    Id last = 1000;
    for (const double angle : { 4.0, 8.0, 16.0, 32.0 })
    {
      const MeshRun run = RunWedge(angle, isRelaxed);
      ASSERT_EQ(run.Error(), "");
      EXPECT_LE(run.Mesh.NumberOfSharpCornerTriangles, NumberOfPoor(run.Mesh));
      EXPECT_LE(run.Mesh.NumberOfSharpCornerTriangles, last) << angle;
      last = run.Mesh.NumberOfSharpCornerTriangles;
    }
  }
}

TEST(SharpCornerTriangles, AreNoneWhereNoCornerIsSharp)
{
  BitingMeshOptions options;
  options.Spacing = UniformSpacing(0.05);
  options.Relaxation = false;
  options.Placement = Placement::Corners;
  const MeshRun run = RunMesh(PolylineBuilder().Loop(RegularPolygon({}, 1.0, 40)).Lines(), options);
  ASSERT_EQ(run.Error(), "");
  EXPECT_GT(NumberOfPoor(run.Mesh), 0);
  EXPECT_EQ(run.Mesh.NumberOfSharpCornerTriangles, 0);
}

} // namespace

} // namespace biting
