// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceHoles.h"

#include "../../Base/DisjointSets.h"
#include "../../Base/DistanceToSegment.h"
#include "../../Base/Numbers.h"
#include "SurfaceRepair.h"

#include <algorithm> // for all_of, find_if, max, min, minmax, rotate
#include <array>     // for triangles
#include <numeric>   // for iota
#include <set>       // for edges
#include <utility>   // for pairs

namespace biting
{

namespace
{

// Patches for holes, one after the other.
class HolePatches
{
public:
  HolePatches(SurfaceMesh& mesh, const SurfaceLinks& links, const SpacingField& reach, Pulse& pulse)
    : Mesh(mesh)
    , Reach(reach)
    , Beats(pulse)
    , SlotsAt(CornersOfVertices(mesh))
    , Parts(mesh.NumberOfTriangles())
    , Areas(mesh.NumberOfTriangles(), 0.0)
  {
    for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
    {
      const Id own = static_cast<Id>(slot); // an open edge: with itself
      this->Parts.Unite(own / 3, std::max(own, links.Across[slot]) / 3);
    }
    for (std::size_t t = 0; t < mesh.NumberOfTriangles(); ++t)
    {
      this->Areas[At(this->Parts.SetOf(static_cast<Id>(t)))] += 0.5 * Length(mesh.Normal(t));
    }
  }

  // Whether the hole was closed.
  bool Close(const BorderChain& hole)
  {
    this->Begin(hole);
    return this->Fill();
  }

  // Whether both loops border one slit, which was closed: they are joined where they are nearest,
  // by an edge there and back.
  bool CloseBetween(const BorderChain& hole, const BorderChain& other)
  {
    this->Begin(other);
    const LoopEdges loop = std::move(this->Loop);
    this->Begin(hole);
    std::array<std::size_t, 2> nearest{ 0, 0 };
    double least = Infinity;
    for (std::size_t i = 0; i < this->Loop.size(); ++i)
    {
      for (std::size_t j = 0; j < loop.size() && this->Beats.Beat(1); ++j)
      {
        const double distance = Distance(this->Place(i), this->Mesh.Points[At(loop[j].first)]);
        nearest = distance < least ? std::array<std::size_t, 2>{ i, j } : nearest;
        least = std::min(distance, least);
      }
    }
    if (!(least <= 2.0 * this->Reach(this->Place(nearest[0]))))
    {
      return false;
    }
    this->Join(nearest[0], loop, nearest[1]);
    return this->Fill();
  }

private:
  using Corners = std::array<std::size_t, 3>;                ///< places of the loop, in order
  using LoopEdges = std::vector<std::pair<Id, std::size_t>>; ///< from a vertex; triangle beside

  // Takes the loop in the direction that patches have, against the triangles beside.
  void Begin(const BorderChain& hole)
  {
    this->Triangles.clear();
    this->Loop.clear();
    const std::size_t count = hole.Slots.size();
    const Id first = this->Mesh.Corners[NextSlotOf(At(hole.Slots.front()))];
    for (std::size_t k = 0; k < count; ++k)
    {
      const bool isTurned = first == hole.Vertices.front();
      const std::size_t edge = isTurned ? (2 * count - 2 - k) % count : k;
      this->Loop.emplace_back(hole.Vertices[isTurned ? edge + 1 : k], At(hole.Slots[edge]) / 3);
    }
  }

  const Point3& Place(std::size_t k) const { return this->Mesh.Points[At(this->Loop[k].first)]; }

  bool HasEdge(std::size_t i, std::size_t j) const
  {
    const Id one = this->Loop[i].first;
    const Id other = this->Loop[j].first;
    return one == other || this->Chords.count(std::minmax(one, other)) > 0 ||
      biting::HasEdge(this->Mesh, this->SlotsAt, one, other);
  }

  // The loop becomes one with another one, from its place `own` to the place `its` of that.
  void Join(std::size_t own, LoopEdges loop, std::size_t its)
  {
    const auto turn = [](LoopEdges& edges, std::size_t first) {
      std::rotate(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(first), edges.end());
    };
    turn(this->Loop, own);
    turn(loop, its);
    const Id from = this->Loop.front().first;
    const Id to = loop.front().first;
    if (from != to)
    {
      this->Chords.insert(std::minmax(from, to));
      this->Loop.emplace_back(from, this->Loop.back().second);
      loop.emplace_back(to, loop.back().second);
    }
    this->Loop.insert(this->Loop.end(), loop.begin(), loop.end());
  }

  // Whether the loop was closed.
  bool Fill()
  {
    std::vector<std::size_t> all(this->Loop.size());
    std::iota(all.begin(), all.end(), 0);
    const bool isClear = this->Triangulate(all) && !this->IsBack() &&
      std::all_of(this->Triangles.begin(), this->Triangles.end(),
        [this](const Corners& corners) { return this->IsClear(corners); });
    if (isClear)
    {
      this->AddTriangles();
    }
    return isClear;
  }

  // Whether the patch is half as large as what it closes, as the other side of a scrap is.
  bool IsBack()
  {
    double area = 0.0; // twice
    for (const Corners& corners : this->Triangles)
    {
      const Point3& a = this->Place(corners[0]);
      area += Length(Cross(this->Place(corners[1]) - a, this->Place(corners[2]) - a));
    }
    const Id first = this->Parts.SetOf(static_cast<Id>(this->Loop.front().second));
    const Id last = this->Parts.SetOf(static_cast<Id>(this->Loop.back().second));
    return area >= this->Areas[At(first)] + (first != last ? this->Areas[At(last)] : 0.0);
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
    return 0.5 * Length(Cross(a, b)) + Weight * (Dot(a, a) + Dot(b, b) + Dot(c, c));
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
    const double reach = this->Reach(place);
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
      // Cells and regions are those beside an edge of the loop, else beside the first corner.
      std::size_t from = 2;
      while (from > 0 && (corners[from] + 1) % this->Loop.size() != corners[(from + 1) % 3])
      {
        --from;
      }
      const std::size_t added = this->Mesh.NumberOfTriangles();
      this->Mesh.Resize(added + 1);
      this->Mesh.CopyTriangle(this->Loop[corners[from]].second, added);
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Id vertex = this->Loop[corners[k]].first;
        this->Mesh.Corners[3 * added + k] = vertex;
        this->Chords.insert(std::minmax({ vertex, this->Loop[corners[(k + 1) % 3]].first }));
      }
    }
  }

  SurfaceMesh& Mesh;
  const SpacingField& Reach;
  Pulse& Beats;
  IdLists SlotsAt;                    ///< of the given triangles
  DisjointSets Parts;                 ///< of given triangles: by edges of two
  std::vector<double> Areas;          ///< of the parts
  std::set<std::pair<Id, Id>> Chords; ///< edges of patches
  LoopEdges Loop;                     ///< of the hole at hand
  std::vector<Corners> Triangles;     ///< of its patch
};

} // namespace

void CloseHoles(SurfaceMesh& mesh, SurfaceLinks& links, const SpacingField& reach,
  ProblemList& problems, Pulse& pulse)
{
  const std::size_t given = mesh.NumberOfTriangles();
  HolePatches patches(mesh, links, reach, pulse);
  std::vector<BorderChain> left;
  const auto tell = [&mesh, &problems](const BorderChain& hole)
  { problems.Add(BorderProblem(ProblemCode::ClosedHoles, mesh, hole)); };
  for (BorderChain& hole : BorderChains(mesh, links, pulse))
  {
    constexpr std::size_t MostEdges = 10000;
    const bool isPossible = hole.IsLoop && hole.Slots.size() <= MostEdges;
    if (isPossible && patches.Close(hole))
    {
      tell(hole);
    }
    else if (isPossible)
    {
      left.push_back(std::move(hole));
    }
  }
  constexpr std::size_t MostPairs = 1000000;
  constexpr std::size_t MostSpent = 100000000; // on all: the rest stays open
  std::size_t spent = 0;
  for (auto hole = left.begin(); hole != left.end() && spent < MostSpent && pulse.Ask(); ++hole)
  {
    const Point3 place = mesh.Points[At(hole->Vertices.front())];
    const double near = 2.0 * reach(place);
    const auto other = std::find_if(hole + 1, left.end(),
      [&](const BorderChain& next)
      {
        // No place of a loop is farther from its first vertex than half of its length.
        const double apart = Distance(place, mesh.Points[At(next.Vertices.front())]);
        const std::size_t pairs = hole->Slots.size() * next.Slots.size();
        const bool isNear =
          apart <= near + 0.5 * (hole->Length + next.Length) && pairs <= MostPairs;
        spent += isNear ? pairs : 1;
        return isNear && spent < MostSpent && patches.CloseBetween(*hole, next);
      });
    if (other != left.end())
    {
      tell(*hole);
      tell(*other);
      left.erase(other);
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
