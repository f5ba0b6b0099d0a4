// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingOutlineCover_h
#define BitingOutlineCover_h

#include "../Base/Ids.h"
#include "../Base/Point2.h"
#include "Bites.h"

#include <array>   // for the sides
#include <cstdint> // for what is covered of each

namespace biting
{

/// Tells of most bites whose outline is covered that it is, at a fraction of the cost of
/// BiteOutline: each side is cut into 63 pieces, one bit each, which are covered by one bite or not
/// at all; without an allocation, nearly without a branch.
/// Law: where IsFull, each place of the outline lies in another bite. What a square covers of a
/// circle does not count.
class OutlineCover
{
public:
  OutlineCover(const Bites& bites, Id bite);

  void Cover(Id other);
  bool IsFull() const
  {
    return (this->Covered[0] & this->Covered[1] & this->Covered[2] & this->Covered[3]) == AllPieces;
  }

private:
  static constexpr std::uint64_t AllPieces = (std::uint64_t{ 1 } << 63) - 1;

  void CoverBySquare(const Point2& center, const Point2& axis, double halfWidth);
  void CoverSquareByCircle(const Point2& center, double radius);
  void CoverCircleByCircle(const Point2& center, double radius);

  const Bites& All;
  Id Bite;
  Point2 Axis;
  double PerHalfWidth;

  // The pieces covered of each side, in the order of places. A circle has one side, along which the
  // places of the four sides of the square about it follow one another, counterclockwise.
  std::array<std::uint64_t, 4> Covered{};
};

} // namespace biting

#endif
