// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RegionFill.h"

#include "../Base/SortInSteps.h"

#include <algorithm> // for max, min
#include <cstdint>   // for flags
#include <utility>   // for move

namespace biting
{

namespace
{

// Where steps end, as shares of the time for a million points.
constexpr double FindingEnd = 0.15;
constexpr double BorderEnd = 0.17;
constexpr double FacesEnd = 0.35;
constexpr double RegionsEnd = 0.36;
constexpr double CountsEnd = 0.4;
constexpr double PointsEnd = 0.5;
constexpr double NumbersEnd = 0.75;
constexpr double NeighborsEnd = 0.92;

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
  const Id constraint = mesh.Mark(edge) / 2;
  const Point2& origin = mesh.PointAt(mesh.Origin(edge));
  const Point2& target = mesh.PointAt(mesh.Target(edge));
  const bool isReverse =
    mesh.PointAt(constraints.Ends[constraint]) < mesh.PointAt(constraints.Starts[constraint]);
  const bool isRight = (target < origin) != isReverse;
  return { edge, constraint, isRight ? target : origin, isReverse, isRight };
}

std::vector<BorderEdge> FindBorder(
  const HalfEdgeMesh& mesh, const ConstraintEdges& constraints, Pulse& pulse)
{
  const PulsePart part(pulse, 0.0, FindingEnd);
  std::vector<BorderEdge> border;
  pulse.ForEach(mesh.NumberOfTriangles,
    [&mesh, &constraints, &border](std::size_t triangle)
    {
      const Id first = HalfEdgeMesh::FirstEdge(static_cast<Id>(triangle));
      for (Id edge = first; mesh.HasMarks(static_cast<Id>(triangle)) && edge < first + 3; ++edge)
      {
        if (mesh.Mark(edge) != NoId)
        {
          border.push_back(MakeBorderEdge(mesh, constraints, edge));
        }
      }
    });
  return border;
}

/// All half-edges with a mark, along the constraints.
std::vector<BorderEdge> CollectBorder(
  const HalfEdgeMesh& mesh, const ConstraintEdges& constraints, Pulse& pulse)
{
  std::vector<BorderEdge> border = FindBorder(mesh, constraints, pulse);
  const PulsePart part(pulse, FindingEnd, BorderEnd);
  SortInSteps(border, ComesBefore, pulse);
  return border;
}

/// The faces that marks part: sets of triangles that share edges without one, united in the order
/// of triangles. A parent has no greater number than its triangle, and a root is its own.
class Faces
{
public:
  Faces(const HalfEdgeMesh& mesh, Pulse& pulse);

  Id Size() const { return this->Count; }
  Id FaceOf(Id triangle) const { return this->OfTriangle[triangle]; }

  /// The face beyond the convex hull.
  Id OuterFace() const { return this->Outer; }

  std::vector<Id> Take() { return std::move(this->OfTriangle); }

private:
  void UniteWithEarlier(const HalfEdgeMesh& mesh, Id triangle);
  Id RootOf(Id triangle);
  void Number(const HalfEdgeMesh& mesh, Id triangle);

  std::vector<Id> OfTriangle; ///< triangle -> parent, then face
  Id Count = 0;
  Id Outer = NoId;
};

Faces::Faces(const HalfEdgeMesh& mesh, Pulse& pulse)
{
  const PulsePart part(pulse, BorderEnd, FacesEnd);
  this->OfTriangle.reserve(mesh.NumberOfTriangles);
  pulse.ForEach(mesh.NumberOfTriangles,
    [this, &mesh](std::size_t t) { this->UniteWithEarlier(mesh, static_cast<Id>(t)); });
  pulse.ForEach(this->OfTriangle.size(),
    [this, &mesh](std::size_t t) { this->Number(mesh, static_cast<Id>(t)); });
}

void Faces::UniteWithEarlier(const HalfEdgeMesh& mesh, Id triangle)
{
  this->OfTriangle.push_back(triangle);
  const Id first = HalfEdgeMesh::FirstEdge(triangle);
  Id root = triangle;
  for (Id edge = first; edge < first + 3; ++edge)
  {
    const Id neighbor = HalfEdgeMesh::TriangleOf(mesh.Twins[edge]);
    if (neighbor < triangle && mesh.Mark(edge) == NoId)
    {
      const Id other = this->RootOf(neighbor);
      const Id least = std::min(root, other);
      this->OfTriangle[root] = this->OfTriangle[other] = least;
      root = least;
    }
  }
}

Id Faces::RootOf(Id triangle)
{
  std::vector<Id>& parents = this->OfTriangle;
  while (parents[triangle] != triangle)
  {
    parents[triangle] = parents[parents[triangle]];
    triangle = parents[triangle];
  }
  return triangle;
}

/// Parents come before: theirs are faces by then.
void Faces::Number(const HalfEdgeMesh& mesh, Id triangle)
{
  const Id parent = this->OfTriangle[triangle];
  const Id face = parent == triangle ? this->Count++ : this->OfTriangle[parent];
  this->OfTriangle[triangle] = face;
  if (this->Outer == NoId && mesh.IsGhost(triangle))
  {
    this->Outer = face;
  }
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
  const HalfEdgeMesh& mesh, const std::vector<BorderEdge>& border, const Faces& faces, Pulse& pulse)
{
  FaceGraph graph;
  graph.Begins.assign(faces.Size() + 1, 0);
  std::vector<Step> steps(border.size());
  pulse.ForEach(border.size(),
    [&mesh, &border, &faces, &graph, &steps](std::size_t k)
    {
      const Id edge = border[k].Edge;
      const Id from = faces.FaceOf(HalfEdgeMesh::TriangleOf(edge));
      const Id to = faces.FaceOf(HalfEdgeMesh::TriangleOf(mesh.Twins[edge]));
      steps[k] = { from, to, static_cast<std::uint8_t>(mesh.Mark(edge) & 1) };
      ++graph.Begins[from + 1];
    });
  for (Id face = 0; face < faces.Size() && pulse.Beat(); ++face)
  {
    graph.Begins[face + 1] += graph.Begins[face];
  }
  graph.Steps.resize(steps.size());
  std::vector<Id> next = graph.Begins;
  pulse.ForEach(steps.size(),
    [&graph, &steps, &next](std::size_t k) { graph.Steps[next[steps[k].From]++] = steps[k]; });
  return graph;
}

/// Face -> 1 where it is an odd number of boundaries away from the outer face.
std::vector<std::uint8_t> FindInside(const FaceGraph& graph, Id outerFace, Pulse& pulse)
{
  constexpr std::uint8_t unknown = 2;
  std::vector<std::uint8_t> isInside(graph.Begins.size() - 1, unknown);
  std::vector<Id> queue{ outerFace };
  isInside[outerFace] = 0;
  for (std::size_t next = 0; next < queue.size(); ++next)
  {
    const Id face = queue[next];
    for (Id i = graph.Begins[face]; i < graph.Begins[face + 1] && pulse.Beat(); ++i)
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

Regions NumberRegions(
  const HalfEdgeMesh& mesh, const std::vector<BorderEdge>& border, const Faces& faces, Pulse& pulse)
{
  const PulsePart part(pulse, FacesEnd, RegionsEnd);
  const std::vector<std::uint8_t> isInside =
    FindInside(MakeFaceGraph(mesh, border, faces, pulse), faces.OuterFace(), pulse);
  Regions regions;
  regions.OfFace.assign(faces.Size(), NoId);
  for (std::size_t k = 0; k < border.size() && pulse.Beat(); ++k)
  {
    const Id face = faces.FaceOf(HalfEdgeMesh::TriangleOf(border[k].Edge));
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
  /// `numbers` are the faces of the triangles.
  Writer(HalfEdgeMesh& mesh, const std::vector<Id>& order, std::vector<Id>&& numbers, Pulse& pulse)
    : Mesh(mesh)
    , Order(order)
    , Beats(pulse)
    , Numbers(std::move(numbers))
  {
  }

  /// Empty on abort.
  Triangulation Write(const Regions& regions);

private:
  Id LastCorner(std::size_t triangle) const;
  std::vector<Id> TakeRegions(const Regions& regions);
  void TakePoints();
  void NumberTriangles(std::vector<Id> next);
  std::vector<Id> SortByLastCorner();
  void WriteTriangles();
  template <typename Step>
  void ForEachHalf(Step&& step);

  HalfEdgeMesh& Mesh;
  const std::vector<Id>& Order;
  Pulse& Beats;
  std::vector<Id> Numbers; ///< triangle of the mesh -> of the result, NoId outside
  std::vector<Id> Inside;  ///< triangle of the result -> of the mesh
  Id LastPoint = 0;        ///< at a corner
  Triangulation Result;
};

Triangulation Writer::Write(const Regions& regions)
{
  std::vector<Id> sizes = this->TakeRegions(regions);
  this->TakePoints();
  this->NumberTriangles(std::move(sizes));
  this->WriteTriangles();
  return this->Beats.HasStopped() ? Triangulation() : std::move(this->Result);
}

/// Numbers become those of the regions; returns the size of region r as entry r + 1.
std::vector<Id> Writer::TakeRegions(const Regions& regions)
{
  const PulsePart part(this->Beats, RegionsEnd, CountsEnd);
  std::vector<Id> sizes(regions.Size + 1, 0);
  this->Beats.ForEach(this->Numbers.size(),
    [this, &regions, &sizes](std::size_t triangle)
    {
      const Id region = regions.OfFace[this->Numbers[triangle]];
      this->Numbers[triangle] = region;
      if (region != NoId)
      {
        ++sizes[region + 1];
      }
    });
  return sizes;
}

/// Corners become points of the caller.
void Writer::TakePoints()
{
  const PulsePart part(this->Beats, CountsEnd, PointsEnd);
  this->Beats.ForEach(HalfEdgeMesh::FirstEdge(this->Mesh.NumberOfTriangles),
    [this](std::size_t edge)
    {
      Id& corner = this->Mesh.Corners[edge];
      corner = corner == NoId ? NoId : this->Order[corner];
      this->LastPoint = std::max(this->LastPoint, corner);
    });
}

/// Region by region, within by last corners; fills Regions of the result.
void Writer::NumberTriangles(std::vector<Id> next)
{
  const PulsePart part(this->Beats, PointsEnd, NumbersEnd);
  for (std::size_t region = 0; region + 1 < next.size() && !this->Beats.HasStopped(); ++region)
  {
    this->Result.Regions.resize(
      this->Result.Regions.size() + next[region + 1], static_cast<Id>(region));
    next[region + 1] += next[region];
  }
  const std::vector<Id> sorted = this->SortByLastCorner();
  GrowInSteps(this->Inside, sorted.size(), NoId, this->Beats);
  this->Beats.ForEach(sorted.size(),
    [this, &next, &sorted](std::size_t place)
    {
      Id& number = this->Numbers[sorted[place]];
      number = next[number]++;
      this->Inside[number] = sorted[place];
    });
}

/// The triangles inside, by counting.
std::vector<Id> Writer::SortByLastCorner()
{
  std::vector<Id> begins;
  std::vector<Id> sorted;
  if (!GrowInSteps(begins, static_cast<std::size_t>(this->LastPoint) + 2, Id(0), this->Beats) ||
    !GrowInSteps(sorted, this->Result.Regions.size(), NoId, this->Beats))
  {
    return {};
  }
  this->Beats.ForEach(this->Numbers.size(),
    [this, &begins](std::size_t triangle)
    {
      if (this->Numbers[triangle] != NoId)
      {
        ++begins[this->LastCorner(triangle) + 1];
      }
    });
  this->Beats.ForEach(
    begins.size() - 1, [&begins](std::size_t point) { begins[point + 1] += begins[point]; });
  this->Beats.ForEach(this->Numbers.size(),
    [this, &begins, &sorted](std::size_t triangle)
    {
      if (this->Numbers[triangle] != NoId)
      {
        sorted[begins[this->LastCorner(triangle)]++] = static_cast<Id>(triangle);
      }
    });
  return sorted;
}

Id Writer::LastCorner(std::size_t triangle) const
{
  const Id* corners = &this->Mesh.Corners[HalfEdgeMesh::FirstEdge(static_cast<Id>(triangle))];
  return std::max({ corners[0], corners[1], corners[2] });
}

/// In two passes: what the first one reads is given back before the second one needs memory.
void Writer::WriteTriangles()
{
  const std::size_t size = 3 * this->Inside.size();
  {
    const PulsePart part(this->Beats, NumbersEnd, NeighborsEnd);
    this->Result.Neighbors.reserve(size);
    this->Result.Constraints.reserve(size);
    this->ForEachHalf(
      [this](Id edge)
      {
        const Id mark = this->Mesh.Mark(edge);
        const Id beyond = HalfEdgeMesh::TriangleOf(this->Mesh.Twins[edge]);
        this->Result.Constraints.push_back(mark == NoId ? NoId : mark / 2);
        this->Result.Neighbors.push_back(this->Numbers[beyond]);
      });
  }
  ReleaseInSteps(this->Beats, this->Mesh.Marks, this->Mesh.Twins, this->Numbers);
  const PulsePart part(this->Beats, NeighborsEnd, 1.0);
  this->Result.Corners.reserve(size);
  this->ForEachHalf([this](Id edge) { this->Result.Corners.push_back(this->Mesh.Corners[edge]); });
  ReleaseInSteps(this->Beats, this->Mesh.Corners);
}

/// Does step(edge) for the half-edges of all triangles of the result, in their order.
template <typename Step>
void Writer::ForEachHalf(Step&& step)
{
  this->Beats.ForEach(this->Inside.size(),
    [this, &step](std::size_t number)
    {
      const Id first = HalfEdgeMesh::FirstEdge(this->Inside[number]);
      for (Id edge = first; edge < first + 3; ++edge)
      {
        step(edge);
      }
    });
}

} // namespace

Triangulation TakeInside(HalfEdgeMesh& mesh, const ConstraintEdges& constraints,
  const std::vector<Id>& order, Pulse& pulse)
{
  const std::vector<BorderEdge> border = CollectBorder(mesh, constraints, pulse);
  ReleaseInSteps(pulse, mesh.Points, mesh.VertexEdges);
  Faces faces(mesh, pulse);
  if (pulse.HasStopped())
  {
    return {};
  }
  const Regions regions = NumberRegions(mesh, border, faces, pulse);
  return Writer(mesh, order, faces.Take(), pulse).Write(regions);
}

} // namespace biting
