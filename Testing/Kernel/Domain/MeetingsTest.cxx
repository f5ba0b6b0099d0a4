// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// Where segments meet is searched in parts, on the threads of the monitor.

#include "Domain/Meetings.h"
#include "Domain/Domain.h"
#include "Support/PolylineShapes.h"
#include "Support/TestThreads.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

/// Short segments in a square, each of which crosses about one other.
Polylines CrossedSquare(int count)
{
  PolylineBuilder builder;
  builder.Box(0.0, 0.0, 1.0, 1.0);
  TestNumbers numbers(31);
  for (int k = 0; k < count; ++k)
  {
    const Point2 place{ 0.1 + 0.8 * numbers.Unit(), 0.1 + 0.8 * numbers.Unit() };
    const Point2 way{ 0.03 * numbers.Unit(), 0.03 * numbers.Unit() };
    builder.Chain({ place, { place.X + way.X, place.Y - way.Y } }, ChainKind::Interface);
    builder.Chain({ place, place + way }, ChainKind::Interface);
  }
  return builder.Lines();
}

struct Made
{
  Domain Drawing;
  ProblemList Problems;
};

Made MakeOn(int threads, const Polylines& input, const DomainOptions& options)
{
  Made made;
  MonitorWithThreads monitor(threads);
  made.Drawing = MakeDomain(input, options, made.Problems, monitor);
  return made;
}

void ExpectSame(const Made& made, const Made& expected)
{
  EXPECT_EQ(made.Drawing.Vertices, expected.Drawing.Vertices);
  EXPECT_EQ(made.Drawing.Starts, expected.Drawing.Starts);
  EXPECT_EQ(made.Drawing.Ends, expected.Drawing.Ends);
  ASSERT_EQ(made.Problems.Groups().size(), expected.Problems.Groups().size());
  for (std::size_t k = 0; k < made.Problems.Groups().size(); ++k)
  {
    const ProblemGroup& one = made.Problems.Groups()[k];
    const ProblemGroup& other = expected.Problems.Groups()[k];
    EXPECT_EQ(one.Count, other.Count);
    ASSERT_EQ(one.First.size(), other.First.size());
    for (std::size_t i = 0; i < one.First.size(); ++i)
    {
      ASSERT_EQ(one.First[i].Ids, other.First[i].Ids);
      ASSERT_EQ(one.First[i].Detail, other.First[i].Detail);
    }
  }
}

} // namespace

TEST(Meetings, AreTheSameOnAnyNumberOfThreads)
{
  const Polylines input = CrossedSquare(6000);
  const Made expected = MakeOn(1, input, {});
  ASSERT_GT(expected.Drawing.NumberOfSegments(), 15000);
  for (const int threads : { 2, 8 })
  {
    ExpectSame(MakeOn(threads, input, {}), expected);
  }
}

/// One more than allowed: so that the search is given up late.
TEST(Meetings, TooManyAreRefusedAlikeOnAnyNumberOfThreads)
{
  const Polylines input = CrossedSquare(6000);
  const auto crossings = MakeOn(1, input, {}).Problems.Count(ProblemCode::Crossings);
  ASSERT_GT(crossings, 1000);
  DomainOptions options;
  options.MaximumNumberOfCrossings = crossings - 1;
  const Made expected = MakeOn(1, input, options);
  EXPECT_EQ(expected.Problems.Count(ProblemCode::NotResolved), 1);
  for (const int threads : { 2, 8 })
  {
    ExpectSame(MakeOn(threads, input, options), expected);
  }
}

} // namespace biting
