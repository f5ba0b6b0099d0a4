// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BlockBytes.h"

#include <cstdint>     // for digests
#include <cstring>     // for copies of bytes
#include <tuple>       // for lists of arrays
#include <type_traits> // for what may be copied
#include <utility>     // for move

namespace biting
{

namespace
{

// All that is joined (JoinBlocks) of a mesh, which may be constant.
template <typename Mesh>
auto ArraysOf(Mesh& mesh)
{
  auto& bites = mesh.Bites;
  auto& triangles = mesh.Triangles;
  return std::tie(bites.Points, bites.Spacings, bites.BiteOrders, bites.Segments, bites.EdgeStarts,
    bites.EdgeEnds, bites.EdgeSegments, triangles.Corners, triangles.Neighbors,
    triangles.Constraints, triangles.Regions);
}

class Writer
{
public:
  template <typename Value>
  void operator()(const std::vector<Value>& values)
  {
    static_assert(std::is_trivially_copyable_v<Value>, "bytes are the value");
    const std::uint64_t size = values.size();
    this->Put(&size, sizeof(size));
    this->Put(values.data(), values.size() * sizeof(Value));
  }

  void Put(const void* from, std::size_t size)
  {
    const char* first = static_cast<const char*>(from);
    this->Bytes.insert(this->Bytes.end(), first, first + size);
  }

  std::vector<char> Bytes;
};

class Reader
{
public:
  explicit Reader(const std::vector<char>& bytes)
    : Bytes(bytes)
  {
  }

  template <typename Value>
  void operator()(std::vector<Value>& values)
  {
    std::uint64_t size = 0;
    this->Take(&size, sizeof(size));
    this->IsSound = this->IsSound && size <= (this->Bytes.size() - this->Next) / sizeof(Value);
    if (this->IsSound)
    {
      values.resize(static_cast<std::size_t>(size));
      this->Take(values.data(), values.size() * sizeof(Value));
    }
  }

  void Take(void* to, std::size_t size)
  {
    this->IsSound = this->IsSound && size <= this->Bytes.size() - this->Next;
    if (this->IsSound && size > 0)
    {
      std::memcpy(to, this->Bytes.data() + this->Next, size);
      this->Next += size;
    }
  }

  bool IsAtEnd() const { return this->IsSound && this->Next == this->Bytes.size(); }

private:
  const std::vector<char>& Bytes;
  std::size_t Next = 0;
  bool IsSound = true;
};

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

std::vector<char> PackBlocks(const BlockDomains& blocks, const std::vector<std::size_t>& numbers,
  const std::vector<BlockMesh>& meshes)
{
  Writer writer;
  const std::uint64_t digest = DigestOf(blocks);
  writer.Put(&digest, sizeof(digest));
  for (const std::size_t block : numbers)
  {
    writer.Put(&meshes[block].Bitten, sizeof(meshes[block].Bitten));
    std::apply(
      [&writer](const auto&... arrays) { (writer(arrays), ...); }, ArraysOf(meshes[block]));
  }
  return std::move(writer.Bytes);
}

bool UnpackBlocks(const std::vector<char>& bytes, const BlockDomains& blocks,
  const std::vector<std::size_t>& numbers, std::vector<BlockMesh>& meshes)
{
  Reader reader(bytes);
  std::uint64_t digest = 0;
  reader.Take(&digest, sizeof(digest));
  if (digest != DigestOf(blocks))
  {
    return false;
  }
  std::vector<BlockMesh> made(numbers.size());
  for (BlockMesh& mesh : made)
  {
    reader.Take(&mesh.Bitten, sizeof(mesh.Bitten));
    std::apply([&reader](auto&... arrays) { (reader(arrays), ...); }, ArraysOf(mesh));
  }
  for (std::size_t k = 0; k < made.size() && reader.IsAtEnd(); ++k)
  {
    meshes[numbers[k]] = std::move(made[k]);
  }
  return reader.IsAtEnd();
}

} // namespace biting
