// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Quality/Quality.h"
#include "Base/Numbers.h"

#include "../Support/TestThreads.h"
#include "TestMesh.h"

#include <gtest/gtest.h>

#include <algorithm> // for min, max
#include <cmath>     // for the formulas

namespace
{

using biting::AspectRatio;
using biting::Dice;
using biting::Infinity;
using biting::MeshQuality;
using biting::MinimumAngle;
using biting::Point2;
using biting::RadiusEdgeRatio;
using biting::TestMesh;

const double SquareRootOf2 = std::sqrt(2.0);
const double SquareRootOf3 = std::sqrt(3.0);

struct Triangle
{
  Point2 A;
  Point2 B;
  Point2 C;
};

std::vector<Triangle> RandomTriangles()
{
  Dice dice(23);
  std::vector<Triangle> triangles;
  for (int i = 0; i < 2000; ++i)
  {
    // The later, the flatter.
    const double height = std::pow(10.0, -0.004 * i);
    const auto place = [&dice, height]() -> Point2
    {
      const double x = dice.Between(-1, 1);
      return { x, height * dice.Between(-1, 1) };
    };
    const Point2 a = place();
    const Point2 b = place();
    triangles.push_back({ a, b, place() });
  }
  return triangles;
}

// The definitions, in extended precision: from side lengths, area and all three angles.
struct ExtendedMeasures
{
  explicit ExtendedMeasures(const Triangle& triangle);
  long double Angle(int corner) const;

  long double X[3];
  long double Y[3];
  long double Sides[3];
  long double Area;
};

ExtendedMeasures::ExtendedMeasures(const Triangle& triangle)
  : X{ triangle.A.X, triangle.B.X, triangle.C.X }
  , Y{ triangle.A.Y, triangle.B.Y, triangle.C.Y }
{
  for (int k = 0; k < 3; ++k)
  {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    this->Sides[k] = std::hypot(this->X[i] - this->X[j], this->Y[i] - this->Y[j]);
  }
  this->Area = std::abs((this->X[1] - this->X[0]) * (this->Y[2] - this->Y[0]) -
                 (this->Y[1] - this->Y[0]) * (this->X[2] - this->X[0])) /
    2;
}

long double ExtendedMeasures::Angle(int corner) const
{
  const int i = (corner + 1) % 3;
  const int j = (corner + 2) % 3;
  const long double dot = (this->X[i] - this->X[corner]) * (this->X[j] - this->X[corner]) +
    (this->Y[i] - this->Y[corner]) * (this->Y[j] - this->Y[corner]);
  return std::atan2(2 * this->Area, dot) * 180 / std::acos(-1.0L);
}

void ExpectClose(double measured, long double expected)
{
  EXPECT_NEAR(measured, static_cast<double>(expected), 1e-9 * static_cast<double>(expected));
}

MeshQuality Measure(const TestMesh& mesh, const std::vector<double>& spacing)
{
  return biting::MeasureQuality({ mesh.Points, spacing, mesh.Corners, mesh.Neighbors });
}

std::vector<double> UniformSpacing(const TestMesh& mesh, double spacing)
{
  return std::vector<double>(mesh.Points.size(), spacing);
}

TestMesh HoledMesh()
{
  TestMesh mesh = TestMesh::Random(80, 3);
  mesh.MakeDelaunay();
  mesh.Keep([](const Point2& p) { return Distance(p, { 0.4, 0.5 }) > 0.2; });
  return mesh;
}

void ExpectSameShapes(const MeshQuality& left, const MeshQuality& right)
{
  EXPECT_EQ(left.Conformity, right.Conformity);
  EXPECT_EQ(left.MinimumAngle, right.MinimumAngle);
  EXPECT_EQ(left.RadiusEdgeRatio, right.RadiusEdgeRatio);
  EXPECT_EQ(left.AspectRatio, right.AspectRatio);
  EXPECT_EQ(left.MeanRelativeLength, right.MeanRelativeLength);
  EXPECT_EQ(left.ShareOfEdgesInBand, right.ShareOfEdgesInBand);
}

TEST(Triangle, HasTheBestMeasuresWhereItIsEquilateral)
{
  const Point2 a{ 0, 0 };
  const Point2 b{ 2, 0 };
  const Point2 c{ 1, SquareRootOf3 };
  EXPECT_NEAR(MinimumAngle(a, b, c), 60.0, 1e-13);
  EXPECT_NEAR(RadiusEdgeRatio(a, b, c), 1.0 / SquareRootOf3, 1e-15);
  EXPECT_NEAR(AspectRatio(a, b, c), 2.0, 1e-14);
}

TEST(Triangle, HasKnownMeasuresWhereItIsHalfASquare)
{
  const Point2 a{ 5, 5 };
  const Point2 b{ 6, 5 };
  const Point2 c{ 5, 6 };
  EXPECT_DOUBLE_EQ(MinimumAngle(a, b, c), 45.0);
  EXPECT_DOUBLE_EQ(RadiusEdgeRatio(a, b, c), 0.5 * SquareRootOf2);
  EXPECT_DOUBLE_EQ(AspectRatio(a, b, c), 1.0 + SquareRootOf2);
}

TEST(Triangle, IsContainedInTheCircleOverItsLongestSideWhereItIsObtuse)
{
  const Point2 a{ -4, 0 };
  const Point2 b{ 4, 0 };
  const Point2 c{ 0, 3 };
  EXPECT_DOUBLE_EQ(AspectRatio(a, b, c), 4.0 / (24.0 / 18.0));
}

TEST(Triangle, HasTheSmallestOfItsThreeAngles)
{
  for (const Triangle& triangle : RandomTriangles())
  {
    const ExtendedMeasures expected(triangle);
    ExpectClose(MinimumAngle(triangle.A, triangle.B, triangle.C),
      std::min({ expected.Angle(0), expected.Angle(1), expected.Angle(2) }));
  }
}

TEST(Triangle, HasTheRadiusEdgeRatioOfItsDefinition)
{
  for (const Triangle& triangle : RandomTriangles())
  {
    const ExtendedMeasures expected(triangle);
    const auto& sides = expected.Sides;
    const long double radius = sides[0] * sides[1] * sides[2] / (4 * expected.Area);
    ExpectClose(RadiusEdgeRatio(triangle.A, triangle.B, triangle.C),
      radius / std::min({ sides[0], sides[1], sides[2] }));
  }
}

TEST(Triangle, HasTheAspectRatioOfItsDefinition)
{
  for (const Triangle& triangle : RandomTriangles())
  {
    const ExtendedMeasures expected(triangle);
    const auto& sides = expected.Sides;
    const bool isAcute =
      std::max({ expected.Angle(0), expected.Angle(1), expected.Angle(2) }) < 90.0L;
    const long double outer = isAcute ? sides[0] * sides[1] * sides[2] / (4 * expected.Area)
                                      : std::max({ sides[0], sides[1], sides[2] }) / 2;
    const long double inner = 2 * expected.Area / (sides[0] + sides[1] + sides[2]);
    ExpectClose(AspectRatio(triangle.A, triangle.B, triangle.C), outer / inner);
  }
}

TEST(Triangle, HasTheSameMeasuresInAnyOrderOfItsCorners)
{
  for (const Triangle& triangle : RandomTriangles())
  {
    const auto& [a, b, c] = triangle;
    ExpectClose(MinimumAngle(b, c, a), MinimumAngle(a, b, c));
    ExpectClose(MinimumAngle(b, a, c), MinimumAngle(a, b, c));
    ExpectClose(RadiusEdgeRatio(c, a, b), RadiusEdgeRatio(a, b, c));
    ExpectClose(RadiusEdgeRatio(a, c, b), RadiusEdgeRatio(a, b, c));
    ExpectClose(AspectRatio(b, c, a), AspectRatio(a, b, c));
    ExpectClose(AspectRatio(c, b, a), AspectRatio(a, b, c));
  }
}

TEST(Triangle, IsAsBadAsCanBeWhereItIsFlat)
{
  const Point2 a{ 0, 0 };
  const Point2 b{ 1, 2 };
  for (const Point2& c : { Point2{ 2, 4 }, Point2{ 0.5, 1 }, b, a })
  {
    EXPECT_EQ(MinimumAngle(a, b, c), 0.0);
    EXPECT_EQ(RadiusEdgeRatio(a, b, c), Infinity);
    EXPECT_EQ(AspectRatio(a, b, c), Infinity);
  }
  EXPECT_EQ(MinimumAngle(a, a, a), 0.0);
  EXPECT_EQ(RadiusEdgeRatio(a, a, a), Infinity);
  EXPECT_EQ(AspectRatio(a, a, a), Infinity);
}

TEST(MeasureQuality, SummarizesItsArrays)
{
  const TestMesh mesh = HoledMesh();
  const MeshQuality quality = Measure(mesh, UniformSpacing(mesh, 0.1));
  const auto smallest = [](const std::vector<double>& values)
  { return *std::min_element(values.begin(), values.end()); };
  EXPECT_EQ(quality.NumberOfVertices, static_cast<std::int64_t>(mesh.Points.size()));
  EXPECT_EQ(quality.NumberOfTriangles, static_cast<std::int64_t>(mesh.Corners.size() / 3));
  EXPECT_EQ(quality.SmallestAngle, smallest(quality.MinimumAngle));
  EXPECT_EQ(quality.LargestRadiusEdgeRatio,
    *std::max_element(quality.RadiusEdgeRatio.begin(), quality.RadiusEdgeRatio.end()));
  EXPECT_EQ(quality.SmallestConformity, smallest(quality.Conformity));
  EXPECT_GE(quality.MeanConformity, quality.SmallestConformity);
  EXPECT_LE(quality.MeanConformity, 1.0);
}

TEST(MeasureQuality, MeasuresEachTriangle)
{
  const TestMesh mesh = HoledMesh();
  const MeshQuality quality = Measure(mesh, UniformSpacing(mesh, 0.1));
  for (std::size_t t = 0; t < mesh.Corners.size() / 3; ++t)
  {
    const Point2& a = mesh.Place(3 * t);
    const Point2& b = mesh.Place(3 * t + 1);
    const Point2& c = mesh.Place(3 * t + 2);
    EXPECT_EQ(quality.MinimumAngle[t], MinimumAngle(a, b, c));
    EXPECT_EQ(quality.RadiusEdgeRatio[t], RadiusEdgeRatio(a, b, c));
    EXPECT_EQ(quality.AspectRatio[t], AspectRatio(a, b, c));
  }
}

TEST(MeasureQuality, ComparesTheNearestDistanceWithTheSpacing)
{
  const TestMesh mesh = TestMesh::Grid(
    biting::UnitLines(4), biting::UnitLines(3), [](std::size_t, std::size_t) { return true; });
  std::vector<double> spacing = UniformSpacing(mesh, 1.0);
  spacing[3] = 4.0;
  spacing[7] = 0.5;
  const MeshQuality quality = Measure(mesh, spacing);
  EXPECT_EQ(quality.Conformity[0], 1.0);
  EXPECT_EQ(quality.Conformity[3], 0.25);
  EXPECT_EQ(quality.Conformity[7], 0.5);
  EXPECT_EQ(quality.SmallestConformity, 0.25);
  EXPECT_DOUBLE_EQ(quality.MeanConformity, 18.75 / 20.0);
}

void ExpectShortestEdges(const TestMesh& mesh, const MeshQuality& quality)
{
  std::vector<double> shortest(mesh.Points.size(), Infinity);
  for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
  {
    const double length = Distance(mesh.Place(slot), mesh.Place(biting::NextSlot(slot)));
    for (const biting::Id end : { mesh.Corners[slot], mesh.Corners[biting::NextSlot(slot)] })
    {
      double& known = shortest[static_cast<std::size_t>(end)];
      known = std::min(known, length);
    }
  }
  for (std::size_t k = 0; k < shortest.size(); ++k)
  {
    EXPECT_DOUBLE_EQ(quality.NearestNeighborDistance[k], shortest[k]);
  }
}

TEST(NearestNeighborDistance, IsThatAlongTheShortestEdge)
{
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
  {
    TestMesh mesh = TestMesh::Random(60, seed);
    mesh.Shuffle(40, seed);
    ExpectShortestEdges(mesh, Measure(mesh, UniformSpacing(mesh, 1.0)));
  }
}

/// By a property of Delaunay triangulations: each point is joined with the nearest one.
TEST(NearestNeighborDistance, IsTheLeastOfAllInAConvexDelaunayMesh)
{
  TestMesh mesh = TestMesh::Random(80, 3);
  mesh.MakeDelaunay();
  const MeshQuality quality = Measure(mesh, UniformSpacing(mesh, 1.0));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    double nearest = Infinity;
    for (std::size_t k = 0; k < mesh.Points.size(); ++k)
    {
      nearest = k == i ? nearest : std::min(nearest, Distance(mesh.Points[i], mesh.Points[k]));
    }
    EXPECT_DOUBLE_EQ(quality.NearestNeighborDistance[i], nearest);
  }
}

/// So many triangles that there are several tasks.
TEST(NearestNeighborDistance, IsTheSameForAnyNumberOfThreads)
{
  TestMesh mesh = TestMesh::Grid(
    biting::UnitLines(300), biting::UnitLines(200), [](std::size_t, std::size_t) { return true; });
  for (std::size_t k = 0; k < mesh.Points.size(); ++k)
  {
    mesh.Points[k].X += 0.004 * static_cast<double>(7919 * k % 101);
    mesh.Points[k].Y += 0.004 * static_cast<double>(5413 * k % 97);
  }
  const std::vector<double> spacing = UniformSpacing(mesh, 1.0);
  const biting::MeshView view{ mesh.Points, spacing, mesh.Corners, mesh.Neighbors };
  const MeshQuality alone = biting::MeasureQuality(view);
  for (const int numberOfThreads : { 2, 3, 8 })
  {
    biting::MonitorWithThreads monitor(numberOfThreads);
    const MeshQuality shared = biting::MeasureQuality(view, monitor);
    EXPECT_EQ(shared.NearestNeighborDistance, alone.NearestNeighborDistance);
    EXPECT_EQ(shared.Conformity, alone.Conformity);
  }
}

// Of 4 x 3 squares: 16 + 15 sides of length 1 and 12 diagonals.
TEST(MeasureQuality, CountsEachEdgeOnce)
{
  const TestMesh mesh = TestMesh::Grid(
    biting::UnitLines(4), biting::UnitLines(3), [](std::size_t, std::size_t) { return true; });
  const MeshQuality quality = Measure(mesh, UniformSpacing(mesh, 1.25));
  EXPECT_DOUBLE_EQ(quality.MeanRelativeLength, (31 + 12 * SquareRootOf2) / 43 / 1.25);
  EXPECT_EQ(quality.ShareOfEdgesInBand, 1.0);
  EXPECT_DOUBLE_EQ(Measure(mesh, UniformSpacing(mesh, 0.9)).ShareOfEdgesInBand, 31.0 / 43.0);
  EXPECT_DOUBLE_EQ(Measure(mesh, UniformSpacing(mesh, 1.9)).ShareOfEdgesInBand, 12.0 / 43.0);
}

TEST(MeasureQuality, ComparesAnEdgeWithTheMeanSpacingOfItsEnds)
{
  TestMesh mesh;
  mesh.Points = { { 0, 0 }, { 4, 0 }, { 0, 3 } };
  mesh.Corners = { 0, 1, 2 };
  mesh.Link();
  const MeshQuality quality = Measure(mesh, { 1.0, 3.0, 5.0 });
  EXPECT_DOUBLE_EQ(quality.MeanRelativeLength, (4.0 / 2.0 + 5.0 / 4.0 + 3.0 / 3.0) / 3.0);
  EXPECT_DOUBLE_EQ(quality.ShareOfEdgesInBand, 2.0 / 3.0);
}

TEST(MeasureQuality, DoesNotDependOnTheUnitOfLength)
{
  TestMesh mesh = HoledMesh();
  const MeshQuality before = Measure(mesh, UniformSpacing(mesh, 0.1));
  for (Point2& p : mesh.Points)
  {
    p = 0x1p40 * p;
  }
  ExpectSameShapes(before, Measure(mesh, UniformSpacing(mesh, 0.1 * 0x1p40)));
}

TEST(MeasureQuality, DoesNotDependOnTheDirectionOfTheAxes)
{
  TestMesh mesh = HoledMesh();
  const MeshQuality before = Measure(mesh, UniformSpacing(mesh, 0.1));
  for (Point2& p : mesh.Points)
  {
    p = Perpendicular(p);
  }
  ExpectSameShapes(before, Measure(mesh, UniformSpacing(mesh, 0.1)));
}

TEST(MeasureQuality, TakesTheSpacingAtTheMiddleOfAnEdgeWhereItIsKnown)
{
  TestMesh mesh;
  mesh.Points = { { 0, 0 }, { 4, 0 }, { 0, 3 } };
  mesh.Corners = { 0, 1, 2 };
  mesh.Link();
  const std::vector<double> spacing{ 1.0, 3.0, 5.0 };
  const biting::MeshView ofEnds{ mesh.Points, spacing, mesh.Corners, mesh.Neighbors };
  std::vector<double> middles;
  for (const Point2& middle : biting::EdgeMiddles(ofEnds))
  {
    middles.push_back(1.0 + middle.X + middle.Y);
  }
  const biting::MeshView mesh2{ mesh.Points, spacing, mesh.Corners, mesh.Neighbors, &middles };
  EXPECT_EQ(
    biting::RelativeLengths(mesh2), (std::vector<double>{ 5.0 / 4.5, 3.0 / 2.5, 4.0 / 3.0 }));
  EXPECT_DOUBLE_EQ(
    MeasureQuality(mesh2).MeanRelativeLength, (5.0 / 4.5 + 3.0 / 2.5 + 4.0 / 3.0) / 3.0);
}

TEST(MeasureQuality, FindsAnglesThatAddUpAndTheSmallestAmongThem)
{
  const TestMesh mesh = HoledMesh();
  const std::vector<double> spacing = UniformSpacing(mesh, 0.1);
  const std::vector<double> angles =
    biting::AnglesOf({ mesh.Points, spacing, mesh.Corners, mesh.Neighbors });
  for (std::size_t slot = 0; slot < angles.size(); slot += 3)
  {
    EXPECT_NEAR(angles[slot] + angles[slot + 1] + angles[slot + 2], 180.0, 1e-11);
    EXPECT_NEAR(*std::min_element(&angles[slot], &angles[slot] + 3),
      MinimumAngle(mesh.Place(slot), mesh.Place(slot + 1), mesh.Place(slot + 2)), 1e-11);
  }
}

TEST(MeasureQuality, FindsTheSlopeOfALinearSpacing)
{
  const TestMesh mesh = TestMesh::Grid(
    biting::UnitLines(4), biting::UnitLines(3), [](std::size_t, std::size_t) { return true; });
  std::vector<double> spacing;
  for (const Point2& p : mesh.Points)
  {
    spacing.push_back(1.0 + 0.25 * (p.X + p.Y));
  }
  const biting::MeshView view{ mesh.Points, spacing, mesh.Corners, mesh.Neighbors };
  EXPECT_DOUBLE_EQ(biting::LargestSlope(view), 0.25 * SquareRootOf2);
  EXPECT_EQ(biting::MeasureQuality(view).LargestSlope, biting::LargestSlope(view));
}

TEST(MeasureQuality, FindsNothingInNothing)
{
  const MeshQuality quality = Measure({}, {});
  EXPECT_EQ(quality.NumberOfVertices, 0);
  EXPECT_EQ(quality.NumberOfTriangles, 0);
  EXPECT_EQ(quality.SmallestAngle, 0.0);
  EXPECT_EQ(quality.SmallestConformity, 0.0);
  EXPECT_EQ(quality.MeanConformity, 0.0);
  EXPECT_EQ(quality.MeanRelativeLength, 0.0);
  EXPECT_EQ(quality.ShareOfEdgesInBand, 0.0);
}

} // namespace
