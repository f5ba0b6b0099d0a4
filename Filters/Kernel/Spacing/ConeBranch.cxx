// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ConeBranch.h"

#include "../Base/Numbers.h"
#include "../Base/Pulse.h"

#include <cmath>   // for ldexp, sqrt
#include <utility> // for move

namespace biting
{
namespace
{

/// With so few cones a square is a leaf, however large: more of them take longer than a level more.
constexpr Id FewCones = 20;

/// A square across which f grows by no more than this share of itself is a leaf, whatever its
/// cones: they meet there.
constexpr double GrowthOfLeaf = 0.03;

/// A slope above this one counts as this one there, as nobody sees it on a part of f.
constexpr double SteepestGrowth = 1.0;

/// From a segment that is nearer than so many half-diagonals the way to the center is taken for
/// none, as rounding could turn it: there the plane is that of the values along the segment.
constexpr double OnSegment = 1e-3;

/// On its diagonal.
Point2 PointIn(const Quadtree::Cube& square, double share)
{
  const Point<2> place = square.At({ share, share });
  return { place[0], place[1] };
}

Box2 BoxOf(const Quadtree::Cube& square)
{
  return { PointIn(square, 0.0), PointIn(square, 1.0) };
}

/// Cuts squares from that of a branch down. The candidates of a square lie on a stack, above those
/// of the squares it is part of.
class BranchCutter
{
public:
  BranchCutter(
    const ConesToCut& whole, const ConeBranch& branch, std::size_t mostEntries, Monitor& monitor)
    : Whole(whole)
    , Branch(branch)
    , MostEntries(mostEntries)
    , Beats(monitor)
    , Candidates(*branch.Candidates)
    , Tangents(this->Candidates.size())
  {
  }

  CutBranch Cut()
  {
    Quadtree::Cube root = this->Branch.Square;
    root.Node = 0;
    this->Refine(root, 0, this->Branch.Likely);
    return std::move(this->Result);
  }

private:
  /// A cone, and its value somewhere.
  struct Lowest
  {
    Id Cone = NoId;
    double Value = Infinity;
  };

  /// A plane that a cone is nowhere below.
  struct Tangent
  {
    Id Cone = NoId;
    double Value; ///< at the center of the square
    Point2 Gradient;
  };

  void Refine(const Quadtree::Cube& square, std::size_t first, Id likely)
  {
    Box2 box = BoxOf(square);
    box.Grow(this->Whole.Margin); // all places that are found in the square
    const std::size_t kept = this->Candidates.size();
    if (!this->Beats.Beat(kept - first) || kept == first || !this->Whole.Bounds.Meets(box))
    {
      this->SetLeaf(square, 0);
      return;
    }
    const double radius =
      Length(Point2{ 0.5 * square.Size, 0.5 * square.Size }) + this->Whole.Margin;
    const Lowest lowest = this->FindTangents(PointIn(square, 0.5), radius, first, likely);
    if (lowest.Value - this->Whole.Slope * radius >= this->Whole.Most)
    {
      this->SetLeaf(square, 0);
      return;
    }
    this->KeepCandidates(box, lowest);
    this->FinishOrSplit(square, lowest, kept);
    this->Candidates.resize(kept);
  }

  void FinishOrSplit(const Quadtree::Cube& square, const Lowest& lowest, std::size_t first)
  {
    const double growth = std::min(this->Whole.Slope, SteepestGrowth) * square.Size;
    const bool isLast = square.Level == Quadtree::MaximumLevel ||
      this->Result.Lists.size() + this->Candidates.size() > this->MostEntries;
    const std::size_t count = this->Candidates.size() - first;
    if (count <= FewCones || growth <= GrowthOfLeaf * lowest.Value || isLast)
    {
      this->AddLeaf(square, first);
    }
    else if (count > ConesPerTask)
    {
      this->LeaveQuarters(square, lowest, first);
    }
    else
    {
      this->Result.Tree.Split(square);
      for (int quarter = 0; quarter < 4; ++quarter)
      {
        this->Refine(this->Result.Tree.Child(square, quarter), first, lowest.Cone);
      }
    }
  }

  /// To other tasks.
  void LeaveQuarters(const Quadtree::Cube& square, const Lowest& lowest, std::size_t first)
  {
    const auto candidates = std::make_shared<const std::vector<Id>>(
      this->Candidates.begin() + static_cast<std::ptrdiff_t>(first), this->Candidates.end());
    this->Result.Tree.Split(square);
    for (int quarter = 0; quarter < 4; ++quarter)
    {
      this->Result.Rest.push_back(
        { this->Result.Tree.Child(square, quarter), candidates, lowest.Cone });
    }
  }

  /// The lowest candidate at a point, where `likely` may be that. Tangents becomes those of the
  /// candidates that are not above it by more than the slope allows within the radius.
  Lowest FindTangents(const Point2& center, double radius, std::size_t first, Id likely)
  {
    const double rise = 2.0 * this->Whole.Slope * radius;
    Lowest lowest{ likely, this->At(likely)(center, this->Whole.Slope) };
    double most = (1.0 + SlackOfCones) * lowest.Value + rise;
    std::size_t count = 0;
    for (std::size_t k = first; k < this->Candidates.size(); ++k)
    {
      const Id id = this->Candidates[k];
      const SegmentCone& cone = this->At(id);
      const SegmentCone::View view = cone.From(center);
      const double way = Length(view.Away);
      const double value = view.Value + this->Whole.Slope * way;
      const bool isAway = way > OnSegment * radius;
      this->Tangents[count] = isAway ? Tangent{ id, value, (this->Whole.Slope / way) * view.Away }
                                     : Tangent{ id, view.Value, cone.Slope * cone.Direction };
      count += value <= most ? 1 : 0; // no branch, which would be guessed wrong as often as not
      if (value < lowest.Value)
      {
        lowest = { id, value };
        most = (1.0 + SlackOfCones) * value + rise;
      }
    }
    this->TangentCount = count;
    return lowest;
  }

  /// Adds to the stack those of Tangents that may be lowest in a box.
  ///
  /// A cone is convex, so it is nowhere below a tangent plane. What the lowest one, b, is above
  /// such a plane is convex, too, so largest at a corner. So the cone is nowhere in the box below
  /// (1 - SlackOfCones) b, if its plane is not at the four corners.
  void KeepCandidates(const Box2& box, const Lowest& lowest)
  {
    const Point2 half = 0.5 * (box.High - box.Low);
    const double share = 1.0 - SlackOfCones;
    const SegmentCone& b = this->At(lowest.Cone);
    const double lowLow = share * b(box.Low, this->Whole.Slope);
    const double highLow = share * b({ box.High.X, box.Low.Y }, this->Whole.Slope);
    const double lowHigh = share * b({ box.Low.X, box.High.Y }, this->Whole.Slope);
    const double highHigh = share * b(box.High, this->Whole.Slope);
    std::size_t count = this->Candidates.size();
    this->Candidates.resize(count + this->TangentCount);
    for (std::size_t k = 0; k < this->TangentCount; ++k)
    {
      const Tangent& tangent = this->Tangents[k];
      const double x = tangent.Gradient.X * half.X;
      const double y = tangent.Gradient.Y * half.Y;
      const double value = tangent.Value;
      const bool isAbove = (value - x - y >= lowLow) & (value + x - y >= highLow) &
        (value - x + y >= lowHigh) & (value + x + y >= highHigh);
      this->Candidates[count] = tangent.Cone;
      const bool stays = !isAbove | (tangent.Cone == lowest.Cone);
      count += stays ? 1 : 0;
    }
    this->Candidates.resize(count);
  }

  void AddLeaf(const Quadtree::Cube& square, std::size_t first)
  {
    std::vector<Id>& lists = this->Result.Lists;
    this->SetLeaf(square, static_cast<Id>(lists.size()));
    lists.push_back(static_cast<Id>(this->Candidates.size() - first));
    lists.insert(lists.end(), this->Candidates.begin() + static_cast<std::ptrdiff_t>(first),
      this->Candidates.end());
  }

  void SetLeaf(const Quadtree::Cube& square, Id list)
  {
    this->Result.Tree.SetLeaf(square, list);
    ++this->Result.LeafCount;
    this->AreaDone += std::ldexp(1.0, 2 * (this->Branch.Square.Level - square.Level));
    this->Beats.SetFraction(std::min(this->AreaDone, 1.0));
  }

  const SegmentCone& At(Id cone) const { return this->Whole.Cones[static_cast<std::size_t>(cone)]; }

  const ConesToCut& Whole;
  const ConeBranch& Branch;
  const std::size_t MostEntries;
  Pulse Beats;
  CutBranch Result;
  std::vector<Id> Candidates;
  std::vector<Tangent> Tangents; ///< those of the square at work are the first
  std::size_t TangentCount = 0;
  double AreaDone = 0.0;
};

} // namespace

CutBranch CutConeBranch(
  const ConesToCut& whole, const ConeBranch& branch, std::size_t mostEntries, Monitor& monitor)
{
  return BranchCutter(whole, branch, mostEntries, monitor).Cut();
}

} // namespace biting
