// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Support/BitingSettings.h"
#include "../Support/SameMesh.h"
#include "PlateMeshes.h"

#include <gtest/gtest.h>

#include <cmath> // for ldexp

namespace biting
{

namespace
{

/// Valid, of the area `area`, and with about as many vertices as `other`.
void ExpectEquivalent(const MeshRun& run, const MeshRun& other, double area)
{
  ASSERT_EQ(run.Error(), "");
  EXPECT_NEAR(Area(run.Mesh), area, 1e-9 * area);
  EXPECT_NEAR(run.NumberOfVertices(), other.NumberOfVertices(), 0.1 * other.NumberOfVertices());
}

TEST(BitingMesh, SameInputGivesSameBytes)
{
  for (FrontOrder order : PaperOrders)
  {
    BitingMeshOptions options = RadialOptions();
    options.Order = order;
    const BitingMesh first = RunMesh(Plate(), options).Mesh;
    const BitingMesh second = RunMesh(Plate(), options).Mesh;
    ASSERT_GT(first.Points.size(), 500u);
    ExpectSameTopology(first, second);
    EXPECT_TRUE(HaveSameBytes(first.Points, second.Points));
    EXPECT_TRUE(HaveSameBytes(first.Spacing, second.Spacing));
    EXPECT_TRUE(HaveSameBytes(first.Bites.Centers, second.Bites.Centers));
    EXPECT_TRUE(HaveSameBytes(first.Bites.Axes, second.Bites.Axes));
    EXPECT_TRUE(HaveSameBytes(first.Quality.MinimumAngle, second.Quality.MinimumAngle));
    EXPECT_TRUE(HaveSameBytes(first.Quality.Conformity, second.Quality.Conformity));
  }
}

TEST(BitingMesh, ScaleByPowerOfTwoScalesEveryBit)
{
  const BitingMesh mesh = RunMesh(Plate(), UniformOptions(0.03)).Mesh;
  for (double scale : { 0x1p-40, 0.25, 0x1p30 })
  {
    const Polylines input = Move(Plate(), [scale](const Point2& p) { return scale * p; });
    const BitingMesh scaled = RunMesh(input, UniformOptions(scale * 0.03)).Mesh;
    ExpectSameTopology(mesh, scaled);
    ASSERT_EQ(mesh.Points.size(), scaled.Points.size());
    for (std::size_t vertex = 0; vertex < mesh.Points.size(); ++vertex)
    {
      ASSERT_EQ(scale * mesh.Points[vertex], scaled.Points[vertex]);
      ASSERT_EQ(scale * mesh.Spacing[vertex], scaled.Spacing[vertex]);
    }
  }
}

TEST(BitingMesh, ScaleByPowerOfTwoScalesEveryBitOfGradedMesh)
{
  constexpr double Scale = 0x1p-20;
  const BitingMesh mesh = RunMesh(Plate(), RadialOptions()).Mesh;
  BitingMeshOptions options = RadialOptions();
  options.Spacing = RadialSpacing({ Scale * 0.3, Scale * 0.25 }, Scale * 0.01, 0.1);
  const Polylines input = Move(Plate(), [](const Point2& p) { return Scale * p; });
  const BitingMesh scaled = RunMesh(input, options).Mesh;
  ExpectSameTopology(mesh, scaled);
  ASSERT_EQ(mesh.Points.size(), scaled.Points.size());
  for (std::size_t vertex = 0; vertex < mesh.Points.size(); ++vertex)
  {
    ASSERT_EQ(Scale * mesh.Points[vertex], scaled.Points[vertex]);
  }
}

TEST(BitingMesh, ShiftGivesValidMesh)
{
  const MeshRun run = RunMesh(UnitSquare(), UniformOptions(0.04));
  for (const Point2& offset :
    { Point2{ 1024.0, -4096.0 }, Point2{ 0x1p30, 0x1p29 }, Point2{ -0x1p40, 3.0 } })
  {
    const Polylines input = Move(UnitSquare(), [&](const Point2& p) { return p + offset; });
    ExpectEquivalent(RunMesh(input, UniformOptions(0.04)), run, 1.0);
  }
}

TEST(BitingMesh, TurnsMirrorsAndReversalsAreEquivalent)
{
  const Polylines plate = Plate();
  const auto mesh = [](const Polylines& input) { return RunMesh(input, UniformOptions(0.03)); };
  const MeshRun run = mesh(plate);
  const double area = Area(run.Mesh);
  ExpectEquivalent(mesh(Move(plate, Perpendicular)), run, area);
  ExpectEquivalent(mesh(Move(plate,
                     [](const Point2& p) {
                       return Point2{ -p.X, p.Y };
                     })),
    run, area);
  ExpectEquivalent(mesh(Move(plate,
                     [](const Point2& p) {
                       return Point2{ p.Y, p.X };
                     })),
    run, area);
  ExpectEquivalent(mesh(Reverse(plate)), run, area);
  ExpectEquivalent(mesh(Unmerge(plate)), run, area);
  const Point2 axis = UnitVector(17.0);
  ExpectEquivalent(
    mesh(Move(plate, [&axis](const Point2& p) { return p.X * axis + p.Y * Perpendicular(axis); })),
    run, area);
}

TEST(BitingMesh, PermutedChainsAreEquivalent)
{
  const MeshRun run = RunMesh(Plate(), UniformOptions(0.03));
  const Polylines permuted = PolylineBuilder()
                               .Chain({ { 0.25, 0.875 } }, ChainKind::EmbeddedPoint)
                               .Chain({ { 1.0, 0.125 }, { 0.0, 0.125 } })
                               .Loop(RegularPolygon({ 0.5, 0.5 }, 0.2, 24))
                               .Loop({ { 1.0, 1.0 }, { 0.0, 1.0 }, { 0.0, 0.125 }, { 0.0, 0.0 },
                                 { 1.0, 0.0 }, { 1.0, 0.125 } })
                               .Lines();
  ExpectEquivalent(RunMesh(permuted, UniformOptions(0.03)), run, Area(run.Mesh));
}

} // namespace

} // namespace biting
