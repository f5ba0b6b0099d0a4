// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceHoles.h"

#include "../../Base/DistanceToSegment.h"
#include "../../Base/Numbers.h"
#include "SurfaceRepair.h"
#include "SurfaceWelding.h"

#include <algorithm> // for any_of, min, minmax, reverse, sort
#include <array>     // for triangles
#include <cstdint>   // for marks
#include <numeric>   // for iota
#include <set>       // for edges
#include <utility>   // for pairs

namespace biting
{

namespace
{

constexpr double ClearShare = 0.17677669529663687; // of f: 1 / (4 sqrt(2))

// Patches for holes, one after the other.
class HolePatches
{
public:
  HolePatches(
    SurfaceMesh& mesh, const SurfaceLinks& links, const SpacingField& spacing, Pulse& pulse)
    : Mesh(mesh)
    , Spacing(spacing)
    , Beats(pulse)
  {
    std::vector<std::uint8_t> isOnBorder(mesh.Points.size(), 0);
    for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
    {
      if (links.Across[slot] == OpenEdge)
      {
        isOnBorder[At(mesh.Corners[NextSlotOf(slot)])] = 1;
        isOnBorder[At(mesh.Corners[PreviousSlotOf(slot)])] = 1;
      }
    }
    for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
    {
      const Id a = mesh.Corners[NextSlotOf(slot)];
      const Id b = mesh.Corners[PreviousSlotOf(slot)];
      if (isOnBorder[At(a)] != 0 && isOnBorder[At(b)] != 0)
      {
        this->Edges.insert(std::minmax(a, b));
      }
    }
  }

  // Whether the hole was closed.
  bool Close(const BorderChain& hole)
  {
    constexpr std::size_t MostEdges = 10000;
    if (!hole.IsLoop || hole.Slots.size() > MostEdges)
    {
      return false;
    }
    this->Begin(hole);
    std::vector<std::size_t> all(this->Loop.size());
    std::iota(all.begin(), all.end(), 0);
    const bool isClear = this->Triangulate(all) &&
      std::all_of(this->Triangles.begin(), this->Triangles.end(),
        [this](const Corners& corners) { return this->IsClear(corners); });
    if (isClear)
    {
      this->AddTriangles();
    }
    return isClear;
  }

private:
  using Corners = std::array<std::size_t, 3>; ///< places of the loop, in order

  // Takes the loop in the direction that patches have, against the triangles beside.
  void Begin(const BorderChain& hole)
  {
    this->Triangles.clear();
    this->Loop.assign(hole.Vertices.begin(), hole.Vertices.end() - 1);
    this->Beside.clear();
    for (const Id slot : hole.Slots)
    {
      this->Beside.push_back(At(slot) / 3);
    }
    if (this->Mesh.Corners[NextSlotOf(At(hole.Slots.front()))] == this->Loop.front())
    {
      std::reverse(this->Loop.begin(), this->Loop.end());
      std::reverse(this->Beside.begin(), this->Beside.end() - 1);
    }
  }

  const Point3& Place(std::size_t k) const { return this->Mesh.Points[At(this->Loop[k])]; }

  bool HasEdge(std::size_t i, std::size_t j) const
  {
    return this->Edges.count(std::minmax(this->Loop[i], this->Loop[j])) > 0;
  }

  // Of the places of the loop in `part`, in order. Whether there is a triangulation.
  bool Triangulate(const std::vector<std::size_t>& part)
  {
    constexpr std::size_t MostAtOnce = 100;
    const std::size_t count = part.size();
    if (count > MostAtOnce)
    {
      return this->Divide(part);
    }
    // Of the polygon from place i on to place j: the least costs, and the corner opposite its side.
    std::vector<double> costs(count * count, Infinity);
    std::vector<std::size_t> corners(count * count, 0);
    for (std::size_t i = 0; i + 1 < count; ++i)
    {
      costs[i * count + i + 1] = 0.0;
    }
    for (std::size_t length = 2; length < count; ++length)
    {
      for (std::size_t i = 0; i + length < count && this->Beats.Beat(); ++i)
      {
        const std::size_t j = i + length;
        double& best = costs[i * count + j];
        const bool isPossible = length + 1 == count || !this->HasEdge(part[i], part[j]);
        for (std::size_t k = i + 1; k < j && isPossible; ++k)
        {
          const double parts = costs[i * count + k] + costs[k * count + j];
          const double cost =
            parts < best ? parts + this->CostOf({ part[i], part[k], part[j] }) : Infinity;
          corners[i * count + j] = cost < best ? k : corners[i * count + j];
          best = std::min(best, cost);
        }
      }
    }
    std::vector<std::pair<std::size_t, std::size_t>> sides{ { 0, count - 1 } };
    while (costs[count - 1] < Infinity && !sides.empty())
    {
      const auto [i, j] = sides.back();
      sides.pop_back();
      if (j > i + 1)
      {
        const std::size_t k = corners[i * count + j];
        this->Triangles.push_back({ part[i], part[k], part[j] });
        sides.push_back({ i, k });
        sides.push_back({ k, j });
      }
    }
    return costs[count - 1] < Infinity;
  }

  // By the shortest edge that leaves a quarter on both sides.
  bool Divide(const std::vector<std::size_t>& part)
  {
    const std::size_t least = part.size() / 4;
    std::pair<std::size_t, std::size_t> best{ 0, 0 };
    double shortest = Infinity;
    for (std::size_t i = 0; i + least < part.size(); ++i)
    {
      const std::size_t end = std::min(part.size(), i + part.size() - least);
      for (std::size_t j = i + least; j < end && this->Beats.Beat(1); ++j)
      {
        const double length = Distance(this->Place(part[i]), this->Place(part[j]));
        if (length < shortest && !this->HasEdge(part[i], part[j]))
        {
          shortest = length;
          best = { i, j };
        }
      }
    }
    const auto at = [&part](std::size_t k)
    { return part.begin() + static_cast<std::ptrdiff_t>(k); };
    std::vector<std::size_t> rest(part.begin(), at(best.first + 1));
    rest.insert(rest.end(), at(best.second), part.end());
    return shortest < Infinity &&
      this->IsNear(Midpoint(this->Place(part[best.first]), this->Place(part[best.second]))) &&
      this->Triangulate({ at(best.first), at(best.second + 1) }) && this->Triangulate(rest);
  }

  // Area; where many triangulations have the same, as of slits, lengths count.
  double CostOf(const Corners& corners) const
  {
    constexpr double Weight = 1e-3;
    const Point3 a = this->Place(corners[1]) - this->Place(corners[0]);
    const Point3 b = this->Place(corners[2]) - this->Place(corners[1]);
    const Point3 c = this->Place(corners[0]) - this->Place(corners[2]);
    return this->IsThere(corners)
      ? Infinity
      : 0.5 * Length(Cross(a, b)) + Weight * (Dot(a, a) + Dot(b, b) + Dot(c, c));
  }

  // Whether the surface has the triangle.
  bool IsThere(const Corners& corners) const
  {
    bool isThere = false;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t from = corners[k];
      const Id* beside = &this->Mesh.Corners[3 * this->Beside[from]];
      isThere = isThere ||
        (corners[(k + 1) % 3] == (from + 1) % this->Loop.size() &&
          std::count(beside, beside + 3, this->Loop[corners[(k + 2) % 3]]) > 0);
    }
    return isThere;
  }

  // Whether the middle of the circle in the triangle, and of sides, are near the loop.
  bool IsClear(const Corners& corners)
  {
    Point3 middle;
    double sum = 0.0;
    bool isClear = true;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Point3& a = this->Place(corners[(k + 1) % 3]);
      const Point3& b = this->Place(corners[(k + 2) % 3]);
      const double length = Distance(a, b);
      middle = middle + length * this->Place(corners[k]);
      sum += length;
      isClear = isClear && this->IsNear(Midpoint(a, b));
    }
    return isClear && this->IsNear((1.0 / sum) * middle);
  }

  bool IsNear(const Point3& place)
  {
    const double reach = ClearShare * this->Spacing(place);
    bool isNear = false;
    for (std::size_t k = 0; k < this->Loop.size() && !isNear && this->Beats.Beat(1); ++k)
    {
      const std::size_t next = k + 1 < this->Loop.size() ? k + 1 : 0;
      isNear = DistanceToSegment(place, this->Place(k), this->Place(next)) <= reach;
    }
    return isNear;
  }

  void AddTriangles()
  {
    for (const Corners& corners : this->Triangles)
    {
      // An edge of the loop, if there is one, is from the first or from the second corner on.
      const bool isFirst = corners[1] == corners[0] + 1;
      const std::size_t added = this->Mesh.NumberOfTriangles();
      this->Mesh.Resize(added + 1);
      this->Mesh.CopyTriangle(this->Beside[corners[isFirst ? 0 : 1]], added);
      for (std::size_t k = 0; k < 3; ++k)
      {
        this->Mesh.Corners[3 * added + k] = this->Loop[corners[k]];
        this->Edges.insert(std::minmax(this->Loop[corners[k]], this->Loop[corners[(k + 1) % 3]]));
      }
    }
  }

  SurfaceMesh& Mesh;
  const SpacingField& Spacing;
  Pulse& Beats;
  std::set<std::pair<Id, Id>> Edges; ///< between vertices of borders
  std::vector<Id> Loop;              ///< vertices of the hole at hand
  std::vector<std::size_t> Beside;   ///< of each edge of it, from its vertex on: the triangle
  std::vector<Corners> Triangles;    ///< of its patch
};

// Of each vertex on open edges how near another one has to be to become one with it; others 0.
std::vector<double> ReachesOnBorders(
  const SurfaceMesh& mesh, const SurfaceLinks& links, const SpacingField& spacing)
{
  constexpr double ShareOfEdges = 0.1;
  std::vector<double> reaches(mesh.Points.size(), 0.0);
  for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
  {
    if (links.Across[slot] == OpenEdge)
    {
      const Id a = mesh.Corners[NextSlotOf(slot)];
      const Id b = mesh.Corners[PreviousSlotOf(slot)];
      const double share = ShareOfEdges * Distance(mesh.Points[At(a)], mesh.Points[At(b)]);
      for (const Id end : { a, b })
      {
        double& reach = reaches[At(end)];
        reach = reach == 0.0 ? ClearShare * spacing(mesh.Points[At(end)]) : reach;
        reach = std::min(reach, share);
      }
    }
  }
  return reaches;
}

} // namespace

void WeldSlits(SurfaceMesh& mesh, const SpacingField& spacing, ProblemList& problems, Pulse& pulse)
{
  const SurfaceLinks links = LinkSurface(mesh, pulse);
  if (links.NumberOfOpen == 0)
  {
    return;
  }
  const std::vector<double> reaches = ReachesOnBorders(mesh, links, spacing);
  // A sweep in a direction along which few borders lie.
  const Point3 sweep{ 0.8, 0.5, 0.3316624790355400 };
  std::vector<std::pair<double, Id>> order;
  std::vector<Id> kept(mesh.Points.size());
  std::iota(kept.begin(), kept.end(), 0);
  for (std::size_t point = 0; point < reaches.size(); ++point)
  {
    if (reaches[point] > 0.0)
    {
      order.emplace_back(Dot(sweep, mesh.Points[point]), static_cast<Id>(point));
    }
  }
  std::sort(order.begin(), order.end());
  for (auto one = order.begin(); one != order.end(); ++one)
  {
    const Id vertex = one->second;
    const Point3& place = mesh.Points[At(vertex)];
    const double reach = reaches[At(vertex)];
    for (auto other = one + 1; kept[At(vertex)] == vertex && other != order.end() &&
         other->first - one->first < reach && pulse.Beat(1);
         ++other)
    {
      const Id next = other->second;
      const double distance = Distance(place, mesh.Points[At(next)]);
      if (kept[At(next)] == next && distance < std::min(reach, reaches[At(next)]))
      {
        kept[At(std::max(vertex, next))] = std::min(vertex, next);
        problems.Add({ ProblemCode::NearPoints,
          { mesh.PointIds[At(std::max(vertex, next))], mesh.PointIds[At(std::min(vertex, next))] },
          place, "on open edges, " + Figure(distance) + " apart" });
      }
    }
  }
  for (Id& vertex : kept)
  {
    vertex = kept[At(vertex)]; // lower ones first
  }
  MergeVertices(mesh, kept);
}

void CloseHoles(SurfaceMesh& mesh, SurfaceLinks& links, const SpacingField& spacing,
  ProblemList& problems, Pulse& pulse)
{
  if (links.NumberOfOpen == 0)
  {
    return;
  }
  const std::size_t given = mesh.NumberOfTriangles();
  HolePatches patches(mesh, links, spacing, pulse);
  for (const BorderChain& hole : BorderChains(mesh, links, pulse))
  {
    if (patches.Close(hole))
    {
      problems.Add(BorderProblem(ProblemCode::ClosedHoles, mesh, hole));
    }
  }
  links = LinkSurface(mesh, pulse);
  FlipThinTriangles(mesh, links, given, pulse);
}

Problem BorderProblem(ProblemCode code, const SurfaceMesh& mesh, const BorderChain& chain)
{
  constexpr int Digits = 6;
  const Id first = chain.Vertices.front();
  return { code, { mesh.PointIds[At(first)] }, mesh.Points[At(first)],
    (chain.IsLoop ? "a loop of " : "a chain of ") + std::to_string(chain.Slots.size()) +
      " edges, length " + Figure(chain.Length, Digits) + ", area " + Figure(chain.Area, Digits) };
}

} // namespace biting
