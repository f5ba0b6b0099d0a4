// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCandidateQueue_h
#define BitingCandidateQueue_h

#include "FrontOrder.h"

#include <deque>  // for each line
#include <vector> // for the lines

namespace biting
{

/// The front as a set of candidates. Candidates that later bites cover stay in the queue until they
/// are taken: nothing is ever searched for or deleted.
/// One line a class, the best class first. A line is first in, first out, O(1) a candidate; where
/// the rule says which one comes later it is a heap, O(log n).
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
