// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Space/Meshing/SurfaceMesher.h"
#include "Space/Delaunay/SpaceTriangulation.h"
#include "Space/Features/SizeCaps.h"
#include "Space/Surface/SurfaceShapes.h"

#include <gtest/gtest.h>

#include <algorithm> // for rotate, sort, unique
#include <array>     // for corners
#include <cmath>     // for angles
#include <utility>   // for pairs
#include <vector>    // for profiles

namespace biting
{

namespace
{

/// A mesh with what was told of it.
struct Meshed
{
  BitingSurface Mesh;
  ProblemList Problems;

  Point3 At(std::size_t slot) const
  {
    return this->Mesh.Points[static_cast<std::size_t>(this->Mesh.Corners[slot])];
  }
  std::size_t Triangles() const { return this->Mesh.Corners.size() / 3; }
};

SurfaceMesherOptions Uniform(double size)
{
  SurfaceMesherOptions options;
  options.Spacing = [size](const Point3&) { return size; };
  return options;
}

Meshed MakeMesh(const Soup& soup, const SurfaceMesherOptions& options)
{
  Meshed meshed;
  meshed.Mesh = MakeBitingSurface(Judge(soup).Surface, options, meshed.Problems, NoMonitor());
  return meshed;
}

Soup BoxOf(const Point3& size)
{
  Soup soup;
  soup.AddBox({ 0.0, 0.0, 0.0 }, size);
  return soup;
}

/// Edges as pairs of vertices, each as often as triangles have it in that direction.
std::vector<std::pair<Id, Id>> DirectedEdges(const BitingSurface& mesh)
{
  std::vector<std::pair<Id, Id>> edges;
  for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
  {
    edges.push_back({ mesh.Corners[slot], mesh.Corners[slot % 3 == 2 ? slot - 2 : slot + 1] });
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Each edge comes once in each direction.
bool IsClosed(const BitingSurface& mesh)
{
  const std::vector<std::pair<Id, Id>> edges = DirectedEdges(mesh);
  bool isClosed = std::adjacent_find(edges.begin(), edges.end()) == edges.end();
  for (const std::pair<Id, Id>& edge : edges)
  {
    isClosed = isClosed &&
      std::binary_search(edges.begin(), edges.end(), std::make_pair(edge.second, edge.first));
  }
  return isClosed;
}

/// Vertices - edges + triangles.
long EulerNumber(const BitingSurface& mesh)
{
  std::vector<std::pair<Id, Id>> edges = DirectedEdges(mesh);
  for (std::pair<Id, Id>& edge : edges)
  {
    edge = { std::min(edge.first, edge.second), std::max(edge.first, edge.second) };
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return static_cast<long>(mesh.Points.size() + mesh.Corners.size() / 3) -
    static_cast<long>(edges.size());
}

double Area(const Meshed& meshed)
{
  double area = 0.0;
  for (std::size_t t = 0; t < meshed.Triangles(); ++t)
  {
    const Point3 a = meshed.At(3 * t);
    area += 0.5 * Length(Cross(meshed.At(3 * t + 1) - a, meshed.At(3 * t + 2) - a));
  }
  return area;
}

double Volume(const Meshed& meshed)
{
  double volume = 0.0;
  for (std::size_t t = 0; t < meshed.Triangles(); ++t)
  {
    volume += Dot(meshed.At(3 * t), Cross(meshed.At(3 * t + 1), meshed.At(3 * t + 2))) / 6.0;
  }
  return volume;
}

double SmallestAngle(const Meshed& meshed)
{
  double smallest = 180.0;
  for (std::size_t slot = 0; slot < meshed.Mesh.Corners.size(); ++slot)
  {
    const std::size_t base = slot - slot % 3;
    const Point3 a = meshed.At(base + (slot + 1) % 3) - meshed.At(slot);
    const Point3 b = meshed.At(base + (slot + 2) % 3) - meshed.At(slot);
    smallest = std::min(smallest, std::atan2(Length(Cross(a, b)), Dot(a, b)) * 57.29577951308232);
  }
  return smallest;
}

double LengthOfLines(const BitingSurface& mesh)
{
  double length = 0.0;
  for (std::size_t k = 0; k < mesh.EdgeEnds.size(); k += 2)
  {
    length += Distance(mesh.Points[static_cast<std::size_t>(mesh.EdgeEnds[k])],
      mesh.Points[static_cast<std::size_t>(mesh.EdgeEnds[k + 1])]);
  }
  return length;
}

/// A prism over a triangle whose angle at the apex is given in degrees.
Soup Wedge(double degrees)
{
  const double half = std::tan(0.5 * degrees / 57.29577951308232);
  const std::array<Point3, 3> low{ Point3{ 0.0, 0.0, 0.0 }, Point3{ 1.0, -half, 0.0 },
    Point3{ 1.0, half, 0.0 } };
  std::array<Point3, 3> high = low;
  for (Point3& point : high)
  {
    point.Z = 1.0;
  }
  Soup soup;
  soup.Add(low[0], low[2], low[1]);
  soup.Add(high[0], high[1], high[2]);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t next = (k + 1) % 3;
    soup.Add(low[k], low[next], high[next]);
    soup.Add(low[k], high[next], high[k]);
  }
  return soup;
}

/// A profile of radii and heights, closed or from axis to axis, turned around the third axis.
Soup Turned(const std::vector<std::array<double, 2>>& profile, int sides)
{
  Soup soup;
  const auto at = [&profile, sides](std::size_t k, int side)
  {
    const double angle = 6.283185307179586 * (side % sides) / sides;
    return Point3{ profile[k][0] * std::cos(angle), profile[k][0] * std::sin(angle),
      profile[k][1] };
  };
  for (std::size_t k = 1; k < profile.size(); ++k)
  {
    for (int side = 0; side < sides; ++side)
    {
      if (profile[k - 1][0] > 0.0)
      {
        soup.Add(at(k - 1, side), at(k - 1, side + 1), at(k, side));
      }
      if (profile[k][0] > 0.0)
      {
        soup.Add(at(k - 1, side + 1), at(k, side + 1), at(k, side));
      }
    }
  }
  return soup;
}

Soup Torus(double radius, double tube, int sides)
{
  std::vector<std::array<double, 2>> profile;
  for (int k = 0; k <= sides; ++k)
  {
    const double angle = 6.283185307179586 * (k % sides) / sides;
    profile.push_back({ radius + tube * std::cos(angle), tube * std::sin(angle) });
  }
  return Turned(profile, 3 * sides);
}

/// Each triangle in four.
Soup Split(const Soup& soup)
{
  Soup split;
  for (std::size_t t = 0; t < soup.Mesh.NumberOfTriangles(); ++t)
  {
    const std::array<Point3, 3> p = soup.Mesh.Triangle(t);
    const Point3 a = Midpoint(p[1], p[2]);
    const Point3 b = Midpoint(p[2], p[0]);
    const Point3 c = Midpoint(p[0], p[1]);
    split.Add(p[0], c, b);
    split.Add(p[1], a, c);
    split.Add(p[2], b, a);
    split.Add(a, b, c);
  }
  return split;
}

/// Each triangle begins at another of its corners.
Soup Rotated(Soup soup)
{
  for (std::size_t t = 0; t < soup.Mesh.NumberOfTriangles(); ++t)
  {
    const auto first = soup.Mesh.Corners.begin() + static_cast<std::ptrdiff_t>(3 * t);
    std::rotate(first, first + 1 + static_cast<std::ptrdiff_t>(t % 2), first + 3);
  }
  return soup;
}

/// The prism, one unit high, over a polygon.
Soup Prism(const std::vector<std::array<double, 2>>& polygon, const Point3& middle)
{
  Soup soup;
  for (std::size_t k = 0; k < polygon.size(); ++k)
  {
    const std::array<double, 2>& from = polygon[k];
    const std::array<double, 2>& to = polygon[(k + 1) % polygon.size()];
    const Point3 a{ from[0], from[1], 0.0 };
    const Point3 b{ to[0], to[1], 0.0 };
    const Point3 up{ 0.0, 0.0, 1.0 };
    soup.Add(a, b, b + up);
    soup.Add(a, b + up, a + up);
    soup.Add(middle, b, a);
    soup.Add(middle + up, a + up, b + up);
  }
  return soup;
}

/// Over a square, its corners rounded by .01.
Soup RoundedPrism()
{
  std::vector<std::array<double, 2>> rounded;
  for (int k = 0; k < 36; ++k)
  {
    const int corner = k / 9;
    const double angle = 1.5707963267948966 * (k % 9 + 8 * corner - 8) / 8;
    rounded.push_back({ (corner < 2 ? 0.99 : 0.01) + 0.01 * std::cos(angle),
      (corner == 1 || corner == 2 ? 0.99 : 0.01) + 0.01 * std::sin(angle) });
  }
  return Prism(rounded, { 0.5, 0.5, 0.0 });
}

} // namespace

TEST(SurfaceMesher, TellsWhereFacetsAreFarFromTheSurface)
{
  SurfaceMesherOptions options = Uniform(0.2);
  options.FeatureAngle = 180.0; // edges of a cube are cut off
  const Soup cube = BoxOf({ 1.0, 1.0, 1.0 });
  const Meshed meshed = MakeMesh(cube, options);
  EXPECT_FALSE(meshed.Problems.HasErrors());
  EXPECT_TRUE(meshed.Problems.Has(ProblemCode::LostFeatures));
  options.BoundaryTolerance = 0.0; // any distance
  EXPECT_TRUE(MakeMesh(cube, options).Problems.Groups().empty());
}

TEST(SurfaceMesher, StaysWithinTheToleranceWhereTheSurfaceCurves)
{
  const std::vector<Soup> bodies{ Turned(
                                    { { 0.0, 0.0 }, { 0.6, 0.0 }, { 0.6, 1.0 }, { 0.0, 1.0 } }, 96),
    Turned({ { 0.0, 0.0 }, { 0.7, 0.0 }, { 0.3, 1.0 }, { 0.0, 1.0 } }, 96), Torus(1.0, 0.35, 32) };
  for (const Soup& body : bodies)
  {
    const Meshed meshed = MakeMesh(body, Uniform(0.3));
    ASSERT_TRUE(meshed.Problems.Groups().empty());
    EXPECT_TRUE(IsClosed(meshed.Mesh));
    const std::vector<double>& deviations = meshed.Mesh.Deviations;
    EXPECT_LT(*std::max_element(deviations.begin(), deviations.end()), 0.1);
    EXPECT_GT(SmallestAngle(meshed), 30.0);
  }
}

TEST(SurfaceMesher, DoesNotDependOnHowFacesAreTriangulated)
{
  std::vector<std::array<double, 2>> halfCircle{ { 0.0, -1.0 } };
  for (int k = 1; k < 20; ++k)
  {
    const double angle = 3.141592653589793 * k / 20;
    halfCircle.push_back({ std::sin(angle), -std::cos(angle) });
  }
  halfCircle.push_back({ 0.0, 1.0 });
  // Where f is capped by little, at lines that turn, at a ball of faces that turn by 9 degrees, and
  // where facets as small as caps make them are still too large.
  const std::vector<std::pair<Soup, double>> bodies{ { Torus(1.0, 0.3, 32), 0.2 },
    { Turned({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } }, 10), 1.0 / 3.0 },
    { Turned(halfCircle, 40), 0.385 }, { RoundedPrism(), 0.3 } };
  for (const auto& [body, size] : bodies)
  {
    const Meshed whole = MakeMesh(body, Uniform(size));
    const auto count = static_cast<double>(whole.Mesh.Points.size());
    for (const Soup& other : { Split(body), Rotated(body) })
    {
      const Meshed again = MakeMesh(other, Uniform(size));
      EXPECT_EQ(EulerNumber(whole.Mesh), EulerNumber(again.Mesh));
      EXPECT_NEAR(static_cast<double>(again.Mesh.Points.size()), count, 0.03 * count)
        << size << ", triangles: " << other.Mesh.NumberOfTriangles();
    }
  }
}

TEST(SurfaceMesher, MakesCornersOneThatAreNear)
{
  // A chamfer of .07 f, and one of .7 f.
  for (const double cut : { 0.01, 0.1 })
  {
    const Soup prism =
      Prism({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 - cut }, { 1.0 - cut, 1.0 }, { 0.0, 1.0 } },
        { 0.5, 0.5, 0.0 });
    const Meshed meshed = MakeMesh(prism, Uniform(0.2));
    ASSERT_TRUE(meshed.Problems.Groups().empty()) << cut;
    EXPECT_TRUE(IsClosed(meshed.Mesh)) << cut;
    EXPECT_EQ(EulerNumber(meshed.Mesh), 2) << cut;
    EXPECT_NEAR(Volume(meshed), 1.0 - 0.5 * cut * cut, 0.3 * cut * cut) << cut;
    const auto corners =
      std::count(meshed.Mesh.Kinds.begin(), meshed.Mesh.Kinds.end(), SurfaceVertexKind::Corner);
    EXPECT_EQ(corners, cut < 0.02 ? 8 : 10) << cut;
  }
}

TEST(SurfaceMesher, KeepsFinsOrTellsThatTheyAreTooSmall)
{
  for (const double size : { 0.2, 0.7 })
  {
    Soup soup;
    soup.AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, 16);
    soup.Add({ 0.5, 0.5, 1.0 }, { 0.5625, 0.5, 1.0 }, { 0.53125, 0.5, 1.03 });
    const Meshed meshed = MakeMesh(soup, Uniform(size));
    ASSERT_FALSE(meshed.Problems.HasErrors()) << size;
    const std::vector<SurfaceEdgeKind>& kinds = meshed.Mesh.EdgeKinds;
    const bool isKept = std::count(kinds.begin(), kinds.end(), SurfaceEdgeKind::NonManifold) > 0;
    EXPECT_EQ(isKept, size < 0.5);
    EXPECT_EQ(meshed.Problems.Count(ProblemCode::LostFeatures), isKept ? 0 : 1);
  }
}

TEST(SurfaceMesher, DividesLinesAlongEachOtherInTurn)
{
  // A plate a third of the spacing thick: triangles of its rim with aligned vertices would have
  // angles of 18 degrees.
  const Meshed meshed = MakeMesh(BoxOf({ 3.0, 3.0, 0.0375 }), Uniform(0.36));
  ASSERT_TRUE(meshed.Problems.Groups().empty());
  EXPECT_TRUE(IsClosed(meshed.Mesh));
  EXPECT_GT(SmallestAngle(meshed), 24.0);
  EXPECT_NEAR(LengthOfLines(meshed.Mesh), 24.15, 1e-11); // vertices of lines are on them
}

TEST(SurfaceMesher, SlidesVerticesAlongLinesNearEachOther)
{
  // A step as wide as a quarter of f as used: with aligned vertices angles of 13 degrees.
  const Meshed meshed = MakeMesh(Turned({ { 0.0, 0.0 }, { 0.6, 0.0 }, { 0.6, 0.3 }, { 0.588, 0.3 },
                                          { 0.588, 0.6 }, { 0.0, 0.6 } },
                                   96),
    Uniform(0.2));
  ASSERT_FALSE(meshed.Problems.HasErrors());
  EXPECT_TRUE(IsClosed(meshed.Mesh));
  EXPECT_EQ(EulerNumber(meshed.Mesh), 2);
  EXPECT_GT(SmallestAngle(meshed), 22.0);
  for (std::size_t v = 0; v < meshed.Mesh.Points.size(); ++v)
  {
    const Point3& p = meshed.Mesh.Points[v];
    const bool isOnRing = std::abs(p.Z - 0.3) < 1e-12 && std::hypot(p.X, p.Y) > 0.585;
    EXPECT_TRUE(!isOnRing || meshed.Mesh.Kinds[v] == SurfaceVertexKind::Line) << v;
  }
}

TEST(SurfaceMesher, ApproachesFacesThatTurnByLessThanTheFeatureAngle)
{
  // A column of ten faces that turn by 36 degrees.
  const Soup column = Turned({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } }, 10);
  SurfaceMesherOptions options = Uniform(0.25);
  const auto far = [&column, &options]
  {
    const BitingSurface mesh = MakeMesh(column, options).Mesh;
    return std::count_if(mesh.Deviations.begin(), mesh.Deviations.end(),
      [](double deviation) { return deviation > 0.08; });
  };
  const auto relaxed = far();
  options.Relaxation = false;
  EXPECT_LT(3 * relaxed, far());
  options.Relaxation = true;
  EXPECT_GT(SmallestAngle(MakeMesh(column, options)), 30.0);
}

TEST(SurfaceMesher, LowersTheSpacingAtRoundingsTooSharpForAQuarterOfIt)
{
  // A cube with an edge rounded by .03 f.
  constexpr double radius = 0.01;
  std::vector<std::array<double, 2>> polygon{ { 0.0, 0.0 }, { 1.0, 0.0 } };
  for (int k = 0; k <= 8; ++k)
  {
    const double angle = 1.5707963267948966 * k / 8;
    polygon.push_back(
      { 1.0 - radius + radius * std::cos(angle), 1.0 - radius + radius * std::sin(angle) });
  }
  polygon.push_back({ 0.0, 1.0 });
  const Meshed meshed = MakeMesh(Prism(polygon, { 0.5, 0.5, 0.0 }), Uniform(0.3));
  ASSERT_FALSE(meshed.Problems.HasErrors());
  EXPECT_TRUE(IsClosed(meshed.Mesh));
  for (std::size_t t = 0; t < meshed.Triangles(); ++t)
  {
    double size = 0.0;
    for (std::size_t slot = 3 * t; slot < 3 * t + 3; ++slot)
    {
      size += meshed.Mesh.Spacing[static_cast<std::size_t>(meshed.Mesh.Corners[slot])] / 3.0;
    }
    EXPECT_LT(meshed.Mesh.Deviations[t] * size, 0.08 * 0.3) << t;
  }
}

TEST(SurfaceMesher, HalvesAQuarterOfTheSpacingTwiceAtTurns)
{
  SurfaceGround ground; // a cube whose edges are no features
  ground.Mesh = Judge(BoxOf({ 1.0, 1.0, 1.0 })).Surface.Mesh;
  for (std::size_t t = 0; t < ground.Mesh.NumberOfTriangles(); ++t)
  {
    const Point3 normal = ground.Mesh.Normal(t);
    ground.Normals.push_back((1.0 / Length(normal)) * normal);
    ground.Mesh.Cells[t] = static_cast<Id>(t);
  }
  ground.Flags.resize(ground.Mesh.Corners.size());
  ground.Given.resize(ground.Mesh.Points.size(), 0.3);
  ground.Sizes.resize(ground.Mesh.Points.size(), 0.25 * 0.3);
  Pulse pulse(NoMonitor());
  LinkGround(ground, pulse);
  EXPECT_TRUE(HalveAtTurns(ground, pulse));
  EXPECT_TRUE(HalveAtTurns(ground, pulse));
  EXPECT_FALSE(HalveAtTurns(ground, pulse));
  EXPECT_NEAR(ground.Sizes.front(), 0.3 / 16.0, 1e-9);
}

TEST(SurfaceMesher, HalvesNoSpacingAtTurnsWhereThatMakesTooManyVertices)
{
  SurfaceMesherOptions options = Uniform(0.3);
  options.MaximumNumberOfVertices = 600;
  const Meshed meshed = MakeMesh(RoundedPrism(), options);
  EXPECT_FALSE(meshed.Problems.HasErrors());
  EXPECT_EQ(EulerNumber(meshed.Mesh), 2);
}

TEST(SurfaceMesher, KeepsHolesThatFacetsCloseThoughNoneIsAtFault)
{
  for (const double radius : { 0.035, 0.045, 0.05, 0.055 }) // in f
  {
    const Meshed meshed = MakeMesh(
      Turned(
        { { radius, -1.0 }, { 2.0, -1.0 }, { 2.0, 1.0 }, { radius, 1.0 }, { radius, -1.0 } }, 12),
      Uniform(1.0));
    ASSERT_FALSE(meshed.Problems.HasErrors()) << radius;
    EXPECT_TRUE(IsClosed(meshed.Mesh)) << radius;
    EXPECT_EQ(EulerNumber(meshed.Mesh), 0) << radius;
  }
}

TEST(SurfaceMesher, MeshesABoxWithItsEdgesAndCorners)
{
  const Meshed meshed = MakeMesh(BoxOf({ 1.0, 1.0, 1.0 }), Uniform(0.1));
  ASSERT_TRUE(meshed.Problems.Groups().empty());
  EXPECT_TRUE(IsClosed(meshed.Mesh));
  EXPECT_EQ(EulerNumber(meshed.Mesh), 2);
  EXPECT_NEAR(Volume(meshed), 1.0, 1e-12);
  EXPECT_NEAR(Area(meshed), 6.0, 1e-11);
  EXPECT_NEAR(LengthOfLines(meshed.Mesh), 12.0, 1e-11);
  EXPECT_GT(SmallestAngle(meshed), 30.0);
  std::vector<Id> originals;
  for (std::size_t v = 0; v < meshed.Mesh.Points.size(); ++v)
  {
    if (meshed.Mesh.Kinds[v] == SurfaceVertexKind::Corner)
    {
      originals.push_back(meshed.Mesh.OriginalPoints[v]);
    }
  }
  EXPECT_EQ(originals.size(), 8u);
  EXPECT_EQ(std::count(originals.begin(), originals.end(), NoId), 0);
}

TEST(SurfaceMesher, MeshesASphereWithGoodTriangles)
{
  const Meshed meshed = MakeMesh(Sphere(1.0, 40), Uniform(0.15));
  ASSERT_TRUE(meshed.Problems.Groups().empty());
  EXPECT_TRUE(IsClosed(meshed.Mesh));
  EXPECT_EQ(EulerNumber(meshed.Mesh), 2);
  EXPECT_GT(SmallestAngle(meshed), 35.0);
  EXPECT_NEAR(Volume(meshed), 4.18879, 0.1);
  const std::vector<double>& deviations = meshed.Mesh.Deviations;
  EXPECT_LT(*std::max_element(deviations.begin(), deviations.end()), 0.1);
}

TEST(SurfaceMesher, TakesASpacingThatJumpsAsItIsWhereTheGradationIsZero)
{
  SurfaceMesherOptions options;
  options.Gradation = 0.0;
  options.Spacing = [](const Point3& p) { return p.X < 1.0 ? 0.1 : 0.3; };
  const Meshed meshed = MakeMesh(BoxOf({ 3.0, 1.0, 1.0 }), options);
  EXPECT_TRUE(meshed.Problems.Groups().empty());
  const auto count = [&meshed](double low, double high)
  {
    long inside = 0;
    for (std::size_t slot = 0; slot < meshed.Mesh.Corners.size(); ++slot)
    {
      const double x = meshed.At(slot).X;
      inside += low < x && x < high ? 1 : 0;
    }
    return inside;
  };
  EXPECT_GT(count(0.2, 0.8), 6 * count(2.2, 2.8));
  EXPECT_GT(count(0.2, 0.8), 7 * count(1.3, 1.9)); // triangles reach from end to end
}

TEST(SurfaceMesher, BitesCoverTheSurfaceAndHaveNoEarlierCentre)
{
  SurfaceMesherOptions options = Uniform(0.2);
  options.KeepBites = true;
  const Soup soup = Sphere(1.0, 20);
  const BitingSurface mesh = MakeMesh(soup, options).Mesh;
  ASSERT_FALSE(mesh.BiteCenters.empty());
  const auto isNear = [&mesh](const Point3& place, std::size_t bite, double share)
  { return Distance(place, mesh.BiteCenters[bite]) < share * mesh.BiteRadii[bite]; };
  bool isFree = true;
  for (std::size_t later = 0; later < mesh.BiteCenters.size(); ++later)
  {
    for (std::size_t bite = 0; bite < later; ++bite)
    {
      isFree = isFree && !isNear(mesh.BiteCenters[later], bite, 0.9 - 1e-9);
    }
  }
  EXPECT_TRUE(isFree);
  for (std::size_t t = 0; t < soup.Mesh.NumberOfTriangles(); ++t)
  {
    bool isCovered = false;
    for (std::size_t bite = 0; bite < mesh.BiteCenters.size(); ++bite)
    {
      isCovered = isCovered || isNear(soup.Mesh.Middle(t), bite, 1.0 + 1e-9);
    }
    EXPECT_TRUE(isCovered) << t;
  }
}

/// Points far from the surface, which are triangulated with the bites, must not count.
TEST(SurfaceMesher, HasFacetsOfTheTriangulationOfItsVerticesAlone)
{
  SurfaceMesherOptions options = Uniform(0.2);
  options.Relaxation = false;
  const BitingSurface mesh = MakeMesh(Sphere(1.0, 20), options).Mesh;
  ASSERT_GT(mesh.Points.size(), 200u);
  const SpaceTriangulation all = TriangulateSpace(mesh.Points, {}, NoMonitor());
  const auto sorted = [](std::array<Id, 3> corners)
  {
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  std::vector<std::array<Id, 3>> facets;
  for (Id facet = 0; facet < 4 * all.Mesh.NumberOfSlots(); ++facet)
  {
    const auto corner = [&all, facet](int k)
    { return all.Order[static_cast<std::size_t>(all.Mesh.FacetCorner(facet, k))]; };
    if (all.Mesh.IsTetrahedron(TetMesh::CellOf(facet)))
    {
      facets.push_back(sorted({ corner(0), corner(1), corner(2) }));
    }
  }
  std::sort(facets.begin(), facets.end());
  for (std::size_t slot = 0; slot < mesh.Corners.size(); slot += 3)
  {
    const Id* c = &mesh.Corners[slot];
    EXPECT_TRUE(std::binary_search(facets.begin(), facets.end(), sorted({ c[0], c[1], c[2] })));
  }
}

TEST(SurfaceMesher, MeshesThinBoxesRightOrRefusesThem)
{
  for (const double share : { 2.0, 1.0, 0.8, 0.6, 0.5, 0.4, 0.3, 0.2 })
  {
    const double thickness = 0.1 * share;
    const Meshed meshed = MakeMesh(BoxOf({ 1.0, 1.0, thickness }), Uniform(0.1));
    EXPECT_TRUE(!meshed.Problems.HasErrors() || share < 0.3) << share;
    if (!meshed.Problems.HasErrors())
    {
      EXPECT_TRUE(IsClosed(meshed.Mesh)) << share;
      EXPECT_EQ(EulerNumber(meshed.Mesh), 2) << share;
      EXPECT_NEAR(Volume(meshed), thickness, 1e-12) << share;
    }
  }
}

TEST(SurfaceMesher, MeshesWedgesRightOrRefusesThemWithAPlace)
{
  for (const double degrees : { 90.0, 60.0, 45.0, 35.0, 25.0, 15.0, 5.0 })
  {
    const Soup soup = Wedge(degrees);
    const Meshed meshed = MakeMesh(soup, Uniform(0.1));
    EXPECT_TRUE(!meshed.Problems.HasErrors() || degrees < 45.0) << degrees;
    if (!meshed.Problems.HasErrors())
    {
      EXPECT_TRUE(IsClosed(meshed.Mesh)) << degrees;
      EXPECT_EQ(EulerNumber(meshed.Mesh), 2) << degrees;
      EXPECT_NEAR(Volume(meshed), Judge(soup).Figures().Volume, 1e-12) << degrees;
    }
    else
    {
      EXPECT_TRUE(meshed.Mesh.Points.empty()) << degrees;
      EXPECT_FALSE(meshed.Problems.Groups().front().First.front().Ids.empty()) << degrees;
    }
  }
}

TEST(SurfaceMesher, KeepsTheBorderOfAnOpenSurface)
{
  Soup soup;
  soup.AddSide({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, 2, true, 1);
  soup.AddSide({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, 0, true, 1);
  const Meshed meshed = MakeMesh(soup, Uniform(0.1));
  ASSERT_FALSE(meshed.Problems.HasErrors());
  EXPECT_EQ(EulerNumber(meshed.Mesh), 1);
  EXPECT_NEAR(Area(meshed), 2.0, 1e-12);
  EXPECT_NEAR(LengthOfLines(meshed.Mesh), 7.0, 1e-12);
  EXPECT_EQ(std::count(
              meshed.Mesh.EdgeKinds.begin(), meshed.Mesh.EdgeKinds.end(), SurfaceEdgeKind::Feature),
    10);
}

TEST(SurfaceMesher, MeshesSharpCornersOfBorders)
{
  constexpr double Degree = 3.14159265358979323846 / 180.0;
  for (const double degrees : { 5.0, 7.0, 10.0, 15.0, 20.0, 25.0, 30.0 })
  {
    for (const double length : { 3.6, 2.9 })
    {
      Soup soup;
      soup.Add({ 0.0, 0.0, 0.0 }, { length, 0.0, 0.0 },
        { 3.6 * std::cos(degrees * Degree), 3.6 * std::sin(degrees * Degree), 0.0 });
      const Meshed meshed = MakeMesh(soup, Uniform(0.3));
      ASSERT_FALSE(meshed.Problems.HasErrors()) << degrees << " " << length;
      EXPECT_EQ(EulerNumber(meshed.Mesh), 1) << degrees << " " << length;
      // Where sides differ a far corner turns by less than FeatureAngle, and is cut.
      const double area = 1.8 * length * std::sin(degrees * Degree);
      EXPECT_NEAR(Area(meshed), area, length == 3.6 ? 1e-11 : 0.01 * area) << degrees;
    }
  }
}

TEST(SurfaceMesher, MeshesABoxThatMissesATriangle)
{
  for (const std::size_t triangle : { 0, 3, 4, 9 })
  {
    Soup soup = BoxOf({ 2.0, 1.0, 0.6 });
    const double whole = 7.6;
    const double part = triangle < 4 ? 0.3 : triangle < 8 ? 0.6 : 1.0;
    soup.Remove(triangle);
    const Meshed meshed = MakeMesh(soup, Uniform(0.2));
    ASSERT_TRUE(meshed.Problems.Groups().empty()) << triangle;
    EXPECT_EQ(EulerNumber(meshed.Mesh), 1) << triangle;
    EXPECT_NEAR(Area(meshed), whole - part, 1e-11) << triangle;
  }
}

TEST(SurfaceMesher, KeepsTheBorderOfRegionsOnAPlane)
{
  SurfaceMesherOptions options = Uniform(0.1);
  Soup soup;
  soup.AddSide({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, 2, true, 1);
  options.Regions = { 4, 7 };
  const Meshed meshed = MakeMesh(soup, options);
  ASSERT_FALSE(meshed.Problems.HasErrors());
  EXPECT_NEAR(LengthOfLines(meshed.Mesh), 4.0 + std::sqrt(2.0), 1e-12);
  double area = 0.0;
  for (std::size_t t = 0; t < meshed.Triangles(); ++t)
  {
    const Point3 a = meshed.At(3 * t);
    area += meshed.Mesh.Regions[t] == 4
      ? 0.5 * Length(Cross(meshed.At(3 * t + 1) - a, meshed.At(3 * t + 2) - a))
      : 0.0;
  }
  EXPECT_NEAR(area, 0.5, 1e-12);
}

TEST(SurfaceMesher, GivesTheSameMeshAgainAndScaledByAPowerOfTwo)
{
  const Meshed first = MakeMesh(BoxOf({ 1.0, 2.0, 0.5 }), Uniform(0.1));
  const Meshed again = MakeMesh(BoxOf({ 1.0, 2.0, 0.5 }), Uniform(0.1));
  const Meshed larger = MakeMesh(BoxOf({ 1024.0, 2048.0, 512.0 }), Uniform(102.4));
  EXPECT_EQ(first.Mesh.Points, again.Mesh.Points);
  EXPECT_EQ(first.Mesh.Corners, again.Mesh.Corners);
  EXPECT_EQ(first.Mesh.Corners, larger.Mesh.Corners);
}

TEST(SurfaceMesher, RefusesWhatCannotBeWithAReason)
{
  SurfaceMesherOptions options = Uniform(0.01);
  options.MaximumNumberOfVertices = 1000;
  const Meshed many = MakeMesh(BoxOf({ 1.0, 1.0, 1.0 }), options);
  EXPECT_TRUE(many.Problems.Has(ProblemCode::TooManyVertices));
  EXPECT_TRUE(many.Mesh.Points.empty());
  // A needle whose faces alone would have some 500, before it is bitten.
  options = Uniform(0.001);
  options.MaximumNumberOfVertices = 2000;
  const Meshed lines = MakeMesh(BoxOf({ 1.0, 1e-4, 1e-4 }), options);
  ASSERT_TRUE(lines.Problems.Has(ProblemCode::TooManyVertices));
  EXPECT_EQ(lines.Problems.Groups().front().First.front().Detail.rfind("at least 4e+03", 0), 0u);
  const Meshed none = MakeMesh(BoxOf({ 1.0, 1.0, 1.0 }), Uniform(0.0));
  EXPECT_TRUE(none.Problems.Has(ProblemCode::BadSpacing));
  EXPECT_TRUE(MakeMesh(Soup(), Uniform(0.1)).Problems.Groups().empty());
}

/// Wants to stop when it is asked for that time.
class StopAt : public SilentMonitor
{
public:
  explicit StopAt(int time)
    : Left(time)
  {
  }
  bool Advance(double) override { return --this->Left > 0; }

  int Left;
};

TEST(SurfaceMesher, GivesNoMeshWhenItIsStopped)
{
  const CheckedSurface surface = Judge(BoxOf({ 1.0, 1.0, 1.0 })).Surface;
  const auto most = 1000000;
  StopAt never(most);
  ProblemList none;
  EXPECT_FALSE(MakeBitingSurface(surface, Uniform(0.2), none, never).Points.empty());
  const int asked = most - never.Left;
  for (int time = 1; time <= asked; time += 7)
  {
    StopAt monitor(time);
    ProblemList problems;
    EXPECT_TRUE(MakeBitingSurface(surface, Uniform(0.2), problems, monitor).Points.empty());
    EXPECT_TRUE(problems.Has(ProblemCode::Aborted)) << time;
  }
}

} // namespace biting
