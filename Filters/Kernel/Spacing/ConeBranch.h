// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingConeBranch_h
#define BitingConeBranch_h

#include "../Base/Monitor.h"
#include "Orthtree.h"
#include "SegmentCone.h"

#include <memory> // for what squares share
#include <vector> // for cones

namespace biting
{

/// A cone of a ConeTree is dropped where another one beats it but for this share of its value. That
/// one may be dropped for a third in a smaller square, but the three are rarely much farther apart.
constexpr double SlackOfCones = 0.01;

/// A square with more cones is cut only once by a task; its quarters are tasks for themselves.
constexpr std::size_t ConesPerTask = 4096;

using Quadtree = Orthtree<2>;

/// What all squares have in common.
struct ConesToCut
{
  std::vector<SegmentCone> Cones; ///< those near each other mostly one after the other
  Box2 Bounds;
  double Slope;
  double Most;
  double Margin;
};

/// A square that is to be cut, and the cones that may be lowest there, ascending.
struct ConeBranch
{
  Quadtree::Cube Square;
  std::shared_ptr<const std::vector<Id>> Candidates;
  Id Likely = 0; ///< to be the lowest
};

/// What a branch became.
struct CutBranch
{
  Quadtree Tree;                ///< its root is the square of the branch
  std::vector<Id> Lists{ 0 };   ///< as ConeTree has them
  std::vector<ConeBranch> Rest; ///< leaves of Tree that are still to be cut
  std::size_t LeafCount = 0;
};

/// Cuts a square of a ConeTree down to its leaves, which may list `mostEntries` cones in all: then
/// what is left becomes leaves.
CutBranch CutConeBranch(
  const ConesToCut& whole, const ConeBranch& branch, std::size_t mostEntries, Monitor& monitor);

} // namespace biting

#endif
