// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMonitors_h
#define BitingMonitors_h

#include "Base/Monitor.h"

#include <string> // for texts
#include <vector> // for lists

namespace biting
{

/// Wants to stop from a given call of Advance on, and counts how often it is asked.
class StoppingMonitor : public SilentMonitor
{
public:
  explicit StoppingMonitor(int callsUntilStop)
    : CallsUntilStop(callsUntilStop)
  {
  }

  bool Advance(double fraction) override
  {
    this->Fraction = fraction;
    return this->Calls++ < this->CallsUntilStop;
  }

  bool HasStopped() const { return this->Calls > this->CallsUntilStop; }

  int Calls = 0;
  double Fraction = 0.0; ///< what was told last

private:
  int CallsUntilStop;
};

/// Remembers the stages and all fractions of each.
class RecordingMonitor : public Monitor
{
public:
  bool Advance(double fraction) override
  {
    this->Fractions.push_back(fraction);
    if (!this->CallsOfStages.empty())
    {
      ++this->CallsOfStages.back();
    }
    return true;
  }

  void BeginStage(const char* text) override
  {
    this->Stages.push_back(text);
    this->Begins.push_back(this->Fractions.size());
    this->CallsOfStages.push_back(0);
  }

  std::vector<double> Fractions;   ///< of all stages
  std::vector<std::string> Stages; ///< texts
  std::vector<std::size_t> Begins; ///< of the stages, in Fractions
  std::vector<int> CallsOfStages;
};

} // namespace biting

#endif
