// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/FaceRegions.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

/// A unit square of two triangles, each a region, that is to be made anew, and is made as it was.
struct Halves
{
  Halves()
  {
    RemeshInput input;
    input.Points = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } };
    input.Corners = { 0, 1, 2, 0, 2, 3 };
    input.Regions = { 0, 1 };
    ProblemList problems;
    this->Mesh = ReadOldMesh(input, 0.0, problems, NoMonitor());
    this->Region = WholeRegion(this->Mesh, std::vector<double>(4, 1.0));
    this->Cavity.Bites.Points = this->Mesh.Points;
    this->Cavity.Triangles = { this->Mesh.Corners, this->Mesh.Neighbors, {}, { 0, 1 } };
  }

  std::vector<Id> FaceRegions() const
  {
    Pulse pulse(NoMonitor());
    return FindFaceRegions(this->Mesh, this->Region, this->Cavity, pulse);
  }

  OldMesh Mesh;
  ChangedRegion Region;
  CavityMesh Cavity;
};

using Numbers = std::vector<Id>;

} // namespace

TEST(FaceRegions, AreThoseAtTheirMiddle)
{
  EXPECT_EQ(Halves().FaceRegions(), (Numbers{ 0, 1 }));
}

TEST(FaceRegions, HaveTheAreasOfTheOldMesh)
{
  Halves halves;
  halves.Cavity.FaceRegions = { 0, 1 };
  EXPECT_EQ(CheckAreas(halves.Mesh, halves.Region, halves.Cavity, {}), "");
  halves.Cavity.FaceRegions = { 1, 1 };
  EXPECT_EQ(CheckAreas(halves.Mesh, halves.Region, halves.Cavity, {}), "region 0 has another area");
}

TEST(FaceRegions, MayHaveOtherAreasAsFarAsEdgesMayMove)
{
  Halves halves;
  halves.Cavity.FaceRegions = { 0, 1 };
  for (Point2& point : halves.Cavity.Bites.Points)
  {
    point = 0.99 * point;
  }
  EXPECT_EQ(CheckAreas(halves.Mesh, halves.Region, halves.Cavity, {}), "region 0 has another area");
  const EdgeTolerance tolerance{ 0.02, 30.0, std::vector<double>(4, 1.0) };
  EXPECT_EQ(CheckAreas(halves.Mesh, halves.Region, halves.Cavity, tolerance), "");
}

// All edges together may sweep more than the square has.
TEST(FaceRegions, AreNotLostWhereOnlyTheEdgesOfOthersSweepAsMuch)
{
  Halves halves;
  halves.Cavity.FaceRegions = { 1, 1 };
  const EdgeTolerance tolerance{ 0.1, 30.0, std::vector<double>(4, 1.0) };
  EXPECT_EQ(
    CheckAreas(halves.Mesh, halves.Region, halves.Cavity, tolerance), "region 0 has another area");
}

} // namespace biting
