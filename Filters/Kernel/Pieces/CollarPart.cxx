// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CollarPart.h"

#include "../Blocks/ByteStream.h"

#include <cstdint> // for counts
#include <tuple>   // for lists of arrays
#include <utility> // for move

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
