// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// The number of threads is no parameter of the mesh.

#include "../Support/MeshRun.h"
#include "../Support/MeshShapes.h"
#include "../Support/PolylineShapes.h"
#include "../Support/TestThreads.h"

#include <gtest/gtest.h>

#include <cmath> // for sqrt

namespace biting
{

namespace
{

BitingMesh MeshWith(int numberOfThreads, double spacing)
{
  BitingMeshOptions options;
  options.Spacing = UniformSpacing(spacing);
  const Polylines drawing = PolylineBuilder()
                              .Box(0.0, 0.0, 1.0, 1.0)
                              .Loop(RegularPolygon({ 0.5, 0.5 }, 0.2, 40))
                              .Chain({ { 0.0, 0.125 }, { 1.0, 0.125 } })
                              .Lines();
  ProblemList problems;
  MonitorWithThreads monitor(numberOfThreads);
  BitingMesh mesh = MakeBitingMesh(drawing, options, problems, monitor);
  EXPECT_FALSE(problems.HasErrors());
  return mesh;
}

void ExpectSame(const BitingMesh& mesh, const BitingMesh& other)
{
  ASSERT_EQ(mesh.Points.size(), other.Points.size());
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    ASSERT_TRUE(mesh.Points[i].X == other.Points[i].X && mesh.Points[i].Y == other.Points[i].Y);
  }
  EXPECT_EQ(mesh.Spacing, other.Spacing);
  EXPECT_EQ(mesh.BiteOrders, other.BiteOrders);
  EXPECT_EQ(mesh.Kinds, other.Kinds);
  EXPECT_EQ(mesh.OriginalPoints, other.OriginalPoints);
  EXPECT_EQ(mesh.Corners, other.Corners);
  EXPECT_EQ(mesh.Neighbors, other.Neighbors);
  EXPECT_EQ(mesh.Regions, other.Regions);
  EXPECT_EQ(mesh.EdgeStarts, other.EdgeStarts);
  EXPECT_EQ(mesh.EdgeEnds, other.EdgeEnds);
  EXPECT_EQ(mesh.EdgeCells, other.EdgeCells);
  EXPECT_EQ(mesh.UsedLipschitz, other.UsedLipschitz);
}

void ExpectSame(const MeshQuality& quality, const MeshQuality& other)
{
  EXPECT_EQ(quality.NearestNeighborDistance, other.NearestNeighborDistance);
  EXPECT_EQ(quality.Conformity, other.Conformity);
  EXPECT_EQ(quality.MinimumAngle, other.MinimumAngle);
  EXPECT_EQ(quality.RadiusEdgeRatio, other.RadiusEdgeRatio);
  EXPECT_EQ(quality.AspectRatio, other.AspectRatio);
  EXPECT_EQ(quality.SmallestAngle, other.SmallestAngle);
  EXPECT_EQ(quality.LargestRadiusEdgeRatio, other.LargestRadiusEdgeRatio);
  EXPECT_EQ(quality.SmallestConformity, other.SmallestConformity);
  EXPECT_EQ(quality.MeanConformity, other.MeanConformity);
  EXPECT_EQ(quality.MeanRelativeLength, other.MeanRelativeLength);
  EXPECT_EQ(quality.ShareOfEdgesInBand, other.ShareOfEdgesInBand);
}

} // namespace

TEST(Threads, MeshesAreTheSameToTheLastByteForAnyNumberOfThem)
{
  const double spacing = std::sqrt(1.0 / 40000.0);
  const BitingMesh alone = MeshWith(1, spacing);
  for (const int numberOfThreads : { 2, 3, 8 })
  {
    const BitingMesh mesh = MeshWith(numberOfThreads, spacing);
    ExpectSame(mesh, alone);
    ExpectSame(mesh.Quality, alone.Quality);
  }
}

} // namespace biting
