// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SourceEdges.h"

#include <algorithm> // for find_if
#include <numeric>   // for partial_sum

namespace biting
{

SourceEdges::SourceEdges(
  const TriangulatedSource& source, const std::vector<bool>& isSteep, Pulse& pulse)
{
  const std::size_t count = source.Points.size();
  std::vector<Id> starts(count + 1, 0);
  for (Id point : source.Triangles)
  {
    ++starts[static_cast<std::size_t>(point) + 1];
  }
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<Id> next = starts;
  std::vector<Id> around(source.Triangles.size());
  pulse.ForEach(around.size(),
    [&source, &next, &around](std::size_t corner)
    {
      const auto point = static_cast<std::size_t>(source.Triangles[corner]);
      around[static_cast<std::size_t>(next[point]++)] = static_cast<Id>(corner / 3);
    });
  this->Edges.reserve(around.size() + count / 8);
  pulse.ForEach(count,
    [this, &source, &isSteep, &starts, &around](std::size_t point)
    {
      this->Firsts.push_back(static_cast<Id>(this->Edges.size()));
      for (Id k = starts[point]; k < starts[point + 1]; ++k)
      {
        const auto triangle = static_cast<std::size_t>(around[static_cast<std::size_t>(k)]);
        this->AddFrom(source, static_cast<Id>(point), triangle, isSteep[triangle]);
      }
    });
  this->Firsts.push_back(static_cast<Id>(this->Edges.size()));
}

/// Those of a triangle that begin at the point.
void SourceEdges::AddFrom(
  const TriangulatedSource& source, Id point, std::size_t triangle, bool isSteep)
{
  for (std::size_t corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
  {
    const Id to = source.Triangles[corner];
    const auto known = std::find_if(this->Edges.begin() + this->Firsts.back(), this->Edges.end(),
      [to](const Edge& edge) { return edge.To == to; });
    if (known != this->Edges.end())
    {
      known->IsSteep = known->IsSteep || isSteep;
    }
    else if (to != point)
    {
      const auto from = static_cast<std::size_t>(point);
      const auto end = static_cast<std::size_t>(to);
      this->Edges.push_back(
        { source.Points[end] - source.Points[from], source.Values[end], to, isSteep });
    }
  }
}

} // namespace biting
