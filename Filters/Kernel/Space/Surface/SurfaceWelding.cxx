// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceWelding.h"

#include "../../Base/Numbers.h"
#include "../../Base/SortInSteps.h"
#include "SurfaceLinks.h"

#include <algorithm>  // for min
#include <cmath>      // for abs
#include <functional> // for less
#include <limits>     // for the least number
#include <numeric>    // for iota
#include <utility>    // for pairs

namespace biting
{

namespace
{

// Gives vertices the numbers of those that they become, `kept`, a lower number or their own; keeps
// those in use, and the triangles that have three corners.
void MergeVertices(SurfaceMesh& mesh, const std::vector<Id>& kept)
{
  std::vector<Id> numbers(mesh.Points.size(), NoId);
  std::size_t triangles = 0;
  for (std::size_t t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const auto corner = [&mesh, &kept, t](std::size_t k)
    { return kept[At(mesh.Corners[3 * t + k])]; };
    const Id corners[] = { corner(0), corner(1), corner(2) };
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
    {
      mesh.CopyTriangle(t, triangles);
      for (std::size_t k = 0; k < 3; ++k)
      {
        mesh.Corners[3 * triangles + k] = corners[k];
        numbers[static_cast<std::size_t>(corners[k])] = 0;
      }
      ++triangles;
    }
  }
  mesh.Resize(triangles);
  std::size_t vertices = 0;
  for (std::size_t point = 0; point < numbers.size(); ++point)
  {
    if (numbers[point] != NoId)
    {
      mesh.Points[vertices] = mesh.Points[point];
      mesh.PointIds[vertices] = mesh.PointIds[point];
      numbers[point] = static_cast<Id>(vertices++);
    }
  }
  mesh.Points.resize(vertices);
  mesh.PointIds.resize(vertices);
  for (Id& corner : mesh.Corners)
  {
    corner = numbers[static_cast<std::size_t>(corner)];
  }
}

// Of each vertex on open edges the least reachOf(vertex, shortest side) of its triangles; of others
// 0. Empty where no edge is open.
template <typename Reach>
std::vector<double> ReachesOnBorders(const SurfaceMesh& mesh, const Reach& reachOf, Pulse& pulse)
{
  const SurfaceLinks links = LinkSurface(mesh, pulse);
  std::vector<double> reaches(links.NumberOfOpen > 0 ? mesh.Points.size() : 0, 0.0);
  for (std::size_t slot = 0; slot < mesh.Corners.size() && !reaches.empty(); ++slot)
  {
    if (links.Across[slot] == OpenEdge)
    {
      reaches[At(mesh.Corners[NextSlotOf(slot)])] = Infinity;
      reaches[At(mesh.Corners[PreviousSlotOf(slot)])] = Infinity;
    }
  }
  for (std::size_t slot = 0; slot < mesh.Corners.size() && !reaches.empty(); ++slot)
  {
    const std::array<Point3, 3> corners = mesh.Triangle(slot / 3);
    const double shortest = std::min({ Distance(corners[0], corners[1]),
      Distance(corners[1], corners[2]), Distance(corners[2], corners[0]) });
    double& reach = reaches[At(mesh.Corners[slot])];
    reach = reach > 0.0 ? std::min(reach, reachOf(At(mesh.Corners[slot]), shortest)) : 0.0;
  }
  return reaches;
}

// Merges vertices where areNear(vertex, other) and neither reach is less than their distance;
// those without one stay. The first stays where it is, and no two that stay are near.
// Calls tell(vertex, the one that it becomes).
template <typename Question, typename Tell>
void WeldNear(SurfaceMesh& mesh, const std::vector<double>& reaches, const Question& areNear,
  const Tell& tell, Pulse& pulse)
{
  const Point3 sweep{ 0.8, 0.5123, 0.3117 }; // shorter than 1; few points lie across it
  if (reaches.empty())
  {
    return;
  }
  std::vector<std::pair<double, Id>> order;
  for (std::size_t point = 0; point < reaches.size(); ++point)
  {
    if (reaches[point] > 0.0)
    {
      order.emplace_back(Dot(sweep, mesh.Points[point]), static_cast<Id>(point));
    }
  }
  SortInSteps(order, std::less<>(), pulse);
  std::vector<std::size_t> ranks(reaches.size(), 0);
  for (std::size_t rank = 0; rank < order.size(); ++rank)
  {
    ranks[At(order[rank].second)] = rank;
  }
  std::vector<Id> kept(mesh.Points.size());
  std::iota(kept.begin(), kept.end(), 0);
  for (std::size_t point = 0; point < reaches.size() && pulse.Beat(); ++point)
  {
    const auto look = [&](std::size_t rank)
    {
      const Id other = order[rank].second;
      const bool isKept = other < kept[point] && kept[At(other)] == other;
      kept[point] = isKept && areNear(point, At(other)) ? other : kept[point];
      return std::abs(order[rank].first - order[ranks[point]].first) <= reaches[point] &&
        pulse.Beat(1);
    };
    const bool isAsked = reaches[point] > 0.0;
    for (std::size_t rank = ranks[point]; isAsked && rank-- > 0 && look(rank);)
    {
    }
    for (std::size_t rank = ranks[point]; isAsked && ++rank < order.size() && look(rank);)
    {
    }
    if (At(kept[point]) != point)
    {
      tell(point, At(kept[point]));
    }
  }
  MergeVertices(mesh, kept);
}

} // namespace

std::size_t WeldEqualPoints(SurfaceMesh& mesh, Pulse& pulse)
{
  std::size_t welded = 0;
  std::vector<double> reaches(mesh.Points.size(), 0.0);
  for (const Id corner : mesh.Corners)
  {
    reaches[At(corner)] = std::numeric_limits<double>::min();
  }
  WeldNear(
    mesh, reaches,
    [&mesh](std::size_t a, std::size_t b) { return mesh.Points[a] == mesh.Points[b]; },
    [&welded](std::size_t, std::size_t) { ++welded; }, pulse);
  return welded;
}

std::size_t WeldBorders(SurfaceMesh& mesh, const Point3& rounding, Pulse& pulse)
{
  std::size_t welded = 0;
  const double reach = rounding.X + rounding.Y + rounding.Z;
  WeldNear(
    mesh,
    ReachesOnBorders(
      mesh, [reach](std::size_t, double) { return reach; }, pulse),
    [&mesh, &rounding](std::size_t a, std::size_t b)
    {
      const Point3 apart = mesh.Points[a] - mesh.Points[b];
      return std::abs(apart.X) <= rounding.X && std::abs(apart.Y) <= rounding.Y &&
        std::abs(apart.Z) <= rounding.Z;
    },
    [&welded](std::size_t, std::size_t) { ++welded; }, pulse);
  return welded;
}

void WeldSlits(SurfaceMesh& mesh, const SpacingField& reach, ProblemList& problems, Pulse& pulse)
{
  constexpr double ShareOfSides = 0.1;
  std::vector<double> reaches;
  bool isChanged = true;
  // From the nearest on: vertices that are one know all their triangles, and the sides of these.
  for (double share = 1e-7; share < 2.0; share *= 10.0)
  {
    if (isChanged)
    {
      reaches = ReachesOnBorders(
        mesh,
        [&mesh, &reach](std::size_t vertex, double side)
        { return std::min(ShareOfSides * side, reach(mesh.Points[vertex])); },
        pulse);
    }
    std::vector<double> shares(reaches.size(), 0.0);
    for (std::size_t vertex = 0; vertex < reaches.size(); ++vertex)
    {
      shares[vertex] =
        reaches[vertex] > 0.0 ? std::min(reaches[vertex], share * reach(mesh.Points[vertex])) : 0.0;
    }
    isChanged = false;
    WeldNear(
      mesh, shares,
      [&mesh, &shares](std::size_t a, std::size_t b)
      { return Distance(mesh.Points[a], mesh.Points[b]) < std::min(shares[a], shares[b]); },
      [&mesh, &problems, &isChanged](std::size_t from, std::size_t to)
      {
        problems.Add(
          { ProblemCode::NearPoints, { mesh.PointIds[from], mesh.PointIds[to] }, mesh.Points[from],
            "on open edges, " + Figure(Distance(mesh.Points[from], mesh.Points[to])) + " apart" });
        isChanged = true;
      },
      pulse);
  }
}

} // namespace biting
