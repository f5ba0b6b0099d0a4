// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/Orthtree.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

#include <cmath>  // for floor
#include <vector> // for leaves

namespace
{

using namespace biting;

using Cube = Orthtree<2>::Cube;

Orthtree<2> TreeOf(const Box2& box)
{
  return Orthtree<2>::Around({ box.Low.X, box.Low.Y }, { box.High.X, box.High.Y });
}

Box2 BoxOf(const Cube& square)
{
  const Point<2> high = square.At({ 1.0, 1.0 });
  return { { square.Low[0], square.Low[1] }, { high[0], high[1] } };
}

/// Squares that have a place in them are cut to a depth, the others are leaves.
class TreeAround
{
public:
  TreeAround(const Box2& box, const Point2& place, int depth)
    : Tree(TreeOf(box))
    , Place(place)
    , Depth(depth)
  {
    this->Refine(this->Tree.Root());
    this->Tree.Finish();
  }

  Orthtree<2> Tree;
  std::vector<Cube> Leaves;

private:
  void Refine(const Cube& square)
  {
    if (square.Level == this->Depth || !BoxOf(square).Contains(this->Place))
    {
      this->Tree.SetLeaf(square, static_cast<Id>(this->Leaves.size()));
      this->Leaves.push_back(square);
      return;
    }
    this->Tree.Split(square);
    for (int quarter = 0; quarter < 4; ++quarter)
    {
      this->Refine(this->Tree.Child(square, quarter));
    }
  }

  const Point2 Place;
  const int Depth;
};

} // namespace

/// Below the table of the upper levels, too.
TEST(Orthtree, FindsTheLeafOfAPlace)
{
  for (const int depth : { 0, 1, 5, 20, Orthtree<2>::MaximumLevel })
  {
    const TreeAround around(UnitBox(), { 0.3, 0.7 }, depth);
    Sampler sampler(8);
    for (int probe = 0; probe < 500; ++probe)
    {
      const Point2 x = probe % 2 == 0
        ? sampler.NextIn(UnitBox())
        : Point2{ 0.3, 0.7 } + std::exp(-20.0 * sampler.Next()) * sampler.NextIn(UnitBox());
      if (UnitBox().Contains(x))
      {
        const auto leaf = static_cast<std::size_t>(around.Tree.Locate({ x.X, x.Y }));
        ASSERT_LT(leaf, around.Leaves.size());
        ASSERT_TRUE(BoxOf(around.Leaves[leaf]).Contains(x)) << depth;
      }
    }
  }
}

TEST(Orthtree, FindsTheNearestLeafOfAPlaceOutside)
{
  const TreeAround around(UnitBox(), { 0.3, 0.7 }, 6);
  EXPECT_EQ(around.Tree.Locate({ 0.3, 17.0 }), around.Tree.Locate({ 0.3, 1.0 }));
  EXPECT_EQ(around.Tree.Locate({ -5.0, 0.7 }), around.Tree.Locate({ 0.0, 0.7 }));
  EXPECT_EQ(around.Tree.Locate({ NotANumber, 0.7 }), around.Tree.Locate({ 0.0, 0.7 }));
}

TEST(Orthtree, CoversABoxOfAnyProportionByOneSquare)
{
  const Box2 thin{ { -3.0, 2.0 }, { 5.0, 2.001 } };
  const Cube root = TreeOf(thin).Root();
  EXPECT_EQ(root.Size, 8.0);
  EXPECT_TRUE(BoxOf(root).Contains(thin.Low));
  EXPECT_TRUE(BoxOf(root).Contains(thin.High));
}

TEST(Orthtree, TakesTheTreeOfAQuarterIn)
{
  Orthtree<2> whole = TreeOf(UnitBox());
  whole.Split(whole.Root());
  for (int quarter = 0; quarter < 3; ++quarter)
  {
    whole.SetLeaf(whole.Child(whole.Root(), quarter), 0);
  }
  const Cube last = whole.Child(whole.Root(), 3);
  Orthtree<2> part;
  Cube top = last;
  top.Node = 0;
  part.Split(top);
  for (int quarter = 0; quarter < 4; ++quarter)
  {
    part.SetLeaf(part.Child(top, quarter), quarter);
  }
  whole.Graft(last, part, 100);
  whole.Finish();
  EXPECT_EQ(whole.Locate({ 0.1, 0.9 }), 0);
  EXPECT_EQ(whole.Locate({ 0.6, 0.6 }), 0); // stays the leaf of nothing
  EXPECT_EQ(whole.Locate({ 0.9, 0.6 }), 101);
  EXPECT_EQ(whole.Locate({ 0.9, 0.9 }), 103);
}
