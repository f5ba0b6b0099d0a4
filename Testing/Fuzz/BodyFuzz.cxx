// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Made-up surfaces of space, checked, meshed and filled, against the laws of BodyOracle.h.
//
//   BitingBodyFuzz [--sort body|open|large] [--cases N] [--seed S] [--seconds T] [--write FILE]
//
// Case k has the seed S + k; `--cases 1 --seed K --write FILE` writes the surface of seed K. Each
// violation is told with its seed, and the status is then 1; so it is after the first case that
// computes for longer than two minutes, which ends the run. Every 20th case is run twice, with one
// and with four threads. The report has each kind of refusal, its count, and its smallest case;
// `clean` are closed surfaces without anything that the check tells. With sanitizers: see
// BitingFuzz.cxx.

#include "BodyOracle.h"
#include "FuzzArguments.h"
#include "SlowCase.h"

#include <array>    // for the counts
#include <cctype>   // for words of refusals
#include <chrono>   // for time
#include <fstream>  // for the file
#include <iostream> // for the report
#include <map>      // for refusals
#include <string>   // for words

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

/// Cases that were refused for the same reason.
struct RefusalCount
{
  long long Cases = 0;
  std::uint64_t Seed = 0; ///< of the smallest
  std::size_t Triangles = 0;
};

/// Without figures.
std::string KindOf(const BodyOutcome& outcome)
{
  std::string kind = outcome.IsClean ? "clean: " : "";
  bool isFigure = false;
  for (const char letter : outcome.Refusal)
  {
    const auto byte = static_cast<unsigned char>(letter);
    isFigure = std::isdigit(byte) != 0 || (isFigure && letter != ' ' && letter != ';');
    kind += isFigure || letter == '-' ? "" : std::string(1, letter);
  }
  return kind;
}

struct BodyCounts
{
  std::array<long long, 4> Stages{};
  long long Violations = 0;
  long long Fair = 0;    ///< relaxed bodies of fair surfaces
  long long Slivers = 0; ///< of these with a dihedral angle below 25 degrees
  std::map<std::string, RefusalCount> Refusals;
  double Slowest = 0.0; ///< seconds
  std::uint64_t SlowestSeed = 0;

  void AddRefusal(const BodyOutcome& outcome, std::uint64_t seed, std::size_t triangles)
  {
    RefusalCount& refusal = this->Refusals[KindOf(outcome)];
    if (refusal.Cases == 0 || triangles < refusal.Triangles)
    {
      refusal.Seed = seed;
      refusal.Triangles = triangles;
    }
    ++refusal.Cases;
  }

  void PrintRefusals() const
  {
    for (const auto& [kind, refusal] : this->Refusals)
    {
      std::cout << "  " << refusal.Cases << " x " << kind << " (seed " << refusal.Seed << ", "
                << refusal.Triangles << " triangles)\n";
    }
    std::cout << std::flush;
  }

  void Print(double seconds) const
  {
    std::cout << seconds << " s: " << this->Stages[2] << " bodies (" << this->Fair
              << " fair and relaxed, " << this->Slivers
              << " of these with a dihedral angle below 25 degrees), " << this->Stages[1]
              << " surfaces only, refused by the check " << this->Stages[0] << ", by the mesher "
              << this->Stages[3] << ", " << this->Violations << " violations; slowest "
              << this->Slowest << " s, seed " << this->SlowestSeed << std::endl;
  }
};

void RunCase(std::uint64_t seed, SurfaceSort sort, const std::string& file, BodyCounts& counts)
{
  FuzzNumbers numbers(seed);
  const SurfaceCase surface = MakeSurfaceCase(numbers, sort);
  if (!file.empty())
  {
    std::ofstream stream(file);
    WriteLegacyVtk(stream, surface, "seed " + std::to_string(seed));
  }
  const Clock::time_point begin = Clock::now();
  BeginCase(seed, SecondsPerCase);
  const BodyOutcome outcome = RunSurfaceCase(surface, seed % 20 == 0);
  EndCase();
  if (SecondsSince(begin) > counts.Slowest)
  {
    counts.Slowest = SecondsSince(begin);
    counts.SlowestSeed = seed;
  }
  ++counts.Stages[static_cast<std::size_t>(outcome.Reached)];
  if (!outcome.Refusal.empty())
  {
    counts.AddRefusal(outcome, seed, surface.Input.NumberOfTriangles());
  }
  const bool isFair = surface.IsFair && surface.Options.Surface.Relaxation &&
    surface.Options.MaximumNumberOfBites == 0 && outcome.Reached == BodyOutcome::Stage::Filled;
  const bool isSliver = isFair && outcome.SmallestDihedral < 25.0;
  counts.Fair += isFair ? 1 : 0;
  counts.Slivers += isSliver ? 1 : 0;
  counts.Violations += outcome.Violation.empty() ? 0 : 1;
  if (!outcome.Violation.empty() || !file.empty())
  {
    std::cout << "seed " << seed << " (" << surface.Words << "f " << surface.LargestSize << ", "
              << surface.Input.NumberOfTriangles() << " triangles): " << outcome.Violation << " ["
              << outcome.Refusal << "] smallest dihedral " << outcome.SmallestDihedral << std::endl;
  }
}

SurfaceSort SortOf(const std::string& word)
{
  return word == "open" ? SurfaceSort::Open
    : word == "large"   ? SurfaceSort::Large
                        : SurfaceSort::Body;
}

} // namespace

int RunBodyFuzz(int count, char** texts)
{
  const FuzzArguments arguments(count, texts,
    { { "--cases", "1000000" }, { "--seed", "1" }, { "--seconds", "1e9" }, { "--write", "" },
      { "--sort", "body" } });
  if (!arguments.Valid())
  {
    std::cerr << "BitingBodyFuzz [--sort body|open|large] [--cases N] [--seed S] [--seconds T] "
                 "[--write FILE]\n";
    return 2;
  }
  BodyCounts counts;
  const Clock::time_point begin = Clock::now();
  const std::uint64_t cases = arguments.Count("--cases");
  for (std::uint64_t k = 0; k < cases && SecondsSince(begin) <= arguments.Number("--seconds"); ++k)
  {
    RunCase(arguments.Count("--seed") + k, SortOf(arguments.Text("--sort")),
      arguments.Text("--write"), counts);
    if ((k + 1) % 100 == 0)
    {
      counts.Print(SecondsSince(begin));
    }
  }
  counts.Print(SecondsSince(begin));
  counts.PrintRefusals();
  return counts.Violations == 0 ? 0 : 1;
}

} // namespace biting

int main(int count, char** texts)
{
  return biting::RunBodyFuzz(count, texts);
}
