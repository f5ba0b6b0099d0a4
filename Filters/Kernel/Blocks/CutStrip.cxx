// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CutStrip.h"

#include "../Base/PartOfStage.h"
#include "../Base/Pulse.h"
#include "../Relaxation/Relaxation.h"
#include "RimFlips.h"

#include <algorithm> // for sort, fill_n, max
#include <cstdint>   // for flags

namespace biting
{

namespace
{

constexpr int Steps = 10; // across edges; two are about a ring of vertices

// Angles below 45 degrees are made better, below 43 also one by one.
constexpr double PoorCotangents = 0.85;

// Where steps end, as shares of the time.
constexpr double TakingEnd = 0.1;
constexpr double RelaxingEnd = 0.8;

// An edge of the strip that stays: what lies across it, if that is not of the strip, and its
// constraint.
struct FixedEdge
{
  Id Outside = NoId; ///< a slot
  Id Constraint = NoId;
};

class Strip
{
public:
  Strip(const Domain& domain, JoinedMesh& mesh, Pulse& pulse)
    : Geometry(domain)
    , Whole(mesh)
    , Beats(pulse)
  {
  }

  void Take();
  bool IsEmpty() const { return this->Triangles.empty(); }
  void Relax(const Spacing& spacing, Monitor& monitor);
  void PutBack();

private:
  void FindTriangles();
  void NumberTriangles();
  bool IsFixed(std::size_t slot) const;
  void FindFixedVertices();
  void NumberVertices();
  void AddFixedEdge(std::size_t slot, Id start, Id end);
  Id SlotAcross(std::size_t slot) const;
  void CopyTriangles();
  void FillDomain();
  void NumberWhole();
  void MoveVertices();
  void MoveTriangles();
  void AddStrip();
  Id Corner(std::size_t slot, std::size_t turn) const
  {
    return this->Whole.Triangles.Corners[slot - slot % 3 + (slot + turn) % 3];
  }

  const Domain& Geometry;
  JoinedMesh& Whole;
  Pulse& Beats;

  std::vector<Id> Triangles;               ///< of the whole, that are of the strip
  std::vector<Id> TriangleNumbers;         ///< of the whole's triangles in the strip, or NoId
  std::vector<std::uint8_t> IsFixedVertex; ///< of the whole's
  std::vector<Id> Vertices; ///< of the whole, that are of the strip: fixed ones first
  std::vector<Id> Numbers;  ///< of the whole's vertices in the strip, or NoId
  std::vector<FixedEdge> FixedEdges;

  Domain Border; ///< the fixed edges as segments
  RelaxationMesh Mesh;
  RelaxationResult Result;

  std::vector<Id> NewNumbers;      ///< of the whole's vertices, NoId where they are gone
  std::vector<Id> NewStripNumbers; ///< of the strip's
  std::vector<std::size_t> Rim;    ///< slots of the whole, at edges to what is not of the strip
  std::vector<Id> NewTriangles;    ///< numbers of the whole's triangles that are not of the strip
};

void Strip::Take()
{
  this->FindTriangles();
  if (this->IsEmpty())
  {
    return;
  }
  this->NumberTriangles();
  this->FindFixedVertices();
  this->NumberVertices();
  this->CopyTriangles();
  this->FillDomain();
}

// Those at cuts, then step by step those across edges.
void Strip::FindTriangles()
{
  const Triangulation& whole = this->Whole.Triangles;
  const std::vector<std::uint8_t>& isOnCut = this->Whole.IsOnCut;
  std::vector<std::uint8_t> isTaken(whole.Regions.size(), 0);
  this->Beats.ForEach(isTaken.size(),
    [this, &whole, &isOnCut, &isTaken](std::size_t triangle)
    {
      const Id* corners = whole.Corners.data() + 3 * triangle;
      if (isOnCut[corners[0]] != 0 || isOnCut[corners[1]] != 0 || isOnCut[corners[2]] != 0)
      {
        isTaken[triangle] = 1;
        this->Triangles.push_back(static_cast<Id>(triangle));
      }
    });
  std::size_t begin = 0;
  for (int step = 0; step < Steps && this->Beats.Ask(); ++step)
  {
    const std::size_t end = this->Triangles.size();
    for (; begin < end; ++begin)
    {
      const std::size_t first = 3 * static_cast<std::size_t>(this->Triangles[begin]);
      for (std::size_t slot = first; slot < first + 3; ++slot)
      {
        const Id next = whole.Neighbors[slot];
        if (next != NoId && isTaken[next] == 0)
        {
          isTaken[next] = 1;
          this->Triangles.push_back(next);
        }
      }
    }
  }
  std::sort(this->Triangles.begin(), this->Triangles.end());
}

void Strip::NumberTriangles()
{
  this->TriangleNumbers.assign(this->Whole.Triangles.Regions.size(), NoId);
  for (std::size_t k = 0; k < this->Triangles.size(); ++k)
  {
    this->TriangleNumbers[this->Triangles[k]] = static_cast<Id>(k);
  }
}

// Of a slot of a triangle of the strip.
bool Strip::IsFixed(std::size_t slot) const
{
  const Id neighbor = this->Whole.Triangles.Neighbors[slot];
  return this->Whole.Triangles.Constraints[slot] != NoId || neighbor == NoId ||
    this->TriangleNumbers[neighbor] == NoId;
}

void Strip::FindFixedVertices()
{
  for (const Id segment : this->Whole.Bites.Segments)
  {
    this->IsFixedVertex.push_back(segment != NoId ? 1 : 0);
  }
  std::fill_n(this->IsFixedVertex.begin(), this->Geometry.NumberOfVertices(), std::uint8_t{ 1 });
  for (const Id triangle : this->Triangles)
  {
    const std::size_t first = 3 * static_cast<std::size_t>(triangle);
    for (std::size_t slot = first; slot < first + 3; ++slot)
    {
      if (this->IsFixed(slot))
      {
        this->IsFixedVertex[this->Corner(slot, 1)] = 1;
        this->IsFixedVertex[this->Corner(slot, 2)] = 1;
      }
    }
  }
}

// In the order of the whole, fixed ones first.
void Strip::NumberVertices()
{
  std::vector<std::uint8_t> isUsed(this->Whole.Bites.Points.size(), 0);
  for (const Id triangle : this->Triangles)
  {
    for (std::size_t turn = 0; turn < 3; ++turn)
    {
      isUsed[this->Corner(3 * static_cast<std::size_t>(triangle), turn)] = 1;
    }
  }
  this->Numbers.assign(isUsed.size(), NoId);
  for (const bool fixed : { true, false })
  {
    for (std::size_t vertex = 0; vertex < isUsed.size(); ++vertex)
    {
      if (isUsed[vertex] != 0 && (this->IsFixedVertex[vertex] != 0) == fixed)
      {
        this->Numbers[vertex] = static_cast<Id>(this->Vertices.size());
        this->Vertices.push_back(static_cast<Id>(vertex));
      }
    }
  }
  for (const Id vertex : this->Vertices)
  {
    this->Mesh.Points.push_back(this->Whole.Bites.Points[vertex]);
    this->Mesh.Spacings.push_back(this->Whole.Bites.Spacings[vertex]);
    this->Mesh.Segments.push_back(NoId);
  }
}

Id Strip::SlotAcross(std::size_t slot) const
{
  std::size_t across = 3 * static_cast<std::size_t>(this->Whole.Triangles.Neighbors[slot]);
  while (this->Corner(across, 2) != this->Corner(slot, 1))
  {
    ++across;
  }
  return static_cast<Id>(across);
}

void Strip::CopyTriangles()
{
  const Triangulation& whole = this->Whole.Triangles;
  Triangulation& strip = this->Mesh.Triangles;
  for (const Id triangle : this->Triangles)
  {
    strip.Regions.push_back(whole.Regions[triangle]);
    const std::size_t first = 3 * static_cast<std::size_t>(triangle);
    for (std::size_t slot = first; slot < first + 3; ++slot)
    {
      const Id neighbor = whole.Neighbors[slot];
      const Id inside = neighbor == NoId ? NoId : this->TriangleNumbers[neighbor];
      strip.Corners.push_back(this->Numbers[whole.Corners[slot]]);
      strip.Neighbors.push_back(inside);
      strip.Constraints.push_back(NoId);
      if (!this->IsFixed(slot))
      {
        continue;
      }
      const std::size_t own = strip.Constraints.size() - 1;
      // Of an edge inside, the triangle that comes later has what the first one got.
      if (inside != NoId && inside < static_cast<Id>(own / 3))
      {
        const std::size_t across = static_cast<std::size_t>(this->SlotAcross(slot));
        strip.Constraints[own] =
          strip.Constraints[3 * static_cast<std::size_t>(inside) + across % 3];
        continue;
      }
      strip.Constraints[own] = static_cast<Id>(this->FixedEdges.size());
      this->AddFixedEdge(
        slot, this->Numbers[this->Corner(slot, 1)], this->Numbers[this->Corner(slot, 2)]);
    }
  }
}

void Strip::AddFixedEdge(std::size_t slot, Id start, Id end)
{
  const Triangulation& whole = this->Whole.Triangles;
  const Id neighbor = whole.Neighbors[slot];
  const bool isInside = neighbor != NoId && this->TriangleNumbers[neighbor] != NoId;
  FixedEdge edge;
  edge.Constraint = whole.Constraints[slot];
  edge.Outside = neighbor == NoId || isInside ? NoId : this->SlotAcross(slot);
  this->Mesh.EdgeStarts.push_back(start);
  this->Mesh.EdgeEnds.push_back(end);
  this->Mesh.EdgeSegments.push_back(static_cast<Id>(this->FixedEdges.size()));
  this->Border.Starts.push_back(start);
  this->Border.Ends.push_back(end);
  this->Border.IsBoundary.push_back(isInside ? 0 : 1);
  this->Border.LeftInside.push_back(1);
  this->Border.RightInside.push_back(isInside ? 1 : 0);
  this->FixedEdges.push_back(edge);
}

void Strip::FillDomain()
{
  for (const Id vertex : this->Vertices)
  {
    if (this->IsFixedVertex[vertex] != 0)
    {
      this->Border.Vertices.push_back(this->Whole.Bites.Points[vertex]);
      this->Border.VertexPoints.push_back(NoId);
      this->Border.IsEmbedded.push_back(0);
      this->Border.HasPoint.push_back(0);
      this->Border.Bounds.Add(this->Border.Vertices.back());
    }
  }
  this->Border.Cells.assign(this->Border.Starts.size(), NoId);
  this->Border.IsPreserved.assign(this->Border.Starts.size(), 1);
  this->Border.Resolution = this->Geometry.Resolution;
}

void Strip::Relax(const Spacing& spacing, Monitor& monitor)
{
  this->Result =
    biting::Relax(this->Border, spacing, { false, true, PoorCotangents }, this->Mesh, monitor);
}

void Strip::PutBack()
{
  this->NumberWhole();
  this->MoveVertices();
  this->MoveTriangles();
  this->AddStrip();
  FlipUntilDelaunay(this->Whole.Bites.Points, this->Rim, this->Whole.Triangles, this->Beats);
}

// What stays, in its order, then what is new.
void Strip::NumberWhole()
{
  const std::size_t count = this->Whole.Bites.Points.size();
  std::vector<std::uint8_t> stays(count, 1);
  for (const Id vertex : this->Vertices)
  {
    stays[vertex] = this->IsFixedVertex[vertex];
  }
  for (const Id origin : this->Result.Origins)
  {
    if (origin != NoId)
    {
      stays[this->Vertices[origin]] = 1;
    }
  }
  this->NewNumbers.assign(count, NoId);
  Id next = 0;
  for (std::size_t vertex = 0; vertex < count; ++vertex)
  {
    this->NewNumbers[vertex] = stays[vertex] != 0 ? next++ : NoId;
  }
  for (const Id origin : this->Result.Origins)
  {
    this->NewStripNumbers.push_back(
      origin == NoId ? next++ : this->NewNumbers[this->Vertices[origin]]);
  }
}

void Strip::MoveVertices()
{
  BitingResult& bites = this->Whole.Bites;
  std::size_t count = 0;
  for (std::size_t vertex = 0; vertex < this->NewNumbers.size(); ++vertex)
  {
    if (this->NewNumbers[vertex] != NoId)
    {
      bites.Points[count] = bites.Points[vertex];
      bites.Spacings[count] = bites.Spacings[vertex];
      bites.BiteOrders[count] = bites.BiteOrders[vertex];
      bites.Segments[count] = bites.Segments[vertex];
      ++count;
    }
  }
  for (const Id number : this->NewStripNumbers)
  {
    count = std::max(count, static_cast<std::size_t>(number) + 1);
  }
  bites.Points.resize(count);
  bites.Spacings.resize(count);
  bites.BiteOrders.resize(count, NoId);
  bites.Segments.resize(count, NoId);
  for (std::size_t k = 0; k < this->NewStripNumbers.size(); ++k)
  {
    const std::size_t number = static_cast<std::size_t>(this->NewStripNumbers[k]);
    bites.Points[number] = this->Mesh.Points[k];
    bites.Spacings[number] = this->Mesh.Spacings[k];
    if (this->Result.Origins[k] == NoId)
    {
      bites.BiteOrders[number] = NoId;
      bites.Segments[number] = NoId;
    }
  }
  for (std::vector<Id>* ends : { &bites.EdgeStarts, &bites.EdgeEnds })
  {
    for (Id& end : *ends)
    {
      end = this->NewNumbers[end];
    }
  }
}

// Those that are not of the strip close up.
void Strip::MoveTriangles()
{
  Triangulation& whole = this->Whole.Triangles;
  Id count = 0;
  this->NewTriangles.assign(whole.Regions.size(), NoId);
  for (std::size_t triangle = 0; triangle < this->NewTriangles.size(); ++triangle)
  {
    this->NewTriangles[triangle] = this->TriangleNumbers[triangle] == NoId ? count++ : NoId;
  }
  for (std::size_t triangle = 0; triangle < this->NewTriangles.size(); ++triangle)
  {
    const Id number = this->NewTriangles[triangle];
    for (std::size_t k = 0; number != NoId && k < 3; ++k)
    {
      const std::size_t from = 3 * triangle + k;
      const std::size_t to = 3 * static_cast<std::size_t>(number) + k;
      const Id neighbor = whole.Neighbors[from];
      whole.Corners[to] = this->NewNumbers[whole.Corners[from]];
      whole.Neighbors[to] = neighbor == NoId ? NoId : this->NewTriangles[neighbor];
      whole.Constraints[to] = whole.Constraints[from];
      whole.Regions[static_cast<std::size_t>(number)] = whole.Regions[triangle];
    }
  }
  const std::size_t size = static_cast<std::size_t>(count);
  whole.Corners.resize(3 * size);
  whole.Neighbors.resize(3 * size);
  whole.Constraints.resize(3 * size);
  whole.Regions.resize(size);
}

void Strip::AddStrip()
{
  Triangulation& whole = this->Whole.Triangles;
  const Triangulation& strip = this->Mesh.Triangles;
  const Id first = whole.NumberOfTriangles();
  for (std::size_t slot = 0; slot < strip.Corners.size(); ++slot)
  {
    const Id constraint = strip.Constraints[slot];
    const FixedEdge edge =
      constraint == NoId ? FixedEdge() : this->FixedEdges[this->Mesh.EdgeSegments[constraint]];
    Id neighbor = strip.Neighbors[slot] == NoId ? NoId : first + strip.Neighbors[slot];
    if (edge.Outside != NoId)
    {
      this->Rim.push_back(3 * static_cast<std::size_t>(first) + slot);
      neighbor = this->NewTriangles[edge.Outside / 3];
      whole.Neighbors[3 * static_cast<std::size_t>(neighbor) + edge.Outside % 3] =
        first + static_cast<Id>(slot / 3);
    }
    whole.Corners.push_back(this->NewStripNumbers[strip.Corners[slot]]);
    whole.Neighbors.push_back(neighbor);
    whole.Constraints.push_back(edge.Constraint);
  }
  whole.Regions.insert(whole.Regions.end(), strip.Regions.begin(), strip.Regions.end());
}

} // namespace

void RelaxCuts(const Domain& domain, const Spacing& spacing, JoinedMesh& mesh, Monitor& monitor)
{
  PartOfStage taking(monitor, 0.0, TakingEnd);
  Pulse pulse(taking);
  Strip strip(domain, mesh, pulse);
  strip.Take();
  if (strip.IsEmpty() || !pulse.Ask())
  {
    return;
  }
  PartOfStage relaxing(monitor, TakingEnd, RelaxingEnd);
  strip.Relax(spacing, relaxing);
  if (!relaxing.HasStopped())
  {
    strip.PutBack();
  }
}

} // namespace biting
