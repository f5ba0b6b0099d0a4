// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Triangulation.h"

#include "../Predicates/Predicates.h"

namespace biting
{

namespace
{

std::string Violation(const char* text, Id triangle, Id corner)
{
  return "triangle " + std::to_string(triangle) + ", corner " + std::to_string(corner) + ": " +
    text;
}

/// Looks at triangles one by one; each question returns a violation, or nullptr.
class Checker
{
public:
  Checker(const std::vector<Point2>& points, const Triangulation& mesh, bool isDelaunay)
    : Points(points)
    , Mesh(mesh)
    , IsDelaunay(isDelaunay)
  {
  }

  const char* CheckSizes() const;
  const char* CheckTriangle(Id triangle) const;
  const char* CheckEdge(Id triangle, Id corner) const;

private:
  const char* CheckInnerEdge(Id triangle, Id corner, Id neighbor) const;
  Id CornerAt(Id triangle, Id corner) const
  {
    return this->Mesh.Corners[3 * triangle + corner % 3];
  }
  const Point2& PointAt(Id triangle, Id corner) const
  {
    return this->Points[this->CornerAt(triangle, corner)];
  }
  Id CornerFacing(Id triangle, Id neighbor) const;

  const std::vector<Point2>& Points;
  const Triangulation& Mesh;
  bool IsDelaunay;
};

const char* Checker::CheckSizes() const
{
  const std::size_t size = this->Mesh.Corners.size();
  const bool isRight = size % 3 == 0 && this->Mesh.Neighbors.size() == size &&
    this->Mesh.Constraints.size() == size && this->Mesh.Regions.size() == size / 3;
  return isRight ? nullptr : "sizes of the arrays do not agree";
}

const char* Checker::CheckTriangle(Id triangle) const
{
  const Id numberOfPoints = static_cast<Id>(this->Points.size());
  for (Id k = 0; k < 3; ++k)
  {
    const Id vertex = this->CornerAt(triangle, k);
    const Id neighbor = this->Mesh.Neighbors[3 * triangle + k];
    if (vertex < 0 || vertex >= numberOfPoints)
    {
      return "the corner is no point";
    }
    if (neighbor < NoId || neighbor >= this->Mesh.NumberOfTriangles() || neighbor == triangle)
    {
      return "the neighbor is no other triangle";
    }
  }
  if (this->Mesh.Regions[triangle] < 0)
  {
    return "the region is negative";
  }
  const int turn =
    Orient2D(this->PointAt(triangle, 0), this->PointAt(triangle, 1), this->PointAt(triangle, 2));
  return turn > 0 ? nullptr : "the corners are not counterclockwise";
}

const char* Checker::CheckEdge(Id triangle, Id corner) const
{
  const Id neighbor = this->Mesh.Neighbors[3 * triangle + corner];
  if (neighbor != NoId)
  {
    return this->CheckInnerEdge(triangle, corner, neighbor);
  }
  const bool hasConstraint = this->Mesh.Constraints[3 * triangle + corner] != NoId;
  return hasConstraint ? nullptr : "no constraint on the border of the mesh";
}

const char* Checker::CheckInnerEdge(Id triangle, Id corner, Id neighbor) const
{
  const Id facing = this->CornerFacing(neighbor, triangle);
  if (facing == NoId ||
    this->CornerAt(triangle, corner + 1) != this->CornerAt(neighbor, facing + 2) ||
    this->CornerAt(triangle, corner + 2) != this->CornerAt(neighbor, facing + 1))
  {
    return "the neighbor does not share the edge";
  }
  const Id constraint = this->Mesh.Constraints[3 * triangle + corner];
  if (constraint != this->Mesh.Constraints[3 * neighbor + facing])
  {
    return "the two sides of the edge have different constraints";
  }
  if (constraint != NoId)
  {
    return nullptr;
  }
  if (this->Mesh.Regions[triangle] != this->Mesh.Regions[neighbor])
  {
    return "the region changes where there is no constraint";
  }
  const bool isLocallyDelaunay = !this->IsDelaunay ||
    InCircle(this->PointAt(triangle, 0), this->PointAt(triangle, 1), this->PointAt(triangle, 2),
      this->PointAt(neighbor, facing)) <= 0;
  return isLocallyDelaunay ? nullptr : "the edge is not locally Delaunay";
}

/// The corner of `triangle` opposite its edge to `neighbor`. Where two triangles share two edges
/// they are not both counterclockwise, which is found out before.
Id Checker::CornerFacing(Id triangle, Id neighbor) const
{
  for (Id k = 0; k < 3; ++k)
  {
    if (this->Mesh.Neighbors[3 * triangle + k] == neighbor)
    {
      return k;
    }
  }
  return NoId;
}

std::string CheckAllTriangles(const Checker& checker, Id numberOfTriangles)
{
  for (Id t = 0; t < numberOfTriangles; ++t)
  {
    if (const char* text = checker.CheckTriangle(t))
    {
      return Violation(text, t, 0);
    }
  }
  return {};
}

std::string CheckAllEdges(const Checker& checker, Id numberOfTriangles)
{
  for (Id t = 0; t < numberOfTriangles; ++t)
  {
    for (Id k = 0; k < 3; ++k)
    {
      if (const char* text = checker.CheckEdge(t, k))
      {
        return Violation(text, t, k);
      }
    }
  }
  return {};
}

} // namespace

std::string CheckTriangulation(
  const std::vector<Point2>& points, const Triangulation& mesh, const TriangulationOptions& options)
{
  const Checker checker(points, mesh, options.Phi >= 1.0);
  if (const char* text = checker.CheckSizes())
  {
    return text;
  }
  const std::string violation = CheckAllTriangles(checker, mesh.NumberOfTriangles());
  return violation.empty() ? CheckAllEdges(checker, mesh.NumberOfTriangles()) : violation;
}

} // namespace biting
