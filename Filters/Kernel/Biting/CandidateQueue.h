// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCandidateQueue_h
#define BitingCandidateQueue_h

#include "../Base/Ids.h"
#include "../Base/Point.h"

#include <array> // for the lines
#include <deque> // for each line

namespace biting
{

/// Which candidate of the front is bitten next.
enum class FrontOrder
{
  Layers, ///< first in, first out: layer by layer from the boundary; good candidates before others
  LargestY, ///< the paper's sweep (section 5)
  BestFirst ///< by the shape they promise, in 32 classes; first in, first out in each
};

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
/// A line for each class, the best class first, first in and first out: O(1) a candidate. LargestY:
/// a heap, O(log n); equal y by age.
class CandidateQueue
{
public:
  static constexpr int NumberOfClasses = 32;

  explicit CandidateQueue(FrontOrder order);

  bool IsEmpty() const { return this->Best == NumberOfClasses; }
  void Put(const Candidate& candidate);
  Candidate Take();

  /// The class of a candidate whose triangle misses its wanted lengths by `misfit` (Bisectors.h).
  int ClassOf(double misfit) const;

private:
  FrontOrder Order;
  std::array<std::deque<Candidate>, NumberOfClasses> Lines;
  int Best = NumberOfClasses; ///< the first line that is not empty
};

} // namespace biting

#endif
