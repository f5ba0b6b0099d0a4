// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDelaunayMesh_h
#define BitingDelaunayMesh_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "MutableMesh.h"

#include <cstdint> // for marks
#include <vector>  // for the lists

namespace biting
{

/// A mutable mesh with flips that make it Delaunay again, and a search for the vertices near a
/// vertex.
///
/// Edges without marks are made locally Delaunay, exactly. A flip never lowers the smallest angle
/// of its two triangles; each lowers the lifted surface, so it ends.
class DelaunayMesh : public MutableMesh
{
public:
  using MutableMesh::MutableMesh;

  /// After the vertex has moved, or come: looks at its edges and those around it.
  void RestoreAround(Id vertex);

  /// Looks at all edges.
  void RestoreAll(Pulse& pulse);

  /// As RestoreAll, with the same flips, for a mesh that was Delaunay before corners of the marked
  /// triangles moved: looks at the edges of marked triangles only.
  void RestoreBeside(const std::vector<std::uint8_t>& areChanged, Pulse& pulse);

  /// The vertices at most `rings` edges from `center`, nearest first, but none beyond vertices
  /// whose stars are too large to be read (Star.h); valid until the next call.
  const std::vector<Id>& Around(Id center, int rings);

  /// The same around several vertices.
  const std::vector<Id>& Around(const std::vector<Id>& centers, int rings);

private:
  bool MustFlip(Id edge) const;
  void FlipAndPush(Id edge);
  void RestoreEdge(Id edge);
  void EmptyStack();
  void AddNear(Id vertex);
  void AddNeighbors(Id vertex);

  std::vector<Id> Stack;   ///< edges to look at
  std::vector<Id> Centers; ///< one, of a search
  std::vector<Id> Near;
  std::vector<Id> Stamps; ///< of each vertex: the last search that found it
  Id Stamp = 0;
};

} // namespace biting

#endif
