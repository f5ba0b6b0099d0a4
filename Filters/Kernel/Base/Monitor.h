// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMonitor_h
#define BitingMonitor_h

#include <functional> // for what is to be done

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

} // namespace biting

#endif
