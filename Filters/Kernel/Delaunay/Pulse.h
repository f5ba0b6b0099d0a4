// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPulse_h
#define BitingPulse_h

#include "../Base/Monitor.h"

#include <cstdint> // for the count

namespace biting
{

/// Counts small steps and asks the monitor once in 1024 of them whether to go on.
class Pulse
{
public:
  explicit Pulse(Monitor& monitor)
    : Listener(monitor)
  {
  }

  /// The part of the stage, from `begin` to `end` in [0, 1], that the next fractions refer to.
  void BeginPart(double begin, double end)
  {
    this->Begin = begin;
    this->Length = end - begin;
    this->Fraction = begin;
  }

  /// How far the part is, in [0, 1]: told to the monitor when it is asked next.
  void SetFraction(double fraction) { this->Fraction = this->Begin + this->Length * fraction; }

  /// One step is done. False, from then on, once the monitor wants to stop.
  bool Beat()
  {
    if ((++this->Count & 1023u) == 0u && !this->Stopped)
    {
      this->Stopped = !this->Listener.Advance(this->Fraction);
    }
    return !this->Stopped;
  }

  bool HasStopped() const { return this->Stopped; }

private:
  Monitor& Listener;
  double Begin = 0.0;
  double Length = 1.0;
  double Fraction = 0.0;
  std::uint64_t Count = 0;
  bool Stopped = false;
};

} // namespace biting

#endif
