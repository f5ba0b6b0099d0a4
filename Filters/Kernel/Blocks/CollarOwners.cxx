// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CollarOwners.h"

#include "../Base/TriangleSlots.h"

#include <algorithm> // for min
#include <cstdint>   // for marks

namespace biting
{

namespace
{

Id BlockOfStrip(const Id* corners, const WholeNumbers& numbers)
{
  Id block = NoId;
  for (int corner = 0; corner < 3; ++corner)
  {
    const Id own = numbers.VertexBlocks[corners[corner]];
    block = block == NoId || (own != NoId && own < block) ? own : block;
  }
  return block;
}

// What has none takes that of a neighbor, step by step.
void FillFromNeighbors(const Triangulation& mesh, std::vector<Id>& blocks)
{
  std::vector<Id> front;
  for (Id triangle = 0; triangle < mesh.NumberOfTriangles(); ++triangle)
  {
    if (blocks[triangle] != NoId)
    {
      front.push_back(triangle);
    }
  }
  while (!front.empty())
  {
    std::vector<Id> next;
    for (const Id triangle : front)
    {
      const std::size_t first = 3 * static_cast<std::size_t>(triangle);
      for (std::size_t slot = first; slot < first + 3; ++slot)
      {
        const Id across = mesh.Neighbors[slot];
        if (across != NoId && blocks[across] == NoId)
        {
          blocks[across] = blocks[triangle];
          next.push_back(across);
        }
      }
    }
    front.swap(next);
  }
}

// Vertices of triangles that have a marked corner become marked.
void MarkRing(const Triangulation& mesh, std::vector<std::uint8_t>& isMarked)
{
  std::vector<std::uint8_t> marks = isMarked;
  for (std::size_t slot = 0; slot < mesh.Corners.size(); slot += 3)
  {
    const Id* own = mesh.Corners.data() + slot;
    if (isMarked[own[0]] != 0 || isMarked[own[1]] != 0 || isMarked[own[2]] != 0)
    {
      marks[own[0]] = marks[own[1]] = marks[own[2]] = 1;
    }
  }
  isMarked.swap(marks);
}

} // namespace

std::vector<Id> OwnersOfTriangles(
  const Triangulation& mesh, const WholeNumbers& numbers, const std::vector<Id>& holders)
{
  std::vector<Id> blocks = numbers.TriangleBlocks;
  for (std::size_t triangle = 0; triangle < blocks.size(); ++triangle)
  {
    blocks[triangle] = blocks[triangle] != NoId
      ? blocks[triangle]
      : BlockOfStrip(mesh.Corners.data() + 3 * triangle, numbers);
  }
  FillFromNeighbors(mesh, blocks);
  for (Id& block : blocks)
  {
    block = block == NoId ? 0 : holders[block];
  }
  return blocks;
}

bool HasRingsAround(
  const Triangulation& mesh, const std::vector<Id>& owners, std::size_t numberOfVertices, int rings)
{
  std::vector<Id> ownersOf(numberOfVertices, NoId);
  std::vector<std::uint8_t> isMarked(numberOfVertices, 0);
  for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
  {
    Id& owner = ownersOf[mesh.Corners[slot]];
    owner = owner == NoId ? owners[slot / 3] : owner;
    isMarked[mesh.Corners[slot]] |= owner != owners[slot / 3] ? 1 : 0;
  }
  for (int ring = 0; ring < rings; ++ring)
  {
    MarkRing(mesh, isMarked);
  }
  bool areThere = true;
  for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
  {
    const bool isOpen = mesh.Neighbors[slot] == NoId && mesh.Constraints[slot] == NoId;
    areThere = areThere &&
      !(isOpen &&
        (isMarked[mesh.Corners[NextSlotOf(slot)]] != 0 ||
          isMarked[mesh.Corners[PreviousSlotOf(slot)]] != 0));
  }
  return areThere;
}

} // namespace biting
