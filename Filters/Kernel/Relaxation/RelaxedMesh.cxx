// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RelaxedMesh.h"

namespace biting
{

Id RelaxedMesh::FirstOfFan(Id vertex) const
{
  const Id start = this->VertexEdges[vertex];
  Id first = start;
  Id before = this->TurnBack(start);
  while (before != NoId && before != start)
  {
    first = before;
    before = this->TurnBack(first);
  }
  return before == NoId ? first : start;
}

} // namespace biting
