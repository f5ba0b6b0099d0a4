// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPartOfStage_h
#define BitingPartOfStage_h

#include "Monitor.h"

namespace biting
{

/// Shows the progress of one part of a stage as progress of the whole, and remembers whether the
/// monitor wanted to stop: the whole is not asked again then.
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
    this->Stopped =
      this->Stopped || !this->Whole.Advance(this->First + (this->Last - this->First) * fraction);
    return !this->Stopped;
  }

  void BeginStage(const char* text) override { this->Whole.BeginStage(text); }

  Executor& Threads() override { return this->Whole.Threads(); }

  bool HasStopped() const { return this->Stopped; }

private:
  Monitor& Whole;
  double First;
  double Last;
  bool Stopped = false;
};

} // namespace biting

#endif
