// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPulse_h
#define BitingPulse_h

#include "Monitor.h"

#include <algorithm> // for max, min
#include <cstddef>   // for counts
#include <vector>    // for values

namespace biting
{

/// Takes the steps of loops to a monitor, which is asked once in 1024 of them, or in 4096 that are
/// cheap. Once it wants to stop it is not asked again, and all that follows is refused.
/// The fraction that it is told never falls.
class Pulse
{
public:
  explicit Pulse(Monitor& monitor)
    : Listener(monitor)
  {
  }

  /// How far the part at hand is, in [0, 1]: told to the monitor when it is asked next.
  void SetFraction(double fraction)
  {
    this->Fraction = std::max(this->Fraction, this->Begin + this->Length * fraction);
  }

  /// One step is done, which takes as long as so many cheap ones. False, from then on, once the
  /// monitor wants to stop.
  bool Beat(std::size_t cheapSteps = 4) { return this->Spend(cheapSteps); }

  /// Asks the monitor now; between steps that are long.
  bool Ask()
  {
    this->Stopped = this->Stopped || !this->Listener.Advance(this->Fraction);
    return !this->Stopped;
  }

  /// Does step(i), cheap, for i = 0 .. count - 1, which are all of the part at hand. False, and the
  /// rest is left undone, where the monitor wants to stop.
  template <typename Step>
  bool ForEach(std::size_t count, Step&& step)
  {
    std::size_t end = 0;
    for (std::size_t begin = 0; begin < count && !this->Stopped; begin = end)
    {
      end = std::min(count, begin + CheapStepsPerAsking);
      for (std::size_t i = begin; i < end; ++i)
      {
        step(i);
      }
      this->SetFraction(static_cast<double>(end) / static_cast<double>(count));
      this->Spend(end - begin);
    }
    return !this->Stopped;
  }

  bool HasStopped() const { return this->Stopped; }

  /// Those of the monitor.
  Executor& Threads() const { return this->Listener.Threads(); }

private:
  friend class PulsePart;

  static constexpr std::size_t CheapStepsPerAsking = 4096;

  bool Spend(std::size_t cheapSteps)
  {
    this->Spent += cheapSteps;
    if (this->Spent >= CheapStepsPerAsking)
    {
      this->Spent = 0;
      this->Ask();
    }
    return !this->Stopped;
  }

  Monitor& Listener;
  double Begin = 0.0;
  double Length = 1.0;
  double Fraction = 0.0;
  std::size_t Spent = 0; ///< cheap steps since the monitor was asked
  bool Stopped = false;
};

/// While it lives, the fractions of a pulse refer to the part from `begin` to `end` of what they
/// referred to before.
class PulsePart
{
public:
  PulsePart(Pulse& pulse, double begin, double end)
    : Whole(pulse)
    , Begin(pulse.Begin)
    , Length(pulse.Length)
  {
    pulse.Begin = this->Begin + this->Length * begin;
    pulse.Length = this->Length * (end - begin);
    pulse.SetFraction(0.0);
  }

  ~PulsePart()
  {
    this->Whole.Begin = this->Begin;
    this->Whole.Length = this->Length;
  }

  PulsePart(const PulsePart&) = delete;
  void operator=(const PulsePart&) = delete;

private:
  Pulse& Whole;
  double Begin;
  double Length;
};

/// Takes what is told to a monitor to a pulse: the fractions are those of the part at hand.
class PulseMonitor : public SilentMonitor
{
public:
  explicit PulseMonitor(Pulse& pulse)
    : Beats(pulse)
  {
  }

  bool Advance(double fraction) override
  {
    this->Beats.SetFraction(fraction);
    return this->Beats.Ask();
  }

  Executor& Threads() override { return this->Beats.Threads(); }

private:
  Pulse& Beats;
};

/// Gives the memory of the arrays back, one after the other, and asks the monitor between: that of
/// millions of items takes as long as touching it first.
template <typename... Values>
void ReleaseInSteps(Pulse& pulse, std::vector<Values>&... values)
{
  ((std::vector<Values>().swap(values), pulse.Ask()), ...);
}

} // namespace biting

#endif
