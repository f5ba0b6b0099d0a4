// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "../Support/MeshShapes.h"

#include "Blocks/NearTouches.h"

#include <gtest/gtest.h>

#include <algorithm> // for minmax
#include <cmath>     // for cos, sin
#include <limits>    // for epsilon
#include <set>       // for pairs
#include <utility>   // for pairs

namespace biting
{

namespace
{

constexpr double Epsilon = std::numeric_limits<double>::epsilon();

/// Vertices within 10 of the origin, with chains between them.
class Drawn
{
public:
  Drawn() { this->Made.Resolution = 4.0 * 10.0 * Epsilon; }

  Drawn& Chain(const std::vector<Point2>& places, bool isClosed)
  {
    const Id first = this->Made.NumberOfVertices();
    for (const Point2& place : places)
    {
      this->Made.Vertices.push_back(place);
      this->Made.IsEmbedded.push_back(places.size() == 1 ? 1 : 0);
      this->Made.Bounds.Add(place);
    }
    const Id last = this->Made.NumberOfVertices() - 1;
    for (Id vertex = first; vertex < last; ++vertex)
    {
      this->Made.Starts.push_back(vertex);
      this->Made.Ends.push_back(vertex + 1);
    }
    if (isClosed)
    {
      this->Made.Starts.push_back(last);
      this->Made.Ends.push_back(first);
    }
    this->Made.LeftInside.resize(this->Made.Starts.size(), 1);
    this->Made.RightInside.resize(this->Made.Starts.size(), 1);
    return *this;
  }

  Drawn Turned(double angle) const
  {
    Drawn turned = *this;
    for (Point2& p : turned.Made.Vertices)
    {
      p = { std::cos(angle) * p.X - std::sin(angle) * p.Y,
        std::sin(angle) * p.X + std::cos(angle) * p.Y };
    }
    return turned;
  }

  bool Touches(double f = 0.1) const { return !this->Found(f).IsEmpty(); }

  NearTouches Found(double f = 0.1) const
  {
    ProblemList problems;
    const Spacing spacing =
      MakeSpacing(UniformSpacing(f), this->Made.Bounds, problems, NoMonitor());
    SilentMonitor monitor;
    Pulse pulse(monitor);
    return FindNearTouches(this->Made, spacing, pulse);
  }

  double Resolution() const { return this->Made.Resolution; }

private:
  Domain Made;
};

/// Two squares side by side, the second one higher by half a side.
Drawn Squares(double gap)
{
  const double left = 3.0 + gap;
  return Drawn()
    .Chain({ { 0.0, 0.0 }, { 3.0, 0.0 }, { 3.0, 3.0 }, { 0.0, 3.0 } }, true)
    .Chain({ { left, 1.5 }, { left + 3.0, 1.5 }, { left + 3.0, 4.5 }, { left, 4.5 } }, true);
}

Drawn Angle(double angle)
{
  return Drawn().Chain(
    { { 4.0 * std::cos(angle), 4.0 * std::sin(angle) }, { 0.0, 0.0 }, { 3.0, 0.0 } }, false);
}

} // namespace

TEST(NearTouches, SegmentsAsNearAsRoundingTouchInAnyDirection)
{
  const double resolution = Drawn().Resolution();
  for (const double turn : { 0.0, 0.3, 1.0, 2.5 })
  {
    EXPECT_TRUE(Squares(resolution).Turned(turn).Touches());
    EXPECT_TRUE(Squares(4.0 * resolution).Turned(turn).Touches());
    EXPECT_FALSE(Squares(16.0 * resolution).Turned(turn).Touches());
    EXPECT_FALSE(Squares(1e-3).Turned(turn).Touches());
  }
}

/// The sides that lie beside each other, and the two that end there.
TEST(NearTouches, TellsWhichSegmentsTouch)
{
  const NearTouches touches = Squares(Drawn().Resolution()).Found();
  std::set<std::pair<Id, Id>> pairs;
  for (const NearTouches::Pair& pair : touches.Pairs)
  {
    pairs.insert(std::minmax(pair.First, pair.Second));
  }
  EXPECT_EQ(pairs, (std::set<std::pair<Id, Id>>{ { 1, 4 }, { 1, 7 }, { 2, 7 } }));
  EXPECT_FALSE(touches.AreEverywhere);
}

/// The first vertices on both are as far from the corner as f is long.
TEST(NearTouches, SegmentsThatLeaveAVertexTouchWhereFIsTooSmallToTellThemApart)
{
  for (const double turn : { 0.0, 0.3, 1.0, 2.5 })
  {
    EXPECT_TRUE(Angle(1e-13).Turned(turn).Touches());
    EXPECT_FALSE(Angle(1e-11).Turned(turn).Touches());
    EXPECT_TRUE(Angle(1e-11).Turned(turn).Touches(1e-3));
    EXPECT_FALSE(Angle(1e-3).Turned(turn).Touches(1e-3));
  }
}

TEST(NearTouches, EmbeddedPointsTouchSegmentsNearby)
{
  Drawn drawn = Squares(1.0);
  EXPECT_FALSE(Drawn(drawn).Chain({ { 1.0, 1.0 } }, false).Touches());
  EXPECT_TRUE(Drawn(drawn).Chain({ { 1.0, drawn.Resolution() } }, false).Touches());
}

} // namespace biting
