// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RegularTriangulation.h"

#include "../../Predicates/Predicates.h"
#include "VertexStar.h"

#include <algorithm> // for find, remove, sort
#include <array>     // for the first cells

namespace biting
{

namespace
{

/// Marks of cells.
constexpr std::uint8_t Unseen = 0;
constexpr std::uint8_t InCavity = 1;
constexpr std::uint8_t Outside = 2;

std::size_t Index(Id id)
{
  return TetMesh::Index(id);
}

Id FacetOpposite(const TetMesh& mesh, Id cell, Id vertex)
{
  const auto corners = mesh.Corners.begin() + 4 * cell;
  return 4 * cell + static_cast<Id>(std::find(corners, corners + 4, vertex) - corners);
}

/// The corner of the cell that is at the place, or NoId.
Id CornerAt(const TetMesh& mesh, Id cell, const Point3& place)
{
  for (Id facet = 4 * cell; facet < 4 * cell + 4; ++facet)
  {
    const Id corner = mesh.Corners[Index(facet)];
    if (corner != NoId && mesh.PointAt(corner) == place)
    {
      return corner;
    }
  }
  return NoId;
}

/// Whether the three lie on a line: their shadows along all axes do.
bool AreCollinear(const Point3& a, const Point3& b, const Point3& c)
{
  const auto shadow = [](const Point3& p, std::size_t d) {
    return Point2{ p[(d + 1) % 3], p[(d + 2) % 3] };
  };
  bool isSo = true;
  for (std::size_t d = 0; d < 3; ++d)
  {
    isSo = isSo && Orient2D(shadow(a, d), shadow(b, d), shadow(c, d)) == 0;
  }
  return isSo;
}

} // namespace

void RegularTriangulation::Reserve(std::size_t numberOfPoints, double cellsPerPoint)
{
  const auto cells =
    static_cast<std::size_t>(cellsPerPoint * static_cast<double>(numberOfPoints)) + 16;
  this->Tets.Points.reserve(numberOfPoints);
  this->Tets.VertexCells.reserve(numberOfPoints);
  this->Tets.Weights.reserve(this->HasWeights ? numberOfPoints : 0);
  this->Tets.Corners.reserve(4 * cells);
  this->Tets.Twins.reserve(4 * cells);
  this->Marks.reserve(cells);
}

std::vector<Id>& RegularTriangulation::KeepLabels()
{
  this->Tets.KeepLabels();
  return this->Tets.Labels;
}

PointInsertion RegularTriangulation::Insert(const Point3& point, double weight, Id hint)
{
  const Id vertex = this->Tets.NumberOfVertices();
  this->Tets.Points.push_back(point);
  this->Tets.VertexCells.push_back(NoId);
  if (this->HasWeights)
  {
    this->Tets.Weights.push_back(weight);
  }
  const PointInsertion result = this->InsertVertex(vertex, hint);
  if (result.What == PointOutcome::Duplicate)
  {
    this->Tets.Points.pop_back();
    this->Tets.VertexCells.pop_back();
    this->Tets.Weights.resize(this->HasWeights ? this->Tets.Points.size() : 0);
  }
  return result;
}

PointInsertion RegularTriangulation::InsertVertex(Id vertex, Id hint)
{
  const Point3 point = this->Tets.PointAt(vertex);
  const Id cell = this->Locate(point, hint);
  if (cell == NoId)
  {
    return this->Wait(vertex);
  }
  const Id other = CornerAt(this->Tets, cell, point);
  if (other != NoId)
  {
    return { PointOutcome::Duplicate, other };
  }
  if (this->HasWeights && this->Tets.IsTetrahedron(cell) &&
    !this->Tets.IsInConflict(cell, point, this->Tets.WeightAt(vertex)))
  {
    this->Hidden.push_back(vertex);
    return { PointOutcome::Hidden, vertex };
  }
  this->FindCavity(cell, vertex);
  this->Cavity.Fill(this->Tets, vertex, this->HasWeights);
  this->Marks.resize(Index(this->Tets.NumberOfSlots()), Unseen);
  this->Hidden.insert(this->Hidden.end(), this->Cavity.Hidden.begin(), this->Cavity.Hidden.end());
  this->LastVertex = vertex;
  return { PointOutcome::Inserted, vertex };
}

// A visibility walk: it ends, because the cells of a regular triangulation, seen from a point, are
// in an order (H. Edelsbrunner, 1990).
Id RegularTriangulation::Locate(const Point3& point, Id hint) const
{
  const TetMesh& mesh = this->Tets;
  Id start = hint != NoId ? mesh.VertexCells[Index(hint)] : NoId;
  start =
    start == NoId && this->LastVertex != NoId ? mesh.VertexCells[Index(this->LastVertex)] : start;
  if (start == NoId)
  {
    return NoId;
  }
  Id cell = mesh.IsGhost(start) ? TetMesh::CellOf(mesh.Twins[Index(4 * start + 3)]) : start;
  Id entry = NoId; // the facet by which it was entered
  for (Id facet = 4 * cell; facet < 4 * cell + 4;)
  {
    const bool isBeyond = facet != entry &&
      Orient3D(point, mesh.PointAt(mesh.FacetCorner(facet, 0)),
        mesh.PointAt(mesh.FacetCorner(facet, 1)), mesh.PointAt(mesh.FacetCorner(facet, 2))) < 0;
    if (!isBeyond)
    {
      ++facet;
      continue;
    }
    entry = mesh.Twins[Index(facet)];
    cell = TetMesh::CellOf(entry);
    if (mesh.IsGhost(cell))
    {
      break;
    }
    facet = 4 * cell;
  }
  return cell;
}

void RegularTriangulation::FindCavity(Id first, Id vertex)
{
  const Point3 point = this->Tets.PointAt(vertex);
  const double weight = this->Tets.WeightAt(vertex);
  std::vector<Id>& zone = this->Cavity.Zone;
  this->Cavity.Clear();
  zone.push_back(first);
  this->Marks[Index(first)] = InCavity;
  for (std::size_t i = 0; i < zone.size(); ++i)
  {
    for (Id facet = 4 * zone[i]; facet < 4 * zone[i] + 4; ++facet)
    {
      const Id next = TetMesh::CellOf(this->Tets.Twins[Index(facet)]);
      std::uint8_t& mark = this->Marks[Index(next)];
      if (mark == Unseen)
      {
        mark = this->Tets.IsInConflict(next, point, weight) ? InCavity : Outside;
        if (mark == InCavity)
        {
          zone.push_back(next);
        }
      }
      if (mark == Outside)
      {
        this->Cavity.AddWall(this->Tets, facet);
      }
    }
  }
  for (const Id cell : zone)
  {
    this->Marks[Index(cell)] = Unseen;
  }
  for (const CavityCones::Wall& wall : this->Cavity.Walls)
  {
    this->Marks[Index(TetMesh::CellOf(wall.Outside))] = Unseen;
  }
}

PointInsertion RegularTriangulation::Wait(Id vertex)
{
  const auto point = [this](std::size_t k) { return this->Tets.PointAt(this->Base[k]); };
  const Point3& p = this->Tets.PointAt(vertex);
  const std::size_t size = this->Base.size();
  const bool isIndependent = size == 0 || (size == 1 && p != point(0)) ||
    (size == 2 && !AreCollinear(point(0), point(1), p)) ||
    (size == 3 && Orient3D(point(0), point(1), point(2), p) != 0);
  this->Waiting.push_back(vertex);
  if (isIndependent)
  {
    this->Base.push_back(vertex);
  }
  if (this->Base.size() < 4)
  {
    return { PointOutcome::Waiting, vertex };
  }
  this->Start();
  return { PointOutcome::Inserted, vertex };
}

// The tetrahedron of the base and the ghosts beyond its facets. Ghosts i and j meet at the facet
// that has neither corner i nor corner j.
void RegularTriangulation::Start()
{
  std::array<Id, 4> c{ this->Base[0], this->Base[1], this->Base[2], this->Base[3] };
  if (Orient3D(this->Tets.PointAt(c[0]), this->Tets.PointAt(c[1]), this->Tets.PointAt(c[2]),
        this->Tets.PointAt(c[3])) < 0)
  {
    std::swap(c[2], c[3]);
  }
  const Id cell = this->Tets.NewCell();
  this->Tets.SetCorners(cell, c[0], c[1], c[2], c[3]);
  std::array<Id, 4> ghosts{};
  for (Id k = 0; k < 4; ++k)
  {
    const auto& f = TetMesh::FacetCorners[k];
    ghosts[Index(k)] = this->Tets.NewCell();
    this->Tets.SetCorners(ghosts[Index(k)], c[Index(f[0])], c[Index(f[1])], c[Index(f[2])], NoId);
    this->Tets.Link(4 * cell + k, 4 * ghosts[Index(k)] + 3);
    this->Tets.VertexCells[Index(c[Index(k)])] = cell;
  }
  for (Id i = 0; i < 4; ++i)
  {
    for (Id j = 0; j < 4; ++j)
    {
      if (i != j)
      {
        this->Tets.Twins[Index(FacetOpposite(this->Tets, ghosts[Index(i)], c[Index(j)]))] =
          FacetOpposite(this->Tets, ghosts[Index(j)], c[Index(i)]);
      }
    }
  }
  this->Marks.resize(Index(this->Tets.NumberOfSlots()), Unseen);
  this->LastVertex = c[0];
  std::vector<Id> others;
  for (const Id vertex : this->Waiting)
  {
    if (std::find(this->Base.begin(), this->Base.end(), vertex) == this->Base.end())
    {
      others.push_back(vertex);
    }
  }
  this->Waiting.clear();
  this->Base.clear();
  this->InsertLater(others);
}

void RegularTriangulation::InsertLater(const std::vector<Id>& vertices)
{
  for (const Id vertex : vertices)
  {
    const PointInsertion result = this->InsertVertex(vertex, NoId);
    if (result.What == PointOutcome::Duplicate)
    {
      this->Late.push_back({ vertex, result.Vertex });
    }
  }
}

void RegularTriangulation::Remove(Id vertex)
{
  for (std::vector<Id>* const list : { &this->Waiting, &this->Hidden })
  {
    list->erase(std::remove(list->begin(), list->end(), vertex), list->end());
  }
  if (this->Tets.VertexCells[Index(vertex)] == NoId)
  {
    this->WaitAgain();
    return;
  }
  const VertexStar star(this->Tets, vertex);
  if (star.Beyond == NoId)
  {
    this->StartAgain(vertex);
    return;
  }
  RegularTriangulation part(this->HasWeights);
  std::vector<Id> vertices = star.Link;
  for (const Id other : star.Link)
  {
    part.Insert(this->Tets.PointAt(other), this->Tets.WeightAt(other));
  }
  if (part.Mesh().NumberOfCells() == 0)
  {
    vertices.push_back(star.Beyond);
    part.Insert(this->Tets.PointAt(star.Beyond), this->Tets.WeightAt(star.Beyond));
  }
  star.Fill(this->Tets, part.Mesh(), vertices);
  this->Marks.resize(Index(this->Tets.NumberOfSlots()), Unseen);
  this->LastVertex = star.Link.front();
  std::vector<Id> hidden;
  hidden.swap(this->Hidden);
  this->InsertLater(hidden);
}

void RegularTriangulation::WaitAgain()
{
  std::vector<Id> waiting;
  waiting.swap(this->Waiting);
  this->Base.clear();
  this->InsertLater(waiting);
}

// Without any of the cells: all other vertices wait.
void RegularTriangulation::StartAgain(Id without)
{
  for (Id vertex = 0; vertex < this->Tets.NumberOfVertices(); ++vertex)
  {
    Id& cell = this->Tets.VertexCells[Index(vertex)];
    if (cell != NoId && vertex != without)
    {
      this->Waiting.push_back(vertex);
    }
    cell = NoId;
  }
  this->Waiting.insert(this->Waiting.end(), this->Hidden.begin(), this->Hidden.end());
  this->Hidden.clear();
  for (Id cell = 0; cell < this->Tets.NumberOfSlots(); ++cell)
  {
    if (!this->Tets.IsFree(cell))
    {
      this->Tets.FreeCell(cell);
    }
  }
  this->LastVertex = NoId;
  this->WaitAgain();
}

} // namespace biting
