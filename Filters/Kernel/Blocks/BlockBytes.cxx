// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BlockBytes.h"

#include "ByteStream.h"

#include <cstdint> // for digests
#include <cstring> // for copies of bytes
#include <tuple>   // for lists of arrays
#include <utility> // for move

namespace biting
{

namespace
{

// All of it, which may be constant.
template <typename Collar>
auto MembersOf(Collar& collar)
{
  auto& bites = collar.Mesh.Bites;
  auto& triangles = collar.Mesh.Triangles;
  return std::tie(collar.Mesh.Bitten, collar.Mesh.NumberOfOrders, collar.NumberOfVertices,
    collar.NumberOfTriangles, collar.Vertices, collar.Triangles, bites.Points, bites.Spacings,
    bites.BiteOrders, bites.Segments, bites.EdgeStarts, bites.EdgeEnds, bites.EdgeSegments,
    triangles.Corners, triangles.Neighbors, triangles.Constraints, triangles.Regions);
}

// FNV-1a, eight bytes at a time: equal only for equal cuts, but by an accident that nobody lives to
// see.
class Digest
{
public:
  template <typename Value>
  void Add(const Value& value)
  {
    static_assert(sizeof(value) <= sizeof(std::uint64_t), "fits");
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(value));
    this->Sum = (this->Sum ^ bits) * 1099511628211u;
  }

  std::uint64_t Sum = 14695981039346656037u;
};

// Of what all processes must have in common.
std::uint64_t DigestOf(const BlockDomains& blocks)
{
  Digest digest;
  for (const Point2& vertex : blocks.Graph.Vertices)
  {
    digest.Add(vertex.X);
    digest.Add(vertex.Y);
  }
  for (const CutGraph::Piece& piece : blocks.Graph.Pieces)
  {
    digest.Add(piece.Start);
    digest.Add(piece.End);
    digest.Add(piece.Segment);
  }
  for (const BlockDomain& block : blocks.Blocks)
  {
    digest.Add(block.Vertices.size());
    digest.Add(block.Pieces.size());
    digest.Add(block.ExpectedVertices);
  }
  return digest.Sum;
}

} // namespace

std::vector<char> PackCollars(const BlockDomains& blocks, const std::vector<std::size_t>& numbers,
  const std::vector<BlockCollar>& collars)
{
  ByteWriter writer;
  writer.Put(DigestOf(blocks));
  for (const std::size_t block : numbers)
  {
    std::apply(
      [&writer](const auto&... members) { (writer.Put(members), ...); }, MembersOf(collars[block]));
  }
  return std::move(writer.Bytes);
}

bool UnpackCollars(const std::vector<char>& bytes, const BlockDomains& blocks,
  const std::vector<std::size_t>& numbers, std::vector<BlockCollar>& collars)
{
  ByteReader reader(bytes);
  std::uint64_t digest = 0;
  reader.Take(digest);
  if (digest != DigestOf(blocks))
  {
    return false;
  }
  std::vector<BlockCollar> made(numbers.size());
  for (BlockCollar& collar : made)
  {
    std::apply([&reader](auto&... members) { (reader.Take(members), ...); }, MembersOf(collar));
  }
  for (std::size_t k = 0; k < made.size() && reader.IsAtEnd(); ++k)
  {
    collars[numbers[k]] = std::move(made[k]);
  }
  return reader.IsAtEnd();
}

} // namespace biting
