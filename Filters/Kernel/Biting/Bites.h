// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBites_h
#define BitingBites_h

#include "../Base/Ids.h"
#include "../Base/Point.h"

#include <cstdint> // for phases
#include <vector>  // for the arrays

namespace biting
{

/// What a bite takes of the domain.
enum class BiteShape
{
  Square, ///< half-width c_b f (the paper)
  Circle  ///< radius c_b f (its predecessor: Li, Teng and Üngör, "Biting: advancing front meets
          ///< sphere packing", 2000)
};

/// Where on the front a bite may sit.
enum class Placement
{
  Corners,  ///< at vertices of the front, as in the paper
  Bisectors ///< where the bisector of two bites leaves both: at equal distances from their centres
};

/// The steps of the biting scheme (paper, section 3.1).
enum class BitePhase : std::uint8_t
{
  VertexProtection = 0,
  EdgeProtection = 1,
  Interior = 2,
  Front = 3 ///< marks the lines of the front in the output, no bite
};

/// The bites in their order. A bite is a square with half-width HalfWidths[b], centred at
/// Centers[b], two of its sides parallel to the unit vector Axes[b]; or, where Axes[b] is zero, a
/// circle with radius HalfWidths[b]. Where several sectors of an
/// input vertex ask for different orientations, its bite is the union of squares that share the
/// centre: consecutive entries with the same Orders. Where segments are not divided, bites of the
/// second phase are shields, which make no vertex.
struct Bites
{
  std::vector<Point2> Centers;
  std::vector<Point2> Axes;
  std::vector<double> HalfWidths;
  std::vector<Id> Orders; ///< number of the bite, from 0
  std::vector<BitePhase> Phases;

  Id Size() const { return static_cast<Id>(this->HalfWidths.size()); }

  bool IsCircle(Id bite) const { return this->Axes[bite] == Point2{}; }
};

} // namespace biting

#endif
