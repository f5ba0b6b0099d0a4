// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RegionFill.h"

#include <algorithm> // for max, min, sort, stable_sort
#include <cstdint>   // for flags
#include <utility>   // for move

namespace biting
{

namespace
{

/// A half-edge with a mark, and what decides when one comes to it along the constraints.
struct BorderEdge
{
  Id Edge = NoId;
  Id Constraint = NoId;
  Point2 Place;           ///< the end that is nearer to the constraint's start
  bool IsReverse = false; ///< the constraint leads from greater points to less ones
  bool IsRight = false;   ///< the triangle is on the right of the constraint
};

/// Ends are compared along the constraint by the order of points: exact, as they are collinear.
bool ComesBefore(const BorderEdge& a, const BorderEdge& b)
{
  if (a.Constraint != b.Constraint)
  {
    return a.Constraint < b.Constraint;
  }
  if (a.Place != b.Place)
  {
    return (a.Place < b.Place) != a.IsReverse;
  }
  return !a.IsRight && b.IsRight;
}

BorderEdge MakeBorderEdge(const HalfEdgeMesh& mesh, const ConstraintEdges& constraints, Id edge)
{
  const Id constraint = mesh.Marks[edge] / 2;
  const Point2& origin = mesh.PointAt(mesh.Origin(edge));
  const Point2& target = mesh.PointAt(mesh.Target(edge));
  const bool isReverse =
    mesh.PointAt(constraints.Ends[constraint]) < mesh.PointAt(constraints.Starts[constraint]);
  const bool isRight = (target < origin) != isReverse;
  return { edge, constraint, isRight ? target : origin, isReverse, isRight };
}

/// All half-edges with a mark, along the constraints.
std::vector<BorderEdge> CollectBorder(const HalfEdgeMesh& mesh, const ConstraintEdges& constraints)
{
  std::vector<BorderEdge> border;
  for (Id edge = 0; edge < HalfEdgeMesh::FirstEdge(mesh.NumberOfTriangles); ++edge)
  {
    if (mesh.Marks[edge] != NoId)
    {
      border.push_back(MakeBorderEdge(mesh, constraints, edge));
    }
  }
  std::sort(border.begin(), border.end(), ComesBefore);
  return border;
}

/// All triangles, breadth first from all borders at once: layer by layer. Waves that meet within a
/// face become one; a wave stands for the others of its face.
class Flood
{
public:
  Flood(const HalfEdgeMesh& mesh, const std::vector<BorderEdge>& border, Pulse& pulse);

  Id Size() const { return static_cast<Id>(this->Triangles.size()); }
  Id NumberOfWaves() const { return static_cast<Id>(this->Parents.size()); }
  Id TriangleAt(Id place) const { return this->Triangles[place]; }
  Id PlaceOf(Id triangle) const { return this->Places[triangle]; }

  /// The face of the triangle at a place: the number of one of its waves.
  Id FaceAt(Id place) { return this->FaceOfWave(this->Waves[place]); }
  Id FaceOf(Id triangle) { return this->FaceAt(this->Places[triangle]); }

  /// The face beyond the convex hull.
  Id OuterFace() { return this->FaceOf(this->Ghost); }

private:
  void Start(Id triangle);
  void Spread(Id place);
  void Add(Id triangle, Id wave);
  void Unite(Id wave, Id other);
  Id FaceOfWave(Id wave);

  const HalfEdgeMesh& Mesh;
  Id Ghost = 0;
  std::vector<Id> Triangles; ///< place -> triangle
  std::vector<Id> Places;    ///< triangle -> place
  std::vector<Id> Waves;     ///< place -> wave
  std::vector<Id> Parents;   ///< wave -> a wave of the same face, not greater
};

Flood::Flood(const HalfEdgeMesh& mesh, const std::vector<BorderEdge>& border, Pulse& pulse)
  : Mesh(mesh)
  , Places(mesh.NumberOfTriangles, NoId)
{
  this->Triangles.reserve(mesh.NumberOfTriangles);
  this->Waves.reserve(mesh.NumberOfTriangles);
  for (const BorderEdge& edge : border)
  {
    this->Start(HalfEdgeMesh::TriangleOf(edge.Edge));
  }
  while (!mesh.IsGhost(this->Ghost))
  {
    ++this->Ghost;
  }
  this->Start(this->Ghost);
  for (Id place = 0; place < this->Size() && pulse.Beat(); ++place)
  {
    this->Spread(place);
  }
}

void Flood::Start(Id triangle)
{
  if (this->Places[triangle] == NoId)
  {
    this->Parents.push_back(this->NumberOfWaves());
    this->Add(triangle, this->NumberOfWaves() - 1);
  }
}

void Flood::Spread(Id place)
{
  const Id wave = this->Waves[place];
  const Id first = HalfEdgeMesh::FirstEdge(this->Triangles[place]);
  for (Id edge = first; edge < first + 3; ++edge)
  {
    if (this->Mesh.Marks[edge] != NoId)
    {
      continue;
    }
    const Id neighbor = HalfEdgeMesh::TriangleOf(this->Mesh.Twins[edge]);
    if (this->Places[neighbor] == NoId)
    {
      this->Add(neighbor, wave);
    }
    else if (this->Waves[this->Places[neighbor]] != wave)
    {
      this->Unite(wave, this->Waves[this->Places[neighbor]]);
    }
  }
}

void Flood::Add(Id triangle, Id wave)
{
  this->Places[triangle] = this->Size();
  this->Triangles.push_back(triangle);
  this->Waves.push_back(wave);
}

void Flood::Unite(Id wave, Id other)
{
  const Id face = this->FaceOfWave(wave);
  const Id otherFace = this->FaceOfWave(other);
  this->Parents[std::max(face, otherFace)] = std::min(face, otherFace);
}

Id Flood::FaceOfWave(Id wave)
{
  while (this->Parents[wave] != wave)
  {
    this->Parents[wave] = this->Parents[this->Parents[wave]];
    wave = this->Parents[wave];
  }
  return wave;
}

/// A step from face to face, across a half-edge with a mark.
struct Step
{
  Id From = NoId;
  Id To = NoId;
  std::uint8_t IsOdd = 0;
};

/// The steps of all borders by the face they start from; those from face f are
/// Steps[Begins[f]] .. Steps[Begins[f + 1] - 1].
struct FaceGraph
{
  std::vector<Step> Steps;
  std::vector<Id> Begins;
};

FaceGraph MakeFaceGraph(
  const HalfEdgeMesh& mesh, const std::vector<BorderEdge>& border, Flood& flood)
{
  FaceGraph graph;
  graph.Begins.assign(flood.NumberOfWaves() + 1, 0);
  for (const BorderEdge& edge : border)
  {
    const Id from = flood.FaceOf(HalfEdgeMesh::TriangleOf(edge.Edge));
    const Id to = flood.FaceOf(HalfEdgeMesh::TriangleOf(mesh.Twins[edge.Edge]));
    graph.Steps.push_back({ from, to, static_cast<std::uint8_t>(mesh.Marks[edge.Edge] & 1) });
    ++graph.Begins[from + 1];
  }
  for (Id face = 0; face < flood.NumberOfWaves(); ++face)
  {
    graph.Begins[face + 1] += graph.Begins[face];
  }
  std::stable_sort(graph.Steps.begin(), graph.Steps.end(),
    [](const Step& a, const Step& b) { return a.From < b.From; });
  return graph;
}

/// Face -> 1 where it is an odd number of boundaries away from the outer face.
std::vector<std::uint8_t> FindInside(const FaceGraph& graph, Id outerFace)
{
  constexpr std::uint8_t unknown = 2;
  std::vector<std::uint8_t> isInside(graph.Begins.size() - 1, unknown);
  std::vector<Id> queue{ outerFace };
  isInside[outerFace] = 0;
  for (std::size_t next = 0; next < queue.size(); ++next)
  {
    const Id face = queue[next];
    for (Id i = graph.Begins[face]; i < graph.Begins[face + 1]; ++i)
    {
      const Step& step = graph.Steps[i];
      if (isInside[step.To] == unknown)
      {
        isInside[step.To] = isInside[face] ^ step.IsOdd;
        queue.push_back(step.To);
      }
    }
  }
  return isInside;
}

/// The regions: the faces inside.
struct Regions
{
  std::vector<Id> OfFace; ///< face -> region, NoId outside
  Id Size = 0;
};

Regions NumberRegions(const HalfEdgeMesh& mesh, const std::vector<BorderEdge>& border, Flood& flood)
{
  const std::vector<std::uint8_t> isInside =
    FindInside(MakeFaceGraph(mesh, border, flood), flood.OuterFace());
  Regions regions;
  regions.OfFace.assign(flood.NumberOfWaves(), NoId);
  for (const BorderEdge& edge : border)
  {
    const Id face = flood.FaceOf(HalfEdgeMesh::TriangleOf(edge.Edge));
    if (isInside[face] == 1 && regions.OfFace[face] == NoId)
    {
      regions.OfFace[face] = regions.Size++;
    }
  }
  return regions;
}

/// Copies triangles out: renumbered, without gaps and ghosts.
class Writer
{
public:
  Writer(const HalfEdgeMesh& mesh, const std::vector<Id>& order, Flood& flood)
    : Mesh(mesh)
    , Order(order)
    , Source(flood)
  {
  }

  Triangulation Write(const Regions& regions, Pulse& pulse);

private:
  void NumberTriangles(const Regions& regions);
  void WriteTriangle(Id place);

  const HalfEdgeMesh& Mesh;
  const std::vector<Id>& Order;
  Flood& Source;
  std::vector<Id> Numbers; ///< place -> triangle of the result, NoId outside
  Triangulation Result;
};

Triangulation Writer::Write(const Regions& regions, Pulse& pulse)
{
  this->NumberTriangles(regions);
  const std::size_t size = this->Result.Regions.size();
  this->Result.Corners.resize(3 * size);
  this->Result.Neighbors.resize(3 * size);
  this->Result.Constraints.resize(3 * size);
  for (Id place = 0; place < this->Source.Size() && pulse.Beat(); ++place)
  {
    if (this->Numbers[place] != NoId)
    {
      this->WriteTriangle(place);
    }
  }
  return pulse.HasStopped() ? Triangulation() : std::move(this->Result);
}

/// Region by region, in the order of the flood within; fills Regions of the result.
void Writer::NumberTriangles(const Regions& regions)
{
  this->Numbers.reserve(this->Source.Size());
  std::vector<Id> begins(regions.Size + 1, 0);
  for (Id place = 0; place < this->Source.Size(); ++place)
  {
    this->Numbers.push_back(regions.OfFace[this->Source.FaceAt(place)]);
    if (this->Numbers.back() != NoId)
    {
      ++begins[this->Numbers.back() + 1];
    }
  }
  for (Id region = 0; region < regions.Size; ++region)
  {
    this->Result.Regions.resize(this->Result.Regions.size() + begins[region + 1], region);
    begins[region + 1] += begins[region];
  }
  for (Id& number : this->Numbers)
  {
    number = number == NoId ? NoId : begins[number]++;
  }
}

void Writer::WriteTriangle(Id place)
{
  const Id first = HalfEdgeMesh::FirstEdge(this->Source.TriangleAt(place));
  const std::size_t number = this->Numbers[place];
  for (Id k = 0; k < 3; ++k)
  {
    const Id neighbor = HalfEdgeMesh::TriangleOf(this->Mesh.Twins[first + k]);
    const Id mark = this->Mesh.Marks[first + k];
    this->Result.Corners[3 * number + k] = this->Order[this->Mesh.Corners[first + k]];
    this->Result.Neighbors[3 * number + k] = this->Numbers[this->Source.PlaceOf(neighbor)];
    this->Result.Constraints[3 * number + k] = mark == NoId ? NoId : mark / 2;
  }
}

} // namespace

Triangulation TakeInside(const HalfEdgeMesh& mesh, const ConstraintEdges& constraints,
  const std::vector<Id>& order, Pulse& pulse)
{
  const std::vector<BorderEdge> border = CollectBorder(mesh, constraints);
  Flood flood(mesh, border, pulse);
  if (pulse.HasStopped())
  {
    return {};
  }
  const Regions regions = NumberRegions(mesh, border, flood);
  return Writer(mesh, order, flood).Write(regions, pulse);
}

} // namespace biting
