// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDelaunayFlips_h
#define BitingDelaunayFlips_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "MutableMesh.h"

#include <vector> // for the stack

namespace biting
{

/// Makes edges without marks locally Delaunay again, by flips, exactly. A flip never lowers the
/// smallest angle of its two triangles; each lowers the lifted surface, so it ends.
class DelaunayFlips
{
public:
  explicit DelaunayFlips(MutableMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// After the vertex has moved, or come: looks at its edges and those around it.
  void RestoreAround(Id vertex);

  /// Looks at all edges.
  void RestoreAll(Pulse& pulse);

private:
  bool MustFlip(Id edge) const;
  void FlipAndPush(Id edge);
  void EmptyStack();

  MutableMesh& Mesh;
  std::vector<Id> Stack;
};

} // namespace biting

#endif
