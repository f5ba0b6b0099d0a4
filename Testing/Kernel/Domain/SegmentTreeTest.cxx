// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Domain/SegmentTree.h"
#include "Predicates/Predicates.h"
#include "Support/PolylineShapes.h"

#include <gtest/gtest.h>

#include <algorithm> // for sort, adjacent_find, binary_search
#include <limits>    // for no limit
#include <utility>   // for pair

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

using Pairs = std::vector<std::pair<Id, Id>>;

/// Notes pairs, and stops after so many.
struct PairNotes
{
  Pairs Found;
  std::size_t Most = std::numeric_limits<std::size_t>::max();

  bool GoesOn() const { return this->Found.size() < this->Most; }
  void SetFraction(double fraction) const { EXPECT_LE(fraction, 1.0); }
  void operator()(Id first, Id second) { this->Found.push_back(std::minmax({ first, second })); }
};

Pairs FindPairs(const Segments& segments, const std::vector<std::uint8_t>& isWanted, double margin)
{
  PairNotes notes;
  SegmentTree(segments.Points, segments.Ends, margin).VisitPairs(isWanted, notes);
  std::sort(notes.Found.begin(), notes.Found.end());
  return notes.Found;
}

/// Random segments, fans, and some a thousand times as long as others.
Segments LongAndShort(int count, std::uint64_t seed)
{
  Segments made = RandomSegments(count, seed);
  TestNumbers numbers(seed + 1);
  for (int i = 0; i < count; ++i)
  {
    const Point2 place{ numbers.Unit(), numbers.Unit() };
    const Id first = static_cast<Id>(made.Points.size());
    made.Points.push_back(place);
    made.Points.push_back({ place.X + 0.001 * numbers.Unit(), place.Y - 0.001 * numbers.Unit() });
    made.Ends.push_back({ first, first + 1 });
  }
  return made;
}

TEST(SegmentTree, VisitsEachPairThatMeetsOnce)
{
  for (const int count : { 2, 5, 40, 300 })
  {
    const Segments segments = LongAndShort(count, 11);
    const auto size = static_cast<Id>(segments.Ends.size());
    std::vector<std::uint8_t> isWanted(segments.Ends.size(), 0);
    for (std::size_t s = 0; s < isWanted.size(); ++s)
    {
      isWanted[s] = s % 3 == 0 ? 1 : 0;
    }
    const Pairs found = FindPairs(segments, isWanted, 1e-9);
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
    for (Id i = 0; i < size; ++i)
    {
      for (Id j = i + 1; j < size; ++j)
      {
        const SegmentEnds& a = segments.Ends[static_cast<std::size_t>(i)];
        const SegmentEnds& b = segments.Ends[static_cast<std::size_t>(j)];
        const auto at = [&segments](Id point)
        { return segments.Points[static_cast<std::size_t>(point)]; };
        const bool isAsked = (i % 3 == 0 || j % 3 == 0) && !a.Has(b.Start) && !a.Has(b.End);
        const bool isMet = Meet(at(a.Start), at(a.End), at(b.Start), at(b.End)) != Meeting::None;
        const bool isFound = std::binary_search(found.begin(), found.end(), std::make_pair(i, j));
        EXPECT_TRUE(isAsked || !isFound);
        EXPECT_TRUE(!isAsked || !isMet || isFound);
      }
    }
  }
}

/// Short ones, and some long ones across them.
Segments ScatteredSegments(int count)
{
  Segments made;
  TestNumbers numbers(13);
  for (int i = 0; i < count; ++i)
  {
    const double length = i % 100 == 0 ? 0.5 : 0.01;
    const Point2 place{ numbers.Unit(), numbers.Unit() };
    made.Points.push_back(place);
    made.Points.push_back(place + length * Point2{ numbers.Unit() - 0.5, numbers.Unit() - 0.5 });
    made.Ends.push_back({ 2 * i, 2 * i + 1 });
  }
  return made;
}

TEST(SegmentTree, PartsOfPairsHaveEachOnce)
{
  const Segments segments = ScatteredSegments(30000);
  const std::vector<std::uint8_t> all(segments.Ends.size(), 1);
  const SegmentTree tree(segments.Points, segments.Ends, 0.0);
  const std::vector<SegmentTree::PairPart> parts = tree.PairParts();
  EXPECT_GT(parts.size(), 10u);
  PairNotes notes;
  const std::vector<Id> before = tree.WantedBefore(all);
  for (const SegmentTree::PairPart& part : parts)
  {
    tree.VisitPairsOf(part, all, before, notes);
  }
  std::sort(notes.Found.begin(), notes.Found.end());
  EXPECT_EQ(notes.Found, FindPairs(segments, all, 0.0));
}

/// Long segments side by side, whose boxes all meet.
Segments Slanted(int count, double slope)
{
  Segments made;
  for (Id i = 0; i < count; ++i)
  {
    const double at = static_cast<double>(i) / count;
    made.Points.push_back({ at, 0.0 });
    made.Points.push_back({ at + 1.0, slope });
    made.Ends.push_back({ 2 * i, 2 * i + 1 });
  }
  return made;
}

TEST(SegmentTree, PairsFewOfManyThatRunSideBySide)
{
  constexpr int Count = 2000;
  for (const double slope : { 0.01, 0.7, -1.3, 40.0 })
  {
    const Pairs found =
      FindPairs(Slanted(Count, slope), std::vector<std::uint8_t>(Count, 1), 1e-12);
    EXPECT_LT(found.size(), 40u * Count) << slope;
  }
}

TEST(SegmentTree, StopsVisitingPairsWhereItIsTold)
{
  const Segments segments = RandomSegments(200, 7);
  PairNotes notes;
  notes.Most = 5;
  SegmentTree(segments.Points, segments.Ends, 0.0)
    .VisitPairs(std::vector<std::uint8_t>(segments.Ends.size(), 1), notes);
  EXPECT_EQ(notes.Found.size(), notes.Most);
}

TEST(SegmentTree, OfNothingFindsNothing)
{
  const SegmentTree tree({}, {}, 0.0);
  tree.Visit(Box2(), SegmentEnds(), [](Id) { FAIL(); });
  EXPECT_TRUE(FindPairs({}, {}, 0.0).empty());
}

} // namespace

} // namespace biting
