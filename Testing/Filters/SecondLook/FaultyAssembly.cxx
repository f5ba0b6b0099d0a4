// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// The assembly of the mesh, which then breaks one thing.
#define AssembleMesh AssembleFaultlessMesh
#include "Kernel/Stages/MeshAssembly.cxx" // NOLINT: under another name
#undef AssembleMesh

#include "Fault.h"

namespace biting
{

namespace
{

using second_look::Fault;

// The first triangle whose neighbors are three.
std::size_t InnerTriangle(const BitingMesh& mesh)
{
  const std::vector<Id>& n = mesh.Neighbors;
  std::size_t first = 0;
  while (n[first] == NoId || n[first + 1] == NoId || n[first + 2] == NoId)
  {
    first += 3;
  }
  return first;
}

std::size_t BoundaryEdge(const BitingMesh& mesh)
{
  return static_cast<std::size_t>(
    std::find(mesh.Neighbors.begin(), mesh.Neighbors.end(), NoId) - mesh.Neighbors.begin());
}

void Unlink(BitingMesh& mesh, Id from, Id to)
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    Id& neighbor = mesh.Neighbors[3 * static_cast<std::size_t>(from) + k];
    neighbor = neighbor == to ? NoId : neighbor;
  }
}

// Of the two triangles the larger one forgets: what the smaller one names is not followed.
void ForgetSmallerNeighbor(std::size_t half, BitingMesh& mesh)
{
  while (mesh.Neighbors[half] == NoId || mesh.Neighbors[half] > static_cast<Id>(half / 3))
  {
    ++half;
  }
  mesh.Neighbors[half] = NoId;
}

// The last triangle takes the number of the dropped one.
void DropTriangle(std::size_t first, BitingMesh& mesh, Triangulation& triangulation)
{
  const Id dropped = static_cast<Id>(first / 3);
  const Id last = static_cast<Id>(mesh.Corners.size() / 3) - 1;
  for (std::size_t k = 0; k < 3; ++k)
  {
    Unlink(mesh, mesh.Neighbors[first + k], dropped);
  }
  for (Id& neighbor : mesh.Neighbors)
  {
    neighbor = neighbor == last ? dropped : neighbor;
  }
  for (std::vector<Id>* array : { &mesh.Corners, &mesh.Neighbors, &triangulation.Constraints })
  {
    std::copy(array->end() - 3, array->end(), array->begin() + static_cast<std::ptrdiff_t>(first));
    array->resize(array->size() - 3);
  }
}

// Its edges count as boundary, and as covered.
void DoubleTriangle(std::size_t first, BitingMesh& mesh, Triangulation& triangulation)
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    mesh.Corners.push_back(mesh.Corners[first + k]);
    mesh.Neighbors.push_back(NoId);
    triangulation.Constraints.push_back(0);
  }
}

// On an interface, which both its triangles forget.
void ForgetInterface(const BitingMesh& mesh, Triangulation& triangulation)
{
  std::vector<Id>& constraints = triangulation.Constraints;
  std::size_t half = 0;
  while (constraints[half] == NoId || mesh.Neighbors[half] == NoId)
  {
    ++half;
  }
  const auto across = constraints.begin() + 3 * mesh.Neighbors[half];
  std::replace(across, across + 3, constraints[half], NoId);
  constraints[half] = NoId;
}

Point2& InnerPoint(BitingMesh& mesh)
{
  const auto inner = std::find(mesh.Kinds.begin(), mesh.Kinds.end(), VertexKind::Interior);
  return mesh.Points[static_cast<std::size_t>(inner - mesh.Kinds.begin())];
}

void MoveBoundary(BitingMesh& mesh)
{
  constexpr double Bulge = 1e-6;
  const auto onEdge = std::find(mesh.Kinds.begin(), mesh.Kinds.end(), VertexKind::Boundary);
  Point2& point = mesh.Points[static_cast<std::size_t>(onEdge - mesh.Kinds.begin())];
  const Point2 center{ 0.5, 0.5 };
  point = point + Bulge * (point - center);
}

void Break(Fault fault, BitingMesh& mesh, Triangulation& triangulation)
{
  const std::size_t inner = InnerTriangle(mesh);
  switch (fault)
  {
    case Fault::SwappedCorners:
      return std::swap(mesh.Corners[inner], mesh.Corners[inner + 1]);
    case Fault::MissingTriangle:
      return DropTriangle(inner, mesh, triangulation);
    case Fault::DoubledTriangle:
      return DoubleTriangle(inner, mesh, triangulation);
    case Fault::MovedVertex:
      InnerPoint(mesh) = Point2{ 2.0, 2.0 };
      return;
    case Fault::MovedBoundary:
      return MoveBoundary(mesh);
    case Fault::UnlinkedNeighbor:
      Unlink(mesh, mesh.Neighbors[inner], static_cast<Id>(inner / 3));
      mesh.Neighbors[inner] = NoId;
      return;
    case Fault::OneSidedNeighbor:
      return ForgetSmallerNeighbor(inner, mesh);
    case Fault::ForgottenConstraint:
      triangulation.Constraints[BoundaryEdge(mesh)] = NoId;
      return;
    case Fault::ForgottenInterface:
      return ForgetInterface(mesh, triangulation);
    case Fault::UnusedVertex:
      mesh.Points.push_back({ 0.5, 0.5 });
      return;
    default:
      return;
  }
}

} // namespace

BitingMesh AssembleMesh(
  const Domain& domain, BitingResult bites, Triangulation& triangulation, Monitor& monitor)
{
  BitingMesh mesh = AssembleFaultlessMesh(domain, std::move(bites), triangulation, monitor);
  Break(second_look::TheFault, mesh, triangulation);
  return mesh;
}

} // namespace biting
