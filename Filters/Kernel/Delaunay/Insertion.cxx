// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ConstrainedMesh.h"

#include "../Predicates/Predicates.h"
#include "Flips.h"

#include <cstdint> // for the generator of the walk
#include <utility> // for swap, move

namespace biting
{

namespace
{

// Of the time.
constexpr double CopyingEnd = 0.05;

/// Where a point lies: in a triangle, perhaps on one of its edges, or at a vertex.
struct Location
{
  Id Triangle = NoId;
  Id Edge = NoId;   ///< half-edge of Triangle that the point lies on
  Id Vertex = NoId; ///< vertex that the point coincides with
};

class Inserter
{
public:
  Inserter(HalfEdgeMesh& mesh, double phi, Pulse& pulse)
    : Mesh(mesh)
    , Phi(phi)
    , Beats(pulse)
  {
  }

  /// Makes the triangle of the vertices 0, 1, 2, and its three ghosts.
  void MakeFirstTriangle()
  {
    const auto& points = this->Mesh.Points;
    const bool isLeft = Orient2D(points[0], points[1], points[2]) > 0;
    this->Mesh.SetTriangle(0, 0, isLeft ? 1 : 2, isLeft ? 2 : 1);
    for (Id k = 0; k < 3; ++k)
    {
      this->Mesh.SetTriangle(k + 1, NoId, this->Mesh.Target(k), this->Mesh.Origin(k));
      this->Mesh.Link(k, HalfEdgeMesh::FirstEdge(k + 1));
      const Id ghostBefore = (k + 2) % 3 + 1;
      this->Mesh.Link(HalfEdgeMesh::FirstEdge(k + 1) + 1, HalfEdgeMesh::FirstEdge(ghostBefore) + 2);
    }
    this->Mesh.NumberOfTriangles = 4;
  }

  /// Inserts the vertex, or returns the one that it coincides with.
  Id Insert(Id vertex)
  {
    const Location location = this->Locate(this->Mesh.Points[vertex]);
    if (location.Vertex != NoId)
    {
      return location.Vertex;
    }
    this->Mesh.Split(location.Triangle, vertex);
    if (location.Edge != NoId)
    {
      this->Mesh.FlipAround(
        HalfEdgeMesh::FirstEdge(this->CornerTriangle(location.Triangle, location.Edge)));
    }
    if (this->Phi < 1.0)
    {
      this->RestorePhi(location.Triangle);
    }
    else
    {
      this->RestoreStar(location.Triangle);
    }
    return vertex;
  }

private:
  /// A visibility walk: leave by an edge that has the point strictly beyond it. In a Delaunay
  /// triangulation no triangle comes twice; in others chance sees to it (Devillers, Pion, Teillaud,
  /// "Walking in a triangulation", 2002).
  Location Locate(const Point2& point)
  {
    Id edge = this->FirstEdgeBefore(point);
    while (true)
    {
      const bool isSwapped = this->IsOtherWayFirst();
      const Id first = isSwapped ? HalfEdgeMesh::Previous(edge) : HalfEdgeMesh::Next(edge);
      const Id second = isSwapped ? HalfEdgeMesh::Next(edge) : HalfEdgeMesh::Previous(edge);
      const int firstSide = this->Mesh.Side(first, point);
      const int secondSide = firstSide < 0 ? 0 : this->Mesh.Side(second, point);
      if (firstSide >= 0 && secondSide >= 0)
      {
        const Id onEdge = firstSide == 0 ? first : (secondSide == 0 ? second : NoId);
        const bool isCorner = firstSide == 0 && secondSide == 0;
        return { HalfEdgeMesh::TriangleOf(edge), onEdge,
          isCorner ? this->Mesh.Corners[edge] : NoId };
      }
      edge = this->Mesh.Twins[firstSide < 0 ? first : second];
      if (this->Mesh.Corners[edge] == NoId)
      {
        return { HalfEdgeMesh::TriangleOf(edge), NoId, NoId };
      }
    }
  }

  /// A half-edge of the last triangle that has the point strictly on its left: there is always one.
  Id FirstEdgeBefore(const Point2& point) const
  {
    Id edge = HalfEdgeMesh::FirstEdge(this->Last);
    if (this->Mesh.IsGhost(this->Last))
    {
      while (this->Mesh.Corners[edge] != NoId)
      {
        ++edge;
      }
      edge = HalfEdgeMesh::FirstEdge(HalfEdgeMesh::TriangleOf(this->Mesh.Twins[edge]));
    }
    while (this->Mesh.Side(edge, point) <= 0)
    {
      ++edge;
    }
    return edge;
  }

  bool IsOtherWayFirst()
  {
    if (this->Phi >= 1.0)
    {
      return false;
    }
    this->Generator = this->Generator * 1664525u + 1013904223u;
    return (this->Generator >> 31) != 0u;
  }

  /// Of the three triangles that Split has just made, the one that took `edge` of `triangle`.
  Id CornerTriangle(Id triangle, Id edge) const
  {
    const Id corner = edge & 3;
    return corner == 0 ? triangle : this->Mesh.NumberOfTriangles - 3 + corner;
  }

  /// Goes once around the new vertex, corner 0 of all its triangles, and flips what its star may
  /// eat.
  void RestoreStar(Id triangle)
  {
    const auto& corners = this->Mesh.Corners;
    Id edge = HalfEdgeMesh::FirstEdge(triangle);
    const Id end = corners[edge + 1];
    while (true)
    {
      const Id opposite = corners[this->Mesh.Twins[edge]];
      if (BreaksDelaunay(this->Mesh, corners[edge], corners[edge + 1], corners[edge + 2], opposite))
      {
        this->Mesh.FlipAround(edge);
        continue;
      }
      if (corners[edge + 2] == end)
      {
        break;
      }
      edge = this->Mesh.Twins[edge + 1] - 2;
    }
    this->Last = HalfEdgeMesh::TriangleOf(edge);
  }

  /// With phi < 1 edges at the new vertex may break the criterion too: the general flips.
  void RestorePhi(Id triangle)
  {
    const Id begin = HalfEdgeMesh::FirstEdge(triangle);
    Id edge = begin;
    do
    {
      this->Stack.push_back(edge);
      this->Stack.push_back(edge + 1);
      edge = this->Mesh.Twins[edge + 1] - 2;
    } while (edge != begin);
    RestoreDelaunay(this->Mesh, this->Phi, this->Stack, this->Beats);
    this->Last = triangle;
  }

  HalfEdgeMesh& Mesh;
  double Phi;
  Pulse& Beats;
  Id Last = 0; ///< triangle where the next walk starts
  std::uint32_t Generator = 1;
  std::vector<Id> Stack;
};

/// Brings three vertices that are not collinear to the front; false where there are none.
bool ChooseFirstTriangle(std::vector<Point2>& points, std::vector<Id>& order)
{
  std::size_t found = 1;
  for (std::size_t i = 1; i < points.size() && found < 3; ++i)
  {
    const bool isNew =
      found == 1 ? points[i] != points[0] : Orient2D(points[0], points[1], points[i]) != 0;
    if (isNew)
    {
      std::swap(points[i], points[found]);
      std::swap(order[i], order[found]);
      ++found;
    }
  }
  return found == 3;
}

/// Few points come late (ConstrainedMesh.h), but to move all for them takes twice the memory.
std::size_t RoomForLate(std::size_t size)
{
  constexpr std::size_t SizePerLate = 32;
  return size / SizePerLate;
}

void CopyPoints(const std::vector<Point2>& points, InsertionResult& result, Pulse& pulse)
{
  const PulsePart part(pulse, 0.0, CopyingEnd);
  result.Mesh.Points.reserve(points.size() + RoomForLate(points.size()));
  result.Mesh.Points.resize(points.size());
  pulse.ForEach(points.size(),
    [&points, &result](std::size_t i) { result.Mesh.Points[i] = points[result.Order[i]]; });
}

void MakeRoom(HalfEdgeMesh& mesh)
{
  const std::size_t numberOfTriangles = 2 * mesh.Points.size() - 2;
  mesh.Corners.reserve(4 * numberOfTriangles + RoomForLate(4 * numberOfTriangles));
  mesh.Twins.reserve(mesh.Corners.capacity());
  mesh.Corners.resize(4 * numberOfTriangles);
  mesh.Twins.resize(4 * numberOfTriangles, NoId);
}

} // namespace

InsertionResult InsertPoints(
  const std::vector<Point2>& points, std::vector<Id> order, double phi, Pulse& pulse)
{
  InsertionResult result;
  result.Order = std::move(order);
  result.Order.reserve(points.size() + RoomForLate(points.size()));
  result.Vertex.resize(points.size());
  CopyPoints(points, result, pulse);
  if (pulse.HasStopped() || !ChooseFirstTriangle(result.Mesh.Points, result.Order))
  {
    return result;
  }
  MakeRoom(result.Mesh);
  const PulsePart part(pulse, CopyingEnd, 1.0);
  Inserter inserter(result.Mesh, phi, pulse);
  inserter.MakeFirstTriangle();
  const Id numberOfPoints = result.Mesh.NumberOfVertices();
  for (Id i = 0; i < numberOfPoints && pulse.Beat(); ++i)
  {
    pulse.SetFraction(static_cast<double>(i) / numberOfPoints);
    result.Vertex[result.Order[i]] = i < 3 ? i : inserter.Insert(i);
  }
  return result;
}

} // namespace biting
