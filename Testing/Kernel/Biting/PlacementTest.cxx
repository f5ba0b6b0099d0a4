// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Support/BitingSettings.h"
#include "../Support/MeshRun.h"
#include "../Support/MeshShapes.h"

#include <gtest/gtest.h>

#include <algorithm> // for transform
#include <cmath>     // for nextafter
#include <numeric>   // for accumulate

namespace biting
{

namespace
{

Polylines Plate()
{
  return PolylineBuilder()
    .Box(0.0, 0.0, 1.0, 1.0)
    .Loop(RegularPolygon({ 0.55, 0.4 }, 0.2, 40))
    .Lines();
}

double MeanSmallestAngle(const BitingMesh& mesh)
{
  const std::vector<double>& angles = mesh.Quality.MinimumAngle;
  return std::accumulate(angles.begin(), angles.end(), 0.0) / static_cast<double>(angles.size());
}

class AllSettings : public testing::TestWithParam<BitingSetting>
{
protected:
  static BitingMeshOptions Options(const SpacingOptions& spacing)
  {
    BitingMeshOptions options;
    options.Spacing = spacing;
    options.Relaxation = false;
    GetParam().SetIn(options);
    return options;
  }
};

INSTANTIATE_TEST_SUITE_P(Placement, AllSettings, testing::ValuesIn(BitingSettings()));

TEST_P(AllSettings, MakeTheSameMeshEveryTime)
{
  const BitingMeshOptions options = Options(RadialSpacing({ 0.3, 0.8 }, 0.01, 0.2));
  const MeshRun first = RunMesh(Plate(), options);
  ASSERT_EQ(first.Error(), "");
  EXPECT_EQ(first.Mesh.Points, RunMesh(Plate(), options).Mesh.Points);
}

TEST_P(AllSettings, DoNotDependOnTheUnit)
{
  constexpr double Unit = 0x1p30;
  const MeshRun run = RunMesh(Plate(), Options(UniformSpacing(0.03)));
  Polylines scaled = Plate();
  for (Point2& p : scaled.Points)
  {
    p = Unit * p;
  }
  MeshRun other = RunMesh(scaled, Options(UniformSpacing(0.03 * Unit)));
  for (Point2& p : other.Mesh.Points)
  {
    p = 1.0 / Unit * p;
  }
  EXPECT_EQ(run.Mesh.Points, other.Mesh.Points);
}

/// The mesh of the plate, mirrored and turned.
MeshRun RunTurned(BitingMeshOptions options)
{
  Polylines input = Plate();
  for (Point2& p : input.Points)
  {
    p = { -p.Y, -p.X };
  }
  return RunMesh(input, options);
}

TEST_P(AllSettings, MakeMeshesAsGoodOfAMirroredDomain)
{
  if (GetParam().Order == FrontOrder::LargestY)
  {
    GTEST_SKIP() << "sweeps in one direction";
  }
  const BitingMeshOptions options = Options(UniformSpacing(0.02));
  const MeshRun run = RunMesh(Plate(), options);
  const MeshRun turned = RunTurned(options);
  EXPECT_NEAR(MeanSmallestAngle(run.Mesh), MeanSmallestAngle(turned.Mesh), 1.5);
  EXPECT_NEAR(1.0 * run.NumberOfVertices() / turned.NumberOfVertices(), 1.0, 0.05);
}

TEST_P(AllSettings, HaveTheLengthThatIsAskedFor)
{
  const MeshRun run = RunMesh(Plate(), Options(UniformSpacing(0.015)));
  EXPECT_NEAR(run.Mesh.Quality.MeanRelativeLength, 1.0, 0.04);
}

TEST_P(AllSettings, MakeSmallerBitesWithASmallerConstant)
{
  BitingMeshOptions options = Options(UniformSpacing(0.06));
  options.BitingConstant = 0.4;
  const Id fine = RunMesh(Plate(), options).NumberOfVertices();
  options.BitingConstant = 0.8;
  const Id coarse = RunMesh(Plate(), options).NumberOfVertices();
  EXPECT_GT(fine, 2.5 * coarse);
}

TEST_P(AllSettings, StopAfterTheBitesThatAreWanted)
{
  BitingMeshOptions options = Options(UniformSpacing(0.05));
  options.KeepBites = true;
  const MeshRun all = RunMesh(Plate(), options);
  const Id last = all.Mesh.Bites.Orders.back();
  for (const Id bites : { last / 2, last, last + 1 })
  {
    options.MaximumNumberOfBites = bites;
    const MeshRun some = RunMesh(Plate(), options);
    ASSERT_EQ(some.Error(), "");
    ASSERT_EQ(some.Mesh.Bites.Orders.back(), bites - 1);
    for (Id bite = 0; bite < some.Mesh.Bites.Size(); ++bite)
    {
      ASSERT_EQ(some.Mesh.Bites.Centers[bite], all.Mesh.Bites.Centers[bite]);
    }
    EXPECT_TRUE(bites > last ? some.Mesh.Front.empty() : bites == last || !some.Mesh.Front.empty());
  }
}

TEST_P(AllSettings, AddNoVertexToAPreservedBoundary)
{
  BitingMeshOptions options = Options(UniformSpacing(0.04));
  options.PreserveBoundary = true;
  const Polylines input =
    PolylineBuilder()
      .Loop(
        DividedLoop({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } }, { 9, 20, 14, 25 }))
      .Lines();
  const MeshRun run = RunMesh(input, options);
  ASSERT_EQ(run.Error(), "");
  EXPECT_EQ(run.Mesh.EdgeStarts.size(), input.Points.size());
  EXPECT_NEAR(Area(run.Mesh), 1.0, 1e-12);
  EXPECT_GT(run.Mesh.Quality.SmallestAngle, 10.0);
}

TEST_P(AllSettings, MeshGapsThatAreSmallerThanABite)
{
  const Polylines comb = PolylineBuilder().Loop(Comb(6, 0.02)).Lines();
  const MeshRun run = RunMesh(comb, Options(UniformSpacing(0.1)));
  EXPECT_EQ(run.Error(), "");
  EXPECT_GT(run.NumberOfTriangles(), 0);
}

TEST_P(AllSettings, MeshVerticesThatAreCrowdedInOneBite)
{
  const Polylines crowd = PolylineBuilder().Loop(RegularPolygon({ 0.0, 0.0 }, 1.0, 3000)).Lines();
  BitingMeshOptions options = Options(UniformSpacing(1.5));
  options.LimitByFeatureSize = false;
  const MeshRun run = RunMesh(crowd, options);
  EXPECT_EQ(run.Error(), "");
  EXPECT_EQ(run.NumberOfVertices(), 3000);
}

TEST_P(AllSettings, EndWhereBitesAreAsSmallAsTheRoundingOfPlaces)
{
  const double near = std::nextafter(4.6, 5.0);
  const Polylines input =
    PolylineBuilder()
      .Loop({ { 0.0, 1.0 }, { 4.6, 1.2 }, { near, 1.2 }, { 5.0, 3.0 }, { 0.0, 3.0 } })
      .Lines();
  BitingMeshOptions options = Options({});
  options.PreserveBoundary = true;
  options.MaximumNumberOfVertices = 20000;
  const MeshRun run = RunMesh(input, options);
  EXPECT_EQ(run.Error(), "");
  EXPECT_LT(run.NumberOfVertices(), 10000);
}

class Shapes : public testing::TestWithParam<BiteShape>
{
};

INSTANTIATE_TEST_SUITE_P(Placement, Shapes, testing::Values(BiteShape::Square, BiteShape::Circle));

TEST_P(Shapes, AreBetterAtBisectorsThanAtCorners)
{
  for (const SpacingOptions& spacing :
    { UniformSpacing(0.02), RadialSpacing({ 0.3, 0.8 }, 0.008, 0.1) })
  {
    BitingMeshOptions options;
    options.Spacing = spacing;
    options.Relaxation = false;
    options.BiteShape = GetParam();
    options.Placement = Placement::Corners;
    const double corners = MeanSmallestAngle(RunMesh(Plate(), options).Mesh);
    options.Placement = Placement::Bisectors;
    EXPECT_GT(MeanSmallestAngle(RunMesh(Plate(), options).Mesh), corners + 2.0);
  }
}

} // namespace

} // namespace biting
