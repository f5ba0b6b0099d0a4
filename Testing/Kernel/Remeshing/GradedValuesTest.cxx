// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/GradedValues.h"
#include "../Support/MeshRun.h"
#include "../Support/MeshShapes.h"
#include "../Support/Monitors.h"
#include "../Support/RemeshLaws.h"

#include <gtest/gtest.h>

#include <algorithm> // for max
#include <cmath>     // for waves

namespace biting
{

namespace
{

constexpr double Gradation = 0.3;

OldMesh MeshOfSquare(double spacing)
{
  BitingMeshOptions options;
  options.Spacing.Uniform = spacing;
  const BitingMesh mesh = RunMesh(PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Lines(), options).Mesh;
  ProblemList problems;
  return ReadOldMesh(RemeshInputOf(mesh, 1e-15), 0.0, problems, NoMonitor());
}

template <typename Function>
std::vector<double> ValuesOn(const OldMesh& mesh, const Function& f)
{
  std::vector<double> values;
  for (const Point2& point : mesh.Points)
  {
    values.push_back(f(point));
  }
  return values;
}

std::vector<double> Lowered(const OldMesh& mesh, double gradation, std::vector<double> values)
{
  LowerToGradation(mesh, gradation, values, NoMonitor());
  return values;
}

double SteepestEdge(const OldMesh& mesh, const std::vector<double>& values)
{
  double steepest = 0.0;
  for (Id slot = 0; slot < static_cast<Id>(mesh.Corners.size()); ++slot)
  {
    const Id a = mesh.Start(slot);
    const Id b = mesh.End(slot);
    steepest = std::max(
      steepest, std::abs(values[a] - values[b]) / Distance(mesh.Points[a], mesh.Points[b]));
  }
  return steepest;
}

double Steep(const Point2& p)
{
  return p.X < 0.5 ? 0.01 : 0.3 + 0.2 * std::sin(20.0 * p.Y);
}

} // namespace

TEST(GradedValues, ValuesThatKeepTheGradationStay)
{
  const OldMesh mesh = MeshOfSquare(0.05);
  const std::vector<double> values = ValuesOn(mesh,
    [](const Point2& p) {
      return 0.01 + 0.29 * Distance(p, { 0.3, 0.4 });
    });
  EXPECT_EQ(Lowered(mesh, Gradation, values), values);
  EXPECT_EQ(Lowered(mesh, 0.0, ValuesOn(mesh, Steep)), ValuesOn(mesh, Steep));
}

TEST(GradedValues, ValuesAreLoweredUntilNoEdgeIsSteep)
{
  const OldMesh mesh = MeshOfSquare(0.04);
  const std::vector<double> given = ValuesOn(mesh, Steep);
  const std::vector<double> values = Lowered(mesh, Gradation, given);
  EXPECT_LT(SteepestEdge(mesh, values), 1.04 * Gradation);
  for (std::size_t vertex = 0; vertex < values.size(); ++vertex)
  {
    EXPECT_LE(values[vertex], given[vertex]);
    EXPECT_GE(values[vertex], 0.01);
  }
}

/// Over triangles, not along edges: those would be longer by up to 15 %. From one vertex, linear
/// interpolation between the first ones around it is the worst.
TEST(GradedValues, ValuesGrowWithTheDistanceInThePlane)
{
  const OldMesh mesh = MeshOfSquare(0.02);
  const Point2 source = mesh.Points[mesh.Points.size() / 2];
  const std::vector<double> values = Lowered(mesh, Gradation,
    ValuesOn(mesh, [&source](const Point2& p) { return p == source ? 0.02 : 10.0; }));
  for (std::size_t vertex = 0; vertex < values.size(); ++vertex)
  {
    const double exact = 0.02 + Gradation * Distance(source, mesh.Points[vertex]);
    EXPECT_GE(values[vertex], exact * (1.0 - 1e-12));
    EXPECT_LE(values[vertex], 1.06 * exact);
  }
}

TEST(GradedValues, AMonitorThatStopsEndsIt)
{
  const OldMesh mesh = MeshOfSquare(0.01);
  std::vector<double> values = ValuesOn(mesh, Steep);
  StoppingMonitor monitor(0);
  LowerToGradation(mesh, Gradation, values, monitor);
  EXPECT_GT(SteepestEdge(mesh, values), 1.1 * Gradation);
}

} // namespace biting
