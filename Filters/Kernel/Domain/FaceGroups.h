// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFaceGroups_h
#define BitingFaceGroups_h

#include "../Base/Ids.h"

#include <cstddef> // for size_t
#include <numeric> // for iota
#include <utility> // for swap
#include <vector>  // for the arrays

namespace biting
{

/// Faces that were joined, as disjoint sets. Cost of all joins nearly O(n).
class FaceGroups
{
public:
  explicit FaceGroups(Id count = 0)
    : Parents(static_cast<std::size_t>(count))
    , Sizes(static_cast<std::size_t>(count), 1)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
  }

  /// The face that stands for all of the group of `face`.
  Id Find(Id face) const
  {
    while (this->Parent(face) != face)
    {
      face = this->Parent(face);
    }
    return face;
  }

  /// The smaller group goes to the larger, so that paths to the face that stands for it are short.
  void Join(Id first, Id second)
  {
    auto kept = static_cast<std::size_t>(this->Find(first));
    auto joined = static_cast<std::size_t>(this->Find(second));
    if (kept != joined)
    {
      if (this->Sizes[kept] < this->Sizes[joined])
      {
        std::swap(kept, joined);
      }
      this->Parents[joined] = static_cast<Id>(kept);
      this->Sizes[kept] += this->Sizes[joined];
    }
  }

  /// How many faces the group of `face` has.
  Id SizeOf(Id face) const { return this->Sizes[static_cast<std::size_t>(this->Find(face))]; }

private:
  Id Parent(Id face) const { return this->Parents[static_cast<std::size_t>(face)]; }

  std::vector<Id> Parents;
  std::vector<Id> Sizes;
};

} // namespace biting

#endif
