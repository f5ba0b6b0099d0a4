// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingLeftOvers_h
#define BitingLeftOvers_h

#include "../Base/Box.h"
#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Base/Pulse.h"
#include "BitingState.h"
#include "Remains.h"

#include <array>   // for triangles
#include <cstdint> // for flags
#include <vector>  // for the bites

namespace biting
{

/// Finds where bites may have left something of the domain over, in the triangulation of what they
/// have made, which it makes (BitingResult::Triangulated).
///
/// A triangle is covered if its circumradius is at most the least half-width at its corners, as
/// each of its places is that near to a corner; if the bites of its corners cover it; or if it lies
/// outside of the domain. From each other triangle, one in a thousand where f is level, one in ten
/// where it is steep, bites are subtracted one by one until it is empty (Remains.h).
class LeftOvers
{
public:
  explicit LeftOvers(BitingState& state);

  /// Places of the front beside gaps, mostly at least one a gap. To be called again once these are
  /// bitten, until there are none. There are none, too, where nothing was bitten since the last
  /// call: a gap may be as narrow as rounding. Without meaning on abort.
  std::vector<Point2> FindPlaces();

  /// Law, once there are no such places: of all that no bite covers, each part is bounded by
  /// outlines of these bites alone, but for the border of the domain. Ascending; mostly none. All
  /// bites where constraints cannot all be edges. Without meaning on abort.
  std::vector<Id> FindBites();

  /// Gives the memory back, once all is found.
  void Release(Pulse& pulse) { ReleaseInSteps(pulse, this->OfOrder, this->Gaps, this->Doubtful); }

private:
  using Triangle = std::array<Point2, 3>;

  enum class Outcome
  {
    Covered,
    NotCovered, ///< or not known to be
    HasTooMany  ///< bites over it
  };

  void Begin();
  std::array<Id, 3> BitesOf(Id triangle) const;
  Box2 BoxOf(Id triangle) const;
  bool MayHaveGap(Id triangle) const;
  bool IsOutside(Id triangle) const;
  Triangle PlacesOf(Id triangle) const;
  bool IsCovered(Id triangle);
  bool IsCovered(const Triangle& places, const std::array<Id, 3>& first, int halvings);
  Outcome TakeAll(const Triangle& places, const std::array<Id, 3>& first);
  Id DeepestAt(const Point2& p) const;
  void PutPlaceBeside(const Point2& p, const std::array<Id, 3>& atCorners);
  bool FindPlaceBeside(const Point2& p);
  void MarkAbout(Id triangle, std::vector<std::uint8_t>& isMarked) const;

  BitingState& State;
  bool HasBegun = false;
  Id LastSize = NoId;      ///< how many bites there were at the last call
  std::vector<Id> OfOrder; ///< the first bite of each order
  double LeastHalfWidth = 0.0;
  std::vector<Id> Gaps;     ///< triangles in which there are places that no bite covers
  std::vector<Id> Doubtful; ///< those in which there may be some
  Remains Left;             ///< of the triangle at hand
  Id CutsLeft = 0;          ///< how many more triangles may be cut, in this call
  std::vector<Point2> Found;
};

} // namespace biting

#endif
