// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/Quadtree.h"

#include "SpacingSources.h"

#include <gtest/gtest.h>

#include <cmath>  // for floor
#include <vector> // for leaves

namespace
{

using namespace biting;

/// Squares that have a place in them are cut to a depth, the others are leaves.
class TreeAround
{
public:
  TreeAround(const Box2& box, const Point2& place, int depth)
    : Tree(box)
    , Place(place)
    , Depth(depth)
  {
    this->Refine(this->Tree.Root());
    this->Tree.Finish();
  }

  Quadtree Tree;
  std::vector<Quadtree::Square> Leaves;

private:
  void Refine(const Quadtree::Square& square)
  {
    if (square.Level == this->Depth || !square.Box().Contains(this->Place))
    {
      this->Tree.SetLeaf(square, static_cast<Id>(this->Leaves.size()));
      this->Leaves.push_back(square);
      return;
    }
    this->Tree.Split(square);
    for (int quarter = 0; quarter < 4; ++quarter)
    {
      this->Refine(this->Tree.Quarter(square, quarter));
    }
  }

  const Point2 Place;
  const int Depth;
};

} // namespace

/// Below the table of the upper levels, too.
TEST(Quadtree, FindsTheLeafOfAPlace)
{
  for (const int depth : { 0, 1, 5, 20, Quadtree::MaximumLevel })
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
        const auto leaf = static_cast<std::size_t>(around.Tree.Locate(x));
        ASSERT_LT(leaf, around.Leaves.size());
        ASSERT_TRUE(around.Leaves[leaf].Box().Contains(x)) << depth;
      }
    }
  }
}

TEST(Quadtree, FindsTheNearestLeafOfAPlaceOutside)
{
  const TreeAround around(UnitBox(), { 0.3, 0.7 }, 6);
  EXPECT_EQ(around.Tree.Locate({ 0.3, 17.0 }), around.Tree.Locate({ 0.3, 1.0 }));
  EXPECT_EQ(around.Tree.Locate({ -5.0, 0.7 }), around.Tree.Locate({ 0.0, 0.7 }));
  EXPECT_EQ(around.Tree.Locate({ NotANumber, 0.7 }), around.Tree.Locate({ 0.0, 0.7 }));
}

TEST(Quadtree, CoversABoxOfAnyProportionByOneSquare)
{
  const Box2 thin{ { -3.0, 2.0 }, { 5.0, 2.001 } };
  const Quadtree::Square root = Quadtree(thin).Root();
  EXPECT_EQ(root.Size, 8.0);
  EXPECT_TRUE(root.Box().Contains(thin.Low));
  EXPECT_TRUE(root.Box().Contains(thin.High));
}

TEST(Quadtree, TakesTheTreeOfAQuarterIn)
{
  Quadtree whole(UnitBox());
  whole.Split(whole.Root());
  for (int quarter = 0; quarter < 3; ++quarter)
  {
    whole.SetLeaf(whole.Quarter(whole.Root(), quarter), 0);
  }
  const Quadtree::Square last = whole.Quarter(whole.Root(), 3);
  Quadtree part;
  Quadtree::Square top = last;
  top.Node = 0;
  part.Split(top);
  for (int quarter = 0; quarter < 4; ++quarter)
  {
    part.SetLeaf(part.Quarter(top, quarter), quarter);
  }
  whole.Graft(last, part, 100);
  whole.Finish();
  EXPECT_EQ(whole.Locate({ 0.1, 0.9 }), 0);
  EXPECT_EQ(whole.Locate({ 0.6, 0.6 }), 0); // stays the leaf of nothing
  EXPECT_EQ(whole.Locate({ 0.9, 0.6 }), 101);
  EXPECT_EQ(whole.Locate({ 0.9, 0.9 }), 103);
}
