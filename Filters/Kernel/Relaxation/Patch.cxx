// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Patch.h"

#include "Star.h"

namespace biting
{

void Patch::Begin()
{
  this->Stamps.resize(this->Mesh.Points.size(), 0);
  this->Vertices.clear();
  ++this->Stamp;
}

void Patch::Add(Id vertex)
{
  if (this->Stamps[vertex] != this->Stamp)
  {
    this->Stamps[vertex] = this->Stamp;
    this->Vertices.push_back(vertex);
  }
}

const std::vector<Id>& Patch::Grow(int rings)
{
  std::size_t first = 0;
  for (int ring = 0; ring < rings; ++ring)
  {
    const std::size_t last = this->Vertices.size();
    for (; first < last; ++first)
    {
      this->AddNeighbors(this->Vertices[first]);
    }
  }
  return this->Vertices;
}

void Patch::AddNeighbors(Id vertex)
{
  if (this->Mesh.Degrees[vertex] > Star::Capacity)
  {
    return;
  }
  const Id first = this->Mesh.FirstAround(vertex);
  Id edge = first;
  do
  {
    this->Add(this->Mesh.Origin(edge));
    this->Add(this->Mesh.Target(edge));
    edge = this->Mesh.Turn(edge);
  } while (edge != NoId && edge != first);
}

} // namespace biting
