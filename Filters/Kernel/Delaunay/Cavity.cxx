// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Cavity.h"

#include "../Predicates/Predicates.h"

namespace biting
{

namespace
{

/// Triangulates the polygon between a chain and the base, the segment from the chain's first vertex
/// to its last. Each edge of the chain, and the base, has a place: 0, 1, ... along the chain, last
/// the base. A half-edge on the border of the polygon has ~place as its twin while the polygon is
/// filled.
///
/// A scan with a stack, which is right as the base sees all of the chain (Toussaint, Avis, "On a
/// convex hull algorithm for polygons", 1982). Linear, but flips remain to be done, n^2 for a long
/// arc: few, as parts of segments are as long as f.
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
    this->FillByScan();
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
