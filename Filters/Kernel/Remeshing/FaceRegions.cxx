// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FaceRegions.h"

#include "OldPlaces.h"

#include <algorithm> // for max, max_element
#include <cmath>     // for abs
#include <cstdint>   // for flags
#include <utility>   // for move

namespace biting
{

namespace
{

constexpr double ToleranceOfSums = 1e-9; // of the old mesh; for sums

/// What edges say about faces.
class FaceReader
{
public:
  FaceReader(const RegionEdges& edges, const CavityMesh& cavity)
    : Edges(edges)
    , Cavity(cavity)
    , Regions(NumberOfFaces(cavity), NoId)
    , AreUnclear(this->Regions.size(), 0)
  {
  }

  void Read()
  {
    const Triangulation& triangles = this->Cavity.Triangles;
    for (Id slot = 0; slot < static_cast<Id>(triangles.Corners.size()); ++slot)
    {
      if (triangles.Constraints[slot] != NoId)
      {
        const Id face = triangles.Regions[slot / 3];
        const Id region = this->RegionBeside(slot);
        Id& known = this->Regions[face];
        known = known == NoId ? region : known;
        this->AreUnclear[face] |= static_cast<std::uint8_t>(region == NoId || region != known);
      }
    }
  }

  std::vector<Id> UnclearFaces() const
  {
    std::vector<Id> faces;
    for (Id face = 0; face < static_cast<Id>(this->Regions.size()); ++face)
    {
      if (this->AreUnclear[face] || this->Regions[face] == NoId)
      {
        faces.push_back(face);
      }
    }
    return faces;
  }

  // Of the largest triangle of each: it is where rounding matters least.
  std::vector<Point2> MiddlesOf(const std::vector<Id>& faces) const
  {
    const Triangulation& triangles = this->Cavity.Triangles;
    const std::vector<Point2>& points = this->Cavity.Bites.Points;
    std::vector<double> largest(this->Regions.size(), 0.0);
    std::vector<Point2> middles(this->Regions.size());
    for (Id triangle = 0; triangle < triangles.NumberOfTriangles(); ++triangle)
    {
      const Id* corners = triangles.Corners.data() + 3 * static_cast<std::size_t>(triangle);
      const Id face = triangles.Regions[triangle];
      const double area = AreaOfTriangle(points, corners);
      if (area > largest[face])
      {
        largest[face] = area;
        middles[face] =
          (1.0 / 3.0) * (points[corners[0]] + points[corners[1]] + points[corners[2]]);
      }
    }
    std::vector<Point2> wanted;
    wanted.reserve(faces.size());
    for (const Id face : faces)
    {
      wanted.push_back(middles[face]);
    }
    return wanted;
  }

  void Set(Id face, Id region) { this->Regions[face] = region; }
  std::vector<Id> Take() { return std::move(this->Regions); }

private:
  static std::size_t NumberOfFaces(const CavityMesh& cavity)
  {
    Id count = 0;
    for (const Id face : cavity.Triangles.Regions)
    {
      count = std::max(count, face + 1);
    }
    return static_cast<std::size_t>(count);
  }

  // What the edge at a slot has on the side of the slot's triangle.
  Id RegionBeside(Id slot) const
  {
    const BitingResult& bites = this->Cavity.Bites;
    const std::vector<Id>& corners = this->Cavity.Triangles.Corners;
    const Id constraint = this->Cavity.Triangles.Constraints[slot];
    const Id first = slot - slot % 3;
    const Point2 along =
      bites.Points[corners[first + (slot + 2) % 3]] - bites.Points[corners[first + (slot + 1) % 3]];
    const Point2 direction =
      bites.Points[bites.EdgeEnds[constraint]] - bites.Points[bites.EdgeStarts[constraint]];
    const RegionEdge& edge = this->Edges.Edges[bites.EdgeSegments[constraint]];
    return Dot(along, direction) > 0.0 ? edge.LeftRegion : edge.RightRegion;
  }

  const RegionEdges& Edges;
  const CavityMesh& Cavity;
  std::vector<Id> Regions;
  std::vector<std::uint8_t> AreUnclear;
};

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

std::vector<Id> FindFaceRegions(const OldMesh& mesh, const ChangedRegion& region,
  const RegionEdges& edges, const CavityMesh& cavity, Pulse& pulse)
{
  FaceReader reader(edges, cavity);
  reader.Read();
  const std::vector<Id> unclear = reader.UnclearFaces();
  const std::vector<OldPlace> places =
    FindOldPlaces(mesh, region.Triangles, reader.MiddlesOf(unclear), pulse);
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    reader.Set(unclear[k], mesh.Regions[places[k].Triangle]);
  }
  return reader.Take();
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
