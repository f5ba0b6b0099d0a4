// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// What is told of an input that is meshed as it is.

#include "Support/MeshRun.h"
#include "Support/PolylineShapes.h"

#include <gtest/gtest.h>

#include <cmath>  // for turns
#include <memory> // for sources
#include <string> // for details
#include <vector> // for places

namespace biting
{

namespace
{

MeshRun RunPlain(const Polylines& input, double spacing = 0.2)
{
  BitingMeshOptions options;
  options.Spacing.Uniform = spacing;
  return RunMesh(input, options);
}

PolylineBuilder Wedge(double height)
{
  return PolylineBuilder().Loop({ { 0, 0 }, { 1, 0 }, { 1, height } });
}

TEST(Notes, AnAngleBelowAHundredthOfADegreeIsMeshedAndToldOf)
{
  const MeshRun run = RunPlain(Wedge(1e-4).Lines());
  EXPECT_EQ(run.Error(), "");
  EXPECT_NEAR(Area(run.Mesh), 0.5e-4, 1e-12);
  ASSERT_EQ(run.Problems.Count(ProblemCode::NarrowAngles), 1);
  EXPECT_EQ(run.Problems.Groups().front().First.front().Place, (Point3{ 0, 0, 0 }));
}

TEST(Notes, AWiderAngleIsNotToldOf)
{
  const MeshRun run = RunPlain(Wedge(2e-4).Lines());
  EXPECT_EQ(run.Error(), "");
  EXPECT_TRUE(run.Problems.Groups().empty());
}

TEST(Notes, AnAngleOutsideOfTheDomainIsNotToldOf)
{
  const MeshRun run = RunPlain(PolylineBuilder()
                                 .Loop({ { 0, -1 }, { 1, -1 }, { 1, 0 }, { 0, 0 }, { 1, 1e-4 },
                                   { 1, 1 }, { -1, 1 }, { -1, -1 } })
                                 .Lines());
  EXPECT_EQ(run.Error(), "");
  EXPECT_FALSE(run.Problems.Has(ProblemCode::NarrowAngles));
}

MeshRun RunWithValueAtOnePoint(double value)
{
  const PolylineBuilder builder = PolylineBuilder().Box(0, 0, 1, 1);
  auto segments = std::make_shared<SegmentSource>();
  segments->Points = builder.Lines().Points;
  segments->Values = { value, 0.2, 0.2, 0.2 };
  segments->Segments = { 0, 1, 1, 2, 2, 3, 3, 0 };
  BitingMeshOptions options;
  options.Spacing.Sources.emplace_back(segments);
  options.Spacing.Gradation = 5.0;
  options.MaximumNumberOfVertices = 100000;
  return RunMesh(builder.Lines(), options);
}

TEST(Notes, ASpacingBelowTheRoundingOfCoordinatesIsRaisedWithAWord)
{
  EXPECT_FALSE(RunWithValueAtOnePoint(1e-3).Problems.Has(ProblemCode::RaisedSpacing));
  for (const double value : { 1e-17, 5e-324 })
  {
    const MeshRun run = RunWithValueAtOnePoint(value);
    EXPECT_EQ(run.Problems.Count(ProblemCode::RaisedSpacing), 1) << value;
  }
}

std::vector<Point2> Turned(std::vector<Point2> places, double degrees)
{
  const double turn = degrees / 57.29577951308232;
  for (Point2& p : places)
  {
    p = { std::cos(turn) * p.X - std::sin(turn) * p.Y,
      std::sin(turn) * p.X + std::cos(turn) * p.Y };
  }
  return places;
}

std::int64_t NearMissesOf(const Polylines& input, double spacing = 0.2)
{
  const MeshRun run = RunPlain(input, spacing);
  EXPECT_EQ(run.Error(), "");
  return run.Problems.Count(ProblemCode::NearMisses);
}

/// Two squares, the right one with a corner within the left side of the gap.
PolylineBuilder Neighbors(double gap, double degrees)
{
  return PolylineBuilder()
    .Loop(Turned({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, degrees))
    .Loop(Turned({ { 1 + gap, 0.25 }, { 2, 0.25 }, { 2, 0.75 }, { 1 + gap, 0.75 } }, degrees));
}

TEST(Notes, NeighborsNearerThanAHundredthOfTheSpacingAreToldOf)
{
  for (const double degrees : { 0.0, 30.0 })
  {
    for (const double gap : { 1e-12, 1e-6, 1.9e-3 })
    {
      EXPECT_EQ(NearMissesOf(Neighbors(gap, degrees).Lines()), 2) << gap;
    }
    EXPECT_EQ(NearMissesOf(Neighbors(2.1e-3, degrees).Lines()), 0);
  }
}

TEST(Notes, TheMergeToleranceThatANearMissNamesJoinsIt)
{
  const Polylines input = Neighbors(1e-6, 30.0).Lines();
  const MeshRun run = RunPlain(input);
  ASSERT_TRUE(run.Problems.Has(ProblemCode::NearMisses));
  const std::string detail = run.Problems.Groups().front().First.front().Detail;
  const std::string name = "Merge Tolerance ";
  ASSERT_NE(detail.find(name), std::string::npos) << detail;
  BitingMeshOptions options;
  options.Spacing.Uniform = 0.2;
  options.Domain.MergeTolerance = std::stod(detail.substr(detail.find(name) + name.size()));
  const MeshRun merged = RunMesh(input, options);
  EXPECT_EQ(merged.Error(), "");
  EXPECT_FALSE(merged.Problems.Has(ProblemCode::NearMisses));
  EXPECT_GT(merged.Mesh.Quality.SmallestAngle, 20.0);
}

TEST(Notes, AnInterfaceThatEndsShortOfASideIsANearMissUnlessItIsJoined)
{
  const Polylines input =
    PolylineBuilder().Box(0, 0, 1, 1).Chain({ { 0.5, 0.5 }, { 0.5, 0.9975 } }).Lines();
  BitingMeshOptions options;
  options.Spacing.Uniform = 0.3;
  const MeshRun joined = RunMesh(input, options);
  EXPECT_EQ(joined.Problems.Count(ProblemCode::JoinedEnds), 1);
  EXPECT_EQ(joined.Problems.Count(ProblemCode::NearMisses), 0);
  options.Domain.EndTolerance = 0.0;
  EXPECT_EQ(RunMesh(input, options).Problems.Count(ProblemCode::NearMisses), 1);
}

TEST(Notes, AnEmbeddedPointBesideASegmentIsANearMiss)
{
  EXPECT_EQ(
    NearMissesOf(
      PolylineBuilder().Box(0, 0, 1, 1).Chain({ { 0.5, 1e-5 } }, ChainKind::EmbeddedPoint).Lines()),
    1);
}

TEST(Notes, ThinPartsAreToldOfAndThinHolesAndShortEdgesAreNone)
{
  EXPECT_EQ(NearMissesOf(PolylineBuilder().Box(0, 0, 1, 1e-4).Lines()), 4);
  EXPECT_EQ(NearMissesOf(PolylineBuilder().Box(0, 0, 1, 1).Box(0.3, 0.5, 0.7, 0.5001).Lines()), 0);
  EXPECT_EQ(NearMissesOf(PolylineBuilder()
                           .Loop({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 1e-5, 1 }, { 0, 1 - 1e-5 } })
                           .Lines()),
    0);
  EXPECT_EQ(
    NearMissesOf(PolylineBuilder().Loop(RegularPolygon({ 0, 0 }, 1.0, 5000)).Lines(), 0.5), 0);
  EXPECT_EQ(NearMissesOf(Wedge(2e-4).Lines()), 0);
}

} // namespace

} // namespace biting
