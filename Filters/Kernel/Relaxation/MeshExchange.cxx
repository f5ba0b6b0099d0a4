// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshExchange.h"

#include "DividedSegments.h"

#include "../Base/SortInSteps.h"

#include <algorithm> // for min
#include <cmath>     // for abs
#include <utility>   // for swap, move

namespace biting
{

namespace
{

constexpr float IdealInside = 6.0f;
constexpr float IdealOnBorder = 3.0f;
constexpr double IdealAngle = 60.0;

/// The angle between p and q, q being to the left: wrong by less than 0.3 degrees, but the same on
/// every machine.
double RoughDegrees(const Point2& p, const Point2& q)
{
  const double along = Dot(p, q);
  const double across = Cross(p, q);
  const bool isSteep = std::abs(along) < across;
  const double z = isSteep ? along / across : across / along;
  const double degrees = 57.29578 * z * (0.9724 - 0.1919 * z * z);
  return isSteep ? 90.0 - degrees : (along > 0.0 ? degrees : 180.0 + degrees);
}

// Where steps end, as shares of the time.
constexpr double VerticesReadEnd = 0.3;
constexpr double TrianglesReadEnd = 0.7;
constexpr double NumbersEnd = 0.15;
constexpr double VerticesWrittenEnd = 0.4;
constexpr double TrianglesWrittenEnd = 0.85;

/// For a few more than `size`, so that the first that is made does not copy all.
template <typename... Values>
void ReserveWithRoom(std::size_t size, std::vector<Values>&... arrays)
{
  (arrays.reserve(size + size / 16), ...);
}

class Reader
{
public:
  Reader(const RelaxationMesh& input, MutableMesh& mesh, Pulse& pulse)
    : Input(input)
    , Mesh(mesh)
    , Progress(pulse)
  {
  }

  std::vector<Id> Read()
  {
    const bool isRead = this->ReadVertices() && this->ReadTriangles();
    if (isRead)
    {
      this->SetBounds();
    }
    return std::move(this->Origins);
  }

private:
  bool ReadVertices()
  {
    const PulsePart part(this->Progress, 0.0, VerticesReadEnd);
    this->NumberVertices();
    this->CopyVertices();
    return !this->Progress.HasStopped();
  }
  bool ReadTriangles()
  {
    const PulsePart part(this->Progress, VerticesReadEnd, TrianglesReadEnd);
    this->CopyTriangles();
    return !this->Progress.HasStopped();
  }
  void SetBounds()
  {
    const PulsePart part(this->Progress, TrianglesReadEnd, 1.0);
    this->SetFreedoms();
    this->SetIdealDegrees();
  }

  void NumberVertices();
  void CopyVertices();
  void CopyTriangles();
  void CopyEdge(std::size_t half, Id edge);
  static Id EdgeOf(std::size_t half) { return static_cast<Id>(half / 3 * 4 + half % 3); }
  void SetFreedoms();
  Freedom FreedomOf(Id vertex, Id numberOfMarks, bool isAtOther) const;
  void SetIdealDegrees();

  const RelaxationMesh& Input;
  MutableMesh& Mesh;
  Pulse& Progress;
  std::vector<Id> Numbers; ///< vertex of the input -> of the mesh
  std::vector<Id> Origins;
};

void Reader::NumberVertices()
{
  GrowInSteps(this->Numbers, this->Input.Points.size(), NoId, this->Progress);
  this->Origins.reserve(this->Input.Points.size());
  const std::vector<Id>& corners = this->Input.Triangles.Corners;
  this->Progress.ForEach(corners.size(),
    [this, &corners](std::size_t half)
    {
      if (this->Numbers[corners[half]] == NoId)
      {
        this->Numbers[corners[half]] = static_cast<Id>(this->Origins.size());
        this->Origins.push_back(corners[half]);
      }
    });
}

void Reader::CopyVertices()
{
  MutableMesh& mesh = this->Mesh;
  const std::size_t size = this->Origins.size();
  ReserveWithRoom(size, mesh.Points, mesh.Spacings, mesh.Segments, mesh.VertexEdges, mesh.Degrees,
    mesh.Freedoms, mesh.IdealDegrees, mesh.IsEstimate);
  this->Progress.ForEach(size,
    [this, &mesh](std::size_t vertex)
    {
      const Id origin = this->Origins[vertex];
      mesh.Points.push_back(this->Input.Points[origin]);
      mesh.Spacings.push_back(this->Input.Spacings[origin]);
      mesh.Segments.push_back(this->Input.Segments[origin]);
    });
  GrowInSteps(mesh.VertexEdges, size, NoId, this->Progress);
  GrowInSteps(mesh.Degrees, size, Id(0), this->Progress);
  GrowInSteps(mesh.Freedoms, size, Freedom::Fixed, this->Progress);
  GrowInSteps(mesh.IdealDegrees, size, IdealInside, this->Progress);
  GrowInSteps(mesh.IsEstimate, size, std::uint8_t{ 0 }, this->Progress);
}

void Reader::CopyTriangles()
{
  MutableMesh& mesh = this->Mesh;
  const std::size_t numberOfHalves = this->Input.Triangles.Corners.size();
  const std::size_t size = numberOfHalves / 3 * 4;
  ReserveWithRoom(size, mesh.Corners, mesh.Twins, mesh.Marks);
  for (std::vector<Id>* array : { &mesh.Corners, &mesh.Twins, &mesh.Marks })
  {
    if (!GrowInSteps(*array, size, NoId, this->Progress))
    {
      return;
    }
  }
  const std::vector<Id>& regions = this->Input.Triangles.Regions;
  ReserveWithRoom(regions.size(), mesh.Regions);
  this->Progress.ForEach(regions.size(),
    [&mesh, &regions](std::size_t triangle) { mesh.Regions.push_back(regions[triangle]); });
  this->Progress.ForEach(numberOfHalves,
    [this, &mesh](std::size_t half)
    {
      const Id edge = EdgeOf(half);
      const Id vertex = this->Numbers[this->Input.Triangles.Corners[half]];
      mesh.Corners[edge] = vertex;
      mesh.VertexEdges[vertex] = edge;
      ++mesh.Degrees[vertex];
    });
  this->Progress.ForEach(
    numberOfHalves, [this](std::size_t half) { this->CopyEdge(half, EdgeOf(half)); });
}

void Reader::CopyEdge(std::size_t half, Id edge)
{
  const Id constraint = this->Input.Triangles.Constraints[half];
  this->Mesh.Marks[edge] = constraint == NoId ? NoId : this->Input.EdgeSegments[constraint];
  const Id neighbor = this->Input.Triangles.Neighbors[half];
  if (neighbor == NoId)
  {
    return;
  }
  const Id start = this->Mesh.Origin(edge);
  Id twin = 4 * neighbor;
  while (this->Mesh.Target(twin) != start)
  {
    ++twin;
  }
  this->Mesh.Twins[edge] = twin;
}

// Only vertices at which nothing but their own segment passes may slide.
void Reader::SetFreedoms()
{
  MutableMesh& mesh = this->Mesh;
  std::vector<std::uint8_t> numbersOfMarks(mesh.Points.size(), 0);
  std::vector<std::uint8_t> isAtOther(mesh.Points.size(), 0);
  this->Progress.ForEach(mesh.Corners.size(),
    [&mesh, &numbersOfMarks, &isAtOther](std::size_t slot)
    {
      const Id edge = static_cast<Id>(slot);
      if (mesh.IsFirstHalf(edge) && mesh.Marks[edge] != NoId)
      {
        for (const Id vertex : { mesh.Origin(edge), mesh.Target(edge) })
        {
          numbersOfMarks[vertex] += numbersOfMarks[vertex] < 3 ? 1 : 0;
          isAtOther[vertex] |= mesh.Segments[vertex] != mesh.Marks[edge] ? 1 : 0;
        }
      }
    });
  this->Progress.ForEach(mesh.Points.size(),
    [this, &mesh, &numbersOfMarks, &isAtOther](std::size_t slot)
    {
      const Id vertex = static_cast<Id>(slot);
      mesh.Freedoms[vertex] =
        this->FreedomOf(vertex, numbersOfMarks[vertex], isAtOther[vertex] != 0);
    });
}

Freedom Reader::FreedomOf(Id vertex, Id numberOfMarks, bool isAtOther) const
{
  const Id segment = this->Mesh.Segments[vertex];
  if (this->Origins[vertex] < this->Mesh.Geometry.NumberOfVertices() || isAtOther)
  {
    return Freedom::Fixed;
  }
  if (segment == NoId)
  {
    return Freedom::Free;
  }
  const bool isFree = numberOfMarks == 2 && this->Mesh.IsDivided[segment] != 0 &&
    IsFarAboveRounding(this->Mesh.Spacings[vertex], this->Mesh.Geometry);
  return isFree ? Freedom::Sliding : Freedom::Fixed;
}

// A fixed vertex of the border has the number that its angle has room for.
void Reader::SetIdealDegrees()
{
  MutableMesh& mesh = this->Mesh;
  this->Progress.ForEach(mesh.Corners.size(),
    [&mesh](std::size_t slot)
    {
      const Id edge = static_cast<Id>(slot);
      if (mesh.IsEdge(edge) && mesh.Twins[edge] == NoId)
      {
        for (const Id vertex : { mesh.Origin(edge), mesh.Target(edge) })
        {
          const bool isFixed = mesh.Freedoms[vertex] == Freedom::Fixed;
          mesh.IdealDegrees[vertex] = isFixed ? 0.0f : IdealOnBorder;
        }
      }
    });
  this->Progress.ForEach(mesh.Corners.size(),
    [&mesh](std::size_t slot)
    {
      const Id edge = static_cast<Id>(slot);
      const Id vertex = mesh.Corners[edge];
      if (vertex != NoId && mesh.Freedoms[vertex] == Freedom::Fixed &&
        mesh.IdealDegrees[vertex] < IdealInside)
      {
        const Point2& center = mesh.Points[vertex];
        mesh.IdealDegrees[vertex] +=
          static_cast<float>(RoughDegrees(mesh.Points[mesh.Origin(edge)] - center,
                               mesh.Points[mesh.Target(edge)] - center) /
            IdealAngle);
      }
    });
}

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

std::vector<Id> ReadMesh(const RelaxationMesh& input, MutableMesh& mesh, Pulse& pulse)
{
  return Reader(input, mesh, pulse).Read();
}

std::vector<Id> WriteMesh(
  const MutableMesh& mesh, const std::vector<Id>& origins, RelaxationMesh& output, Pulse& pulse)
{
  return Writer(mesh, origins, output, pulse).Write(output);
}

} // namespace biting
