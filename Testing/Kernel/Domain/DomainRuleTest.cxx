// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Domain/Domain.h"
#include "Support/PolylineShapes.h"
#include "Support/RuleOracle.h"

#include <gtest/gtest.h>

#include <cmath>  // for abs
#include <random> // for drawings

namespace biting
{

namespace
{

constexpr DomainRule AllRules[] = { DomainRule::EvenOdd, DomainRule::OuterMinusOthers,
  DomainRule::Union };

MadeDomain MakeBy(DomainRule rule, const Polylines& input)
{
  MadeDomain made;
  SilentMonitor monitor;
  DomainOptions options;
  options.Rule = rule;
  made.Domain = MakeDomain(input, options, made.Problems, monitor);
  made.Violation = CheckDomain(made.Domain);
  return made;
}

/// Loops of three to six corners, some of which cross themselves, all over each other.
Loops RandomLoops(std::mt19937& random)
{
  const auto number = [&random] { return static_cast<double>(random() % 10007) / 10007.0; };
  Loops loops(2 + random() % 5);
  for (Loop& loop : loops)
  {
    const double size = 0.2 + 2.0 * number();
    const Point2 corner{ number(), number() };
    for (std::size_t n = 3 + random() % 4; n > 0; --n)
    {
      loop.push_back(corner + size * Point2{ number(), number() });
    }
  }
  return loops;
}

/// Closed chains, chains of one segment each in any direction, or faces.
Polylines DrawingOf(const Loops& loops, unsigned way)
{
  PolylineBuilder builder;
  for (std::size_t k = 0; k < loops.size(); ++k)
  {
    const Loop& loop = loops[k];
    builder.Region(static_cast<Id>(k));
    way != 1 ? builder.Loop(loop, way == 2 ? ChainKind::Face : ChainKind::Automatic) : builder;
    for (std::size_t i = 0; way == 1 && i < loop.size(); ++i)
    {
      const Point2& next = loop[(i + 1) % loop.size()];
      i % 2 == 0 ? builder.Chain({ loop[i], next }) : builder.Chain({ next, loop[i] });
    }
  }
  return builder.Lines();
}

/// Whether each segment divides the parts at its two sides.
void ExpectParts(const Domain& domain, const Loops& loops, DomainRule rule, Id outer)
{
  for (Id s = 0; s < domain.NumberOfSegments(); ++s)
  {
    const Point2& a = domain.Vertices[domain.Starts[s]];
    const Point2& b = domain.Vertices[domain.Ends[s]];
    const Point2 side = 1e-9 / Distance(a, b) * Point2{ a.Y - b.Y, b.X - a.X };
    const Point2 middle = 0.5 * (a + b);
    const Id left = PartAt(loops, rule, outer, middle + side);
    const Id right = PartAt(loops, rule, outer, middle - side);
    if (Distance(a, b) > 1e-6)
    {
      EXPECT_EQ(left != NoId, domain.LeftInside[s] != 0);
      EXPECT_EQ(right != NoId, domain.RightInside[s] != 0);
      EXPECT_TRUE(left != right || rule == DomainRule::EvenOdd);
    }
  }
}

TEST(DomainRule, GivesTheAreaOfAnyLoopsHoweverTheyAreDrawn)
{
  std::mt19937 random(46);
  int empty = 0;
  for (int round = 0; round < 400; ++round)
  {
    const Loops loops = RandomLoops(random);
    const Id outer = LargestOf(loops);
    const unsigned way = static_cast<unsigned>(round % 3);
    for (const DomainRule rule : AllRules)
    {
      const bool isSure = rule != DomainRule::EvenOdd || way != 1;
      const MadeDomain made = MakeBy(rule, DrawingOf(loops, way));
      const double area = AreaBy(loops, rule, outer);
      EXPECT_EQ(made.Violation, "");
      EXPECT_TRUE(!isSure || std::abs(made.Domain.Area - area) < 1e-9) << round << ' ' << way;
      empty += area == 0.0 ? 1 : 0;
      if (isSure)
      {
        ExpectParts(made.Domain, loops, rule, outer);
      }
    }
  }
  EXPECT_LT(empty, 60);
}

TEST(DomainRule, MakesASeaOfABoxAndAShorelineThatLeavesIt)
{
  PolylineBuilder builder;
  builder.Box(0, 0, 10, 10).Box(8, -3, 14, 4).Box(12, 6, 13, 7);
  const MadeDomain made = MakeBy(DomainRule::OuterMinusOthers, builder.Lines());
  EXPECT_EQ(made.Domain.Area, 92.0);
  EXPECT_TRUE(made.Problems.Groups().empty());
}

TEST(DomainRule, PutsTheLaterFaceOnTop)
{
  PolylineBuilder builder;
  builder.Region(1).Loop({ { 0, 0 }, { 6, 0 }, { 6, 6 }, { 0, 6 } }, ChainKind::Face);
  builder.Region(2).Loop({ { 4, 4 }, { 10, 4 }, { 10, 10 }, { 4, 10 } }, ChainKind::Face);
  const MadeDomain made = MakeBy(DomainRule::Union, builder.Lines());
  EXPECT_EQ(made.Domain.Area, 68.0);
  EXPECT_TRUE(made.Problems.Groups().empty());
  EXPECT_EQ(made.Domain.NumberOfSegments(), 10); // of the first face four, cut; of the second six
  EXPECT_EQ(made.Domain.NumberOfVertices(), 9);  // that of the first within the second is dropped
}

TEST(DomainRule, KeepsNoBorderWithinOneRegion)
{
  PolylineBuilder builder;
  builder.Region(1).Loop({ { 0, 0 }, { 6, 0 }, { 6, 6 }, { 0, 6 } }, ChainKind::Face);
  builder.Loop({ { 4, 4 }, { 10, 4 }, { 10, 10 }, { 4, 10 } }, ChainKind::Face);
  const MadeDomain made = MakeBy(DomainRule::Union, builder.Lines());
  EXPECT_EQ(made.Domain.Area, 68.0);
  EXPECT_EQ(made.Domain.NumberOfSegments(), 8);
}

TEST(DomainRule, EvenOddTellsOfAFaceWithinAnother)
{
  PolylineBuilder builder;
  builder.Loop({ { 0, 0 }, { 9, 0 }, { 9, 9 }, { 0, 9 } }, ChainKind::Face);
  builder.Loop({ { 4, 4 }, { 6, 4 }, { 6, 6 }, { 4, 6 } }, ChainKind::Face);
  const MadeDomain made = MakeBy(DomainRule::EvenOdd, builder.Lines());
  EXPECT_EQ(made.Domain.Area, 77.0);
  ASSERT_EQ(made.Problems.Count(ProblemCode::NestedCells), 1);
  EXPECT_EQ(made.Problems.Groups().front().First.front().Ids.front(), 1);
  EXPECT_EQ(MakeBy(DomainRule::Union, builder.Lines()).Domain.Area, 81.0);
  EXPECT_FALSE(Make(builder, false).Problems.HasErrors());
}

TEST(DomainRule, LeavesOpenChainsAsInterfaces)
{
  PolylineBuilder builder;
  builder.Box(0, 0, 4, 4)
    .Box(1, 1, 2, 2)
    .Chain({ { 3, 1 }, { 3, 3 } })
    .Chain({ { 3, 2 }, { 5, 2 } });
  const MadeDomain made = MakeBy(DomainRule::OuterMinusOthers, builder.Lines());
  EXPECT_EQ(made.Violation, "");
  EXPECT_EQ(made.Domain.Area, 15.0);
  EXPECT_EQ(made.Problems.Count(ProblemCode::OutsideInterfaces), 1);
}

TEST(DomainRule, RefusesWhereNothingIsLeftOfTheLargestLoop)
{
  PolylineBuilder builder;
  builder.Box(0, 0, 4, 4).Box(-1, -1, 2.1, 4.1).Box(2, -1, 5, 4.1);
  const MadeDomain made = MakeBy(DomainRule::OuterMinusOthers, builder.Lines());
  ASSERT_EQ(made.Problems.Count(ProblemCode::NoClosedLoop), 1);
  EXPECT_EQ(made.Problems.Groups().front().First.front().Detail,
    "the others cover all of the largest loop");
}

} // namespace

} // namespace biting
