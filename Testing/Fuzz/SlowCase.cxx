// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SlowCase.h"

#include <csignal> // for the alarm
#include <cstdio>  // for the line
#include <string>  // for its length

#include <sys/time.h> // for the alarm
#include <unistd.h>   // for write

/// Blocks are freed by the thousand in each case: without the stacks of their allocation, and with
/// fewer of them kept aside, there is time for more cases. ASAN_OPTIONS overrules it, to look at
/// one.
extern "C" const char* __asan_default_options()
{
  return "malloc_context_size=0:quarantine_size_mb=16";
}

namespace biting
{

namespace
{

/// What the alarm tells: a signal handler may neither format nor allocate.
char SlowCase[64];

extern "C" void TellSlowCase(int)
{
  const std::size_t length = std::char_traits<char>::length(SlowCase);
  const bool isWritten = write(STDERR_FILENO, SlowCase, length) > 0;
  _exit(isWritten ? 1 : 2);
}

/// 0: no alarm.
void SetAlarm(int seconds)
{
  itimerval timer{};
  timer.it_value.tv_sec = seconds;
  setitimer(ITIMER_PROF, &timer, nullptr);
}

} // namespace

void BeginCase(std::uint64_t seed, int seconds)
{
  std::snprintf(SlowCase, sizeof(SlowCase), "seed %llu takes too long\n",
    static_cast<unsigned long long>(seed));
  std::signal(SIGPROF, TellSlowCase);
  SetAlarm(seconds);
}

void EndCase()
{
  SetAlarm(0);
}

} // namespace biting
