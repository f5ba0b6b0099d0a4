// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Support/TestThreads.h"
#include "SurfaceShapes.h"

#include <gtest/gtest.h>

#include <cmath> // for circles

namespace biting
{

namespace
{

constexpr double Pi = 3.14159265358979323846;

Soup Cube()
{
  Soup soup;
  soup.AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  return soup;
}

// A band of n quads about the z axis; a Moebius band where it is twisted.
Soup Band(int n, bool isTwisted)
{
  Soup soup;
  const auto at = [n, isTwisted](int k, double side)
  {
    const double turn = 2.0 * Pi * (k % n) / n;
    const double twist = isTwisted ? 0.5 * turn : 0.0;
    const double across = (isTwisted && k == n ? -side : side) * 0.3;
    const double radius = 1.0 + across * std::sin(twist);
    return Point3{ radius * std::cos(turn), radius * std::sin(turn), across * std::cos(twist) };
  };
  for (int k = 0; k < n; ++k)
  {
    soup.Add(at(k, -1.0), at(k + 1, -1.0), at(k + 1, 1.0));
    soup.Add(at(k, -1.0), at(k + 1, 1.0), at(k, 1.0));
  }
  return soup;
}

bool HasNothing(const Verdict& verdict)
{
  return verdict.Problems.Groups().empty();
}

} // namespace

TEST(SurfaceCheck, HasNothingToSayOfABox)
{
  const Verdict verdict = Judge(Cube());
  EXPECT_TRUE(HasNothing(verdict));
  EXPECT_EQ(verdict.Surface.Mesh.Points.size(), 8u);
  EXPECT_EQ(verdict.Figures().WeldedPoints, 28);
  EXPECT_EQ(verdict.Figures().Edges, 18);
  EXPECT_EQ(verdict.Figures().EulerNumber, 2);
  EXPECT_EQ(verdict.Figures().Parts, 1);
  EXPECT_DOUBLE_EQ(verdict.Figures().Volume, 1.0);
  EXPECT_DOUBLE_EQ(verdict.Figures().Area, 6.0);
  EXPECT_EQ(verdict.Surface.EdgeKinds.size(), 12u);
}

TEST(SurfaceCheck, OrientsTrianglesThatAreTurnedAtRandom)
{
  Dice dice(7);
  for (int round = 0; round < 30; ++round)
  {
    Soup soup = Sphere(1.0, 8);
    for (std::size_t t = 0; t < soup.Mesh.NumberOfTriangles(); ++t)
    {
      if (dice.Below(2) == 1)
      {
        soup.Turn(t);
      }
    }
    const Verdict verdict = Judge(soup);
    EXPECT_EQ(verdict.Count(ProblemCode::InconsistentEdges), 1);
    EXPECT_FALSE(verdict.Problems.HasErrors());
    EXPECT_DOUBLE_EQ(verdict.Figures().Volume, Judge(Sphere(1.0, 8)).Figures().Volume);
  }
}

TEST(SurfaceCheck, NestsShellsWhateverTheirOrientation)
{
  for (int turned = 0; turned < 16; ++turned)
  {
    Soup soup;
    soup.AddBox({ 0.0, 0.0, 0.0 }, { 9.0, 9.0, 9.0 });
    soup.AddBox({ 1.0, 1.0, 1.0 }, { 5.0, 8.0, 8.0 });
    soup.AddBox({ 2.0, 2.0, 2.0 }, { 4.0, 4.0, 4.0 });
    soup.AddBox({ 6.0, 1.0, 1.0 }, { 7.0, 8.0, 8.0 });
    for (std::size_t t = 0; t < soup.Mesh.NumberOfTriangles(); ++t)
    {
      if ((turned >> (t / 12) & 1) != 0)
      {
        soup.Turn(t);
      }
    }
    const Verdict verdict = Judge(soup);
    EXPECT_TRUE(HasNothing(verdict));
    EXPECT_EQ(verdict.Figures().Parts, 4);
    EXPECT_EQ(verdict.Figures().Cavities, 2);
    EXPECT_DOUBLE_EQ(verdict.Figures().Volume, 729.0 - 4.0 * 49.0 + 8.0 - 49.0);
    EXPECT_EQ(verdict.Surface.Shells.Of(24).Depth, 2);
  }
}

// A corner of one is on the face of another, and rays from there along the face are in that one.
TEST(SurfaceCheck, OrientsBodiesThatTouchOutwardsInAllDirections)
{
  for (std::size_t shift = 0; shift < 3; ++shift)
  {
    const auto moved = [shift](const Point3& p) {
      return Point3{ p[shift], p[(shift + 1) % 3], p[(shift + 2) % 3] };
    };
    Soup soup;
    soup.AddBox(moved({ 2.0, 0.0, 1.0 }), moved({ 5.0, 1.0, 5.0 }));
    soup.AddBox(moved({ 3.0, 1.0, 0.0 }), moved({ 7.0, 2.0, 2.0 }));
    EXPECT_DOUBLE_EQ(Judge(soup).Figures().Volume, 12.0 + 8.0);
    EXPECT_EQ(Judge(soup).Figures().Cavities, 0);
    for (Point3& point : soup.Mesh.Points) // what rounding does to it is below the noise
    {
      point = { 0.6 * point.X - 0.8 * point.Y, 0.8 * point.X + 0.6 * point.Y, point.Z };
    }
    EXPECT_NEAR(Judge(soup).Figures().Volume, 12.0 + 8.0, 1e-12);
  }
}

TEST(SurfaceCheck, TellsHolesAsLoopsWithLengthAndArea)
{
  Soup soup;
  soup.AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  soup.Remove(11);
  soup.Remove(10);
  const Verdict verdict = Judge(soup);
  ASSERT_EQ(verdict.Count(ProblemCode::OpenEdges), 1);
  EXPECT_EQ(
    verdict.Problems.Groups().front().First.front().Detail, "a loop of 4 edges, length 4, area 1");
  EXPECT_EQ(verdict.Figures().OpenEdges, 4);
  EXPECT_TRUE(std::isnan(verdict.Figures().Volume));
  EXPECT_EQ(verdict.Surface.Thickness.Value, 0.0);
}

TEST(SurfaceCheck, TellsEdgesOfFourTrianglesAndPinchedVertices)
{
  Soup edge = Cube();
  edge.AddBox({ 1.0, 1.0, 0.0 }, { 2.0, 2.0, 1.0 });
  const Verdict atEdge = Judge(edge);
  EXPECT_EQ(atEdge.Count(ProblemCode::NonManifoldEdges), 1);
  EXPECT_EQ(atEdge.Count(ProblemCode::PinchedVertices), 0);
  EXPECT_EQ(atEdge.Figures().Parts, 1);
  Soup vertex = Cube();
  vertex.AddBox({ 1.0, 1.0, 1.0 }, { 2.0, 2.0, 2.0 });
  const Verdict atVertex = Judge(vertex);
  EXPECT_EQ(atVertex.Count(ProblemCode::NonManifoldEdges), 0);
  EXPECT_EQ(atVertex.Count(ProblemCode::PinchedVertices), 1);
  EXPECT_EQ(atVertex.Figures().Parts, 1);
  EXPECT_DOUBLE_EQ(atVertex.Figures().Volume, 2.0);
}

TEST(SurfaceCheck, EndsChainsOfOpenEdgesAtEdgesOfThreeTriangles)
{
  Soup soup;
  for (int k = 0; k < 3; ++k)
  {
    const double turn = 2.0 * Pi * k / 3.0;
    soup.Add({ 0.0, 0.0, 0.0 }, { std::cos(turn), std::sin(turn), 0.5 }, { 0.0, 0.0, 1.0 });
  }
  const Verdict verdict = Judge(soup);
  EXPECT_EQ(verdict.Count(ProblemCode::NonManifoldEdges), 1);
  ASSERT_EQ(verdict.Count(ProblemCode::OpenEdges), 3);
  for (const Problem& problem : verdict.Problems.Groups().front().First)
  {
    EXPECT_EQ(problem.Detail.rfind("a chain of 2 edges", 0), 0u);
  }
}

TEST(SurfaceCheck, RemovesDuplicatesOfEitherOrientation)
{
  Soup soup = Cube();
  for (const bool isTurned : { false, true })
  {
    soup.Add(soup.Mesh.Points[0], soup.Mesh.Points[1], soup.Mesh.Points[2]);
    if (isTurned)
    {
      soup.Turn(soup.Mesh.NumberOfTriangles() - 1);
    }
  }
  const Verdict verdict = Judge(soup);
  EXPECT_EQ(verdict.Count(ProblemCode::DuplicateTriangles), 2);
  EXPECT_EQ(verdict.Surface.Mesh.NumberOfTriangles(), 12u);
  EXPECT_FALSE(verdict.Problems.HasErrors());
}

TEST(SurfaceCheck, FlipsFlatTrianglesAway)
{
  for (int parts = 2; parts < 7; ++parts)
  {
    Soup soup = Cube();
    // One side of an edge is divided, and flat triangles close the slit to the other.
    const std::array<Point3, 3> corners = soup.Mesh.Triangle(0);
    soup.Remove(0);
    const auto at = [&corners, parts](int k)
    { return corners[0] + (static_cast<double>(k) / parts) * (corners[1] - corners[0]); };
    for (int k = 0; k < parts; ++k)
    {
      soup.Add(at(k), at(k + 1), corners[2]);
      if (k > 0)
      {
        soup.Add(at(0), at(k + 1), at(k));
      }
    }
    const Verdict verdict = Judge(soup);
    EXPECT_GT(verdict.Count(ProblemCode::FlatTriangles), 0);
    EXPECT_FALSE(verdict.Problems.HasErrors());
    EXPECT_EQ(verdict.Surface.Mesh.NumberOfTriangles(), 12u + 2u * (parts - 1));
    EXPECT_EQ(verdict.Figures().EulerNumber, 2);
    EXPECT_DOUBLE_EQ(verdict.Figures().Volume, 1.0);
    EXPECT_DOUBLE_EQ(verdict.Figures().Area, 6.0);
  }
}

TEST(SurfaceCheck, TellsABandWithOneSide)
{
  EXPECT_EQ(Judge(Band(20, false)).Count(ProblemCode::NotOrientable), 0);
  EXPECT_EQ(Judge(Band(20, false)).Count(ProblemCode::OpenEdges), 2);
  const Verdict verdict = Judge(Band(20, true));
  EXPECT_EQ(verdict.Count(ProblemCode::NotOrientable), 1);
  EXPECT_EQ(verdict.Count(ProblemCode::OpenEdges), 1);
  EXPECT_EQ(verdict.Figures().EulerNumber, 0);
}

TEST(SurfaceCheck, TellsFoldsAndNoFlatNeighbors)
{
  Soup fold;
  fold.Add({ 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.5, 1.0, 0.0 });
  fold.Add({ 1.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.4, 0.5, 0.0 });
  EXPECT_EQ(Judge(fold).Count(ProblemCode::Folds), 1);
  fold.Mesh.Points.back() = { 0.4, -0.5, 0.0 };
  EXPECT_EQ(Judge(fold).Count(ProblemCode::Folds), 0);
  fold.Mesh.Points.back() = { 0.4, 0.5, 0.01 };
  EXPECT_EQ(Judge(fold).Count(ProblemCode::Folds), 0);
}

TEST(SurfaceCheck, TellsCrossingsFromTouches)
{
  Soup crossing = Cube();
  crossing.AddBox({ 0.5, 0.5, 0.25 }, { 2.0, 2.0, 0.75 });
  EXPECT_GT(Judge(crossing).Count(ProblemCode::SelfCrossings), 0);
  EXPECT_EQ(Judge(crossing).Figures().Parts, 2);
  Soup touching = Cube();
  touching.AddBox({ 1.0, 0.25, 0.25 }, { 2.0, 0.75, 0.75 });
  const Verdict verdict = Judge(touching);
  EXPECT_EQ(verdict.Count(ProblemCode::SelfCrossings), 0);
  EXPECT_GT(verdict.Count(ProblemCode::SurfaceTouches), 0);
  EXPECT_FALSE(verdict.Problems.HasErrors());
  EXPECT_DOUBLE_EQ(verdict.Figures().Volume, 1.25);
}

TEST(SurfaceCheck, WeldsOpenEdgesByRoundingAndNothingElse)
{
  Soup soup = Cube();
  Dice dice(3);
  for (Point3& point : soup.Mesh.Points)
  {
    point = point + Point3{ 1e-9 * dice.Unit(), 1e-9 * dice.Unit(), 1e-9 * dice.Unit() };
  }
  EXPECT_EQ(Judge(soup, 1e-11).Figures().OpenEdges, 36);
  const Verdict verdict = Judge(soup, 1e-9);
  EXPECT_TRUE(HasNothing(verdict));
  EXPECT_EQ(verdict.Surface.Mesh.Points.size(), 8u);
  // Closed already: edges shorter than the rounding stay.
  EXPECT_EQ(Judge(Sphere(1.0, 40), 0.2).Surface.Mesh.NumberOfTriangles(),
    Sphere(1.0, 40).Mesh.NumberOfTriangles());
}

TEST(SurfaceCheck, ClosesHolesThatAreNarrowForTheSpacingAndTellsThem)
{
  Dice dice(11);
  const SurfaceFigures whole = Judge(Sphere(1.0, 16)).Figures();
  for (int round = 0; round < 20; ++round)
  {
    Soup soup = Sphere(1.0, 16);
    for (int k = 0; k < 20; ++k)
    {
      soup.Remove(static_cast<std::size_t>(dice.Below(480 - k)));
    }
    const Verdict verdict = JudgeClosed(soup, 2.0);
    EXPECT_GT(verdict.Count(ProblemCode::ClosedHoles), 5);
    EXPECT_FALSE(verdict.Problems.HasErrors());
    EXPECT_EQ(verdict.Count(ProblemCode::InconsistentEdges), 0);
    EXPECT_EQ(verdict.Figures().EulerNumber, 2);
    EXPECT_NEAR(verdict.Figures().Volume, whole.Volume, 0.02 * whole.Volume);
    EXPECT_GT(JudgeClosed(soup, 0.05).Count(ProblemCode::OpenEdges), 5);
    EXPECT_EQ(JudgeClosed(soup, 0.05).Count(ProblemCode::ClosedHoles), 0);
  }
}

TEST(SurfaceCheck, LeavesACupAndATerrainOpenAtAnySpacingBelowTheirSizes)
{
  Soup cup;
  Soup terrain;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    cup.AddSide({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, axis, false, 40);
  }
  cup.AddSide({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, 0, true, 40);
  cup.AddSide({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, 1, true, 40);
  terrain.AddSide({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, 2, true, 40);
  for (const Soup& soup : { cup, terrain })
  {
    const Verdict verdict = JudgeClosed(soup, 1.0);
    ASSERT_EQ(verdict.Count(ProblemCode::OpenEdges), 1);
    EXPECT_EQ(verdict.Problems.Groups().front().First.front().Detail,
      "a loop of 160 edges, length 4, area 1");
    EXPECT_EQ(verdict.Count(ProblemCode::ClosedHoles), 0);
  }
}

TEST(SurfaceCheck, NeverDoublesTrianglesThatHangByAVertex)
{
  const Point3 top{ 1.0, 1.0, 1.0 };
  const Point3 left{ 1.5, 1.0, 1.2 };
  const Point3 right{ 1.0, 1.5, 1.2 };
  Soup one = Cube();
  one.Add(top, left, right);
  Soup two = one;
  two.Add(right, left, { 1.5, 1.5, 1.4 });
  for (const Soup& soup : { one, two })
  {
    const Verdict verdict = JudgeClosed(soup, 10.0);
    EXPECT_EQ(verdict.Count(ProblemCode::ClosedHoles), 0);
    EXPECT_EQ(verdict.Count(ProblemCode::OpenEdges), 1);
    EXPECT_EQ(verdict.Surface.Mesh.NumberOfTriangles(), soup.Mesh.NumberOfTriangles());
  }
}

TEST(SurfaceCheck, DividesEdgesAtTheVerticesOfCracks)
{
  for (const double off : { 0.0, 1e-9, 1e-6, 1e-3 })
  {
    Soup soup;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      soup.AddSide({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, axis, false, static_cast<int>(axis) + 3);
      soup.AddSide({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, axis, true, static_cast<int>(axis) + 6);
    }
    Dice dice(3);
    for (Point3& point : soup.Mesh.Points)
    {
      point = point + off * Point3{ dice.Unit(), dice.Unit(), dice.Unit() };
    }
    EXPECT_GT(Judge(soup).Count(ProblemCode::OpenEdges), 5);
    const Verdict verdict = JudgeClosed(soup, 0.1);
    EXPECT_FALSE(verdict.Problems.HasErrors()) << off;
    EXPECT_GT(verdict.Count(ProblemCode::ClosedHoles), 5) << off;
    EXPECT_EQ(verdict.Figures().EulerNumber, 2) << off;
    EXPECT_NEAR(verdict.Figures().Volume, 1.0, 6.0 * off + 1e-12) << off;
    EXPECT_NEAR(verdict.Figures().Area, 6.0, 24.0 * off + 1e-12) << off;
  }
}

TEST(SurfaceCheck, WeldsTrianglesThatAreApartAndNoShortSides)
{
  Soup soup;
  soup.AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 0.004 });
  Dice dice(3);
  for (Point3& point : soup.Mesh.Points)
  {
    point = point + 1e-5 * Point3{ dice.Unit(), dice.Unit(), dice.Unit() };
  }
  const Verdict verdict = JudgeClosed(soup, 0.1);
  EXPECT_FALSE(verdict.Problems.HasErrors());
  EXPECT_EQ(verdict.Count(ProblemCode::NearPoints), 28);
  EXPECT_EQ(verdict.Surface.Mesh.Points.size(), 8u);
  EXPECT_EQ(verdict.Figures().EulerNumber, 2);
}

TEST(SurfaceCheck, ClosesSlitsBetweenLoopsOfDifferentVertices)
{
  for (const double turn : { 0.0, 0.1 }) // a common vertex, or none
  {
    Soup soup;
    const auto at = [](int k, int n, double from, double height)
    {
      const double angle = from + 2.0 * Pi * (k % n) / n;
      return Point3{ std::cos(angle), std::sin(angle), height };
    };
    constexpr int Wall = 24;
    for (int k = 0; k < Wall; ++k)
    {
      soup.Add(at(k, Wall, 0.0, 0.0), at(k + 1, Wall, 0.0, 0.0), at(k + 1, Wall, 0.0, 1.0));
      soup.Add(at(k, Wall, 0.0, 0.0), at(k + 1, Wall, 0.0, 1.0), at(k, Wall, 0.0, 1.0));
    }
    for (const int n : { 17, 90 })
    {
      const double height = n == 17 ? 0.0 : 1.0;
      for (int k = 0; k < n; ++k)
      {
        soup.Add({ 0.0, 0.0, height }, at(k + 1, n, turn, height), at(k, n, turn, height));
        if (n == 90)
        {
          soup.Turn(soup.Mesh.NumberOfTriangles() - 1);
        }
      }
    }
    const Verdict verdict = JudgeClosed(soup, 0.2);
    EXPECT_FALSE(verdict.Problems.HasErrors()) << turn;
    EXPECT_GT(verdict.Count(ProblemCode::ClosedHoles), 3) << turn;
    EXPECT_EQ(verdict.Count(ProblemCode::InconsistentEdges), 0) << turn;
    EXPECT_EQ(verdict.Figures().EulerNumber, 2) << turn;
    EXPECT_NEAR(verdict.Figures().Volume, Pi, 0.05) << turn;
    EXPECT_GT(JudgeClosed(soup, 0.02).Count(ProblemCode::OpenEdges), 1) << turn;
  }
}

TEST(SurfaceCheck, LeavesScrapsOpen)
{
  for (const double rise : { 0.0, 0.02 }) // flat, or bent along the edge between
  {
    Soup soup;
    soup.AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, 4);
    soup.Add({ 3.0, 0.0, 0.0 }, { 3.1, 0.0, 0.0 }, { 3.0, 0.1, rise });
    soup.Add({ 3.1, 0.0, 0.0 }, { 3.1, 0.1, 0.0 }, { 3.0, 0.1, rise });
    const Verdict verdict = JudgeClosed(soup, 1.0);
    EXPECT_EQ(verdict.Count(ProblemCode::OpenEdges), 1) << rise;
    EXPECT_EQ(verdict.Count(ProblemCode::ClosedHoles), 0) << rise;
  }
}

TEST(SurfaceCheck, TellsHolesThatTouchOneByOne)
{
  Soup soup;
  soup.AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, 4);
  Soup holes = soup;
  // Two triangles of one side with one common corner, and no side between them.
  holes.Remove(2);
  holes.Remove(0);
  ASSERT_EQ(Judge(holes).Count(ProblemCode::OpenEdges), 2);
  const Verdict verdict = JudgeClosed(holes, 1.0);
  EXPECT_EQ(verdict.Count(ProblemCode::ClosedHoles), 2);
  EXPECT_NEAR(verdict.Figures().Volume, 1.0, 1e-12);
  EXPECT_EQ(verdict.Surface.Mesh.NumberOfTriangles(), soup.Mesh.NumberOfTriangles());
}

TEST(SurfaceCheck, FindsTheThicknessOfAPlateAndOfASphere)
{
  Soup plate;
  plate.AddBox({ 0.0, 0.0, 0.0 }, { 10.0, 10.0, 0.5 }, 20);
  const SurfaceThickness thickness = Judge(plate).Surface.Thickness;
  EXPECT_NEAR(thickness.Value, 0.5, 1e-9);
  EXPECT_NEAR(thickness.Place.Z, 0.25, 1e-9);
  EXPECT_NEAR(Judge(Sphere(3.0, 20)).Surface.Thickness.Value, 6.0, 0.2);
}

TEST(SurfaceCheck, IsTheSameForAnyNumberOfThreads)
{
  Soup soup = Sphere(1.0, 100);
  soup.AddBox({ 0.2, 0.2, 0.2 }, { 2.0, 2.0, 2.0 }, 40);
  const Verdict one = Judge(soup);
  EXPECT_GT(one.Count(ProblemCode::SelfCrossings), 100);
  for (const int threads : { 2, 8 })
  {
    MonitorWithThreads monitor(threads);
    const Verdict other = Judge(soup, 1e-12, monitor);
    EXPECT_EQ(one.Surface.Mesh.Corners, other.Surface.Mesh.Corners);
    EXPECT_EQ(one.Surface.Thickness.Value, other.Surface.Thickness.Value);
    const auto& a = one.Problems.Groups().front().First;
    const auto& b = other.Problems.Groups().front().First;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k)
    {
      EXPECT_EQ(a[k].Ids, b[k].Ids);
      EXPECT_TRUE(a[k].Place == b[k].Place);
    }
  }
}

TEST(SurfaceCheck, EndsWhereTheMonitorWantsToStop)
{
  class Impatient : public SilentMonitor
  {
  public:
    bool Advance(double) override { return false; }
  };
  Impatient monitor;
  EXPECT_EQ(Judge(Sphere(1.0, 40), 0.0, monitor).Count(ProblemCode::Aborted), 1);
}

} // namespace biting
