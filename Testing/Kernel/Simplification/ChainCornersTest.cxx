// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SimplifiedDrawing.h"

#include <gtest/gtest.h>

namespace biting
{

TEST(ChainCorners, ACornerOfTheDomainStaysHoweverNearAJunctionIs)
{
  for (const double distance : { 0.5, 1.5, 3.0, 4.5, 7.0 })
  {
    const Simplified made = SimplifyLines(PolylineBuilder()
                                            .Box(0.0, 0.0, 100.0, 100.0)
                                            .Chain({ { distance, 0.0 }, { 50.0, 100.0 } })
                                            .Lines(),
      0.2, 10.0);
    EXPECT_EQ(made.After.RemovedVertices, 0);
  }
}

} // namespace biting
