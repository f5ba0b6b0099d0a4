// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshExchange.h"

#include "../Base/SortInSteps.h"

#include <algorithm>        // for max, min
#include <initializer_list> // for steps
#include <numeric>          // for accumulate
#include <utility>          // for move, pairs

namespace biting
{

namespace
{

// Where steps end, as shares of the time.
constexpr double NumbersEnd = 0.15;
constexpr double PartsEnd = 0.2;
constexpr double VerticesWrittenEnd = 0.4;
constexpr double TrianglesWrittenEnd = 0.85;

/// A mesh edge on a segment, in the direction of it, in the numbers of the output.
struct SegmentPart
{
  Id Segment;
  double Along; ///< of its start
  Id Start;
  Id End;
  Id Half;
  Id Twin; ///< the half on its other side, or NoId
};

class Writer
{
public:
  Writer(
    MutableMesh& mesh, const std::vector<Id>& origins, const RelaxationMesh& rest, Pulse& pulse)
    : Mesh(mesh)
    , Origins(origins)
    , Rest(rest)
    , Progress(pulse)
  {
  }

  std::vector<Id> Write(RelaxationMesh& output)
  {
    ReleaseInSteps(this->Progress, this->Mesh.Degrees, this->Mesh.Freedoms, this->Mesh.IdealDegrees,
      this->Mesh.IsEstimate);
    using Step = void (Writer::*)();
    double begin = 0.0;
    for (const auto& [step, end] :
      std::initializer_list<std::pair<Step, double>>{ { &Writer::NumberAll, NumbersEnd },
        { &Writer::FindParts, PartsEnd }, { &Writer::WriteVertices, VerticesWrittenEnd },
        { &Writer::WriteTriangles, TrianglesWrittenEnd }, { &Writer::WriteParts, 1.0 } })
    {
      const PulsePart part(this->Progress, begin, end);
      begin = end;
      (this->*step)();
    }
    output = std::move(this->Output);
    return std::move(this->NewOrigins);
  }

private:
  void NumberAll();
  void NumberVertices();
  void NumberVertex(Id source, Id origin);
  void FindParts();
  SegmentPart MakePart(Id edge) const;
  void WriteVertices();
  template <typename Value>
  void WriteOfVertices(
    std::vector<Value>& from, const std::vector<Value>& unused, std::vector<Value>& to);
  void WriteTriangles();
  template <typename Visit>
  void WriteHalves(
    std::vector<Id>& from, std::vector<Id>& to, std::size_t perTriangle, const Visit& valueOf);
  void WriteParts();
  Id NewHalf(Id edge) const { return 3 * this->Triangles[edge >> 2] + (edge & 3); }

  MutableMesh& Mesh;
  const std::vector<Id>& Origins;
  const RelaxationMesh& Rest; ///< the vertices of the domain
  Pulse& Progress;
  RelaxationMesh Output;
  std::vector<Id> NewOrigins;
  std::vector<Id> Sources;   ///< of each new vertex: the vertex of the mesh, or NoId
  std::vector<Id> Numbers;   ///< vertex of the mesh -> new vertex
  std::vector<Id> Triangles; ///< triangle of the mesh -> new triangle
  Id NumberOfTriangles = 0;  ///< that are new
  std::vector<SegmentPart> Parts;
};

void Writer::NumberAll()
{
  this->NumberVertices();
  GrowInSteps(this->Triangles, this->Mesh.Regions.size(), NoId, this->Progress);
  Id& count = this->NumberOfTriangles;
  this->Progress.ForEach(this->Triangles.size(),
    [this, &count](std::size_t triangle)
    { this->Triangles[triangle] = this->Mesh.Corners[4 * triangle] == NoId ? NoId : count++; });
  ReleaseInSteps(this->Progress, this->Mesh.VertexEdges);
}

// Vertices of the domain stay, whether a triangle uses them or not.
void Writer::NumberVertices()
{
  std::vector<Id> sourceOf;
  const Id numberOfOld = std::accumulate(this->Origins.begin(), this->Origins.end(),
    this->Mesh.Geometry.NumberOfVertices(),
    [](Id most, Id origin) { return std::max(most, origin + 1); });
  const bool isReady =
    GrowInSteps(sourceOf, static_cast<std::size_t>(numberOfOld), NoId, this->Progress) &&
    GrowInSteps(this->Numbers, this->Mesh.Points.size(), NoId, this->Progress) &&
    this->Progress.ForEach(this->Origins.size(),
      [this, &sourceOf](std::size_t slot)
      {
        const Id vertex = static_cast<Id>(slot);
        sourceOf[this->Origins[slot]] = this->Mesh.IsAlive(vertex) ? vertex : NoId;
      });
  if (!isReady)
  {
    return;
  }
  this->Sources.reserve(this->Mesh.Points.size());
  this->NewOrigins.reserve(this->Mesh.Points.size());
  this->Progress.ForEach(sourceOf.size(),
    [this, &sourceOf](std::size_t slot)
    {
      const Id origin = static_cast<Id>(slot);
      if (sourceOf[slot] != NoId || origin < this->Mesh.Geometry.NumberOfVertices())
      {
        this->NumberVertex(sourceOf[slot], origin);
      }
    });
  for (Id vertex = static_cast<Id>(this->Origins.size()); vertex < this->Mesh.NumberOfVertices();
       ++vertex)
  {
    if (this->Mesh.IsAlive(vertex))
    {
      this->NumberVertex(vertex, NoId);
    }
  }
}

void Writer::NumberVertex(Id source, Id origin)
{
  if (source != NoId)
  {
    this->Numbers[source] = static_cast<Id>(this->Sources.size());
  }
  this->Sources.push_back(source);
  this->NewOrigins.push_back(origin);
}

void Writer::FindParts()
{
  this->Progress.ForEach(this->Triangles.size(),
    [this](std::size_t triangle)
    {
      const Id* marks = &this->Mesh.Marks[4 * triangle];
      if ((marks[0] & marks[1] & marks[2]) == NoId)
      {
        return; // nearly all: each is NoId, which has all bits
      }
      for (Id edge = 4 * static_cast<Id>(triangle); (edge & 3) < 3; ++edge)
      {
        if (this->Mesh.Marks[edge] != NoId && this->Mesh.IsFirstHalf(edge))
        {
          this->Parts.push_back(this->MakePart(edge));
        }
      }
    });
  ReleaseInSteps(this->Progress, this->Mesh.Marks);
  SortInSteps(
    this->Parts,
    [](const SegmentPart& a, const SegmentPart& b)
    { return a.Segment != b.Segment ? a.Segment < b.Segment : a.Along < b.Along; },
    this->Progress);
}

SegmentPart Writer::MakePart(Id edge) const
{
  const MutableMesh& mesh = this->Mesh;
  const Id segment = mesh.Marks[edge];
  const Point2& from = mesh.Geometry.Vertices[mesh.Geometry.Starts[segment]];
  const Point2 direction = mesh.Geometry.Vertices[mesh.Geometry.Ends[segment]] - from;
  const Id origin = mesh.Origin(edge);
  const Id target = mesh.Target(edge);
  const double start = Dot(mesh.Points[origin] - from, direction);
  const double end = Dot(mesh.Points[target] - from, direction);
  const bool isForward = start < end;
  const Id twin = mesh.Twins[edge];
  return { segment, std::min(start, end), this->Numbers[isForward ? origin : target],
    this->Numbers[isForward ? target : origin], this->NewHalf(edge),
    twin == NoId ? NoId : this->NewHalf(twin) };
}

void Writer::WriteVertices()
{
  this->WriteOfVertices(this->Mesh.Points, this->Rest.Points, this->Output.Points);
  this->WriteOfVertices(this->Mesh.Spacings, this->Rest.Spacings, this->Output.Spacings);
  this->WriteOfVertices(this->Mesh.Segments, this->Rest.Segments, this->Output.Segments);
  ReleaseInSteps(this->Progress, this->Sources);
}

template <typename Value>
void Writer::WriteOfVertices(
  std::vector<Value>& from, const std::vector<Value>& unused, std::vector<Value>& to)
{
  to.reserve(this->Sources.size());
  this->Progress.ForEach(this->Sources.size(),
    [this, &from, &unused, &to](std::size_t vertex)
    {
      const Id source = this->Sources[vertex];
      to.push_back(source != NoId ? from[source] : unused[this->NewOrigins[vertex]]);
    });
  ReleaseInSteps(this->Progress, from);
}

void Writer::WriteTriangles()
{
  Triangulation& triangles = this->Output.Triangles;
  this->WriteHalves(this->Mesh.Twins, triangles.Neighbors, 3,
    [this](Id twin) { return twin == NoId ? NoId : this->Triangles[twin >> 2]; });
  this->WriteHalves(
    this->Mesh.Corners, triangles.Corners, 3, [this](Id corner) { return this->Numbers[corner]; });
  this->WriteHalves(this->Mesh.Regions, triangles.Regions, 1, [](Id region) { return region; });
  ReleaseInSteps(this->Progress, this->Numbers, this->Triangles);
}

// Fills `to` with valueOf the values of `from` for the triangles that are left: the first three of
// four, or one a triangle. Then `from` is given back.
template <typename Visit>
void Writer::WriteHalves(
  std::vector<Id>& from, std::vector<Id>& to, std::size_t perTriangle, const Visit& valueOf)
{
  const std::size_t stride = perTriangle == 1 ? 1 : 4;
  to.reserve(perTriangle * static_cast<std::size_t>(this->NumberOfTriangles));
  this->Progress.ForEach(this->Triangles.size(),
    [this, &from, &to, &valueOf, perTriangle, stride](std::size_t triangle)
    {
      const std::size_t first = stride * triangle;
      for (std::size_t k = first; this->Triangles[triangle] != NoId && k < first + perTriangle; ++k)
      {
        to.push_back(valueOf(from[k]));
      }
    });
  ReleaseInSteps(this->Progress, from);
}

void Writer::WriteParts()
{
  RelaxationMesh& output = this->Output;
  std::vector<Id>& constraints = output.Triangles.Constraints;
  GrowInSteps(constraints, output.Triangles.Corners.size(), NoId, this->Progress);
  this->Progress.ForEach(this->Parts.size(),
    [this, &output, &constraints](std::size_t k)
    {
      const SegmentPart& part = this->Parts[k];
      output.EdgeStarts.push_back(part.Start);
      output.EdgeEnds.push_back(part.End);
      output.EdgeSegments.push_back(part.Segment);
      constraints[part.Half] = static_cast<Id>(k);
      if (part.Twin != NoId)
      {
        constraints[part.Twin] = static_cast<Id>(k);
      }
    });
}

} // namespace

std::vector<Id> WriteMesh(
  MutableMesh& mesh, const std::vector<Id>& origins, RelaxationMesh& output, Pulse& pulse)
{
  return Writer(mesh, origins, output, pulse).Write(output);
}

} // namespace biting
