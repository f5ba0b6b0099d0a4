// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshExchange.h"

#include "../Base/SortInSteps.h"
#include "../Base/TriangleSlots.h"
#include "DividedSegments.h"

#include <cmath>            // for abs
#include <functional>       // for less
#include <initializer_list> // for steps
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

/// For a few more than `size`, so that the first that is made does not copy all.
template <typename... Values>
void ReserveWithRoom(std::size_t size, std::vector<Values>&... arrays)
{
  (arrays.reserve(size + size / 16), ...);
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
    using Step = void (Reader::*)();
    double begin = 0.0;
    for (const auto& [step, end] : std::initializer_list<std::pair<Step, double>>{
           { &Reader::TakeCorners, CornersReadEnd }, { &Reader::TakeVertices, VerticesReadEnd },
           { &Reader::TakeEdges, TrianglesReadEnd }, { &Reader::SetBounds, 1.0 } })
    {
      const PulsePart part(this->Progress, begin, end);
      begin = end;
      if (!this->Progress.HasStopped())
      {
        (this->*step)();
      }
    }
    return std::move(this->Origins);
  }

private:
  void TakeCorners();
  Id NumberOf(Id vertex);
  void TakeVertices();
  template <typename Value>
  void TakeOfVertices(std::vector<Value>& from, std::vector<Value>& to);
  void TakeEdges();
  template <typename Visit>
  void TakeHalves(std::vector<Id>& from, std::vector<Id>& to, Visit&& visit);
  Id TwinOf(Id edge, Id neighbor) const;
  void SetBounds();
  void SetFreedoms();
  Freedom FreedomOf(Id vertex, Id numberOfMarks, bool isAtOther) const;
  void SetIdealDegrees();
  std::vector<Id> CornersOfFixed() const;

  RelaxationMesh& Input;
  MutableMesh& Mesh;
  Pulse& Progress;
  std::vector<Id> Numbers; ///< vertex of the input -> of the mesh
  std::vector<Id> Origins;
  std::vector<Id> Marked; ///< half-edges that have a mark
  std::vector<Id> Border; ///< those that have no twin
};

void Reader::TakeVertices()
{
  MutableMesh& mesh = this->Mesh;
  const std::size_t size = this->Origins.size();
  this->TakeOfVertices(this->Input.Points, mesh.Points);
  this->TakeOfVertices(this->Input.Spacings, mesh.Spacings);
  this->TakeOfVertices(this->Input.Segments, mesh.Segments);
  ReserveWithRoom(size, mesh.Freedoms, mesh.IdealDegrees, mesh.IsEstimate);
  GrowInSteps(mesh.Freedoms, size, Freedom::Fixed, this->Progress);
  GrowInSteps(mesh.IdealDegrees, size, IdealInside, this->Progress);
  GrowInSteps(mesh.IsEstimate, size, std::uint8_t{ 0 }, this->Progress);
}

template <typename Value>
void Reader::TakeOfVertices(std::vector<Value>& from, std::vector<Value>& to)
{
  ReserveWithRoom(this->Origins.size(), to);
  this->Progress.ForEach(this->Origins.size(),
    [this, &from, &to](std::size_t vertex) { to.push_back(from[this->Origins[vertex]]); });
  const auto ofDomain = from.begin() + this->Mesh.Geometry.NumberOfVertices();
  std::vector<Value>(from.begin(), ofDomain).swap(from);
  this->Progress.Ask();
}

// Makes `to` as long as there are half-edges, and calls visit(edge, value) for the values of `from`,
// three a triangle, with the half-edges that they are of. Then `from` is given back.
template <typename Visit>
void Reader::TakeHalves(std::vector<Id>& from, std::vector<Id>& to, Visit&& visit)
{
  const std::size_t triangles = this->Input.Triangles.Regions.size();
  ReserveWithRoom(4 * triangles, to);
  if (GrowInSteps(to, 4 * triangles, NoId, this->Progress))
  {
    this->Progress.ForEach(triangles,
      [&from, &visit](std::size_t triangle)
      {
        for (std::size_t corner = 0; corner < 3; ++corner)
        {
          visit(static_cast<Id>(4 * triangle + corner), from[3 * triangle + corner]);
        }
      });
  }
  ReleaseInSteps(this->Progress, from);
}

// Numbers the vertices as it meets them.
void Reader::TakeCorners()
{
  MutableMesh& mesh = this->Mesh;
  const std::size_t size = this->Input.Points.size();
  this->Origins.reserve(size);
  ReserveWithRoom(size, mesh.VertexEdges, mesh.Degrees);
  if (GrowInSteps(this->Numbers, size, NoId, this->Progress))
  {
    this->TakeHalves(this->Input.Triangles.Corners, mesh.Corners,
      [this, &mesh](Id edge, Id corner)
      {
        const Id vertex = this->NumberOf(corner);
        mesh.Corners[edge] = vertex;
        mesh.VertexEdges[vertex] = edge;
        ++mesh.Degrees[vertex];
      });
  }
  ReleaseInSteps(this->Progress, this->Numbers);
}

Id Reader::NumberOf(Id vertex)
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

void Reader::TakeEdges()
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

// The half-edge of the neighbor that ends where `edge` starts.
Id Reader::TwinOf(Id edge, Id neighbor) const
{
  constexpr Id After[] = { 1, 2, 0, 0 };
  return 4 * neighbor + After[CornerOf(&this->Mesh.Corners[4 * neighbor], this->Mesh.Origin(edge))];
}

void Reader::SetBounds()
{
  this->SetFreedoms();
  this->SetIdealDegrees();
}

// Only vertices at which nothing but their own segment passes may slide.
void Reader::SetFreedoms()
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
std::vector<Id> Reader::CornersOfFixed() const
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

} // namespace

std::vector<Id> ReadMesh(RelaxationMesh& input, MutableMesh& mesh, Pulse& pulse)
{
  return Reader(input, mesh, pulse).Read();
}

} // namespace biting
