// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// The long run: as many made-up inputs as there is time for, each judged by the oracle.
//
//   BitingFuzz [--cases N] [--seed S] [--seconds T] [--write FILE] [--drawings near|rules]
//
// With `--drawings near` they are drawings that nearly meet themselves, and the laws are those of
// NearDrawings.h; each violation is told, and the run goes on. With `rules` they are loops over
// each other, and the laws those of RuleDrawings.h.
//
// Case k has the seed S + k, so `--cases 1 --seed K` repeats the case of seed K, whatever run it
// was found in; `--write` then writes its input as legacy VTK. Prints how many cases a second, and
// what became of them. The first violation, and the first case that computes for longer than ten
// seconds, is told with its seed and ends the run with status 1. Best built with sanitizers:
//
//   cmake -D BITING_SDK=Kernel -D BITING_SANITIZE=address,undefined,float-cast-overflow ...
//
// GuidedFuzz.cxx is the same under the guidance of a fuzzer that watches the branches taken.

#include "FuzzArguments.h"
#include "NearDrawings.h"
#include "Oracle.h"
#include "RuleDrawings.h"
#include "SlowCase.h"

#include <array>    // for the counts
#include <chrono>   // for rates
#include <fstream>  // for the file
#include <iostream> // for the report
#include <string>   // for names

namespace biting
{

namespace
{

using Clock = std::chrono::steady_clock;

constexpr int SecondsPerCase = 10;
constexpr double SecondsPerReport = 60.0;

class Counts
{
public:
  void Add(const FuzzOutcome& outcome)
  {
    ++this->Cases;
    ++this->Verdicts[static_cast<std::size_t>(outcome.Kind)];
    this->Blocks += outcome.IsOfBlocks ? 1 : 0;
  }

  void Print() const
  {
    const std::chrono::duration<double> seconds = Clock::now() - this->Begin;
    std::cout << this->Cases << " cases in " << seconds.count() << " s, "
              << static_cast<double>(this->Cases) / seconds.count()
              << " a second: " << this->Verdicts[0] << " meshes, " << this->Verdicts[1]
              << " repaired meshes, " << this->Verdicts[2] << " refusals, " << this->Verdicts[3]
              << " aborted, " << this->Blocks << " of blocks, " << this->Verdicts[4]
              << " violations" << std::endl;
  }

  double Seconds() const
  {
    return std::chrono::duration<double>(Clock::now() - this->Begin).count();
  }

private:
  Clock::time_point Begin = Clock::now();
  std::uint64_t Cases = 0;
  std::uint64_t Blocks = 0;
  std::array<std::uint64_t, 5> Verdicts{};
};

bool RunCase(std::uint64_t seed, const FuzzArguments& arguments, Counts& counts)
{
  FuzzNumbers numbers(seed);
  const std::string& file = arguments.Text("--write");
  const bool isNear = arguments.Text("--drawings") == "near";
  const bool hasRule = arguments.Text("--drawings") == "rules";
  const NearCase nearCase = isNear ? MakeNearCase(numbers) : NearCase();
  const RuleCase ruleCase = hasRule ? MakeRuleCase(numbers) : RuleCase();
  const FuzzCase fuzzCase = isNear ? nearCase.Case
    : hasRule                      ? ruleCase.Case
                                   : MakeFuzzCase(numbers);
  if (!file.empty())
  {
    std::ofstream stream(file);
    WriteLegacyVtk(stream, fuzzCase.Input, "seed " + std::to_string(seed));
    std::cout << Describe(fuzzCase) << std::endl;
  }
  BeginCase(seed, SecondsPerCase);
  const FuzzOutcome outcome = isNear ? RunNearCase(nearCase)
    : hasRule                        ? RunRuleCase(ruleCase)
                                     : RunFuzzCase(fuzzCase);
  EndCase();
  counts.Add(outcome);
  if (outcome.Kind == Verdict::Violation)
  {
    std::cout << "seed " << seed << ": " << outcome.Violation << "\n"
              << Describe(fuzzCase) << std::endl;
  }
  return outcome.Kind != Verdict::Violation;
}

int RunAll(const FuzzArguments& arguments)
{
  Counts counts;
  double nextReport = SecondsPerReport;
  bool isQuiet = true;
  const std::uint64_t cases = arguments.Count("--cases");
  const bool goesOn = arguments.Text("--drawings") == "near";
  for (std::uint64_t k = 0;
       (isQuiet || goesOn) && k < cases && counts.Seconds() <= arguments.Number("--seconds"); ++k)
  {
    const bool isKept = RunCase(arguments.Count("--seed") + k, arguments, counts);
    isQuiet = isKept && isQuiet;
    if (counts.Seconds() > nextReport)
    {
      counts.Print();
      nextReport += SecondsPerReport;
    }
  }
  counts.Print();
  return isQuiet ? 0 : 1;
}

} // namespace

int RunFuzz(int count, char** texts)
{
  const FuzzArguments arguments(count, texts,
    { { "--cases", "1000000" }, { "--seed", "1" }, { "--seconds", "1e9" }, { "--write", "" },
      { "--drawings", "" } });
  if (!arguments.Valid())
  {
    std::cerr
      << "BitingFuzz [--cases N] [--seed S] [--seconds T] [--write FILE] [--drawings near|rules]\n";
    return 2;
  }
  return RunAll(arguments);
}

} // namespace biting

int main(int count, char** texts)
{
  return biting::RunFuzz(count, texts);
}
