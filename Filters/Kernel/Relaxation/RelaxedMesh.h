// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRelaxedMesh_h
#define BitingRelaxedMesh_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Domain/Domain.h"
#include "../Spacing/Spacing.h"

#include <cstdint> // for freedoms
#include <vector>  // for the arrays

namespace biting
{

/// How many triangles meet at a vertex, ideally.
constexpr float IdealInside = 6.0f;
constexpr float IdealOnBorder = 3.0f;

/// Where a vertex may go.
enum class Freedom : std::uint8_t
{
  Fixed,
  Sliding, ///< along its segment
  Free
};

/// A triangulation, the spacing wanted at its vertices, and the segments that bind these.
///
/// Half-edge e = 4t + k (k = 0..2; 4t + 3 is unused) belongs to triangle t and lies opposite its
/// corner k, Corners[e]. It runs from Corners[Next(e)] to Corners[Previous(e)], its triangle on
/// the left. Twins[e] is the same edge in the triangle on its right, NoId on the border. Removed
/// items stay in the arrays: a removed triangle has no corners, a removed vertex no edge.
struct RelaxedMesh
{
  RelaxedMesh(const Domain& domain, const Spacing& spacing)
    : Geometry(domain)
    , F(spacing)
  {
  }

  static Id Next(Id edge) { return (edge & 3) == 2 ? edge - 2 : edge + 1; }
  static Id Previous(Id edge) { return (edge & 3) == 0 ? edge + 2 : edge - 1; }
  static Id TriangleOf(Id edge) { return edge >> 2; }

  Id Origin(Id edge) const { return this->Corners[Next(edge)]; }
  Id Target(Id edge) const { return this->Corners[Previous(edge)]; }
  Id NumberOfVertices() const { return static_cast<Id>(this->Points.size()); }
  Id NumberOfEdges() const { return static_cast<Id>(this->Corners.size()); }
  bool IsAlive(Id vertex) const { return this->VertexEdges[vertex] != NoId; }
  bool IsEdge(Id edge) const { return (edge & 3) != 3 && this->Corners[edge] != NoId; }

  /// Each inner edge has two half-edges: true for one of them, and for those of the border.
  bool IsFirstHalf(Id edge) const { return this->IsEdge(edge) && this->Twins[edge] < edge; }

  /// The half-edge of the next triangle counterclockwise around the same corner, or NoId.
  Id Turn(Id edge) const
  {
    const Id twin = this->Twins[Next(edge)];
    return twin == NoId ? NoId : Next(twin);
  }

  /// The same clockwise.
  Id TurnBack(Id edge) const
  {
    const Id twin = this->Twins[Previous(edge)];
    return twin == NoId ? NoId : Previous(twin);
  }

  /// The first half-edge of the vertex, counterclockwise from the border. Where triangles surround
  /// the vertex, as they do a free one, it is any of its half-edges.
  Id FirstAround(Id vertex) const
  {
    return this->Freedoms[vertex] == Freedom::Free ? this->VertexEdges[vertex]
                                                   : this->FirstOfFan(vertex);
  }

  /// The same, found by turning back.
  Id FirstOfFan(Id vertex) const
  {
    const Id start = this->VertexEdges[vertex];
    Id first = start;
    for (Id before = this->TurnBack(start); before != start; before = this->TurnBack(first))
    {
      if (before == NoId)
      {
        return first;
      }
      first = before;
    }
    return start;
  }

  /// Whether holds(edge) is true for the half-edges of all triangles of the vertex. They are asked
  /// counterclockwise, up to the first for which it is not.
  template <typename Condition>
  bool HoldsAround(Id vertex, Condition&& holds) const
  {
    const Id first = this->FirstAround(vertex);
    Id edge = first;
    do
    {
      if (!holds(edge))
      {
        return false;
      }
      edge = this->Turn(edge);
    } while (edge != NoId && edge != first);
    return true;
  }

  /// Calls visit(edge) for the half-edges of all triangles of the vertex, counterclockwise.
  template <typename Visit>
  void ForEachAround(Id vertex, Visit&& visit) const
  {
    this->HoldsAround(vertex,
      [&visit](Id edge)
      {
        visit(edge);
        return true;
      });
  }

  /// Number of triangles of a vertex less the number that would fit best.
  double Excess(Id vertex) const
  {
    return this->Degrees[vertex] - static_cast<double>(this->IdealDegrees[vertex]);
  }

  /// Length of the edge in units of the mean spacing of its ends.
  double RelativeLength(Id edge) const
  {
    const Id u = this->Origin(edge);
    const Id v = this->Target(edge);
    return 2.0 * Distance(this->Points[u], this->Points[v]) /
      (this->Spacings[u] + this->Spacings[v]);
  }

  /// The square of that, without a root.
  double SquaredRelativeLength(Id edge) const
  {
    const Id u = this->Origin(edge);
    const Id v = this->Target(edge);
    const Point2 along = this->Points[v] - this->Points[u];
    const double sum = this->Spacings[u] + this->Spacings[v];
    return 4.0 * Dot(along, along) / (sum * sum);
  }

  const Domain& Geometry;
  const Spacing& F;

  // Vertices.
  std::vector<Point2> Points;
  std::vector<double> Spacings;
  std::vector<Freedom> Freedoms;
  std::vector<Id> Segments;             ///< of a sliding vertex
  std::vector<Id> VertexEdges;          ///< a half-edge whose corner is the vertex
  std::vector<Id> Degrees;              ///< number of triangles
  std::vector<float> IdealDegrees;      ///< 6 inside, 3 on segments of the border
  std::vector<std::uint8_t> IsEstimate; ///< 1 where the spacing may be estimated

  // Half-edges.
  std::vector<Id> Corners;
  std::vector<Id> Twins;
  std::vector<Id> Marks; ///< the segment that the edge is a part of, or NoId

  std::vector<Id> Regions;             ///< one a triangle
  std::vector<std::uint8_t> IsDivided; ///< of a segment: whether vertices on it may slide or go
  bool DividesSegments = true;         ///< whether new vertices may come where IsDivided
  double PoorCotangents = 1.0;         ///< factor on the limits: below 1 more angles are poor
};

} // namespace biting

#endif
