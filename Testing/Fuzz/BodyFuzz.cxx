// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Made-up surfaces of space, checked, meshed and filled, against the laws of BodyOracle.h.
//
//   BitingBodyFuzz [--cases N] [--seed S] [--seconds T] [--write FILE]
//
// Case k has the seed S + k; `--cases 1 --seed K --write FILE` writes the surface of seed K. Each
// violation is told with its seed, and the status is then 1; so it is after the first case that
// computes for longer than two minutes, which ends the run. With sanitizers: see BitingFuzz.cxx.

#include "BodyOracle.h"
#include "FuzzArguments.h"
#include "SlowCase.h"

#include <array>    // for the counts
#include <chrono>   // for time
#include <fstream>  // for the file
#include <iostream> // for the report
#include <string>   // for words

/// As in BitingFuzz.cxx.
extern "C" const char* __asan_default_options()
{
  return "malloc_context_size=0:quarantine_size_mb=16";
}

namespace biting
{

namespace
{

using Clock = std::chrono::steady_clock;

constexpr int SecondsPerCase = 120;

double SecondsSince(Clock::time_point begin)
{
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

struct BodyCounts
{
  std::array<long long, 4> Stages{};
  long long Violations = 0;
  long long Fair = 0;    ///< relaxed bodies of fair surfaces
  long long Slivers = 0; ///< of these with a dihedral angle below 25 degrees

  void Print(double seconds) const
  {
    std::cout << seconds << " s: " << this->Stages[2] << " bodies (" << this->Fair
              << " fair and relaxed, " << this->Slivers
              << " of these with a dihedral angle below 25 degrees), " << this->Stages[1]
              << " surfaces only, refused by the check " << this->Stages[0] << ", by the mesher "
              << this->Stages[3] << ", " << this->Violations << " violations" << std::endl;
  }
};

void RunCase(std::uint64_t seed, const std::string& file, BodyCounts& counts)
{
  FuzzNumbers numbers(seed);
  const SurfaceCase surface = MakeSurfaceCase(numbers);
  if (!file.empty())
  {
    std::ofstream stream(file);
    WriteLegacyVtk(stream, surface, "seed " + std::to_string(seed));
  }
  BeginCase(seed, SecondsPerCase);
  const BodyOutcome outcome = RunSurfaceCase(surface);
  EndCase();
  ++counts.Stages[static_cast<std::size_t>(outcome.Reached)];
  const bool isFair = surface.IsFair && surface.Options.Surface.Relaxation &&
    surface.Options.MaximumNumberOfBites == 0 && outcome.Reached == BodyOutcome::Stage::Filled;
  const bool isSliver = isFair && outcome.SmallestDihedral < 25.0;
  counts.Fair += isFair ? 1 : 0;
  counts.Slivers += isSliver ? 1 : 0;
  counts.Violations += outcome.Violation.empty() ? 0 : 1;
  if (!outcome.Violation.empty() || isSliver || !file.empty())
  {
    std::cout << "seed " << seed << " (" << surface.Words << "f " << surface.LargestSize
              << "): " << outcome.Violation << " [" << outcome.Refusal << "] smallest dihedral "
              << outcome.SmallestDihedral << std::endl;
  }
}

} // namespace

int RunBodyFuzz(int count, char** texts)
{
  const FuzzArguments arguments(count, texts,
    { { "--cases", "1000000" }, { "--seed", "1" }, { "--seconds", "1e9" }, { "--write", "" } });
  if (!arguments.Valid())
  {
    std::cerr << "BitingBodyFuzz [--cases N] [--seed S] [--seconds T] [--write FILE]\n";
    return 2;
  }
  BodyCounts counts;
  const Clock::time_point begin = Clock::now();
  const std::uint64_t cases = arguments.Count("--cases");
  for (std::uint64_t k = 0; k < cases && SecondsSince(begin) <= arguments.Number("--seconds"); ++k)
  {
    RunCase(arguments.Count("--seed") + k, arguments.Text("--write"), counts);
    if ((k + 1) % 100 == 0)
    {
      counts.Print(SecondsSince(begin));
    }
  }
  counts.Print(SecondsSince(begin));
  return counts.Violations == 0 ? 0 : 1;
}

} // namespace biting

int main(int count, char** texts)
{
  return biting::RunBodyFuzz(count, texts);
}
