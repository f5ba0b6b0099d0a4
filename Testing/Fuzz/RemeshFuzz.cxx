// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Meshes of made-up drawings, made anew for made-up spacings, against the laws of remeshing.
// BitingRemeshFuzz [--cases N] [--seed S] [--seconds T]; the first violation ends it with 1, a case
// that takes too long with 1, too.

#include "../Kernel/Support/RemeshLaws.h"
#include "RandomInput.h"
#include "SlowCase.h"

#include <chrono>   // for rates
#include <cstdlib>  // for numbers
#include <iostream> // for the report
#include <string>   // for arguments

namespace biting
{

namespace
{

constexpr int SecondsPerCase = 60;
constexpr std::size_t MostVertices = 20000; // of what is remeshed, for the time

struct Counts
{
  long long Cases = 0;
  long long Meshes = 0;
  long long Unchanged = 0;
  long long Refused = 0;
};

RemeshOptions MakeOptions(const BitingMesh& mesh, FuzzNumbers& numbers)
{
  RemeshOptions options;
  const double scale = numbers.Power(-2, 2);
  const Point2 center =
    mesh.Points[static_cast<std::size_t>(numbers.Below(static_cast<int>(mesh.Points.size())))];
  const double spread = numbers.Power(0, 5) * mesh.Spacing.front();
  const double noise = numbers.OneIn(3) ? numbers.Unit() : 0.0;
  const bool isLocal = numbers.OneIn(2);
  for (std::size_t vertex = 0; vertex < mesh.Points.size(); ++vertex)
  {
    const bool isFar = isLocal && Distance(mesh.Points[vertex], center) > spread;
    options.Values.push_back(
      mesh.Spacing[vertex] * (isFar ? 1.0 : scale) * (1.0 + noise * numbers.Unit()));
  }
  options.Spacing.Gradation = numbers.OneIn(4) ? 0.0 : 0.3;
  options.LimitByFeatureSize = !numbers.OneIn(3);
  options.Relaxation = !numbers.OneIn(5);
  options.Rings = numbers.Below(4);
  options.Edges = static_cast<EdgePolicy>(numbers.OneIn(2) ? numbers.Below(3) : 0);
  if (numbers.OneIn(2))
  {
    options.BoundaryTolerance = numbers.Power(-2, 0);
    options.FeatureAngle = 180.0 * numbers.Unit();
  }
  options.Preference = static_cast<RemeshPreference>(numbers.Below(3));
  options.MaximumNumberOfVertices = 200000;
  return options;
}

std::vector<double> AllowedDistances(const RemeshOptions& options)
{
  const bool mayMove = options.BoundaryTolerance > 0.0 && options.Edges == EdgePolicy::Free;
  std::vector<double> distances;
  for (std::size_t vertex = 0; mayMove && vertex < options.Values.size(); ++vertex)
  {
    distances.push_back(options.BoundaryTolerance * options.Values[vertex]);
  }
  return distances;
}

void FreezeSome(FuzzNumbers& numbers, RemeshInput& input)
{
  if (numbers.OneIn(4))
  {
    for (std::size_t triangle = 0; triangle < input.Corners.size() / 3; ++triangle)
    {
      input.IsFrozen.push_back(numbers.OneIn(6));
    }
  }
}

/// Which law is broken, empty where none.
std::string RunCase(std::uint64_t seed, Counts& counts)
{
  FuzzNumbers numbers(seed);
  FuzzCase fuzzCase = MakeFuzzCase(numbers);
  fuzzCase.Options.MaximumNumberOfBites = -1;
  ProblemList problems;
  const BitingMesh mesh = MakeBitingMesh(fuzzCase.Input, fuzzCase.Options, problems, NoMonitor());
  ++counts.Cases;
  if (mesh.Points.empty() || mesh.Points.size() > MostVertices)
  {
    return {};
  }
  double largest = 0.0;
  for (const Point2& point : mesh.Points)
  {
    largest = std::max({ largest, std::abs(point.X), std::abs(point.Y) });
  }
  RemeshInput input = RemeshInputOf(mesh, RoundingInUlp * 2.2e-16 * largest);
  FreezeSome(numbers, input);
  ProblemList told;
  const RemeshOptions options = MakeOptions(mesh, numbers);
  const RemeshResult result = Remesh(input, options, told, NoMonitor());
  ++(told.HasErrors() ? counts.Refused : result.IsUnchanged ? counts.Unchanged : counts.Meshes);
  if (told.HasErrors())
  {
    const ProblemGroup& group = told.Groups().back();
    const bool isTold = told.Has(ProblemCode::TooManyVertices);
    return isTold ? ""
                  : "refused: problem " + std::to_string(static_cast<int>(group.Code)) + " " +
        group.First.front().Detail;
  }
  const std::vector<double> allowed = AllowedDistances(options);
  return result.IsUnchanged ? "" : RemeshLaws(input, result, allowed).Violation();
}

} // namespace

int RunRemeshFuzz(int count, char** texts)
{
  std::uint64_t seed = 1;
  std::uint64_t cases = 100000;
  double seconds = 1e9;
  for (int k = 1; k + 1 < count; k += 2)
  {
    const std::string name = texts[k];
    seed = name == "--seed" ? std::strtoull(texts[k + 1], nullptr, 10) : seed;
    cases = name == "--cases" ? std::strtoull(texts[k + 1], nullptr, 10) : cases;
    seconds = name == "--seconds" ? std::strtod(texts[k + 1], nullptr) : seconds;
  }
  const auto begin = std::chrono::steady_clock::now();
  const auto elapsed = [begin]()
  { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); };
  Counts counts;
  int broken = 0;
  for (std::uint64_t k = 0; k < cases && elapsed() < seconds; ++k)
  {
    BeginCase(seed + k, SecondsPerCase);
    const std::string violation = RunCase(seed + k, counts);
    EndCase();
    if (!violation.empty())
    {
      ++broken;
      std::cout << "seed " << seed + k << ": " << violation << std::endl;
    }
  }
  std::cout << counts.Cases << " cases in " << elapsed() << " s: " << counts.Meshes << " meshes, "
            << counts.Unchanged << " unchanged, " << counts.Refused << " refused, " << broken
            << " violations" << std::endl;
  return broken == 0 ? 0 : 1;
}

} // namespace biting

int main(int count, char** texts)
{
  return biting::RunRemeshFuzz(count, texts);
}
