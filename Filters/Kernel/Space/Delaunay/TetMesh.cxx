// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TetMesh.h"

#include <algorithm> // for sort, unique
#include <array>     // for facets
#include <utility>   // for pairs

namespace biting
{

namespace
{

std::string At(const char* violation, Id place)
{
  return std::string(violation) + " at " + std::to_string(place);
}

/// The corners in one order, +1 or -1 for the parity of the order they came in.
std::pair<std::array<Id, 3>, int> SortedFacet(const TetMesh& mesh, Id facet)
{
  std::array<Id, 3> c{ mesh.FacetCorner(facet, 0), mesh.FacetCorner(facet, 1),
    mesh.FacetCorner(facet, 2) };
  int parity = 1;
  for (const auto& [i, j] : { std::pair(0u, 1u), std::pair(1u, 2u), std::pair(0u, 1u) })
  {
    if (c[j] < c[i])
    {
      std::swap(c[i], c[j]);
      parity = -parity;
    }
  }
  return { c, parity };
}

std::string CheckFacet(const TetMesh& mesh, Id facet, bool isRegular)
{
  const Id twin = mesh.Twins[TetMesh::Index(facet)];
  if (twin < 0 || twin >= 4 * mesh.NumberOfSlots() || mesh.IsFree(TetMesh::CellOf(twin)) ||
    mesh.Twins[TetMesh::Index(twin)] != facet)
  {
    return At("a twin that is not mutual", facet);
  }
  const auto [corners, parity] = SortedFacet(mesh, facet);
  const auto [twinCorners, twinParity] = SortedFacet(mesh, twin);
  if (corners != twinCorners || parity == twinParity)
  {
    return At("twins whose corners do not fit", facet);
  }
  const Id across = mesh.Corners[TetMesh::Index(twin)];
  if (isRegular && across != NoId &&
    mesh.IsInConflict(TetMesh::CellOf(facet), mesh.PointAt(across), mesh.WeightAt(across)))
  {
    return At("a facet that is not regular", facet);
  }
  return {};
}

std::string CheckCell(const TetMesh& mesh, Id cell, bool isRegular)
{
  const Id* c = &mesh.Corners[TetMesh::Index(4 * cell)];
  for (int k = 0; k < 4; ++k)
  {
    const bool isVertex = c[k] >= 0 && c[k] < mesh.NumberOfVertices();
    if (!isVertex && (k < 3 || c[k] != NoId))
    {
      return At("a corner that is no vertex", cell);
    }
  }
  if (c[3] != NoId &&
    Orient3D(mesh.PointAt(c[0]), mesh.PointAt(c[1]), mesh.PointAt(c[2]), mesh.PointAt(c[3])) <= 0)
  {
    return At("a tetrahedron that is not positive", cell);
  }
  for (int k = 0; k < 4; ++k)
  {
    std::string violation = CheckFacet(mesh, 4 * cell + k, isRegular);
    if (!violation.empty())
    {
      return violation;
    }
  }
  return {};
}

/// Vertices - edges + facets - cells, the vertex at infinity counted.
std::ptrdiff_t EulerNumber(const TetMesh& mesh)
{
  std::vector<std::pair<Id, Id>> edges;
  std::vector<Id> vertices;
  edges.reserve(6 * TetMesh::Index(mesh.NumberOfCells()));
  vertices.reserve(4 * TetMesh::Index(mesh.NumberOfCells()));
  for (Id cell = 0; cell < mesh.NumberOfSlots(); ++cell)
  {
    const Id* c = &mesh.Corners[TetMesh::Index(4 * cell)];
    for (int i = 0; i < 4 && !mesh.IsFree(cell); ++i)
    {
      vertices.push_back(c[i]);
      for (int j = i + 1; j < 4; ++j)
      {
        edges.push_back(std::minmax(c[i], c[j]));
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  std::sort(vertices.begin(), vertices.end());
  const auto numberOfEdges = std::unique(edges.begin(), edges.end()) - edges.begin();
  const auto numberOfVertices = std::unique(vertices.begin(), vertices.end()) - vertices.begin();
  return numberOfVertices - numberOfEdges + mesh.NumberOfCells(); // facets are twice the cells
}

std::string CheckVertices(const TetMesh& mesh)
{
  for (Id vertex = 0; vertex < mesh.NumberOfVertices(); ++vertex)
  {
    const Id cell = mesh.VertexCells[TetMesh::Index(vertex)];
    if (cell == NoId)
    {
      continue;
    }
    const bool isCell = cell >= 0 && cell < mesh.NumberOfSlots() && !mesh.IsFree(cell);
    const Id* c = isCell ? &mesh.Corners[TetMesh::Index(4 * cell)] : nullptr;
    if (!isCell || std::find(c, c + 4, vertex) == c + 4)
    {
      return At("the cell of a vertex that does not have it", vertex);
    }
  }
  return {};
}

} // namespace

Id TetMesh::NewCell()
{
  Id cell = this->FirstFree;
  if (cell != NoId)
  {
    this->FirstFree = this->Twins[Index(4 * cell)];
    --this->NumberOfFree;
  }
  else
  {
    cell = this->NumberOfSlots();
    if (this->Corners.size() == this->Corners.capacity())
    {
      const std::size_t room = this->Corners.size() + this->Corners.size() / 8 + 64; // cells: most
      this->Corners.reserve(room);                                                   // of memory
      this->Twins.reserve(room);
    }
    this->Corners.resize(this->Corners.size() + 4);
    this->Twins.resize(this->Twins.size() + 4);
    if (!this->Labels.empty())
    {
      this->Labels.push_back(NoId);
    }
  }
  return cell;
}

void TetMesh::FreeCell(Id cell)
{
  this->Corners[Index(4 * cell + 3)] = Free;
  this->Twins[Index(4 * cell)] = this->FirstFree;
  this->FirstFree = cell;
  ++this->NumberOfFree;
  if (!this->Labels.empty())
  {
    this->Labels[Index(cell)] = NoId;
  }
}

void TetMesh::SetCorners(Id cell, Id first, Id a, Id b, Id c)
{
  Id* corners = &this->Corners[Index(4 * cell)];
  corners[0] = first;
  corners[1] = a == NoId ? b : b == NoId ? c : a;
  corners[2] = a == NoId ? c : b == NoId ? a : b;
  corners[3] = a == NoId ? a : b == NoId ? b : c;
  if (!this->Labels.empty())
  {
    this->Labels[Index(cell)] = NoId;
  }
}

bool TetMesh::IsInConflict(Id cell, const Point3& point, double weight) const
{
  const Id* c = &this->Corners[Index(4 * cell)];
  if (c[3] < 0)
  {
    const int side = Orient3D(this->PointAt(c[0]), this->PointAt(c[1]), this->PointAt(c[2]), point);
    return side > 0 ||
      (side == 0 && this->IsInConflict(CellOf(this->Twins[Index(4 * cell + 3)]), point, weight));
  }
  const Point3& p = this->PointAt(c[0]);
  const Point3& q = this->PointAt(c[1]);
  const Point3& r = this->PointAt(c[2]);
  const Point3& s = this->PointAt(c[3]);
  const auto weightAt = [this, c](int k) { return this->Weights[Index(c[k])]; };
  const bool isOfPoints = this->Weights.empty() ||
    (weight == 0.0 && weightAt(0) == 0.0 && weightAt(1) == 0.0 && weightAt(2) == 0.0 &&
      weightAt(3) == 0.0);
  const int sign = isOfPoints ? InSphere(p, q, r, s, point)
                              : PowerTest({ p, weightAt(0) }, { q, weightAt(1) },
                                  { r, weightAt(2) }, { s, weightAt(3) }, { point, weight });
  return sign > 0 || (sign == 0 && TieInSphere(p, q, r, s, point) > 0);
}

std::size_t TetMesh::Bytes() const
{
  return sizeof(Point3) * this->Points.capacity() + sizeof(double) * this->Weights.capacity() +
    sizeof(Id) *
    (this->Corners.capacity() + this->Twins.capacity() + this->VertexCells.capacity() +
      this->Labels.capacity());
}

std::string CheckTetMesh(const TetMesh& mesh, bool isRegular)
{
  // Facets are regular only where all corners and twins are what they should be.
  for (const bool isOfSpheres : { false, true })
  {
    for (Id cell = 0; cell < mesh.NumberOfSlots(); ++cell)
    {
      std::string violation =
        mesh.IsFree(cell) ? "" : CheckCell(mesh, cell, isOfSpheres && isRegular);
      if (!violation.empty())
      {
        return violation;
      }
    }
  }
  Id numberOfFree = 0;
  for (Id cell = 0; cell < mesh.NumberOfSlots(); ++cell)
  {
    numberOfFree += mesh.IsFree(cell) ? 1 : 0;
  }
  for (Id cell = mesh.FirstFree; cell != NoId && numberOfFree >= 0;
       cell = mesh.Twins[TetMesh::Index(4 * cell)])
  {
    --numberOfFree;
  }
  if (numberOfFree != 0)
  {
    return "a list of free cells that is not all of them";
  }
  if (mesh.NumberOfCells() > 0 && EulerNumber(mesh) != 0)
  {
    return "Euler's number is not 0";
  }
  return CheckVertices(mesh);
}

} // namespace biting
