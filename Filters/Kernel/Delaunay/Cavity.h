// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCavity_h
#define BitingCavity_h

#include "../Base/Ids.h"
#include "HalfEdgeMesh.h"

#include <vector> // for the chains

namespace biting
{

/// One side of a cavity: the vertices along it, and the half-edges between them. Edges[i] joins
/// Vertices[i] and Vertices[i + 1] and belongs to a triangle of the cavity. Where the border enters
/// the cavity and returns, an edge occurs twice, once a direction.
struct CavityChain
{
  std::vector<Id> Vertices;
  std::vector<Id> Edges;

  void Add(Id vertex, Id edge)
  {
    this->Vertices.push_back(vertex);
    this->Edges.push_back(edge);
  }
};

/// The triangles that a segment crosses, from end to end.
struct Cavity
{
  std::vector<Id> Triangles;
  CavityChain Left;  ///< from the segment's start to its end
  CavityChain Right; ///< from the segment's end to its start

  void Clear()
  {
    this->Triangles.clear();
    this->Left.Vertices.clear();
    this->Left.Edges.clear();
    this->Right.Vertices.clear();
    this->Right.Edges.clear();
  }
};

/// Fills the cavity anew so that the segment is an edge, and returns its half-edge from start to
/// end. Reuses the triangles of the cavity; marks, VertexEdges and links to the outside follow.
/// Half-edges that may not be Delaunay are added to `stack`.
Id FillCavity(HalfEdgeMesh& mesh, const Cavity& cavity, std::vector<Id>& stack);

} // namespace biting

#endif
