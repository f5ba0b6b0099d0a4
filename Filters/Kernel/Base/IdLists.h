// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingIdLists_h
#define BitingIdLists_h

#include "Ids.h"

#include <cstddef> // for counts
#include <numeric> // for partial_sum
#include <vector>  // for the items

namespace biting
{

/// A list of ids for each of many owners, all in one array (compressed rows).
class IdLists
{
public:
  struct List
  {
    const Id* First;
    const Id* Last; ///< past the end

    const Id* begin() const { return this->First; }
    const Id* end() const { return this->Last; }
    Id Size() const { return static_cast<Id>(this->Last - this->First); }
    Id operator[](Id k) const { return this->First[k]; }
  };

  IdLists() = default;

  /// `visit(add)` calls add(owner, id) for all ids; it is called twice and does the same. Each list
  /// has its ids in that order.
  template <typename Visit>
  IdLists(std::size_t owners, const Visit& visit)
    : Offsets(owners + 2, 0)
  {
    visit([this](Id owner, Id) { ++this->Offsets[owner + 2]; });
    std::partial_sum(this->Offsets.begin(), this->Offsets.end(), this->Offsets.begin());
    this->Items.resize(static_cast<std::size_t>(this->Offsets.back()));
    // Offsets[owner + 1] goes from the start of the list to its end.
    visit([this](Id owner, Id id) { this->Items[this->Offsets[owner + 1]++] = id; });
  }

  List operator[](Id owner) const
  {
    return { this->Items.data() + this->Offsets[owner],
      this->Items.data() + this->Offsets[owner + 1] };
  }

private:
  std::vector<Id> Offsets;
  std::vector<Id> Items;
};

} // namespace biting

#endif
