// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Relaxation/LongEdges.h"
#include "RawMesh.h"
#include "Relaxation/Star.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

constexpr double Longest = 1.3;

/// A mesh whose inner edges are split.
struct SplitMesh : Workshop
{
  explicit SplitMesh(double longest, double greatestCotangent = CotangentOf20Degrees)
    : Workshop(UnitSquare(0.05))
    , Before(this->Mesh.NumberOfVertices())
    , LongBefore(this->CountLong())
    , WorstBefore(this->WorstCotangentOfAll())
  {
    SilentMonitor monitor;
    Pulse pulse(monitor);
    SplitLongEdges(this->Mesh, longest, greatestCotangent, pulse);
    EXPECT_EQ(this->Violation(true), "");
  }

  Id CountLong() const
  {
    Id count = 0;
    for (Id edge = 0; edge < this->Mesh.NumberOfEdges(); ++edge)
    {
      count += this->Mesh.IsFirstHalf(edge) && this->Mesh.Marks[edge] == NoId &&
          this->Mesh.SquaredRelativeLength(edge) > Longest * Longest
        ? 1
        : 0;
    }
    return count;
  }

  Id Before;
  Id LongBefore;
  double WorstBefore;
};

TEST(LongEdges, AreFewerAfterwardsAndNoAngleIsWorse)
{
  const SplitMesh split(Longest);
  EXPECT_GT(split.Mesh.NumberOfVertices(), split.Before);
  EXPECT_LT(split.CountLong(), split.LongBefore);
  EXPECT_LE(split.WorstCotangentOfAll(), std::max(split.WorstBefore, CotangentOf20Degrees));
}

TEST(LongEdges, AreNotSplitWhereNoneIsTooLong)
{
  const SplitMesh split(1e9);
  EXPECT_EQ(split.Mesh.NumberOfVertices(), split.Before);
}

TEST(LongEdges, AreSplitMoreOftenWhereAnglesMayBeSmaller)
{
  const SplitMesh strict(Longest, 0.0);
  const SplitMesh loose(Longest, CotangentOf20Degrees);
  EXPECT_LT(loose.CountLong(), strict.CountLong());
}

/// Spokes of two spacings from the middle of a wheel.
RawMesh Wheel(int corners)
{
  return RawMesh(PolylineBuilder()
                   .Loop(RegularPolygon({ 0.0, 0.0 }, 1.0, corners))
                   .Chain({ { 0.0, 0.0 } }, ChainKind::EmbeddedPoint)
                   .Lines(),
    UniformSpacing(0.5), 0.7, 0);
}

TEST(LongEdges, StayBesideVerticesOfMoreTrianglesThanCanBeJudged)
{
  for (const int corners : { Star::Capacity, Star::Capacity + 1 })
  {
    Workshop wheel(Wheel(corners));
    ASSERT_EQ(wheel.Mesh.NumberOfEdges() / 4, corners);
    SilentMonitor monitor;
    Pulse pulse(monitor);
    const Id before = wheel.Mesh.NumberOfVertices();
    SplitLongEdges(wheel.Mesh, Longest, 1e9, pulse);
    EXPECT_EQ(wheel.Mesh.NumberOfVertices() > before, corners == Star::Capacity);
    EXPECT_EQ(wheel.Violation(true), "");
  }
}

} // namespace

} // namespace biting
