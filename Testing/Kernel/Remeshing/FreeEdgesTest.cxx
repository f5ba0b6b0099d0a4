// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/FreeEdges.h"
#include "../Support/Monitors.h"
#include "Base/DistanceToSegment.h"
#include "Predicates/Predicates.h"
#include "Quality/TriangleLinks.h"

#include <gtest/gtest.h>

#include <cmath>  // for lengths
#include <random> // for places

namespace biting
{

namespace
{

OldMesh MeshOf(std::vector<Point2> points, std::vector<Id> corners)
{
  OldMesh mesh;
  mesh.Points = std::move(points);
  mesh.Corners = std::move(corners);
  mesh.Neighbors = LinkTriangles(mesh.Corners, mesh.NumberOfVertices()).Neighbors;
  return mesh;
}

bool AreApart(const OldMesh& mesh, double distance)
{
  Pulse pulse(NoMonitor());
  return FreeEdges(mesh).AreApart(distance, pulse);
}

bool BoundOnce(const OldMesh& mesh)
{
  Pulse pulse(NoMonitor());
  return FreeEdges(mesh).BoundOnce(pulse);
}

/// Whether an end of one edge, that the other has not, is near to it, or both meet.
bool AreNear(const FreeEdges& edges, const SegmentEnds& one, const SegmentEnds& other, double near)
{
  const auto place = [&edges](Id point) { return edges.Points[point]; };
  bool areNear = false;
  for (const auto& [a, b] : { std::make_pair(one, other), std::make_pair(other, one) })
  {
    for (const Id end : { a.Start, a.End })
    {
      areNear = areNear ||
        (!b.Has(end) &&
          (DistanceToSegment(place(end), place(b.Start), place(b.End)) <= near ||
            IsOnSegment(place(end), place(b.Start), place(b.End))));
    }
  }
  const bool share = other.Has(one.Start) || other.Has(one.End);
  return areNear ||
    (!share &&
      Meet(place(one.Start), place(one.End), place(other.Start), place(other.End)) !=
        Meeting::None);
}

/// By all pairs.
bool AreFarApart(const FreeEdges& edges, double distance)
{
  for (std::size_t k = 0; k < edges.Ends.size(); ++k)
  {
    const SegmentEnds& one = edges.Ends[k];
    if (Distance(edges.Points[one.Start], edges.Points[one.End]) <= 2.0 * distance)
    {
      return false;
    }
    for (std::size_t j = 0; j < k; ++j)
    {
      if (AreNear(edges, one, edges.Ends[j], distance))
      {
        return false;
      }
    }
  }
  return true;
}

/// A triangle about the middle: the larger, the larger.
void AddRing(double size, OldMesh& mesh)
{
  const Id first = mesh.NumberOfVertices();
  mesh.Points.insert(mesh.Points.end(), { { -size, -size }, { size, -size }, { 0.0, size } });
  mesh.Corners.insert(mesh.Corners.end(), { first, first + 1, first + 2 });
  mesh.Neighbors.insert(mesh.Neighbors.end(), 3, NoId);
}

} // namespace

TEST(FreeEdges, AreApartWhereAllPairsAre)
{
  std::mt19937 random(5);
  int apart = 0;
  int unequal = 0; // in roundings
  for (int round = 0; round < 4000; ++round)
  {
    // Few triangles over points of a grid, some of them moved a little.
    std::uniform_int_distribution<int> coordinate(0, 12);
    std::uniform_int_distribution<Id> vertex(0, 9);
    std::vector<Point2> points;
    for (int k = 0; k < 10; ++k)
    {
      const double shift = random() % 3 == 0 ? 1e-3 : 0.0;
      points.push_back({ coordinate(random) + shift, static_cast<double>(coordinate(random)) });
    }
    std::vector<Id> corners;
    for (int k = 0; k < 2; ++k)
    {
      const Id first = vertex(random);
      corners.insert(
        corners.end(), { first, (first + 1 + vertex(random) % 4) % 10, (first + 6) % 10 });
    }
    const OldMesh mesh = MeshOf(points, corners);
    for (const double distance : { 0.0, 1e-2 })
    {
      const bool areApart = AreFarApart(FreeEdges(mesh), distance);
      EXPECT_TRUE(areApart || !AreApart(mesh, distance)) << round;
      unequal += areApart != AreApart(mesh, distance);
      apart += areApart;
    }
  }
  EXPECT_LT(unequal, 5);
  EXPECT_GT(apart, 1000);
  EXPECT_LT(apart, 7000);
}

TEST(FreeEdges, AreNotApartWhereVerticesHangOnThem)
{
  const std::vector<Id> corners{ 0, 1, 2, 1, 0, 3 };
  EXPECT_TRUE(AreApart(MeshOf({ { 0, 0 }, { 4, 0 }, { 2, 2 }, { 2, -1 } }, corners), 1e-9));
  const std::vector<Id> hanging{ 0, 1, 2, 3, 4, 5 };
  for (const double gap : { 0.0, 5e-10, 2e-9 })
  {
    const OldMesh mesh =
      MeshOf({ { 0, 0 }, { 4, 0 }, { 2, 2 }, { 3, -gap }, { 1, -gap }, { 2, -1 } }, hanging);
    EXPECT_EQ(AreApart(mesh, 1e-9), gap > 1e-9);
    EXPECT_EQ(AreApart(mesh, 0.0), gap > 0.0);
  }
  // An end of the shorter of two at one vertex.
  const OldMesh fan =
    MeshOf({ { 0, 0 }, { 4, 0 }, { 2, 2 }, { 1, -1e-10 }, { 1, -1 } }, { 0, 1, 2, 0, 4, 3 });
  EXPECT_TRUE(AreApart(fan, 0.0));
  EXPECT_FALSE(AreApart(fan, 1e-9));
}

TEST(FreeEdges, AreNearByThemselves)
{
  // Two triangles with sides that are near, and a third far off.
  const OldMesh mesh = MeshOf({ { 0, 0 }, { 4, 0 }, { 2, 2 }, { 3, -1e-9 }, { 1, -1e-9 }, { 2, -1 },
                                { 9, 0 }, { 10, 0 }, { 9, 1 } },
    { 0, 1, 2, 3, 4, 5, 6, 7, 8 });
  Pulse pulse(NoMonitor());
  const FreeEdges edges(mesh);
  const std::vector<std::uint8_t> areNear = edges.FindNear(1e-6, pulse);
  EXPECT_EQ(areNear, (std::vector<std::uint8_t>{ 0, 0, 1, 1, 1, 1, 0, 0, 0 }));
  EXPECT_EQ(edges.FindNear(0.0, pulse), std::vector<std::uint8_t>(9, 0));
  EXPECT_NEAR(edges.LengthOf(areNear), 4.0 + 2.0 + 2.0 * std::sqrt(2.0), 1e-8);
}

TEST(FreeEdges, MayTouchInVerticesOfTwoParts)
{
  std::vector<Point2> points{ { 0, 0 } };
  std::vector<Id> corners;
  for (const double sign : { 1.0, -1.0, 2.0 })
  {
    const auto first = static_cast<Id>(points.size());
    points.insert(points.end(), { { sign, sign - 0.5 }, { sign, sign + 0.5 } });
    corners.insert(corners.end(), { 0, first + (sign < 0.0), first + (sign > 0.0) });
    const OldMesh mesh = MeshOf(points, corners);
    EXPECT_EQ(AreApart(mesh, 0.0), sign < 2.0);
    if (sign < 2.0)
    {
      EXPECT_TRUE(BoundOnce(mesh));
    }
  }
}

TEST(FreeEdges, BoundOnceWhereNoTriangleLiesOnOthers)
{
  OldMesh mesh;
  for (const double size : { 1.0, 4.0, 16.0 }) // the plane is covered up to three times
  {
    AddRing(size, mesh);
    EXPECT_TRUE(AreApart(mesh, 1e-3));
    EXPECT_EQ(BoundOnce(mesh), size == 1.0);
  }
  // A triangle in the hole of a frame.
  const OldMesh frame = MeshOf({ { 0, 0 }, { 9, 0 }, { 0, 9 }, { 1, 1 }, { 5, 1 }, { 1, 5 },
                                 { 1.5, 1.5 }, { 3, 1.5 }, { 1.5, 3 } },
    { 0, 1, 3, 1, 4, 3, 1, 2, 4, 2, 5, 4, 2, 0, 5, 0, 3, 5, 6, 7, 8 });
  EXPECT_TRUE(AreApart(frame, 1e-3));
  EXPECT_TRUE(BoundOnce(frame));
  EXPECT_DOUBLE_EQ(FreeEdges(frame).Area(), 40.5 - 8.0 + 1.125);
  EXPECT_EQ(FreeEdges(frame).Points.size(), 9u);
}

TEST(FreeEdges, AreNeitherWhereTheMonitorWantsToStop)
{
  OldMesh mesh;
  AddRing(1.0, mesh);
  StoppingMonitor monitor(0);
  Pulse pulse(monitor);
  pulse.Ask();
  EXPECT_FALSE(FreeEdges(mesh).AreApart(0.0, pulse));
  EXPECT_EQ(FreeEdges(mesh).FindNear(0.0, pulse), (std::vector<std::uint8_t>(3, 1)));
  EXPECT_FALSE(FreeEdges(mesh).BoundOnce(pulse));
}

} // namespace biting
