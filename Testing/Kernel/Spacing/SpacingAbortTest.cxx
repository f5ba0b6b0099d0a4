// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SpacingSources.h"

#include <gtest/gtest.h>

namespace
{

using namespace biting;

/// Stops at one call, and counts.
class StopAt : public SilentMonitor
{
public:
  explicit StopAt(int call)
    : Last(call)
  {
  }

  bool Advance(double fraction) override
  {
    this->HasFallen = this->HasFallen || fraction < this->Fraction || fraction > 1.0;
    this->Fraction = fraction;
    return this->Calls++ < this->Last;
  }

  int Calls = 0;
  bool HasFallen = false;

private:
  int Last;
  double Fraction = 0.0;
};

double JumpAroundMiddle(const Point2& x)
{
  return Length(x - Point2{ 0.5, 0.5 }) < 0.3 ? 0.01 : 0.1;
}

double JumpWithHoles(const Point2& x)
{
  return std::sin(40.0 * x.X) > 0.9 ? NotANumber : JumpAroundMiddle(x);
}

SpacingOptions WithAllJumping()
{
  SpacingOptions options = With(MakeGrid(70, 70, JumpWithHoles));
  options.Sources.emplace_back(Share(MakeTriangulation(40, JumpWithHoles)));
  options.Sources.emplace_back(
    Share(MakeLoop(400, [](double angle) { return 0.02 + 0.01 * std::sin(angle); })));
  options.Floor = Share(MakeLoop(400, [](double) { return 0.002; }));
  const SegmentSource loop = MakeLoop(400, [](double) { return 1.0; });
  FeatureSource features;
  features.Points = loop.Points;
  for (std::size_t end = 0; end < loop.Segments.size(); end += 2)
  {
    features.Starts.push_back(loop.Segments[end]);
    features.Ends.push_back(loop.Segments[end + 1]);
    features.LeftInside.push_back(1);
    features.RightInside.push_back(1);
  }
  options.Features = Share(std::move(features));
  return options;
}

} // namespace

TEST(MakeSpacing, ReportsProgressThatDoesNotFall)
{
  for (double scale : { 0.5, 1.0, 2.0 })
  {
    SpacingOptions options = WithAllJumping();
    options.Scale = scale;
    StopAt monitor(1 << 30);
    ProblemList problems;
    MakeSpacing(options, UnitBox(), problems, monitor);
    EXPECT_FALSE(problems.HasErrors());
    EXPECT_FALSE(monitor.HasFallen);
    EXPECT_GT(monitor.Calls, 100);
  }
}

TEST(MakeSpacing, StopsAtWhicheverCallTheMonitorWants)
{
  const SpacingOptions options = WithAllJumping();
  StopAt counter(1 << 30);
  ProblemList none;
  MakeSpacing(options, UnitBox(), none, counter);
  const int step = std::max(1, counter.Calls / 25);
  for (int call = 0; call < counter.Calls; call += step)
  {
    StopAt monitor(call);
    ProblemList problems;
    const Spacing f = MakeSpacing(options, UnitBox(), problems, monitor);
    ASSERT_EQ(monitor.Calls, call + 1);
    ASSERT_EQ(problems.Count(ProblemCode::Aborted), 1);
    ASSERT_EQ(problems.Groups().size(), 1u);
    ASSERT_EQ(f({ 0.5, 0.5 }), 1.0);
  }
}
