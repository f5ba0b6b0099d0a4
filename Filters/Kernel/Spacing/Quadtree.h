// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingQuadtree_h
#define BitingQuadtree_h

#include "../Base/Box2.h"
#include "../Base/Ids.h"

#include <cstdint> // for integer coordinates
#include <vector>  // for the arrays

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
  explicit Quadtree(const Box2& box);

  Square Root() const { return { 0, 0, this->Low, this->Size }; }

  /// Cuts a leaf; its quarters are in the order (0,0), (1,0), (0,1), (1,1).
  void Split(const Square& square);
  Square Quarter(const Square& square, int quarter) const;

  /// leaf is not negative.
  void SetLeaf(const Square& square, Id leaf);

  /// To be called once, when all leaves are set.
  void Finish();

  /// The number of the leaf of x; of the nearest place along the axes, for a point outside (or
  /// NaN).
  Id Locate(const Point2& x) const
  {
    const std::uint64_t column = this->Units(x.X - this->Low.X);
    const std::uint64_t row = this->Units(x.Y - this->Low.Y);
    int shift = UnitBits - this->TableLevel;
    Id node = this->Table[((row >> shift) << this->TableLevel) + (column >> shift)];
    while (node >= 0)
    {
      --shift;
      const auto quarter = static_cast<Id>(((column >> shift) & 1) + 2 * ((row >> shift) & 1));
      node = this->Nodes[static_cast<std::size_t>(node + quarter)];
    }
    return ~node;
  }

private:
  static constexpr int UnitBits = 52;

  std::uint64_t Units(double offset) const
  {
    constexpr auto last = static_cast<double>((std::uint64_t(1) << UnitBits) - 1);
    const double units = offset * this->UnitsPerLength;
    const double least = units > 0.0 ? units : 0.0;
    return static_cast<std::uint64_t>(least < last ? least : last);
  }

  void FillTable(Id node, int level, std::uint64_t column, std::uint64_t row);

  Point2 Low;
  double Size = 0.0;
  double UnitsPerLength = 0.0;
  int TableLevel = 0;
  std::vector<Id> Nodes{ 0 }; ///< first of four children, or the complement of a leaf
  std::vector<Id> Table;      ///< the nodes of level TableLevel, or the leaves above them
};

} // namespace biting

#endif
