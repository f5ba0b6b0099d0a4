// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Relaxation/HeldVertices.h"
#include "RawMesh.h"
#include "Relaxation/StarObjective.h"

#include <gtest/gtest.h>

#include <algorithm> // for find

namespace biting
{

namespace
{

/// How many of the vertices that are held are no more where they were.
Id CountMoved(const HoldOptions& hold)
{
  RawMesh raw = UnitSquare(0.05);
  const std::vector<Point2> before = raw.Mesh.Points;
  const std::vector<Id> segments = raw.Mesh.Segments;
  RelaxationOptions options;
  options.Hold = hold;
  raw.Relax(options);
  EXPECT_EQ(raw.Violation(true), "");
  const Id first = raw.Domain.NumberOfVertices();
  Id moved = 0;
  for (Id vertex = first; vertex < first + hold.Count; ++vertex)
  {
    const auto end = raw.Mesh.Points.end();
    const bool isThere = std::find(raw.Mesh.Points.begin(), end, before[vertex]) != end;
    moved += isThere || segments[vertex] != NoId ? 0 : 1;
  }
  return moved;
}

Id CountNew(const RawMesh& raw)
{
  return static_cast<Id>(raw.Mesh.Points.size()) - raw.Domain.NumberOfVertices();
}

TEST(HeldVertices, StayWhereTheyAreWhereNoneIsReleased)
{
  const Id count = CountNew(UnitSquare(0.05)) / 2;
  EXPECT_EQ(CountMoved({ count, 0.0, 10.0, 0.0, 0 }), 0);
  EXPECT_EQ(CountMoved({ count, NoCotangent, 0.0, NoCotangent, 4 }), 0);
}

TEST(HeldVertices, StricterLimitsReleaseMore)
{
  const Id count = CountNew(UnitSquare(0.05)) / 2;
  const Id few = CountMoved({ count, CotangentOf30Degrees, 0.6, 1.6, 4 });
  const Id more = CountMoved({ count, CotangentOf40Degrees, 0.8, 1.3, 4 });
  EXPECT_GT(few, 0);
  EXPECT_GT(more, few);
  EXPECT_LT(more, count);
}

/// Of the vertices with odd numbers: how many are released, as last ones or not.
Id CountOddOnesReleased(bool areLast)
{
  RawMesh raw = UnitSquare(0.05);
  SilentMonitor monitor;
  Pulse pulse(monitor);
  MutableMesh mesh(raw.Domain, raw.Spacing);
  mesh.IsDivided.assign(4, 1);
  const Id count = CountNew(raw);
  const Id first = raw.Domain.NumberOfVertices();
  const std::vector<Id> origins = ReadMesh(raw.Mesh, mesh, pulse);
  HoldOptions hold{ count, CotangentOf35Degrees, 0.0, NoCotangent, 1 };
  for (Id vertex = 0; areLast && vertex < count; ++vertex)
  {
    hold.AreLast.push_back(vertex % 2);
  }
  HeldVertices held(hold, first, origins, mesh);
  Id odd = 0;
  for (const Id vertex : held.ReleaseThoseInTheWay(pulse))
  {
    odd += (origins[vertex] - first) % 2;
  }
  return odd;
}

TEST(HeldVertices, LastOnesAreReleasedMoreSeldom)
{
  const Id last = CountOddOnesReleased(true);
  EXPECT_GT(last, 0);
  EXPECT_LT(last, CountOddOnesReleased(false));
}

TEST(HeldVertices, OfEachPoorTriangleAtMostOneIsReleasedAtATime)
{
  RawMesh raw = UnitSquare(0.05);
  SilentMonitor monitor;
  Pulse pulse(monitor);
  MutableMesh mesh(raw.Domain, raw.Spacing);
  mesh.IsDivided.assign(4, 1);
  const Id count = CountNew(raw);
  const std::vector<Id> origins = ReadMesh(raw.Mesh, mesh, pulse);
  const Id first = raw.Domain.NumberOfVertices();
  const HoldOptions hold{ count, CotangentOf35Degrees, 0.0, NoCotangent, 1 };
  HeldVertices held(hold, first, origins, mesh);
  const std::vector<Id> released = held.ReleaseThoseInTheWay(pulse);
  EXPECT_FALSE(released.empty());
  for (const Id vertex : released)
  {
    EXPECT_EQ(mesh.Freedoms[vertex], Freedom::Free);
    bool isInTheWay = false;
    mesh.ForEachAround(vertex,
      [&mesh, &released, &hold, &isInTheWay](Id edge)
      {
        const Id triangle = MutableMesh::TriangleOf(edge);
        if (IsWorseThan(mesh, triangle, hold.GreatestCotangent))
        {
          isInTheWay = true;
          for (const Id other : { mesh.Origin(edge), mesh.Target(edge) })
          {
            EXPECT_EQ(std::find(released.begin(), released.end(), other), released.end());
          }
        }
      });
    EXPECT_TRUE(isInTheWay);
  }
}

TEST(HeldVertices, ThatWereReleasedComeBackWhereThatIsWithinTheLimits)
{
  RawMesh raw = UnitSquare(0.05);
  SilentMonitor monitor;
  Pulse pulse(monitor);
  MutableMesh mesh(raw.Domain, raw.Spacing);
  mesh.IsDivided.assign(4, 1);
  const Id count = CountNew(raw);
  const std::vector<Id> origins = ReadMesh(raw.Mesh, mesh, pulse);
  HoldOptions hold{ count, CotangentOf40Degrees, 0.0, NoCotangent, 1 };
  HeldVertices held(hold, raw.Domain.NumberOfVertices(), origins, mesh);
  ASSERT_FALSE(held.ReleaseThoseInTheWay(pulse).empty());
  for (const HeldVertices::Released& released : held.ListReleased())
  {
    const auto comesBack = [&](double cotangent, double longest)
    {
      hold.GreatestCotangent = cotangent;
      hold.LongestEdge = longest;
      return held.TakeBack(released);
    };
    EXPECT_FALSE(comesBack(0.0, NoCotangent)); // it is there, and that is not better
    mesh.Move(released.Vertex, released.Home + Point2{ 1e-3, 1e-3 });
    EXPECT_FALSE(comesBack(NoCotangent, 0.1));
    EXPECT_TRUE(comesBack(NoCotangent, NoCotangent));
    EXPECT_EQ(mesh.Points[released.Vertex], released.Home);
    EXPECT_EQ(mesh.Freedoms[released.Vertex], Freedom::Fixed);
    EXPECT_FALSE(comesBack(NoCotangent, NoCotangent));
  }
}

TEST(HeldVertices, FreeOnesGoToPlacesNearThemWhereThatIsWithinTheLimits)
{
  RawMesh raw = UnitSquare(0.05);
  SilentMonitor monitor;
  Pulse pulse(monitor);
  MutableMesh mesh(raw.Domain, raw.Spacing);
  mesh.IsDivided.assign(4, 1);
  const std::vector<Id> origins = ReadMesh(raw.Mesh, mesh, pulse);
  Point2 place;
  const Point2* found = nullptr;
  HoldOptions hold{ 1, NoCotangent, 0.0, NoCotangent, 1 };
  hold.FindPlace = [&found](const Point2&, double) { return found; };
  HeldVertices held(hold, raw.Domain.NumberOfVertices(), origins, mesh);
  int count = 0;
  for (Id vertex = 0; vertex < static_cast<Id>(mesh.Points.size()); ++vertex)
  {
    const bool isFree = mesh.Freedoms[vertex] == Freedom::Free;
    place = mesh.Points[vertex] + Point2{ 1e-5, 1e-5 };
    found = nullptr;
    EXPECT_FALSE(isFree && held.HoldAtPlaceNear(vertex));
    found = &place;
    hold.GreatestCotangentAtPlaces = 0.5; // of no triangle
    EXPECT_FALSE(held.HoldAtPlaceNear(vertex));
    hold.GreatestCotangentAtPlaces = NoCotangent;
    EXPECT_EQ(held.HoldAtPlaceNear(vertex), isFree);
    EXPECT_EQ(mesh.Points[vertex] == place, isFree);
    EXPECT_NE(mesh.Freedoms[vertex], Freedom::Free);
    count += isFree;
  }
  EXPECT_GT(count, 100);
}

} // namespace

} // namespace biting
