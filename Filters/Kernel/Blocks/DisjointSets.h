// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDisjointSets_h
#define BitingDisjointSets_h

#include "../Base/Ids.h"

#include <algorithm> // for min, max
#include <cstddef>   // for counts
#include <numeric>   // for iota
#include <vector>    // for the items

namespace biting
{

/// Sets of items, each called by its first item. At first each item is a set of its own.
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t items = 0)
    : Parents(items)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), Id{ 0 });
  }

  std::size_t Size() const { return this->Parents.size(); }

  Id SetOf(Id item)
  {
    while (this->Parents[item] != item)
    {
      this->Parents[item] = this->Parents[this->Parents[item]];
      item = this->Parents[item];
    }
    return item;
  }

  /// The sets of both become one.
  void Unite(Id a, Id b)
  {
    const Id first = this->SetOf(a);
    const Id second = this->SetOf(b);
    this->Parents[std::max(first, second)] = std::min(first, second);
  }

private:
  std::vector<Id> Parents; ///< one of the same set, not greater
};

} // namespace biting

#endif
