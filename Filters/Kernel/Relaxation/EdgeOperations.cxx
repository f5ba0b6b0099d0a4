// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "EdgeOperations.h"

#include "../Base/Numbers.h"
#include "../Base/SortInSteps.h"
#include "../Predicates/Predicates.h"
#include "Smoothing.h"
#include "Star.h"

#include <algorithm> // for max
#include <utility>   // for swap
#include <vector>    // for lists

namespace biting
{

namespace
{

bool IsSplittable(const MutableMesh& mesh, Id edge, const Point2& place)
{
  const Point2& apex = mesh.Points[mesh.Corners[edge]];
  return Orient2D(apex, mesh.Points[mesh.Origin(edge)], place) > 0 &&
    Orient2D(apex, place, mesh.Points[mesh.Target(edge)]) > 0;
}

// The half of the triangle (p, u, v) at u stays, that at v is new: (p, vertex, v).
void SplitSide(MutableMesh& mesh, Id edge, Id vertex, Id added)
{
  const Id apex = mesh.Corners[edge];
  const Id target = mesh.Target(edge);
  const Id outer = MutableMesh::Next(edge);
  mesh.Store(mesh.Corners, added, apex);
  mesh.Store(mesh.Corners, added + 1, vertex);
  mesh.Store(mesh.Corners, added + 2, target);
  mesh.Store(mesh.Corners, MutableMesh::Previous(edge), vertex);
  mesh.Store(mesh.Twins, added, NoId);
  mesh.Store(mesh.Twins, added + 1, NoId);
  mesh.Link(added + 1, mesh.Twins[outer]);
  mesh.Link(added + 2, outer);
  mesh.Store(mesh.Marks, added, mesh.Marks[edge]);
  mesh.Store(mesh.Marks, added + 1, mesh.Marks[outer]);
  mesh.Store(mesh.Marks, outer, NoId);
  mesh.Store(mesh.VertexEdges, vertex, added + 1);
  mesh.Store(mesh.VertexEdges, target, added + 2);
  mesh.AddDegree(vertex, 2);
  mesh.AddDegree(apex, 1);
}

// A free vertex may become any other; a sliding one only a neighbor on its segment.
bool MayMerge(const MutableMesh& mesh, Id edge)
{
  const Id u = mesh.Origin(edge);
  const Id v = mesh.Target(edge);
  if (mesh.Freedoms[u] == Freedom::Free || mesh.Freedoms[v] == Freedom::Free)
  {
    return true;
  }
  const Id segment = mesh.Marks[edge];
  return segment != NoId && mesh.IsDivided[segment] &&
    (mesh.Freedoms[u] == Freedom::Sliding || mesh.Freedoms[v] == Freedom::Sliding);
}

// The triangle becomes one edge: that must not join two constraints, nor cut the mesh.
bool MayVanish(const MutableMesh& mesh, Id edge)
{
  const Id next = MutableMesh::Next(edge);
  const Id previous = MutableMesh::Previous(edge);
  return (mesh.Marks[next] == NoId || mesh.Marks[previous] == NoId) &&
    (mesh.Twins[next] != NoId || mesh.Twins[previous] != NoId);
}

// With the vertex at `place`, the triangles of `spared` left out, which may be none.
bool IsValidAt(const MutableMesh& mesh, Id vertex, const Point2& place, Id spared)
{
  return mesh.HoldsAround(vertex,
    [&mesh, &place, spared](Id edge)
    {
      const Id a = mesh.Origin(edge);
      const Id b = mesh.Target(edge);
      return a == spared || b == spared || Orient2D(place, mesh.Points[a], mesh.Points[b]) > 0;
    });
}

bool MoveToMiddle(MutableMesh& mesh, Id edge, Id kept)
{
  const Point2 place =
    mesh.PlaceFor(kept, Midpoint(mesh.Points[mesh.Origin(edge)], mesh.Points[mesh.Target(edge)]));
  if (!IsValidAt(mesh, kept, place, NoId))
  {
    return false;
  }
  mesh.Move(kept, place);
  return true;
}

void RemoveSide(MutableMesh& mesh, Id edge)
{
  const Id next = MutableMesh::Next(edge);
  const Id previous = MutableMesh::Previous(edge);
  const Id apex = mesh.Corners[edge];
  const Id beyondNext = mesh.Twins[next];
  const Id beyondPrevious = mesh.Twins[previous];
  const Id mark = mesh.Marks[next] == NoId ? mesh.Marks[previous] : mesh.Marks[next];
  for (const Id outer : { beyondNext, beyondPrevious })
  {
    if (outer != NoId)
    {
      mesh.Store(mesh.Twins, outer, outer == beyondNext ? beyondPrevious : beyondNext);
      mesh.Store(mesh.Marks, outer, mark);
      mesh.Store(mesh.VertexEdges, mesh.Origin(outer), MutableMesh::Next(outer));
      mesh.Store(mesh.VertexEdges, mesh.Target(outer), MutableMesh::Previous(outer));
    }
  }
  mesh.AddDegree(apex, -1);
  for (const Id gone : { edge, next, previous })
  {
    mesh.Store(mesh.Corners, gone, NoId);
  }
}

void RemoveVertex(MutableMesh& mesh, Id edge, Id vertex, Id kept)
{
  const Id twin = mesh.Twins[edge];
  const Id numberOfSides = twin == NoId ? 1 : 2;
  mesh.AddDegree(kept, mesh.Degrees[vertex] - 2 * numberOfSides);
  mesh.ForEachAround(vertex, [&mesh, kept](Id around) { mesh.Store(mesh.Corners, around, kept); });
  mesh.Store(mesh.VertexEdges, vertex, NoId);
  RemoveSide(mesh, edge);
  if (twin != NoId)
  {
    RemoveSide(mesh, twin);
  }
}

constexpr double ShortestOfNew = 0.75; // in spacings: shorter ones crowd their ends
constexpr int PassesAroundNew = 2;

bool IsTooLong(const MutableMesh& mesh, Id edge, double longest)
{
  return mesh.Marks[edge] == NoId && mesh.Twins[edge] != NoId &&
    mesh.SquaredRelativeLength(edge) > longest * longest;
}

// The longest first.
std::vector<std::pair<double, Id>> FindLong(const MutableMesh& mesh, double longest, Pulse& pulse)
{
  std::vector<std::pair<double, Id>> found;
  pulse.ForEach(static_cast<std::size_t>(mesh.NumberOfEdges()),
    [&mesh, longest, &found](std::size_t k)
    {
      const Id edge = static_cast<Id>(k);
      if (mesh.IsFirstHalf(edge) && IsTooLong(mesh, edge, longest))
      {
        found.emplace_back(-mesh.SquaredRelativeLength(edge), edge);
      }
    });
  SortInSteps(
    found, [](const std::pair<double, Id>& a, const std::pair<double, Id>& b) { return a < b; },
    pulse);
  return found;
}

double WorstAroundAll(const MutableMesh& mesh, const std::vector<Id>& vertices)
{
  double worst = 0.0;
  for (const Id vertex : vertices)
  {
    worst = std::max(worst, WorstAround(mesh, vertex));
  }
  return worst;
}

bool HasShortEdge(const MutableMesh& mesh, Id vertex)
{
  bool isShort = false;
  mesh.ForEachAround(vertex,
    [&mesh, &isShort](Id edge)
    {
      for (const Id side : { MutableMesh::Next(edge), MutableMesh::Previous(edge) })
      {
        isShort |= mesh.SquaredRelativeLength(side) < ShortestOfNew * ShortestOfNew;
      }
    });
  return isShort;
}

// Whether it is good.
bool TrySplit(DelaunayMesh& mesh, Id edge, double limit)
{
  const Id vertex = SplitEdge(mesh, edge);
  if (vertex == NoId)
  {
    return false;
  }
  mesh.RestoreAround(vertex);
  for (int pass = 0; pass < PassesAroundNew; ++pass)
  {
    for (const Id near : mesh.Around(vertex, 1))
    {
      SmoothVertex(mesh, near);
    }
  }
  return WorstAroundAll(mesh, mesh.Around(vertex, 1)) <= limit && !HasShortEdge(mesh, vertex);
}

} // namespace

Id SplitEdge(MutableMesh& mesh, Id edge)
{
  const Id twin = mesh.Twins[edge];
  const Id segment = mesh.Marks[edge];
  const Point2& origin = mesh.Points[mesh.Origin(edge)];
  const Point2& target = mesh.Points[mesh.Target(edge)];
  const Point2 middle = Midpoint(origin, target);
  const Point2 place = segment == NoId ? middle : mesh.PlaceOnSegment(segment, middle);
  if (!mesh.MayDivide(edge) || !IsSplittable(mesh, edge, place) ||
    (twin != NoId && !IsSplittable(mesh, twin, place)))
  {
    return NoId;
  }
  const Id vertex = mesh.AddVertex(place, segment, twin == NoId);
  const Id added = mesh.AddTriangle(mesh.Regions[MutableMesh::TriangleOf(edge)]);
  const Id addedTwin =
    twin == NoId ? NoId : mesh.AddTriangle(mesh.Regions[MutableMesh::TriangleOf(twin)]);
  SplitSide(mesh, edge, vertex, added);
  if (twin != NoId)
  {
    SplitSide(mesh, twin, vertex, addedTwin);
    mesh.Link(added, twin);
  }
  mesh.Link(edge, addedTwin);
  return vertex;
}

Id CollapseEdge(MutableMesh& mesh, Id edge)
{
  if (!MayMerge(mesh, edge) || !MayVanish(mesh, edge) ||
    (mesh.Twins[edge] != NoId && !MayVanish(mesh, mesh.Twins[edge])))
  {
    return NoId;
  }
  Id kept = mesh.Origin(edge);
  Id vertex = mesh.Target(edge);
  const bool isMoved = mesh.Freedoms[kept] == mesh.Freedoms[vertex];
  if (mesh.Freedoms[vertex] < mesh.Freedoms[kept])
  {
    std::swap(kept, vertex);
  }
  const Point2 oldPlace = mesh.Points[kept];
  if (isMoved && !MoveToMiddle(mesh, edge, kept))
  {
    return NoId;
  }
  if (!IsValidAt(mesh, vertex, mesh.Points[kept], kept))
  {
    mesh.Move(kept, oldPlace);
    return NoId;
  }
  if (isMoved)
  {
    mesh.RefreshSpacing(kept);
  }
  RemoveVertex(mesh, edge, vertex, kept);
  return kept;
}

void SplitLongEdges(DelaunayMesh& mesh, double longest, double greatestCotangent, Pulse& pulse)
{
  const std::vector<std::pair<double, Id>> edges = FindLong(mesh, longest, pulse);
  pulse.ForEach(edges.size(),
    [&mesh, &edges, longest, greatestCotangent](std::size_t k)
    {
      const Id edge = edges[k].second;
      if (mesh.IsEdge(edge) && IsTooLong(mesh, edge, longest))
      {
        const double worst = WorstAroundAll(mesh,
          { mesh.Origin(edge), mesh.Target(edge), mesh.Corners[edge],
            mesh.Corners[mesh.Twins[edge]] });
        if (worst < Infinity)
        {
          mesh.BeginTrial();
          mesh.EndTrial(TrySplit(mesh, edge, std::max(worst, greatestCotangent)));
        }
      }
    });
}

} // namespace biting
