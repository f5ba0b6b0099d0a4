// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFacetTable_h
#define BitingFacetTable_h

#include "../../Base/IdLists.h"
#include "../../Base/Ids.h"

#include <algorithm> // for min
#include <array>     // for corners
#include <cstddef>   // for counts
#include <vector>    // for the arrays

namespace biting
{

/// The corners turned so that the lowest comes first; the orientation stays.
inline std::array<Id, 3> LowestFirst(Id a, Id b, Id c)
{
  const Id lowest = std::min(a, std::min(b, c));
  return lowest == a ? std::array<Id, 3>{ a, b, c }
    : lowest == b    ? std::array<Id, 3>{ b, c, a }
                     : std::array<Id, 3>{ c, a, b };
}

/// Finds facets by their corners.
class FacetTable
{
public:
  /// `corners`: three vertices a facet, below `vertices`. Must outlive this object.
  FacetTable(const std::vector<Id>& corners, std::size_t vertices)
    : Corners(corners)
    , ByLowest(vertices,
        [&corners](const auto& add)
        {
          for (std::size_t slot = 0; slot < corners.size(); slot += 3)
          {
            add(std::min(corners[slot], std::min(corners[slot + 1], corners[slot + 2])),
              static_cast<Id>(slot / 3));
          }
        })
  {
  }

  std::array<Id, 3> CornersOf(Id facet) const
  {
    const Id* corners = &this->Corners[3 * static_cast<std::size_t>(facet)];
    return LowestFirst(corners[0], corners[1], corners[2]);
  }

  /// The facet that has these corners, LowestFirst, in either orientation; NoId if there is none.
  Id Find(const std::array<Id, 3>& corners) const
  {
    for (const Id facet : this->ByLowest[corners[0]])
    {
      const std::array<Id, 3> own = this->CornersOf(facet);
      if (own == corners || (own[1] == corners[2] && own[2] == corners[1]))
      {
        return facet;
      }
    }
    return NoId;
  }

private:
  const std::vector<Id>& Corners;
  IdLists ByLowest;
};

} // namespace biting

#endif
