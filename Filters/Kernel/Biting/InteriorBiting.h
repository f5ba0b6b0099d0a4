// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingInteriorBiting_h
#define BitingInteriorBiting_h

#include "../Base/Point.h"
#include "../Base/Pulse.h"
#include "Bisectors.h"
#include "BitingState.h"
#include "CandidateQueue.h"
#include "FrontVertices.h"
#include "LeftOvers.h"

#include <vector> // for bites

namespace biting
{

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
