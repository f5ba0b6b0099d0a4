// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GroundPatches.h"

#include "../../Base/DisjointSets.h"
#include "../Surface/NearestOnTriangle.h"

#include <algorithm> // for find_first_of, min
#include <array>     // for corners
#include <cmath>     // for abs

namespace biting
{

namespace
{

/// The corner opposite the side that the place is farthest beyond; 3 where it is above the inside:
/// then no place of the surface near its foot is as near.
std::size_t CornerAway(const std::array<Point3, 3>& t, const Point3& place)
{
  const Point3 normal = Cross(t[1] - t[0], t[2] - t[0]);
  std::size_t corner = 3;
  double least = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Point3& tail = t[(k + 1) % 3];
    const double part = Dot(Cross(t[(k + 2) % 3] - tail, place - tail), normal);
    corner = part <= least ? k : corner;
    least = std::min(least, part);
  }
  return corner;
}

} // namespace

GroundPatches::GroundPatches(const SurfaceGround& ground)
  : Ground(ground)
  , Patches(ground.Mesh.NumberOfTriangles())
{
  DisjointSets sets(this->Patches.size());
  for (std::size_t slot = 0; slot < ground.Across.size(); ++slot)
  {
    if (ground.Across[slot] != NoId)
    {
      sets.Unite(static_cast<Id>(slot / 3), ground.Across[slot] / 3);
    }
  }
  for (std::size_t t = 0; t < this->Patches.size(); ++t)
  {
    this->Patches[t] = sets.SetOf(static_cast<Id>(t));
  }
}

GroundPlace GroundPatches::Project(Id triangle, const Point3& place) const
{
  const SurfaceMesh& mesh = this->Ground.Mesh;
  GroundPlace best{ triangle, NearestPoint(mesh.Triangle(At(triangle)), place) };
  double least = Distance(best.Place, place);
  const Id patch = this->PatchOf(triangle);
  constexpr int MostSteps = 1000;
  bool isNearer = true;
  const auto goTo = [this, &mesh, &place, &best, &least, &isNearer](Id t)
  {
    constexpr double Nearer = 1.0 - 1e-12;
    // Where its plane is no nearer, it is not: so on plane ground a foot is the nearest.
    if (std::abs(Dot(this->Ground.NormalOf(At(t)), place - mesh.At(3 * At(t)))) >= Nearer * least)
    {
      return;
    }
    const Point3 foot = NearestPoint(mesh.Triangle(At(t)), place);
    const double distance = Distance(foot, place);
    if (distance < Nearer * least)
    {
      least = distance;
      best = { t, foot };
      isNearer = true;
    }
  };
  for (int step = 0; step < MostSteps && isNearer && least > 0.0; ++step)
  {
    isNearer = false;
    const std::size_t base = 3 * At(best.Triangle);
    const std::size_t away = CornerAway(mesh.Triangle(At(best.Triangle)), place);
    if (away < 3 && this->Ground.Across[base + away] != NoId)
    {
      goTo(this->Ground.Across[base + away] / 3);
    }
    // All around where that is no nearer.
    const std::size_t end = away < 3 && !isNearer ? base + 3 : base;
    for (std::size_t slot = base; slot < end; ++slot)
    {
      const Id vertex = mesh.Corners[slot];
      for (const Id t : this->Ground.TrianglesAt[vertex])
      {
        const auto corners = mesh.Corners.begin() + 3 * t;
        const bool isSeen = std::find_first_of(corners, corners + 3, mesh.Corners.begin() + base,
                              mesh.Corners.begin() + slot) != corners + 3; // at an earlier vertex
        if (!isSeen && this->PatchOf(t) == patch)
        {
          goTo(t);
        }
      }
    }
  }
  return best;
}

} // namespace biting
