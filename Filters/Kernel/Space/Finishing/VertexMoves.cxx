// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "VertexMoves.h"

#include <algorithm> // for max, sort

namespace biting
{

namespace
{

/// What is better by less is no better.
constexpr double LeastGain = 1e-4;

} // namespace

void VertexMoves::Gather(Id vertex)
{
  this->Star.clear();
  for (const Id slot : this->Tets.StarOf(vertex))
  {
    const Id base = slot & ~3;
    const int* order = TetMesh::FacetCorners[slot & 3];
    const double badness = this->Tets.Badness[At(slot >> 2)];
    this->Star.push_back({ badness, badness, slot, this->Tets.PointOf(base + order[0]),
      this->Tets.PointOf(base + order[1]), this->Tets.PointOf(base + order[2]) });
  }
}

/// Whether all tetrahedra are positive there and none is worse than the limit.
bool VertexMoves::Suits(const Point3& place, double limit)
{
  for (Cone& cone : this->Star)
  {
    cone.Tried = TetShape(place, cone.A, cone.B, cone.C).Badness();
    if (!(cone.Tried < limit))
    {
      return false;
    }
  }
  for (const Cone& cone : this->Star)
  {
    if (Orient3D(place, cone.A, cone.B, cone.C) <= 0)
    {
      return false;
    }
  }
  return true;
}

void VertexMoves::Move(Id vertex, const Point3& place)
{
  this->Tets.Mesh.Points[At(vertex)] = place;
  ++this->Tets.Clock;
  for (Cone& cone : this->Star)
  {
    cone.Badness = cone.Tried;
    this->Tets.Badness[At(cone.Slot >> 2)] = cone.Tried;
    for (const Id corner : this->Tets.CornersOf(cone.Slot >> 2))
    {
      this->Tets.Touched[At(corner)] = this->Tets.Clock;
    }
  }
}

bool VertexMoves::TryFree(Id vertex, const Point3& place, double limit)
{
  if (!this->Suits(place, limit))
  {
    return false;
  }
  this->Move(vertex, place);
  this->Tets.Body.Sizes[At(vertex)] = this->Size(place);
  return true;
}

bool VertexMoves::TryOnGround(Id vertex, const Point3& place, double limit)
{
  const GroundPlace onGround = this->Normals.Project(vertex, place);
  if (!this->Suits(onGround.Place, limit) ||
    !this->Normals.AllowsMove(this->Tets, this->Tets.StarOf(vertex), vertex, onGround))
  {
    return false;
  }
  this->Move(vertex, onGround.Place);
  this->Normals.Move(vertex, onGround);
  return true;
}

bool VertexMoves::Smooth(Id vertex, double good)
{
  const std::vector<double>& sizes = this->Tets.Body.Sizes;
  const Point3 old = this->Tets.Mesh.PointAt(vertex);
  this->Gather(vertex);
  Point3 sum{};
  double mass = 0.0;
  double worst = 0.0;
  for (const Cone& cone : this->Star)
  {
    const TetShape shape(old, cone.A, cone.B, cone.C);
    const Id* c = &this->Tets.Mesh.Corners[At(cone.Slot & ~3)];
    const double size = sizes[At(c[0])] + sizes[At(c[1])] + sizes[At(c[2])] + sizes[At(c[3])];
    const double density = 1.0 / (size * size * size);
    const Point3 center = shape.WeightedCenter();
    sum.X += density * center.X;
    sum.Y += density * center.Y;
    sum.Z += density * center.Z;
    mass += 2.0 * density * shape.SixVolumes();
    worst = std::max(worst, cone.Badness);
  }
  const double limit = std::max(worst, good);
  for (const double share : { 1.0, 0.5 })
  {
    if (mass > 0.0 && this->TryFree(vertex, old + (share / mass) * sum, limit))
    {
      return true;
    }
  }
  return false;
}

bool VertexMoves::Improve(Id vertex, double good)
{
  if (vertex < this->Tets.Body.NumberOnLines ||
    this->Tried[At(vertex)] > this->Tets.Touched[At(vertex)])
  {
    return false;
  }
  this->Gather(vertex);
  const auto isWorse = [](const Cone& a, const Cone& b) { return a.Badness > b.Badness; };
  std::sort(this->Star.begin(), this->Star.end(), isWorse);
  const double before = this->Worst();
  const double size = this->Tets.Body.Sizes[At(vertex)];
  constexpr double Longest = 0.2;
  constexpr double Shortest = 0.008;
  double length = Longest * size;
  while (length > Shortest * size && this->Worst() > good)
  {
    if (this->Step(vertex, length))
    {
      std::sort(this->Star.begin(), this->Star.end(), isWorse);
    }
    else
    {
      length *= 0.5;
    }
  }
  this->Tried[At(vertex)] = ++this->Tets.Clock;
  return this->Worst() < before;
}

/// Tries the directions of a cube's faces and corners.
bool VertexMoves::Step(Id vertex, double length)
{
  constexpr double Corner = 0.5773502691896258;
  static constexpr double Directions[14][3] = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 },
    { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 }, { Corner, Corner, Corner },
    { -Corner, -Corner, -Corner }, { -Corner, Corner, Corner }, { Corner, -Corner, -Corner },
    { Corner, -Corner, Corner }, { -Corner, Corner, -Corner }, { Corner, Corner, -Corner },
    { -Corner, -Corner, Corner } };
  const Point3 old = this->Tets.Mesh.PointAt(vertex);
  const double limit = this->Worst() - LeastGain;
  for (const auto& d : Directions)
  {
    const Point3 place{ old.X + length * d[0], old.Y + length * d[1], old.Z + length * d[2] };
    if (vertex < this->Tets.Body.NumberOnBoundary ? this->TryOnGround(vertex, place, limit)
                                                  : this->TryFree(vertex, place, limit))
    {
      return true;
    }
  }
  return false;
}

} // namespace biting
