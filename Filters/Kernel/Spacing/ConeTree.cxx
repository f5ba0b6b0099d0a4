// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ConeTree.h"

#include "../Base/Numbers.h"
#include "BoxTree.h"

#include <cmath>  // for ldexp
#include <limits> // for epsilon

namespace biting
{
namespace
{

/// A cone is dropped where another one beats it but for this share of its value. That one may be
/// dropped for a third in a smaller square, but the three are rarely much farther apart.
constexpr double Slack = 0.005;

/// With so few cones a square is a leaf, however large: more of them take longer than a level more.
constexpr Id FewCones = 20;

/// A square across which f grows by no more than this share of itself is a leaf, whatever its
/// cones: they meet there.
constexpr double GrowthOfLeaf = 0.03;

/// A slope above this one counts as this one there, as nobody sees it on a part of f.
constexpr double SteepestGrowth = 1.0;

/// Of all lists: then what is left to be cut becomes leaves.
constexpr std::size_t MostEntries = std::size_t(1) << 30;

/// From a segment that is nearer than so many half-diagonals the way to the center is taken for
/// none, as rounding could turn it: there the plane is that of the values along the segment.
constexpr double OnSegment = 1e-3;

/// Of the largest coordinate: more than the rounding of a square, and of a place that is looked up.
/// Such a place may be found in a square that it lies beside.
constexpr double RoundingShare = 8.0 * std::numeric_limits<double>::epsilon();

double LargestCoordinate(const Box2& box)
{
  return std::max(
    { std::abs(box.Low.X), std::abs(box.Low.Y), std::abs(box.High.X), std::abs(box.High.Y) });
}

} // namespace

/// Cuts squares from the root down. The candidates of a square lie on a stack, above those of the
/// squares it is part of.
class ConeTree::Builder
{
public:
  Builder(ConeTree& whole, const std::vector<SegmentCone>& cones, double most, Monitor& monitor)
    : Whole(whole)
    , Beats(monitor)
    , Cones(BoxTree<SegmentCone>(cones, this->Beats).Items())
    , Most(most)
    , Slope(whole.Slope)
    , Margin(RoundingShare * LargestCoordinate(whole.Bounds))
  {
  }

  bool Build()
  {
    DropHigh(this->Slope, Slack, this->Cones, this->Beats);
    for (std::size_t cone = 0; cone < this->Cones.size(); ++cone)
    {
      this->Candidates.push_back(static_cast<Id>(cone));
    }
    this->Tangents.resize(this->Cones.size());
    this->NewIds.assign(this->Cones.size(), NoId);
    this->Whole.Lists.push_back(0);
    this->Refine(this->Whole.Tree.Root(), 0, 0);
    this->Whole.Tree.Finish();
    return !this->Beats.HasStopped();
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

  void Refine(const Quadtree::Square& square, std::size_t first, Id likely)
  {
    Box2 box = square.Box();
    box.Grow(this->Margin); // all places that are found in the square
    const std::size_t kept = this->Candidates.size();
    if (!this->Beats.Beat(kept - first) || kept == first || !this->Whole.Bounds.Meets(box))
    {
      this->SetLeaf(square, 0);
      return;
    }
    const double radius = square.Radius() + this->Margin;
    const Lowest lowest = this->FindTangents(square.At(0.5, 0.5), radius, first, likely);
    if (lowest.Value - this->Slope * radius >= this->Most)
    {
      this->SetLeaf(square, 0);
      return;
    }
    this->KeepCandidates(box, lowest);
    this->FinishOrSplit(square, lowest, kept);
    this->Candidates.resize(kept);
  }

  void FinishOrSplit(const Quadtree::Square& square, const Lowest& lowest, std::size_t first)
  {
    const double growth = std::min(this->Slope, SteepestGrowth) * square.Size;
    const bool isLast = square.Level == Quadtree::MaximumLevel ||
      this->Whole.Lists.size() + this->Candidates.size() > MostEntries;
    const auto count = static_cast<Id>(this->Candidates.size() - first);
    if (count <= FewCones || growth <= GrowthOfLeaf * lowest.Value || isLast)
    {
      this->AddLeaf(square, first);
    }
    else
    {
      this->Whole.Tree.Split(square);
      for (int quarter = 0; quarter < 4; ++quarter)
      {
        this->Refine(this->Whole.Tree.Quarter(square, quarter), first, lowest.Cone);
      }
    }
  }

  /// The lowest candidate at a point, where `likely` may be that. Tangents becomes those of the
  /// candidates that are not above it by more than the slope allows within the radius.
  Lowest FindTangents(const Point2& center, double radius, std::size_t first, Id likely)
  {
    const double rise = 2.0 * this->Slope * radius;
    Lowest lowest{ likely, this->At(likely)(center, this->Slope) };
    double most = (1.0 + Slack) * lowest.Value + rise;
    std::size_t count = 0;
    for (std::size_t k = first; k < this->Candidates.size(); ++k)
    {
      const Id id = this->Candidates[k];
      const SegmentCone& cone = this->At(id);
      const SegmentCone::View view = cone.From(center);
      const double room = most - view.Value;
      const double squaredWay = Dot(view.Away, view.Away);
      if (room < 0.0 || this->Slope * this->Slope * squaredWay > room * room)
      {
        continue;
      }
      const double way = std::sqrt(squaredWay);
      const double value = view.Value + this->Slope * way;
      const bool isAway = way > OnSegment * radius;
      this->Tangents[count++] = isAway ? Tangent{ id, value, (this->Slope / way) * view.Away }
                                       : Tangent{ id, view.Value, cone.Slope * cone.Direction };
      if (value < lowest.Value)
      {
        lowest = { id, value };
        most = (1.0 + Slack) * value + rise;
      }
    }
    this->TangentCount = count;
    return lowest;
  }

  /// Adds to the stack those of Tangents that may be lowest in a box.
  ///
  /// A cone is convex, so it is nowhere below a tangent plane. What the lowest one, b, is above
  /// such a plane is convex, too, so largest at a corner. So the cone is nowhere in the box below
  /// (1 - Slack) b, if its plane is not at the four corners.
  void KeepCandidates(const Box2& box, const Lowest& lowest)
  {
    const Point2 half = 0.5 * (box.High - box.Low);
    const double share = 1.0 - Slack;
    const SegmentCone& b = this->At(lowest.Cone);
    const double lowLow = share * b(box.Low, this->Slope);
    const double highLow = share * b({ box.High.X, box.Low.Y }, this->Slope);
    const double lowHigh = share * b({ box.Low.X, box.High.Y }, this->Slope);
    const double highHigh = share * b(box.High, this->Slope);
    for (std::size_t k = 0; k < this->TangentCount; ++k)
    {
      const Tangent& tangent = this->Tangents[k];
      const double x = tangent.Gradient.X * half.X;
      const double y = tangent.Gradient.Y * half.Y;
      const double value = tangent.Value;
      const bool isAbove = (value - x - y >= lowLow) & (value + x - y >= highLow) &
        (value - x + y >= lowHigh) & (value + x + y >= highHigh);
      if (!isAbove || tangent.Cone == lowest.Cone)
      {
        this->Candidates.push_back(tangent.Cone);
      }
    }
  }

  void AddLeaf(const Quadtree::Square& square, std::size_t first)
  {
    std::vector<Id>& lists = this->Whole.Lists;
    this->SetLeaf(square, static_cast<Id>(lists.size()));
    lists.push_back(static_cast<Id>(this->Candidates.size() - first));
    for (std::size_t k = first; k < this->Candidates.size(); ++k)
    {
      Id& newId = this->NewIds[static_cast<std::size_t>(this->Candidates[k])];
      if (newId == NoId)
      {
        newId = static_cast<Id>(this->Whole.Cones.size());
        this->Whole.Cones.push_back(this->At(this->Candidates[k]));
      }
      lists.push_back(newId);
    }
  }

  void SetLeaf(const Quadtree::Square& square, Id list)
  {
    this->Whole.Tree.SetLeaf(square, list);
    ++this->Whole.LeafCount;
    this->AreaDone += std::ldexp(1.0, -2 * square.Level);
    this->Beats.SetFraction(std::min(this->AreaDone, 1.0));
  }

  const SegmentCone& At(Id cone) const { return this->Cones[static_cast<std::size_t>(cone)]; }

  ConeTree& Whole;
  Pulse Beats;
  std::vector<SegmentCone> Cones; ///< those near each other mostly one after the other
  const double Most;
  const double Slope;
  const double Margin;
  std::vector<Id> Candidates;
  std::vector<Tangent> Tangents; ///< those of the square at work are the first
  std::size_t TangentCount = 0;
  std::vector<Id> NewIds; ///< of cones that are listed
  double AreaDone = 0.0;
};

ConeTree::ConeTree(const std::vector<SegmentCone>& cones, double slope, const Box2& bounds,
  double most, Monitor& monitor)
  : Slope(slope)
  , Bounds(bounds)
  , Tree(this->Bounds)
{
  Builder(*this, cones, most, monitor).Build();
}

} // namespace biting
