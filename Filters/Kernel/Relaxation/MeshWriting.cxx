// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshExchange.h"

#include "../Base/SortInSteps.h"

#include <algorithm> // for min
#include <utility>   // for move

namespace biting
{

namespace
{

// Where steps end, as shares of the time.
constexpr double NumbersEnd = 0.15;
constexpr double VerticesWrittenEnd = 0.4;
constexpr double TrianglesWrittenEnd = 0.85;

/// In steps: all of it at once would take long.
void Release(RelaxationMesh& mesh, Pulse& pulse)
{
  Triangulation& triangles = mesh.Triangles;
  ReleaseInSteps(pulse, mesh.Points, mesh.Spacings, mesh.Segments, triangles.Corners,
    triangles.Neighbors, triangles.Constraints, triangles.Regions);
}

/// A mesh edge on a segment, in the direction of it.
struct SegmentPart
{
  Id Segment;
  double Along; ///< of its start
  Id Edge;
  bool IsForward;
};

class Writer
{
public:
  Writer(const MutableMesh& mesh, const std::vector<Id>& origins, const RelaxationMesh& input,
    Pulse& pulse)
    : Mesh(mesh)
    , Origins(origins)
    , Input(input)
    , Progress(pulse)
  {
  }

  std::vector<Id> Write(RelaxationMesh& output)
  {
    this->NumberAll();
    this->WriteVertices();
    this->WriteTriangles();
    this->WriteParts();
    if (!this->Progress.HasStopped())
    {
      Release(output, this->Progress);
      output = std::move(this->Output);
    }
    return std::move(this->NewOrigins);
  }

private:
  void NumberAll();
  void NumberVertices();
  void NumberVertex(Id source, Id origin);
  void NumberTriangles();
  void WriteVertices();
  void WriteTriangles();
  void WriteEdge(Id edge);
  void WriteParts();
  void WritePart(const SegmentPart& part);
  std::vector<SegmentPart> FindParts();
  SegmentPart MakePart(Id edge) const;
  Id NewHalf(Id edge) const { return 3 * this->Triangles[edge >> 2] + (edge & 3); }

  const MutableMesh& Mesh;
  const std::vector<Id>& Origins;
  const RelaxationMesh& Input;
  Pulse& Progress;
  RelaxationMesh Output;
  std::vector<Id> NewOrigins;
  std::vector<Id> Sources;   ///< of each new vertex: the vertex of the mesh, or NoId
  std::vector<Id> Numbers;   ///< vertex of the mesh -> new vertex
  std::vector<Id> Triangles; ///< triangle of the mesh -> new triangle
  Id NumberOfTriangles = 0;  ///< that are new
};

void Writer::NumberAll()
{
  const PulsePart part(this->Progress, 0.0, NumbersEnd);
  this->NumberVertices();
  this->NumberTriangles();
}

// Vertices of the domain stay, whether a triangle uses them or not.
void Writer::NumberVertices()
{
  std::vector<Id> sourceOf;
  const bool isReady = GrowInSteps(sourceOf, this->Input.Points.size(), NoId, this->Progress) &&
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

void Writer::NumberTriangles()
{
  GrowInSteps(this->Triangles, this->Mesh.Regions.size(), NoId, this->Progress);
  Id& count = this->NumberOfTriangles;
  this->Progress.ForEach(this->Triangles.size(),
    [this, &count](std::size_t triangle)
    { this->Triangles[triangle] = this->Mesh.Corners[4 * triangle] == NoId ? NoId : count++; });
}

void Writer::WriteVertices()
{
  const PulsePart part(this->Progress, NumbersEnd, VerticesWrittenEnd);
  this->Output.Points.reserve(this->Sources.size());
  this->Output.Spacings.reserve(this->Sources.size());
  this->Output.Segments.reserve(this->Sources.size());
  this->Progress.ForEach(this->Sources.size(),
    [this](std::size_t vertex)
    {
      const Id source = this->Sources[vertex];
      const Id origin = this->NewOrigins[vertex];
      const bool isUsed = source != NoId;
      this->Output.Points.push_back(
        isUsed ? this->Mesh.Points[source] : this->Input.Points[origin]);
      this->Output.Spacings.push_back(
        isUsed ? this->Mesh.Spacings[source] : this->Input.Spacings[origin]);
      this->Output.Segments.push_back(
        isUsed ? this->Mesh.Segments[source] : this->Input.Segments[origin]);
    });
}

void Writer::WriteTriangles()
{
  const PulsePart part(this->Progress, VerticesWrittenEnd, TrianglesWrittenEnd);
  Triangulation& triangles = this->Output.Triangles;
  const std::size_t count = static_cast<std::size_t>(this->NumberOfTriangles);
  triangles.Corners.reserve(3 * count);
  triangles.Neighbors.reserve(3 * count);
  triangles.Regions.reserve(count);
  this->Progress.ForEach(this->Mesh.Corners.size(),
    [this](std::size_t slot) { this->WriteEdge(static_cast<Id>(slot)); });
  GrowInSteps(triangles.Constraints, triangles.Corners.size(), NoId, this->Progress);
}

void Writer::WriteEdge(Id edge)
{
  if (this->Mesh.IsEdge(edge))
  {
    Triangulation& triangles = this->Output.Triangles;
    const Id twin = this->Mesh.Twins[edge];
    triangles.Corners.push_back(this->Numbers[this->Mesh.Corners[edge]]);
    triangles.Neighbors.push_back(twin == NoId ? NoId : this->Triangles[twin >> 2]);
    if ((edge & 3) == 0)
    {
      triangles.Regions.push_back(this->Mesh.Regions[edge >> 2]);
    }
  }
}

void Writer::WriteParts()
{
  const PulsePart part(this->Progress, TrianglesWrittenEnd, 1.0);
  const std::vector<SegmentPart> parts = this->FindParts();
  this->Progress.ForEach(
    parts.size(), [this, &parts](std::size_t k) { this->WritePart(parts[k]); });
}

void Writer::WritePart(const SegmentPart& part)
{
  RelaxationMesh& output = this->Output;
  const Id constraint = static_cast<Id>(output.EdgeSegments.size());
  const Id origin = this->Numbers[this->Mesh.Origin(part.Edge)];
  const Id target = this->Numbers[this->Mesh.Target(part.Edge)];
  output.EdgeStarts.push_back(part.IsForward ? origin : target);
  output.EdgeEnds.push_back(part.IsForward ? target : origin);
  output.EdgeSegments.push_back(part.Segment);
  const Id twin = this->Mesh.Twins[part.Edge];
  output.Triangles.Constraints[this->NewHalf(part.Edge)] = constraint;
  if (twin != NoId)
  {
    output.Triangles.Constraints[this->NewHalf(twin)] = constraint;
  }
}

std::vector<SegmentPart> Writer::FindParts()
{
  const MutableMesh& mesh = this->Mesh;
  std::vector<SegmentPart> parts;
  this->Progress.ForEach(mesh.Corners.size(),
    [this, &mesh, &parts](std::size_t slot)
    {
      const Id edge = static_cast<Id>(slot);
      if (mesh.Marks[edge] != NoId && mesh.IsFirstHalf(edge))
      {
        parts.push_back(this->MakePart(edge));
      }
    });
  SortInSteps(
    parts,
    [](const SegmentPart& a, const SegmentPart& b)
    { return a.Segment != b.Segment ? a.Segment < b.Segment : a.Along < b.Along; },
    this->Progress);
  return this->Progress.HasStopped() ? std::vector<SegmentPart>() : std::move(parts);
}

SegmentPart Writer::MakePart(Id edge) const
{
  const MutableMesh& mesh = this->Mesh;
  const Id segment = mesh.Marks[edge];
  const Point2& from = mesh.Geometry.Vertices[mesh.Geometry.Starts[segment]];
  const Point2 direction = mesh.Geometry.Vertices[mesh.Geometry.Ends[segment]] - from;
  const double start = Dot(mesh.Points[mesh.Origin(edge)] - from, direction);
  const double end = Dot(mesh.Points[mesh.Target(edge)] - from, direction);
  return { segment, std::min(start, end), edge, start < end };
}

} // namespace

std::vector<Id> WriteMesh(
  const MutableMesh& mesh, const std::vector<Id>& origins, RelaxationMesh& output, Pulse& pulse)
{
  return Writer(mesh, origins, output, pulse).Write(output);
}

} // namespace biting
