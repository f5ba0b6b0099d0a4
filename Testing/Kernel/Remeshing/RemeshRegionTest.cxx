// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/RemeshRegion.h"
#include "../Support/MeshRun.h"
#include "../Support/Monitors.h"
#include "../Support/PolylineShapes.h"
#include "../Support/RemeshLaws.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

/// A box with a bar in it that is one `gap` wide, and as far from another one. The mesh was not
/// limited by feature size.
RemeshInput BarsInABox(double gap, double spacing)
{
  BitingMeshOptions options;
  options.Spacing.Uniform = spacing;
  options.LimitByFeatureSize = false;
  const BitingMesh mesh = RunMesh(PolylineBuilder()
                                    .Box(0.0, 0.0, 2.0, 1.0)
                                    .Box(0.1, 0.4, 1.9, 0.4 + gap)
                                    .Box(0.1, 0.4 + 2.0 * gap, 1.9, 0.95)
                                    .Lines(),
    options)
                            .Mesh;
  return RemeshInputOf(mesh, 1e-15);
}

} // namespace

// Near narrow parts f is lower than it was given, and more of the mesh must change.
TEST(RemeshRegion, TheSpacingIsThatOfTheOldVerticesInAllOfIt)
{
  int larger = 0;
  for (const double gap : { 0.02, 0.05, 0.25 })
  {
    for (const double place : { 0.4, 1.0, 1.6 })
    {
      const RemeshInput input = BarsInABox(gap, 0.2);
      RemeshOptions options;
      for (const Point2& point : input.Points)
      {
        options.Values.push_back(Distance(point, { place, 0.5 }) < 0.15 ? 0.1 : 0.2);
      }
      ProblemList problems;
      const OldMesh mesh = ReadOldMesh(input, 0.0, problems, NoMonitor());
      const RemeshRegion limited = FindRemeshRegion(mesh, options, problems, NoMonitor());
      for (const Id vertex : limited.Region.Vertices)
      {
        EXPECT_NEAR(limited.F(mesh.Points[vertex]), limited.OldSpacings[vertex], 1e-12);
      }
      options.LimitByFeatureSize = false;
      const RemeshRegion given = FindRemeshRegion(mesh, options, problems, NoMonitor());
      EXPECT_FALSE(problems.HasErrors());
      larger += !given.Region.Covers(limited.Region);
    }
  }
  EXPECT_GT(larger, 0);
}

} // namespace biting
