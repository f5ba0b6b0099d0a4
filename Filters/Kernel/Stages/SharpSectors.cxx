// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SharpSectors.h"

#include "../Base/Numbers.h"
#include "../Biting/Spokes.h"
#include "StageProblems.h"

#include <algorithm> // for all_of, any_of
#include <array>     // for triangles
#include <cmath>     // for atan2
#include <vector>    // for the sectors

namespace biting
{

namespace
{

constexpr double NarrowInDegrees = 0.01;
constexpr double CosineOf30 = 0.86602540378443864676;

double AngleInDegrees(const SharpSector& sector)
{
  const Point2& first = sector.First.Direction;
  const Point2& last = sector.Last.Direction;
  return DegreesPerRadian * std::atan2(Cross(first, last), Dot(first, last));
}

using Corners = std::array<Id, 3>;

class SharpCornerFinder
{
public:
  SharpCornerFinder(const Domain& domain, const BitingResult& bites, Pulse& pulse)
    : Geometry(domain)
    , Bites(bites)
  {
    const SpokesOfVertices spokes(domain);
    for (Id vertex = 0; vertex < domain.NumberOfVertices() && pulse.Beat(); ++vertex)
    {
      this->FirstSectors.push_back(static_cast<Id>(this->Sectors.size()));
      for (const SharpSector& sector : spokes.SharpSectorsAt(vertex))
      {
        this->Sectors.push_back({ vertex, sector.First.Segment, sector.Last.Segment });
      }
    }
    this->FirstSectors.push_back(static_cast<Id>(this->Sectors.size()));
  }

  bool HasSectors() const { return !this->Sectors.empty(); }

  // The corner is one of the triangle's, or an end of the segment on which one of them lies.
  bool IsInSharpCorner(const Corners& corners) const
  {
    return std::any_of(corners.begin(), corners.end(),
      [this, &corners](Id vertex)
      {
        const Id segment = this->Bites.Segments[vertex];
        return vertex < this->Geometry.NumberOfVertices()
          ? this->IsWithin(corners, vertex)
          : this->IsWithin(corners, this->Geometry.Starts[segment]) ||
            this->IsWithin(corners, this->Geometry.Ends[segment]);
      });
  }

private:
  // A sector between two segments.
  struct Sector
  {
    Id Vertex;
    Id First;
    Id Last;
  };

  bool IsOn(Id vertex, Id segment) const
  {
    return this->Bites.Segments[vertex] == segment || this->Geometry.Starts[segment] == vertex ||
      this->Geometry.Ends[segment] == vertex;
  }

  // Whether all lie on the sides of one sector of `vertex`.
  bool IsWithin(const Corners& corners, Id vertex) const
  {
    const auto first = this->Sectors.begin() + this->FirstSectors[vertex];
    const auto last = this->Sectors.begin() + this->FirstSectors[vertex + 1];
    return std::any_of(first, last,
      [this, &corners](const Sector& sector)
      {
        return std::all_of(corners.begin(), corners.end(),
          [this, &sector](Id corner)
          { return this->IsOn(corner, sector.First) || this->IsOn(corner, sector.Last); });
      });
  }

  const Domain& Geometry;
  const BitingResult& Bites;
  std::vector<Sector> Sectors;
  std::vector<Id> FirstSectors; ///< of each vertex, and one past the last
};

bool IsPoor(const BitingResult& bites, const Corners& corners)
{
  for (int k = 0; k < 3; ++k)
  {
    const Point2 u = bites.Points[corners[(k + 1) % 3]] - bites.Points[corners[k]];
    const Point2 v = bites.Points[corners[(k + 2) % 3]] - bites.Points[corners[k]];
    if (Dot(u, v) > CosineOf30 * Length(u) * Length(v))
    {
      return true;
    }
  }
  return false;
}

} // namespace

void ReportNarrowAngles(const Domain& domain, ProblemList& problems, Pulse& pulse)
{
  const SpokesOfVertices spokes(domain);
  for (Id vertex = 0; vertex < domain.NumberOfVertices() && pulse.Beat(); ++vertex)
  {
    for (const SharpSector& sector : spokes.SharpSectorsAt(vertex))
    {
      const double degrees = AngleInDegrees(sector);
      if (degrees < NarrowInDegrees)
      {
        problems.Add({ ProblemCode::NarrowAngles,
          { domain.Cells[sector.First.Segment], domain.Cells[sector.Last.Segment] },
          domain.Vertices[vertex], Figure(degrees, 2) + " degrees" });
      }
    }
  }
}

Id CountSharpCornerTriangles(
  const Domain& domain, const BitingResult& bites, const Triangulation& mesh, Monitor& monitor)
{
  Pulse pulse(monitor);
  const SharpCornerFinder finder(domain, bites, pulse);
  Id count = 0;
  if (finder.HasSectors())
  {
    pulse.ForEach(mesh.Corners.size() / 3,
      [&domain, &bites, &mesh, &finder, &count](std::size_t triangle)
      {
        const Corners corners{ mesh.Corners[3 * triangle], mesh.Corners[3 * triangle + 1],
          mesh.Corners[3 * triangle + 2] };
        const bool isOnSegments = std::all_of(corners.begin(), corners.end(),
          [&domain, &bites](Id vertex)
          { return vertex < domain.NumberOfVertices() || bites.Segments[vertex] != NoId; });
        const bool isCounted =
          isOnSegments && IsPoor(bites, corners) && finder.IsInSharpCorner(corners);
        count += isCounted ? 1 : 0;
      });
  }
  return count;
}

} // namespace biting
