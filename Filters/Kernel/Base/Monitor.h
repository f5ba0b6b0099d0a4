// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMonitor_h
#define BitingMonitor_h

#include <algorithm>  // for find, max
#include <functional> // for what is to be done
#include <vector>     // for texts

namespace biting
{

/// The threads that the kernel may use. It starts none itself: who calls it hands them in, with the
/// monitor (Monitor::Threads).
class Executor
{
public:
  virtual ~Executor() = default;

  /// At least 1.
  virtual int NumberOfThreads() const = 0;

  /// Calls `work` on as many threads at once as it can, NumberOfThreads at most and one at least,
  /// and returns when all calls have returned. Meanwhile the calling thread calls `watch`, at least
  /// ten times a second. `work` and `watch` throw nothing.
  virtual void Run(const std::function<void()>& work, const std::function<void()>& watch) = 0;
};

/// The calling thread, and no other.
class CallingThread : public Executor
{
public:
  int NumberOfThreads() const override { return 1; }
  void Run(const std::function<void()>& work, const std::function<void()>&) override { work(); }
};

/// For those who have no other.
inline Executor& NoThreads()
{
  static CallingThread executor;
  return executor;
}

/// Where the kernel reports how far it is, learns whether to stop, and finds threads for its work.
/// Called from one thread; each loop calls Advance at least every 1024 steps, or every 4096 of
/// those that take some nanoseconds. Within a stage fractions do not fall.
class Monitor
{
public:
  virtual ~Monitor() = default;

  /// `fraction` in [0, 1] of the current stage. False means: stop, the result is not wanted.
  virtual bool Advance(double fraction) = 0;

  /// A new stage begins; `text` is shown to the user and outlives the call.
  virtual void BeginStage(const char* text) = 0;

  /// What works for the stage. Results do not depend on it.
  virtual Executor& Threads() { return NoThreads(); }
};

/// A monitor that shows nothing and never stops.
class SilentMonitor : public Monitor
{
public:
  bool Advance(double) override { return true; }
  void BeginStage(const char*) override {}
};

/// For those who have no other.
inline Monitor& NoMonitor()
{
  static SilentMonitor monitor;
  return monitor;
}

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
