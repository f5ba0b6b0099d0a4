// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Quadtree.h"

#include <algorithm> // for max

namespace biting
{
namespace
{

/// A million entries: more would not stay in the cache.
constexpr int MaximumTableLevel = 10;

} // namespace

Quadtree::Quadtree(const Box2& box)
  : Size(std::max(box.Width(), box.Height()))
{
  const Point2 center = box.Center();
  this->Low = { center.X - 0.5 * this->Size, center.Y - 0.5 * this->Size };
  this->UnitsPerLength = static_cast<double>(std::uint64_t(1) << UnitBits) / this->Size;
}

void Quadtree::Split(const Square& square)
{
  this->Nodes[static_cast<std::size_t>(square.Node)] = static_cast<Id>(this->Nodes.size());
  this->Nodes.resize(this->Nodes.size() + 4, NoId);
}

Quadtree::Square Quadtree::Quarter(const Square& square, int quarter) const
{
  const Id first = this->Nodes[static_cast<std::size_t>(square.Node)];
  return { first + quarter, square.Level + 1, square.At(0.5 * (quarter & 1), 0.5 * (quarter >> 1)),
    0.5 * square.Size };
}

void Quadtree::SetLeaf(const Square& square, Id leaf)
{
  this->Nodes[static_cast<std::size_t>(square.Node)] = ~leaf;
}

void Quadtree::Finish()
{
  std::size_t tableSize = 1;
  while (tableSize < this->Nodes.size() && this->TableLevel < MaximumTableLevel)
  {
    ++this->TableLevel;
    tableSize *= 4;
  }
  this->Table.resize(tableSize);
  this->FillTable(0, 0, 0, 0);
}

void Quadtree::FillTable(Id nodeId, int level, std::uint64_t column, std::uint64_t row)
{
  const Id node = this->Nodes[static_cast<std::size_t>(nodeId)];
  if (node >= 0 && level < this->TableLevel)
  {
    for (int quarter = 0; quarter < 4; ++quarter)
    {
      this->FillTable(node + quarter, level + 1, 2 * column + static_cast<unsigned>(quarter & 1),
        2 * row + static_cast<unsigned>(quarter >> 1));
    }
    return;
  }
  const int below = this->TableLevel - level;
  for (std::uint64_t j = row << below; j < (row + 1) << below; ++j)
  {
    for (std::uint64_t i = column << below; i < (column + 1) << below; ++i)
    {
      this->Table[(j << this->TableLevel) + i] = node;
    }
  }
}

} // namespace biting
