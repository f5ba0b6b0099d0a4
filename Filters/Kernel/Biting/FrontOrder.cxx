// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FrontOrder.h"

#include <algorithm> // for push_heap, pop_heap, min

namespace biting
{

void CandidateQueue::Put(const Candidate& candidate)
{
  const std::size_t rank = static_cast<std::size_t>(candidate.Class);
  std::deque<Candidate>& line = this->Lines[rank];
  line.push_back(candidate);
  this->Best = std::min(this->Best, rank);
  if (this->Rule.ComesLater)
  {
    std::push_heap(line.begin(), line.end(), this->Rule.ComesLater);
  }
}

Candidate CandidateQueue::Take()
{
  std::deque<Candidate>& line = this->Lines[this->Best];
  if (this->Rule.ComesLater)
  {
    std::pop_heap(line.begin(), line.end(), this->Rule.ComesLater);
  }
  const Candidate candidate = this->Rule.ComesLater ? line.back() : line.front();
  this->Rule.ComesLater ? line.pop_back() : line.pop_front();
  while (this->Best < this->Lines.size() && this->Lines[this->Best].empty())
  {
    ++this->Best;
  }
  return candidate;
}

int CandidateQueue::ClassOf(double misfit) const
{
  return static_cast<int>(
    std::min(this->Rule.NumberOfClasses - 1.0, misfit / this->Rule.ClassWidth));
}

} // namespace biting
