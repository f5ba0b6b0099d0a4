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

double RelaxedMesh::RelativeLength(Id edge) const
{
  const Id u = this->Origin(edge);
  const Id v = this->Target(edge);
  return 2.0 * Distance(this->Points[u], this->Points[v]) / (this->Spacings[u] + this->Spacings[v]);
}

} // namespace biting
