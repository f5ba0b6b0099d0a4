// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingInteriorBiting_h
#define BitingInteriorBiting_h

#include "../Base/Box.h"
#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "../Base/Pulse.h"
#include "Bisectors.h"
#include "BiteOutline.h"
#include "BitingState.h"
#include "FrontOrder.h"
#include "LeftOvers.h"

#include <vector> // for bites

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

/// The third phase (paper, section 3.1): bites at places of the front until nothing is left of it.
class InteriorBiting
{
public:
  explicit InteriorBiting(BitingState& state);

  void Run();

  /// Gives the memory back.
  void Release(Pulse& pulse)
  {
    this->Front.Release(pulse);
    this->Rest.Release(pulse);
  }

private:
  void SeedFront();
  void BiteCandidate(Candidate candidate);
  double Shift(Candidate& candidate) const;
  Point2 AxisOf(const Candidate& candidate) const;
  double ShareOf(const Candidate& candidate, Id vertex) const;
  void PutCandidates(Id bite);
  void PutBisectorPoints(Id bite);
  void PutFrontVertices(Id bite);
  bool PutLeftOvers();
  bool HasOpen();
  bool IsUncovered(const Candidate& candidate);
  bool IsSurrounded(const Point2& p) const;

  BitingState& State;
  bool IsUniform;      ///< f is one constant
  Bisectors Points;    ///< where bites may sit, with Placement::Bisectors
  FrontVertices Front; ///< the same with Placement::Corners, and what bisectors leave over
  CandidateQueue Queue;

  // The last resort.
  LeftOvers Rest;             ///< what bisectors leave over
  bool AreGapsBitten = false; ///< as far as they are found without outlines
  std::vector<Id> Open;       ///< bites whose outlines may have gaps
  Id FirstNew = NoId;         ///< the first bite after these were found
  Id NextOpen = 0;            ///< the next to look at, of Open and then of new ones
};

} // namespace biting

#endif
