// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SharedWalls.h"

#include "SurfaceLinks.h"

#include <algorithm> // for all_of, lower_bound, sort, unique
#include <cmath>     // for abs, sqrt
#include <cstdint>   // for marks
#include <utility>   // for pairs

namespace biting
{

namespace
{

class WallJoiner
{
public:
  WallJoiner(SurfaceMesh& mesh, ProblemList& problems, Pulse& pulse)
    : Mesh(mesh)
    , Problems(problems)
    , Beats(pulse)
  {
  }

  void Run()
  {
    constexpr int MostRounds = 30;
    bool isChanged = std::all_of(this->Mesh.Regions.begin(), this->Mesh.Regions.end(),
      [](const RegionPair& pair) { return pair[1] == NoId; });
    for (int round = 0; isChanged && round < MostRounds && this->Beats.Ask(); ++round)
    {
      this->SetApart();
      if (this->Links.NumberOfOpen > 0)
      {
        return;
      }
      isChanged = false;
      for (std::size_t slot = 0; slot < this->Mesh.Corners.size() && this->Beats.Beat(); ++slot)
      {
        isChanged = this->GiveToOthers(slot) || isChanged;
      }
      isChanged = isChanged || this->DivideFolds();
    }
  }

private:
  /// A vertex of the surface of one region.
  using RegionVertex = std::pair<Id, Id>; ///< vertex, region

  /// Triangles from one vertex to another: the edges between them are Crossed, as slots of the
  /// triangles before; the vertices beside them are on the right, or on the left, if one stands in
  /// the first triangle and looks to the last.
  struct Strip
  {
    std::vector<std::size_t> Crossed;
    std::vector<Id> Right;
    std::vector<Id> Left;
    std::size_t Last = 0; ///< triangle
  };

  static constexpr std::size_t MostCrossed = 3;

  Id RegionOf(std::size_t triangle) const { return this->Mesh.Regions[triangle][0]; }

  /// The surfaces of regions without common vertices.
  void SetApart()
  {
    const std::size_t slots = this->Mesh.Corners.size();
    this->Vertices.clear();
    this->Vertices.reserve(slots);
    for (std::size_t slot = 0; slot < slots; ++slot)
    {
      this->Vertices.emplace_back(this->Mesh.Corners[slot], this->RegionOf(slot / 3));
    }
    std::sort(this->Vertices.begin(), this->Vertices.end());
    this->Vertices.erase(
      std::unique(this->Vertices.begin(), this->Vertices.end()), this->Vertices.end());
    this->Apart.Points.resize(this->Vertices.size());
    this->Apart.Corners.resize(slots);
    for (std::size_t slot = 0; slot < slots; ++slot)
    {
      this->Apart.Corners[slot] =
        this->NumberOf({ this->Mesh.Corners[slot], this->RegionOf(slot / 3) });
    }
    this->SlotsAt = CornersOfVertices(this->Apart);
    this->Links = LinkSurface(this->Apart, this->Beats);
    this->IsTouched.assign(this->Mesh.Points.size(), 0);
  }

  Id NumberOf(const RegionVertex& vertex) const
  {
    const auto at = std::lower_bound(this->Vertices.begin(), this->Vertices.end(), vertex);
    return at != this->Vertices.end() && *at == vertex
      ? static_cast<Id>(at - this->Vertices.begin())
      : NoId;
  }

  /// Calls visit(a, b) for the numbers of both ends of an edge in each other region that has them.
  template <typename Visit>
  void ForOtherRegions(Id from, Id to, Id region, const Visit& visit) const
  {
    auto at = std::lower_bound(this->Vertices.begin(), this->Vertices.end(), RegionVertex(from, 0));
    for (; at != this->Vertices.end() && at->first == from; ++at)
    {
      const Id other = at->second == region ? NoId : this->NumberOf({ to, at->second });
      if (other != NoId)
      {
        visit(static_cast<Id>(at - this->Vertices.begin()), other);
      }
    }
  }

  bool HasEdge(Id from, Id to) const
  {
    return biting::HasEdge(this->Apart, this->SlotsAt, from, to);
  }

  /// Whether the edge opposite the slot came to another region's surface.
  bool GiveToOthers(std::size_t slot)
  {
    const Id from = this->Mesh.Corners[NextSlotOf(slot)];
    const Id to = this->Mesh.Corners[PreviousSlotOf(slot)];
    bool isChanged = false;
    if ((this->IsTouched[At(from)] | this->IsTouched[At(to)]) == 0)
    {
      this->ForOtherRegions(from, to, this->RegionOf(slot / 3),
        [this, &isChanged, slot](Id a, Id b)
        {
          if (!isChanged && !this->HasEdge(a, b))
          {
            isChanged = this->Recover(a, b);
            if (isChanged)
            {
              this->Problems.Add({ ProblemCode::DuplicateTriangles,
                { this->Mesh.Cells[slot / 3], this->Mesh.Cells[this->Found.Last] },
                Midpoint(this->Mesh.At(NextSlotOf(slot)), this->Mesh.At(PreviousSlotOf(slot))),
                "with other edges" });
            }
          }
        });
    }
    return isChanged;
  }

  /// Makes the edge from a to b, if there is a strip for it: the shortest, the first of these.
  bool Recover(Id a, Id b)
  {
    for (std::size_t most = 1; most <= MostCrossed; ++most)
    {
      for (const Id own : this->SlotsAt[a])
      {
        const std::size_t slot = At(own);
        this->Found = {};
        this->Found.Right.push_back(this->Apart.Corners[NextSlotOf(slot)]);
        this->Found.Left.push_back(this->Apart.Corners[PreviousSlotOf(slot)]);
        if (this->Extend(a, b, slot, most) && this->IsSound(a, b))
        {
          this->Divide(slot / 3, a, b);
          return true;
        }
      }
    }
    return false;
  }

  /// Goes on across the edge opposite the slot until b is reached across `most` edges.
  bool Extend(Id a, Id b, std::size_t slot, std::size_t most)
  {
    const Id across = this->Links.Across[slot];
    if (across < 0 || !this->MayGo(slot, a, b))
    {
      return false;
    }
    const std::size_t next = At(across);
    const Id apex = this->Apart.Corners[next];
    this->Found.Crossed.push_back(slot);
    this->Found.Last = next / 3;
    if (most == 1)
    {
      if (apex == b)
      {
        return true;
      }
    }
    else if (apex != b && apex != a)
    {
      // Opposite the vertex on one side is the edge from the apex to that on the other side.
      for (const bool isRight : { true, false })
      {
        std::vector<Id>& side = isRight ? this->Found.Right : this->Found.Left;
        const std::size_t base = next - next % 3;
        const std::size_t opposite = base + CornerOf(&this->Apart.Corners[base], side.back());
        side.push_back(apex);
        if (this->Extend(a, b, opposite, most - 1))
        {
          return true;
        }
        side.pop_back();
      }
    }
    this->Found.Crossed.pop_back();
    return false;
  }

  /// Whether the edge opposite the slot is of one region, and passes the line from a to b between
  /// its ends, near to it.
  bool MayGo(std::size_t slot, Id a, Id b) const
  {
    constexpr double Near = 0.25;
    const Id from = this->Mesh.Corners[NextSlotOf(slot)];
    const Id to = this->Mesh.Corners[PreviousSlotOf(slot)];
    if ((this->IsTouched[At(from)] | this->IsTouched[At(to)]) != 0)
    {
      return false;
    }
    bool isShared = false;
    this->ForOtherRegions(from, to, this->RegionOf(slot / 3),
      [this, &isShared](Id p, Id q) { isShared = isShared || this->HasEdge(p, q); });
    Point3 place;
    return !isShared &&
      this->PassNear(
        this->Vertices[At(a)].first, this->Vertices[At(b)].first, from, to, Near, place);
  }

  /// Whether the lines from a to b and from p to q pass each other between their ends, nearer than
  /// `near` lengths of the first one; `place` then is between them.
  bool PassNear(Id a, Id b, Id p, Id q, double near, Point3& place) const
  {
    const Point3& begin = this->Mesh.Points[At(a)];
    const Point3& other = this->Mesh.Points[At(p)];
    const Point3 way = this->Mesh.Points[At(b)] - begin;
    const Point3 side = this->Mesh.Points[At(q)] - other;
    const Point3 normal = Cross(way, side);
    const double square = Dot(normal, normal);
    const double alongWay = Dot(Cross(other - begin, side), normal);
    const double alongSide = Dot(Cross(other - begin, way), normal);
    if (!(alongWay > 0.0 && alongWay < square && alongSide > 0.0 && alongSide < square))
    {
      return false;
    }
    place = Midpoint(begin + (alongWay / square) * way, other + (alongSide / square) * side);
    return std::abs(Dot(normal, other - begin)) <= near * std::sqrt(square) * Length(way);
  }

  /// Whether no vertex comes twice, and no new edge is there already.
  bool IsSound(Id a, Id b) const
  {
    std::vector<Id> all = this->Found.Right;
    all.insert(all.end(), this->Found.Left.begin(), this->Found.Left.end());
    std::sort(all.begin(), all.end());
    bool isSound = std::unique(all.begin(), all.end()) == all.end();
    for (const std::vector<Id>* side : { &this->Found.Right, &this->Found.Left })
    {
      for (std::size_t k = 0; k < side->size(); ++k)
      {
        isSound = isSound && (*side)[k] != a && (*side)[k] != b &&
          (k == 0 || !this->HasEdge(a, (*side)[k]));
      }
    }
    return isSound;
  }

  /// The triangles of the strip become two fans about a.
  void Divide(std::size_t first, Id a, Id b)
  {
    std::vector<Id> right = this->Found.Right;
    std::vector<Id> left = this->Found.Left;
    right.push_back(b);
    left.push_back(b);
    std::vector<std::size_t> triangles{ first };
    for (const std::size_t slot : this->Found.Crossed)
    {
      triangles.push_back(At(this->Links.Across[slot]) / 3);
    }
    std::size_t next = 0;
    const auto set = [this, &triangles, &next, a](Id p, Id q)
    {
      const std::size_t base = 3 * triangles[next++];
      const std::array<Id, 3> corners{ a, p, q };
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Id vertex = this->Vertices[At(corners[k])].first;
        this->Mesh.Corners[base + k] = vertex;
        this->IsTouched[At(vertex)] = 1;
      }
    };
    for (std::size_t k = 1; k < right.size(); ++k)
    {
      set(right[k - 1], right[k]);
    }
    for (std::size_t k = 1; k < left.size(); ++k)
    {
      set(left[k], left[k - 1]);
    }
  }

  /// Two triangles of different regions that share an edge and lie on each other: the other edges
  /// that cross are divided at one new vertex, which makes a triangle of both regions. Whether any
  /// were.
  bool DivideFolds()
  {
    const std::size_t slots = this->Mesh.Corners.size();
    this->Edges.clear();
    this->Edges.reserve(slots);
    for (std::size_t slot = 0; slot < slots; ++slot)
    {
      this->Edges.push_back({ EndsOf(this->Mesh, slot), slot });
    }
    std::sort(this->Edges.begin(), this->Edges.end());
    bool isChanged = false;
    std::size_t end = 0;
    for (std::size_t begin = 0; begin < slots && this->Beats.Beat(); begin = end)
    {
      while (end < slots && this->Edges[end].first == this->Edges[begin].first)
      {
        ++end;
      }
      for (std::size_t one = begin; one < end; ++one)
      {
        for (std::size_t other = one + 1; other < end; ++other)
        {
          isChanged =
            this->DivideFold(this->Edges[one].second, this->Edges[other].second) || isChanged;
        }
      }
    }
    return isChanged;
  }

  bool DivideFold(std::size_t slot, std::size_t other)
  {
    const Id p = this->Mesh.Corners[slot];
    const Id q = this->Mesh.Corners[other];
    const auto [low, high] = EndsOf(this->Mesh, slot);
    const auto isTouched = [this](Id vertex) { return this->IsTouched[At(vertex)] != 0; };
    if (this->RegionOf(slot / 3) == this->RegionOf(other / 3) || p == q || isTouched(p) ||
      isTouched(q) || isTouched(low) || isTouched(high))
    {
      return false;
    }
    constexpr double Flat = 0.05;
    const auto hasEdge = [this](Id from, Id to, std::size_t in)
    {
      const Id begin = this->NumberOf({ from, this->RegionOf(in / 3) });
      const Id end = this->NumberOf({ to, this->RegionOf(in / 3) });
      return begin != NoId && end != NoId && this->HasEdge(begin, end);
    };
    for (const bool isFirst : { true, false })
    {
      const Id a = isFirst ? low : high;
      const Id b = isFirst ? high : low;
      Point3 place;
      if (this->PassNear(a, p, b, q, Flat, place) && this->PassNear(b, q, a, p, Flat, place) &&
        !hasEdge(a, p, other) && !hasEdge(b, q, slot))
      {
        this->Problems.Add({ ProblemCode::DuplicateTriangles,
          { this->Mesh.Cells[slot / 3], this->Mesh.Cells[other / 3] }, place, "in part" });
        this->Mesh.Points.push_back(place);
        this->Mesh.PointIds.push_back(NoId);
        this->IsTouched.push_back(1);
        this->DivideEdge(a, p);
        this->DivideEdge(b, q);
        return true;
      }
    }
    return false;
  }

  /// At the last vertex.
  void DivideEdge(Id a, Id b)
  {
    const std::pair<Id, Id> ends = std::minmax(a, b);
    const auto middle = static_cast<Id>(this->Mesh.Points.size() - 1);
    auto edge = std::lower_bound(
      this->Edges.begin(), this->Edges.end(), std::pair<std::pair<Id, Id>, std::size_t>(ends, 0));
    for (; edge != this->Edges.end() && edge->first == ends; ++edge)
    {
      const std::size_t added = this->Mesh.NumberOfTriangles();
      const std::size_t own = edge->second / 3;
      this->Mesh.Resize(added + 1);
      this->Mesh.CopyTriangle(own, added);
      this->Mesh.Corners[3 * own + NextSlotOf(edge->second) % 3] = middle;
      this->Mesh.Corners[3 * added + PreviousSlotOf(edge->second) % 3] = middle;
      for (std::size_t k = 3 * added; k < 3 * added + 3; ++k)
      {
        this->IsTouched[At(this->Mesh.Corners[k])] = 1;
      }
      this->IsTouched[At(this->Mesh.Corners[PreviousSlotOf(edge->second)])] = 1;
    }
  }

  SurfaceMesh& Mesh;
  ProblemList& Problems;
  Pulse& Beats;
  std::vector<std::pair<std::pair<Id, Id>, std::size_t>> Edges; ///< of all slots, in order
  std::vector<RegionVertex> Vertices;  ///< in order; what follows has their numbers
  SurfaceMesh Apart;                   ///< corners only
  SurfaceLinks Links;                  ///< of it
  IdLists SlotsAt;                     ///< of vertices
  std::vector<std::uint8_t> IsTouched; ///< of vertices of the mesh: of triangles that changed
  Strip Found;
};

} // namespace

void JoinSharedWalls(SurfaceMesh& mesh, ProblemList& problems, Pulse& pulse)
{
  WallJoiner(mesh, problems, pulse).Run();
}

} // namespace biting
