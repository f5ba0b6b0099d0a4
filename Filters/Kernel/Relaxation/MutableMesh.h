// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMutableMesh_h
#define BitingMutableMesh_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Base/Pulse.h"
#include "RelaxedMesh.h"

#include <vector> // for what is written down

namespace biting
{

/// A triangulation whose vertices are moved, inserted and removed (EdgeOperations.h), and whose
/// edges flip.
///
/// Between BeginTrial and EndTrial every change is written down, so that it can be taken back.
class MutableMesh : public RelaxedMesh
{
public:
  using RelaxedMesh::RelaxedMesh;

  /// The point of the segment's line nearest to `place`, rounded.
  Point2 PlaceOnSegment(Id segment, const Point2& place) const;

  /// The unit vector from the start of the segment to its end.
  Point2 DirectionOf(Id segment) const;

  /// Where the vertex comes to lie when it is sent to `place`.
  Point2 PlaceFor(Id vertex, const Point2& place) const
  {
    return this->Freedoms[vertex] == Freedom::Sliding
      ? this->PlaceOnSegment(this->Segments[vertex], place)
      : place;
  }

  /// Moves the vertex. Its spacing stays that of the old place until it is refreshed.
  void Move(Id vertex, const Point2& place) { this->MoveTo(vertex, place, this->Spacings[vertex]); }

  /// The same with a spacing that is an estimate, until AskForEstimates.
  void MoveWithEstimate(Id vertex, const Point2& place, double spacing)
  {
    this->IsEstimate[vertex] = 1;
    this->MoveTo(vertex, place, spacing);
  }

  /// Evaluates the spacing where the vertex is.
  void RefreshSpacing(Id vertex)
  {
    this->MoveTo(vertex, this->Points[vertex], this->F(this->Points[vertex]));
  }

  /// Evaluates the spacing of all vertices that have an estimate.
  void AskForEstimates(Pulse& pulse);

  /// Replaces the edge by the other diagonal of its quadrangle. Precondition: it has a twin and no
  /// mark, and the quadrangle is strictly convex.
  void Flip(Id edge);

  /// Whether the segment of the edge, if it has one, allows a new vertex between its ends.
  bool MayDivide(Id edge) const;

  /// Adds a vertex without triangles: on the segment, or free where `segment` is NoId.
  Id AddVertex(const Point2& place, Id segment, bool isOnBorder);

  /// Adds a triangle without corners; returns its first half-edge.
  Id AddTriangle(Id region);

  /// Changes one of the arrays of ids.
  void Store(std::vector<Id>& array, Id index, Id value)
  {
    if (this->IsTrial)
    {
      this->Changes.push_back({ &array, index, array[index] });
    }
    array[index] = value;
  }

  /// Makes two half-edges each other's twins; the second may be NoId.
  void Link(Id edge, Id twin);

  void AddDegree(Id vertex, Id change)
  {
    this->Store(this->Degrees, vertex, this->Degrees[vertex] + change);
  }

  void BeginTrial();
  void EndTrial(bool isKept);

private:
  struct IdChange
  {
    std::vector<Id>* Array;
    Id Index;
    Id Value;
  };
  struct Motion
  {
    Id Vertex;
    Point2 Place;
    double Spacing;
  };

  void MoveTo(Id vertex, const Point2& place, double spacing);
  void TakeBack();

  bool IsTrial = false;
  std::vector<IdChange> Changes;
  std::vector<Motion> Motions;
  std::size_t OldNumberOfVertices = 0;
  std::size_t OldNumberOfTriangles = 0;
};

} // namespace biting

#endif
