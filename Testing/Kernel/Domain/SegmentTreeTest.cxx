// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Domain/SegmentTree.h"
#include "Predicates/Predicates.h"
#include "Support/PolylineShapes.h"

#include <gtest/gtest.h>

#include <algorithm> // for sort

namespace biting
{

namespace
{

struct Segments
{
  std::vector<Point2> Points;
  std::vector<SegmentEnds> Ends;
};

/// Random segments, some in fans.
Segments RandomSegments(int count, std::uint64_t seed)
{
  TestNumbers numbers(seed);
  Segments made;
  for (int i = 0; i < count; ++i)
  {
    made.Points.push_back({ numbers.Unit(), numbers.Unit() });
  }
  for (int i = 0; i < count; ++i)
  {
    const Id start = numbers.Below(3) == 0 ? numbers.Below(2) : numbers.Below(count);
    made.Ends.push_back({ start, (start + 1 + numbers.Below(count - 1)) % count });
  }
  return made;
}

Box2 BoxOf(const Segments& segments, const SegmentEnds& ends)
{
  Box2 box;
  box.Add(segments.Points[static_cast<std::size_t>(ends.Start)]);
  box.Add(segments.Points[static_cast<std::size_t>(ends.End)]);
  return box;
}

std::vector<Id> BruteForce(
  const Segments& segments, const Box2& box, const SegmentEnds& skipped, double margin)
{
  std::vector<Id> found;
  for (std::size_t s = 0; s < segments.Ends.size(); ++s)
  {
    Box2 grown = BoxOf(segments, segments.Ends[s]);
    grown.Grow(margin);
    const bool isSkipped = segments.Ends[s].Has(skipped.Start) || segments.Ends[s].Has(skipped.End);
    if (grown.Meets(box) && !isSkipped)
    {
      found.push_back(static_cast<Id>(s));
    }
  }
  return found;
}

TEST(SegmentTree, FindsWhatBruteForceFinds)
{
  for (const int count : { 2, 7, 50, 400 })
  {
    const Segments segments = RandomSegments(count, 3);
    const double margin = 0.01;
    const SegmentTree tree(segments.Points, segments.Ends, margin);
    for (const SegmentEnds& ends : segments.Ends)
    {
      std::vector<Id> found;
      const Box2 box = BoxOf(segments, ends);
      tree.Visit(box, ends, [&found](Id segment) { found.push_back(segment); });
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, BruteForce(segments, box, ends, margin));
    }
  }
}

TEST(SegmentTree, FindsAlongASegmentWhatMeetsItAndNoMoreThanItsBox)
{
  const Segments segments = RandomSegments(300, 5);
  const SegmentTree tree(segments.Points, segments.Ends, 0.0);
  const auto at = [&segments](Id point)
  { return segments.Points[static_cast<std::size_t>(point)]; };
  for (const SegmentEnds& ends : segments.Ends)
  {
    std::vector<Id> found;
    const double length = SegmentTree::LengthOf(at(ends.Start), at(ends.End));
    tree.VisitAlong(at(ends.Start), at(ends.End), length, ends,
      [&found](Id segment) { found.push_back(segment); });
    std::sort(found.begin(), found.end());
    const std::vector<Id> inBox = BruteForce(segments, BoxOf(segments, ends), ends, 0.0);
    EXPECT_TRUE(std::includes(inBox.begin(), inBox.end(), found.begin(), found.end()));
    for (const Id other : inBox)
    {
      const SegmentEnds& b = segments.Ends[static_cast<std::size_t>(other)];
      const bool isShorter = SegmentTree::LengthOf(at(b.Start), at(b.End)) <= length;
      const bool isMet =
        Meet(at(ends.Start), at(ends.End), at(b.Start), at(b.End)) != Meeting::None;
      EXPECT_TRUE(!isShorter || !isMet || std::binary_search(found.begin(), found.end(), other));
    }
  }
}

TEST(SegmentTree, OfNothingFindsNothing)
{
  const SegmentTree tree({}, {}, 0.0);
  tree.Visit(Box2(), SegmentEnds(), [](Id) { FAIL(); });
}

} // namespace

} // namespace biting
