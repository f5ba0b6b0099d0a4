// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/OtherReadings.h"

#include <gtest/gtest.h>

namespace biting
{

namespace
{

std::size_t NumberOfReadings(double nearest, double rounding, bool hasHanging)
{
  RemeshInput input;
  input.Points = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 1e-9, 0 }, { 1, 1 + 1e-6 } };
  input.Corners = { 0, 1, 2, 4, 5, 3 };
  input.Rounding = rounding;
  return OtherReadings(input, nearest, hasHanging).size();
}

} // namespace

// No vertices lie between the distances, nor are made one for the larger of them only.
TEST(OtherReadings, AreNoneWhereTheMeshIsTheSame)
{
  for (const double nearest : { 0.0, 1e-10, 1e-8, 1e-7, 1e-5 })
  {
    EXPECT_EQ(NumberOfReadings(nearest, nearest, false), 0u);
    EXPECT_EQ(NumberOfReadings(nearest, 2.0 * nearest, false), 0u);
    EXPECT_EQ(NumberOfReadings(nearest, 2.0 * nearest, true), 1u);
  }
}

TEST(OtherReadings, AreThoseWithMorePointsMadeOneAndWithVerticesAsTheyHang)
{
  for (const double nearest : { 0.0, 1e-10, 1e-7 })
  {
    const double rounding = nearest < 1e-9 ? 1e-8 : 1e-5;
    EXPECT_EQ(NumberOfReadings(nearest, rounding, false), 1u);
    EXPECT_EQ(NumberOfReadings(nearest, rounding, true), 3u);
  }
}

} // namespace biting
