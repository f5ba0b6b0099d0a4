// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ConeTree.h"

#include "../Base/BoxTree.h"
#include "../Base/Tasks.h"

#include <array>   // for corners
#include <cmath>   // for abs
#include <limits>  // for epsilon
#include <numeric> // for iota
#include <utility> // for move

namespace biting
{
namespace
{

/// A cone is dropped where another one beats it but for this share of its value. That one may be
/// dropped for a third in a smaller cube, but the three are rarely much farther apart.
constexpr double SlackOfCones = 0.01;

/// A cube with at most so many cones is cut to its leaves by one task.
constexpr std::size_t ConesPerTask = 4096;

/// Of all lists: then what is left to be cut becomes leaves.
constexpr std::size_t MostEntries = std::size_t(1) << 30;

/// With so few cones a cube is a leaf, however large: more of them take longer than a level more.
constexpr std::size_t FewCones = 20;

/// A cube across which f grows by no more than this share of itself is a leaf, whatever its cones:
/// they meet there.
constexpr double GrowthOfLeaf = 0.03;

/// A slope above this one counts as this one there, as nobody sees it on a part of f.
constexpr double SteepestGrowth = 1.0;

/// From a segment that is nearer than so many half-diagonals the way to the center is taken for
/// none, as rounding could turn it: there the plane is that of the values along the segment.
constexpr double OnSegment = 1e-3;

/// Of the largest coordinate: more than the rounding of a cube, and of a place that is looked up.
/// Such a place may be found in a cube that it lies beside.
constexpr double RoundingShare = 8.0 * std::numeric_limits<double>::epsilon();

template <std::size_t D>
Point<D> Filled(double number)
{
  Point<D> point;
  for (std::size_t d = 0; d < D; ++d)
  {
    point[d] = number;
  }
  return point;
}

template <std::size_t D>
double LargestCoordinate(const Box<D>& box)
{
  double largest = 0.0;
  for (std::size_t d = 0; d < D; ++d)
  {
    largest = std::max({ largest, std::abs(box.Low[d]), std::abs(box.High[d]) });
  }
  return largest;
}

} // namespace

/// A cube that is to be cut, and the cones that may be lowest there, ascending.
template <std::size_t D>
struct ConeTree<D>::Branch
{
  typename Orthtree<D>::Cube Cube;
  std::vector<Id> Candidates;
  Id Likely = 0; ///< to be the lowest
};

/// Cuts cubes from one down to their leaves. The candidates of a cube lie on a stack, above those
/// of the cubes it is part of.
template <std::size_t D>
class ConeTree<D>::Cutter
{
public:
  /// A cube with few cones is added to `rest`, if that is not null, and not cut.
  Cutter(const ConeTree& whole, double most, std::size_t mostEntries, std::vector<Branch>* rest,
    Pulse& pulse)
    : Whole(whole)
    , Most(most)
    , MostEntries(mostEntries)
    , Margin(RoundingShare * LargestCoordinate(whole.Bounds))
    , Rest(rest)
    , Beats(pulse)
  {
  }

  /// Makes the tree below a branch, whose node becomes the root.
  void Cut(const Branch& branch)
  {
    this->Candidates = branch.Candidates;
    this->Tangents.resize(this->Candidates.size());
    Cube root = branch.Cube;
    root.Node = 0;
    this->Refine(root, 0, branch.Likely);
  }

  Orthtree<D> Tree;
  std::vector<Id> Lists{ 0 }; ///< as those of the whole

private:
  using Cube = typename Orthtree<D>::Cube;
  static constexpr int Children = Orthtree<D>::Children;

  /// A cone, and its value somewhere.
  struct Lowest
  {
    Id Number = NoId;
    double Value = Infinity;
  };

  /// A plane that a cone is nowhere below.
  struct Tangent
  {
    Id Number = NoId;
    double Value; ///< at the center of the cube
    Point<D> Gradient;
  };

  /// The candidates are those from `first` on.
  void Refine(const Cube& cube, std::size_t first, Id likely)
  {
    Box<D> box{ cube.At(Filled<D>(0.0)), cube.At(Filled<D>(1.0)) };
    box.Grow(this->Margin); // all places that are found in the cube
    const std::size_t kept = this->Candidates.size();
    if (!this->Beats.Beat(kept - first) || kept == first || !this->Whole.Bounds.Meets(box))
    {
      this->Tree.SetLeaf(cube, 0);
      return;
    }
    if (this->Rest != nullptr && kept - first <= ConesPerTask)
    {
      this->Rest->push_back({ cube, this->CandidatesFrom(first), likely });
      return;
    }
    const double radius = Length(Filled<D>(0.5 * cube.Size)) + this->Margin;
    const Lowest lowest = this->FindTangents(cube.At(Filled<D>(0.5)), radius, first, likely);
    if (lowest.Value - this->Whole.Slope * radius >= this->Most)
    {
      this->Tree.SetLeaf(cube, 0);
      return;
    }
    this->KeepCandidates(box, lowest);
    this->FinishOrSplit(cube, lowest, kept);
    this->Candidates.resize(kept);
  }

  void FinishOrSplit(const Cube& cube, const Lowest& lowest, std::size_t first)
  {
    const double growth = std::min(this->Whole.Slope, SteepestGrowth) * cube.Size;
    const bool isLast = cube.Level == Orthtree<D>::MaximumLevel ||
      this->Lists.size() + this->Candidates.size() > this->MostEntries;
    const std::size_t count = this->Candidates.size() - first;
    if (count <= FewCones || growth <= GrowthOfLeaf * lowest.Value || isLast)
    {
      this->Tree.SetLeaf(cube, static_cast<Id>(this->Lists.size()));
      this->Lists.push_back(static_cast<Id>(count));
      this->Lists.insert(this->Lists.end(),
        this->Candidates.begin() + static_cast<std::ptrdiff_t>(first), this->Candidates.end());
      return;
    }
    this->Tree.Split(cube);
    for (int child = 0; child < Children; ++child)
    {
      this->Refine(this->Tree.Child(cube, child), first, lowest.Number);
    }
  }

  /// The lowest candidate at a point, where `likely` may be that. Tangents becomes those of the
  /// candidates that are not above it by more than the slope allows within the radius.
  Lowest FindTangents(const Point<D>& center, double radius, std::size_t first, Id likely)
  {
    const double slope = this->Whole.Slope;
    const double rise = 2.0 * slope * radius;
    Lowest lowest{ likely, this->At(likely)(center, slope) };
    double most = (1.0 + SlackOfCones) * lowest.Value + rise;
    std::size_t count = 0;
    for (std::size_t k = first; k < this->Candidates.size(); ++k)
    {
      const Id id = this->Candidates[k];
      const Cone<D>& cone = this->At(id);
      const typename Cone<D>::View view = cone.From(center);
      const double way = Length(view.Away);
      const double value = view.Value + slope * way;
      const bool isAway = way > OnSegment * radius;
      this->Tangents[count] = isAway ? Tangent{ id, value, (slope / way) * view.Away }
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
  /// (1 - SlackOfCones) b, if its plane is not at the corners.
  void KeepCandidates(const Box<D>& box, const Lowest& lowest)
  {
    const Point<D> half = 0.5 * (box.High - box.Low);
    const Cone<D>& b = this->At(lowest.Number);
    std::array<double, Children> least;
    for (std::size_t corner = 0; corner < Children; ++corner)
    {
      Point<D> place = box.Low;
      for (std::size_t d = 0; d < D; ++d)
      {
        place[d] = ((corner >> d) & 1) != 0 ? box.High[d] : box.Low[d];
      }
      least[corner] = (1.0 - SlackOfCones) * b(place, this->Whole.Slope);
    }
    std::size_t count = this->Candidates.size();
    this->Candidates.resize(count + this->TangentCount);
    for (std::size_t k = 0; k < this->TangentCount; ++k)
    {
      const Tangent& tangent = this->Tangents[k];
      bool isAbove = tangent.Number != lowest.Number;
      for (std::size_t corner = 0; corner < Children; ++corner)
      {
        double value = tangent.Value;
        for (std::size_t d = 0; d < D; ++d)
        {
          const double step = tangent.Gradient[d] * half[d];
          value += ((corner >> d) & 1) != 0 ? step : -step;
        }
        isAbove &= value >= least[corner];
      }
      this->Candidates[count] = tangent.Number;
      count += isAbove ? 0 : 1;
    }
    this->Candidates.resize(count);
  }

  std::vector<Id> CandidatesFrom(std::size_t first) const
  {
    return { this->Candidates.begin() + static_cast<std::ptrdiff_t>(first),
      this->Candidates.end() };
  }

  const Cone<D>& At(Id cone) const { return this->Whole.Cones[cone]; }

  const ConeTree& Whole;
  const double Most;
  const std::size_t MostEntries;
  const double Margin;
  std::vector<Branch>* Rest;
  Pulse& Beats;
  std::vector<Id> Candidates;
  std::vector<Tangent> Tangents; ///< those of the cube at work are the first
  std::size_t TangentCount = 0;
};

/// The cubes with many cones are cut one after the other, what is left of them at once.
template <std::size_t D>
ConeTree<D>::ConeTree(const std::vector<Cone<D>>& cones, double slope, const Box<D>& bounds,
  double most, Monitor& monitor)
  : Slope(slope)
  , Bounds(bounds)
  , Tree(Orthtree<D>::Around(bounds.Low, bounds.High))
{
  Pulse pulse(monitor);
  this->Cones = BoxTree<Cone<D>, D>(cones, pulse).Items();
  DropHigh(slope, SlackOfCones, this->Cones, pulse);
  Branch all{ this->Tree.Root(), std::vector<Id>(this->Cones.size()) };
  std::iota(all.Candidates.begin(), all.Candidates.end(), 0);
  std::vector<Branch> branches;
  Cutter top(*this, most, MostEntries, &branches, pulse);
  top.Cut(all);
  this->Tree.Graft(all.Cube, top.Tree, 0);
  std::vector<Orthtree<D>> trees(branches.size());
  std::vector<std::vector<Id>> lists(branches.size());
  DoTasks(pulse, branches.size(),
    [this, most, &branches, &trees, &lists](std::size_t k, Monitor& own)
    {
      Pulse beats(own);
      Cutter cutter(*this, most, MostEntries / branches.size(), nullptr, beats);
      cutter.Cut(branches[k]);
      trees[k] = std::move(cutter.Tree);
      lists[k] = std::move(cutter.Lists);
    });
  this->Lists = std::move(top.Lists);
  for (std::size_t k = 0; k < branches.size() && !pulse.HasStopped(); ++k)
  {
    const auto shift = static_cast<Id>(this->Lists.size()) - 1;
    this->Tree.Graft(branches[k].Cube, trees[k], shift);
    this->Lists.insert(this->Lists.end(), lists[k].begin() + 1, lists[k].end());
  }
  this->Tree.Finish();
}

template class ConeTree<2>;
template class ConeTree<3>;

} // namespace biting
