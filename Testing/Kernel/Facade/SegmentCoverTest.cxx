// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Stages/SegmentCover.h"
#include "../Support/PolylineShapes.h"

#include <gtest/gtest.h>

#include <algorithm> // for replace, swap
#include <vector>    // for the arrays

namespace biting
{

namespace
{

/// A square of four triangles about its center, with an interface of two edges along a diagonal:
/// that is segment 4, its parts are constraints 4 and 5.
struct CoveredSquare
{
  biting::Domain Domain =
    Make(PolylineBuilder().Box(0, 0, 2, 2).Chain({ { 0, 0 }, { 2, 2 } })).Domain;
  // The vertices of the domain, and the middle.
  std::vector<Point2> Points{ { 0, 0 }, { 2, 2 }, { 2, 0 }, { 0, 2 }, { 1, 1 } };
  std::vector<Id> Corners{ 4, 0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0 };
  std::vector<Id> Neighbors{ NoId, 1, 3, NoId, 2, 0, NoId, 3, 1, NoId, 0, 2 };
  std::vector<Id> Constraints{ 0, NoId, 4, 1, 5, NoId, 2, NoId, 5, 3, 4, NoId };
  std::vector<Id> Segments{ 2, 1, 4, 3, 0, 0 };

  std::string Violation() const
  {
    return CheckSegmentCover(this->Domain,
      { this->Points, this->Corners, this->Neighbors, this->Constraints, this->Segments });
  }
};

TEST(SegmentCover, IsFaultlessWhereEachSegmentIsAChain)
{
  const CoveredSquare square;
  ASSERT_EQ(square.Domain.NumberOfSegments(), 5);
  EXPECT_EQ(square.Violation(), "");
}

TEST(SegmentCover, MissesAnyPartOfASegment)
{
  for (Id constraint = 0; constraint < 6; ++constraint)
  {
    CoveredSquare square;
    std::replace(square.Constraints.begin(), square.Constraints.end(), constraint, NoId);
    EXPECT_NE(square.Violation(), "") << constraint;
  }
}

TEST(SegmentCover, MissesAllOfASegment)
{
  CoveredSquare square;
  std::replace(square.Constraints.begin(), square.Constraints.end(), 4, NoId);
  std::replace(square.Constraints.begin(), square.Constraints.end(), 5, NoId);
  EXPECT_EQ(
    square.Violation(), "the mesh edges on segment 0, of cell 1, are not a chain between its ends");
}

TEST(SegmentCover, DoesNotTakeOneSegmentForAnother)
{
  CoveredSquare square;
  std::swap(square.Segments[0], square.Segments[4]);
  EXPECT_NE(square.Violation(), "");
}

TEST(SegmentCover, SeesAnEndThatIsMoved)
{
  CoveredSquare square;
  square.Points[1].Y = 2.5;
  EXPECT_NE(square.Violation(), "");
}

TEST(SegmentCover, LetsVerticesBetweenTheEndsBeAnywhere)
{
  CoveredSquare square;
  square.Points[4].Y = 1.25;
  EXPECT_EQ(square.Violation(), "");
}

} // namespace

} // namespace biting
