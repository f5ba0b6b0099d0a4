// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing/ConeBranch.h"

#include "../Support/Monitors.h"
#include "SpacingSources.h"

#include <gtest/gtest.h>

#include <numeric> // for iota

namespace
{

using namespace biting;

/// Points with one value, none of which another one stands for.
ConesToCut CrowdOf(std::size_t count)
{
  ConesToCut whole{ {}, UnitBox(), 0.3, 1e300, 1e-15 };
  Sampler sampler(61);
  for (std::size_t k = 0; k < count; ++k)
  {
    const Point2 place = sampler.NextIn(UnitBox());
    whole.Cones.emplace_back(place, place, 1e-4, 1e-4, 0.3);
  }
  return whole;
}

ConeBranch RootOf(const ConesToCut& whole)
{
  std::vector<Id> all(whole.Cones.size());
  std::iota(all.begin(), all.end(), 0);
  return { Quadtree::Around({ whole.Bounds.Low.X, whole.Bounds.Low.Y },
             { whole.Bounds.High.X, whole.Bounds.High.Y })
             .Root(),
    std::make_shared<const std::vector<Id>>(all), 0 };
}

} // namespace

TEST(ConeBranch, OfFewConesIsOneLeaf)
{
  const ConesToCut whole = CrowdOf(3);
  const CutBranch cut = CutConeBranch(whole, RootOf(whole), 1000, NoMonitor());
  EXPECT_EQ(cut.LeafCount, 1u);
  EXPECT_EQ(cut.Lists, (std::vector<Id>{ 0, 3, 0, 1, 2 }));
}

TEST(ConeBranch, OfManyConesIsCutOnce)
{
  const ConesToCut whole = CrowdOf(ConesPerTask + 1000);
  const CutBranch cut = CutConeBranch(whole, RootOf(whole), 1u << 30, NoMonitor());
  EXPECT_EQ(cut.LeafCount, 0u);
  ASSERT_EQ(cut.Rest.size(), 4u);
  EXPECT_EQ(cut.Rest.front().Square.Size, 0.5);
  EXPECT_EQ(cut.Rest.front().Candidates, cut.Rest.back().Candidates);
}

TEST(ConeBranch, EndsInLeavesWhereTheirListsAreLong)
{
  const ConesToCut whole = CrowdOf(1000);
  EXPECT_EQ(CutConeBranch(whole, RootOf(whole), 100, NoMonitor()).LeafCount, 1u);
  EXPECT_GT(CutConeBranch(whole, RootOf(whole), 1u << 30, NoMonitor()).LeafCount, 100u);
}
