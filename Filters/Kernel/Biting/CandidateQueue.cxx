// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CandidateQueue.h"

#include <algorithm> // for push_heap, pop_heap, min

namespace biting
{

namespace
{

// Measured: 5 to 6 % in two classes gives the best mean shape on average over fields, with squares
// and with circles; 16 to 64 classes of 1 to 5 % are alike.
constexpr double GoodMisfit = 0.06;
constexpr double ClassWidth = 0.02;

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
  const int rank = this->Order == FrontOrder::LargestY ? 0 : candidate.Class;
  std::deque<Candidate>& line = this->Lines[rank];
  line.push_back(candidate);
  this->Best = std::min(this->Best, rank);
  if (this->Order == FrontOrder::LargestY)
  {
    std::push_heap(line.begin(), line.end(), ComesLater);
  }
}

Candidate CandidateQueue::Take()
{
  std::deque<Candidate>& line = this->Lines[this->Best];
  const bool isHeap = this->Order == FrontOrder::LargestY;
  if (isHeap)
  {
    std::pop_heap(line.begin(), line.end(), ComesLater);
  }
  const Candidate candidate = isHeap ? line.back() : line.front();
  isHeap ? line.pop_back() : line.pop_front();
  while (this->Best < NumberOfClasses && this->Lines[this->Best].empty())
  {
    ++this->Best;
  }
  return candidate;
}

int CandidateQueue::ClassOf(double misfit) const
{
  if (this->Order == FrontOrder::BestFirst)
  {
    return static_cast<int>(std::min(misfit / ClassWidth, NumberOfClasses - 1.0));
  }
  return misfit < GoodMisfit ? 0 : 1;
}

} // namespace biting
