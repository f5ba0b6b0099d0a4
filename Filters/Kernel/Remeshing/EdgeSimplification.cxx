// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "EdgeSimplification.h"

#include "../Base/DistanceToSegment.h"
#include "../Domain/Domain.h"
#include "../Simplification/Simplification.h"
#include "Stitching.h"

#include <algorithm> // for max
#include <cstdint>   // for flags

namespace biting
{

namespace
{

using Flags = std::vector<std::uint8_t>;

// In units of f: the triangle between an edge and a vertex that is nearer is poor. Half of the
// height of a good one.
constexpr double RoomBesideEdges = 0.43;

// Beyond the rim lies the rest of the mesh. Its free edges may be as near to those of the region.
void AddRest(const OldMesh& mesh, const ChangedRegion& region, Domain& drawing)
{
  std::vector<Id> numbers(mesh.Points.size(), NoId);
  for (Id vertex = 0; vertex < drawing.NumberOfVertices(); ++vertex)
  {
    numbers[drawing.VertexPoints[vertex]] = vertex;
  }
  const auto number = [&mesh, &numbers, &drawing](Id vertex)
  {
    if (numbers[vertex] == NoId)
    {
      numbers[vertex] = drawing.NumberOfVertices();
      drawing.Vertices.push_back(mesh.Points[vertex]);
      drawing.VertexPoints.push_back(vertex);
      drawing.IsEmbedded.push_back(0);
      drawing.HasPoint.push_back(1);
      drawing.Bounds.Add(mesh.Points[vertex]);
    }
    return numbers[vertex];
  };
  for (Id slot = 0; slot < static_cast<Id>(mesh.Corners.size()); ++slot)
  {
    if (mesh.Neighbors[slot] == NoId && !region.IsChanged[slot / 3])
    {
      drawing.Starts.push_back(number(mesh.Start(slot)));
      drawing.Ends.push_back(number(mesh.End(slot)));
      drawing.Cells.push_back(mesh.Marks[slot]);
      drawing.IsBoundary.push_back(1);
      drawing.LeftInside.push_back(1);
      drawing.RightInside.push_back(0);
    }
  }
}

// All edges of the region as they are, and the free ones of the rest of the mesh, with what may not
// go as points: all that is on the rim or beyond, what is fixed, and what `stays` marks.
Domain DrawingOf(const OldMesh& mesh, const ChangedRegion& region, const Flags& stays)
{
  const RegionEdges edges = StraightPieces(mesh, region, EdgePolicy::SplitOnly);
  Flags isKept = edges.IsKept;
  for (Id vertex = 0; vertex < region.NumberOfVertices(); ++vertex)
  {
    isKept[vertex] |= mesh.IsFixed[region.Vertices[vertex]];
  }
  Domain drawing = MakeCavityDomain(mesh, region, edges, isKept, {}, EdgePolicy::Free);
  for (const Id vertex : drawing.VertexPoints)
  {
    const Id number = region.Numbers[vertex];
    drawing.HasPoint.push_back(stays[number] != 0 || region.IsInside[number] == 0);
  }
  for (std::size_t edge = 0; edge < edges.Edges.size(); ++edge)
  {
    if (mesh.IsFrozenEdge(edges.Edges[edge].Mark))
    {
      drawing.HasPoint[drawing.Starts[edge]] = 1;
      drawing.HasPoint[drawing.Ends[edge]] = 1;
    }
    if (edges.Edges[edge].RimSlot != NoId)
    {
      drawing.IsBoundary[edge] = 0;
      drawing.RightInside[edge] = 1;
    }
  }
  AddRest(mesh, region, drawing);
  return drawing;
}

// Which vertices of the region are left where its edges are simplified.
Flags FindLeft(const OldMesh& mesh, const ChangedRegion& region, const Flags& stays,
  const EdgeTolerance& tolerance, Monitor& monitor)
{
  const Domain drawing = DrawingOf(mesh, region, stays);
  SimplificationOptions options;
  options.Tolerance = tolerance.Tolerance;
  options.CornerAngle = tolerance.FeatureAngle;
  options.AreAlike = [&mesh](Id mark, Id other) { return mesh.HaveEqualTags(mark, other); };
  std::vector<double> spacings;
  for (const Id vertex : drawing.VertexPoints)
  {
    spacings.push_back(tolerance.Spacings[vertex]);
  }
  const SimplifiedDomain simplified = SimplifyChains(drawing, options, spacings, monitor);
  const bool hasStopped = simplified.Drawing.Vertices.empty();
  Flags left(region.Vertices.size(), hasStopped ? 1 : 0);
  for (const Id vertex : simplified.Drawing.VertexPoints)
  {
    const Id number = region.Numbers[vertex];
    if (number != NoId)
    {
      left[number] = 1;
    }
  }
  return left;
}

/// Finds what edges moved over.
///
/// What lies between an edge and the path that it stands for is as near to the edge as the farthest
/// vertex of the path, as places that near to a segment are a convex set. From each vertex in
/// between others lead on, away from the edge, to one of the path, as in a triangulation each inner
/// vertex has neighbours on either side of each line through it: so a walk from these finds all.
class MovedEdges
{
public:
  MovedEdges(const OldMesh& mesh, const ChangedRegion& region, const std::vector<double>& spacings,
    RegionEdges& edges)
    : Mesh(mesh)
    , Region(region)
    , Spacings(spacings)
    , Edges(edges)
    , Stamps(region.Vertices.size(), NoId)
  {
  }

  void Clear()
  {
    for (Id edge = 0; edge < static_cast<Id>(this->Edges.Edges.size()); ++edge)
    {
      const double moved = this->Moved(edge);
      if (moved > this->Mesh.Rounding)
      {
        const RegionEdge& at = this->Edges.Edges[edge];
        const double room =
          RoomBesideEdges * 0.5 * (this->Spacings[at.Start] + this->Spacings[at.End]);
        this->ClearBeside(edge, std::max(moved, room));
      }
    }
  }

private:
  const Point2& Place(Id vertex) const { return this->Mesh.Points[this->Region.Vertices[vertex]]; }

  double DistanceTo(Id edge, Id vertex) const
  {
    const RegionEdge& at = this->Edges.Edges[edge];
    return DistanceToSegment(this->Place(vertex), this->Place(at.Start), this->Place(at.End));
  }

  double Moved(Id edge) const
  {
    double largest = 0.0;
    for (Id k = this->Edges.GoneOffsets[edge]; k < this->Edges.GoneOffsets[edge + 1]; ++k)
    {
      largest = std::max(largest, this->DistanceTo(edge, this->Edges.Gone[k]));
    }
    return largest;
  }

  void ClearBeside(Id edge, double distance)
  {
    this->Queue.assign(this->Edges.Gone.begin() + this->Edges.GoneOffsets[edge],
      this->Edges.Gone.begin() + this->Edges.GoneOffsets[edge + 1]);
    for (std::size_t next = 0; next < this->Queue.size(); ++next)
    {
      const Id vertex = this->Queue[next];
      for (const Id near : this->Region.Neighbors[vertex])
      {
        if (this->Stamps[near] != edge && this->DistanceTo(edge, near) <= distance)
        {
          this->Stamps[near] = edge;
          this->Queue.push_back(near);
          this->Edges.IsGone[near] |= this->Region.IsInside[near] && !this->Edges.IsKept[near];
        }
      }
    }
  }

  const OldMesh& Mesh;
  const ChangedRegion& Region;
  const std::vector<double>& Spacings;
  RegionEdges& Edges;
  std::vector<Id> Stamps; ///< the last edge that the vertex was found for
  std::vector<Id> Queue;
};

} // namespace

RegionEdges SimplifiedPieces(const OldMesh& mesh, const ChangedRegion& region,
  const EdgeTolerance& tolerance, Monitor& monitor)
{
  const Flags none(region.Vertices.size(), 0);
  return PiecesBetween(mesh, region, FindLeft(mesh, region, none, tolerance, monitor));
}

// First the vertices that the shape needs; between them those that divide their run well, as of
// straight edges; then all others go that may.
RegionEdges SimplifiedEdges(const OldMesh& mesh, const ChangedRegion& region,
  const std::vector<double>& spacings, const KeepRules& rules, const EdgeTolerance& tolerance,
  Monitor& monitor)
{
  const Flags none(region.Vertices.size(), 0);
  const Flags shape = FindLeft(mesh, region, none, tolerance, monitor);
  const RegionEdges wanted = ThinnedEdges(mesh, region, spacings, rules, EdgePolicy::Free, &shape);
  const Flags left = FindLeft(mesh, region, wanted.IsKept, tolerance, monitor);
  RegionEdges edges = PiecesBetween(mesh, region, left);
  MovedEdges(mesh, region, spacings, edges).Clear();
  return edges;
}

} // namespace biting
