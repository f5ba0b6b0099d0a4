// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCornerGuard_h
#define BitingCornerGuard_h

#include "../Base/Ids.h"
#include "../Domain/Domain.h"
#include "DomainChains.h"

#include <utility> // for pair
#include <vector>  // for the arrays

namespace biting
{

/// Keeps chains from ending in points where the drawing is blunt: a triangle in a sharp corner of
/// the domain is as sharp, whatever the spacing.
///
/// A vertex stays while its removal would decrease an inner angle of the domain at a neighbour to
/// below 36 degrees. This holds at ends far narrower than f, too: two vertices there make a
/// triangle as narrow as the end, which is less sharp than the corner along the whole sides.
class CornerGuard
{
public:
  /// Refers to its arguments.
  CornerGuard(const Domain& domain, const DomainChains& chains);

  /// The vertices on the other sides of the angles that would be too small. Where there is none the
  /// slot may go; else it is to be asked again when one of them has gone.
  std::vector<Id> FindOtherSides(Id slot) const;

private:
  void FindOtherSidesAt(Id near, Id slot, Id far, std::vector<Id>& found) const;
  bool IsSharpened(Id near, Id slot, Id far, Id other) const;
  bool IsInside(Id slot, Id next, bool isLeft) const;
  const Point2& At(Id slot) const { return this->Drawing.Vertices[this->Chains.Vertices[slot]]; }

  const Domain& Drawing;
  const DomainChains& Chains;
  std::vector<std::pair<Id, Id>> Ends; ///< vertex and slot of each open end, sorted
};

} // namespace biting

#endif
