// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

double Level(const Point2&)
{
  return 0.05;
}

/// All problems of options that are expected to be bad; f is 1 then.
std::vector<Problem> ProblemsOf(const SpacingOptions& options)
{
  ProblemList problems;
  SilentMonitor monitor;
  const Spacing spacing = MakeSpacing(options, UnitBox(), problems, monitor);
  EXPECT_TRUE(problems.HasErrors());
  EXPECT_EQ(spacing({ 0.5, 0.5 }), 1.0);
  EXPECT_EQ(problems.Groups().size(), 1u);
  EXPECT_EQ(problems.Groups().front().Code, ProblemCode::BadSpacing);
  return problems.Groups().front().First;
}

void ExpectRefused(const SpacingOptions& options, const std::string& detail)
{
  const std::vector<Problem> problems = ProblemsOf(options);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems.front().Detail, detail);
  EXPECT_TRUE(problems.front().Ids.empty());
}

void ExpectRefusedValue(
  const SpacingOptions& options, std::int64_t id, const Point2& place, const std::string& detail)
{
  const std::vector<Problem> problems = ProblemsOf(options);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems.front().Detail, detail);
  EXPECT_EQ(problems.front().Ids, std::vector<std::int64_t>{ id });
  EXPECT_EQ(problems.front().Place, Point3(place));
}

} // namespace

TEST(MakeSpacing, RefusesValuesOfTheGridThatAreNoSpacing)
{
  const std::pair<double, const char*> cases[] = { { 0.0, "value 0 in the grid source" },
    { -3.0, "value -3 in the grid source" },
    { std::numeric_limits<double>::infinity(), "value inf in the grid source" },
    { -std::numeric_limits<double>::infinity(), "value -inf in the grid source" } };
  for (const auto& bad : cases)
  {
    GridSource grid = MakeGrid(5, 3, Level);
    grid.Values[7] = bad.first;
    ExpectRefusedValue(With(grid), 7, { 0.5, 0.5 }, bad.second);
  }
}

TEST(MakeSpacing, RefusesValuesOfTrianglesThatAreNoSpacing)
{
  TriangulatedSource source = MakeTriangulation(3, Level);
  source.Values[5] = -0.25;
  ExpectRefusedValue(With(source), 5, { 1.0, 0.5 }, "value -0.25 in the triangulated source");
}

TEST(MakeSpacing, RefusesValuesOfSegmentsThatAreNoSpacing)
{
  for (double bad : { 0.0, -1.0, NotANumber })
  {
    SegmentSource source = MakeLoop(8, [](double) { return 1.0; });
    source.Values[3] = bad;
    const std::string text = std::isnan(bad) ? "nan" : bad < 0.0 ? "-1" : "0";
    ExpectRefusedValue(
      With(source), 3, source.Points[3], "value " + text + " in the segment source");
  }
}

TEST(MakeSpacing, ReportsEveryBadValue)
{
  GridSource grid = MakeGrid(5, 3, Level);
  grid.Values[2] = 0.0;
  grid.Values[9] = -1.0;
  SpacingOptions options = With(grid);
  SegmentSource segments = MakeLoop(8, [](double) { return 1.0; });
  segments.Values[0] = -2.0;
  options.Sources.emplace_back(Share(segments));
  options.Scale = -1.0;
  EXPECT_EQ(ProblemsOf(options).size(), 4u);
}

TEST(MakeSpacing, RefusesASourceThatIsOneHole)
{
  const auto hole = [](const Point2&) { return NotANumber; };
  ExpectRefused(With(MakeGrid(4, 4, hole)), "every value is nan in the grid source");
  ExpectRefused(With(MakeTriangulation(4, hole)), "every value is nan in the triangulated source");
}

TEST(MakeSpacing, RefusesTriangulationsWithoutAUsableTriangle)
{
  const TriangulatedSource points{ { { 0.0, 0.0 }, { 1.0, 0.0 } }, { 1.0, 2.0 }, {} };
  ExpectRefused(With(points), "there are points but no triangles in the triangulated source");
  const TriangulatedSource flat{ { { 0.0, 0.0 }, { 1.0, 0.0 }, { 2.0, 0.0 } }, { 1.0, 2.0, 3.0 },
    { 0, 1, 2 } };
  ExpectRefused(With(flat), "no triangle has an area and three values in the triangulated source");
}

TEST(MakeSpacing, RefusesPositionsThatAreNotFinite)
{
  SegmentSource source = MakeLoop(8, [](double) { return 1.0; });
  source.Points[2].Y = NotANumber;
  const std::vector<Problem> problems = ProblemsOf(With(source));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems.front().Ids, std::vector<std::int64_t>{ 2 });
  EXPECT_EQ(problems.front().Detail, "position in the segment source");
}

TEST(MakeSpacing, RefusesNodesThatDoNotAscend)
{
  GridSource grid = MakeGrid(4, 4, Level);
  std::swap(grid.YNodes[1], grid.YNodes[2]);
  ExpectRefused(With(grid), "y nodes do not ascend in the grid source");
  for (const double bad : { NotANumber, std::numeric_limits<double>::infinity() })
  {
    grid = MakeGrid(4, 4, Level);
    grid.XNodes.back() = bad;
    ExpectRefused(With(grid), "x nodes do not ascend in the grid source");
  }
}

TEST(MakeSpacing, RefusesParametersThatAreNoSpacing)
{
  SpacingOptions options;
  options.Uniform = -1.0;
  ExpectRefused(options, "Uniform Spacing is -1");
  options = {};
  options.Scale = 0.0;
  ExpectRefused(options, "Spacing Scale is 0");
  options = {};
  options.Scale = NotANumber;
  ExpectRefused(options, "Spacing Scale is nan");
  options = {};
  options.Minimum = std::numeric_limits<double>::infinity();
  ExpectRefused(options, "Minimum Spacing is inf");
  options = {};
  options.Maximum = -2.0;
  ExpectRefused(options, "Maximum Spacing is -2");
  options = {};
  options.Gradation = NotANumber;
  ExpectRefused(options, "Gradation is nan");
  options = {};
  options.Minimum = 2.0;
  options.Maximum = 1.0;
  ExpectRefused(options, "Minimum Spacing 2 is above Maximum Spacing 1");
}

TEST(MakeSpacing, RefusesValuesThatLeaveTheRangeWhenScaled)
{
  GridSource grid = MakeGrid(5, 3, Level);
  grid.Values[7] = 1e300;
  SpacingOptions options = With(grid);
  options.Scale = 1e10;
  ExpectRefusedValue(options, 7, { 0.5, 0.5 }, "value 1e+300 in the grid source");
}

TEST(SourceCheck, KnowsTheLeastOfAllValuesGiven)
{
  SpacingOptions options;
  EXPECT_EQ(LeastGiven(options), std::numeric_limits<double>::infinity());
  options.Uniform = 0.5;
  EXPECT_EQ(LeastGiven(options), 0.5);
  GridSource grid = MakeGrid(5, 3, Level);
  grid.Values[7] = NotANumber;
  grid.Values[8] = 0.04;
  options.Sources.emplace_back(Share(grid));
  EXPECT_EQ(LeastGiven(options), std::min(0.04, Level({ 0.5, 0.5 })));
  SegmentSource segments = MakeLoop(7, [](double) { return 0.03; });
  segments.Values[5] = 1e-4;
  options.Sources.emplace_back(Share(segments));
  options.Scale = 7.0;
  EXPECT_EQ(LeastGiven(options), 1e-4);
}
