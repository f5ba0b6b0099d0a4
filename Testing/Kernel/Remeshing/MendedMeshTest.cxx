// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Support/MeshRun.h"
#include "../Support/MeshShapes.h"
#include "../Support/Monitors.h"
#include "../Support/RemeshLaws.h"
#include "BitingRemesh.h"

#include <gtest/gtest.h>

#include <algorithm> // for sort
#include <numeric>   // for iota

namespace biting
{

// What forms no mesh is read twice.
TEST(MendedMesh, IsReadAgainUnlessAMonitorStops)
{
  RemeshInput input = RemeshInputOf(SquareMesh(0.03), Rounding);
  for (const Point2& point : { Point2{ 0.3, 0.3 }, Point2{ 0.7, 0.3 }, Point2{ 0.5, 0.7 } })
  {
    input.Corners.push_back(static_cast<Id>(input.Points.size()));
    input.Points.push_back(point);
  }
  input.Regions.push_back(0);
  input.IsFixed.resize(input.Points.size(), 0);
  RemeshOptions options;
  options.Values.assign(input.Points.size(), 0.01);
  int stopped = 0;
  bool isRefused = false;
  for (int calls = 0; calls < 1000 && !isRefused; ++calls)
  {
    StoppingMonitor monitor(calls);
    ProblemList problems;
    Remesh(input, options, problems, monitor);
    EXPECT_EQ(problems.Has(ProblemCode::Aborted), monitor.HasStopped());
    stopped += monitor.HasStopped() ? 1 : 0;
    isRefused = !monitor.HasStopped() && problems.Has(ProblemCode::BadTriangles);
  }
  EXPECT_TRUE(isRefused);
  EXPECT_GT(stopped, 2);
}

TEST(MendedMesh, ThatFitsHasNoFlatTrianglesAtFreeEdges)
{
  const BitingMesh mesh = SquareMesh(0.1);
  const RemeshInput input = RemeshInputOf(mesh, Rounding);
  RemeshOptions options;
  options.Values = mesh.Spacing;
  std::vector<Id> below;
  for (Id vertex = 0; vertex < static_cast<Id>(mesh.Points.size()); ++vertex)
  {
    if (mesh.Points[vertex].Y == 0.0)
    {
      below.push_back(vertex);
    }
  }
  std::sort(below.begin(), below.end(),
    [&mesh](Id a, Id b) { return mesh.Points[a].X < mesh.Points[b].X; });
  RemeshInput flat = input;
  flat.Corners.insert(flat.Corners.end(), { below[2], below[4], below[3] });
  flat.Regions.push_back(0);
  ProblemList problems;
  const RemeshResult result = Remesh(flat, options, problems, NoMonitor());
  EXPECT_EQ(problems.Count(ProblemCode::FlatTriangles), 1);
  EXPECT_FALSE(problems.HasErrors());
  EXPECT_FALSE(result.IsUnchanged);
  EXPECT_EQ(RemeshLaws(input, result).Violation(), "");
}

// The triangles on the right of a slit have points of their own along it.
TEST(MendedMesh, ThatFitsKeepsAllTrianglesWherePointsAreMadeOne)
{
  const BitingMesh mesh = SquareMesh(0.05);
  RemeshInput input = RemeshInputOf(mesh, Rounding);
  RemeshOptions options;
  options.Values = mesh.Spacing;
  options.Values.insert(options.Values.end(), mesh.Spacing.begin(), mesh.Spacing.end());
  const Id count = static_cast<Id>(mesh.Points.size());
  input.Points.insert(input.Points.end(), mesh.Points.begin(), mesh.Points.end());
  input.IsFixed.resize(input.Points.size(), 0);
  for (std::size_t triangle = 0; triangle < mesh.Corners.size(); triangle += 3)
  {
    const bool isRight = mesh.Points[mesh.Corners[triangle]].X > 0.5;
    for (std::size_t slot = triangle; isRight && slot < triangle + 3; ++slot)
    {
      input.Corners[slot] += count;
    }
  }
  ProblemList problems;
  const RemeshResult result = Remesh(input, options, problems, NoMonitor());
  EXPECT_EQ(RemeshLaws(input, result).Violation(), "");
  EXPECT_GT(problems.Count(ProblemCode::DuplicatePoints), 10);
  EXPECT_FALSE(result.IsUnchanged);
  EXPECT_EQ(result.Mesh.Points.size(), mesh.Points.size());
  EXPECT_EQ(result.Mesh.EdgeStarts.size(), mesh.EdgeStarts.size());
  std::vector<Id> all(mesh.Corners.size() / 3);
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(result.OriginalTriangles, all);
}

} // namespace biting
