// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCandidateQueue_h
#define BitingCandidateQueue_h

#include "../Base/Ids.h"
#include "../Base/Point.h"
#include "FrontOrder.h"

#include <deque>  // for each line
#include <vector> // for the lines

namespace biting
{

/// A place of the front, as it was when the bite `Birth` made it.
struct Candidate
{
  Point2 Place;
  Id Birth = NoId;

  // Of a bisector point (Bisectors.h).
  Id Parents[2] = { NoId, NoId };
  int Class = 0; ///< 0 the best
};

/// The front as a set of candidates. Candidates that later bites cover stay in the queue until they
/// are taken: nothing is ever searched for or deleted.
/// One line a class, the best class first. A line is first in, first out, O(1) a candidate; in a
/// sweep it is a heap by y, O(log n), where equal y go by age.
class CandidateQueue
{
public:
  explicit CandidateQueue(FrontOrder order)
    : Rule(RuleOf(order))
    , Lines(static_cast<std::size_t>(this->Rule.NumberOfClasses))
    , Best(this->Lines.size())
  {
  }

  bool IsEmpty() const { return this->Best == this->Lines.size(); }
  void Put(const Candidate& candidate);
  Candidate Take();

  /// The class of a candidate whose triangle misses its wanted lengths by `misfit` (FrontRule).
  int ClassOf(double misfit) const;

private:
  const FrontRule& Rule;
  std::vector<std::deque<Candidate>> Lines;
  std::size_t Best; ///< the first line that is not empty
};

} // namespace biting

#endif
