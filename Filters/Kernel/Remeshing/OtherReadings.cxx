// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OtherReadings.h"

#include "../Quality/TriangleLinks.h"
#include "NearVertices.h"

#include <algorithm> // for minmax, sort, unique
#include <utility>   // for pairs

namespace biting
{

namespace
{

/// Pairs of vertices of free edges, the smaller first, ascending: each once.
std::vector<std::pair<Id, Id>> NearFreeVertices(const OldMesh& mesh, double nearest)
{
  std::vector<std::pair<Id, Id>> pairs =
    FindNearVertices(mesh.Points, mesh.VerticesOfFreeEdges(), nearest);
  for (std::pair<Id, Id>& pair : pairs)
  {
    pair = std::minmax({ pair.first, pair.second });
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

/// Whether the same vertices are made one for both distances.
bool AreMadeOneAlike(const RemeshInput& input, double nearest, double other)
{
  OldMesh mesh;
  mesh.Points = input.Points;
  mesh.Corners = input.Corners;
  mesh.Neighbors = LinkTriangles(mesh.Corners, mesh.NumberOfVertices()).Neighbors;
  return nearest == other || NearFreeVertices(mesh, nearest) == NearFreeVertices(mesh, other);
}

} // namespace

std::vector<Reading> OtherReadings(const RemeshInput& input, double nearest, bool hasHanging)
{
  const bool areAlike = AreMadeOneAlike(input, nearest, input.Rounding);
  std::vector<Reading> readings;
  for (const HangingRule rule : { HangingRule::Divide, HangingRule::Leave })
  {
    if (rule == HangingRule::Leave && hasHanging)
    {
      readings.push_back({ nearest, rule });
    }
    if (!areAlike && (rule == HangingRule::Divide || hasHanging))
    {
      readings.push_back({ input.Rounding, rule });
    }
  }
  return readings;
}

} // namespace biting
