// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Relaxation/Smoothing.h"
#include "RawMesh.h"

#include <gtest/gtest.h>

#include <cmath> // for sqrt

namespace biting
{

namespace
{

/// A mesh that was smoothed once within limits.
struct SmoothedMesh : Workshop
{
  explicit SmoothedMesh(const SmoothingLimits& limits)
    : Workshop(UnitSquare(0.05))
    , MeanBefore(this->MeanAngle())
    , WorstBefore(this->WorstCotangentOfAll())
    , BeyondBefore(this->CountBeyond(limits))
    , Before(this->Mesh.Points)
  {
    SilentMonitor monitor;
    Pulse pulse(monitor);
    SmoothWithin(this->Mesh, limits, pulse);
    EXPECT_EQ(this->Violation(true), "");
  }

  double MeanAngle() const
  {
    double sum = 0.0;
    const RelaxationMesh mesh = this->Written();
    const Triangulation& triangles = mesh.Triangles;
    const MeshQuality quality =
      MeasureQuality({ mesh.Points, mesh.Spacings, triangles.Corners, triangles.Neighbors });
    for (const double angle : quality.MinimumAngle)
    {
      sum += angle;
    }
    return sum / static_cast<double>(quality.MinimumAngle.size());
  }

  /// How many inner edges are shorter or longer.
  Id CountBeyond(const SmoothingLimits& limits) const
  {
    Id count = 0;
    for (Id edge = 0; edge < this->Mesh.NumberOfEdges(); ++edge)
    {
      if (this->Mesh.IsFirstHalf(edge) && this->Mesh.Marks[edge] == NoId)
      {
        const double length = std::sqrt(this->Mesh.SquaredRelativeLength(edge));
        count += length < limits.ShortestEdge || length > limits.LongestEdge ? 1 : 0;
      }
    }
    return count;
  }

  Id CountMoved() const
  {
    Id count = 0;
    for (std::size_t vertex = 0; vertex < this->Before.size(); ++vertex)
    {
      count += this->Mesh.Points[vertex] == this->Before[vertex] ? 0 : 1;
    }
    return count;
  }

  double MeanBefore;
  double WorstBefore;
  Id BeyondBefore;
  std::vector<Point2> Before;
};

TEST(Smoothing, WithinLimitsMakesShapesBetterAndNoAngleBeyondThemWorse)
{
  const SmoothedMesh smoothed({ CotangentOf40Degrees, 0.7, 1.4 });
  EXPECT_GT(smoothed.MeanAngle(), smoothed.MeanBefore);
  EXPECT_LE(smoothed.WorstCotangentOfAll(), std::max(smoothed.WorstBefore, CotangentOf40Degrees));
  const SmoothedMesh none({ 0.0, 0.7, 1.4 });
  EXPECT_LE(none.WorstCotangentOfAll(), none.WorstBefore);
}

TEST(Smoothing, WithinLimitsOfLengthsLeavesFewerEdgesBeyondThem)
{
  const SmoothingLimits limits{ NoCotangent, 0.9, 1.15 };
  const SmoothedMesh free({ NoCotangent, 0.0, NoCotangent });
  const SmoothedMesh within(limits);
  EXPECT_LT(within.CountBeyond(limits), within.BeyondBefore);
  EXPECT_LT(within.CountMoved(), free.CountMoved());
}

TEST(Smoothing, WithoutRoomForLengthsNothingGetsLongerOrShorter)
{
  const SmoothedMesh stuck({ NoCotangent, NoCotangent, 0.0 });
  EXPECT_EQ(stuck.CountMoved(), 0);
}

} // namespace

} // namespace biting
