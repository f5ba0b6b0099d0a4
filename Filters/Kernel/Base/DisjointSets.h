// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDisjointSets_h
#define BitingDisjointSets_h

#include "Ids.h"

#include <algorithm> // for min, max
#include <cstddef>   // for counts
#include <numeric>   // for iota
#include <vector>    // for the items

namespace biting
{

/// Sets of items, each called by its first item (union-find with path halving). At first each item
/// is a set of its own.
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t items = 0)
    : Parents(items)
    , Sizes(items, 1)
    , Sets(items)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), Id{ 0 });
  }

  std::size_t Size() const { return this->Parents.size(); } ///< in items
  std::size_t NumberOfSets() const { return this->Sets; }

  Id SetOf(Id item)
  {
    while (this->Parents[item] != item)
    {
      this->Parents[item] = this->Parents[this->Parents[item]];
      item = this->Parents[item];
    }
    return item;
  }

  /// How many items the set of `item` has.
  Id SizeOf(Id item) { return this->Sizes[this->SetOf(item)]; }

  /// The sets of both become one, which is returned.
  Id Unite(Id a, Id b)
  {
    const Id first = this->SetOf(a);
    const Id second = this->SetOf(b);
    const Id kept = std::min(first, second);
    if (first != second)
    {
      this->Parents[std::max(first, second)] = kept;
      this->Sizes[kept] += this->Sizes[std::max(first, second)];
      --this->Sets;
    }
    return kept;
  }

  /// Another item, a set of its own.
  Id Add()
  {
    this->Parents.push_back(static_cast<Id>(this->Parents.size()));
    this->Sizes.push_back(1);
    ++this->Sets;
    return this->Parents.back();
  }

  /// The sets of `other`, its items behind those that are here.
  void Append(const DisjointSets& other)
  {
    const Id begin = static_cast<Id>(this->Parents.size());
    for (const Id parent : other.Parents)
    {
      this->Parents.push_back(begin + parent);
    }
    this->Sizes.insert(this->Sizes.end(), other.Sizes.begin(), other.Sizes.end());
    this->Sets += other.Sets;
  }

private:
  std::vector<Id> Parents; ///< one of the same set, not greater
  std::vector<Id> Sizes;   ///< of the sets, by their first items
  std::size_t Sets;
};

} // namespace biting

#endif
