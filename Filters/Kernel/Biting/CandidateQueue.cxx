// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CandidateQueue.h"

#include <algorithm> // for push_heap, pop_heap

namespace biting
{

namespace
{

constexpr std::size_t LeastCompaction = 4096;

// Heap order: the greatest comes out first.
bool ComesLater(const Candidate& a, const Candidate& b)
{
  if (a.Place.Y != b.Place.Y)
  {
    return a.Place.Y < b.Place.Y;
  }
  return a.Birth != b.Birth ? a.Birth > b.Birth : a.Place.X > b.Place.X;
}

} // namespace

CandidateQueue::CandidateQueue(FrontOrder order)
  : Order(order)
{
}

void CandidateQueue::Put(const Candidate& candidate)
{
  this->Waiting.push_back(candidate);
  if (this->Order == FrontOrder::LargestY)
  {
    std::push_heap(this->Waiting.begin(), this->Waiting.end(), ComesLater);
  }
}

Candidate CandidateQueue::Take()
{
  if (this->Order == FrontOrder::LargestY)
  {
    std::pop_heap(this->Waiting.begin(), this->Waiting.end(), ComesLater);
    const Candidate candidate = this->Waiting.back();
    this->Waiting.pop_back();
    return candidate;
  }
  const Candidate candidate = this->Waiting[this->Taken++];
  this->Compact();
  return candidate;
}

// Drops the taken part once it is the larger half: O(1) a candidate, and no more memory than twice
// the front.
void CandidateQueue::Compact()
{
  if (this->Taken > LeastCompaction && 2 * this->Taken > this->Waiting.size())
  {
    this->Waiting.erase(
      this->Waiting.begin(), this->Waiting.begin() + static_cast<std::ptrdiff_t>(this->Taken));
    this->Taken = 0;
  }
}

} // namespace biting
