// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GroundPatches.h"

#include "../Surface/NearestOnTriangle.h"

#include <algorithm> // for find_first_of
#include <cmath>     // for abs

namespace biting
{

GroundPatches::GroundPatches(const SurfaceGround& ground)
  : Ground(ground)
  , Patches(ground.Mesh.NumberOfTriangles(), NoId)
{
  std::vector<Id> front;
  for (std::size_t t = 0; t < this->Patches.size(); ++t)
  {
    if (this->Patches[t] != NoId)
    {
      continue;
    }
    this->Patches[t] = static_cast<Id>(t);
    front.assign(1, static_cast<Id>(t));
    while (!front.empty())
    {
      const std::size_t base = 3 * At(front.back());
      front.pop_back();
      for (std::size_t slot = base; slot < base + 3; ++slot)
      {
        const Id across = ground.Across[slot];
        if (across != NoId && this->Patches[At(across / 3)] == NoId)
        {
          this->Patches[At(across / 3)] = static_cast<Id>(t);
          front.push_back(across / 3);
        }
      }
    }
  }
}

GroundPlace GroundPatches::Project(Id triangle, const Point3& place) const
{
  const SurfaceMesh& mesh = this->Ground.Mesh;
  GroundPlace best{ triangle, NearestPoint(mesh.Triangle(At(triangle)), place) };
  double least = Distance(best.Place, place);
  const Id patch = this->PatchOf(triangle);
  constexpr int MostSteps = 64;
  constexpr double Nearer = 1.0 - 1e-12;
  bool isNearer = true;
  for (int step = 0; step < MostSteps && isNearer && least > 0.0; ++step)
  {
    isNearer = false;
    const std::size_t base = 3 * At(best.Triangle);
    for (std::size_t slot = base; slot < base + 3; ++slot)
    {
      const Id vertex = mesh.Corners[slot];
      for (const Id t : this->Ground.TrianglesAt[vertex])
      {
        // Where its plane is no nearer, it is not: so on plane ground a foot is the nearest.
        const Point3& corner = mesh.At(3 * At(t));
        if (std::abs(Dot(this->Ground.NormalOf(At(t)), place - corner)) >= Nearer * least)
        {
          continue;
        }
        const auto corners = mesh.Corners.begin() + 3 * t;
        const bool isSeen = std::find_first_of(corners, corners + 3, mesh.Corners.begin() + base,
                              mesh.Corners.begin() + slot) != corners + 3; // at an earlier vertex
        if (isSeen || this->PatchOf(t) != patch)
        {
          continue;
        }
        const Point3 foot = NearestPoint(mesh.Triangle(At(t)), place);
        const double distance = Distance(foot, place);
        if (distance < Nearer * least)
        {
          least = distance;
          best = { t, foot };
          isNearer = true;
        }
      }
    }
  }
  return best;
}

} // namespace biting
