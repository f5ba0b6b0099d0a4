// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingOrthtree_h
#define BitingOrthtree_h

#include "../Base/Ids.h"
#include "Source.h"

#include <algorithm> // for max, transform
#include <cstdint>   // for integer coordinates
#include <iterator>  // for back_inserter

namespace biting
{

/// A cube of D dimensions, cut into 2^D again and again; each leaf carries a number of the user's
/// choice. A leaf is found by arithmetic on integer coordinates: a table answers for the upper
/// levels, and only leaves below it cost a step a level.
template <std::size_t D>
class Orthtree
{
public:
  static constexpr int MaximumLevel = 31;
  static constexpr int Children = 1 << D;

  /// A cube of the tree.
  struct Cube
  {
    Id Node = 0;
    int Level = 0;
    Point<D> Low{};
    double Size = 0.0;

    /// At shares of the size from the low corner.
    Point<D> At(Point<D> shares) const
    {
      for (std::size_t d = 0; d < D; ++d)
      {
        shares[d] = this->Low[d] + shares[d] * this->Size;
      }
      return shares;
    }
  };

  Orthtree() = default;
  Orthtree(const Point<D>& low, double size)
    : Low(low)
    , Size(size)
    , UnitsPerLength(static_cast<double>(std::uint64_t(1) << UnitBits) / size)
  {
  }

  /// The smallest cube about the middle of a box.
  static Orthtree Around(const Point<D>& low, const Point<D>& high)
  {
    double size = 0.0;
    for (std::size_t d = 0; d < D; ++d)
    {
      size = std::max(size, high[d] - low[d]);
    }
    Point<D> corner;
    for (std::size_t d = 0; d < D; ++d)
    {
      corner[d] = low[d] + 0.5 * (high[d] - low[d]) - 0.5 * size;
    }
    return { corner, size };
  }

  Cube Root() const { return { 0, 0, this->Low, this->Size }; }

  /// Cuts a leaf; bit d of a child's number is set where it is the upper one along axis d.
  void Split(const Cube& cube)
  {
    this->Nodes[cube.Node] = static_cast<Id>(this->Nodes.size());
    this->Nodes.resize(this->Nodes.size() + Children, NoId);
  }

  Cube Child(const Cube& cube, int child) const
  {
    const Id first = this->Nodes[cube.Node];
    Point<D> half;
    for (std::size_t d = 0; d < D; ++d)
    {
      half[d] = 0.5 * ((child >> d) & 1);
    }
    return { first + child, cube.Level + 1, cube.At(half), 0.5 * cube.Size };
  }

  /// leaf is not negative.
  void SetLeaf(const Cube& cube, Id leaf) { this->Nodes[cube.Node] = ~leaf; }

  /// Makes a leaf the root of another tree, of the same cube, whose leaves get numbers larger by
  /// `shift`, but for 0.
  void Graft(const Cube& cube, const Orthtree& other, Id shift)
  {
    const Id nodeShift = static_cast<Id>(this->Nodes.size()) - 1;
    const auto shifted = [shift, nodeShift](Id node)
    {
      const bool isInner = node >= 0;
      return isInner ? node + nodeShift : (~node == 0 ? node : ~(~node + shift));
    };
    this->Nodes[cube.Node] = shifted(other.Nodes.front());
    std::transform(
      other.Nodes.begin() + 1, other.Nodes.end(), std::back_inserter(this->Nodes), shifted);
  }

  /// To be called once, when all leaves are set.
  void Finish()
  {
    while (static_cast<int>(D) * (this->TableLevel + 1) <= MaximumTableBits &&
      std::size_t(1) << D * static_cast<std::size_t>(this->TableLevel) < this->Nodes.size())
    {
      ++this->TableLevel;
    }
    const std::uint64_t side = std::uint64_t(1) << this->TableLevel;
    std::size_t count = 1;
    for (std::size_t d = 0; d < D; ++d)
    {
      count *= side;
    }
    this->Table.reserve(count);
    for (std::uint64_t entry = 0; entry < count; ++entry)
    {
      Units units;
      for (std::size_t d = 0; d < D; ++d)
      {
        units[d] = (entry >> d * static_cast<std::size_t>(this->TableLevel)) % side;
      }
      this->Table.push_back(this->Descend(this->Nodes[0], units, this->TableLevel));
    }
  }

  /// The number of the leaf of x; of the nearest place along the axes, for a point outside (or
  /// NaN).
  Id Locate(const Point<D>& x) const
  {
    const int shift = UnitBits - this->TableLevel;
    Units units;
    std::uint64_t entry = 0;
    for (std::size_t d = D; d-- > 0;)
    {
      units[d] = this->UnitsOf(x[d] - this->Low[d]);
      entry = (entry << this->TableLevel) + (units[d] >> shift);
    }
    return ~this->Descend(this->Table[entry], units, shift);
  }

private:
  using Units = std::array<std::uint64_t, D>;

  static constexpr int UnitBits = 52;

  /// A million entries: more would not stay in the cache.
  static constexpr int MaximumTableBits = 20;

  std::uint64_t UnitsOf(double offset) const
  {
    constexpr auto last = static_cast<double>((std::uint64_t(1) << UnitBits) - 1);
    const double units = offset * this->UnitsPerLength;
    const double least = units > 0.0 ? units : 0.0;
    return static_cast<std::uint64_t>(least < last ? least : last);
  }

  /// From a node towards a place, by a bit of its coordinates a level.
  Id Descend(Id node, const Units& units, int bit) const
  {
    while (node >= 0 && bit > 0)
    {
      --bit;
      std::uint64_t child = 0;
      for (std::size_t d = D; d-- > 0;)
      {
        child = 2 * child + ((units[d] >> bit) & 1);
      }
      node = this->Nodes[static_cast<std::size_t>(node) + static_cast<std::size_t>(child)];
    }
    return node;
  }

  Point<D> Low{};
  double Size = 0.0;
  double UnitsPerLength = 0.0;
  int TableLevel = 0;
  std::vector<Id> Nodes{ 0 }; ///< first of the children, or the complement of a leaf
  std::vector<Id> Table;      ///< the nodes of level TableLevel, or the leaves above them
};

} // namespace biting

#endif
