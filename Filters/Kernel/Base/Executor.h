// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingExecutor_h
#define BitingExecutor_h

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

} // namespace biting

#endif
