// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ConstrainedMesh.h"
#include "Flips.h"

#include <cstdint> // for the generator of the walk

namespace biting
{

namespace
{

/// Inserts vertices into a mesh that carries marks.
class LateInserter
{
public:
  LateInserter(HalfEdgeMesh& mesh, double phi, Pulse& pulse)
    : Mesh(mesh)
    , Phi(phi)
    , Beats(pulse)
  {
  }

  /// Inserts the point, or returns the vertex that it coincides with.
  Id Insert(const Point2& point)
  {
    const Id triangle = this->FindTriangle(point);
    this->Last = triangle;
    const Id known = this->VertexAt(triangle, point);
    if (known != NoId || this->Beats.HasStopped())
    {
      return known;
    }
    const Id vertex = this->Mesh.NumberOfVertices();
    this->Mesh.Points.push_back(point);
    Id onEdge = NoId;
    if (!this->Mesh.IsGhost(triangle))
    {
      for (Id edge = HalfEdgeMesh::FirstEdge(triangle), k = 0; k < 3; ++k, ++edge)
      {
        onEdge = this->Mesh.Side(edge, point) == 0 ? k : onEdge;
      }
    }
    this->Split(triangle, vertex);
    if (onEdge != NoId)
    {
      const Id flat = onEdge == 0 ? triangle : this->Mesh.NumberOfTriangles - 3 + onEdge;
      const Id edge = HalfEdgeMesh::FirstEdge(flat);
      this->DivideEdge(edge, this->Mesh.Mark(edge));
    }
    RestoreDelaunay(this->Mesh, this->Phi, this->Stack, this->Beats);
    return vertex;
  }

private:
  bool IsOtherWayFirst()
  {
    this->Generator = this->Generator * 1664525u + 1013904223u;
    return (this->Generator >> 31) != 0u;
  }

  /// A walk as in Insertion.cxx, by chance, as constraints keep the mesh from being Delaunay.
  Id FindTriangle(const Point2& point)
  {
    Id edge = HalfEdgeMesh::FirstEdge(this->Last);
    while (this->Beats.Beat(1))
    {
      if (this->Mesh.IsGhost(HalfEdgeMesh::TriangleOf(edge)))
      {
        while (this->Mesh.Corners[edge] != NoId)
        {
          edge = HalfEdgeMesh::Next(edge);
        }
        if (this->Mesh.Side(edge, point) > 0)
        {
          break;
        }
        edge = this->Mesh.Twins[edge];
      }
      edge = this->IsOtherWayFirst() ? HalfEdgeMesh::Next(edge) : edge;
      Id steps = 0;
      while (steps < 3 && this->Mesh.Side(edge, point) >= 0)
      {
        edge = HalfEdgeMesh::Next(edge);
        ++steps;
      }
      if (steps == 3)
      {
        break;
      }
      edge = HalfEdgeMesh::Next(this->Mesh.Twins[edge]);
    }
    return HalfEdgeMesh::TriangleOf(edge);
  }

  Id VertexAt(Id triangle, const Point2& point) const
  {
    for (Id k = 0; k < 3; ++k)
    {
      const Id vertex = this->Mesh.Corners[HalfEdgeMesh::FirstEdge(triangle) + k];
      if (vertex != NoId && this->Mesh.PointAt(vertex) == point)
      {
        return vertex;
      }
    }
    return NoId;
  }

  /// Into three; the outer edges keep their marks.
  void Split(Id triangle, Id vertex)
  {
    HalfEdgeMesh& mesh = this->Mesh;
    const std::size_t size = mesh.Corners.size() + 8;
    mesh.Corners.resize(size, 0);
    mesh.Twins.resize(size, NoId);
    mesh.VertexEdges.push_back(HalfEdgeMesh::FirstEdge(triangle));
    const Id old = HalfEdgeMesh::FirstEdge(triangle);
    const Id second = HalfEdgeMesh::FirstEdge(mesh.NumberOfTriangles);
    const Id marks[3] = { mesh.Mark(old), mesh.Mark(old + 1), mesh.Mark(old + 2) };
    mesh.Split(triangle, vertex);
    const Id firsts[3] = { old, second, second + 4 };
    for (int k = 0; k < 3; ++k)
    {
      mesh.SetMark(firsts[k], marks[k]);
      mesh.SetMark(firsts[k] + 1, NoId);
      mesh.SetMark(firsts[k] + 2, NoId);
      this->Stack.push_back(firsts[k]);
      for (Id corner = firsts[k]; corner < firsts[k] + 3; ++corner)
      {
        if (mesh.Corners[corner] != NoId)
        {
          mesh.VertexEdges[mesh.Corners[corner]] = corner;
        }
      }
    }
  }

  /// The triangle of `edge` is flat: the new vertex, opposite, lies on it. Its halves keep the
  /// mark.
  void DivideEdge(Id edge, Id mark)
  {
    const Id twin = this->Mesh.Twins[edge];
    this->Mark(edge, NoId);
    FlipEdge(this->Mesh, edge);
    this->Mark(HalfEdgeMesh::Previous(edge), mark);
    this->Mark(twin, mark);
    for (const Id outer : { edge, HalfEdgeMesh::Previous(twin) })
    {
      this->Stack.push_back(outer);
    }
  }

  void Mark(Id edge, Id mark)
  {
    this->Mesh.SetMark(edge, mark);
    this->Mesh.SetMark(this->Mesh.Twins[edge], mark);
  }

  HalfEdgeMesh& Mesh;
  double Phi;
  Pulse& Beats;
  Id Last = 0; ///< triangle where the next walk starts
  std::uint32_t Generator = 1;
  std::vector<Id> Stack;
};

} // namespace

void InsertLate(const std::vector<Point2>& points, double phi, ConstrainedMesh& mesh, Pulse& pulse)
{
  InsertionResult& inserted = mesh.Inserted;
  LateInserter inserter(inserted.Mesh, phi, pulse);
  for (std::size_t& point = mesh.NumberOfPoints; point < points.size() && pulse.Beat(); ++point)
  {
    const Id vertex = inserter.Insert(points[point]);
    if (vertex == static_cast<Id>(inserted.Order.size()))
    {
      inserted.Order.push_back(static_cast<Id>(point));
    }
  }
}

} // namespace biting
