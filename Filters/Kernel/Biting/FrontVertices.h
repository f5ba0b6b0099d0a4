// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFrontVertices_h
#define BitingFrontVertices_h

#include "../Base/Box.h"
#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Base/Pulse.h"
#include "BiteOutline.h"
#include "BitingState.h"

#include <vector> // for the lists

namespace biting
{

/// Finds the vertices of the front that a bite makes: its corners that no other bite covers, and
/// where the sides of other bites cross its own.
class FrontVertices
{
public:
  explicit FrontVertices(const BitingState& state);

  /// The vertices of the front on this bite that lie in the domain; valid until the next call.
  const std::vector<Point2>& Find(Id bite);

  /// Gives the memory back.
  void Release(Pulse& pulse) { ReleaseInSteps(pulse, this->Seen); }

private:
  bool IsHidden(Id bite, double reach);
  bool HideGaps(Id bite);
  bool Look(Id bite, Id other);

  const BitingState& State;
  Box2 Bounds;          ///< of the domain, and what rounding may add to it
  BiteOutline Outline;  ///< of the bite at hand
  std::vector<Id> Seen; ///< per bite: the last bite whose outline it was asked for
  std::vector<Point2> Found;
};

} // namespace biting

#endif
