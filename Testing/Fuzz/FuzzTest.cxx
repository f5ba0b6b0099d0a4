// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "EvenOddArea.h"
#include "FuzzCases.h"
#include "JudgedMesh.h"
#include "NearDrawings.h"
#include "RuleDrawings.h"

#include <gtest/gtest.h>

#include <algorithm> // for reverse
#include <cmath>     // for nextafter
#include <limits>    // for infinity
#include <memory>    // for sources
#include <numeric>   // for seeds

namespace biting
{

namespace
{

constexpr std::uint64_t FirstSeed = 1;
constexpr std::uint64_t NumberOfCases = 1000;

TEST(Fuzz, MadeUpInputGivesAValidMeshOrOneClearMessage)
{
  for (std::uint64_t seed = FirstSeed; seed < FirstSeed + NumberOfCases; ++seed)
  {
    ExpectKept(CaseOfSeed(seed), std::to_string(seed));
  }
}

/// Without this, a generator that makes nothing would pass.
TEST(Fuzz, AllVerdictsOccur)
{
  int counts[5] = {};
  int ofBlocks = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed)
  {
    const FuzzOutcome outcome = RunFuzzCase(CaseOfSeed(seed));
    ++counts[static_cast<int>(outcome.Kind)];
    ofBlocks += outcome.IsOfBlocks ? 1 : 0;
  }
  EXPECT_GT(ofBlocks, 1);
  EXPECT_GT(counts[static_cast<int>(Verdict::Mesh)], 2);
  EXPECT_GT(counts[static_cast<int>(Verdict::RepairedMesh)], 20);
  EXPECT_GT(counts[static_cast<int>(Verdict::Refusal)], 10);
  EXPECT_GT(counts[static_cast<int>(Verdict::Aborted)], 0);
}

/// The last seeds: a segment that welding made, far shorter than the spacing; ends that moved when
/// they were merged; outlines of which one end is joined with a side, and another is just too far.
TEST(Fuzz, WhatNearlyTouchesIsMeantOrToldOf)
{
  std::vector<std::uint64_t> seeds(200);
  std::iota(seeds.begin(), seeds.end(), FirstSeed);
  seeds.insert(seeds.end(), { 1121, 2266, 581, 1859, 1898, 100141 });
  for (const std::uint64_t seed : seeds)
  {
    FuzzNumbers numbers(seed);
    EXPECT_EQ(RunNearCase(MakeNearCase(numbers)).Violation, "") << "seed " << seed;
  }
}

TEST(Fuzz, DomainsAreWhatTheirRuleSays)
{
  for (std::uint64_t seed = FirstSeed; seed < FirstSeed + 200; ++seed)
  {
    FuzzNumbers numbers(seed);
    EXPECT_EQ(RunRuleCase(MakeRuleCase(numbers)).Violation, "") << "seed " << seed;
  }
}

TEST(Fuzz, BytesMakeCasesToo)
{
  std::vector<std::uint8_t> bytes;
  for (int length = 0; length < 200; ++length)
  {
    FuzzNumbers numbers(bytes.data(), bytes.size());
    ExpectKept(MakeFuzzCase(numbers), "bytes-" + std::to_string(length));
    bytes.push_back(static_cast<std::uint8_t>(length * 73 + 5));
  }
}

double AreaOf(const std::vector<std::vector<Point2>>& chains)
{
  const EvenOddArea area = MeasureEvenOddArea(ReadDrawing(BoundaryOf(chains, 1.0).Input));
  return area.Area.convert_to<double>();
}

/// Moved by 2^40, with 2^-12 the unit of length, all products have more digits than a double.
TEST(EvenOddArea, IsExactWhereverSegmentsMeet)
{
  for (const double shift : { 0.0, 0x1p40 })
  {
    const double unit = shift == 0.0 ? 1.0 : 0x1p-12;
    const auto area = [shift, unit](std::vector<std::vector<Point2>> chains)
    {
      for (std::vector<Point2>& chain : chains)
      {
        for (Point2& p : chain)
        {
          p = unit * p + Point2{ shift, -shift };
        }
      }
      return AreaOf(chains) / (unit * unit);
    };
    const std::vector<Point2> box{ { 0, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 }, { 0, 0 } };
    const std::vector<Point2> within{ { 1, 1 }, { 2, 1 }, { 2, 2 }, { 1, 2 }, { 1, 1 } };
    const std::vector<Point2> across{ { 1, 1 }, { 3, 1 }, { 3, 3 }, { 1, 3 }, { 1, 1 } };
    const std::vector<Point2> low{ { 0, 0 }, { 1, 0 }, { 0, 1 }, { 0, 0 } };
    const std::vector<Point2> high{ { 0, 0 }, { 1, 0 }, { 1, 2 }, { 0, 0 } };
    EXPECT_EQ(area({ box }), 4.0);
    EXPECT_EQ(area({ box, box }), 0.0);
    EXPECT_EQ(area({ box, box, box }), 4.0);
    EXPECT_EQ(area({ box, within }), 3.0);
    EXPECT_EQ(area({ box, across }), 6.0);
    EXPECT_EQ(area({ { { 0, 0 }, { 3, 1 }, { 3, 0 }, { 0, 1 }, { 0, 0 } } }), 1.5);
    EXPECT_EQ(area({ low, high }), 5.0 / 6.0);
    EXPECT_EQ(area({ low, { { 5, 0 }, { 7, 0 }, { 5, 0 } } }), 0.5);
  }
}

/// The oracle must see what is wrong, or its silence means nothing.
TEST(Oracle, SeesWhatIsWrongWithAMesh)
{
  const FuzzCase fuzzCase = BoundaryOf({ UnitSquare }, 0.25);
  ProblemList problems;
  SilentMonitor monitor;
  const BitingMesh mesh = MakeBitingMesh(fuzzCase.Input, fuzzCase.Options, problems, monitor);
  const auto violationOf = [&fuzzCase](const BitingMesh& spoiled)
  { return FindMeshViolation(spoiled, fuzzCase.Input, fuzzCase.Options); };
  EXPECT_EQ(violationOf(mesh), "");

  BitingMesh spoiled = mesh;
  std::swap(spoiled.Corners[0], spoiled.Corners[1]);
  EXPECT_NE(violationOf(spoiled), "");
  spoiled = mesh;
  spoiled.Points.back() = spoiled.Points.front();
  EXPECT_NE(violationOf(spoiled), "");
  spoiled = mesh;
  spoiled.Neighbors[4] = 0;
  EXPECT_NE(violationOf(spoiled), "");
  spoiled = mesh;
  spoiled.EdgeIsBoundary[0] = 0;
  EXPECT_NE(violationOf(spoiled), "");
  spoiled = mesh;
  spoiled.Regions[0] = 1;
  EXPECT_NE(violationOf(spoiled), "");
  spoiled = mesh;
  spoiled.Quality.MinimumAngle[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(violationOf(spoiled), "");
}

TEST(Oracle, SeesAMissingSegmentPointAndArea)
{
  const FuzzCase small = BoundaryOf({ UnitSquare }, 0.25);
  ProblemList problems;
  SilentMonitor monitor;
  const BitingMesh mesh = MakeBitingMesh(small.Input, small.Options, problems, monitor);
  const auto violationFor = [&mesh](FuzzCase other, ChainKind kind)
  {
    other.Input.Kinds.back() = kind;
    return FindMeshViolation(mesh, other.Input, other.Options);
  };
  const std::vector<Point2> hole{ { 0.3, 0.3 }, { 0.6, 0.3 }, { 0.6, 0.6 }, { 0.3, 0.3 } };
  const std::vector<Point2> line{ { 0.31, 0.3 }, { 0.61, 0.6 } };
  EXPECT_NE(violationFor(BoundaryOf({ UnitSquare, hole }, 0.25), ChainKind::Boundary), "");
  EXPECT_NE(violationFor(BoundaryOf({ UnitSquare, line }, 0.25), ChainKind::Interface), "");
  EXPECT_NE(violationFor(BoundaryOf({ UnitSquare, line }, 0.25), ChainKind::EmbeddedPoint), "");
}

} // namespace

} // namespace biting
