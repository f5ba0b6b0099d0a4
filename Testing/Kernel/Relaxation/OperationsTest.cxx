// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RawMesh.h"

#include "Base/Pulse.h"
#include "Relaxation/AngleDescent.h"
#include "Relaxation/Smoothing.h"
#include "Relaxation/Star.h"
#include "Relaxation/StarObjective.h"
#include "Relaxation/TopologyTrials.h"
#include "Relaxation/ValenceRound.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

/// A mesh with all the tools.
struct Tools : Workshop
{
  explicit Tools(RawMesh raw)
    : Workshop(std::move(raw))
    , Progress(Listener)
    , Valences(this->Mesh)
    , Descent(this->Mesh)
    , Trials(this->Mesh, Descent)
  {
  }

  SilentMonitor Listener;
  Pulse Progress;
  ValenceRound Valences;
  AngleDescent Descent;
  TopologyTrials Trials;
};

constexpr double Rounding = 1e-9; // of a cotangent

/// The law of all operations but one: no angle falls below the floor and what was smallest.
void ExpectLawful(const Tools& tools, double worstBefore, double floor)
{
  ASSERT_EQ(tools.Violation(true), "");
  EXPECT_LE(tools.WorstCotangentOfAll(), std::max(worstBefore, floor) * (1.0 + Rounding));
}

double SumOfSquaredExcess(const MutableMesh& mesh)
{
  double sum = 0.0;
  for (Id vertex = 0; vertex < mesh.NumberOfVertices(); ++vertex)
  {
    const double excess = mesh.IsAlive(vertex) ? mesh.Excess(vertex) : 0.0;
    sum += excess * excess;
  }
  return sum;
}

Id NumberOfEdgesOutOfBand(const MutableMesh& mesh)
{
  Id count = 0;
  for (Id edge = 0; edge < mesh.NumberOfEdges(); ++edge)
  {
    count += mesh.IsFirstHalf(edge) && IsOutOfBand(mesh, edge) ? 1 : 0;
  }
  return count;
}

Id NumberOfPoorTriangles(const MutableMesh& mesh)
{
  Id count = 0;
  for (Id triangle = 0; triangle < static_cast<Id>(mesh.Regions.size()); ++triangle)
  {
    count += mesh.IsEdge(4 * triangle) && IsWorseThan(mesh, triangle, CotangentOf38Degrees) ? 1 : 0;
  }
  return count;
}

} // namespace

TEST(Smoothing, LowersNoAngleBelow30DegreesAndKeepsDelaunay)
{
  for (RawMesh& raw : AllRawMeshes())
  {
    Tools tools(std::move(raw));
    for (int sweep = 0; sweep < 4; ++sweep)
    {
      const double worst = tools.WorstCotangentOfAll();
      SmoothAll(tools.Mesh, SweepKind::All, tools.Progress);
      ExpectLawful(tools, worst, CotangentOf30Degrees);
    }
  }
}

TEST(Smoothing, KeepsDelaunayWhereACoarseSweepLooksForFlipsBesideWhatMovedOnly)
{
  for (RawMesh& raw : AllRawMeshes())
  {
    Tools tools(std::move(raw));
    SmoothAll(tools.Mesh, SweepKind::All, tools.Progress);
    for (int sweep = 0; sweep < 6; ++sweep)
    {
      const double worst = tools.WorstCotangentOfAll();
      SmoothAll(tools.Mesh, SweepKind::Coarse, tools.Progress);
      ExpectLawful(tools, worst, CotangentOf30Degrees);
    }
  }
}

TEST(Smoothing, PutsAVertexInTheMiddleOfAHexagon)
{
  PolylineBuilder builder;
  builder.Loop(RegularPolygon({ 0.0, 0.0 }, 1.0, 6));
  RawMesh raw(builder.Lines(), UniformSpacing(1.0), 0.7, 0);
  raw = RawMesh(
    builder.Chain({ { 0.2, 0.13 } }, ChainKind::EmbeddedPoint).Lines(), UniformSpacing(1.0), 1, 0);
  Tools tools(std::move(raw));
  Id center = 0;
  while (tools.Mesh.Degrees[center] != 6)
  {
    ++center;
  }
  tools.Mesh.Freedoms[center] = Freedom::Free;
  for (int step = 0; step < 40; ++step)
  {
    SmoothVertex(tools.Mesh, center);
  }
  EXPECT_LT(Length(tools.Mesh.Points[center]), 1e-9);
}

TEST(Smoothing, EstimatesSpacingsWithinTwoPercent)
{
  Tools tools(GradedSquare());
  SmoothAll(tools.Mesh, SweepKind::All, tools.Progress);
  SmoothAll(tools.Mesh, SweepKind::All, tools.Progress);
  for (Id vertex = 0; vertex < tools.Mesh.NumberOfVertices(); ++vertex)
  {
    const double asked = tools.Raw.Spacing(tools.Mesh.Points[vertex]);
    ASSERT_NEAR(tools.Mesh.Spacings[vertex], asked, 0.02 * asked);
  }
}

TEST(Smoothing, LeavesEstimatesThatAreAskedForOnce)
{
  Tools tools(GradedSquare());
  SmoothAll(tools.Mesh, SweepKind::All, tools.Progress);
  SmoothAll(tools.Mesh, SweepKind::All, tools.Progress);
  tools.Mesh.AskForEstimates(tools.Progress);
  for (Id vertex = 0; vertex < tools.Mesh.NumberOfVertices(); ++vertex)
  {
    ASSERT_EQ(tools.Mesh.Spacings[vertex], tools.Raw.Spacing(tools.Mesh.Points[vertex]));
  }
}

TEST(ValenceRound, LowersNoAngleBelow20DegreesAndKeepsDelaunay)
{
  for (RawMesh& raw : AllRawMeshes())
  {
    Tools tools(std::move(raw));
    for (int round = 0; round < 4; ++round)
    {
      const double worst = tools.WorstCotangentOfAll();
      tools.Valences.Run(2, tools.Progress);
      ExpectLawful(tools, worst, CotangentOf20Degrees);
    }
  }
}

TEST(ValenceRound, BringsTheNumbersOfTrianglesTowardsSix)
{
  for (RawMesh& raw : AllRawMeshes())
  {
    Tools tools(std::move(raw));
    const double before = SumOfSquaredExcess(tools.Mesh);
    tools.Valences.Run(1, tools.Progress);
    EXPECT_LT(SumOfSquaredExcess(tools.Mesh), 0.95 * before);
  }
}

TEST(AngleDescent, LowersNoAngleBelow32DegreesAndKeepsDelaunay)
{
  for (RawMesh& raw : AllRawMeshes())
  {
    Tools tools(std::move(raw));
    const double worst = tools.WorstCotangentOfAll();
    tools.Descent.Run(tools.Progress);
    ExpectLawful(tools, worst, 1.6);
  }
}

TEST(AngleDescent, BringsEdgesIntoTheBand)
{
  Tools tools(UnitSquare());
  const Id before = NumberOfEdgesOutOfBand(tools.Mesh);
  tools.Descent.Run(tools.Progress);
  EXPECT_LT(2 * NumberOfEdgesOutOfBand(tools.Mesh), before);
}

TEST(TopologyTrials, LeavesFewerTrianglesBelow38DegreesInAll)
{
  Id before = 0;
  Id after = 0;
  for (RawMesh& raw : AllRawMeshes())
  {
    Tools tools(std::move(raw));
    tools.Descent.Run(tools.Progress);
    before += NumberOfPoorTriangles(tools.Mesh);
    tools.Trials.Run(20, tools.Progress);
    after += NumberOfPoorTriangles(tools.Mesh);
  }
  EXPECT_LT(after, before);
}

TEST(TopologyTrials, LowersNoAngleBelow30DegreesAndKeepsDelaunay)
{
  for (RawMesh& raw : AllRawMeshes())
  {
    Tools tools(std::move(raw));
    const double worst = tools.WorstCotangentOfAll();
    tools.Trials.Run(8, tools.Progress);
    ExpectLawful(tools, worst, CotangentOf30Degrees);
  }
}

TEST(StarObjective, DoesNotCountTheAngleBetweenTwoSegments)
{
  // An angle of 10 degrees cut off where both segments are one long: apart from it 85 and 85.
  const Point2 tip = UnitVector(10.0);
  RawMesh raw(PolylineBuilder().Loop({ { 0.0, 0.0 }, { 1.0, 0.0 }, tip }).Lines(),
    UniformSpacing(1.0), 1.0, 0);
  MutableMesh mesh(raw.Domain, raw.Spacing);
  mesh.IsDivided.assign(3, 1);
  SilentMonitor monitor;
  Pulse pulse(monitor);
  ReadMesh(raw.Mesh, mesh, pulse);
  EXPECT_FALSE(IsWorseThan(mesh, 0, CotangentOf30Degrees));
  mesh.Marks[0] = mesh.Marks[1] = mesh.Marks[2] = NoId;
  EXPECT_TRUE(IsWorseThan(mesh, 0, CotangentOf30Degrees));
}

} // namespace biting
