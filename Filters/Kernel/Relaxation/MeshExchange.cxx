// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshExchange.h"

#include "../Base/SortInSteps.h"
#include "../Base/TriangleSlots.h"
#include "DividedSegments.h"

#include <algorithm>        // for max, min
#include <cmath>            // for abs
#include <functional>       // for less
#include <initializer_list> // for steps
#include <numeric>          // for accumulate
#include <utility>          // for move, pairs

namespace biting
{

namespace
{

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
constexpr double CornersReadEnd = 0.35;
constexpr double VerticesReadEnd = 0.5;
constexpr double TrianglesReadEnd = 0.9;
constexpr double NumbersEnd = 0.15;
constexpr double PartsEnd = 0.2;
constexpr double VerticesWrittenEnd = 0.4;
constexpr double TrianglesWrittenEnd = 0.85;

/// For a few more than `size`, so that the first that is made does not copy all.
template <typename... Values>
void ReserveWithRoom(std::size_t size, std::vector<Values>&... arrays)
{
  (arrays.reserve(size + size / 16), ...);
}

/// Does the steps in their order, each up to a share of the time, until the monitor wants to stop.
template <typename Worker>
void DoSteps(
  Worker& worker, std::initializer_list<std::pair<void (Worker::*)(), double>> steps, Pulse& pulse)
{
  double begin = 0.0;
  for (const auto& [step, end] : steps)
  {
    const PulsePart part(pulse, begin, end);
    begin = end;
    if (!pulse.HasStopped())
    {
      (worker.*step)();
    }
  }
}

class Reader
{
public:
  Reader(RelaxationMesh& input, MutableMesh& mesh, Pulse& pulse)
    : Input(input)
    , Mesh(mesh)
    , Progress(pulse)
  {
  }

  std::vector<Id> Read()
  {
    DoSteps(*this,
      { { &Reader::TakeCorners, CornersReadEnd }, { &Reader::TakeVertices, VerticesReadEnd },
        { &Reader::TakeEdges, TrianglesReadEnd }, { &Reader::SetBounds, 1.0 } },
      this->Progress);
    return std::move(this->Origins);
  }

private:
  // Numbers the vertices as it meets them.
  void TakeCorners()
  {
    MutableMesh& mesh = this->Mesh;
    const std::size_t size = this->Input.Points.size();
    this->Origins.reserve(size);
    ReserveWithRoom(size, mesh.VertexEdges, mesh.Degrees);
    this->Numbers.resize(size, NoId);
    this->TakeHalves(this->Input.Triangles.Corners, mesh.Corners,
      [this, &mesh](Id edge, Id corner)
      {
        const Id vertex = this->NumberOf(corner);
        mesh.Corners[edge] = vertex;
        mesh.VertexEdges[vertex] = edge;
        ++mesh.Degrees[vertex];
      });
    ReleaseInSteps(this->Progress, this->Numbers);
  }

  Id NumberOf(Id vertex)
  {
    Id& number = this->Numbers[vertex];
    if (number == NoId)
    {
      number = static_cast<Id>(this->Origins.size());
      this->Origins.push_back(vertex);
      this->Mesh.VertexEdges.push_back(NoId);
      this->Mesh.Degrees.push_back(0);
    }
    return number;
  }

  void TakeVertices()
  {
    MutableMesh& mesh = this->Mesh;
    const std::size_t size = this->Origins.size();
    this->TakeOfVertices(this->Input.Points, mesh.Points);
    this->TakeOfVertices(this->Input.Spacings, mesh.Spacings);
    this->TakeOfVertices(this->Input.Segments, mesh.Segments);
    ReserveWithRoom(size, mesh.Freedoms, mesh.IdealDegrees, mesh.IsEstimate);
    mesh.Freedoms.resize(size, Freedom::Fixed);
    mesh.IdealDegrees.resize(size, IdealInside);
    mesh.IsEstimate.resize(size, std::uint8_t{ 0 });
  }

  template <typename Value>
  void TakeOfVertices(std::vector<Value>& from, std::vector<Value>& to)
  {
    ReserveWithRoom(this->Origins.size(), to);
    this->Progress.ForEach(this->Origins.size(),
      [this, &from, &to](std::size_t vertex) { to.push_back(from[this->Origins[vertex]]); });
    const auto ofDomain = from.begin() + this->Mesh.Geometry.NumberOfVertices();
    std::vector<Value>(from.begin(), ofDomain).swap(from);
    this->Progress.Ask();
  }

  void TakeEdges()
  {
    this->TakeHalves(this->Input.Triangles.Constraints, this->Mesh.Marks,
      [this](Id edge, Id constraint)
      {
        if (constraint != NoId)
        {
          this->Mesh.Marks[edge] = this->Input.EdgeSegments[constraint];
          this->Marked.push_back(edge);
        }
      });
    ReleaseInSteps(
      this->Progress, this->Input.EdgeStarts, this->Input.EdgeEnds, this->Input.EdgeSegments);
    this->TakeHalves(this->Input.Triangles.Neighbors, this->Mesh.Twins,
      [this](Id edge, Id neighbor)
      {
        if (neighbor == NoId)
        {
          this->Border.push_back(edge);
          return;
        }
        this->Mesh.Twins[edge] = this->TwinOf(edge, neighbor);
      });
    std::vector<Id>& regions = this->Input.Triangles.Regions;
    ReserveWithRoom(regions.size(), this->Mesh.Regions);
    this->Progress.ForEach(regions.size(),
      [this, &regions](std::size_t triangle) { this->Mesh.Regions.push_back(regions[triangle]); });
    ReleaseInSteps(this->Progress, regions);
  }

  // Makes `to` as long as there are half-edges, and calls visit(edge, value) for the values of
  // `from`, three a triangle, with the half-edges that they are of. Then `from` is given back.
  template <typename Visit>
  void TakeHalves(std::vector<Id>& from, std::vector<Id>& to, Visit&& visit)
  {
    const std::size_t triangles = this->Input.Triangles.Regions.size();
    ReserveWithRoom(4 * triangles, to);
    to.resize(4 * triangles, NoId);
    this->Progress.ForEach(triangles,
      [&from, &visit](std::size_t triangle)
      {
        for (std::size_t corner = 0; corner < 3; ++corner)
        {
          visit(static_cast<Id>(4 * triangle + corner), from[3 * triangle + corner]);
        }
      });
    ReleaseInSteps(this->Progress, from);
  }

  // The half-edge of the neighbor that ends where `edge` starts.
  Id TwinOf(Id edge, Id neighbor) const
  {
    constexpr Id After[] = { 1, 2, 0, 0 };
    return 4 * neighbor +
      After[CornerOf(&this->Mesh.Corners[4 * neighbor], this->Mesh.Origin(edge))];
  }

  void SetBounds()
  {
    this->SetFreedoms();
    this->SetIdealDegrees();
  }

  // Only vertices at which nothing but their own segment passes may slide.
  void SetFreedoms()
  {
    MutableMesh& mesh = this->Mesh;
    std::vector<std::uint8_t> numbersOfMarks(mesh.Points.size(), 0);
    std::vector<std::uint8_t> isAtOther(mesh.Points.size(), 0);
    this->Progress.ForEach(this->Marked.size(),
      [this, &mesh, &numbersOfMarks, &isAtOther](std::size_t k)
      {
        const Id edge = this->Marked[k];
        if (mesh.IsFirstHalf(edge))
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

  Freedom FreedomOf(Id vertex, Id numberOfMarks, bool isAtOther) const
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
  void SetIdealDegrees()
  {
    MutableMesh& mesh = this->Mesh;
    this->Progress.ForEach(this->Border.size(),
      [this, &mesh](std::size_t k)
      {
        for (const Id vertex : { mesh.Origin(this->Border[k]), mesh.Target(this->Border[k]) })
        {
          const bool isFixed = mesh.Freedoms[vertex] == Freedom::Fixed;
          mesh.IdealDegrees[vertex] = isFixed ? 0.0f : IdealOnBorder;
        }
      });
    const std::vector<Id> edges = this->CornersOfFixed();
    this->Progress.ForEach(edges.size(),
      [&mesh, &edges](std::size_t k)
      {
        const Id edge = edges[k];
        const Point2& center = mesh.Points[mesh.Corners[edge]];
        mesh.IdealDegrees[mesh.Corners[edge]] +=
          static_cast<float>(RoughDegrees(mesh.Points[mesh.Origin(edge)] - center,
                               mesh.Points[mesh.Target(edge)] - center) /
            IdealAngle);
      });
  }

  // Of the border: each edge of it begins a fan of triangles.
  std::vector<Id> CornersOfFixed() const
  {
    std::vector<Id> edges;
    this->Progress.ForEach(this->Border.size(),
      [this, &edges](std::size_t k)
      {
        Id edge = MutableMesh::Next(this->Border[k]);
        const bool isFixed = this->Mesh.Freedoms[this->Mesh.Corners[edge]] == Freedom::Fixed;
        for (; isFixed && edge != NoId; edge = this->Mesh.Turn(edge))
        {
          edges.push_back(edge);
        }
      });
    SortInSteps(edges, std::less<Id>(), this->Progress); // sums do not depend on the border's order
    return edges;
  }

  RelaxationMesh& Input;
  MutableMesh& Mesh;
  Pulse& Progress;
  std::vector<Id> Numbers; ///< vertex of the input -> of the mesh
  std::vector<Id> Origins;
  std::vector<Id> Marked; ///< half-edges that have a mark
  std::vector<Id> Border; ///< those that have no twin
};

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
    DoSteps(*this,
      { { &Writer::NumberAll, NumbersEnd }, { &Writer::FindParts, PartsEnd },
        { &Writer::WriteVertices, VerticesWrittenEnd },
        { &Writer::WriteTriangles, TrianglesWrittenEnd }, { &Writer::WriteParts, 1.0 } },
      this->Progress);
    output = std::move(this->Output);
    return std::move(this->NewOrigins);
  }

private:
  void NumberAll()
  {
    this->NumberVertices();
    this->Triangles.resize(this->Mesh.Regions.size(), NoId);
    Id& count = this->NumberOfTriangles;
    this->Progress.ForEach(this->Triangles.size(),
      [this, &count](std::size_t triangle)
      { this->Triangles[triangle] = this->Mesh.Corners[4 * triangle] == NoId ? NoId : count++; });
    ReleaseInSteps(this->Progress, this->Mesh.VertexEdges);
  }

  // Vertices of the domain stay, whether a triangle uses them or not.
  void NumberVertices()
  {
    const Id numberOfOld = std::accumulate(this->Origins.begin(), this->Origins.end(),
      this->Mesh.Geometry.NumberOfVertices(),
      [](Id most, Id origin) { return std::max(most, origin + 1); });
    std::vector<Id> sourceOf(static_cast<std::size_t>(numberOfOld), NoId);
    this->Numbers.resize(this->Mesh.Points.size(), NoId);
    this->Progress.ForEach(this->Origins.size(),
      [this, &sourceOf](std::size_t slot)
      {
        const Id vertex = static_cast<Id>(slot);
        sourceOf[this->Origins[slot]] = this->Mesh.IsAlive(vertex) ? vertex : NoId;
      });
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

  void NumberVertex(Id source, Id origin)
  {
    if (source != NoId)
    {
      this->Numbers[source] = static_cast<Id>(this->Sources.size());
    }
    this->Sources.push_back(source);
    this->NewOrigins.push_back(origin);
  }

  void FindParts()
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

  SegmentPart MakePart(Id edge) const
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

  void WriteVertices()
  {
    this->WriteOfVertices(this->Mesh.Points, this->Rest.Points, this->Output.Points);
    this->WriteOfVertices(this->Mesh.Spacings, this->Rest.Spacings, this->Output.Spacings);
    this->WriteOfVertices(this->Mesh.Segments, this->Rest.Segments, this->Output.Segments);
    ReleaseInSteps(this->Progress, this->Sources);
  }

  template <typename Value>
  void WriteOfVertices(
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

  void WriteTriangles()
  {
    Triangulation& triangles = this->Output.Triangles;
    this->WriteHalves(this->Mesh.Twins, triangles.Neighbors, 3,
      [this](Id twin) { return twin == NoId ? NoId : this->Triangles[twin >> 2]; });
    this->WriteHalves(this->Mesh.Corners, triangles.Corners, 3,
      [this](Id corner) { return this->Numbers[corner]; });
    this->WriteHalves(this->Mesh.Regions, triangles.Regions, 1, [](Id region) { return region; });
    ReleaseInSteps(this->Progress, this->Numbers, this->Triangles);
  }

  // Fills `to` with valueOf the values of `from` for the triangles that are left: the first three
  // of four, or one a triangle. Then `from` is given back.
  template <typename Visit>
  void WriteHalves(
    std::vector<Id>& from, std::vector<Id>& to, std::size_t perTriangle, const Visit& valueOf)
  {
    const std::size_t stride = perTriangle == 1 ? 1 : 4;
    to.reserve(perTriangle * static_cast<std::size_t>(this->NumberOfTriangles));
    this->Progress.ForEach(this->Triangles.size(),
      [this, &from, &to, &valueOf, perTriangle, stride](std::size_t triangle)
      {
        const std::size_t first = stride * triangle;
        for (std::size_t k = first; this->Triangles[triangle] != NoId && k < first + perTriangle;
             ++k)
        {
          to.push_back(valueOf(from[k]));
        }
      });
    ReleaseInSteps(this->Progress, from);
  }

  void WriteParts()
  {
    RelaxationMesh& output = this->Output;
    std::vector<Id>& constraints = output.Triangles.Constraints;
    constraints.resize(output.Triangles.Corners.size(), NoId);
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

} // namespace

std::vector<Id> ReadMesh(RelaxationMesh& input, MutableMesh& mesh, Pulse& pulse)
{
  return Reader(input, mesh, pulse).Read();
}

std::vector<Id> WriteMesh(
  MutableMesh& mesh, const std::vector<Id>& origins, RelaxationMesh& output, Pulse& pulse)
{
  return Writer(mesh, origins, output, pulse).Write(output);
}

} // namespace biting
