// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCornerTable_h
#define BitingCornerTable_h

#include "../Base/Ids.h"

#include <array>   // for coordinates
#include <cstddef> // for dimensions
#include <cstdint> // for keys
#include <utility> // for move
#include <vector>  // for the table

namespace biting
{

/// The numbers of points with integer coordinates, in the order of their first search: a hash table
/// with open addressing.
template <std::size_t D>
class CornerTable
{
public:
  /// Coordinates are at most 2^MaximumLevel.
  static constexpr int MaximumLevel = D == 2 ? 30 : 20;

  using Units = std::array<std::uint32_t, D>;

  /// The number of a point; a point that is new gets the next one.
  Id Find(const Units& units)
  {
    if (2 * this->Count >= this->Numbers.size())
    {
      this->Grow();
    }
    const std::uint64_t key = KeyOf(units);
    std::size_t slot = this->SlotOf(key);
    if (this->Numbers[slot] == NoId)
    {
      this->Keys[slot] = key;
      this->Numbers[slot] = static_cast<Id>(this->Count++);
    }
    return this->Numbers[slot];
  }

private:
  static std::uint64_t KeyOf(const Units& units)
  {
    std::uint64_t key = 0;
    for (const std::uint32_t unit : units)
    {
      key = (key << (MaximumLevel + 1)) | unit;
    }
    return key;
  }

  /// That of the key, or an empty one.
  std::size_t SlotOf(std::uint64_t key) const
  {
    constexpr std::uint64_t GoldenRatio = 0x9e3779b97f4a7c15u;
    const std::size_t mask = this->Keys.size() - 1;
    auto slot = static_cast<std::size_t>((key * GoldenRatio) >> (64 - this->Bits));
    while (this->Numbers[slot] != NoId && this->Keys[slot] != key)
    {
      slot = (slot + 1) & mask;
    }
    return slot;
  }

  void Grow()
  {
    const std::vector<std::uint64_t> keys(std::move(this->Keys));
    const std::vector<Id> numbers(std::move(this->Numbers));
    this->Bits += keys.empty() ? 0 : 2;
    const std::size_t size = std::size_t(1) << this->Bits;
    this->Keys.assign(size, 0);
    this->Numbers.assign(size, NoId);
    for (std::size_t slot = 0; slot < keys.size(); ++slot)
    {
      if (numbers[slot] != NoId)
      {
        const std::size_t to = this->SlotOf(keys[slot]);
        this->Keys[to] = keys[slot];
        this->Numbers[to] = numbers[slot];
      }
    }
  }

  std::vector<std::uint64_t> Keys;
  std::vector<Id> Numbers;
  std::size_t Count = 0;
  int Bits = 10; ///< of the number of slots
};

} // namespace biting

#endif
