// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCandidateQueue_h
#define BitingCandidateQueue_h

#include "../Base/Ids.h"
#include "../Base/Point2.h"

#include <cstddef> // for size_t
#include <vector>  // for the queue

namespace biting
{

/// Which candidate of the front is bitten next.
enum class FrontOrder
{
  Layers,  ///< first in, first out: layer by layer from the boundary
  LargestY ///< the paper's sweep (section 5)
};

/// A vertex of the front, as it was when the bite `Birth` made it.
struct Candidate
{
  Point2 Place;
  Id Birth = NoId;
};

/// The front as a set of candidates. Candidates that later bites cover stay in the queue until they
/// are taken: nothing is ever searched for or deleted.
/// Layers: O(1) a candidate. LargestY: a heap, O(log n); equal y by age.
class CandidateQueue
{
public:
  explicit CandidateQueue(FrontOrder order);

  bool IsEmpty() const { return this->Taken == this->Waiting.size(); }
  void Put(const Candidate& candidate);
  Candidate Take();

private:
  void Compact();

  FrontOrder Order;
  std::vector<Candidate> Waiting;
  std::size_t Taken = 0; ///< of the front part of Waiting (Layers)
};

} // namespace biting

#endif
