// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Cavity.h"

#include "../Predicates/Predicates.h"

#include <cstdint> // for the generator of the order
#include <utility> // for swap

namespace biting
{

namespace
{

/// Chains with fewer edges are filled by the scan at once: it is simpler, and the flips are few.
constexpr std::size_t LeastRandomFill = 32;

/// Triangulates the polygon between a chain and the base, the segment from the chain's first vertex
/// to its last. Each edge of the chain, and the base, has a place: 0, 1, ... along the chain, last
/// the base. A half-edge on the border of the polygon has ~place as its twin while the polygon is
/// filled.
///
/// Long chains: vertices are taken out of the chain in random order, and inserted in reverse order
/// with flips; a vertex that is nearer to the base than both its neighbors stays for the time being
/// (Shewchuk, Brown, "Fast segment insertion and incremental construction of constrained Delaunay
/// triangulations", 2015). Expected time O(n log n), and the result is Delaunay but for rare edges.
///
/// Short chains, and should a triangle have come out reversed: a scan with a stack, which is right
/// as the base sees all of the chain (Toussaint, Avis, "On a convex hull algorithm for polygons",
/// 1982). Linear, but flips remain to be done, n^2 for a long arc.
class ChainFiller
{
public:
  ChainFiller(HalfEdgeMesh& mesh, const CavityChain& chain, const Id* triangles)
    : Mesh(mesh)
    , Chain(chain)
    , Triangles(triangles)
  {
  }

  /// Notes what lies beyond the chain; before any triangle of the cavity is overwritten.
  void NoteOutside()
  {
    const auto& edges = this->Chain.Edges;
    for (const Id edge : edges)
    {
      this->Outside.push_back(this->Mesh.Twins[edge]);
      this->Marks.push_back(this->Mesh.Mark(edge));
    }
    for (std::size_t place = 0; place < edges.size(); ++place)
    {
      this->Mesh.Twins[edges[place]] = ~static_cast<Id>(place);
    }
    for (Id& outside : this->Outside)
    {
      const Id twin = this->Mesh.Twins[outside];
      outside = twin < 0 ? twin : outside;
    }
  }

  /// Makes the triangles; returns the half-edge from the chain's first vertex to its last.
  Id Fill(std::vector<Id>& stack)
  {
    this->Inside.assign(this->Chain.Edges.size() + 1, NoId);
    const bool isLong = this->Chain.Edges.size() >= LeastRandomFill;
    if (isLong)
    {
      this->FillAtRandom();
    }
    if (!isLong || !this->IsValid())
    {
      this->FillByScan();
    }
    this->Finish(stack);
    return this->Inside.back();
  }

  /// How many triangles that takes.
  std::size_t Size() const { return this->Chain.Edges.size() - 1; }

private:
  /// A vertex of the scan, and what faces the edge from the vertex before.
  struct Entry
  {
    Id Vertex;
    Id Facing;
  };

  void FillByScan()
  {
    this->Used = 0;
    this->Scan.assign(1, { this->Chain.Vertices[0], NoId });
    for (std::size_t place = 0; place < this->Chain.Edges.size(); ++place)
    {
      Entry next{ this->Chain.Vertices[place + 1], ~static_cast<Id>(place) };
      while (this->Scan.size() >= 2 && this->IsCutOff(next.Vertex))
      {
        next.Facing = this->CutOff(next);
        this->Scan.pop_back();
      }
      this->Scan.push_back(next);
    }
    this->Attach(this->Scan.back().Facing, ~static_cast<Id>(this->Chain.Edges.size()));
  }

  /// Whether the chain, at the top of the scan, turns away from the base.
  bool IsCutOff(Id next) const
  {
    const Id corner = this->Scan.back().Vertex;
    const Id before = this->Scan[this->Scan.size() - 2].Vertex;
    return Orient2D(
             this->Mesh.PointAt(before), this->Mesh.PointAt(next), this->Mesh.PointAt(corner)) > 0;
  }

  /// Cuts the top of the scan off; returns the half-edge that now leads from below it to `next`.
  Id CutOff(const Entry& next)
  {
    const Entry& corner = this->Scan.back();
    const Id before = this->Scan[this->Scan.size() - 2].Vertex;
    const Id triangle = this->TakeTriangle();
    const Id first = HalfEdgeMesh::FirstEdge(triangle);
    this->Mesh.SetTriangle(triangle, before, next.Vertex, corner.Vertex);
    this->Attach(first, next.Facing);
    this->Attach(first + 1, corner.Facing);
    return first + 2;
  }

  void FillAtRandom()
  {
    const std::size_t size = this->Chain.Vertices.size();
    const Point2 base = this->Mesh.PointAt(this->Chain.Vertices[0]);
    const Point2 along = this->Mesh.PointAt(this->Chain.Vertices[size - 1]) - base;
    for (std::size_t i = 0; i < size; ++i)
    {
      this->Order.push_back(static_cast<Id>(i));
      this->Nexts.push_back(static_cast<Id>(i) + 1);
      this->Previouses.push_back(static_cast<Id>(i) - 1);
      this->Heights.push_back(Cross(along, this->Mesh.PointAt(this->Chain.Vertices[i]) - base));
    }
    this->TakeOut(size - 2);
    this->AddFirst(this->Order[1]);
    for (std::size_t i = 2; i < size - 1; ++i)
    {
      this->Insert(this->Order[i]);
    }
  }

  /// Takes all of the `count` inner vertices out of the chain but one; Order tells their sequence,
  /// from the end.
  void TakeOut(std::size_t count)
  {
    for (std::size_t last = count; last > 1; --last)
    {
      std::size_t choice = 1 + this->RandomBelow(last);
      while (this->IsNearerThanNeighbors(this->Order[choice]))
      {
        choice = 1 + this->RandomBelow(last);
      }
      std::swap(this->Order[choice], this->Order[last]);
      const Id position = this->Order[last];
      this->Nexts[this->Previouses[position]] = this->Nexts[position];
      this->Previouses[this->Nexts[position]] = this->Previouses[position];
    }
  }

  bool IsNearerThanNeighbors(Id position) const
  {
    const double height = this->Heights[position];
    return height < this->Heights[this->Previouses[position]] &&
      height < this->Heights[this->Nexts[position]];
  }

  std::size_t RandomBelow(std::size_t bound)
  {
    this->Generator = this->Generator * 1664525u + 1013904223u;
    return static_cast<std::size_t>((static_cast<std::uint64_t>(this->Generator) * bound) >> 32);
  }

  void AddFirst(Id position)
  {
    const Id base = static_cast<Id>(this->Chain.Edges.size());
    const Id triangle = this->TakeTriangle();
    const auto& vertices = this->Chain.Vertices;
    this->Mesh.SetTriangle(triangle, vertices[0], vertices[base], vertices[position]);
    const Id first = HalfEdgeMesh::FirstEdge(triangle);
    this->Attach(first, ~position);
    this->Attach(first + 1, ~Id(0));
    this->Attach(first + 2, ~base);
  }

  /// Adds a triangle to the edge between the neighbors, reversed perhaps, and goes around the
  /// vertex, corner 0 of all its triangles, flipping.
  void Insert(Id position)
  {
    const Id previous = this->Previouses[position];
    const auto& vertices = this->Chain.Vertices;
    const Id triangle = this->TakeTriangle();
    this->Mesh.SetTriangle(
      triangle, vertices[position], vertices[previous], vertices[this->Nexts[position]]);
    Id edge = HalfEdgeMesh::FirstEdge(triangle);
    this->Attach(edge, this->Inside[previous]);
    this->Attach(edge + 1, ~position);
    this->Attach(edge + 2, ~previous);
    while (true)
    {
      if (this->IsToFlip(edge))
      {
        this->Mesh.FlipAround(edge, [this](Id one, Id twin) { this->Attach(one, twin); });
        continue;
      }
      const Id ahead = this->Mesh.Twins[edge + 1];
      if (ahead < 0)
      {
        break;
      }
      edge = ahead - 2;
    }
  }

  bool IsToFlip(Id edge) const
  {
    const Id twin = this->Mesh.Twins[edge];
    if (twin < 0)
    {
      return false;
    }
    const Point2& p = this->Mesh.PointAt(this->Mesh.Corners[edge]);
    const Point2& a = this->Mesh.PointAt(this->Mesh.Corners[edge + 1]);
    const Point2& b = this->Mesh.PointAt(this->Mesh.Corners[edge + 2]);
    return Orient2D(p, a, b) <= 0 ||
      InCircle(p, a, b, this->Mesh.PointAt(this->Mesh.Corners[twin])) > 0;
  }

  Id TakeTriangle() { return this->Triangles[this->Used++]; }

  void Attach(Id edge, Id facing)
  {
    if (facing < 0)
    {
      this->Mesh.Twins[edge] = facing;
      this->Inside[~facing] = edge;
      return;
    }
    this->Mesh.Link(edge, facing);
  }

  bool IsValid() const
  {
    for (std::size_t i = 0; i < this->Used; ++i)
    {
      const Id first = HalfEdgeMesh::FirstEdge(this->Triangles[i]);
      if (Orient2D(this->Mesh.PointAt(this->Mesh.Corners[first]),
            this->Mesh.PointAt(this->Mesh.Corners[first + 1]),
            this->Mesh.PointAt(this->Mesh.Corners[first + 2])) <= 0)
      {
        return false;
      }
    }
    return true;
  }

  void Finish(std::vector<Id>& stack)
  {
    for (std::size_t i = 0; i < this->Used; ++i)
    {
      const Id first = HalfEdgeMesh::FirstEdge(this->Triangles[i]);
      for (Id edge = first; edge < first + 3; ++edge)
      {
        this->Mesh.SetMark(edge, NoId);
        this->Mesh.VertexEdges[this->Mesh.Corners[edge]] = edge;
        if (this->Mesh.Twins[edge] > edge)
        {
          stack.push_back(edge);
        }
      }
    }
    for (std::size_t place = 0; place < this->Outside.size(); ++place)
    {
      const Id edge = this->Inside[place];
      const Id outside = this->Outside[place];
      this->Mesh.Link(edge, outside < 0 ? this->Inside[~outside] : outside);
      this->Mesh.SetMark(edge, this->Marks[place]);
      stack.push_back(edge);
    }
  }

  HalfEdgeMesh& Mesh;
  const CavityChain& Chain;
  const Id* Triangles; ///< that may be overwritten
  std::size_t Used = 0;
  std::vector<Id> Outside; ///< place -> half-edge beyond the chain, or ~place of the same edge
  std::vector<Id> Marks;   ///< place -> mark
  std::vector<Id> Inside;  ///< place -> new half-edge
  std::vector<Entry> Scan;

  // For the random order; positions count the vertices along the chain.
  std::vector<Id> Order;
  std::vector<Id> Nexts;
  std::vector<Id> Previouses;
  std::vector<double> Heights; ///< distance from the base, in some unit; rounded
  std::uint32_t Generator = 1;
};

} // namespace

Id FillCavity(HalfEdgeMesh& mesh, const Cavity& cavity, std::vector<Id>& stack)
{
  ChainFiller left(mesh, cavity.Left, cavity.Triangles.data());
  ChainFiller right(mesh, cavity.Right, cavity.Triangles.data() + left.Size());
  left.NoteOutside();
  right.NoteOutside();
  const Id edge = left.Fill(stack);
  mesh.Link(edge, right.Fill(stack));
  return edge;
}

} // namespace biting
