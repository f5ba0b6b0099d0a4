// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FaceRegions.h"

#include "OldPlaces.h"

#include <algorithm> // for max, max_element
#include <cmath>     // for abs
#include <cstddef>   // for faces

namespace biting
{

namespace
{

constexpr double ToleranceOfSums = 1e-9; // of the old mesh; for sums

// Of each face, the middle of its largest triangle: there rounding matters least.
std::vector<Point2> MiddlesOfFaces(const CavityMesh& cavity)
{
  const Triangulation& triangles = cavity.Triangles;
  const std::vector<Point2>& points = cavity.Bites.Points;
  std::vector<double> largest;
  std::vector<Point2> middles;
  for (Id triangle = 0; triangle < triangles.NumberOfTriangles(); ++triangle)
  {
    const Id* corners = triangles.Corners.data() + 3 * static_cast<std::size_t>(triangle);
    const auto face = static_cast<std::size_t>(triangles.Regions[triangle]);
    largest.resize(std::max(largest.size(), face + 1), 0.0);
    middles.resize(largest.size());
    const double area = AreaOfTriangle(points, corners);
    if (area > largest[face])
    {
      largest[face] = area;
      middles[face] = (1.0 / 3.0) * (points[corners[0]] + points[corners[1]] + points[corners[2]]);
    }
  }
  return middles;
}

using Areas = std::vector<double>; // one a region of the old mesh

/// What each region may gain or lose. A path whose places are within some distance of a segment
/// sweeps at most its length times that on its way to their nearest places there: to project onto a
/// segment makes nothing longer. So it is with the marked edges of a region and the tolerance.
/// Rounding may also give a sliver to a region that has no edge there: all regions may gain and
/// lose a strip on both sides of all edges, and a disc at their ends.
Areas AllowedDifferences(const OldMesh& mesh, const ChangedRegion& region,
  const EdgeTolerance& tolerance, std::size_t count)
{
  Areas allowed(count, 0.0);
  double shared = ToleranceOfSums * mesh.Area;
  for (const Id triangle : region.Triangles)
  {
    for (Id slot = 3 * triangle; slot < 3 * triangle + 3; ++slot)
    {
      if (mesh.Marks[slot] != NoId)
      {
        const Id start = mesh.Start(slot);
        const Id end = mesh.End(slot);
        const double length = Distance(mesh.Points[start], mesh.Points[end]);
        const double width = tolerance.IsAsked()
          ? tolerance.Tolerance * std::max(tolerance.Spacings[start], tolerance.Spacings[end])
          : 0.0;
        allowed[mesh.Regions[triangle]] += length * width;
        shared += 2.0 * mesh.Rounding * (length + 2.0 * mesh.Rounding);
      }
    }
  }
  for (double& area : allowed)
  {
    area += shared;
  }
  return allowed;
}

} // namespace

std::vector<Id> FindFaceRegions(
  const OldMesh& mesh, const ChangedRegion& region, const CavityMesh& cavity, Pulse& pulse)
{
  std::vector<Id> regions;
  for (const OldPlace& place : FindOldPlaces(mesh, region.Triangles, MiddlesOfFaces(cavity), pulse))
  {
    regions.push_back(mesh.Regions[place.Triangle]);
  }
  return regions;
}

std::string CheckAreas(const OldMesh& mesh, const ChangedRegion& region, const CavityMesh& cavity,
  const EdgeTolerance& tolerance)
{
  const Id last = *std::max_element(mesh.Regions.begin(), mesh.Regions.end());
  Areas differences(static_cast<std::size_t>(last) + 1, 0.0);
  for (const Id triangle : region.Triangles)
  {
    const Id* corners = mesh.Corners.data() + 3 * static_cast<std::size_t>(triangle);
    differences[mesh.Regions[triangle]] += AreaOfTriangle(mesh.Points, corners);
  }
  const Triangulation& triangles = cavity.Triangles;
  for (Id triangle = 0; triangle < triangles.NumberOfTriangles(); ++triangle)
  {
    const Id* corners = triangles.Corners.data() + 3 * static_cast<std::size_t>(triangle);
    differences[cavity.FaceRegions[triangles.Regions[triangle]]] -=
      AreaOfTriangle(cavity.Bites.Points, corners);
  }
  const Areas allowed = AllowedDifferences(mesh, region, tolerance, differences.size());
  for (std::size_t number = 0; number < differences.size(); ++number)
  {
    if (!(std::abs(differences[number]) <= allowed[number]))
    {
      return "region " + std::to_string(number) + " has another area";
    }
  }
  return {};
}

} // namespace biting
