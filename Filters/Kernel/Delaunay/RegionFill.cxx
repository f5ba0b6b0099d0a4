// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RegionFill.h"

#include <algorithm> // for sort
#include <cstdint>   // for flags

namespace biting
{

namespace
{

/// The faces between constraints, the outside included. Face f has the triangles
/// Triangles[Begins[f]] .. Triangles[Begins[f + 1] - 1].
struct Faces
{
  std::vector<Id> FaceOf; ///< triangle -> face
  std::vector<Id> Triangles;
  std::vector<Id> Begins;
  std::vector<std::uint8_t> IsInside;

  Id Size() const { return static_cast<Id>(this->IsInside.size()); }
};

/// Where a face may begin: a triangle beyond a constraint.
struct Seed
{
  Id Triangle = NoId;
  std::uint8_t IsInside = 0;
};

Id FindGhost(const HalfEdgeMesh& mesh)
{
  Id triangle = 0;
  while (!mesh.IsGhost(triangle))
  {
    ++triangle;
  }
  return triangle;
}

/// Adds the triangles that can be reached from the seed without crossing a constraint; what lies
/// beyond the constraints becomes seeds.
void FloodFace(
  const HalfEdgeMesh& mesh, Seed seed, Faces& faces, std::vector<Seed>& seeds, Pulse& pulse)
{
  const Id face = faces.Size();
  faces.IsInside.push_back(seed.IsInside);
  faces.FaceOf[seed.Triangle] = face;
  std::size_t next = faces.Triangles.size();
  faces.Triangles.push_back(seed.Triangle);
  for (; next < faces.Triangles.size() && pulse.Beat(); ++next)
  {
    const Id first = HalfEdgeMesh::FirstEdge(faces.Triangles[next]);
    for (Id edge = first; edge < first + 3; ++edge)
    {
      const Id neighbor = HalfEdgeMesh::TriangleOf(mesh.Twins[edge]);
      const Id mark = mesh.Marks[edge];
      if (faces.FaceOf[neighbor] != NoId)
      {
        continue;
      }
      if (mark != NoId)
      {
        seeds.push_back({ neighbor, static_cast<std::uint8_t>(seed.IsInside ^ (mark & 1)) });
        continue;
      }
      faces.FaceOf[neighbor] = face;
      faces.Triangles.push_back(neighbor);
    }
  }
  faces.Begins.push_back(static_cast<Id>(faces.Triangles.size()));
}

Faces FloodFaces(const HalfEdgeMesh& mesh, Pulse& pulse)
{
  Faces faces;
  faces.FaceOf.assign(mesh.NumberOfTriangles, NoId);
  faces.Triangles.reserve(mesh.NumberOfTriangles);
  faces.Begins.push_back(0);
  std::vector<Seed> seeds{ { FindGhost(mesh), 0 } };
  for (std::size_t next = 0; next < seeds.size() && !pulse.HasStopped(); ++next)
  {
    if (faces.FaceOf[seeds[next].Triangle] == NoId)
    {
      FloodFace(mesh, seeds[next], faces, seeds, pulse);
    }
  }
  return faces;
}

/// A half-edge with a mark, and what decides when one comes to it along the constraints.
struct BorderEdge
{
  Id Constraint = NoId;
  Point2 Place;           ///< the end that is nearer to the constraint's start
  bool IsReverse = false; ///< the constraint leads from greater points to less ones
  bool IsRight = false;   ///< the triangle is on the right of the constraint
  Id Face = NoId;
};

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

/// Ends are compared along the constraint by the order of points: exact, as they are collinear.
BorderEdge MakeBorderEdge(
  const HalfEdgeMesh& mesh, const ConstraintEdges& constraints, Id edge, Id face)
{
  const Id constraint = mesh.Marks[edge] / 2;
  const Point2& origin = mesh.PointAt(mesh.Origin(edge));
  const Point2& target = mesh.PointAt(mesh.Target(edge));
  const bool isReverse =
    mesh.PointAt(constraints.Ends[constraint]) < mesh.PointAt(constraints.Starts[constraint]);
  const bool isRight = (target < origin) != isReverse;
  return { constraint, isRight ? target : origin, isReverse, isRight, face };
}

std::vector<BorderEdge> CollectBorder(
  const HalfEdgeMesh& mesh, const ConstraintEdges& constraints, const Faces& faces)
{
  std::vector<BorderEdge> border;
  for (Id triangle = 0; triangle < mesh.NumberOfTriangles; ++triangle)
  {
    const Id face = faces.FaceOf[triangle];
    const Id first = HalfEdgeMesh::FirstEdge(triangle);
    for (Id edge = first; edge < first + 3; ++edge)
    {
      if (faces.IsInside[face] != 0 && mesh.Marks[edge] != NoId)
      {
        border.push_back(MakeBorderEdge(mesh, constraints, edge, face));
      }
    }
  }
  std::sort(border.begin(), border.end(), ComesBefore);
  return border;
}

/// Region -> face.
std::vector<Id> NumberRegions(
  const HalfEdgeMesh& mesh, const ConstraintEdges& constraints, const Faces& faces)
{
  std::vector<Id> regions;
  std::vector<std::uint8_t> isNumbered(faces.IsInside.size(), 0);
  for (const BorderEdge& edge : CollectBorder(mesh, constraints, faces))
  {
    if (isNumbered[edge.Face] == 0)
    {
      isNumbered[edge.Face] = 1;
      regions.push_back(edge.Face);
    }
  }
  return regions;
}

/// Copies triangles out: renumbered, without gaps and ghosts.
class Writer
{
public:
  Writer(const HalfEdgeMesh& mesh, const Faces& faces, const std::vector<Id>& order)
    : Mesh(mesh)
    , AllFaces(faces)
    , Order(order)
    , Numbers(mesh.NumberOfTriangles, NoId)
  {
  }

  Triangulation Write(const std::vector<Id>& regions, Pulse& pulse);

private:
  void Number(const std::vector<Id>& regions);
  void WriteTriangle(Id triangle, Id region);
  Id NumberOf(Id edge) const { return this->Numbers[HalfEdgeMesh::TriangleOf(edge)]; }

  const HalfEdgeMesh& Mesh;
  const Faces& AllFaces;
  const std::vector<Id>& Order;
  std::vector<Id> Numbers; ///< triangle -> triangle of the result
  Id NumberOfTriangles = 0;
  Triangulation Result;
};

Triangulation Writer::Write(const std::vector<Id>& regions, Pulse& pulse)
{
  this->Number(regions);
  const std::size_t size = this->NumberOfTriangles;
  this->Result.Corners.reserve(3 * size);
  this->Result.Neighbors.reserve(3 * size);
  this->Result.Constraints.reserve(3 * size);
  this->Result.Regions.reserve(size);
  for (std::size_t region = 0; region < regions.size(); ++region)
  {
    const Id face = regions[region];
    for (Id i = this->AllFaces.Begins[face]; i < this->AllFaces.Begins[face + 1]; ++i)
    {
      if (!pulse.Beat())
      {
        return {};
      }
      this->WriteTriangle(this->AllFaces.Triangles[i], static_cast<Id>(region));
    }
  }
  return std::move(this->Result);
}

void Writer::Number(const std::vector<Id>& regions)
{
  for (const Id face : regions)
  {
    for (Id i = this->AllFaces.Begins[face]; i < this->AllFaces.Begins[face + 1]; ++i)
    {
      this->Numbers[this->AllFaces.Triangles[i]] = this->NumberOfTriangles++;
    }
  }
}

void Writer::WriteTriangle(Id triangle, Id region)
{
  const Id first = HalfEdgeMesh::FirstEdge(triangle);
  for (Id edge = first; edge < first + 3; ++edge)
  {
    const Id mark = this->Mesh.Marks[edge];
    this->Result.Corners.push_back(this->Order[this->Mesh.Corners[edge]]);
    this->Result.Neighbors.push_back(this->NumberOf(this->Mesh.Twins[edge]));
    this->Result.Constraints.push_back(mark == NoId ? NoId : mark / 2);
  }
  this->Result.Regions.push_back(region);
}

} // namespace

Triangulation TakeInside(const HalfEdgeMesh& mesh, const ConstraintEdges& constraints,
  const std::vector<Id>& order, Pulse& pulse)
{
  const Faces faces = FloodFaces(mesh, pulse);
  if (pulse.HasStopped())
  {
    return {};
  }
  const std::vector<Id> regions = NumberRegions(mesh, constraints, faces);
  return Writer(mesh, faces, order).Write(regions, pulse);
}

} // namespace biting
