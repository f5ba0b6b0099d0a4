// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// What is told of an input that is meshed as it is.

#include "Support/MeshRun.h"
#include "Support/PolylineShapes.h"

#include <gtest/gtest.h>

#include <memory> // for sources

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
  EXPECT_EQ(run.Problems.Groups().front().First.front().Place, (Point2{ 0, 0 }));
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
  options.Spacing.Segments = segments;
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

} // namespace

} // namespace biting
