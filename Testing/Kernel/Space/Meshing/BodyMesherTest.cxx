// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Space/Meshing/BodyMesher.h"
#include "Predicates/Predicates3.h"
#include "Space/Surface/SurfaceShapes.h"
#include "Support/TestThreads.h"

#include <gtest/gtest.h>

#include <algorithm> // for sort, set_difference
#include <array>     // for corners
#include <map>       // for volumes
#include <utility>   // for pairs

namespace biting
{

namespace
{

/// Bodies with values of their triangles.
struct ValuedSoup
{
  Soup Shape;
  std::vector<Id> Values;

  void Add(const Soup& other, Id value)
  {
    for (std::size_t t = 0; t < other.Mesh.NumberOfTriangles(); ++t)
    {
      const std::array<Point3, 3> corners = other.Mesh.Triangle(t);
      this->Shape.Add(corners[0], corners[1], corners[2]);
      this->Values.push_back(value);
    }
  }
};

struct MeshedBody
{
  BitingBody Mesh;
  ProblemList Problems;

  Point3 At(std::size_t corner) const
  {
    return this->Mesh.Points[static_cast<std::size_t>(this->Mesh.Corners[corner])];
  }

  std::array<Id, 4> Tet(std::size_t tet) const
  {
    const Id* corners = &this->Mesh.Corners[4 * tet];
    return { corners[0], corners[1], corners[2], corners[3] };
  }

  std::map<Id, double> Volumes() const
  {
    std::map<Id, double> volumes;
    for (std::size_t tet = 0; tet < this->Mesh.Regions.size(); ++tet)
    {
      const Point3 a = this->At(4 * tet);
      volumes[this->Mesh.Regions[tet]] +=
        Dot(
          Cross(this->At(4 * tet + 1) - a, this->At(4 * tet + 2) - a), this->At(4 * tet + 3) - a) /
        6.0;
    }
    return volumes;
  }
};

/// Holes that are narrow for the size are closed.
MeshedBody MakeBody(const ValuedSoup& soup, double size, Monitor& monitor = NoMonitor(),
  BodyMesherOptions options = {})
{
  options.Surface.Spacing = [size](const Point3&) { return size; };
  const CheckedSurface surface =
    Judge(soup.Shape, 1e-12, NoMonitor(), options.Surface.Spacing).Surface;
  for (const Id cell : surface.Mesh.Cells)
  {
    if (!soup.Values.empty())
    {
      options.Surface.Regions.push_back(soup.Values[static_cast<std::size_t>(cell)]);
    }
  }
  MeshedBody meshed;
  meshed.Mesh = MakeBitingBody(surface, options, meshed.Problems, monitor);
  return meshed;
}

ValuedSoup Plain(const Soup& soup)
{
  return { soup, {} };
}

Soup BoxBetween(const Point3& low, const Point3& high)
{
  Soup soup;
  soup.AddBox(low, high);
  return soup;
}

/// From the lowest corner on, in their orientation.
std::array<Id, 3> Turned(std::array<Id, 3> corners)
{
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// The facets of tetrahedra that no other one of the same region has, away from them; those between
/// regions away from the lower one.
std::vector<std::array<Id, 3>> OuterFacets(const MeshedBody& meshed)
{
  std::map<std::array<Id, 3>, Id> regions;
  for (std::size_t tet = 0; tet < meshed.Mesh.Regions.size(); ++tet)
  {
    const std::array<Id, 4> t = meshed.Tet(tet);
    for (const std::array<Id, 3>& facet : { std::array<Id, 3>{ t[1], t[2], t[3] },
           { t[0], t[3], t[2] }, { t[0], t[1], t[3] }, { t[0], t[2], t[1] } })
    {
      EXPECT_TRUE(regions.emplace(Turned(facet), meshed.Mesh.Regions[tet]).second);
    }
  }
  std::vector<std::array<Id, 3>> outer;
  for (const auto& [facet, region] : regions)
  {
    const auto other = regions.find({ facet[0], facet[2], facet[1] });
    if (other == regions.end() || region < other->second)
    {
      outer.push_back(facet);
    }
  }
  return outer;
}

void ExpectSound(const MeshedBody& meshed)
{
  ASSERT_FALSE(meshed.Problems.HasErrors());
  ASSERT_FALSE(meshed.Mesh.Corners.empty());
  bool isPositive = true;
  for (std::size_t corner = 0; corner < meshed.Mesh.Corners.size(); corner += 4)
  {
    isPositive = isPositive &&
      Orient3D(
        meshed.At(corner), meshed.At(corner + 1), meshed.At(corner + 2), meshed.At(corner + 3)) > 0;
  }
  EXPECT_TRUE(isPositive);
  const BitingSurface& boundary = meshed.Mesh.Boundary;
  std::vector<std::array<Id, 3>> facets;
  for (std::size_t slot = 0; slot < boundary.Corners.size(); slot += 3)
  {
    facets.push_back(
      Turned({ boundary.Corners[slot], boundary.Corners[slot + 1], boundary.Corners[slot + 2] }));
    const std::array<Id, 4> cell =
      meshed.Tet(static_cast<std::size_t>(meshed.Mesh.BoundaryCells[slot / 3]));
    for (std::size_t k = slot; k < slot + 3; ++k)
    {
      EXPECT_EQ(std::count(cell.begin(), cell.end(), boundary.Corners[k]), 1);
    }
  }
  std::sort(facets.begin(), facets.end());
  EXPECT_EQ(facets, OuterFacets(meshed));
  EXPECT_TRUE(
    std::equal(boundary.Points.begin(), boundary.Points.end(), meshed.Mesh.Points.begin()));
  EXPECT_EQ(boundary.Triangles.size(), facets.size());
}

} // namespace

TEST(BodyMesher, FillsABoxExactly)
{
  const MeshedBody meshed = MakeBody(Plain(BoxBetween({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 })), 0.15);
  ExpectSound(meshed);
  ASSERT_EQ(meshed.Volumes().size(), 1u);
  EXPECT_NEAR(meshed.Volumes()[0], 1.0, 1e-12);
  EXPECT_GT(meshed.Mesh.Points.size(), meshed.Mesh.Boundary.Points.size());
}

TEST(BodyMesher, LeavesCavitiesEmpty)
{
  ValuedSoup soup;
  soup.Add(Sphere(1.0, 24), 0);
  soup.Add(Sphere(0.5, 16), 0);
  soup.Values.clear();
  const MeshedBody meshed = MakeBody(soup, 0.2);
  ExpectSound(meshed);
  ASSERT_EQ(meshed.Volumes().size(), 1u);
  EXPECT_NEAR(meshed.Volumes()[0], 3.665, 0.15);
}

TEST(BodyMesher, NumbersBodiesAndNamesNestedRegions)
{
  ValuedSoup apart;
  apart.Add(BoxBetween({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }), 0);
  apart.Add(BoxBetween({ 2.0, 0.0, 0.0 }, { 3.0, 1.0, 2.0 }), 0);
  apart.Values.clear();
  MeshedBody meshed = MakeBody(apart, 0.3);
  ExpectSound(meshed);
  EXPECT_NEAR(meshed.Volumes()[0], 1.0, 1e-12);
  EXPECT_NEAR(meshed.Volumes()[1], 2.0, 1e-12);

  ValuedSoup nested;
  nested.Add(BoxBetween({ 0.0, 0.0, 0.0 }, { 3.0, 3.0, 3.0 }), 7);
  nested.Add(BoxBetween({ 1.0, 1.0, 1.0 }, { 2.0, 2.0, 2.0 }), 4);
  nested.Add(BoxBetween({ 1.4, 1.4, 1.4 }, { 1.8, 1.8, 1.8 }), 4);
  meshed = MakeBody(nested, 0.3);
  ExpectSound(meshed);
  ASSERT_EQ(meshed.Volumes().size(), 2u);
  EXPECT_NEAR(meshed.Volumes()[4], 1.0 - 0.064, 1e-12);
  EXPECT_NEAR(meshed.Volumes()[7], 26.0, 1e-11);
}

TEST(BodyMesher, GivesWallsThatBodiesShareAsFacesOfBoth)
{
  // Three materials meet at an edge; shared walls are given twice.
  ValuedSoup soup;
  soup.Add(BoxBetween({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }), 2);
  soup.Add(BoxBetween({ 1.0, 0.0, 0.0 }, { 2.0, 1.0, 1.0 }), 1);
  soup.Add(BoxBetween({ 0.0, 1.0, 0.0 }, { 1.0, 2.0, 1.0 }), 9);
  MeshedBody meshed = MakeBody(soup, 0.25);
  ExpectSound(meshed);
  ASSERT_EQ(meshed.Volumes().size(), 3u);
  for (const Id region : { 1, 2, 9 })
  {
    EXPECT_NEAR(meshed.Volumes()[region], 1.0, 1e-12) << region;
  }
  soup.Values.clear();
  meshed = MakeBody(soup, 0.25);
  ExpectSound(meshed);
  for (const Id region : { 0, 1, 2 })
  {
    EXPECT_NEAR(meshed.Volumes()[region], 1.0, 1e-12) << region;
  }
}

TEST(BodyMesher, GivesTheSameBytesForAnyThreadsAndFarFromTheOrigin)
{
  const ValuedSoup soup = Plain(BoxBetween({ 0.0, 0.0, 0.0 }, { 1.0, 2.0, 0.5 }));
  const MeshedBody first = MakeBody(soup, 0.15);
  for (const int threads : { 2, 8 })
  {
    MonitorWithThreads monitor(threads);
    const MeshedBody other = MakeBody(soup, 0.15, monitor);
    EXPECT_EQ(first.Mesh.Points, other.Mesh.Points) << threads;
    EXPECT_EQ(first.Mesh.Corners, other.Mesh.Corners) << threads;
  }
  const double far = 1048576.0;
  const MeshedBody moved =
    MakeBody(Plain(BoxBetween({ far, far, far }, { far + 1.0, far + 2.0, far + 0.5 })), 0.15);
  ExpectSound(moved);
  EXPECT_NEAR(moved.Volumes()[0], 1.0, 1e-8);
}

TEST(BodyMesher, RefusesWhatCannotBeWithAReason)
{
  Soup open = BoxBetween({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  open.Remove(0);
  const auto refuses = [](const ValuedSoup& soup, double size, ProblemCode code)
  {
    BodyMesherOptions options;
    options.Surface.MaximumNumberOfVertices = 10000;
    const MeshedBody meshed = MakeBody(soup, size, NoMonitor(), options);
    return meshed.Problems.Has(code) && meshed.Mesh.Points.empty();
  };
  const ValuedSoup box = Plain(BoxBetween({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }));
  EXPECT_TRUE(refuses(Plain(open), 0.2, ProblemCode::OpenEdges));
  const Problem hole = MakeBody(Plain(open), 0.2).Problems.Groups().front().First.front();
  EXPECT_EQ(hole.Place.X, 0.0); // of the triangle that is missing
  EXPECT_TRUE(refuses(box, 0.001, ProblemCode::TooManyVertices));
  EXPECT_TRUE(refuses(box, 0.03, ProblemCode::TooManyVertices)); // inside only
  EXPECT_TRUE(refuses(box, 0.0, ProblemCode::BadSpacing));
  Soup near = BoxBetween({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  near.AddBox({ 0.0, 0.0, 1.0001 }, { 1.0, 1.0, 2.0 });
  EXPECT_TRUE(refuses(Plain(near), 0.5, ProblemCode::TooThin));
  EXPECT_TRUE(MakeBody({}, 0.1).Problems.Groups().empty());
}

TEST(BodyMesher, FillsABodyWithSmallHolesAsTheWholeOne)
{
  const double whole = MakeBody(Plain(Sphere(1.0, 40)), 0.25).Volumes()[0];
  Dice dice(5);
  for (int round = 0; round < 4; ++round)
  {
    Soup soup = Sphere(1.0, 40);
    for (int k = 0; k < 40; ++k)
    {
      soup.Remove(static_cast<std::size_t>(dice.Below(3120 - k)));
    }
    const MeshedBody meshed = MakeBody(Plain(soup), 0.25);
    ExpectSound(meshed);
    ASSERT_EQ(meshed.Volumes().size(), 1u);
    EXPECT_NEAR(meshed.Volumes().at(0), whole, 0.005 * whole);
  }
}

TEST(BodyMesher, FillsABodyWhoseSidesDoNotMatchAtCracks)
{
  ValuedSoup soup;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    soup.Shape.AddSide(
      { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, axis, false, 2 + static_cast<int>(axis));
    soup.Shape.AddSide(
      { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, axis, true, 7 + static_cast<int>(axis));
  }
  for (const double off : { 0.0, 1e-6, 1e-3 })
  {
    ValuedSoup moved = soup;
    Dice dice(9);
    for (Point3& point : moved.Shape.Mesh.Points)
    {
      point = point + off * Point3{ dice.Unit(), dice.Unit(), dice.Unit() };
    }
    const MeshedBody meshed = MakeBody(moved, 0.2);
    ExpectSound(meshed);
    EXPECT_NEAR(meshed.Volumes()[0], 1.0, 6.0 * off + 1e-12) << off;
    EXPECT_EQ(meshed.Problems.Groups().size(), 0u) << off;
  }
}

/// Two tetrahedra on the two sides of a plane share an edge; their bases in the plane overlap.
TEST(BodyMesher, CallsTrianglesThatLieOnEachOtherAtACrowdedEdgeFolds)
{
  const auto tetrahedron = [](double depth, double height)
  {
    const Point3 a = { 0.0, 0.0, 0.0 };
    const Point3 b = { 1.0, 0.0, 0.0 };
    const Point3 c = { 0.3, depth, 0.0 };
    const Point3 d = { 0.3, 0.3 * depth, height };
    Soup soup;
    soup.Add(a, b, c);
    soup.Add(a, d, b);
    soup.Add(b, d, c);
    soup.Add(c, d, a);
    return soup;
  };
  bool isFolded = false;
  for (const double up : { -1.0, 1.0 })
  {
    ValuedSoup pair; // beside another one, from which angles are measured
    pair.Add(tetrahedron(-1.0, 1.0), 3);
    pair.Add(tetrahedron(0.5, up), 1);
    pair.Add(tetrahedron(1.0, -up), 2);
    const MeshedBody meshed = MakeBody(pair, 0.2);
    EXPECT_FALSE(meshed.Problems.Has(ProblemCode::OpenEdges));
    isFolded = isFolded || meshed.Problems.Has(ProblemCode::Folds);
  }
  EXPECT_TRUE(isFolded);
}

TEST(BodyMesher, StopsAfterAsManyBitesAsWanted)
{
  BodyMesherOptions options;
  options.MaximumNumberOfBites = 900;
  options.Surface.KeepBites = true;
  const MeshedBody meshed =
    MakeBody(Plain(BoxBetween({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 })), 0.1, NoMonitor(), options);
  ExpectSound(meshed);
  EXPECT_GE(meshed.Mesh.BiteCenters.size(), 900u);
  EXPECT_LE(meshed.Mesh.BiteCenters.size(), 901u);
  EXPECT_NEAR(meshed.Volumes()[0], 1.0, 1e-12);
}

/// Wants to stop when it is asked for that time.
class StopBodyAt : public SilentMonitor
{
public:
  explicit StopBodyAt(int time)
    : Left(time)
  {
  }
  bool Advance(double) override { return --this->Left > 0; }

  int Left;
};

TEST(BodyMesher, GivesNoMeshWhenItIsStopped)
{
  const ValuedSoup soup = Plain(BoxBetween({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }));
  const auto most = 1000000;
  StopBodyAt never(most);
  EXPECT_FALSE(MakeBody(soup, 0.25, never).Mesh.Points.empty());
  const int asked = most - never.Left;
  for (int time = 1; time <= asked; time += 1 + asked / 40)
  {
    StopBodyAt monitor(time);
    const MeshedBody meshed = MakeBody(soup, 0.25, monitor);
    EXPECT_TRUE(meshed.Mesh.Points.empty()) << time;
    EXPECT_TRUE(meshed.Problems.Has(ProblemCode::Aborted)) << time;
  }
}

} // namespace biting
