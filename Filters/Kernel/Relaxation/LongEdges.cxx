// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "LongEdges.h"

#include "../Base/Numbers.h"
#include "../Base/SortInSteps.h"
#include "EdgeOperations.h"
#include "Smoothing.h"
#include "Star.h"

#include <algorithm> // for max
#include <utility>   // for pairs
#include <vector>    // for lists

namespace biting
{

namespace
{

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
