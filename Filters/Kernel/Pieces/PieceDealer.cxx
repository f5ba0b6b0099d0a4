// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PieceDealer.h"

#include "../Blocks/ByteStream.h"

#include <algorithm> // for min, sort, unique
#include <limits>    // for levels
#include <tuple>     // for lists of arrays
#include <utility>   // for move

namespace biting
{

namespace
{

template <typename Part>
auto MembersOf(Part& part)
{
  auto& mesh = part.Mesh;
  auto& piece = mesh.Piece;
  return std::tie(mesh.Points, mesh.Spacing, mesh.BiteOrders, mesh.Kinds, mesh.OriginalPoints,
    mesh.Corners, mesh.Neighbors, mesh.Regions, piece.IsPart, piece.PointIds, piece.TriangleIds,
    piece.ForeignPoints, piece.Levels, part.Constraints, part.GhostLevels, part.CountsAsked);
}

template <typename Numbers>
auto MembersOfBlock(Numbers& numbers)
{
  return std::tie(numbers.FirstVertex, numbers.GoneVertices, numbers.FirstTriangle,
    numbers.TakenTriangles, numbers.FirstOrder, numbers.Regions);
}

} // namespace

PieceDealer::PieceDealer(const DealtMesh& dealt, int levels)
  : Dealt(dealt)
  , Levels(levels)
  , Own(static_cast<std::size_t>(dealt.NumberOfMembers))
  , LevelsSoFar(dealt.Owners.size(), 0)
  , NewVertices(dealt.Mesh.Points.size(), NoId)
  , NewTriangles(dealt.Owners.size(), NoId)
{
  this->OwnVertices();
  this->Uses = IdLists(this->Dealt.Mesh.Points.size(),
    [this](const auto& add)
    {
      for (std::size_t slot = 0; slot < this->Dealt.Mesh.Corners.size(); ++slot)
      {
        add(this->Dealt.Mesh.Corners[slot], static_cast<Id>(slot / 3));
      }
    });
  for (std::size_t triangle = 0; triangle < dealt.Owners.size(); ++triangle)
  {
    this->Own[dealt.Owners[triangle]].push_back(static_cast<Id>(triangle));
  }
}

void PieceDealer::OwnVertices()
{
  const std::vector<Id>& corners = this->Dealt.Mesh.Corners;
  this->Owners.assign(this->Dealt.Mesh.Points.size(), this->Dealt.NumberOfMembers);
  for (std::size_t slot = 0; slot < corners.size(); ++slot)
  {
    Id& owner = this->Owners[corners[slot]];
    owner = std::min(owner, this->Dealt.Owners[slot / 3]);
  }
}

CollarPart PieceDealer::Make(Id member)
{
  CollarPart part;
  part.Mesh.Piece.IsPart = true;
  const Numbers triangles = this->TrianglesOf(member);
  const Numbers vertices = this->VerticesOf(triangles);
  for (std::size_t k = 0; k < vertices.size(); ++k)
  {
    this->NewVertices[vertices[k]] = static_cast<Id>(k);
  }
  for (std::size_t k = 0; k < triangles.size(); ++k)
  {
    this->NewTriangles[triangles[k]] = static_cast<Id>(k);
  }
  this->CopyVertices(member, vertices, part);
  this->CopyTriangles(triangles, part);
  for (const Id triangle : triangles)
  {
    this->NewTriangles[triangle] = NoId;
    this->LevelsSoFar[triangle] = 0;
  }
  return part;
}

PieceDealer::Numbers PieceDealer::TrianglesOf(Id member)
{
  Numbers triangles = this->Own[member];
  for (const Id triangle : triangles)
  {
    this->LevelsSoFar[triangle] = 1;
  }
  Numbers front = triangles;
  for (int level = 1; level <= this->Levels; ++level)
  {
    // Levels beyond the largest number have the largest.
    constexpr int Largest = std::numeric_limits<std::uint8_t>::max();
    this->AddLevel(static_cast<std::uint8_t>(std::min(level + 1, Largest)), front, triangles);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

// Triangles around the vertices of those of the front, which they become.
void PieceDealer::AddLevel(std::uint8_t level, Numbers& front, Numbers& triangles)
{
  Numbers next;
  for (const Id triangle : front)
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const Id vertex = this->Dealt.Mesh.Corners[3 * static_cast<std::size_t>(triangle) + corner];
      for (const Id other : this->Uses[vertex])
      {
        if (this->LevelsSoFar[other] == 0)
        {
          this->LevelsSoFar[other] = level;
          next.push_back(other);
        }
      }
    }
  }
  triangles.insert(triangles.end(), next.begin(), next.end());
  front.swap(next);
}

PieceDealer::Numbers PieceDealer::VerticesOf(const Numbers& triangles) const
{
  Numbers vertices;
  for (const Id triangle : triangles)
  {
    const auto corner =
      this->Dealt.Mesh.Corners.begin() + 3 * static_cast<std::ptrdiff_t>(triangle);
    vertices.insert(vertices.end(), corner, corner + 3);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

void PieceDealer::CopyVertices(Id member, const Numbers& vertices, CollarPart& part) const
{
  const BitingMesh& from = this->Dealt.Mesh;
  BitingMesh& to = part.Mesh;
  for (const Id vertex : vertices)
  {
    to.Points.push_back(from.Points[vertex]);
    to.Spacing.push_back(from.Spacing[vertex]);
    to.BiteOrders.push_back(from.BiteOrders[vertex]);
    to.Kinds.push_back(from.Kinds[vertex]);
    to.OriginalPoints.push_back(from.OriginalPoints[vertex]);
    to.Piece.PointIds.push_back(from.Piece.PointIds[vertex]);
    to.Piece.ForeignPoints.push_back(this->Owners[vertex] == member ? 0 : 1);
  }
}

void PieceDealer::CopyTriangles(const Numbers& triangles, CollarPart& part) const
{
  const BitingMesh& from = this->Dealt.Mesh;
  BitingMesh& to = part.Mesh;
  for (const Id triangle : triangles)
  {
    const std::size_t first = 3 * static_cast<std::size_t>(triangle);
    for (std::size_t slot = first; slot < first + 3; ++slot)
    {
      const Id across = from.Neighbors[slot];
      to.Corners.push_back(this->NewVertices[from.Corners[slot]]);
      to.Neighbors.push_back(across == NoId ? NoId : this->NewTriangles[across]);
      part.Constraints.push_back(this->Dealt.Constraints[slot]);
    }
    to.Regions.push_back(from.Regions[triangle]);
    to.Piece.TriangleIds.push_back(from.Piece.TriangleIds[triangle]);
    to.Piece.Levels.push_back(static_cast<std::uint8_t>(this->LevelsSoFar[triangle] - 1));
  }
}

std::vector<char> PackPart(const CollarPart& part)
{
  ByteWriter writer;
  const auto put = [&writer](const auto&... members) { (writer.Put(members), ...); };
  std::apply(put, MembersOf(part));
  writer.Put(static_cast<std::uint64_t>(part.Blocks.size()));
  for (const BlockNumbers& numbers : part.Blocks)
  {
    std::apply(put, MembersOfBlock(numbers));
  }
  return std::move(writer.Bytes);
}

bool UnpackPart(const std::vector<char>& bytes, CollarPart& part)
{
  ByteReader reader(bytes);
  const auto take = [&reader](auto&... members) { (reader.Take(members), ...); };
  std::apply(take, MembersOf(part));
  std::uint64_t count = 0;
  reader.Take(count);
  for (std::uint64_t k = 0; k < count && !bytes.empty(); ++k)
  {
    part.Blocks.emplace_back();
    std::apply(take, MembersOfBlock(part.Blocks.back()));
  }
  return reader.IsAtEnd();
}

} // namespace biting
