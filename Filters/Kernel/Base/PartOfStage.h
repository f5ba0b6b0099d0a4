// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPartOfStage_h
#define BitingPartOfStage_h

#include "Monitor.h"

#include <algorithm> // for find, max
#include <vector>    // for texts

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

/// Shows each stage once, where work is done a second time: stages that were shown before are not
/// shown again, and progress stands still until the last of them is as far as it was.
class StagesOnce : public Monitor
{
public:
  explicit StagesOnce(Monitor& whole)
    : Whole(whole)
  {
  }

  bool Advance(double fraction) override
  {
    this->Fraction = this->IsRepeating ? this->Fraction : std::max(this->Fraction, fraction);
    return this->Whole.Advance(this->Fraction);
  }

  void BeginStage(const char* text) override
  {
    if (std::find(this->Shown.begin(), this->Shown.end(), text) == this->Shown.end())
    {
      this->Shown.push_back(text);
      this->Fraction = 0.0;
      this->IsRepeating = false;
      this->Whole.BeginStage(text);
      return;
    }
    this->IsRepeating = text != this->Shown.back();
  }

  Executor& Threads() override { return this->Whole.Threads(); }

private:
  Monitor& Whole;
  std::vector<const char*> Shown;
  double Fraction = 0.0; ///< of the last stage
  bool IsRepeating = false;
};

} // namespace biting

#endif
