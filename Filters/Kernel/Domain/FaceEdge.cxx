// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FaceEdge.h"

#include <algorithm> // for find, rotate

namespace biting
{

void FaceEdge::Absorb(const FaceEdge& other, bool isReversed)
{
  this->Stays = this->Stays || other.Stays;
  this->Turn += isReversed ? -other.Turn : other.Turn;
  this->Count += other.Count;
  for (const Id given : other.Runs)
  {
    const Id run = isReversed ? OtherSide(given) : given;
    const auto back = std::find(this->Runs.begin(), this->Runs.end(), OtherSide(run));
    const auto free = std::find(this->Runs.begin(), this->Runs.end(), NoId);
    if (run != NoId && back != this->Runs.end())
    {
      std::rotate(back, back + 1, this->Runs.end());
      this->Runs.back() = NoId;
      this->Count -= 2;
    }
    else if (run != NoId && free != this->Runs.end())
    {
      *free = run;
    }
  }
}

} // namespace biting
