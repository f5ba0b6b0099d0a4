// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MutableMesh.h"

#include "DividedSegments.h"

#include "../Base/PointOnSegment.h"
#include "../Predicates/Predicates.h"

#include <utility> // for swap

namespace biting
{

Id MutableMesh::FirstAround(Id vertex) const
{
  const Id start = this->VertexEdges[vertex];
  Id first = start;
  for (Id edge = this->TurnBack(start); edge != NoId && edge != start; edge = this->TurnBack(edge))
  {
    first = edge;
  }
  return this->TurnBack(first) == NoId ? first : start;
}

double MutableMesh::RelativeLength(Id edge) const
{
  const Id u = this->Origin(edge);
  const Id v = this->Target(edge);
  return 2.0 * Distance(this->Points[u], this->Points[v]) / (this->Spacings[u] + this->Spacings[v]);
}

// From the nearer end, so that the rounding is that of the shorter part.
Point2 MutableMesh::PlaceOnSegment(Id segment, const Point2& place) const
{
  const Point2& start = this->Geometry.Vertices[this->Geometry.Starts[segment]];
  const Point2& end = this->Geometry.Vertices[this->Geometry.Ends[segment]];
  const Point2 direction = end - start;
  const double parameter = Dot(place - start, direction) / Dot(direction, direction);
  return PointOnSegment(start, end, parameter, LeastSlidingLength(this->Geometry));
}

Point2 MutableMesh::DirectionOf(Id segment) const
{
  const Point2 along = this->Geometry.Vertices[this->Geometry.Ends[segment]] -
    this->Geometry.Vertices[this->Geometry.Starts[segment]];
  return 1.0 / Length(along) * along;
}

void MutableMesh::MoveTo(Id vertex, const Point2& place, double spacing)
{
  if (this->IsTrial)
  {
    this->Motions.push_back({ vertex, this->Points[vertex], this->Spacings[vertex] });
  }
  this->Points[vertex] = place;
  this->Spacings[vertex] = spacing;
}

void MutableMesh::AskForEstimates(Pulse& pulse)
{
  pulse.ForEach(this->Points.size(),
    [this](std::size_t slot)
    {
      if (this->IsEstimate[slot] != 0 && this->IsAlive(static_cast<Id>(slot)))
      {
        this->RefreshSpacing(static_cast<Id>(slot));
      }
    });
}

void MutableMesh::Flip(Id edge)
{
  const Id twin = this->Twins[edge];
  const Id nextEdge = Next(edge);
  const Id nextTwin = Next(twin);
  const Id markBeyondEdge = this->Marks[nextEdge];
  const Id markBeyondTwin = this->Marks[nextTwin];
  const Id beyondEdge = this->Twins[nextEdge];
  const Id beyondTwin = this->Twins[nextTwin];
  this->AddDegree(this->Corners[Previous(edge)], -1);
  this->AddDegree(this->Corners[Previous(twin)], -1);
  this->AddDegree(this->Corners[edge], 1);
  this->AddDegree(this->Corners[twin], 1);
  this->Store(this->Corners, Previous(edge), this->Corners[twin]);
  this->Store(this->Corners, Previous(twin), this->Corners[edge]);
  this->Link(edge, beyondTwin);
  this->Link(twin, beyondEdge);
  this->Link(nextEdge, nextTwin);
  this->Store(this->Marks, edge, markBeyondTwin);
  this->Store(this->Marks, twin, markBeyondEdge);
  this->Store(this->Marks, nextEdge, NoId);
  this->Store(this->Marks, nextTwin, NoId);
  for (const Id corner : { edge, nextEdge, twin, nextTwin })
  {
    this->Store(this->VertexEdges, this->Corners[corner], corner);
  }
}

bool MutableMesh::MayDivide(Id edge) const
{
  const Id segment = this->Marks[edge];
  return segment == NoId ||
    (this->DividesSegments && this->IsDivided[segment] != 0 &&
      IsFarAboveRounding(
        Distance(this->Points[this->Origin(edge)], this->Points[this->Target(edge)]),
        this->Geometry));
}

Id MutableMesh::Split(Id edge)
{
  const Id twin = this->Twins[edge];
  const Id segment = this->Marks[edge];
  const Point2& origin = this->Points[this->Origin(edge)];
  const Point2& target = this->Points[this->Target(edge)];
  const Point2 middle = Midpoint(origin, target);
  const Point2 place = segment == NoId ? middle : this->PlaceOnSegment(segment, middle);
  if (!this->MayDivide(edge) || !this->IsSplittable(edge, place) ||
    (twin != NoId && !this->IsSplittable(twin, place)))
  {
    return NoId;
  }
  const Id vertex = this->AddVertex(place, segment, twin == NoId);
  const Id added = this->AddTriangle(this->Regions[TriangleOf(edge)]);
  const Id addedTwin = twin == NoId ? NoId : this->AddTriangle(this->Regions[TriangleOf(twin)]);
  this->SplitSide(edge, vertex, added);
  if (twin != NoId)
  {
    this->SplitSide(twin, vertex, addedTwin);
    this->Link(added, twin);
  }
  this->Link(edge, addedTwin);
  return vertex;
}

bool MutableMesh::IsSplittable(Id edge, const Point2& place) const
{
  const Point2& apex = this->Points[this->Corners[edge]];
  return Orient2D(apex, this->Points[this->Origin(edge)], place) > 0 &&
    Orient2D(apex, place, this->Points[this->Target(edge)]) > 0;
}

Id MutableMesh::AddVertex(const Point2& place, Id segment, bool isOnBorder)
{
  this->Points.push_back(place);
  this->Spacings.push_back(this->F(place));
  this->Freedoms.push_back(segment == NoId ? Freedom::Free : Freedom::Sliding);
  this->Segments.push_back(segment);
  this->VertexEdges.push_back(NoId);
  this->Degrees.push_back(0);
  this->IdealDegrees.push_back(isOnBorder ? IdealOnBorder : IdealInside);
  this->IsEstimate.push_back(0);
  return this->NumberOfVertices() - 1;
}

Id MutableMesh::AddTriangle(Id region)
{
  const Id first = this->NumberOfEdges();
  for (std::vector<Id>* array : { &this->Corners, &this->Twins, &this->Marks })
  {
    array->resize(array->size() + 4, NoId);
  }
  this->Regions.push_back(region);
  return first;
}

// The half of the triangle (p, u, v) at u stays, that at v is new: (p, vertex, v).
void MutableMesh::SplitSide(Id edge, Id vertex, Id added)
{
  const Id apex = this->Corners[edge];
  const Id target = this->Target(edge);
  const Id outer = Next(edge);
  this->Store(this->Corners, added, apex);
  this->Store(this->Corners, added + 1, vertex);
  this->Store(this->Corners, added + 2, target);
  this->Store(this->Corners, Previous(edge), vertex);
  this->Store(this->Twins, added, NoId);
  this->Store(this->Twins, added + 1, NoId);
  this->Link(added + 1, this->Twins[outer]);
  this->Link(added + 2, outer);
  this->Store(this->Marks, added, this->Marks[edge]);
  this->Store(this->Marks, added + 1, this->Marks[outer]);
  this->Store(this->Marks, outer, NoId);
  this->Store(this->VertexEdges, vertex, added + 1);
  this->Store(this->VertexEdges, target, added + 2);
  this->AddDegree(vertex, 2);
  this->AddDegree(apex, 1);
}

Id MutableMesh::Collapse(Id edge)
{
  if (!this->MayMerge(edge) || !this->MayVanish(edge) ||
    (this->Twins[edge] != NoId && !this->MayVanish(this->Twins[edge])))
  {
    return NoId;
  }
  Id kept = this->Origin(edge);
  Id vertex = this->Target(edge);
  const bool isMoved = this->Freedoms[kept] == this->Freedoms[vertex];
  if (this->Freedoms[vertex] < this->Freedoms[kept])
  {
    std::swap(kept, vertex);
  }
  const Point2 oldPlace = this->Points[kept];
  if (isMoved && !this->MoveToMiddle(edge, kept))
  {
    return NoId;
  }
  if (!this->IsValidWithout(vertex, kept))
  {
    this->Move(kept, oldPlace);
    return NoId;
  }
  if (isMoved)
  {
    this->RefreshSpacing(kept);
  }
  this->RemoveVertex(edge, vertex, kept);
  return kept;
}

// A free vertex may become any other; a sliding one only a neighbor on its segment.
bool MutableMesh::MayMerge(Id edge) const
{
  const Id u = this->Origin(edge);
  const Id v = this->Target(edge);
  if (this->Freedoms[u] == Freedom::Free || this->Freedoms[v] == Freedom::Free)
  {
    return true;
  }
  const Id segment = this->Marks[edge];
  return segment != NoId && this->IsDivided[segment] &&
    (this->Freedoms[u] == Freedom::Sliding || this->Freedoms[v] == Freedom::Sliding);
}

// The triangle becomes one edge: that must not join two constraints, nor cut the mesh.
bool MutableMesh::MayVanish(Id edge) const
{
  const Id next = Next(edge);
  const Id previous = Previous(edge);
  return (this->Marks[next] == NoId || this->Marks[previous] == NoId) &&
    (this->Twins[next] != NoId || this->Twins[previous] != NoId);
}

bool MutableMesh::MoveToMiddle(Id edge, Id kept)
{
  const Point2 place = this->PlaceFor(
    kept, Midpoint(this->Points[this->Origin(edge)], this->Points[this->Target(edge)]));
  if (!this->IsValidAt(kept, place))
  {
    return false;
  }
  this->Move(kept, place);
  return true;
}

bool MutableMesh::IsValidAt(Id vertex, const Point2& place) const
{
  const Id first = this->FirstAround(vertex);
  Id edge = first;
  do
  {
    if (Orient2D(place, this->Points[this->Origin(edge)], this->Points[this->Target(edge)]) <= 0)
    {
      return false;
    }
    edge = this->Turn(edge);
  } while (edge != NoId && edge != first);
  return true;
}

bool MutableMesh::IsValidWithout(Id vertex, Id kept) const
{
  const Id first = this->FirstAround(vertex);
  Id edge = first;
  do
  {
    const Id a = this->Origin(edge);
    const Id b = this->Target(edge);
    if (a != kept && b != kept &&
      Orient2D(this->Points[kept], this->Points[a], this->Points[b]) <= 0)
    {
      return false;
    }
    edge = this->Turn(edge);
  } while (edge != NoId && edge != first);
  return true;
}

void MutableMesh::RemoveVertex(Id edge, Id vertex, Id kept)
{
  const Id twin = this->Twins[edge];
  const Id numberOfSides = twin == NoId ? 1 : 2;
  this->AddDegree(kept, this->Degrees[vertex] - 2 * numberOfSides);
  const Id first = this->FirstAround(vertex);
  Id around = first;
  do
  {
    const Id following = this->Turn(around);
    this->Store(this->Corners, around, kept);
    around = following;
  } while (around != NoId && around != first);
  this->Store(this->VertexEdges, vertex, NoId);
  this->RemoveSide(edge);
  if (twin != NoId)
  {
    this->RemoveSide(twin);
  }
}

void MutableMesh::RemoveSide(Id edge)
{
  const Id next = Next(edge);
  const Id previous = Previous(edge);
  const Id apex = this->Corners[edge];
  const Id beyondNext = this->Twins[next];
  const Id beyondPrevious = this->Twins[previous];
  const Id mark = this->Marks[next] == NoId ? this->Marks[previous] : this->Marks[next];
  for (const Id outer : { beyondNext, beyondPrevious })
  {
    if (outer != NoId)
    {
      this->Store(this->Twins, outer, outer == beyondNext ? beyondPrevious : beyondNext);
      this->Store(this->Marks, outer, mark);
      this->Store(this->VertexEdges, this->Origin(outer), Next(outer));
      this->Store(this->VertexEdges, this->Target(outer), Previous(outer));
    }
  }
  this->AddDegree(apex, -1);
  for (const Id gone : { edge, next, previous })
  {
    this->Store(this->Corners, gone, NoId);
  }
}

void MutableMesh::BeginTrial()
{
  this->IsTrial = true;
  this->Changes.clear();
  this->Motions.clear();
  this->OldNumberOfVertices = this->Points.size();
  this->OldNumberOfTriangles = this->Regions.size();
}

void MutableMesh::EndTrial(bool isKept)
{
  this->IsTrial = false;
  if (!isKept)
  {
    this->TakeBack();
  }
}

void MutableMesh::TakeBack()
{
  for (auto change = this->Changes.rbegin(); change != this->Changes.rend(); ++change)
  {
    (*change->Array)[change->Index] = change->Value;
  }
  for (auto motion = this->Motions.rbegin(); motion != this->Motions.rend(); ++motion)
  {
    this->Points[motion->Vertex] = motion->Place;
    this->Spacings[motion->Vertex] = motion->Spacing;
  }
  this->Points.resize(this->OldNumberOfVertices);
  this->Spacings.resize(this->OldNumberOfVertices);
  this->Freedoms.resize(this->OldNumberOfVertices);
  this->Segments.resize(this->OldNumberOfVertices);
  this->VertexEdges.resize(this->OldNumberOfVertices);
  this->Degrees.resize(this->OldNumberOfVertices);
  this->IdealDegrees.resize(this->OldNumberOfVertices);
  this->IsEstimate.resize(this->OldNumberOfVertices);
  this->Corners.resize(4 * this->OldNumberOfTriangles);
  this->Twins.resize(4 * this->OldNumberOfTriangles);
  this->Marks.resize(4 * this->OldNumberOfTriangles);
  this->Regions.resize(this->OldNumberOfTriangles);
}

void MutableMesh::Store(std::vector<Id>& array, Id index, Id value)
{
  if (this->IsTrial)
  {
    this->Changes.push_back({ &array, index, array[index] });
  }
  array[index] = value;
}

void MutableMesh::Link(Id edge, Id twin)
{
  this->Store(this->Twins, edge, twin);
  if (twin != NoId)
  {
    this->Store(this->Twins, twin, edge);
  }
}

void MutableMesh::AddDegree(Id vertex, Id change)
{
  this->Store(this->Degrees, vertex, this->Degrees[vertex] + change);
}

} // namespace biting
