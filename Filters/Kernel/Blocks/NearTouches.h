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

/// Pairs of segments of a domain whose parts may cross once f divides them, by the rounding of the
/// new vertices: segments nearer to each other than that rounding, or with so small an angle
/// between them. In one mesh such divisions are taken back (SoundTriangulation.h). Two blocks
/// cannot do that for a pair with one segment in each.
struct NearTouches
{
  struct Pair
  {
    Id First;
    Id Second;
  };

  bool IsEmpty() const { return this->Pairs.empty() && !this->AreEverywhere; }

  std::vector<Pair> Pairs;    ///< of segments
  bool AreEverywhere = false; ///< too many for a list, or one of them is an embedded point
};

/// Law: parts of two segments that are no such pair meet in common ends only, wherever the segments
/// are divided in proportion to f. Cost O(n log n). Where the monitor wants to stop the answer has
/// no meaning.
NearTouches FindNearTouches(const Domain& domain, const Spacing& spacing, Pulse& pulse);

} // namespace biting

#endif
