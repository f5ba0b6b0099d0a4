// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingNearTouches_h
#define BitingNearTouches_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "../Domain/Domain.h"
#include "../Spacing/Spacing.h"

#include <vector> // for the list

namespace biting
{

/// Segments of a domain that may meet, where f divides them, by rounding of the vertices on them:
/// that are as near to each other as that, or leave a vertex at so small an angle. The mesh of a
/// whole takes such divisions back. Blocks can not, if one has the one segment, and another one the
/// other.
struct NearTouches
{
  struct Pair
  {
    Id First;
    Id Second;
  };

  bool IsEmpty() const { return this->Pairs.empty() && !this->AreEverywhere; }

  std::vector<Pair> Pairs;    ///< of segments
  bool AreEverywhere = false; ///< there are too many for a list, or some of embedded points
};

/// Law: vertices on other segments than these pairs differ, and their parts meet at common ends
/// only, wherever they are divided in proportion to f. Cost O(n log n). Where the monitor wants to
/// stop the answer has no meaning.
NearTouches FindNearTouches(const Domain& domain, const Spacing& spacing, Pulse& pulse);

} // namespace biting

#endif
