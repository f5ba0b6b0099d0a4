// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Space/Quality/TetQuality.h"

#include <gtest/gtest.h>

#include <cmath> // for sqrt

namespace biting
{

namespace
{

const std::vector<double> NoSpacing;

} // namespace

TEST(TetQuality, KnowsTheRegularTetrahedron)
{
  const std::vector<Point3> points{ { 1.0, 1.0, 1.0 }, { 1.0, -1.0, -1.0 }, { -1.0, 1.0, -1.0 },
    { -1.0, -1.0, 1.0 } };
  const TetQuality quality = MeasureTetrahedra({ points, NoSpacing, { 0, 1, 2, 3 } });
  EXPECT_NEAR(quality.SmallestDihedralAngle, 70.528779365509, 1e-10);
  EXPECT_NEAR(quality.LargestDihedralAngle, 70.528779365509, 1e-10);
  EXPECT_NEAR(quality.LargestRadiusEdgeRatio, std::sqrt(3.0 / 8.0), 1e-14);
  EXPECT_NEAR(quality.AspectRatio.front(), 3.0, 1e-14);
  EXPECT_EQ(quality.NumberOfVertices, 4);
  EXPECT_EQ(quality.NumberOfSlivers, 0);
  EXPECT_EQ(quality.NearestNeighborDistance[0], std::sqrt(8.0));
}

TEST(TetQuality, IsTheSameForEitherOrientation)
{
  const std::vector<Point3> points{ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.2, 1.1, 0.0 },
    { 0.3, 0.2, 0.7 }, { 0.3, 0.2, -0.9 } };
  const std::vector<double> spacing{ 1.0, 1.0, 1.0, 0.5, 2.0 };
  const TetQuality a = MeasureTetrahedra({ points, spacing, { 0, 1, 2, 3, 0, 2, 1, 4 }, true });
  const TetQuality b = MeasureTetrahedra({ points, spacing, { 0, 2, 1, 3, 2, 0, 1, 4 }, true });
  EXPECT_NEAR(a.SmallestDihedralAngle, b.SmallestDihedralAngle, 1e-12);
  EXPECT_NEAR(a.LargestRadiusEdgeRatio, b.LargestRadiusEdgeRatio, 1e-12);
  EXPECT_EQ(a.RelativeLengths, b.RelativeLengths);
  EXPECT_EQ(a.RelativeLengths.size(), 9u);
  EXPECT_EQ(a.Conformity, b.Conformity);
}

TEST(TetQuality, CountsSlivers)
{
  // Four points nearly on the equator of a sphere: short edges, no volume.
  const std::vector<Point3> points{ { 1.0, 0.0, 0.02 }, { 0.0, 1.0, -0.02 }, { -1.0, 0.0, 0.02 },
    { 0.0, -1.0, -0.02 } };
  const TetQuality quality = MeasureTetrahedra({ points, NoSpacing, { 0, 1, 2, 3 } });
  EXPECT_EQ(quality.NumberOfSlivers, 1);
  EXPECT_LT(quality.SmallestDihedralAngle, 5.0);
  EXPECT_LT(quality.LargestRadiusEdgeRatio, 1.0);
}

TEST(TetQuality, GivesFlatOnesTheWorst)
{
  const std::vector<Point3> points{ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 },
    { 1.0, 1.0, 0.0 } };
  const TetQuality quality = MeasureTetrahedra({ points, NoSpacing, { 0, 1, 2, 3 } });
  EXPECT_EQ(quality.SmallestDihedralAngle, 0.0);
  EXPECT_EQ(quality.LargestDihedralAngle, 180.0);
  EXPECT_TRUE(std::isinf(quality.LargestRadiusEdgeRatio));
}

} // namespace biting
