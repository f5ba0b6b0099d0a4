// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingDomainChains_h
#define BitingDomainChains_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "../Domain/Domain.h"

#include <cstdint>    // for flags
#include <functional> // for tags
#include <vector>     // for the arrays

namespace biting
{

/// The segments of a domain as chains. An inner vertex of a chain ends two segments, both boundary
/// or both interface and with the same tags, and is no embedded point. Chains without an end are
/// closed.
///
/// A chain is a row of slots: one a vertex, in order; an end of several chains has a slot in each.
/// Slots of one chain are numbered in a row. Nexts and Previous link those that are left.
struct DomainChains
{
  std::vector<Id> Firsts;             ///< slot of each chain
  std::vector<std::uint8_t> IsClosed; ///< of each chain: the first slot follows the last
  std::vector<Id> Left;               ///< of each chain: how many slots are left

  // Of each slot.
  std::vector<Id> Vertices;
  std::vector<Id> Chains;
  std::vector<Id> Segments;       ///< to the slot that follows in the domain; NoId at an open end
  std::vector<Id> Nexts;          ///< NoId at an open end
  std::vector<Id> Previous;       ///< NoId at an open end
  std::vector<std::uint8_t> Goes; ///< 1: the slot was removed

  Id NumberOfChains() const { return static_cast<Id>(this->IsClosed.size()); }
  Id NumberOfSlots() const { return static_cast<Id>(this->Vertices.size()); }

  bool IsOpenEnd(Id slot) const
  {
    return this->Nexts[slot] == NoId || this->Previous[slot] == NoId;
  }

  /// The slot after `slot` in the domain, whether it is left or not. Not for an open end.
  Id Following(Id slot) const
  {
    const Id chain = this->Chains[slot];
    const bool isLast = slot + 1 == this->Firsts[chain + 1];
    return isLast ? this->Firsts[chain] : slot + 1;
  }

  void Remove(Id slot)
  {
    this->Goes[slot] = 1;
    this->Nexts[this->Previous[slot]] = this->Nexts[slot];
    this->Previous[this->Nexts[slot]] = this->Previous[slot];
    --this->Left[this->Chains[slot]];
  }
};

/// `areAlike` tells whether two cells have the same tags; it may be empty.
DomainChains MakeChains(
  const Domain& domain, const std::function<bool(Id, Id)>& areAlike, Pulse& pulse);

} // namespace biting

#endif
