// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Blocks/WholeNumbers.h"

#include <gtest/gtest.h>

#include <vector> // for the collars

namespace biting
{

// Two blocks that share three vertices, of which one is used no more. Of the second one a triangle
// is gone, and three are new.
TEST(WholeNumbers, HaveSixtyFourBits)
{
  std::vector<BlockCollar> collars(2);
  for (BlockCollar& collar : collars)
  {
    collar.NumberOfVertices = 2000000000;
    collar.NumberOfTriangles = 2000000000;
    collar.Vertices = { 0, 3 };
    collar.Triangles = { 1, 2 };
  }
  JoinedMesh joined;
  joined.Places = { { 3, 0, 0, 0 }, { 5, 40, 2, 2 }, { 7, 50, 4, 3 } };
  joined.FaceRegions = { 4, 6, 4 };
  joined.Bites.Points.resize(7);
  joined.Triangles.Corners = { 0, 2, 3, 2, 4, 3, 4, 5, 6, 0, 6, 2, 6, 5, 2 };
  joined.Triangles.Regions.resize(5);
  StripChange change;
  change.GoneVertices = { 1 };
  change.Triangles = { 3 };
  const WholeNumbers numbers = NumberWhole(collars, joined, change);
  EXPECT_EQ(numbers.NumberOfVertices, 4000000002);
  EXPECT_EQ(numbers.Triangles.back(), 4000000000);
}

} // namespace biting
