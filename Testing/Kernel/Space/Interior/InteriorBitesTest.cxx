// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Space/Interior/InteriorBites.h"
#include "Space/Interior/BodySpacing.h"
#include "Space/Interior/CubeMeetings.h"

#include "Space/Delaunay/SpaceTriangulation.h"
#include "Space/Meshing/SurfaceMesher.h"
#include "Space/Quality/TetQuality.h"
#include "Space/Surface/SurfaceShapes.h"
#include "Support/Dice.h"
#include "Support/Monitors.h"

#include <gtest/gtest.h>

#include <algorithm> // for max, min, sort
#include <array>     // for facets
#include <cmath>     // for sqrt
#include <set>       // for facets
#include <string>    // for names

namespace biting
{

namespace
{

constexpr double Guard = 0.9; // of bites: no center is nearer
constexpr double SphereConstant = 0.885;
constexpr double CubeConstant = 0.7;

enum class BodyKind
{
  Box, ///< the unit cube
  Ball ///< of radius 1
};

/// A body with its boundary, as its bites leave it.
struct BittenBody
{
  BodyKind Kind;
  BodyBoundary Boundary;
  std::vector<CubeAxes> BoundaryAxes;
  InteriorBites Bites;
  int InsideTests = 0;

  bool IsInside(const Point3& x) const
  {
    return this->Kind == BodyKind::Ball
      ? Dot(x, x) < 1.0
      : std::min({ x.X, x.Y, x.Z }) > 0.0 && std::max({ x.X, x.Y, x.Z }) < 1.0;
  }

  /// In the norm of a cube, or Euclid's.
  static double DistanceOf(const Point3& way, const CubeAxes* axes)
  {
    double distance = axes == nullptr ? Length(way) : 0.0;
    for (std::size_t d = 0; d < 3 && axes != nullptr; ++d)
    {
      distance = std::max(distance, std::abs(Dot((*axes)[d], way)));
    }
    return distance;
  }

  /// In half sides of a cube, or in radii of a sphere.
  double DistanceFrom(std::size_t bite, const Point3& x) const
  {
    const CubeAxes* axes = this->Bites.Axes.empty() ? nullptr : &this->Bites.Axes[bite];
    return DistanceOf(x - this->Bites.Centers[bite], axes) / this->Bites.Radii[bite];
  }

  bool IsTaken(const Point3& x) const
  {
    bool isTaken = false;
    for (std::size_t k = 0; k < this->Bites.Centers.size() && !isTaken; ++k)
    {
      isTaken = this->DistanceFrom(k, x) <= 1.0;
    }
    for (std::size_t k = 0; k < this->Boundary.Centers.size() && !isTaken; ++k)
    {
      const double share = this->Bites.Axes.empty() ? SphereConstant : CubeConstant;
      isTaken = DistanceOf(x - this->Boundary.Centers[k],
                  this->Bites.Axes.empty() ? nullptr : &this->BoundaryAxes[k + 1]) <=
        share * this->Boundary.Sizes[k];
    }
    for (std::size_t k = 0; k < this->Boundary.Balls.size() && !isTaken; ++k)
    {
      const EmptyBall& ball = this->Boundary.Balls[k];
      isTaken = Distance(x, ball.Center) <= ball.Radius;
    }
    return isTaken;
  }

  std::vector<Point3> Points() const
  {
    std::vector<Point3> points = this->Boundary.Centers;
    points.insert(points.end(), this->Bites.Centers.begin(), this->Bites.Centers.end());
    return points;
  }

  std::vector<double> Sizes() const
  {
    std::vector<double> sizes = this->Boundary.Sizes;
    sizes.insert(sizes.end(), this->Bites.Sizes.begin(), this->Bites.Sizes.end());
    return sizes;
  }
};

/// The ball about the place on the surface that is at equal powers from the vertices of a facet.
EmptyBall BallOf(const BittenBody& body, const Id* corners)
{
  const BodyBoundary& boundary = body.Boundary;
  const auto at = [&boundary, corners](std::size_t k)
  { return boundary.Centers[static_cast<std::size_t>(corners[k])]; };
  const auto weight = [&boundary, corners](std::size_t k)
  { return boundary.Weights[static_cast<std::size_t>(corners[k])]; };
  const Point3 u = at(1) - at(0);
  const Point3 v = at(2) - at(0);
  const Point3 normal = Cross(u, v);
  Point3 way = (0.5 / Dot(normal, normal)) *
    ((Dot(u, u) + weight(0) - weight(1)) * Cross(v, normal) +
      (Dot(v, v) + weight(0) - weight(2)) * Cross(normal, u));
  if (body.Kind == BodyKind::Ball)
  {
    // The centers are equally far from the middle of the sphere: so is the dual line.
    const Point3 foot = at(0) + way;
    way = 1.0 / Length(foot) * foot - at(0);
  }
  return { at(0) + way, std::sqrt(std::max(0.0, Dot(way, way) - weight(0))) };
}

BittenBody BodyOf(BodyKind kind, const std::function<double(const Point3&)>& spacing)
{
  BittenBody body;
  body.Kind = kind;
  Soup soup = Sphere(1.0, 40);
  if (kind == BodyKind::Box)
  {
    soup = Soup();
    soup.AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  }
  SurfaceMesherOptions options;
  options.Spacing = spacing;
  options.Relaxation = false;
  ProblemList problems;
  BitingSurface surface = MakeBitingSurface(Judge(soup).Surface, options, problems, NoMonitor());
  EXPECT_FALSE(problems.HasErrors());
  BodyBoundary& boundary = body.Boundary;
  for (std::size_t k = 0; k < surface.Points.size(); ++k)
  {
    Point3& point = surface.Points[k];
    point = kind == BodyKind::Ball ? 1.0 / Length(point) * point : point;
    const double radius =
      surface.Kinds[k] == SurfaceVertexKind::Surface ? 0.0 : 0.9 * surface.Spacing[k];
    boundary.Weights.push_back(radius * radius);
  }
  boundary.Centers = surface.Points;
  boundary.Sizes = surface.Spacing;
  boundary.Facets = surface.Corners;
  for (std::size_t slot = 0; slot < boundary.Facets.size(); slot += 3)
  {
    boundary.Balls.push_back(BallOf(body, &boundary.Facets[slot]));
  }
  boundary.Spacing = spacing;
  return body;
}

void Bite(BittenBody& body, SpaceBiteShape shape, double constant = 0.0)
{
  body.Boundary.IsInside = [&body](const Point3& x)
  {
    ++body.InsideTests;
    return body.IsInside(x);
  };
  Pulse pulse(NoMonitor());
  body.BoundaryAxes = AxesOfBoundary(body.Boundary);
  body.Bites = BiteInterior(body.Boundary, shape, 1000000, pulse, constant);
}

BittenBody BiteBody(BittenBody body, SpaceBiteShape shape, double constant = 0.0)
{
  Bite(body, shape, constant);
  body.Boundary.IsInside = nullptr; // it refers to this body
  return body;
}

/// h at x = 0, growing along x.
std::function<double(const Point3&)> Graded(double h, double slope)
{
  return [h, slope](const Point3& x) { return h + slope * std::max(0.0, x.X); };
}

/// The tetrahedra between the points of a convex body.
struct RawMesh
{
  SpaceTriangulation Cells;
  std::vector<Id> Corners;
};

RawMesh Triangulate(const BittenBody& body)
{
  RawMesh raw;
  std::vector<double> weights = body.Boundary.Weights;
  weights.resize(weights.size() + body.Bites.Centers.size(), 0.0);
  raw.Cells = TriangulateSpace(body.Points(), weights, NoMonitor());
  const TetMesh& mesh = raw.Cells.Mesh;
  for (Id cell = 0; cell < mesh.NumberOfSlots(); ++cell)
  {
    for (Id slot = 4 * cell; slot < 4 * cell + 4 && mesh.IsTetrahedron(cell); ++slot)
    {
      const Id vertex = mesh.Corners[TetMesh::Index(slot)];
      raw.Corners.push_back(raw.Cells.Order[TetMesh::Index(vertex)]);
    }
  }
  return raw;
}

struct CaseOfBody
{
  BittenBody Body;
  double Slope;
  std::string Name;
};

/// Made once for all laws.
const std::vector<CaseOfBody>& AllBodies()
{
  static const std::vector<CaseOfBody> bodies = []
  {
    std::vector<CaseOfBody> made;
    for (const BodyKind kind : { BodyKind::Box, BodyKind::Ball })
    {
      for (const double slope : { 0.0, 0.06, 0.2, 0.3 })
      {
        const BittenBody body = BodyOf(kind, Graded(kind == BodyKind::Box ? 0.16 : 0.35, slope));
        const std::string name =
          (kind == BodyKind::Box ? "box, slope " : "ball, slope ") + std::to_string(slope);
        made.push_back({ BiteBody(body, SpaceBiteShape::Sphere), slope, name });
        made.push_back({ BiteBody(body, SpaceBiteShape::Cube), slope, name + ", cubes" });
      }
    }
    return made;
  }();
  return bodies;
}

template <typename Law>
void ForBodies(const Law& law)
{
  for (const CaseOfBody& one : AllBodies())
  {
    SCOPED_TRACE(one.Name);
    law(one.Body, one.Slope);
  }
}

} // namespace

TEST(InteriorBites, TakeAllOfTheInside)
{
  ForBodies(
    [](const BittenBody& body, double)
    {
      Dice dice(7);
      int free = 0;
      for (int k = 0; k < 3000; ++k)
      {
        const Point3 x{ dice.Between(-1.0, 1.0), dice.Between(-1.0, 1.0), dice.Between(-1.0, 1.0) };
        free += body.IsInside(x) && !body.IsTaken(x) ? 1 : 0;
      }
      EXPECT_EQ(free, 0);
    });
}

/// Lemma 4.3. And the balls of the paper's lemma 4.2 do not overlap: of c_p f with
/// c_p = c / (2 + slope c), where c = .9 of the constant.
TEST(InteriorBites, HaveNoCenterInAnEarlierOne)
{
  ForBodies(
    [](const BittenBody& body, double slope)
    {
      const InteriorBites& bites = body.Bites;
      ASSERT_GT(bites.Centers.size(), 20u);
      const double c = Guard * bites.Radii[0] / bites.Sizes[0];
      const double packing = c / (2.0 + slope * c);
      double nearest = 1.0;
      double overlap = 0.0;
      for (std::size_t k = 0; k < bites.Centers.size(); ++k)
      {
        for (std::size_t j = 0; j < k; ++j)
        {
          nearest = std::min(nearest, body.DistanceFrom(j, bites.Centers[k]));
          overlap = std::max(overlap,
            packing * (bites.Sizes[k] + bites.Sizes[j]) /
              Distance(bites.Centers[k], bites.Centers[j]));
        }
      }
      EXPECT_GE(nearest, Guard * (1.0 - 1e-12));
      EXPECT_LE(overlap, 1.0 + 1e-12);
    });
}

TEST(InteriorBites, AreInsideAndOutOfEmptyBallsAndWeights)
{
  ForBodies(
    [](const BittenBody& body, double)
    {
      int bad = 0;
      for (const Point3& x : body.Bites.Centers)
      {
        bad += body.IsInside(x) ? 0 : 1;
        for (const EmptyBall& ball : body.Boundary.Balls)
        {
          bad += Distance(x, ball.Center) < (1.0 - 1e-12) * ball.Radius ? 1 : 0;
        }
        for (std::size_t k = 0; k < body.Boundary.Centers.size(); ++k)
        {
          const Point3 apart = x - body.Boundary.Centers[k];
          bad += Dot(apart, apart) < (1.0 - 1e-12) * body.Boundary.Weights[k] ? 1 : 0;
        }
      }
      EXPECT_EQ(bad, 0);
    });
}

TEST(InteriorBites, LeaveAllFacetsOfTheBoundary)
{
  ForBodies(
    [](const BittenBody& body, double)
    {
      const RawMesh raw = Triangulate(body);
      std::set<std::array<Id, 3>> facets;
      for (std::size_t slot = 0; slot < raw.Corners.size(); ++slot)
      {
        std::array<Id, 3> facet{};
        for (std::size_t k = 0; k < 3; ++k)
        {
          facet[k] = raw.Corners[slot - slot % 4 + (slot + k + 1) % 4];
        }
        std::sort(facet.begin(), facet.end());
        facets.insert(facet);
      }
      std::size_t missing = 0;
      for (std::size_t slot = 0; slot < body.Boundary.Facets.size(); slot += 3)
      {
        std::array<Id, 3> facet{ body.Boundary.Facets[slot], body.Boundary.Facets[slot + 1],
          body.Boundary.Facets[slot + 2] };
        std::sort(facet.begin(), facet.end());
        missing += 1 - facets.count(facet);
      }
      EXPECT_EQ(missing, 0u);
      EXPECT_TRUE(raw.Cells.Hidden.empty());
      EXPECT_TRUE(raw.Cells.Duplicates.empty());
    });
}

/// As lemma 4.10. The centre of a cell is within c f(p) of a bite p, so that R <= c f(p); the
/// earlier end e of an edge is within 2 c f(p) of p, so that f(p) (1 - 2 s c) <= f(e); and
/// l >= .9 c f(e). Bites of this boundary are larger, and its empty balls smaller.
TEST(InteriorBites, BoundTheRadiusOverTheShortestEdge)
{
  for (const CaseOfBody& one : AllBodies())
  {
    const BittenBody& body = one.Body;
    if (body.Kind == BodyKind::Ball && body.Bites.Axes.empty())
    {
      const TetQuality quality =
        MeasureTetrahedra({ body.Points(), body.Sizes(), Triangulate(body).Corners });
      EXPECT_LE(
        quality.LargestRadiusEdgeRatio, 1.0 / (Guard * (1.0 - 2.0 * one.Slope * SphereConstant)));
    }
  }
}

TEST(InteriorBites, MakeEdgesOfF)
{
  for (const BodyKind kind : { BodyKind::Box, BodyKind::Ball })
  {
    const BittenBody bare = BodyOf(kind, Graded(kind == BodyKind::Box ? 0.09 : 0.17, 0.0));
    for (const SpaceBiteShape shape : { SpaceBiteShape::Sphere, SpaceBiteShape::Cube })
    {
      const BittenBody body = BiteBody(bare, shape);
      const TetQuality quality =
        MeasureTetrahedra({ body.Points(), body.Sizes(), Triangulate(body).Corners });
      EXPECT_NEAR(quality.MeanRelativeLength, 1.0, 0.04);
      EXPECT_LT(shape == SpaceBiteShape::Cube ? 0.0 : body.InsideTests,
        1.5 * static_cast<double>(body.Points().size()));
    }
  }
}

TEST(InteriorBites, OfAnyConstantTakeAllOfTheInside)
{
  for (const double constant : { 0.4, 1.5 })
  {
    const BittenBody body =
      BiteBody(BodyOf(BodyKind::Box, Graded(0.2, 0.0)), SpaceBiteShape::Sphere, constant);
    Dice dice(3);
    for (int k = 0; k < 1000; ++k)
    {
      EXPECT_TRUE(body.IsTaken({ dice.Unit(), dice.Unit(), dice.Unit() }));
    }
    for (const Point3& center : body.Bites.Centers)
    {
      EXPECT_TRUE(body.IsInside(center));
    }
  }
}

/// The axes of a cube on a face are those of the face; in the middle of a body those of the world.
TEST(InteriorBites, OfCubesHaveAxesOfFacesAtFirst)
{
  const double turn = 0.5;
  const auto turned = [turn](const Point3& x)
  {
    return Point3{ std::cos(turn) * x.X - std::sin(turn) * x.Y,
      std::sin(turn) * x.X + std::cos(turn) * x.Y, x.Z };
  };
  BittenBody body = BodyOf(BodyKind::Box, Graded(0.1, 0.0));
  for (Point3& center : body.Boundary.Centers)
  {
    center = turned(center);
  }
  for (EmptyBall& ball : body.Boundary.Balls)
  {
    ball.Center = turned(ball.Center);
  }
  body.Boundary.IsInside = [&body, turn](const Point3& x)
  {
    return body.IsInside({ std::cos(turn) * x.X + std::sin(turn) * x.Y,
      std::cos(turn) * x.Y - std::sin(turn) * x.X, x.Z });
  };
  Pulse pulse(NoMonitor());
  body.Bites = BiteInterior(body.Boundary, SpaceBiteShape::Cube, 100000, pulse);
  ASSERT_FALSE(body.Bites.Axes.empty());
  const Point3 faceNormal = turned({ 1.0, 0.0, 0.0 });
  int aligned = 0;
  int ofWorld = 0;
  for (const CubeAxes& axes : body.Bites.Axes)
  {
    bool isAligned = false;
    bool isOfWorld = true;
    for (std::size_t d = 0; d < 3; ++d)
    {
      isAligned = isAligned || std::abs(Dot(axes[d], faceNormal)) > 1.0 - 1e-9;
      isOfWorld = isOfWorld && axes[d][d] == 1.0;
      EXPECT_NEAR(Dot(axes[d], axes[d]), 1.0, 1e-12);
      EXPECT_NEAR(Dot(axes[d], axes[(d + 1) % 3]), 0.0, 1e-12);
    }
    aligned += isAligned ? 1 : 0;
    ofWorld += isOfWorld ? 1 : 0;
  }
  EXPECT_GT(aligned, 100);
  EXPECT_GT(ofWorld, 20);
}

TEST(InteriorBites, StopAtTheMostAndWhereTheMonitorWantsTo)
{
  BittenBody body = BodyOf(BodyKind::Box, Graded(0.1, 0.0));
  body.Boundary.IsInside = [&body](const Point3& x) { return body.IsInside(x); };
  Pulse pulse(NoMonitor());
  EXPECT_EQ(BiteInterior(body.Boundary, SpaceBiteShape::Sphere, 20, pulse).Centers.size(), 21u);
  for (const SpaceBiteShape shape : { SpaceBiteShape::Sphere, SpaceBiteShape::Cube })
  {
    StoppingMonitor monitor(1);
    Pulse stopping(monitor);
    BiteInterior(body.Boundary, shape, 1000000, stopping);
    EXPECT_EQ(monitor.Calls, 2);
  }
  EXPECT_TRUE(BiteInterior({}, SpaceBiteShape::Sphere, 20, pulse).Centers.empty());
}

TEST(InteriorBites, TellHowFarTheyAre)
{
  BittenBody body = BodyOf(BodyKind::Box, Graded(0.06, 0.0));
  body.Boundary.IsInside = [&body](const Point3& x) { return body.IsInside(x); };
  RecordingMonitor monitor;
  Pulse pulse(monitor);
  BiteInterior(body.Boundary, SpaceBiteShape::Sphere, 1000000, pulse);
  EXPECT_TRUE(std::is_sorted(monitor.Fractions.begin(), monitor.Fractions.end()));
  EXPECT_GT(monitor.Fractions.back(), 0.6);
}

TEST(BodySpacing, GrowsFromLoweredVertices)
{
  Dice dice(11);
  const auto given = [](const Point3& x) { return 0.2 + 0.1 * x.X; };
  std::vector<Point3> centers;
  std::vector<double> sizes;
  for (int k = 0; k < 200; ++k)
  {
    centers.push_back({ dice.Unit(), dice.Unit(), dice.Unit() });
    sizes.push_back((k % 3 == 0 ? dice.Between(0.1, 1.0) : 1.0) * given(centers.back()));
  }
  Pulse pulse(NoMonitor());
  constexpr double Gradation = 0.3;
  const auto spacing = BodySpacing(given, centers, sizes, Gradation, pulse);
  const auto ungraded = BodySpacing(given, centers, sizes, 0.0, pulse); // the given f is
  for (int k = 0; k < 2000; ++k)
  {
    const Point3 x{ dice.Between(0.1, 0.9), dice.Between(0.1, 0.9), dice.Between(0.1, 0.9) };
    double least = given(x);
    for (std::size_t j = 0; j < centers.size(); j += 3)
    {
      least = std::min(least, sizes[j] + Gradation * Distance(x, centers[j]));
    }
    EXPECT_GE(spacing(x), 0.999999 * least);
    EXPECT_LE(spacing(x), std::min(given(x), 1.02 * least));
    EXPECT_EQ(ungraded(x), spacing(x));
  }
}

} // namespace biting
