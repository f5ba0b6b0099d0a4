// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ConeTree.h"

#include "../Base/BoxTree.h"
#include "../Base/Numbers.h"
#include "../Base/Tasks.h"
#include "ConeBranch.h"

#include <cmath>   // for abs
#include <limits>  // for epsilon
#include <numeric> // for iota
#include <utility> // for move

namespace biting
{
namespace
{

/// Of the time, that of tasks which cut once.
constexpr double ShareOfCuttingOnce = 0.1;

/// Of all lists: then what is left to be cut becomes leaves.
constexpr std::size_t MostEntries = std::size_t(1) << 30;

/// Of the largest coordinate: more than the rounding of a square, and of a place that is looked up.
/// Such a place may be found in a square that it lies beside.
constexpr double RoundingShare = 8.0 * std::numeric_limits<double>::epsilon();

double LargestCoordinate(const Box2& box)
{
  return std::max(
    { std::abs(box.Low.X), std::abs(box.Low.Y), std::abs(box.High.X), std::abs(box.High.Y) });
}

} // namespace

/// Cuts the square of all, level by level where there are many cones, then branches to their
/// leaves. The tasks do not depend on the number of threads.
class ConeTree::Builder
{
public:
  Builder(ConeTree& whole, const std::vector<SegmentCone>& cones, double most, Monitor& monitor)
    : Whole(whole)
    , Beats(monitor)
    , ToCut{ BoxTree<SegmentCone>(cones, this->Beats).Items(), whole.Bounds, whole.Slope, most,
      RoundingShare * LargestCoordinate(whole.Bounds) }
  {
  }

  void Build()
  {
    DropHigh(this->ToCut.Slope, SlackOfCones, this->ToCut.Cones, this->Beats);
    std::vector<Id> all(this->ToCut.Cones.size());
    std::iota(all.begin(), all.end(), 0);
    this->Whole.Lists.push_back(0);
    std::vector<ConeBranch> branches{ { this->Whole.Tree.Root(),
      std::make_shared<const std::vector<Id>>(std::move(all)), 0 } };
    for (double begin = 0.0; !branches.empty() && !this->Beats.HasStopped();)
    {
      const bool isLast = std::all_of(branches.begin(), branches.end(),
        [](const ConeBranch& branch) { return branch.Candidates->size() <= ConesPerTask; });
      const double end = isLast ? 1.0 : begin + ShareOfCuttingOnce * (1.0 - begin);
      const PulsePart part(this->Beats, begin, end);
      branches = this->CutAll(branches);
      begin = end;
    }
    this->Whole.Cones = std::move(this->ToCut.Cones);
    this->Whole.Tree.Finish();
  }

private:
  /// Each may have its share of the entries that are left. Returns what is left of them to be cut.
  std::vector<ConeBranch> CutAll(const std::vector<ConeBranch>& branches)
  {
    std::size_t sum = 1;
    for (const ConeBranch& branch : branches)
    {
      sum += branch.Candidates->size();
    }
    const double left = static_cast<double>(MostEntries) -
      std::min(static_cast<double>(this->Whole.Lists.size()), static_cast<double>(MostEntries));
    const double perCandidate = left / static_cast<double>(sum);
    std::vector<CutBranch> parts(branches.size());
    DoTasks(this->Beats, branches.size(),
      [this, &branches, &parts, perCandidate](std::size_t k, Monitor& monitor)
      {
        const auto most = static_cast<std::size_t>(
          perCandidate * static_cast<double>(branches[k].Candidates->size()));
        parts[k] = CutConeBranch(this->ToCut, branches[k], most, monitor);
      });
    return this->Graft(branches, parts);
  }

  std::vector<ConeBranch> Graft(
    const std::vector<ConeBranch>& branches, std::vector<CutBranch>& parts)
  {
    std::vector<ConeBranch> rest;
    std::size_t size = this->Whole.Lists.size();
    std::vector<std::size_t> begins;
    for (std::size_t k = 0; k < parts.size(); ++k)
    {
      begins.push_back(size);
      const Id shift =
        this->Whole.Tree.Graft(branches[k].Square, parts[k].Tree, static_cast<Id>(size) - 1);
      for (ConeBranch& branch : parts[k].Rest)
      {
        branch.Square.Node += shift;
        rest.push_back(std::move(branch));
      }
      size += parts[k].Lists.size() - 1;
      this->Whole.LeafCount += parts[k].LeafCount;
    }
    if (parts.size() == 1 && this->Whole.Lists.size() == 1)
    {
      this->Whole.Lists.swap(parts.front().Lists);
      return rest;
    }
    this->Whole.Lists.resize(size);
    DoTasks(this->Beats, parts.size(),
      [this, &parts, &begins](std::size_t k, Monitor&)
      {
        const std::vector<Id> lists = std::move(parts[k].Lists);
        std::copy(lists.begin() + 1, lists.end(),
          this->Whole.Lists.begin() + static_cast<std::ptrdiff_t>(begins[k]));
      });
    return rest;
  }

  ConeTree& Whole;
  Pulse Beats;
  ConesToCut ToCut;
};

ConeTree::ConeTree(const std::vector<SegmentCone>& cones, double slope, const Box2& bounds,
  double most, Monitor& monitor)
  : Slope(slope)
  , Bounds(bounds)
  , Tree(Quadtree::Around({ bounds.Low.X, bounds.Low.Y }, { bounds.High.X, bounds.High.Y }))
{
  Builder(*this, cones, most, monitor).Build();
}

} // namespace biting
