// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingQuadtree_h
#define BitingQuadtree_h

#include "../Base/Box2.h"
#include "../Base/Ids.h"

#include <algorithm> // for max, transform
#include <cstdint>   // for integer coordinates
#include <iterator>  // for back_inserter
#include <vector>    // for the arrays

namespace biting
{

/// A square, cut into four again and again; each leaf carries a number of the user's choice.
/// A leaf is found by arithmetic on integer coordinates: a table answers for the upper levels, and
/// only leaves below it cost a step a level.
class Quadtree
{
public:
  static constexpr int MaximumLevel = 31;

  /// A square of the tree.
  struct Square
  {
    Id Node = 0;
    int Level = 0;
    Point2 Low;
    double Size = 0.0;

    Point2 At(double u, double v) const
    {
      return { this->Low.X + u * this->Size, this->Low.Y + v * this->Size };
    }
    double Radius() const { return Length({ 0.5 * this->Size, 0.5 * this->Size }); }
    Box2 Box() const { return { this->Low, this->At(1.0, 1.0) }; }
  };

  Quadtree() = default;
  explicit Quadtree(const Box2& box)
    : Size(std::max(box.Width(), box.Height()))
    , UnitsPerLength(static_cast<double>(std::uint64_t(1) << UnitBits) / Size)
  {
    const Point2 center = box.Center();
    this->Low = { center.X - 0.5 * this->Size, center.Y - 0.5 * this->Size };
  }

  Square Root() const { return { 0, 0, this->Low, this->Size }; }

  /// Cuts a leaf; its quarters are in the order (0,0), (1,0), (0,1), (1,1).
  void Split(const Square& square)
  {
    this->Nodes[static_cast<std::size_t>(square.Node)] = static_cast<Id>(this->Nodes.size());
    this->Nodes.resize(this->Nodes.size() + 4, NoId);
  }

  Square Quarter(const Square& square, int quarter) const
  {
    const Id first = this->Nodes[static_cast<std::size_t>(square.Node)];
    return { first + quarter, square.Level + 1,
      square.At(0.5 * (quarter & 1), 0.5 * (quarter >> 1)), 0.5 * square.Size };
  }

  /// leaf is not negative.
  void SetLeaf(const Square& square, Id leaf)
  {
    this->Nodes[static_cast<std::size_t>(square.Node)] = ~leaf;
  }

  /// Makes a leaf the root of another tree, of the same square, whose leaves get numbers larger by
  /// `shift`, but for 0; returns by how much its other nodes have.
  Id Graft(const Square& square, const Quadtree& other, Id shift)
  {
    const Id nodeShift = static_cast<Id>(this->Nodes.size()) - 1;
    const auto shifted = [shift, nodeShift](Id node)
    {
      const bool isInner = node >= 0;
      return isInner ? node + nodeShift : (~node == 0 ? node : ~(~node + shift));
    };
    this->Nodes[static_cast<std::size_t>(square.Node)] = shifted(other.Nodes.front());
    std::transform(
      other.Nodes.begin() + 1, other.Nodes.end(), std::back_inserter(this->Nodes), shifted);
    return nodeShift;
  }

  /// To be called once, when all leaves are set.
  void Finish()
  {
    while (this->TableLevel < MaximumTableLevel &&
      std::size_t(1) << 2 * this->TableLevel < this->Nodes.size())
    {
      ++this->TableLevel;
    }
    const std::uint64_t side = std::uint64_t(1) << this->TableLevel;
    this->Table.reserve(static_cast<std::size_t>(side * side));
    for (std::uint64_t cell = 0; cell < side * side; ++cell)
    {
      this->Table.push_back(
        this->Descend(this->Nodes[0], cell % side, cell / side, this->TableLevel));
    }
  }

  /// The number of the leaf of x; of the nearest place along the axes, for a point outside (or
  /// NaN).
  Id Locate(const Point2& x) const
  {
    const std::uint64_t column = this->Units(x.X - this->Low.X);
    const std::uint64_t row = this->Units(x.Y - this->Low.Y);
    const int shift = UnitBits - this->TableLevel;
    const Id node = this->Table[((row >> shift) << this->TableLevel) + (column >> shift)];
    return ~this->Descend(node, column, row, shift);
  }

private:
  static constexpr int UnitBits = 52;

  /// A million entries: more would not stay in the cache.
  static constexpr int MaximumTableLevel = 10;

  std::uint64_t Units(double offset) const
  {
    constexpr auto last = static_cast<double>((std::uint64_t(1) << UnitBits) - 1);
    const double units = offset * this->UnitsPerLength;
    const double least = units > 0.0 ? units : 0.0;
    return static_cast<std::uint64_t>(least < last ? least : last);
  }

  /// From a node towards a place, by a bit of its coordinates a level.
  Id Descend(Id node, std::uint64_t column, std::uint64_t row, int bit) const
  {
    while (node >= 0 && bit > 0)
    {
      --bit;
      const auto quarter = static_cast<Id>(((column >> bit) & 1) + 2 * ((row >> bit) & 1));
      node = this->Nodes[static_cast<std::size_t>(node + quarter)];
    }
    return node;
  }

  Point2 Low;
  double Size = 0.0;
  double UnitsPerLength = 0.0;
  int TableLevel = 0;
  std::vector<Id> Nodes{ 0 }; ///< first of four children, or the complement of a leaf
  std::vector<Id> Table;      ///< the nodes of level TableLevel, or the leaves above them
};

} // namespace biting

#endif
