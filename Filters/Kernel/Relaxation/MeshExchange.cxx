// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshExchange.h"

#include <algorithm> // for sort
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

class Reader
{
public:
  Reader(const RelaxationMesh& input, MutableMesh& mesh)
    : Input(input)
    , Mesh(mesh)
  {
  }

  std::vector<Id> Read()
  {
    this->NumberVertices();
    this->CopyVertices();
    this->CopyTriangles();
    this->SetFreedoms();
    this->SetIdealDegrees();
    return std::move(this->Origins);
  }

private:
  void NumberVertices();
  void CopyVertices();
  void CopyTriangles();
  void CopyEdge(Id half, Id edge);
  void SetFreedoms();
  Freedom FreedomOf(Id vertex, Id numberOfMarks, bool isAtOther) const;
  void SetIdealDegrees();

  const RelaxationMesh& Input;
  MutableMesh& Mesh;
  std::vector<Id> Numbers; ///< vertex of the input -> of the mesh
  std::vector<Id> Origins;
};

void Reader::NumberVertices()
{
  this->Numbers.assign(this->Input.Points.size(), NoId);
  this->Origins.reserve(this->Input.Points.size());
  for (const Id corner : this->Input.Triangles.Corners)
  {
    if (this->Numbers[corner] == NoId)
    {
      this->Numbers[corner] = static_cast<Id>(this->Origins.size());
      this->Origins.push_back(corner);
    }
  }
}

void Reader::CopyVertices()
{
  MutableMesh& mesh = this->Mesh;
  const std::size_t size = this->Origins.size();
  const std::size_t reserve = size + size / 16;
  mesh.Points.reserve(reserve);
  mesh.Spacings.reserve(reserve);
  for (const Id origin : this->Origins)
  {
    mesh.Points.push_back(this->Input.Points[origin]);
    mesh.Spacings.push_back(this->Input.Spacings[origin]);
    mesh.Segments.push_back(this->Input.Segments[origin]);
  }
  mesh.VertexEdges.assign(size, NoId);
  mesh.Degrees.assign(size, 0);
  mesh.Freedoms.assign(size, Freedom::Fixed);
  mesh.IdealDegrees.assign(size, IdealInside);
}

void Reader::CopyTriangles()
{
  MutableMesh& mesh = this->Mesh;
  const Id numberOfTriangles = this->Input.Triangles.NumberOfTriangles();
  const std::size_t size = 4 * static_cast<std::size_t>(numberOfTriangles);
  for (std::vector<Id>* array : { &mesh.Corners, &mesh.Twins, &mesh.Marks })
  {
    array->reserve(size + size / 16);
    array->assign(size, NoId);
  }
  mesh.Regions = this->Input.Triangles.Regions;
  for (Id half = 0; half < 3 * numberOfTriangles; ++half)
  {
    const Id edge = 4 * (half / 3) + half % 3;
    const Id vertex = this->Numbers[this->Input.Triangles.Corners[half]];
    mesh.Corners[edge] = vertex;
    mesh.VertexEdges[vertex] = edge;
    ++mesh.Degrees[vertex];
  }
  for (Id half = 0; half < 3 * numberOfTriangles; ++half)
  {
    this->CopyEdge(half, 4 * (half / 3) + half % 3);
  }
}

void Reader::CopyEdge(Id half, Id edge)
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
  for (Id edge = 0; edge < mesh.NumberOfEdges(); ++edge)
  {
    if (mesh.IsFirstHalf(edge) && mesh.Marks[edge] != NoId)
    {
      for (const Id vertex : { mesh.Origin(edge), mesh.Target(edge) })
      {
        numbersOfMarks[vertex] += numbersOfMarks[vertex] < 3 ? 1 : 0;
        isAtOther[vertex] |= mesh.Segments[vertex] != mesh.Marks[edge] ? 1 : 0;
      }
    }
  }
  for (Id vertex = 0; vertex < mesh.NumberOfVertices(); ++vertex)
  {
    mesh.Freedoms[vertex] = this->FreedomOf(vertex, numbersOfMarks[vertex], isAtOther[vertex] != 0);
  }
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
  return numberOfMarks == 2 && this->Mesh.IsDivided[segment] ? Freedom::Sliding : Freedom::Fixed;
}

// A fixed vertex of the border has the number that its angle has room for.
void Reader::SetIdealDegrees()
{
  MutableMesh& mesh = this->Mesh;
  for (Id edge = 0; edge < mesh.NumberOfEdges(); ++edge)
  {
    if (mesh.IsEdge(edge) && mesh.Twins[edge] == NoId)
    {
      for (const Id vertex : { mesh.Origin(edge), mesh.Target(edge) })
      {
        const bool isFixed = mesh.Freedoms[vertex] == Freedom::Fixed;
        mesh.IdealDegrees[vertex] = isFixed ? 0.0f : IdealOnBorder;
      }
    }
  }
  for (Id edge = 0; edge < mesh.NumberOfEdges(); ++edge)
  {
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
  }
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
  Writer(const MutableMesh& mesh, const std::vector<Id>& origins, RelaxationMesh& output)
    : Mesh(mesh)
    , Origins(origins)
    , Output(output)
  {
  }

  std::vector<Id> Write()
  {
    this->NumberVertices();
    this->NumberTriangles();
    this->WriteVertices();
    this->WriteTriangles();
    this->WriteParts();
    return std::move(this->NewOrigins);
  }

private:
  void NumberVertices();
  void NumberTriangles();
  void WriteVertices();
  void WriteTriangles();
  void WriteParts();
  std::vector<SegmentPart> FindParts() const;
  Id NewHalf(Id edge) const { return 3 * this->Triangles[edge >> 2] + (edge & 3); }

  const MutableMesh& Mesh;
  const std::vector<Id>& Origins;
  RelaxationMesh& Output;
  std::vector<Id> NewOrigins;
  std::vector<Id> Sources;   ///< of each new vertex: the vertex of the mesh, or NoId
  std::vector<Id> Numbers;   ///< vertex of the mesh -> new vertex
  std::vector<Id> Triangles; ///< triangle of the mesh -> new triangle
};

// Vertices of the domain stay, whether a triangle uses them or not.
void Writer::NumberVertices()
{
  std::vector<Id> sourceOf(this->Output.Points.size(), NoId);
  for (Id vertex = 0; vertex < static_cast<Id>(this->Origins.size()); ++vertex)
  {
    sourceOf[this->Origins[vertex]] = this->Mesh.IsAlive(vertex) ? vertex : NoId;
  }
  this->Numbers.assign(this->Mesh.Points.size(), NoId);
  const auto add = [this](Id source, Id origin)
  {
    if (source != NoId)
    {
      this->Numbers[source] = static_cast<Id>(this->Sources.size());
    }
    this->Sources.push_back(source);
    this->NewOrigins.push_back(origin);
  };
  for (Id origin = 0; origin < static_cast<Id>(sourceOf.size()); ++origin)
  {
    if (sourceOf[origin] != NoId || origin < this->Mesh.Geometry.NumberOfVertices())
    {
      add(sourceOf[origin], origin);
    }
  }
  for (Id vertex = static_cast<Id>(this->Origins.size()); vertex < this->Mesh.NumberOfVertices();
       ++vertex)
  {
    if (this->Mesh.IsAlive(vertex))
    {
      add(vertex, NoId);
    }
  }
}

void Writer::NumberTriangles()
{
  this->Triangles.assign(this->Mesh.Regions.size(), NoId);
  Id count = 0;
  for (std::size_t triangle = 0; triangle < this->Triangles.size(); ++triangle)
  {
    this->Triangles[triangle] = this->Mesh.Corners[4 * triangle] == NoId ? NoId : count++;
  }
}

void Writer::WriteVertices()
{
  std::vector<Point2> points;
  std::vector<double> spacings;
  std::vector<Id> segments;
  points.reserve(this->Sources.size());
  spacings.reserve(this->Sources.size());
  segments.reserve(this->Sources.size());
  for (std::size_t vertex = 0; vertex < this->Sources.size(); ++vertex)
  {
    const Id source = this->Sources[vertex];
    const Id origin = this->NewOrigins[vertex];
    const bool isUsed = source != NoId;
    points.push_back(isUsed ? this->Mesh.Points[source] : this->Output.Points[origin]);
    spacings.push_back(isUsed ? this->Mesh.Spacings[source] : this->Output.Spacings[origin]);
    segments.push_back(isUsed ? this->Mesh.Segments[source] : this->Output.Segments[origin]);
  }
  this->Output.Points = std::move(points);
  this->Output.Spacings = std::move(spacings);
  this->Output.Segments = std::move(segments);
}

void Writer::WriteTriangles()
{
  Triangulation& triangles = this->Output.Triangles;
  triangles.Corners.clear();
  triangles.Neighbors.clear();
  triangles.Regions.clear();
  for (Id edge = 0; edge < this->Mesh.NumberOfEdges(); ++edge)
  {
    if (this->Mesh.IsEdge(edge))
    {
      const Id twin = this->Mesh.Twins[edge];
      triangles.Corners.push_back(this->Numbers[this->Mesh.Corners[edge]]);
      triangles.Neighbors.push_back(twin == NoId ? NoId : this->Triangles[twin >> 2]);
      if ((edge & 3) == 0)
      {
        triangles.Regions.push_back(this->Mesh.Regions[edge >> 2]);
      }
    }
  }
  triangles.Constraints.assign(triangles.Corners.size(), NoId);
}

void Writer::WriteParts()
{
  RelaxationMesh& output = this->Output;
  output.EdgeStarts.clear();
  output.EdgeEnds.clear();
  output.EdgeSegments.clear();
  for (const SegmentPart& part : this->FindParts())
  {
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
}

std::vector<SegmentPart> Writer::FindParts() const
{
  const MutableMesh& mesh = this->Mesh;
  std::vector<SegmentPart> parts;
  for (Id edge = 0; edge < mesh.NumberOfEdges(); ++edge)
  {
    const Id segment = mesh.Marks[edge];
    if (segment == NoId || !mesh.IsFirstHalf(edge))
    {
      continue;
    }
    const Point2& from = mesh.Geometry.Vertices[mesh.Geometry.Starts[segment]];
    const Point2 direction = mesh.Geometry.Vertices[mesh.Geometry.Ends[segment]] - from;
    const double start = Dot(mesh.Points[mesh.Origin(edge)] - from, direction);
    const double end = Dot(mesh.Points[mesh.Target(edge)] - from, direction);
    parts.push_back({ segment, std::min(start, end), edge, start < end });
  }
  std::sort(parts.begin(), parts.end(),
    [](const SegmentPart& a, const SegmentPart& b)
    { return a.Segment != b.Segment ? a.Segment < b.Segment : a.Along < b.Along; });
  return parts;
}

} // namespace

std::vector<Id> ReadMesh(const RelaxationMesh& input, MutableMesh& mesh)
{
  return Reader(input, mesh).Read();
}

std::vector<Id> WriteMesh(
  const MutableMesh& mesh, const std::vector<Id>& origins, RelaxationMesh& output)
{
  return Writer(mesh, origins, output).Write();
}

} // namespace biting
