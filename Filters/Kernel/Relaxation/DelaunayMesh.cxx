// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "DelaunayMesh.h"

#include "../Predicates/Predicates.h"
#include "Star.h"

namespace biting
{

void DelaunayMesh::RestoreAround(Id vertex)
{
  this->ForEachAround(vertex,
    [this](Id edge) {
      this->Stack.insert(this->Stack.end(), { edge, Next(edge) });
    });
  this->EmptyStack();
}

void DelaunayMesh::RestoreAll(Pulse& pulse)
{
  pulse.ForEach(this->Regions.size(),
    [this](std::size_t triangle)
    {
      for (Id edge = 4 * static_cast<Id>(triangle); (edge & 3) < 3; ++edge)
      {
        if (this->Twins[edge] < edge)
        {
          this->RestoreEdge(edge);
        }
      }
    });
}

void DelaunayMesh::RestoreBeside(const std::vector<std::uint8_t>& areChanged, Pulse& pulse)
{
  pulse.ForEach(areChanged.size(),
    [this, &areChanged](std::size_t triangle)
    {
      for (Id edge = 4 * static_cast<Id>(triangle); (edge & 3) < 3; ++edge)
      {
        const Id twin = this->Twins[edge];
        if (twin < edge && twin != NoId &&
          (areChanged[triangle] | areChanged[TriangleOf(twin)]) != 0)
        {
          this->RestoreEdge(edge);
        }
      }
    });
}

void DelaunayMesh::RestoreEdge(Id edge)
{
  if (this->IsEdge(edge) && this->MustFlip(edge))
  {
    this->FlipAndPush(edge);
    this->EmptyStack();
  }
}

void DelaunayMesh::EmptyStack()
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

bool DelaunayMesh::MustFlip(Id edge) const
{
  const Id twin = this->Twins[edge];
  if (twin == NoId || this->Marks[edge] != NoId)
  {
    return false;
  }
  const std::vector<Point2>& points = this->Points;
  return InCircle(points[this->Corners[edge]], points[this->Origin(edge)],
           points[this->Target(edge)], points[this->Corners[twin]]) > 0;
}

void DelaunayMesh::FlipAndPush(Id edge)
{
  const Id twin = this->Twins[edge];
  this->Flip(edge);
  this->Stack.insert(this->Stack.end(), { edge, Previous(edge), twin, Previous(twin) });
}

const std::vector<Id>& DelaunayMesh::Around(Id center, int rings)
{
  this->Centers.assign(1, center);
  return this->Around(this->Centers, rings);
}

const std::vector<Id>& DelaunayMesh::Around(const std::vector<Id>& centers, int rings)
{
  this->Stamps.resize(this->Points.size(), 0);
  this->Near.clear();
  ++this->Stamp;
  for (const Id center : centers)
  {
    this->AddNear(center);
  }
  std::size_t first = 0;
  for (int ring = 0; ring < rings; ++ring)
  {
    for (const std::size_t last = this->Near.size(); first < last; ++first)
    {
      this->AddNeighbors(this->Near[first]);
    }
  }
  return this->Near;
}

void DelaunayMesh::AddNear(Id vertex)
{
  if (this->Stamps[vertex] != this->Stamp)
  {
    this->Stamps[vertex] = this->Stamp;
    this->Near.push_back(vertex);
  }
}

void DelaunayMesh::AddNeighbors(Id vertex)
{
  if (this->Degrees[vertex] <= Star::Capacity)
  {
    Id last = NoId;
    this->ForEachAround(vertex,
      [this, &last](Id edge)
      {
        this->AddNear(this->Origin(edge));
        last = edge;
      });
    this->AddNear(this->Target(last));
  }
}

} // namespace biting
