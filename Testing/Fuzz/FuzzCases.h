// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFuzzCases_h
#define BitingFuzzCases_h

#include "Oracle.h"

#include <gtest/gtest.h>

#include <cstdint> // for seeds
#include <fstream> // for inputs to look at
#include <string>  // for names
#include <vector>  // for chains

namespace biting
{

inline FuzzCase CaseOfSeed(std::uint64_t seed, FuzzBlocks blocks = FuzzBlocks::Small)
{
  FuzzNumbers numbers(seed);
  return MakeFuzzCase(numbers, blocks);
}

/// Judges a case; where it fails, its input is written to be looked at.
inline void ExpectKept(const FuzzCase& fuzzCase, const std::string& name)
{
  const FuzzOutcome outcome = RunFuzzCase(fuzzCase);
  if (outcome.Kind == Verdict::Violation)
  {
    const std::string path = "fuzz-" + name + ".vtk";
    std::ofstream file(path);
    WriteLegacyVtk(file, fuzzCase.Input, name);
    ADD_FAILURE() << name << ": " << outcome.Violation << "\n"
                  << Describe(fuzzCase) << "\nThe input is in " << path;
  }
}

/// Of one block, as when the seed was found.
inline void ExpectKept(std::uint64_t seed)
{
  ExpectKept(CaseOfSeed(seed, FuzzBlocks::None), std::to_string(seed));
}

/// Chains of boundary, each with points of its own.
inline FuzzCase BoundaryOf(const std::vector<std::vector<Point2>>& chains, double spacing)
{
  FuzzCase fuzzCase;
  Polylines& input = fuzzCase.Input;
  for (const std::vector<Point2>& chain : chains)
  {
    for (const Point2& place : chain)
    {
      input.Connectivity.push_back(static_cast<Id>(input.Points.size()));
      input.Points.push_back(place);
    }
    input.Cells.push_back(input.NumberOfChains());
    input.Kinds.push_back(ChainKind::Boundary);
    input.Offsets.push_back(static_cast<Id>(input.Connectivity.size()));
  }
  fuzzCase.Options.Spacing.Uniform = spacing;
  return fuzzCase;
}

inline const std::vector<Point2> UnitSquare{ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 },
  { 0.0, 0.0 } };

} // namespace biting

#endif
