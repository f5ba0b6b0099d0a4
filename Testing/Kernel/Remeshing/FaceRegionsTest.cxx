// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/FaceRegions.h"
#include "Remeshing/Stitching.h"

#include <gtest/gtest.h>

#include <algorithm> // for minmax

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
    this->Edges = StraightPieces(this->Mesh, this->Region, EdgePolicy::Frozen);
    this->Cavity.Geometry = MakeCavityDomain(
      this->Mesh, this->Region, this->Edges, this->Edges.IsKept, {}, EdgePolicy::Frozen);
    BitingResult& bites = this->Cavity.Bites;
    bites.Points = this->Cavity.Geometry.Vertices;
    bites.EdgeStarts = this->Cavity.Geometry.Starts;
    bites.EdgeEnds = this->Cavity.Geometry.Ends;
    Triangulation& triangles = this->Cavity.Triangles;
    triangles = { this->Mesh.Corners, this->Mesh.Neighbors, {}, { 0, 1 } };
    for (std::size_t edge = 0; edge < this->Edges.Edges.size(); ++edge)
    {
      bites.EdgeSegments.push_back(static_cast<Id>(edge));
    }
    for (Id slot = 0; slot < 6; ++slot)
    {
      triangles.Constraints.push_back(this->EdgeAt(slot));
    }
  }

  Id EdgeAt(Id slot) const
  {
    const auto wanted = std::minmax({ this->Mesh.Start(slot), this->Mesh.End(slot) });
    Id edge = 0;
    while (std::minmax({ this->Edges.Edges[edge].Start, this->Edges.Edges[edge].End }) != wanted)
    {
      ++edge;
    }
    return edge;
  }

  RegionEdge& Diagonal() { return this->Edges.Edges[this->EdgeAt(1)]; }

  std::vector<Id> FaceRegions() const
  {
    Pulse pulse(NoMonitor());
    return FindFaceRegions(this->Mesh, this->Region, this->Edges, this->Cavity, pulse);
  }

  OldMesh Mesh;
  ChangedRegion Region;
  RegionEdges Edges;
  CavityMesh Cavity;
};

using Numbers = std::vector<Id>;

} // namespace

TEST(FaceRegions, AreWhatEdgesHaveOnThisSide)
{
  EXPECT_EQ(Halves().FaceRegions(), (Numbers{ 0, 1 }));
}

// As a tagged edge within a region has it that rounding has put across the interface beside it.
TEST(FaceRegions, AreThoseAtTheirMiddleWhereEdgesDisagree)
{
  for (const Id region : { 0, 1 })
  {
    Halves halves;
    halves.Diagonal().LeftRegion = region;
    halves.Diagonal().RightRegion = region;
    EXPECT_EQ(halves.FaceRegions(), (Numbers{ 0, 1 })) << region;
  }
}

TEST(FaceRegions, AreThoseAtTheirMiddleWhereEdgesHaveNone)
{
  Halves halves;
  for (RegionEdge& edge : halves.Edges.Edges)
  {
    edge.LeftRegion = NoId;
    edge.RightRegion = NoId;
  }
  EXPECT_EQ(halves.FaceRegions(), (Numbers{ 0, 1 }));
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
