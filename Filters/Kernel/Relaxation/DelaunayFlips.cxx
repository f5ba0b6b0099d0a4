// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "DelaunayFlips.h"

#include "../Predicates/Predicates.h"

namespace biting
{

void DelaunayFlips::RestoreAround(Id vertex)
{
  const Id first = this->Mesh.FirstAround(vertex);
  Id edge = first;
  do
  {
    this->Stack.insert(this->Stack.end(), { edge, MutableMesh::Next(edge) });
    edge = this->Mesh.Turn(edge);
  } while (edge != NoId && edge != first);
  this->EmptyStack();
}

void DelaunayFlips::RestoreAll(Pulse& pulse)
{
  for (Id edge = 0; edge < this->Mesh.NumberOfEdges() && pulse.Beat(); edge += 4)
  {
    for (Id side = edge; side < edge + 3; ++side)
    {
      if (this->Mesh.IsFirstHalf(side) && this->MustFlip(side))
      {
        this->FlipAndPush(side);
        this->EmptyStack();
      }
    }
  }
}

void DelaunayFlips::EmptyStack()
{
  while (!this->Stack.empty())
  {
    const Id edge = this->Stack.back();
    this->Stack.pop_back();
    if (this->MustFlip(edge))
    {
      this->FlipAndPush(edge);
    }
  }
}

bool DelaunayFlips::MustFlip(Id edge) const
{
  const MutableMesh& mesh = this->Mesh;
  const Id twin = mesh.Twins[edge];
  if (twin == NoId || mesh.Marks[edge] != NoId)
  {
    return false;
  }
  const auto& points = mesh.Points;
  return InCircle(points[mesh.Corners[edge]], points[mesh.Origin(edge)], points[mesh.Target(edge)],
           points[mesh.Corners[twin]]) > 0;
}

void DelaunayFlips::FlipAndPush(Id edge)
{
  const Id twin = this->Mesh.Twins[edge];
  this->Mesh.Flip(edge);
  this->Stack.insert(
    this->Stack.end(), { edge, MutableMesh::Previous(edge), twin, MutableMesh::Previous(twin) });
}

} // namespace biting
