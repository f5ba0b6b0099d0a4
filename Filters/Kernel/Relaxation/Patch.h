// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPatch_h
#define BitingPatch_h

#include "../Base/Ids.h"
#include "MutableMesh.h"

#include <vector> // for the lists

namespace biting
{

/// Finds the vertices near a vertex. Made once, asked often: its arrays are reused. Does not look
/// beyond vertices whose stars are too large to be read.
class Patch
{
public:
  explicit Patch(const MutableMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// The vertices at most `rings` edges from `center`, nearest first; valid until the next call.
  const std::vector<Id>& Around(Id center, int rings)
  {
    this->Begin();
    this->Add(center);
    return this->Grow(rings);
  }

  /// The same around several vertices.
  const std::vector<Id>& Around(const std::vector<Id>& centers, int rings)
  {
    this->Begin();
    for (const Id center : centers)
    {
      this->Add(center);
    }
    return this->Grow(rings);
  }

private:
  void Begin();
  void Add(Id vertex);
  void AddNeighbors(Id vertex);
  const std::vector<Id>& Grow(int rings);

  const MutableMesh& Mesh;
  std::vector<Id> Vertices;
  std::vector<Id> Stamps; ///< of each vertex: the last call that found it
  Id Stamp = 0;
};

} // namespace biting

#endif
