// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingStripMeshes_h
#define BitingStripMeshes_h

#include "../Relaxation/RawMesh.h"

#include "Blocks/JoinedBlocks.h"

#include <numeric> // for iota
#include <set>     // for vertices
#include <vector>  // for lists

namespace biting
{

/// A mesh as it is after blocks were joined.
inline JoinedMesh AsJoined(const RelaxationMesh& mesh)
{
  JoinedMesh joined;
  joined.Bites.Points = mesh.Points;
  joined.Bites.Spacings = mesh.Spacings;
  joined.Bites.Segments = mesh.Segments;
  joined.Bites.BiteOrders.resize(mesh.Points.size());
  std::iota(joined.Bites.BiteOrders.begin(), joined.Bites.BiteOrders.end(), 0);
  joined.Bites.EdgeStarts = mesh.EdgeStarts;
  joined.Bites.EdgeEnds = mesh.EdgeEnds;
  joined.Bites.EdgeSegments = mesh.EdgeSegments;
  joined.Triangles = mesh.Triangles;
  return joined;
}

inline RelaxationMesh FromJoined(const JoinedMesh& joined)
{
  return { joined.Bites.Points, joined.Bites.Spacings, joined.Bites.Segments,
    joined.Bites.EdgeStarts, joined.Bites.EdgeEnds, joined.Bites.EdgeSegments, joined.Triangles };
}

inline std::set<Id> VerticesOf(const Triangulation& mesh, const std::vector<Id>& triangles)
{
  std::set<Id> vertices;
  for (const Id triangle : triangles)
  {
    const Id* corners = mesh.Corners.data() + 3 * static_cast<std::size_t>(triangle);
    vertices.insert(corners, corners + 3);
  }
  return vertices;
}

} // namespace biting

#endif
