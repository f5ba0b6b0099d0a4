// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "JudgedMesh.h"

#include "ExactSigns.h"

#include <algorithm> // for sort, binary_search
#include <cmath>     // for isfinite

namespace biting
{

namespace
{

constexpr std::size_t MostWindings = 40;

bool HasSizes(JudgedMesh& judged)
{
  const std::size_t points = judged.Mesh.Points.size();
  const std::size_t corners = judged.Mesh.Corners.size();
  const std::size_t edges = judged.Mesh.EdgeStarts.size();
  const MeshQuality& quality = judged.Mesh.Quality;
  return judged.Require(corners > 0 && corners % 3 == 0, "the mesh has triangles") &&
    judged.Require(judged.Mesh.Spacing.size() == points &&
        judged.Mesh.BiteOrders.size() == points && judged.Mesh.Kinds.size() == points &&
        judged.Mesh.OriginalPoints.size() == points &&
        quality.NearestNeighborDistance.size() == points && quality.Conformity.size() == points,
      "arrays of vertices have one size") &&
    judged.Require(judged.Mesh.Neighbors.size() == corners &&
        judged.Mesh.Regions.size() == corners / 3 && quality.MinimumAngle.size() == corners / 3 &&
        quality.RadiusEdgeRatio.size() == corners / 3 && quality.AspectRatio.size() == corners / 3,
      "arrays of triangles have one size") &&
    judged.Require(judged.Mesh.EdgeEnds.size() == edges && judged.Mesh.EdgeCells.size() == edges &&
        judged.Mesh.EdgeIsBoundary.size() == edges,
      "arrays of edges have one size");
}

bool HasBiteSizes(JudgedMesh& judged)
{
  const Bites& bites = judged.Mesh.Bites;
  const std::size_t count = bites.HalfWidths.size();
  return judged.Require(bites.Centers.size() == count && bites.Axes.size() == count &&
      bites.Orders.size() == count && bites.Phases.size() == count &&
      judged.Mesh.Front.size() % 2 == 0,
    "arrays of bites have one size");
}

bool HasIds(JudgedMesh& judged)
{
  const auto areWithin = [](const std::vector<Id>& ids, Id low, std::size_t end)
  {
    return std::all_of(
      ids.begin(), ids.end(), [low, end](Id id) { return id >= low && id < static_cast<Id>(end); });
  };
  const auto isCell = [&judged](Id cell)
  {
    return std::find(judged.Input.Cells.begin(), judged.Input.Cells.end(), cell) !=
      judged.Input.Cells.end();
  };
  const std::size_t points = judged.Mesh.Points.size();
  const std::size_t triangles = judged.Mesh.Corners.size() / 3;
  return judged.Require(areWithin(judged.Mesh.Corners, 0, points), "corners are vertices") &&
    judged.Require(areWithin(judged.Mesh.Neighbors, NoId, triangles), "neighbors are triangles") &&
    judged.Require(areWithin(judged.Mesh.Regions, 0, triangles), "regions are numbered") &&
    judged.Require(
      areWithin(judged.Mesh.EdgeStarts, 0, points) && areWithin(judged.Mesh.EdgeEnds, 0, points),
      "ends of edges are vertices") &&
    judged.Require(areWithin(judged.Mesh.OriginalPoints, NoId, judged.Input.Points.size()),
      "original points are points of the input") &&
    judged.Require(std::all_of(judged.Mesh.EdgeCells.begin(), judged.Mesh.EdgeCells.end(), isCell),
      "cells of edges are cells of the input");
}

bool HasPlaces(JudgedMesh& judged)
{
  for (std::size_t vertex = 0; vertex < judged.Mesh.Points.size(); ++vertex)
  {
    const Point2& p = judged.Mesh.Points[vertex];
    const double f = judged.Mesh.Spacing[vertex];
    if (!std::isfinite(p.X) || !std::isfinite(p.Y) || !std::isfinite(f) || !(f > 0.0))
    {
      return judged.Refuse("places and spacing are finite");
    }
  }
  return true;
}

bool HasPointsOnce(JudgedMesh& judged)
{
  judged.SortedPoints = judged.Mesh.Points;
  std::sort(judged.SortedPoints.begin(), judged.SortedPoints.end());
  const auto twice = std::adjacent_find(judged.SortedPoints.begin(), judged.SortedPoints.end());
  return judged.Require(twice == judged.SortedPoints.end(), "no point is there twice");
}

bool UsesAllPoints(JudgedMesh& judged)
{
  std::vector<char> isUsed(judged.Mesh.Points.size(), 0);
  for (const Id corner : judged.Mesh.Corners)
  {
    isUsed[At(corner)] = 1;
  }
  return judged.Require(
    std::find(isUsed.begin(), isUsed.end(), 0) == isUsed.end(), "every point has a triangle");
}

bool IsCounterclockwise(JudgedMesh& judged)
{
  for (std::size_t slot = 0; slot < judged.Mesh.Corners.size(); slot += 3)
  {
    if (ExactOrientation(judged.Corner(slot), judged.Corner(slot + 1), judged.Corner(slot + 2)) <=
      0)
    {
      return judged.Refuse("triangle " + std::to_string(slot / 3) + " is not counterclockwise");
    }
  }
  return true;
}

bool IsNeighbor(JudgedMesh& judged, const HalfEdge& half)
{
  const HalfEdge* twin = judged.FindHalf(half.End, half.Start);
  const Id across = twin ? static_cast<Id>(twin->Slot / 3) : NoId;
  if (!twin)
  {
    judged.BoundarySlots.push_back(half.Slot);
  }
  return judged.Require(judged.Mesh.Neighbors[half.Slot] == across, "neighbors share the edge");
}

bool IsManifold(JudgedMesh& judged)
{
  for (std::size_t slot = 0; slot < judged.Mesh.Corners.size(); ++slot)
  {
    const std::size_t start = Next(slot);
    judged.Halves.push_back({ judged.Mesh.Corners[start], judged.Mesh.Corners[Next(start)], slot });
  }
  std::sort(judged.Halves.begin(), judged.Halves.end());
  const auto twice = std::adjacent_find(judged.Halves.begin(), judged.Halves.end(),
    [](const HalfEdge& a, const HalfEdge& b) { return a.Ends() == b.Ends(); });
  return judged.Require(twice == judged.Halves.end(), "an edge has one triangle on each side") &&
    std::all_of(judged.Halves.begin(), judged.Halves.end(),
      [&judged](const HalfEdge& half) { return IsNeighbor(judged, half); });
}

bool HasCoveringEdges(JudgedMesh& judged)
{
  std::size_t boundaries = 0;
  for (std::size_t edge = 0; edge < judged.Mesh.EdgeStarts.size(); ++edge)
  {
    const Id start = judged.Mesh.EdgeStarts[edge];
    const Id end = judged.Mesh.EdgeEnds[edge];
    const int sides = (judged.FindHalf(start, end) ? 1 : 0) + (judged.FindHalf(end, start) ? 1 : 0);
    const bool isBoundary = judged.Mesh.EdgeIsBoundary[edge] != 0;
    if (sides != (isBoundary ? 1 : 2))
    {
      return judged.Refuse(judged.EdgeText(start, end) + " covers " +
        (isBoundary ? "boundary" : "an interface") + " and has " + std::to_string(sides) +
        " triangles");
    }
    boundaries += isBoundary ? 1 : 0;
    judged.Covering.push_back(std::minmax(start, end));
  }
  std::sort(judged.Covering.begin(), judged.Covering.end());
  const auto twice = std::adjacent_find(judged.Covering.begin(), judged.Covering.end());
  return judged.Require(twice == judged.Covering.end(), "each covering edge is there once") &&
    judged.Require(boundaries == judged.BoundarySlots.size(), "all of the boundary is covered");
}

int WindingAbout(const JudgedMesh& judged, const Point2& p)
{
  int winding = 0;
  for (const std::size_t slot : judged.BoundarySlots)
  {
    const Point2& start = judged.Corner(Next(slot));
    const Point2& end = judged.Corner(Next(Next(slot)));
    if ((start.Y <= p.Y) != (end.Y <= p.Y))
    {
      const int side = ExactOrientation(start, end, p);
      winding += start.Y <= p.Y ? (side > 0 ? 1 : 0) : (side < 0 ? -1 : 0);
    }
  }
  return winding;
}

/// Where the centre of a triangle is not within it, the triangle is too thin to ask.
bool CoversOnce(JudgedMesh& judged)
{
  const std::size_t triangles = judged.Mesh.Corners.size() / 3;
  const std::size_t step = triangles / MostWindings + 1;
  for (std::size_t slot = 0; slot < 3 * triangles; slot += 3 * step)
  {
    const Point2& a = judged.Corner(slot);
    const Point2& b = judged.Corner(slot + 1);
    const Point2& c = judged.Corner(slot + 2);
    const Point2 center = a + 1.0 / 3.0 * ((b - a) + (c - a));
    const bool isWithin = ExactOrientation(a, b, center) > 0 &&
      ExactOrientation(b, c, center) > 0 && ExactOrientation(c, a, center) > 0;
    if (isWithin && WindingAbout(judged, center) != 1)
    {
      return judged.Refuse("the boundary winds " + std::to_string(WindingAbout(judged, center)) +
        " times about triangle " + std::to_string(slot / 3));
    }
  }
  return true;
}

/// Spreads from one triangle of each region over edges that cover nothing.
bool HasRegions(JudgedMesh& judged)
{
  std::vector<char> isReached(judged.Mesh.Regions.size(), 0);
  std::vector<char> isKnown(judged.Mesh.Regions.size(), 0);
  for (std::size_t first = 0; first < isReached.size(); ++first)
  {
    const Id region = judged.Mesh.Regions[first];
    std::vector<std::size_t> open;
    if (!isReached[first])
    {
      if (!judged.Require(!isKnown[At(region)], "a region is connected"))
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
        const Id across = judged.Mesh.Neighbors[slot];
        const std::size_t start = Next(slot);
        const HalfEdge half{ judged.Mesh.Corners[start], judged.Mesh.Corners[Next(start)], slot };
        if (across == NoId || judged.IsCovering(half))
        {
          continue;
        }
        if (!judged.Require(judged.Mesh.Regions[At(across)] == region, "regions end at edges"))
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

} // namespace

bool HoldsTopology(JudgedMesh& judged)
{
  return HasSizes(judged) && HasBiteSizes(judged) && HasIds(judged) && HasPlaces(judged) &&
    HasPointsOnce(judged) && UsesAllPoints(judged) && IsCounterclockwise(judged) &&
    IsManifold(judged) && HasCoveringEdges(judged) && CoversOnce(judged) && HasRegions(judged);
}

} // namespace biting
