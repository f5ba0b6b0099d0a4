// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Biting/Orientation.h"
#include "../Support/MeshShapes.h"

#include <gtest/gtest.h>

#include <algorithm> // for min
#include <cmath>     // for abs

namespace biting
{

namespace
{

constexpr double Rounding = 1e-12;

/// Whether a side of the square with this axis is parallel to `direction`.
bool HasSideAlong(const Point2& axis, const Point2& direction)
{
  return std::min(std::abs(Cross(axis, direction)), std::abs(Dot(axis, direction))) < Rounding;
}

bool HasDiagonalAlong(const Point2& axis, const Point2& direction)
{
  return std::abs(std::abs(Cross(axis, direction)) - std::abs(Dot(axis, direction))) < Rounding;
}

std::vector<Point2> AxesAt(const Domain& domain, const Point2& place)
{
  Pulse pulse(NoMonitor());
  const VertexAxes axes = OrientVertexBites(domain, pulse);
  for (Id vertex = 0; vertex < domain.NumberOfVertices(); ++vertex)
  {
    if (domain.Vertices[vertex] == place)
    {
      return { axes.Axes.begin() + axes.Offsets[vertex],
        axes.Axes.begin() + axes.Offsets[vertex + 1] };
    }
  }
  return {};
}

// Figure 7. At 135 and 225 degrees, here rounded, either is right.
TEST(SectorAxis, FollowsFigure7AtEveryAngle)
{
  for (int start = 0; start < 360; start += 7)
  {
    for (int angle = 1; angle < 360; ++angle)
    {
      const Point2 axis = SectorAxis(UnitVector(start), UnitVector(start + angle));
      EXPECT_NEAR(Length(axis), 1.0, Rounding);
      const Point2 bisector = UnitVector(start + 0.5 * angle);
      const bool isObtuse = angle >= 135 && angle <= 225;
      const bool isLimit = angle == 135 || angle == 225;
      EXPECT_TRUE((isObtuse && HasSideAlong(axis, bisector)) ||
        ((!isObtuse || isLimit) && HasDiagonalAlong(axis, bisector)))
        << start << " + " << angle;
    }
  }
}

TEST(OrientVertexBites, EachSectorOfAVertexAsksForItsSquare)
{
  const Point2 apex{ 0.0, 0.0 };
  const MadeDomain made =
    Make(PolylineBuilder()
           .Loop({ { -4.0, 0.0 }, apex, { 4.0, 0.0 }, { 4.0, 4.0 }, { -4.0, 4.0 } })
           .Chain({ apex, 2.0 * UnitVector(30.0) }));
  const std::vector<Point2> axes = AxesAt(made.Domain, apex);
  ASSERT_EQ(axes.size(), 2u);
  const bool isFirst = HasDiagonalAlong(axes[0], UnitVector(15.0));
  EXPECT_TRUE(HasDiagonalAlong(axes[isFirst ? 0 : 1], UnitVector(15.0)));
  EXPECT_TRUE(HasSideAlong(axes[isFirst ? 1 : 0], UnitVector(105.0)));
}

TEST(OrientVertexBites, OutsideSectorsDoNotCount)
{
  const Point2 apex{ 0.0, 0.0 };
  const MadeDomain made =
    Make(PolylineBuilder().Loop({ apex, UnitVector(10.0), UnitVector(50.0) }));
  const std::vector<Point2> axes = AxesAt(made.Domain, apex);
  ASSERT_EQ(axes.size(), 1u);
  EXPECT_TRUE(HasDiagonalAlong(axes[0], UnitVector(30.0)));
}

TEST(OrientVertexBites, EndOfAnInterfaceIsOneSectorOf360Degrees)
{
  const Point2 end = 0.5 * UnitVector(20.0);
  const MadeDomain made =
    Make(PolylineBuilder().Box(-1.0, -1.0, 1.0, 1.0).Chain({ { 0.0, 0.0 }, end }));
  const std::vector<Point2> axes = AxesAt(made.Domain, end);
  ASSERT_EQ(axes.size(), 1u);
  EXPECT_TRUE(HasDiagonalAlong(axes[0], UnitVector(20.0)));
}

TEST(OrientVertexBites, EmbeddedPointIsBittenAlongTheAxesOfThePlane)
{
  const MadeDomain made = Make(PolylineBuilder()
                                 .Loop(RegularPolygon({ 0.0, 0.0 }, 1.0, 4, 30.0))
                                 .Chain({ { 0.1, 0.2 } }, ChainKind::EmbeddedPoint));
  const std::vector<Point2> axes = AxesAt(made.Domain, { 0.1, 0.2 });
  ASSERT_EQ(axes.size(), 1u);
  EXPECT_EQ(axes[0], (Point2{ 1.0, 0.0 }));
}

} // namespace

} // namespace biting
