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

namespace biting
{

namespace
{

constexpr double ShortestOfNew = 0.75; // in spacings: shorter ones crowd their ends
constexpr int PassesAroundNew = 2;

} // namespace

void LongEdges::Split(double longest, double greatestCotangent, Pulse& pulse)
{
  const std::vector<Id> edges = this->Find(longest, pulse);
  pulse.ForEach(edges.size(),
    [this, &edges, longest, greatestCotangent](std::size_t k)
    {
      const Id edge = edges[k];
      if (this->Mesh.IsEdge(edge) && this->IsLong(edge, longest))
      {
        const Id twin = this->Mesh.Twins[edge];
        const double worst = this->WorstOf({ this->Mesh.Origin(edge), this->Mesh.Target(edge),
          this->Mesh.Corners[edge], this->Mesh.Corners[twin] });
        if (worst < Infinity)
        {
          this->Mesh.BeginTrial();
          this->Mesh.EndTrial(this->TrySplit(edge, std::max(worst, greatestCotangent)));
        }
      }
    });
}

std::vector<Id> LongEdges::Find(double longest, Pulse& pulse) const
{
  std::vector<std::pair<double, Id>> found;
  pulse.ForEach(static_cast<std::size_t>(this->Mesh.NumberOfEdges()),
    [this, longest, &found](std::size_t k)
    {
      const Id edge = static_cast<Id>(k);
      if (this->Mesh.IsFirstHalf(edge) && this->IsLong(edge, longest))
      {
        found.emplace_back(-this->Mesh.SquaredRelativeLength(edge), edge);
      }
    });
  SortInSteps(
    found, [](const std::pair<double, Id>& a, const std::pair<double, Id>& b) { return a < b; },
    pulse);
  std::vector<Id> edges;
  edges.reserve(found.size());
  for (const auto& [length, edge] : found)
  {
    edges.push_back(edge);
  }
  return edges;
}

bool LongEdges::IsLong(Id edge, double longest) const
{
  return this->Mesh.Marks[edge] == NoId && this->Mesh.Twins[edge] != NoId &&
    this->Mesh.SquaredRelativeLength(edge) > longest * longest;
}

// Whether it is good.
bool LongEdges::TrySplit(Id edge, double limit)
{
  const Id vertex = SplitEdge(this->Mesh, edge);
  if (vertex == NoId)
  {
    return false;
  }
  this->Flips.RestoreAround(vertex);
  this->SmoothAround(vertex);
  return this->WorstOf(this->Surroundings.Around(vertex, 1)) <= limit &&
    !this->HasShortEdge(vertex);
}

void LongEdges::SmoothAround(Id vertex)
{
  for (int pass = 0; pass < PassesAroundNew; ++pass)
  {
    for (const Id near : this->Surroundings.Around(vertex, 1))
    {
      if (SmoothVertex(this->Mesh, near, CotangentOf30Degrees))
      {
        this->Flips.RestoreAround(near);
      }
    }
  }
}

// Infinity where a star is too large to be read: nothing near it could be judged.
double LongEdges::WorstOf(const std::vector<Id>& vertices) const
{
  double worst = 0.0;
  Star star;
  for (const Id vertex : vertices)
  {
    worst = std::max(worst, star.Read(this->Mesh, vertex) ? star.Worst({}) : Infinity);
  }
  return worst;
}

bool LongEdges::HasShortEdge(Id vertex) const
{
  bool isShort = false;
  this->Mesh.ForEachAround(vertex,
    [this, &isShort](Id edge)
    {
      for (const Id side : { MutableMesh::Next(edge), MutableMesh::Previous(edge) })
      {
        isShort |= this->Mesh.SquaredRelativeLength(side) < ShortestOfNew * ShortestOfNew;
      }
    });
  return isShort;
}

} // namespace biting
