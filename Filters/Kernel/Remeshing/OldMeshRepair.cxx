// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OldMeshRepair.h"

#include "../Quality/TriangleLinks.h"
#include "NearVertices.h"

#include <algorithm> // for max, min, sort
#include <numeric>   // for iota
#include <utility>   // for move

namespace biting
{

namespace
{

std::vector<Id> VerticesOfFreeEdges(const OldMesh& mesh)
{
  std::vector<Id> vertices;
  for (Id slot = 0; slot < static_cast<Id>(mesh.Corners.size()); ++slot)
  {
    if (mesh.Neighbors[slot] == NoId)
    {
      vertices.push_back(mesh.Start(slot));
      vertices.push_back(mesh.End(slot));
    }
  }
  return vertices;
}

class Mender
{
public:
  Mender(const RemeshInput& input, double nearest, OldMesh& mesh, ProblemList& problems)
    : Input(input)
    , Nearest(nearest)
    , Mesh(mesh)
    , Problems(problems)
  {
  }

  MendedMesh Mend();

private:
  void Link();
  void WeldFreeEdges();
  void Weld(Id one, Id other);
  void MendFlat();
  void KeepSides(const FlatTriangleRepair& repair);
  void TellFlat(const std::vector<FlatTriangle>& flat);
  void Renumber();
  Id NumberOf(Id vertex) const;
  std::int64_t PointId(Id vertex) const
  {
    return this->Input.PointIds.empty() ? vertex : this->Input.PointIds[vertex];
  }

  const RemeshInput& Input;
  double Nearest;
  OldMesh& Mesh;
  ProblemList& Problems;
  MendedMesh Result;
};

void Mender::Link()
{
  TriangleLinks links = LinkTriangles(this->Mesh.Corners, this->Mesh.NumberOfVertices());
  this->Mesh.Neighbors = std::move(links.Neighbors);
  this->Result.Crowded = std::move(links.Crowded);
}

MendedMesh Mender::Mend()
{
  this->Link();
  this->WeldFreeEdges();
  this->MendFlat();
  if (!this->Result.Numbers.empty() || !this->Mesh.Origins.empty())
  {
    this->Link();
  }
  return std::move(this->Result);
}

void Mender::WeldFreeEdges()
{
  const std::vector<Id> vertices = VerticesOfFreeEdges(this->Mesh);
  for (const auto& [one, other] : FindNearVertices(this->Mesh.Points, vertices, this->Nearest))
  {
    this->Weld(one, other);
  }
  this->Renumber();
}

// The lower number stays.
void Mender::Weld(Id one, Id other)
{
  if (this->Result.Numbers.empty() && one != other)
  {
    this->Result.Numbers.resize(this->Mesh.Points.size());
    std::iota(this->Result.Numbers.begin(), this->Result.Numbers.end(), 0);
  }
  const Id stays = std::min(this->NumberOf(one), this->NumberOf(other));
  const Id goes = std::max(this->NumberOf(one), this->NumberOf(other));
  if (stays == goes)
  {
    return;
  }
  this->Result.Numbers[goes] = stays;
  const Point2& place = this->Mesh.Points[goes];
  const bool isSame = place == this->Mesh.Points[stays];
  this->Problems.Add({ isSame ? ProblemCode::DuplicatePoints : ProblemCode::NearPoints,
    { this->PointId(goes), this->PointId(stays) }, place, "" });
}

Id Mender::NumberOf(Id vertex) const
{
  while (!this->Result.Numbers.empty() && this->Result.Numbers[vertex] != vertex)
  {
    vertex = this->Result.Numbers[vertex];
  }
  return vertex;
}

void Mender::MendFlat()
{
  OldMesh& mesh = this->Mesh;
  FlatTriangleRepair repair = RepairFlatTriangles(mesh.Points, this->Input.Rounding, mesh.Corners);
  this->TellFlat(repair.Flat);
  for (const auto& [goes, stays] : repair.Welded)
  {
    this->Weld(stays, goes);
  }
  this->Renumber();
  if (repair.Origins.empty())
  {
    return;
  }
  this->KeepSides(repair);
  std::vector<Id> regions;
  std::vector<std::uint8_t> isFrozen;
  for (std::size_t triangle = 0; triangle < repair.Origins.size(); ++triangle)
  {
    const Id origin = repair.Origins[triangle];
    regions.push_back(mesh.Regions[origin]);
    isFrozen.push_back(repair.IsNew[triangle] ? 0 : mesh.IsFrozen[origin]);
  }
  mesh.Regions = std::move(regions);
  mesh.IsFrozen = std::move(isFrozen);
  mesh.Origins = std::move(repair.Origins);
  mesh.IsRepaired = std::move(repair.IsNew);
}

void Mender::KeepSides(const FlatTriangleRepair& repair)
{
  for (const auto& [start, end, middle] : repair.Divided)
  {
    const auto [first, second] = std::minmax({ this->NumberOf(start), this->NumberOf(end) });
    this->Result.Divided.push_back({ first, second, this->NumberOf(middle) });
  }
  std::sort(this->Result.Divided.begin(), this->Result.Divided.end());
  for (const Id vertex : repair.RimVertices)
  {
    this->Mesh.RepairedVertices.push_back(this->NumberOf(vertex));
  }
}

void Mender::TellFlat(const std::vector<FlatTriangle>& flat)
{
  const std::vector<std::int64_t>& cells = this->Input.CellIds;
  for (const FlatTriangle& one : flat)
  {
    const std::int64_t cell = cells.empty() ? one.Triangle : cells[one.Triangle];
    this->Problems.Add({ ProblemCode::FlatTriangles, { cell }, one.Middle, "" });
  }
}

// What stays stays under the number that is left.
void Mender::Renumber()
{
  if (this->Result.Numbers.empty())
  {
    return;
  }
  std::vector<Id>& numbers = this->Result.Numbers;
  for (std::size_t vertex = 0; vertex < numbers.size(); ++vertex)
  {
    numbers[vertex] = numbers[numbers[vertex]]; // that one is lower, and done
    this->Mesh.IsFixed[numbers[vertex]] |= this->Mesh.IsFixed[vertex];
  }
  for (Id& corner : this->Mesh.Corners)
  {
    corner = numbers[corner];
  }
}

} // namespace

MendedMesh MendOldMesh(
  const RemeshInput& input, double nearest, OldMesh& mesh, ProblemList& problems)
{
  return Mender(input, nearest, mesh, problems).Mend();
}

} // namespace biting
