// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Space/Union/SurfaceUnion.h"
#include "Space/Surface/SurfaceShapes.h"
#include "Space/Union/ResolveCrossings.h"
#include "Space/Union/SmallCrossings.h"
#include "Space/Union/WindingNumber.h"

#include <gtest/gtest.h>

#include <algorithm> // for any_of
#include <array>     // for boxes
#include <cmath>     // for turns

namespace biting
{

namespace
{

constexpr double Noise = 1e-14;

void Append(Soup& soup, const Soup& other, const Point3& shift)
{
  for (std::size_t t = 0; t < other.Mesh.NumberOfTriangles(); ++t)
  {
    const std::array<Point3, 3> corners = other.Mesh.Triangle(t);
    soup.Add(corners[0] + shift, corners[1] + shift, corners[2] + shift);
  }
}

/// Turned about two axes.
Soup Oblique(Soup soup)
{
  for (Point3& p : soup.Mesh.Points)
  {
    p = { 0.8 * p.X - 0.6 * p.Y, 0.6 * p.X + 0.8 * p.Y, p.Z };
    p = { p.X, std::cos(0.7) * p.Y - std::sin(0.7) * p.Z,
      std::sin(0.7) * p.Y + std::cos(0.7) * p.Z };
  }
  return soup;
}

/// The union, as it is checked.
Verdict United(const Soup& soup)
{
  const Verdict given = Judge(soup, Noise);
  Pulse pulse(NoMonitor());
  Soup united;
  united.Mesh = UniteSurfaces(given.Surface, Noise, pulse);
  return Judge(united, Noise);
}

/// The surface without crossings and touches, as far as these were resolved.
Verdict Resolved(const Soup& soup, double spacing)
{
  Verdict verdict = Judge(soup, Noise);
  SurfaceCheckOptions options;
  options.Noise = Noise;
  options.Spacing = [spacing](const Point3&) { return spacing; };
  ResolveCrossings(verdict.Surface, options, verdict.Problems, NoMonitor());
  return verdict;
}

bool IsSound(const Verdict& verdict)
{
  return verdict.Surface.Mesh.NumberOfTriangles() > 0 &&
    verdict.Count(ProblemCode::OpenEdges) == 0 && verdict.Count(ProblemCode::NotOrientable) == 0 &&
    verdict.Count(ProblemCode::SelfCrossings) == 0 && verdict.Count(ProblemCode::Folds) == 0;
}

int WindingAt(const SurfaceMesh& mesh, const Point3& place)
{
  Pulse pulse(NoMonitor());
  const BoxTree<SurfaceItem, 3> tree = MakeSurfaceTree(mesh, pulse);
  return WindingNumber(mesh, tree).At(place, 2, [](std::size_t) { return false; });
}

/// Boxes of whole numbers from 0 to 6, and the number of unit cubes in any of them.
struct Blocks
{
  Soup Surface;
  int Volume = 0;
  bool IsNested = false; ///< a box is in another one: it is a cavity, or not clear
};

using Ends = std::array<std::array<int, 3>, 2>; ///< of a box

bool IsIn(const Ends& one, const Ends& other)
{
  bool isIn = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    isIn = isIn && other[0][axis] <= one[0][axis] && one[1][axis] <= other[1][axis];
  }
  return isIn;
}

Blocks MakeBlocks(Dice& dice, int count)
{
  constexpr int Most = 7;
  Blocks blocks;
  std::vector<Ends> boxes;
  for (int box = 0; box < count; ++box)
  {
    Ends ends{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      ends[0][axis] = dice.Below(4);
      ends[1][axis] = ends[0][axis] + 1 + dice.Below(3);
    }
    for (const auto& other : boxes)
    {
      blocks.IsNested = blocks.IsNested || IsIn(ends, other) || IsIn(other, ends);
    }
    boxes.push_back(ends);
    const auto corner = [&ends](std::size_t k) {
      return Point3{ 1.0 * ends[k][0], 1.0 * ends[k][1], 1.0 * ends[k][2] };
    };
    blocks.Surface.AddBox(corner(0), corner(1));
  }
  for (int cube = 0; cube < Most * Most * Most; ++cube)
  {
    const std::array<int, 3> at{ cube % Most, cube / Most % Most, cube / Most / Most };
    blocks.Volume += std::any_of(boxes.begin(), boxes.end(),
                       [&at](const auto& ends)
                       {
                         bool isIn = true;
                         for (std::size_t axis = 0; axis < 3; ++axis)
                         {
                           isIn = isIn && ends[0][axis] <= at[axis] && at[axis] < ends[1][axis];
                         }
                         return isIn;
                       })
      ? 1
      : 0;
  }
  return blocks;
}

/// A box with a peak, and a vertex beside it that is moved through that.
Soup Peak()
{
  Soup peak;
  peak.AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, 8);
  for (Point3& p : peak.Mesh.Points)
  {
    p = p == Point3{ 0.5, 0.5, 1.0 }   ? Point3{ 0.5, 0.5, 1.08 }
      : p == Point3{ 0.625, 0.5, 1.0 } ? Point3{ 0.42, 0.5, 1.03 }
                                       : p;
  }
  return peak;
}

} // namespace

TEST(SurfaceUnion, HasTheVolumeOfBoxesAlsoWhereTheirSidesLieOnEachOther)
{
  Dice dice(3);
  int united = 0;
  for (int trial = 0; trial < 150; ++trial)
  {
    const Blocks blocks = MakeBlocks(dice, 2 + trial % 2);
    const Soup surface = trial % 3 == 0 ? Oblique(blocks.Surface) : blocks.Surface;
    if (blocks.IsNested || Judge(surface, Noise).Count(ProblemCode::SelfCrossings) == 0)
    {
      continue;
    }
    const Verdict verdict = United(surface);
    if (IsSound(verdict)) // else it is refused
    {
      ++united;
      EXPECT_NEAR(verdict.Figures().Volume, blocks.Volume, 1e-5) << trial;
    }
  }
  EXPECT_GT(united, 30);
}

TEST(SurfaceUnion, IsInsideWhereTheWindingNumberIsAboveZero)
{
  Soup soup;
  soup.AddBox({ -2.0, -2.0, -0.2 }, { 2.0, 2.0, 0.3 }, 3);
  Append(soup, Sphere(1.0, 12), { 0.1, 0.2, 0.3 });
  Append(soup, Sphere(0.9, 10), { 0.9, -0.2, 0.1 });
  const Soup turned = Oblique(soup);
  const Verdict given = Judge(turned, Noise);
  const Verdict verdict = United(turned);
  ASSERT_TRUE(IsSound(verdict));
  EXPECT_EQ(verdict.Figures().EulerNumber, 2);
  EXPECT_EQ(verdict.Figures().Parts, 1);
  Dice dice(5);
  const Box3 box = given.Surface.Mesh.Bounds();
  for (int trial = 0; trial < 300; ++trial)
  {
    const Point3 place{ dice.Between(box.Low.X, box.High.X), dice.Between(box.Low.Y, box.High.Y),
      dice.Between(box.Low.Z, box.High.Z) };
    EXPECT_EQ(WindingAt(verdict.Surface.Mesh, place), WindingAt(given.Surface.Mesh, place) > 0);
  }
}

TEST(SurfaceUnion, KeepsCavitiesWhateverTheOrientation)
{
  Soup soup = Sphere(1.0, 14);
  Append(soup, Sphere(0.7, 12), {});
  const Soup hollow = soup;
  soup.AddBox({ -2.0, -2.0, -0.1 }, { 2.0, 2.0, 0.1 });
  const Verdict verdict = United(soup);
  ASSERT_TRUE(IsSound(verdict));
  EXPECT_EQ(verdict.Figures().Cavities, 2);
  EXPECT_EQ(verdict.Figures().EulerNumber, 6);
  for (std::size_t t = 0; t < soup.Mesh.NumberOfTriangles(); ++t)
  {
    soup.Turn(t);
  }
  EXPECT_NEAR(United(soup).Figures().Volume, verdict.Figures().Volume, 1e-9);
  EXPECT_GT(verdict.Figures().Volume, Judge(hollow).Figures().Volume + 1.0);
}

TEST(SurfaceUnion, FillsATubeThatCrossesItself)
{
  // A bar from tower to tower, with a hook that comes back through it.
  Soup soup;
  const std::array<Point3, 6> way{ Point3{ 0.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 }, { 4.0, 3.0, 0.0 },
    { 2.0, 3.0, 0.1 }, { 2.0, -2.0, 0.1 }, { 1.0, -3.0, 0.1 } };
  const auto at = [&way](std::size_t k, std::size_t side)
  {
    const Point3 along = way[std::min<std::size_t>(k + 1, 5)] - way[k == 0 ? 0 : k - 1];
    const Point3 across = (0.4 / Length(along)) * Point3{ -along.Y, along.X, 0.0 };
    const double rise = side == 0 || side == 1 ? 0.3 : -0.3;
    return way[k] + (side == 0 || side == 3 ? -1.0 : 1.0) * across + Point3{ 0.0, 0.0, rise };
  };
  for (std::size_t side = 0; side < 4; ++side)
  {
    const std::size_t next = (side + 1) % 4;
    for (std::size_t k = 0; k + 1 < way.size(); ++k)
    {
      soup.Add(at(k, side), at(k + 1, side), at(k + 1, next));
      soup.Add(at(k, side), at(k + 1, next), at(k, next));
    }
  }
  soup.Add(at(0, 0), at(0, 1), at(0, 2));
  soup.Add(at(0, 0), at(0, 2), at(0, 3));
  soup.Add(at(5, 0), at(5, 2), at(5, 1));
  soup.Add(at(5, 0), at(5, 3), at(5, 2));
  const Verdict given = Judge(soup, Noise);
  EXPECT_GT(given.Count(ProblemCode::SelfCrossings), 0);
  EXPECT_EQ(given.Figures().EulerNumber, 2);
  const Verdict verdict = United(soup);
  ASSERT_TRUE(IsSound(verdict));
  EXPECT_EQ(verdict.Figures().EulerNumber, 0); // a ring
  EXPECT_LT(verdict.Figures().Volume, given.Figures().Volume - 0.1);
}

TEST(SurfaceUnion, GivesPiecesTheCellsOfTheirTriangles)
{
  Soup soup;
  soup.AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, 2);
  soup.AddBox({ 0.3, 0.4, 0.5 }, { 1.3, 1.4, 1.5 });
  const Verdict verdict = United(soup);
  ASSERT_TRUE(IsSound(verdict));
  const SurfaceMesh& mesh = verdict.Surface.Mesh;
  for (std::size_t t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const std::size_t cell = At(mesh.Cells[t]);
    const Point3 normal = soup.Mesh.Normal(cell);
    EXPECT_NEAR(Dot(mesh.Middle(t) - soup.Mesh.At(3 * cell), normal), 0.0, 1e-6);
    EXPECT_GT(Dot(mesh.Normal(t), normal), 0.0);
  }
}

TEST(SurfaceUnion, IsNotOfOpenSurfacesNorOfRegions)
{
  Soup soup;
  soup.AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  soup.AddBox({ 0.5, 0.5, 0.5 }, { 1.5, 1.5, 1.5 });
  Soup open = soup;
  open.Remove(3);
  EXPECT_EQ(United(open).Surface.Mesh.NumberOfTriangles(), 0u);
  soup.Mesh.Regions.assign(soup.Mesh.NumberOfTriangles(), { 0, NoId });
  EXPECT_EQ(United(soup).Surface.Mesh.NumberOfTriangles(), 0u);
}

TEST(SurfaceUnion, IsNotOfABoxThatWouldBeACavityWithoutAWall)
{
  Soup soup;
  soup.AddBox({ 0.0, 0.0, 0.0 }, { 3.0, 3.0, 3.0 });
  soup.AddBox({ 2.0, 2.0, 2.0 }, { 4.0, 4.0, 4.0 });
  Soup apart = soup;
  soup.AddBox({ 0.0, 1.0, 1.0 }, { 1.0, 1.5, 1.5 });
  apart.AddBox({ 0.5, 1.0, 1.0 }, { 1.0, 1.5, 1.5 });
  EXPECT_EQ(United(soup).Surface.Mesh.NumberOfTriangles(), 0u);
  EXPECT_NEAR(United(apart).Figures().Volume, 27.0 + 8.0 - 1.0 - 0.125, 1e-5);
}

TEST(SurfaceUnion, IsNotOfALobeThatIsInsideOut)
{
  // A prism over a polygon that crosses itself: one half of it is inside out.
  const std::array<Point3, 4> bow{ Point3{ 0.0, 0.0, 0.0 }, { 3.0, 2.0, 0.0 }, { 3.0, 0.0, 0.0 },
    { 0.0, 2.0, 0.0 } };
  const Point3 rise{ 0.0, 0.0, 1.0 };
  Soup soup;
  for (std::size_t k = 0; k < 4; ++k)
  {
    const Point3& next = bow[(k + 1) % 4];
    soup.Add(bow[k], next, next + rise);
    soup.Add(bow[k], next + rise, bow[k] + rise);
  }
  soup.Add(bow[0], bow[2], bow[1]);
  soup.Add(bow[0], bow[3], bow[2]);
  soup.Add(bow[0] + rise, bow[1] + rise, bow[2] + rise);
  soup.Add(bow[0] + rise, bow[2] + rise, bow[3] + rise);
  EXPECT_GT(Judge(soup, Noise).Surface.Crossings.size(), 0u);
  EXPECT_EQ(United(soup).Surface.Mesh.NumberOfTriangles(), 0u);
}

TEST(SmallCrossings, AreSmallAsTheRegionIsThatTheyBoundNotAsTheirCurve)
{
  Pulse pulse(NoMonitor());
  const auto isCutOut = [&pulse](const Soup& soup, double spacing)
  {
    const Verdict given = Judge(soup, Noise);
    EXPECT_GT(given.Surface.Crossings.size(), 0u);
    const SurfaceMesh left = CutOutCrossings(
      given.Surface, [spacing](const Point3&) { return spacing; }, pulse);
    return left.NumberOfTriangles() > 0;
  };
  EXPECT_TRUE(isCutOut(Peak(), 1.5));
  EXPECT_FALSE(isCutOut(Peak(), 0.2));
  // A spike through the other side crosses that in a small loop, but is long.
  Soup spike;
  spike.AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, 8);
  for (Point3& p : spike.Mesh.Points)
  {
    p = p == Point3{ 0.5, 0.5, 1.0 } ? Point3{ 0.52, 0.52, -1.0 } : p;
  }
  EXPECT_FALSE(isCutOut(spike, 1.5));
}

TEST(ResolveCrossings, ClosesWhatItCutsOutAndUnitesWhatIsLarge)
{
  const Verdict small = Resolved(Peak(), 1.5);
  EXPECT_TRUE(IsSound(small));
  EXPECT_GT(small.Count(ProblemCode::SmallCrossings), 0);
  EXPECT_EQ(small.Figures().EulerNumber, 2);
  EXPECT_NEAR(small.Figures().Volume, 1.0, 0.01);
  Soup boxes;
  boxes.AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  boxes.AddBox({ 0.5, 0.5, 0.5 }, { 1.5, 1.5, 1.5 });
  const Verdict united = Resolved(boxes, 0.1);
  EXPECT_TRUE(IsSound(united));
  EXPECT_GT(united.Count(ProblemCode::UnitedSurfaces), 0);
  EXPECT_NEAR(united.Figures().Volume, 1.875, 1e-6);
  boxes.Remove(0);
  const Verdict open = Resolved(boxes, 0.1);
  EXPECT_GT(open.Count(ProblemCode::SelfCrossings), 0);
}

TEST(ResolveCrossings, UnitesBodiesThatTouchLieInEachOtherFlushOrShareAnEdge)
{
  const Ends cube{ 0, 0, 0, 4, 4, 4 };
  const auto volume = [&cube](const std::vector<Ends>& others)
  {
    Soup soup;
    const auto add = [&soup](const Ends& ends)
    {
      soup.AddBox({ 0.25 * ends[0][0], 0.25 * ends[0][1], 0.25 * ends[0][2] },
        { 0.25 * ends[1][0], 0.25 * ends[1][1], 0.25 * ends[1][2] });
    };
    add(cube);
    std::for_each(others.begin(), others.end(), add);
    const Verdict verdict = Resolved(soup, 0.1);
    EXPECT_TRUE(IsSound(verdict));
    EXPECT_GT(verdict.Count(ProblemCode::UnitedSurfaces), 0);
    return verdict.Figures().Volume;
  };
  EXPECT_NEAR(volume({ { 4, 2, 0, 8, 6, 4 } }), 2.0, 1e-6); // half a side
  EXPECT_NEAR(volume({ { 2, 0, 0, 6, 4, 4 } }), 1.5, 1e-6); // four sides of both
  EXPECT_NEAR(volume({ { 4, 4, 1, 6, 8, 5 } }), 1.5, 1e-6); // a part of an edge
  EXPECT_NEAR(volume({ { 4, 4, 0, 8, 8, 4 }, { 2, 2, 1, 6, 6, 3 } }), 2.25, 1e-6); // an edge
  Soup hollow; // a cavity without a wall, or a body
  hollow.AddBox({ 0.0, 0.0, 0.0 }, { 4.0, 4.0, 4.0 });
  hollow.AddBox({ 1.0, 1.0, 0.0 }, { 3.0, 3.0, 2.0 });
  EXPECT_EQ(Resolved(hollow, 0.1).Count(ProblemCode::UnitedSurfaces), 0);
}

// The cavities stand on the bottom with one edge; shells that share an edge are nested as others.
TEST(ResolveCrossings, KeepsCavitiesThatTouchWhereShellsShareAnEdge)
{
  const Ends cube{ 0, 0, 0, 8, 8, 8 };
  const auto volume =
    [](const std::vector<Ends>& boxes, const std::vector<double>& prisms, bool isTurned)
  {
    Soup soup;
    for (const double x : prisms)
    {
      const std::array<Point3, 4> corners{ Point3{ x, 3.0, 0.0 }, { x + 1.5, 3.0, 1.5 },
        { x, 3.0, 3.0 }, { x - 1.5, 3.0, 1.5 } };
      const Point3 far{ 0.0, 2.0, 0.0 };
      for (std::size_t k = 0; k < 4; ++k)
      {
        const Point3& next = corners[(k + 1) % 4];
        soup.Add(corners[k], corners[k] + far, next + far);
        soup.Add(corners[k], next + far, next);
      }
      soup.Add(corners[0], corners[1], corners[2]);
      soup.Add(corners[0], corners[2], corners[3]);
      soup.Add(corners[0] + far, corners[2] + far, corners[1] + far);
      soup.Add(corners[0] + far, corners[3] + far, corners[2] + far);
    }
    for (std::size_t t = 0; t < soup.Mesh.NumberOfTriangles() && isTurned; ++t)
    {
      soup.Turn(t);
    }
    for (const Ends& ends : boxes)
    {
      soup.AddBox({ 1.0 * ends[0][0], 1.0 * ends[0][1], 1.0 * ends[0][2] },
        { 1.0 * ends[1][0], 1.0 * ends[1][1], 1.0 * ends[1][2] });
    }
    const Verdict verdict = Resolved(soup, 0.1);
    EXPECT_TRUE(IsSound(verdict));
    EXPECT_GT(verdict.Count(ProblemCode::UnitedSurfaces), 0);
    return verdict.Figures().Volume;
  };
  for (const bool isTurned : { false, true })
  {
    EXPECT_NEAR(volume({ cube, { 8, 8, 0, 12, 12, 8 } }, { 4.0 }, isTurned), 631.0, 1e-5);
    EXPECT_NEAR(volume({ cube }, { 2.5, 5.5 }, isTurned), 494.0, 1e-5);
  }
  EXPECT_NEAR(
    volume({ cube, { 1, 1, 1, 3, 3, 3 }, { 3, 3, 1, 5, 5, 3 }, { 3, 1, 1, 5, 3, 2 } }, {}, false),
    492.0, 1e-5);
}

TEST(ResolveCrossings, UnitesBodiesThatCrossWhereTheirEdgesLieInSidesAndNoCavitiesThatDo)
{
  const std::array<double, 3> rings{ 2.0, 4.0, 6.0 }; // of a bar
  Soup soup;
  for (std::size_t side = 0; side < 4; ++side)
  {
    for (std::size_t k = 0; k < 2; ++k)
    {
      soup.AddSide({ 1.0, 1.0, rings[k] }, { 3.0, 3.0, rings[k + 1] }, side / 2, side % 2 == 1, 1);
    }
  }
  soup.AddSide({ 1.0, 1.0, 2.0 }, { 3.0, 3.0, 6.0 }, 2, false, 1);
  soup.AddSide({ 1.0, 1.0, 2.0 }, { 3.0, 3.0, 6.0 }, 2, true, 1);
  soup.AddBox({ 0.0, 0.0, 0.0 }, { 4.0, 4.0, 4.0 });
  const Verdict bodies = Resolved(soup, 0.1);
  EXPECT_GT(bodies.Count(ProblemCode::UnitedSurfaces), 0);
  EXPECT_NEAR(bodies.Figures().Volume, 72.0, 1e-5);
  soup.AddBox({ -1.0, -1.0, -1.0 }, { 7.0, 7.0, 7.0 });
  EXPECT_EQ(Resolved(soup, 0.1).Count(ProblemCode::UnitedSurfaces), 0);
}

TEST(ResolveCrossings, LooksForNoCavitiesInBodiesThatBoundNothingWithoutOthers)
{
  Soup soup;
  soup.AddBox({ 0.0, 0.0, 0.0 }, { 4.0, 4.0, 4.0 });
  for (std::size_t side = 1; side < 6; ++side)
  {
    soup.AddSide({ 4.0, 0.0, 0.0 }, { 8.0, 4.0, 4.0 }, side / 2, side % 2 == 1, 1);
  }
  const std::array<Point3, 4> corners{ Point3{ 4.0, 0.0, 0.0 }, { 4.0, 0.0, 4.0 },
    { 4.0, 4.0, 4.0 }, { 4.0, 4.0, 0.0 } };
  for (std::size_t k = 0; k < 4; ++k)
  {
    soup.Add(corners[k], corners[(k + 1) % 4], { 4.0, 2.0, 2.0 }); // the same wall, otherwise
  }
  const Verdict verdict = Resolved(soup, 0.1);
  EXPECT_TRUE(IsSound(verdict));
  EXPECT_GT(verdict.Count(ProblemCode::UnitedSurfaces), 0);
  EXPECT_NEAR(verdict.Figures().Volume, 128.0, 1e-5);
  soup.AddBox({ 1.0, 1.0, 0.0 }, { 3.0, 3.0, 2.0 });
  EXPECT_EQ(Resolved(soup, 0.1).Count(ProblemCode::UnitedSurfaces), 0);
}

// There middles of triangles are on other triangles, and bodies touch others where these cross.
TEST(ResolveCrossings, UnitesNearlyAllBoxesOfALattice)
{
  Dice dice(8);
  int given = 0;
  int united = 0;
  for (int trial = 0; trial < 80; ++trial)
  {
    const Blocks blocks = MakeBlocks(dice, 3 + trial % 2);
    const Soup surface = Oblique(blocks.Surface);
    if (!blocks.IsNested && Judge(surface, Noise).Count(ProblemCode::SelfCrossings) > 0)
    {
      ++given;
      const Verdict verdict = Resolved(surface, 0.1);
      if (verdict.Count(ProblemCode::UnitedSurfaces) > 0)
      {
        ++united;
        EXPECT_NEAR(verdict.Figures().Volume, blocks.Volume, 1e-4) << trial;
      }
    }
  }
  EXPECT_GT(given, 30);
  EXPECT_GE(united, 0.9 * given) << given;
}

} // namespace biting
