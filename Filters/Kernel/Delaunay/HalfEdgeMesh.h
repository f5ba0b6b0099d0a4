// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingHalfEdgeMesh_h
#define BitingHalfEdgeMesh_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Predicates/Predicates.h"

#include <vector> // for the arrays

namespace biting
{

/// The triangulation at work: it covers the whole plane. Beyond each edge of the convex hull lies a
/// ghost triangle whose third corner, NoId, is the vertex at infinity.
///
/// Half-edge e = 4t + k (k = 0..2; 4t + 3 is none) belongs to triangle t and lies opposite its
/// corner k, Corners[e]. It runs from Corners[Next(e)] to Corners[Previous(e)], its triangle on the
/// left. Twins[e] is the same edge in the triangle on its right: there is always one.
struct HalfEdgeMesh
{
  std::vector<Point2> Points; ///< in the order of insertion
  std::vector<Id> Corners;
  std::vector<Id> Twins;
  Id NumberOfTriangles = 0; ///< ghosts included

  std::vector<Id> Marks; ///< those of triangle t, if it ever had one, are the three from
                         ///< Twins[4t + 3] on; that is NoId for the others

  // Filled when constraints are recovered, empty before.
  std::vector<Id> VertexEdges; ///< a half-edge whose corner is the vertex

  static Id Next(Id edge) { return (edge & 3) == 2 ? edge - 2 : edge + 1; }
  static Id Previous(Id edge) { return (edge & 3) == 0 ? edge + 2 : edge - 1; }
  static Id TriangleOf(Id edge) { return edge >> 2; }
  static Id FirstEdge(Id triangle) { return triangle << 2; }

  Id Origin(Id edge) const { return this->Corners[Next(edge)]; }
  Id Target(Id edge) const { return this->Corners[Previous(edge)]; }
  const Point2& PointAt(Id vertex) const { return this->Points[vertex]; }
  Id NumberOfVertices() const { return static_cast<Id>(this->Points.size()); }

  bool IsGhost(Id triangle) const
  {
    const Id first = FirstEdge(triangle);
    return (this->Corners[first] | this->Corners[first + 1] | this->Corners[first + 2]) < 0;
  }

  /// Twice the constraint on the half-edge, plus 1 where inside and outside change across it; NoId
  /// where there is none. Few triangles have one.
  Id Mark(Id edge) const
  {
    const Id place = this->Twins[edge | 3];
    return place == NoId ? NoId : this->Marks[place + (edge & 3)];
  }

  bool HasMarks(Id triangle) const { return this->Twins[FirstEdge(triangle) + 3] != NoId; }

  void SetMark(Id edge, Id mark)
  {
    Id& place = this->Twins[edge | 3];
    if (place == NoId && mark != NoId)
    {
      place = static_cast<Id>(this->Marks.size());
      this->Marks.insert(this->Marks.end(), 3, NoId);
    }
    if (place != NoId)
    {
      this->Marks[place + (edge & 3)] = mark;
    }
  }

  void Link(Id edge, Id twin)
  {
    this->Twins[edge] = twin;
    this->Twins[twin] = edge;
  }

  void SetTriangle(Id triangle, Id a, Id b, Id c)
  {
    const Id first = FirstEdge(triangle);
    this->Corners[first] = a;
    this->Corners[first + 1] = b;
    this->Corners[first + 2] = c;
  }

  /// Where `point` lies of the half-edge: +1 on its left, -1 on its right, 0 on its line, exactly.
  int Side(Id edge, const Point2& point) const
  {
    return Orient2D(this->Points[this->Origin(edge)], this->Points[this->Target(edge)], point);
  }

  /// Flips the edge opposite corner 0, which becomes corner 0 of both triangles: (p, a, b) and
  /// (d, b, a) turn into (p, a, d) and (p, d, b). Marks and VertexEdges do not follow.
  void FlipAround(Id edge)
  {
    const Id twin = this->Twins[edge];
    const Id other = FirstEdge(TriangleOf(twin));
    const Id b = this->Corners[edge + 2];
    const Id d = this->Corners[twin];
    const Id beyondAd = this->Twins[Next(twin)];
    const Id beyondDb = this->Twins[Previous(twin)];
    const Id ahead = this->Twins[edge + 1];
    this->Corners[edge + 2] = d;
    this->SetTriangle(TriangleOf(twin), this->Corners[edge], d, b);
    this->Link(edge, beyondAd);
    this->Link(other, beyondDb);
    this->Link(other + 1, ahead);
    this->Link(edge + 1, other + 2);
  }

  /// Divides the triangle into three by a vertex, which becomes corner 0 of each. The triangle
  /// keeps the edge opposite its corner 0, the two new ones, the last of all, take those opposite 1
  /// and 2. There is room for them; marks and VertexEdges do not follow.
  void Split(Id triangle, Id vertex)
  {
    const Id old = FirstEdge(triangle);
    const Id second = FirstEdge(this->NumberOfTriangles);
    const Id third = second + 4;
    const Id a = this->Corners[old];
    const Id b = this->Corners[old + 1];
    const Id c = this->Corners[old + 2];
    this->SetTriangle(triangle, vertex, b, c);
    this->SetTriangle(this->NumberOfTriangles, vertex, c, a);
    this->SetTriangle(this->NumberOfTriangles + 1, vertex, a, b);
    this->NumberOfTriangles += 2;
    this->Link(second, this->Twins[old + 1]);
    this->Link(third, this->Twins[old + 2]);
    this->Link(old + 1, second + 2);
    this->Link(second + 1, third + 2);
    this->Link(third + 1, old + 2);
  }
};

} // namespace biting

#endif
