// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPlaceTable_h
#define BitingPlaceTable_h

#include "../../Base/Ids.h"

#include <array>   // for keys
#include <cstdint> // for keys
#include <vector>  // for the table

namespace biting
{

/// Items by keys of three whole numbers: a hash table with chains. What is found does not depend on
/// the hash: the items of a key are visited from the last one added to the first.
class PlaceTable
{
public:
  using Key = std::array<std::int64_t, 3>;

  /// For at most `items` items, numbered from 0.
  explicit PlaceTable(std::size_t items)
    : Next(items, NoId)
    , Keys(items)
  {
    std::size_t size = 16;
    while (size < 2 * items)
    {
      size *= 2;
    }
    this->Heads.assign(size, NoId);
  }

  void Add(const Key& key, Id item)
  {
    Id& head = this->Heads[this->PlaceOf(key)];
    this->Keys[static_cast<std::size_t>(item)] = key;
    this->Next[static_cast<std::size_t>(item)] = head;
    head = item;
  }

  /// The last item added for which isSo(item); NoId if there is none.
  template <typename Question>
  Id Find(const Key& key, const Question& isSo) const
  {
    Id item = this->Heads[this->PlaceOf(key)];
    while (item != NoId && !(this->Keys[static_cast<std::size_t>(item)] == key && isSo(item)))
    {
      item = this->Next[static_cast<std::size_t>(item)];
    }
    return item;
  }

private:
  /// Odd multipliers from the golden ratio and from the square roots of 2 and 3 mix all bits into
  /// the high ones.
  std::size_t PlaceOf(const Key& key) const
  {
    std::uint64_t hash = static_cast<std::uint64_t>(key[0]) * 0x9E3779B97F4A7C15u;
    hash = (hash ^ (hash >> 29) ^ static_cast<std::uint64_t>(key[1])) * 0x6A09E667F3BCC909u;
    hash = (hash ^ (hash >> 31) ^ static_cast<std::uint64_t>(key[2])) * 0xBB67AE8584CAA73Bu;
    return static_cast<std::size_t>(hash ^ (hash >> 32)) & (this->Heads.size() - 1);
  }

  std::vector<Id> Heads;
  std::vector<Id> Next;
  std::vector<Key> Keys;
};

} // namespace biting

#endif
