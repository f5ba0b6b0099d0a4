// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TakenStrip.h"

#include "../Base/SortInSteps.h"
#include "../Base/Tasks.h"
#include "../Base/TriangleSlots.h"
#include "../Relaxation/DividedSegments.h"

#include <algorithm>  // for sort, lower_bound, stable_partition
#include <functional> // for less
#include <utility>    // for move

namespace biting
{

namespace
{

// Constraints of the whole with an end that may slide, and on which of their sides the strip is.
class SlidingEdges
{
public:
  struct Edge
  {
    Id Constraint;
    bool IsLeftInside;
    bool IsRightInside;
  };

  void Add(Id constraint, bool isLeft) { this->Edges.push_back({ constraint, isLeft, !isLeft }); }

  // By their constraints, and so in the order of their segments. Of edges inside both sides were
  // added: they become one.
  void Sort()
  {
    std::sort(this->Edges.begin(), this->Edges.end(),
      [](const Edge& a, const Edge& b) { return a.Constraint < b.Constraint; });
    std::vector<Edge> united;
    for (const Edge& edge : this->Edges)
    {
      if (united.empty() || united.back().Constraint != edge.Constraint)
      {
        united.push_back(edge);
        continue;
      }
      united.back().IsLeftInside = united.back().IsLeftInside || edge.IsLeftInside;
      united.back().IsRightInside = united.back().IsRightInside || edge.IsRightInside;
    }
    this->Edges = std::move(united);
  }

  // Its place among the others; NoId where it is none of them.
  Id PlaceOf(Id constraint) const
  {
    const auto found = std::lower_bound(this->Edges.begin(), this->Edges.end(), constraint,
      [](const Edge& edge, Id wanted) { return edge.Constraint < wanted; });
    return found != this->Edges.end() && found->Constraint == constraint
      ? static_cast<Id>(found - this->Edges.begin())
      : NoId;
  }

  std::size_t Size() const { return this->Edges.size(); }
  const Edge& operator[](std::size_t place) const { return this->Edges[place]; }

private:
  std::vector<Edge> Edges;
};

class StripTaker
{
public:
  StripTaker(StripSource& source, std::vector<Id> triangles, Pulse& pulse)
    : Geometry(source.Geometry)
    , AreTouching(source.AreTouching)
    , Whole(source.Whole)
    , Beats(pulse)
    , TriangleNumbers(source.TriangleNumbers)
    , Numbers(source.VertexNumbers)
  {
    this->Strip.Triangles = std::move(triangles);
  }

  TakenStrip Take()
  {
    if (!this->Strip.IsEmpty() && this->Beats.Ask())
    {
      this->NumberTriangles();
      this->ListVertices();
      this->NumberVertices();
      this->FindSlidingEdges();
      this->AddRuns();
      this->CopyTriangles();
    }
    if (!this->Beats.HasStopped())
    {
      this->FillDomain();
    }
    return std::move(this->Strip);
  }

private:
  void NumberTriangles()
  {
    ForEachAtOnce(this->Beats, this->Strip.Triangles.size(),
      [this](std::size_t k)
      { this->TriangleNumbers[this->Strip.Triangles[k]] = static_cast<Id>(k); });
  }

  // Of a slot of a triangle of the strip.
  bool IsFixed(std::size_t slot) const
  {
    const Id neighbor = this->Whole.Triangles.Neighbors[slot];
    return this->Whole.Triangles.Constraints[slot] != NoId || neighbor == NoId ||
      this->TriangleNumbers[neighbor] == NoId;
  }

  // In the order of the whole; their numbers are 0 where they are fixed, else 1.
  void ListVertices()
  {
    std::vector<Id>& vertices = this->Strip.Vertices;
    for (std::size_t k = 0; k < this->Strip.Triangles.size() && this->Beats.Beat(); ++k)
    {
      const std::size_t first = 3 * static_cast<std::size_t>(this->Strip.Triangles[k]);
      for (std::size_t slot = first; slot < first + 3; ++slot)
      {
        const bool isFixed = this->IsFixed(slot);
        for (const std::size_t end : { NextSlotOf(slot), PreviousSlotOf(slot) })
        {
          const Id vertex = this->Whole.Triangles.Corners[end];
          Id& number = this->Numbers[vertex];
          if (number == NoId)
          {
            vertices.push_back(vertex);
            number = this->StaysByItself(vertex) ? 0 : 1;
          }
          number = isFixed && !this->MaySlideAlong(slot, vertex) ? 0 : number;
        }
      }
    }
    SortInSteps(vertices, std::less<>(), this->Beats);
  }

  bool StaysByItself(Id vertex) const
  {
    const Id segment = this->Whole.Bites.Segments[vertex];
    return vertex < this->Geometry.NumberOfVertices() ||
      (segment != NoId &&
        (this->Geometry.MustPreserve(segment) || this->IsTouching(segment) ||
          !IsFarAboveRounding(this->Whole.Bites.Spacings[vertex], this->Geometry)));
  }

  bool IsTouching(Id segment) const
  {
    return !this->AreTouching.empty() && this->AreTouching[segment] != 0;
  }

  // An edge on the vertex's own segment, with nothing beside it that stays.
  bool MaySlideAlong(std::size_t slot, Id vertex) const
  {
    const Id neighbor = this->Whole.Triangles.Neighbors[slot];
    const Id constraint = this->Whole.Triangles.Constraints[slot];
    return constraint != NoId &&
      this->Whole.Bites.EdgeSegments[constraint] == this->Whole.Bites.Segments[vertex] &&
      (neighbor == NoId || this->TriangleNumbers[neighbor] != NoId);
  }

  // Fixed ones first.
  void NumberVertices()
  {
    std::vector<Id>& vertices = this->Strip.Vertices;
    const auto free = std::stable_partition(
      vertices.begin(), vertices.end(), [this](Id vertex) { return this->Numbers[vertex] == 0; });
    this->NumberOfFixed = static_cast<std::size_t>(free - vertices.begin());
    RelaxationMesh& mesh = this->Strip.Mesh;
    mesh.Points.resize(vertices.size());
    mesh.Spacings.resize(vertices.size());
    mesh.Segments.assign(vertices.size(), NoId);
    ForEachAtOnce(this->Beats, vertices.size(),
      [this, &vertices, &mesh](std::size_t k)
      {
        this->Numbers[vertices[k]] = static_cast<Id>(k);
        mesh.Points[k] = this->Whole.Bites.Points[vertices[k]];
        mesh.Spacings[k] = this->Whole.Bites.Spacings[vertices[k]];
      });
  }

  bool Slides(Id vertex) const
  {
    return static_cast<std::size_t>(this->Numbers[vertex]) >= this->NumberOfFixed;
  }

  void FindSlidingEdges()
  {
    const BitingResult& bites = this->Whole.Bites;
    for (std::size_t k = 0; k < this->Strip.Triangles.size() && this->Beats.Beat(); ++k)
    {
      const std::size_t first = 3 * static_cast<std::size_t>(this->Strip.Triangles[k]);
      for (std::size_t slot = first; slot < first + 3; ++slot)
      {
        const Id constraint = this->Whole.Triangles.Constraints[slot];
        if (constraint != NoId &&
          (this->Slides(bites.EdgeStarts[constraint]) || this->Slides(bites.EdgeEnds[constraint])))
        {
          this->Sliding.Add(constraint,
            this->Whole.Triangles.Corners[NextSlotOf(slot)] == bites.EdgeStarts[constraint]);
        }
      }
    }
    this->Sliding.Sort();
  }

  // From a vertex that stays to the next.
  void AddRuns()
  {
    std::size_t begin = 0;
    for (std::size_t k = 0; k < this->Sliding.Size() && this->Beats.Beat(); ++k)
    {
      const Id end = this->Whole.Bites.EdgeEnds[this->Sliding[k].Constraint];
      if (!this->Slides(end))
      {
        this->AddRun(begin, k + 1);
        begin = k + 1;
      }
    }
  }

  void AddRun(std::size_t begin, std::size_t end)
  {
    const BitingResult& bites = this->Whole.Bites;
    const SlidingEdges::Edge& first = this->Sliding[begin];
    const Id segment = static_cast<Id>(this->Strip.Sides.size());
    for (std::size_t k = begin; k < end; ++k)
    {
      const Id constraint = this->Sliding[k].Constraint;
      const Id start = this->Numbers[bites.EdgeStarts[constraint]];
      this->AddEdge(start, this->Numbers[bites.EdgeEnds[constraint]], segment);
      this->Strip.Mesh.Segments[start] = k == begin ? NoId : segment;
    }
    this->Strip.Sides.push_back({ NoId, first.Constraint, static_cast<Id>(end - begin) });
    this->AddSegment(this->Strip.Mesh.EdgeStarts[begin], this->Strip.Mesh.EdgeEnds.back(),
      first.IsLeftInside, first.IsRightInside);
  }

  void AddEdge(Id start, Id end, Id segment)
  {
    this->Strip.Mesh.EdgeStarts.push_back(start);
    this->Strip.Mesh.EdgeEnds.push_back(end);
    this->Strip.Mesh.EdgeSegments.push_back(segment);
  }

  void AddSegment(Id start, Id end, bool isLeftInside, bool isRightInside)
  {
    Domain& border = this->Strip.Border;
    border.Starts.push_back(start);
    border.Ends.push_back(end);
    border.IsBoundary.push_back(isLeftInside && isRightInside ? 0 : 1);
    border.LeftInside.push_back(isLeftInside ? 1 : 0);
    border.RightInside.push_back(isRightInside ? 1 : 0);
    border.IsPreserved.push_back(this->Strip.Sides.back().NumberOfParts == 1 ? 1 : 0);
  }

  void CopyTriangles()
  {
    Triangulation& own = this->Strip.Mesh.Triangles;
    own.Regions.reserve(this->Strip.Triangles.size());
    for (std::vector<Id>* slots : { &own.Corners, &own.Neighbors, &own.Constraints })
    {
      slots->reserve(3 * this->Strip.Triangles.size());
    }
    for (std::size_t k = 0; k < this->Strip.Triangles.size() && this->Beats.Beat(); ++k)
    {
      const Id triangle = this->Strip.Triangles[k];
      own.Regions.push_back(this->Whole.Triangles.Regions[triangle]);
      const std::size_t first = 3 * static_cast<std::size_t>(triangle);
      for (std::size_t slot = first; slot < first + 3; ++slot)
      {
        this->CopySlot(slot);
      }
    }
  }

  void CopySlot(std::size_t slot)
  {
    const Triangulation& whole = this->Whole.Triangles;
    Triangulation& strip = this->Strip.Mesh.Triangles;
    const Id neighbor = whole.Neighbors[slot];
    const Id inside = neighbor == NoId ? NoId : this->TriangleNumbers[neighbor];
    strip.Corners.push_back(this->Numbers[whole.Corners[slot]]);
    strip.Neighbors.push_back(inside);
    strip.Constraints.push_back(NoId);
    if (!this->IsFixed(slot))
    {
      return;
    }
    const std::size_t own = strip.Constraints.size() - 1;
    if (whole.Constraints[slot] != NoId)
    {
      strip.Constraints[own] = this->Sliding.PlaceOf(whole.Constraints[slot]);
      if (strip.Constraints[own] != NoId)
      {
        return;
      }
    }
    // Of an edge inside, the triangle that comes later has what the first one got.
    if (inside != NoId && inside < static_cast<Id>(own / 3))
    {
      const std::size_t across = SlotAcross(whole.Corners, slot, neighbor);
      strip.Constraints[own] = strip.Constraints[3 * static_cast<std::size_t>(inside) + across % 3];
      return;
    }
    strip.Constraints[own] = static_cast<Id>(this->Strip.Mesh.EdgeStarts.size());
    this->AddFixedEdge(slot, this->Numbers[whole.Corners[NextSlotOf(slot)]],
      this->Numbers[whole.Corners[PreviousSlotOf(slot)]]);
  }

  void AddFixedEdge(std::size_t slot, Id start, Id end)
  {
    const Triangulation& whole = this->Whole.Triangles;
    const Id neighbor = whole.Neighbors[slot];
    const bool isInside = neighbor != NoId && this->TriangleNumbers[neighbor] != NoId;
    TakenStrip::Side side;
    side.Constraint = whole.Constraints[slot];
    side.Outside = neighbor == NoId || isInside
      ? NoId
      : static_cast<Id>(SlotAcross(whole.Corners, slot, neighbor));
    this->AddEdge(start, end, static_cast<Id>(this->Strip.Sides.size()));
    this->Strip.Sides.push_back(side);
    this->AddSegment(start, end, true, isInside);
  }

  void FillDomain()
  {
    Domain& border = this->Strip.Border;
    for (std::size_t k = 0; k < this->NumberOfFixed; ++k)
    {
      border.Vertices.push_back(this->Strip.Mesh.Points[k]);
      border.Bounds.Add(border.Vertices.back());
    }
    border.VertexPoints.assign(this->NumberOfFixed, NoId);
    border.IsEmbedded.assign(this->NumberOfFixed, 0);
    border.HasPoint.assign(this->NumberOfFixed, 0);
    border.Cells.assign(border.Starts.size(), NoId);
    border.Resolution = this->Geometry.Resolution;
  }

  const Domain& Geometry;
  const std::vector<std::uint8_t>& AreTouching;
  const JoinedMesh& Whole;
  Pulse& Beats;
  TakenStrip Strip;
  std::vector<Id>& TriangleNumbers;
  std::vector<Id>& Numbers; ///< of the whole's vertices in the strip, or NoId
  std::size_t NumberOfFixed = 0;
  SlidingEdges Sliding; ///< the first edges of the strip
};

} // namespace

StripSource::StripSource(
  const Domain& domain, const std::vector<std::uint8_t>& areTouching, const JoinedMesh& mesh)
  : Geometry(domain)
  , AreTouching(areTouching)
  , Whole(mesh)
  , TriangleNumbers(mesh.Triangles.Regions.size(), NoId)
  , VertexNumbers(mesh.Bites.Points.size(), NoId)
{
}

TakenStrip TakeStrip(StripSource& source, std::vector<Id> triangles, Pulse& pulse)
{
  return StripTaker(source, std::move(triangles), pulse).Take();
}

} // namespace biting
