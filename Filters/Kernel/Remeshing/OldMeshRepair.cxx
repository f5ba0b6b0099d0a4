// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OldMeshRepair.h"

#include "../Quality/TriangleLinks.h"
#include "HangingVertices.h"

#include <algorithm> // for minmax, sort, unique
#include <array>     // for corners
#include <cmath>     // for floor
#include <cstdint>   // for flags
#include <numeric>   // for iota
#include <tuple>     // for the order of vertices
#include <utility>   // for move, pairs, swap

namespace biting
{

namespace
{

/// A vertex in one of many upright strips.
struct StripVertex
{
  double Strip = 0.0;
  Point2 Place;
  Id Vertex = NoId;
};

bool operator<(const StripVertex& a, const StripVertex& b)
{
  return std::tie(a.Strip, a.Place.Y, a.Place.X, a.Vertex) <
    std::tie(b.Strip, b.Place.Y, b.Place.X, b.Vertex);
}

/// Pairs of different `vertices` that are not further apart than `nearest`, which may be 0: so many
/// that all are connected by them that are by such distances. Each pair once or twice, in an order
/// that depends on places and numbers alone. Cost O(n log n) where few places are that near to one,
/// however many vertices are at each.
/// Strips are twice as wide as vertices may be apart: two of them share a strip, or one of those
/// that lie half a width beside. Of many at one place each is paired with the next.
std::vector<std::pair<Id, Id>> FindNearVertices(
  const std::vector<Point2>& points, std::vector<Id> vertices, double nearest)
{
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::vector<std::pair<Id, Id>> pairs;
  std::vector<StripVertex> ordered(vertices.size());
  for (const double shift : { 0.0, nearest })
  {
    for (std::size_t k = 0; k < vertices.size(); ++k)
    {
      const Point2& place = points[vertices[k]];
      const double strip =
        nearest > 0.0 ? std::floor((place.X + shift) / (2.0 * nearest)) : place.X;
      ordered[k] = { strip, place, vertices[k] };
    }
    std::sort(ordered.begin(), ordered.end());
    for (auto one = ordered.begin(); one != ordered.end(); ++one)
    {
      for (auto other = one + 1; other != ordered.end() && other->Strip == one->Strip &&
           other->Place.Y - one->Place.Y <= nearest;
           ++other)
      {
        if (Distance(one->Place, other->Place) <= nearest)
        {
          pairs.emplace_back(one->Vertex, other->Vertex);
        }
        if (other->Place == one->Place)
        {
          break; // what is near to the one is near to the other
        }
      }
    }
  }
  return pairs;
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

  MendedMesh Mend()
  {
    this->Link();
    this->WeldFreeEdges();
    this->FillBesideHanging();
    this->MendFlat();
    if (!this->Result.Numbers.empty() || !this->Mesh.Origins.empty())
    {
      this->Link();
    }
    return std::move(this->Result);
  }

private:
  void Link()
  {
    TriangleLinks links = LinkTriangles(this->Mesh.Corners, this->Mesh.NumberOfVertices());
    this->Mesh.Neighbors = std::move(links.Neighbors);
    this->Result.Crowded = std::move(links.Crowded);
  }

  void WeldFreeEdges()
  {
    for (const auto& [one, other] :
      FindNearVertices(this->Mesh.Points, this->Mesh.VerticesOfFreeEdges(), this->Nearest))
    {
      this->Weld(one, other);
    }
    this->Mesh.IsWelded = !this->Result.Numbers.empty();
    this->Renumber();
    if (this->Mesh.IsWelded)
    {
      this->Link();
    }
  }

  // The lower number stays, unless the place of the other one is frozen.
  void Weld(Id one, Id other)
  {
    if (this->Result.Numbers.empty() && one != other)
    {
      this->Result.Numbers.resize(this->Mesh.Points.size());
      std::iota(this->Result.Numbers.begin(), this->Result.Numbers.end(), 0);
      this->FindFrozen();
    }
    auto [stays, goes] = std::minmax({ this->NumberOf(one), this->NumberOf(other) });
    if (stays == goes)
    {
      return;
    }
    const bool isSame = this->Mesh.Points[stays] == this->Mesh.Points[goes];
    if (!isSame && this->IsFrozen[goes] > this->IsFrozen[stays])
    {
      std::swap(stays, goes);
    }
    this->Result.Numbers[goes] = stays;
    this->IsFrozen[stays] |= this->IsFrozen[goes];
    const Point2& place = this->Mesh.Points[goes];
    this->Problems.Add({ isSame ? ProblemCode::DuplicatePoints : ProblemCode::NearPoints,
      { this->PointId(goes), this->PointId(stays) }, place, "" });
  }

  void FindFrozen()
  {
    this->IsFrozen = this->Mesh.IsFixed;
    for (std::size_t slot = 0; slot < this->Mesh.Corners.size(); ++slot)
    {
      this->IsFrozen[this->Mesh.Corners[slot]] |= this->Mesh.IsFrozen[slot / 3];
    }
    for (std::size_t line = 0; line < this->Input.IsFrozenLine.size(); ++line)
    {
      this->IsFrozen[this->Input.LineStarts[line]] |= this->Input.IsFrozenLine[line];
      this->IsFrozen[this->Input.LineEnds[line]] |= this->Input.IsFrozenLine[line];
    }
  }

  // What is filled in is flat: mending it divides the triangle beside.
  void FillBesideHanging()
  {
    for (const HangingVertices& hanging : FindHangingVertices(this->Mesh, this->Input.Rounding))
    {
      const Id owner = hanging.Slot / 3;
      for (const std::array<Id, 3>& corners : FillBeside(this->Mesh, hanging))
      {
        this->Mesh.Corners.insert(this->Mesh.Corners.end(), corners.begin(), corners.end());
        this->Owners.push_back(owner);
      }
      for (const Id vertex : hanging.Vertices)
      {
        this->Problems.Add({ ProblemCode::Touches, { this->CellId(owner), this->PointId(vertex) },
          this->Mesh.Points[vertex], "" });
      }
    }
  }

  void MendFlat()
  {
    OldMesh& mesh = this->Mesh;
    FlatTriangleRepair repair =
      RepairFlatTriangles(mesh.Points, this->Input.Rounding, mesh.Corners, this->Owners.size());
    const auto given = static_cast<Id>(mesh.Regions.size());
    if (repair.Origins.empty())
    {
      mesh.Corners.resize(3 * mesh.Regions.size());
      return;
    }
    for (Id& origin : repair.Origins)
    {
      origin = origin < given ? origin : this->Owners[origin - given];
    }
    this->TellFlat(repair.Flat);
    for (const auto& [goes, stays] : repair.Welded)
    {
      this->Weld(stays, goes);
    }
    this->Renumber();
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

  void KeepSides(const FlatTriangleRepair& repair)
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

  void TellFlat(const std::vector<FlatTriangle>& flat)
  {
    for (const FlatTriangle& one : flat)
    {
      this->Problems.Add(
        { ProblemCode::FlatTriangles, { this->CellId(one.Triangle) }, one.Middle, "" });
    }
  }

  // What stays stays under the number that is left.
  void Renumber()
  {
    if (this->Result.Numbers.empty())
    {
      return;
    }
    std::vector<Id>& numbers = this->Result.Numbers;
    for (std::size_t vertex = 0; vertex < numbers.size(); ++vertex)
    {
      numbers[vertex] = this->NumberOf(static_cast<Id>(vertex));
      this->Mesh.IsFixed[numbers[vertex]] |= this->Mesh.IsFixed[vertex];
    }
    for (Id& corner : this->Mesh.Corners)
    {
      corner = numbers[corner];
    }
  }

  Id NumberOf(Id vertex) const
  {
    while (!this->Result.Numbers.empty() && this->Result.Numbers[vertex] != vertex)
    {
      vertex = this->Result.Numbers[vertex];
    }
    return vertex;
  }

  std::int64_t CellId(Id triangle) const
  {
    return this->Input.CellIds.empty() ? triangle : this->Input.CellIds[triangle];
  }
  std::int64_t PointId(Id vertex) const
  {
    return this->Input.PointIds.empty() ? vertex : this->Input.PointIds[vertex];
  }

  const RemeshInput& Input;
  double Nearest;
  OldMesh& Mesh;
  ProblemList& Problems;
  std::vector<Id> Owners;             ///< of each triangle that was filled in: that with the edge
  std::vector<std::uint8_t> IsFrozen; ///< one a vertex, where some are made one: its place stays
  MendedMesh Result;
};

} // namespace

MendedMesh MendOldMesh(
  const RemeshInput& input, double nearest, OldMesh& mesh, ProblemList& problems)
{
  return Mender(input, nearest, mesh, problems).Mend();
}

} // namespace biting
