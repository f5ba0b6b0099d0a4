// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Meshes of made-up drawings, made anew for made-up spacings, against the laws of remeshing.
//
//   BitingRemeshFuzz [--cases N] [--seed S] [--seconds T] [--vertices V]
//
// Case k has the seed S + k. Meshes that would have more than V vertices (400) are made with a
// larger spacing, so that many cases fit into a second; V is part of what a case is. Violations
// are told with their seeds, and the status is then 1; so it is after the first case that computes
// for longer than a minute, which ends the run. With sanitizers, in several processes:
//
//   sh Testing/fuzz.sh 200000 1 2 BitingRemeshFuzz

#include "../Kernel/Support/RemeshLaws.h"
#include "FuzzArguments.h"
#include "RandomInput.h"
#include "SlowCase.h"

#include <algorithm> // for max
#include <chrono>    // for rates
#include <cmath>     // for abs
#include <cstdint>   // for seeds
#include <iostream>  // for the report
#include <string>    // for violations

namespace biting
{

namespace
{

constexpr int SecondsPerCase = 60;
constexpr double SecondsPerReport = 60.0;
constexpr int MostCoarsenings = 6;   // of a drawing, until it has few vertices
constexpr int GrowthOfVertices = 10; // at most, by remeshing

struct Counts
{
  long long Cases = 0;
  long long Meshes = 0;
  long long Unchanged = 0;
  long long Refused = 0;
  long long Violations = 0;
};

/// A mesh of at most so many vertices, if a larger spacing makes one.
BitingMesh MeshOf(FuzzCase& fuzzCase, std::int64_t vertices)
{
  fuzzCase.Options.MaximumNumberOfBites = -1;
  fuzzCase.Options.MaximumNumberOfVertices = vertices;
  BitingMesh mesh;
  for (int k = 0; k <= MostCoarsenings; ++k)
  {
    ProblemList problems;
    mesh = MakeBitingMesh(fuzzCase.Input, fuzzCase.Options, problems, NoMonitor());
    if (!problems.Has(ProblemCode::TooManyVertices))
    {
      break;
    }
    fuzzCase.Options.Spacing.Scale *= 4.0;
  }
  return mesh;
}

RemeshOptions MakeOptions(const BitingMesh& mesh, std::int64_t mostVertices, FuzzNumbers& numbers)
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
  options.MaximumNumberOfVertices = mostVertices;
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

/// Whether all triangles are so thin that points which rounding makes one leave none.
bool IsFlat(const RemeshInput& input)
{
  for (std::size_t slot = 0; slot < input.Corners.size(); slot += 3)
  {
    const Point2& a = input.Points[input.Corners[slot]];
    const Point2& b = input.Points[input.Corners[slot + 1]];
    const Point2& c = input.Points[input.Corners[slot + 2]];
    const double longest = std::max({ Distance(a, b), Distance(b, c), Distance(c, a) });
    if (std::abs(Cross(b - a, c - a)) > input.Rounding * longest)
    {
      return false;
    }
  }
  return true;
}

/// Which law is broken, empty where none.
std::string RunCase(std::uint64_t seed, std::int64_t vertices, Counts& counts)
{
  FuzzNumbers numbers(seed);
  FuzzCase fuzzCase = MakeFuzzCase(numbers);
  const BitingMesh mesh = MeshOf(fuzzCase, vertices);
  ++counts.Cases;
  if (mesh.Points.empty())
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
  const RemeshOptions options = MakeOptions(mesh, GrowthOfVertices * vertices, numbers);
  const RemeshResult result = Remesh(input, options, told, NoMonitor());
  ++(told.HasErrors() ? counts.Refused : result.IsUnchanged ? counts.Unchanged : counts.Meshes);
  if (told.HasErrors())
  {
    const ProblemGroup& group = told.Groups().back();
    const bool isTold = told.Has(ProblemCode::TooManyVertices) ||
      (told.Has(ProblemCode::BadTriangles) && IsFlat(input));
    return isTold ? ""
                  : "refused: problem " + std::to_string(static_cast<int>(group.Code)) + " " +
        group.First.front().Detail;
  }
  const std::vector<double> allowed = AllowedDistances(options);
  return result.IsUnchanged ? "" : RemeshLaws(input, result, allowed).Violation();
}

void Print(const Counts& counts, double seconds)
{
  std::cout << counts.Cases << " cases in " << seconds << " s, "
            << static_cast<double>(counts.Cases) / seconds << " a second: " << counts.Meshes
            << " meshes, " << counts.Unchanged << " unchanged, " << counts.Refused << " refused, "
            << counts.Violations << " violations" << std::endl;
}

Counts RunAll(const FuzzArguments& arguments)
{
  const auto begin = std::chrono::steady_clock::now();
  const auto elapsed = [begin]()
  { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); };
  Counts counts;
  double nextReport = SecondsPerReport;
  const std::uint64_t cases = arguments.Count("--cases");
  for (std::uint64_t k = 0; k < cases && elapsed() < arguments.Number("--seconds"); ++k)
  {
    const std::uint64_t seed = arguments.Count("--seed") + k;
    BeginCase(seed, SecondsPerCase);
    const std::string violation =
      RunCase(seed, static_cast<std::int64_t>(arguments.Count("--vertices")), counts);
    EndCase();
    if (!violation.empty())
    {
      ++counts.Violations;
      std::cout << "seed " << seed << ": " << violation << std::endl;
    }
    if (elapsed() > nextReport)
    {
      Print(counts, elapsed());
      nextReport += SecondsPerReport;
    }
  }
  Print(counts, elapsed());
  return counts;
}

} // namespace

int RunRemeshFuzz(int count, char** texts)
{
  const FuzzArguments arguments(count, texts,
    { { "--cases", "100000" }, { "--seed", "1" }, { "--seconds", "1e9" },
      { "--vertices", "400" } });
  if (!arguments.Valid())
  {
    std::cerr << "BitingRemeshFuzz [--cases N] [--seed S] [--seconds T] [--vertices V]\n";
    return 2;
  }
  return RunAll(arguments).Violations == 0 ? 0 : 1;
}

} // namespace biting

int main(int count, char** texts)
{
  return biting::RunRemeshFuzz(count, texts);
}
