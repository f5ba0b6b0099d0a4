// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MutableMesh.h"

#include "DividedSegments.h"

#include "../Base/PointOnSegment.h"

namespace biting
{

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
  const auto shrink = [](std::size_t size, auto&... arrays) { (arrays.resize(size), ...); };
  shrink(this->OldNumberOfVertices, this->Points, this->Spacings, this->Freedoms, this->Segments,
    this->VertexEdges, this->Degrees, this->IdealDegrees, this->IsEstimate);
  shrink(4 * this->OldNumberOfTriangles, this->Corners, this->Twins, this->Marks);
  this->Regions.resize(this->OldNumberOfTriangles);
}

void MutableMesh::Link(Id edge, Id twin)
{
  this->Store(this->Twins, edge, twin);
  if (twin != NoId)
  {
    this->Store(this->Twins, twin, edge);
  }
}

} // namespace biting
