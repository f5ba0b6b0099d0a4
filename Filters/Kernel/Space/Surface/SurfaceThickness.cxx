// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceThickness.h"

#include "NearestOnTriangle.h"

#include <algorithm> // for find_first_of, min
#include <array>     // for corners

namespace biting
{

namespace
{

constexpr double LeastOpposition = 0.9396926207859084; // cos 20 degrees
constexpr double ShareToBegin = 0.48; // of the diameter: below half, so that round bodies end soon
constexpr std::size_t MostSamples = 100000;
constexpr std::size_t MostTests = 4000000;

// Shrinks balls that touch the surface from inside.
class ThinnestBall
{
public:
  ThinnestBall(
    const SurfaceMesh& mesh, const BoxTree<SurfaceItem, 3>& tree, const SurfaceShells& shells)
    : Mesh(mesh)
    , Tree(tree)
    , Shells(shells)
    , Diameter(mesh.Bounds().Diagonal())
  {
  }

  bool IsSpent() const { return this->Tests > MostTests; }
  void TryAt(std::size_t triangle);

  SurfaceThickness Best;

private:
  Id FindInside(std::size_t triangle, const Point3& center, double radius, Point3& nearest);
  bool Faces(std::size_t a, std::size_t b) const;

  const SurfaceMesh& Mesh;
  const BoxTree<SurfaceItem, 3>& Tree;
  const SurfaceShells& Shells;
  double Diameter;
  std::size_t Tests = 0;
};

void ThinnestBall::TryAt(std::size_t triangle)
{
  const Point3 doubled = this->Mesh.Normal(triangle);
  const double length = Length(doubled);
  if (!this->Shells.IsSolid(triangle) || length == 0.0)
  {
    return;
  }
  const Point3 normal = (1.0 / length) * doubled;
  const Point3 place = this->Mesh.Middle(triangle);
  double radius = ShareToBegin * this->Diameter;
  constexpr int MostRounds = 20;
  bool isLess = true;
  for (int round = 0; round < MostRounds && isLess && !this->IsSpent(); ++round)
  {
    const Point3 center = place - radius * normal;
    Point3 nearest;
    const Id other = this->FindInside(triangle, center, radius, nearest);
    const Point3 apart = place - nearest;
    const double height = other == NoId ? 0.0 : Dot(apart, normal);
    const double least = height > 0.0 ? Dot(apart, apart) / (2.0 * height) : radius;
    constexpr double Shrinks = 1.0 - 1e-9;
    isLess = least < Shrinks * radius;
    if (isLess)
    {
      radius = least;
      this->Best = { 2.0 * radius, place - radius * normal, static_cast<Id>(triangle), other };
      this->Diameter = 2.0 * radius;
    }
  }
}

// Whether the triangles have opposite normals, and no common corner: walls, and no crease.
bool ThinnestBall::Faces(std::size_t a, std::size_t b) const
{
  const Point3 normalA = this->Mesh.Normal(a);
  const Point3 normalB = this->Mesh.Normal(b);
  const Id* const corners = &this->Mesh.Corners[3 * a];
  return -Dot(normalA, normalB) >= LeastOpposition * Length(normalA) * Length(normalB) &&
    std::find_first_of(corners, corners + 3, &this->Mesh.Corners[3 * b],
      &this->Mesh.Corners[3 * b] + 3) == corners + 3;
}

// The nearest triangle within the ball that faces the given one; NoId where there is none.
Id ThinnestBall::FindInside(
  std::size_t triangle, const Point3& center, double radius, Point3& nearest)
{
  Id found = NoId;
  this->Tree.Search(center, 1.0, radius,
    [this, triangle, &center, &nearest, &found](const SurfaceItem& item, double limit)
    {
      ++this->Tests;
      const auto t = static_cast<std::size_t>(item.Triangle);
      if (!this->Shells.IsSolid(t) || !this->Faces(triangle, t))
      {
        return this->IsSpent() ? 0.0 : limit;
      }
      const Point3 place = NearestPoint(this->Mesh.Triangle(t), center);
      const double distance = Distance(place, center);
      if (distance < limit)
      {
        nearest = place;
        found = item.Triangle;
      }
      return this->IsSpent() ? 0.0 : std::min(distance, limit);
    });
  return found;
}

} // namespace

SurfaceThickness SmallestThickness(const SurfaceMesh& mesh, const BoxTree<SurfaceItem, 3>& tree,
  const SurfaceShells& shells, Pulse& pulse)
{
  ThinnestBall ball(mesh, tree, shells);
  const std::size_t count = tree.Items().size();
  // A stride near the golden section of the number of triangles spreads also the first samples.
  const std::size_t samples = std::min(count, MostSamples);
  constexpr double Golden = 0.6180339887498949;
  pulse.ForEach(samples,
    [&ball, &tree, count](std::size_t k)
    {
      const double turn = static_cast<double>(k) * Golden;
      const double part = turn - static_cast<double>(static_cast<std::int64_t>(turn));
      const auto item = static_cast<std::size_t>(part * static_cast<double>(count));
      if (!ball.IsSpent())
      {
        ball.TryAt(static_cast<std::size_t>(tree.Items()[std::min(item, count - 1)].Triangle));
      }
    });
  return ball.Best;
}

} // namespace biting
