// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPartOfStage_h
#define BitingPartOfStage_h

#include "../Base/Monitor.h"

namespace biting
{

/// Shows the progress of one part of a stage as progress of the whole.
class PartOfStage : public Monitor
{
public:
  /// The part goes from `first` to `last`, fractions of the whole.
  PartOfStage(Monitor& whole, double first, double last)
    : Whole(whole)
    , First(first)
    , Last(last)
  {
  }

  bool Advance(double fraction) override
  {
    return this->Whole.Advance(this->First + (this->Last - this->First) * fraction);
  }

  void BeginStage(const char* text) override { this->Whole.BeginStage(text); }

private:
  Monitor& Whole;
  double First;
  double Last;
};

} // namespace biting

#endif
