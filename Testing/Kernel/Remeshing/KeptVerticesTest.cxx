// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/KeptVertices.h"
#include "../Support/MeshShapes.h"
#include "../Support/PolylineShapes.h"
#include "../Support/RemeshLaws.h"
#include "BitingMesh.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

/// Of the inner vertices of a mesh of a square, the share that is chosen where edges are to be so
/// many times shorter.
double ShareOfChosen(double ratio)
{
  BitingMeshOptions meshing;
  meshing.Spacing.Uniform = 0.05;
  ProblemList problems;
  const BitingMesh mesh = MakeBitingMesh(
    PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Lines(), meshing, problems, NoMonitor());
  SilentMonitor monitor;
  const OldMesh old = ReadOldMesh(RemeshInputOf(mesh, 1e-15), 0.0, problems, monitor);
  const std::vector<double> wanted(old.Points.size(), 0.05 / ratio);
  const ChangedRegion region = WholeRegion(old, MeanLengths(old, wanted));
  const KeepRules rules;
  const RegionEdges edges = ThinnedEdges(old, region, wanted, rules, EdgePolicy::Free);
  const std::vector<std::uint8_t> isKept = ChooseKeptVertices(old, region, edges, wanted, rules);
  double inner = 0.0;
  double chosen = 0.0;
  for (Id vertex = 0; vertex < region.NumberOfVertices(); ++vertex)
  {
    const Id point = region.Vertices[vertex];
    const Point2& place = old.Points[point];
    const bool isInner = place.X > 0.1 && place.X < 0.9 && place.Y > 0.1 && place.Y < 0.9;
    inner += isInner ? 1.0 : 0.0;
    chosen += isInner && isKept[vertex] != 0 ? 1.0 : 0.0;
  }
  EXPECT_GT(inner, 100.0);
  return chosen / inner;
}

TEST(KeptVertices, AreAllThatFit)
{
  EXPECT_EQ(ShareOfChosen(1.0), 1.0);
  EXPECT_GT(ShareOfChosen(1.35), 0.75); // lengths differ: the mean of those of a few is above 1.4
}

TEST(KeptVertices, AreAllWhereOthersFitBetweenThem)
{
  EXPECT_EQ(ShareOfChosen(2.0), 1.0);
}

TEST(KeptVertices, AreFewThatLieTooWideForFAndTooCloseForOthers)
{
  EXPECT_LT(ShareOfChosen(1.5), 0.25);
}

// Of a lattice whose edges are half as long as f one of four; fewer where lattices meet.
TEST(KeptVertices, AreACoarserLatticeWhereThereAreTooMany)
{
  EXPECT_NEAR(ShareOfChosen(0.5), 0.25, 0.07);
}

} // namespace

} // namespace biting
