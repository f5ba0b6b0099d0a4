// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SimplifiedDrawing.h"

#include <gtest/gtest.h>

namespace biting
{

TEST(ChainReduction, AVertexOppositeAsNearAsTheErrorIsInTheWayInWhateverDirection)
{
  // Between (1, 1) and (0, 0) first (1, 2) goes, then (0, 2) would, if (2, 0) were not as near to
  // that segment on the other side. Other vertices stay as they are between two tags.
  SimplificationOptions options;
  options.Tolerance = 0.2;
  options.CornerAngle = 181.0;
  options.AreAlike = [](Id first, Id second) { return first == second; };
  const Polylines lines = PolylineBuilder()
                            .Chain({ { 2, 0 }, { 1, 1 } })
                            .Chain({ { 1, 1 }, { 1, 2 }, { 0, 2 }, { 0, 0 } })
                            .Chain({ { 0, 0 }, { -20, 0 } })
                            .Chain({ { -20, 0 }, { 1, -20 } })
                            .Chain({ { 1, -20 }, { 2, 0 } })
                            .Lines();
  for (int degrees = 0; degrees < 360; degrees += 5)
  {
    const Point2 axis = 3.7 * UnitVector(degrees);
    const Polylines moved =
      Move(lines, [&axis](const Point2& p) { return p.X * axis + p.Y * Perpendicular(axis); });
    const Simplified made = SimplifyLines(moved, options, [](const Point2&) { return 3.7 * 7.5; });
    EXPECT_EQ(made.Violation, "");
    EXPECT_EQ(made.After.RemovedVertices, 1);
  }
}

} // namespace biting
