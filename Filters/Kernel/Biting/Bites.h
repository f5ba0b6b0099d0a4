// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBites_h
#define BitingBites_h

#include "../Base/Ids.h"
#include "../Base/Point2.h"

#include <cstdint> // for phases
#include <vector>  // for the arrays

namespace biting
{

/// The steps of the biting scheme (paper, section 3.1).
enum class BitePhase : std::uint8_t
{
  VertexProtection = 0,
  EdgeProtection = 1,
  Interior = 2,
  Front = 3 ///< marks the lines of the front in the output, no bite
};

/// The bites in their order. A bite is a square with half-width HalfWidths[b], centred at
/// Centers[b], two of its sides parallel to the unit vector Axes[b]. Where several sectors of an
/// input vertex ask for different orientations, its bite is the union of squares that share the
/// centre: consecutive entries with the same Orders.
struct Bites
{
  std::vector<Point2> Centers;
  std::vector<Point2> Axes;
  std::vector<double> HalfWidths;
  std::vector<Id> Orders; ///< number of the bite, from 0; the vertex that it makes
  std::vector<BitePhase> Phases;

  Id Size() const { return static_cast<Id>(this->HalfWidths.size()); }
};

} // namespace biting

#endif
