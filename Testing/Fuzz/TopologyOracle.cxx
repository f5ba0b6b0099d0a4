// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TopologyOracle.h"

#include "ExactSigns.h"

#include <algorithm> // for sort, binary_search
#include <cmath>     // for isfinite
#include <map>       // for regions

namespace biting
{

namespace
{

constexpr std::size_t MostWindings = 40;

} // namespace

bool TopologyOracle::Holds()
{
  return this->HasSizes() && this->HasBiteSizes() && this->HasIds() && this->HasPlaces() &&
    this->HasPointsOnce() && this->UsesAllPoints() && this->IsCounterclockwise() &&
    this->IsManifold() && this->HasCoveringEdges() && this->CoversOnce() && this->HasRegions();
}

bool TopologyOracle::HasSizes()
{
  const std::size_t points = this->Judged.Mesh.Points.size();
  const std::size_t corners = this->Judged.Mesh.Corners.size();
  const std::size_t edges = this->Judged.Mesh.EdgeStarts.size();
  const MeshQuality& quality = this->Judged.Mesh.Quality;
  return this->Judged.Require(corners > 0 && corners % 3 == 0, "the mesh has triangles") &&
    this->Judged.Require(this->Judged.Mesh.Spacing.size() == points &&
        this->Judged.Mesh.BiteOrders.size() == points && this->Judged.Mesh.Kinds.size() == points &&
        this->Judged.Mesh.OriginalPoints.size() == points &&
        quality.NearestNeighborDistance.size() == points && quality.Conformity.size() == points,
      "arrays of vertices have one size") &&
    this->Judged.Require(this->Judged.Mesh.Neighbors.size() == corners &&
        this->Judged.Mesh.Regions.size() == corners / 3 &&
        quality.MinimumAngle.size() == corners / 3 &&
        quality.RadiusEdgeRatio.size() == corners / 3 && quality.AspectRatio.size() == corners / 3,
      "arrays of triangles have one size") &&
    this->Judged.Require(this->Judged.Mesh.EdgeEnds.size() == edges &&
        this->Judged.Mesh.EdgeCells.size() == edges &&
        this->Judged.Mesh.EdgeIsBoundary.size() == edges,
      "arrays of edges have one size");
}

bool TopologyOracle::HasBiteSizes()
{
  const Bites& bites = this->Judged.Mesh.Bites;
  const std::size_t count = bites.HalfWidths.size();
  return this->Judged.Require(bites.Centers.size() == count && bites.Axes.size() == count &&
      bites.Orders.size() == count && bites.Phases.size() == count &&
      this->Judged.Mesh.Front.size() % 2 == 0,
    "arrays of bites have one size");
}

bool TopologyOracle::HasIds()
{
  const auto areWithin = [](const std::vector<Id>& ids, Id low, std::size_t end)
  {
    return std::all_of(
      ids.begin(), ids.end(), [low, end](Id id) { return id >= low && id < static_cast<Id>(end); });
  };
  const auto isCell = [this](Id cell)
  {
    return std::find(this->Judged.Input.Cells.begin(), this->Judged.Input.Cells.end(), cell) !=
      this->Judged.Input.Cells.end();
  };
  const std::size_t points = this->Judged.Mesh.Points.size();
  const std::size_t triangles = this->Judged.Mesh.Corners.size() / 3;
  return this->Judged.Require(
           areWithin(this->Judged.Mesh.Corners, 0, points), "corners are vertices") &&
    this->Judged.Require(
      areWithin(this->Judged.Mesh.Neighbors, NoId, triangles), "neighbors are triangles") &&
    this->Judged.Require(
      areWithin(this->Judged.Mesh.Regions, 0, triangles), "regions are numbered") &&
    this->Judged.Require(areWithin(this->Judged.Mesh.EdgeStarts, 0, points) &&
        areWithin(this->Judged.Mesh.EdgeEnds, 0, points),
      "ends of edges are vertices") &&
    this->Judged.Require(
      areWithin(this->Judged.Mesh.OriginalPoints, NoId, this->Judged.Input.Points.size()),
      "original points are points of the input") &&
    this->Judged.Require(
      std::all_of(this->Judged.Mesh.EdgeCells.begin(), this->Judged.Mesh.EdgeCells.end(), isCell),
      "cells of edges are cells of the input");
}

bool TopologyOracle::HasPlaces()
{
  for (std::size_t vertex = 0; vertex < this->Judged.Mesh.Points.size(); ++vertex)
  {
    const Point2& p = this->Judged.Mesh.Points[vertex];
    const double f = this->Judged.Mesh.Spacing[vertex];
    if (!std::isfinite(p.X) || !std::isfinite(p.Y) || !std::isfinite(f) || !(f > 0.0))
    {
      return this->Judged.Refuse("places and spacing are finite");
    }
  }
  return true;
}

bool TopologyOracle::HasPointsOnce()
{
  this->Judged.SortedPoints = this->Judged.Mesh.Points;
  std::sort(this->Judged.SortedPoints.begin(), this->Judged.SortedPoints.end());
  const auto twice =
    std::adjacent_find(this->Judged.SortedPoints.begin(), this->Judged.SortedPoints.end());
  return this->Judged.Require(twice == this->Judged.SortedPoints.end(), "no point is there twice");
}

bool TopologyOracle::UsesAllPoints()
{
  std::vector<char> isUsed(this->Judged.Mesh.Points.size(), 0);
  for (const Id corner : this->Judged.Mesh.Corners)
  {
    isUsed[At(corner)] = 1;
  }
  return this->Judged.Require(
    std::find(isUsed.begin(), isUsed.end(), 0) == isUsed.end(), "every point has a triangle");
}

bool TopologyOracle::IsCounterclockwise()
{
  for (std::size_t slot = 0; slot < this->Judged.Mesh.Corners.size(); slot += 3)
  {
    if (ExactOrientation(this->Judged.Corner(slot), this->Judged.Corner(slot + 1),
          this->Judged.Corner(slot + 2)) <= 0)
    {
      return this->Judged.Refuse(
        "triangle " + std::to_string(slot / 3) + " is not counterclockwise");
    }
  }
  return true;
}

bool TopologyOracle::IsManifold()
{
  for (std::size_t slot = 0; slot < this->Judged.Mesh.Corners.size(); ++slot)
  {
    const std::size_t start = Next(slot);
    this->Judged.Halves.push_back(
      { this->Judged.Mesh.Corners[start], this->Judged.Mesh.Corners[Next(start)], slot });
  }
  std::sort(this->Judged.Halves.begin(), this->Judged.Halves.end());
  const auto twice = std::adjacent_find(this->Judged.Halves.begin(), this->Judged.Halves.end(),
    [](const HalfEdge& a, const HalfEdge& b) { return a.Ends() == b.Ends(); });
  return this->Judged.Require(
           twice == this->Judged.Halves.end(), "an edge has one triangle on each side") &&
    std::all_of(this->Judged.Halves.begin(), this->Judged.Halves.end(),
      [this](const HalfEdge& half) { return this->IsNeighbor(half); });
}

bool TopologyOracle::IsNeighbor(const HalfEdge& half)
{
  const HalfEdge* twin = this->Judged.FindHalf(half.End, half.Start);
  const Id across = twin ? static_cast<Id>(twin->Slot / 3) : NoId;
  if (!twin)
  {
    this->Judged.BoundarySlots.push_back(half.Slot);
  }
  return this->Judged.Require(
    this->Judged.Mesh.Neighbors[half.Slot] == across, "neighbors share the edge");
}

bool TopologyOracle::HasCoveringEdges()
{
  std::size_t boundaries = 0;
  for (std::size_t edge = 0; edge < this->Judged.Mesh.EdgeStarts.size(); ++edge)
  {
    const Id start = this->Judged.Mesh.EdgeStarts[edge];
    const Id end = this->Judged.Mesh.EdgeEnds[edge];
    const int sides =
      (this->Judged.FindHalf(start, end) ? 1 : 0) + (this->Judged.FindHalf(end, start) ? 1 : 0);
    const bool isBoundary = this->Judged.Mesh.EdgeIsBoundary[edge] != 0;
    if (sides != (isBoundary ? 1 : 2))
    {
      return this->Judged.Refuse(this->Judged.EdgeText(start, end) + " covers " +
        (isBoundary ? "boundary" : "an interface") + " and has " + std::to_string(sides) +
        " triangles");
    }
    boundaries += isBoundary ? 1 : 0;
    this->Judged.Covering.push_back(std::minmax(start, end));
  }
  std::sort(this->Judged.Covering.begin(), this->Judged.Covering.end());
  const auto twice = std::adjacent_find(this->Judged.Covering.begin(), this->Judged.Covering.end());
  return this->Judged.Require(
           twice == this->Judged.Covering.end(), "each covering edge is there once") &&
    this->Judged.Require(
      boundaries == this->Judged.BoundarySlots.size(), "all of the boundary is covered");
}

/// Where the centre of a triangle is not within it, the triangle is too thin to ask.
bool TopologyOracle::CoversOnce()
{
  const std::size_t triangles = this->Judged.Mesh.Corners.size() / 3;
  const std::size_t step = triangles / MostWindings + 1;
  for (std::size_t slot = 0; slot < 3 * triangles; slot += 3 * step)
  {
    const Point2& a = this->Judged.Corner(slot);
    const Point2& b = this->Judged.Corner(slot + 1);
    const Point2& c = this->Judged.Corner(slot + 2);
    const Point2 center = a + 1.0 / 3.0 * ((b - a) + (c - a));
    const bool isWithin = ExactOrientation(a, b, center) > 0 &&
      ExactOrientation(b, c, center) > 0 && ExactOrientation(c, a, center) > 0;
    if (isWithin && this->WindingAbout(center) != 1)
    {
      return this->Judged.Refuse("the boundary winds " +
        std::to_string(this->WindingAbout(center)) + " times about triangle " +
        std::to_string(slot / 3));
    }
  }
  return true;
}

int TopologyOracle::WindingAbout(const Point2& p) const
{
  int winding = 0;
  for (const std::size_t slot : this->Judged.BoundarySlots)
  {
    const Point2& start = this->Judged.Corner(Next(slot));
    const Point2& end = this->Judged.Corner(Next(Next(slot)));
    if ((start.Y <= p.Y) != (end.Y <= p.Y))
    {
      const int side = ExactOrientation(start, end, p);
      winding += start.Y <= p.Y ? (side > 0 ? 1 : 0) : (side < 0 ? -1 : 0);
    }
  }
  return winding;
}

/// Spreads from one triangle of each region over edges that cover nothing.
bool TopologyOracle::HasRegions()
{
  std::vector<char> isReached(this->Judged.Mesh.Regions.size(), 0);
  std::vector<char> isKnown(this->Judged.Mesh.Regions.size(), 0);
  for (std::size_t first = 0; first < isReached.size(); ++first)
  {
    const Id region = this->Judged.Mesh.Regions[first];
    std::vector<std::size_t> open;
    if (!isReached[first])
    {
      if (!this->Judged.Require(!isKnown[At(region)], "a region is connected"))
      {
        return false;
      }
      isKnown[At(region)] = 1;
      isReached[first] = 1;
      open.push_back(first);
    }
    while (!open.empty())
    {
      const std::size_t triangle = open.back();
      open.pop_back();
      for (std::size_t slot = 3 * triangle; slot < 3 * triangle + 3; ++slot)
      {
        const Id across = this->Judged.Mesh.Neighbors[slot];
        const std::size_t start = Next(slot);
        const HalfEdge half{ this->Judged.Mesh.Corners[start],
          this->Judged.Mesh.Corners[Next(start)], slot };
        if (across == NoId || this->Judged.IsCovering(half))
        {
          continue;
        }
        if (!this->Judged.Require(
              this->Judged.Mesh.Regions[At(across)] == region, "regions end at edges"))
        {
          return false;
        }
        if (!isReached[At(across)])
        {
          isReached[At(across)] = 1;
          open.push_back(At(across));
        }
      }
    }
  }
  return true;
}

} // namespace biting
