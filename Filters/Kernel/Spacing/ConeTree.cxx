// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ConeTree.h"

#include "../Base/Numbers.h"
#include "BoxTree.h"

#include <array>  // for lattices
#include <cmath>  // for ldexp
#include <limits> // for epsilon

namespace biting
{
namespace
{

/// A cone is dropped where another one beats it but for this share of its value. Of a chain of
/// cones, each of which stands for the one before, the ends are rarely much farther apart.
constexpr double Slack = 0.005;

/// With so few cones a square is a leaf, however large: more of them take longer than a level more.
constexpr Id FewCones = 14;

/// A square across which f grows by no more than this share of itself is a leaf, whatever its
/// cones: what a lattice misses is rarely lower than what it finds by more than a tenth of that.
constexpr double GrowthOfLeaf = 0.03;

/// A slope above this one counts as this one there, as nobody sees it on a part of f.
constexpr double SteepestGrowth = 1.0;

/// Among more, those that another one beside them stands for are looked for.
constexpr std::size_t ManyCones = 64;

/// Of all lists: then what is left to be cut becomes leaves.
constexpr std::size_t MostEntries = std::size_t(1) << 30;

/// Cells of the lattice along a side.
constexpr int LatticeCells = 2;

/// From this many half-diagonals on a cone is nearly a plane.
constexpr double FarAway = 1.2;

/// Of the largest coordinate: more than the rounding of a square, and of a place that is looked up.
/// Such a place may be found in a square that it lies beside.
constexpr double RoundingShare = 8.0 * std::numeric_limits<double>::epsilon();

double LargestCoordinate(const Box2& box)
{
  return std::max(
    { std::abs(box.Low.X), std::abs(box.Low.Y), std::abs(box.High.X), std::abs(box.High.Y) });
}

/// A box of no extent is replaced by that of the cones, grown to have one.
Box2 WithExtent(Box2 box, const std::vector<SegmentCone>& cones)
{
  if (!(box.Diagonal() > 0.0))
  {
    for (const SegmentCone& cone : cones)
    {
      box.Add(cone.Start);
      box.Add(cone.End());
    }
    const double extent = box.Diagonal();
    box.Grow(extent > 0.0 || cones.empty() ? extent : cones.front().Value);
  }
  return box;
}

/// From each cone to the next one.
double WayThrough(const std::vector<SegmentCone>& cones)
{
  double way = 0.0;
  for (std::size_t cone = 1; cone < cones.size(); ++cone)
  {
    way += Distance(cones[cone - 1].Start, cones[cone].Start);
  }
  return way;
}

/// The same cones, those near each other mostly one after the other: as they are given, which is
/// along the chains of a boundary, or in the order of a tree where that is a shorter way.
std::vector<SegmentCone> InOrder(const std::vector<SegmentCone>& cones, Pulse& pulse)
{
  std::vector<BoxTree::Item> places(cones.size());
  for (std::size_t cone = 0; cone < cones.size(); ++cone)
  {
    places[cone].Box.Add(cones[cone].Start);
  }
  const BoxTree tree(places, pulse);
  std::vector<SegmentCone> ordered;
  ordered.reserve(cones.size());
  for (const Id cone : tree.Order())
  {
    ordered.push_back(cones[static_cast<std::size_t>(cone)]);
  }
  return WayThrough(ordered) < WayThrough(cones) ? ordered : cones;
}

} // namespace

/// Cuts squares from the root down. The candidates of a square lie on a stack, above those of the
/// squares it is part of.
class ConeTree::Builder
{
public:
  Builder(
    ConeTree& whole, const std::vector<SegmentCone>& cones, const Relief& relief, Monitor& monitor)
    : Whole(whole)
    , Beats(monitor)
    , Cones(InOrder(cones, this->Beats))
    , Less(relief)
    , Slope(whole.Slope)
    , Margin(RoundingShare * LargestCoordinate(whole.Bounds))
  {
  }

  bool Build()
  {
    for (std::size_t cone = 0; cone < this->Cones.size(); ++cone)
    {
      this->Candidates.push_back(static_cast<Id>(cone));
    }
    this->Values.resize(this->Cones.size());
    this->NewIds.assign(this->Cones.size(), NoId);
    this->Whole.Lists.push_back(0);
    this->Refine(this->Whole.Tree.Root(), 0);
    this->Whole.Tree.Finish();
    return !this->Beats.HasStopped();
  }

private:
  /// The lowest candidate at the center of a square.
  struct Lowest
  {
    Id Cone = NoId;
    double Value = Infinity;
  };

  void Refine(const Quadtree::Square& square, std::size_t first)
  {
    Box2 box = square.Box();
    box.Grow(this->Margin); // all places that are found in the square
    if (!this->Beats.Beat(this->Candidates.size() - first) || !this->Whole.Bounds.Meets(box))
    {
      this->SetLeaf(square, 0);
      return;
    }
    const double radius = square.Radius() + this->Margin;
    const Lowest lowest = this->FindLowest(square.At(0.5, 0.5), first);
    if (lowest.Value - this->Slope * radius >= this->Less.Most)
    {
      this->SetLeaf(square, 0);
      return;
    }
    const std::size_t kept = this->Candidates.size();
    this->KeepCandidates(square.At(0.5, 0.5), radius, lowest, first);
    this->FinishOrSplit(square, box, lowest, kept);
    this->Candidates.resize(kept);
  }

  void FinishOrSplit(
    const Quadtree::Square& square, const Box2& box, const Lowest& lowest, std::size_t first)
  {
    const double growth = std::min(this->Slope, SteepestGrowth) * square.Size;
    const bool isLast = square.Level == Quadtree::MaximumLevel ||
      this->Whole.Lists.size() + this->Candidates.size() > MostEntries;
    const auto count = static_cast<Id>(this->Candidates.size() - first);
    if (count <= FewCones)
    {
      this->AddLeaf(square, first);
    }
    else if (growth <= GrowthOfLeaf * lowest.Value || isLast)
    {
      this->KeepLowest(square, first);
      this->AddLeaf(square, first);
    }
    else if (growth <= 0.5 * lowest.Value && this->Less.IsUnused && this->Less.IsUnused(box))
    {
      this->Candidates.resize(first);
      this->Candidates.push_back(lowest.Cone);
      this->AddLeaf(square, first);
    }
    else
    {
      this->Whole.Tree.Split(square);
      for (int quarter = 0; quarter < 4; ++quarter)
      {
        this->Refine(this->Whole.Tree.Quarter(square, quarter), first);
      }
    }
  }

  Lowest FindLowest(const Point2& center, std::size_t first)
  {
    Lowest lowest;
    const std::size_t count = this->Candidates.size();
    for (std::size_t k = first; k < count; ++k)
    {
      const Id cone = this->Candidates[k];
      const double value = this->At(cone)(center, this->Slope);
      this->Values[k - first] = value;
      lowest = value < lowest.Value ? Lowest{ cone, value } : lowest;
    }
    return lowest;
  }

  /// Adds to the stack those of its candidates from `first` on that may be lowest in the square.
  ///
  /// All are Lipschitz with the slope g: within the radius r a cone is above the lowest one, b, if
  /// it is by 2 g r at the center. Far away it is nearly a plane: with its gradient G, and D from
  /// its foot, it differs from that by at most g r^2 / (2 (D - r)). So the difference of two such
  /// cones is at least that at the center less r |G - G_b| and both these rests.
  /// Of cones beside each other, one also stands for those after it: so lists do not grow with the
  /// number of segments where these are close together.
  void KeepCandidates(const Point2& center, double radius, const Lowest& lowest, std::size_t first)
  {
    const double rise = 2.0 * this->Slope * radius;
    const double limit = (1.0 - Slack) * lowest.Value + rise;
    const double room = Slack * (lowest.Value - 0.5 * rise); // of the lowest value in the square
    const Point2 toLowest = center - this->At(lowest.Cone).Foot(center);
    const double distance = Length(toLowest);
    const bool isFar = distance > FarAway * radius && room > 0.0;
    const Point2 direction = (1.0 / distance) * toLowest;
    const double rest = 0.5 * radius / (distance - radius);
    const std::size_t count = this->Candidates.size();
    const bool areMany = count - first > ManyCones;
    Lowest last;
    for (std::size_t k = first; k < count; ++k)
    {
      const double value = this->Values[k - first];
      const double above = value - lowest.Value;
      const Id cone = this->Candidates[k];
      const bool mayBeLowest = cone == lowest.Cone ||
        (!(value > limit) &&
          (!isFar ||
            !this->IsFarAbove(
              cone, center, radius, (above + room) / (this->Slope * radius), direction, rest)) &&
          !(areMany && last.Cone != NoId &&
            this->StandsFor(last.Cone, cone, center, radius, last.Value - value, room)));
      if (mayBeLowest)
      {
        this->Candidates.push_back(cone);
        last = { cone, value };
      }
    }
  }

  /// `above` is what a cone is above the lowest one at the center, in units of the slope times the
  /// radius.
  bool IsFarAbove(Id cone, const Point2& center, double radius, double above,
    const Point2& direction, double rest) const
  {
    const Point2 toCenter = center - this->At(cone).Foot(center);
    const double distance = Length(toCenter);
    return distance > FarAway * radius &&
      above >
      Length((1.0 / distance) * toCenter - direction) + rest + 0.5 * radius / (distance - radius);
  }

  /// Whether, all over the square, a cone is above another one by no more than `room`. `above` is
  /// what it is above it at the center.
  /// - It is, everywhere, if at both ends of the other one's segment: along that it is convex, and
  ///   from there it grows no faster.
  /// - Far away the gradients differ by no more than the angle between their feet, seen from a
  ///   point of the square.
  bool StandsFor(
    Id cone, Id other, const Point2& center, double radius, double above, double room) const
  {
    if (above > room)
    {
      return false;
    }
    const SegmentCone& a = this->At(cone);
    const SegmentCone& b = this->At(other);
    const double apart = Distance(a.Start, b.Start) + a.Length + b.Length;
    const double away = Distance(center, a.Start) - radius - apart;
    return (away > 0.0 && (room - above) * away > this->Slope * radius * apart) ||
      (a(b.Start, this->Slope) <= b.Value + room &&
        a(b.End(), this->Slope) <= b.Value + b.Slope * b.Length + room);
  }

  /// Leaves, of the candidates from `first` on, those that are lowest at points of a lattice.
  void KeepLowest(const Quadtree::Square& square, std::size_t first)
  {
    constexpr int Points = LatticeCells + 1;
    std::array<Lowest, Points * Points> lowest;
    for (std::size_t k = first; k < this->Candidates.size(); ++k)
    {
      const SegmentCone& cone = this->At(this->Candidates[k]);
      for (int point = 0; point < Points * Points; ++point)
      {
        const Point2 x = square.At(static_cast<double>(point % Points) / LatticeCells,
          static_cast<double>(point / Points) / LatticeCells);
        const double value = cone(x, this->Slope);
        Lowest& least = lowest[static_cast<std::size_t>(point)];
        least = value < least.Value ? Lowest{ this->Candidates[k], value } : least;
      }
    }
    this->Beats.Beat(8 * (this->Candidates.size() - first));
    this->Candidates.resize(first);
    for (const Lowest& least : lowest)
    {
      const auto begin = this->Candidates.begin() + static_cast<std::ptrdiff_t>(first);
      if (std::find(begin, this->Candidates.end(), least.Cone) == this->Candidates.end())
      {
        this->Candidates.push_back(least.Cone);
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
  const std::vector<SegmentCone> Cones;
  const Relief& Less;
  const double Slope;
  const double Margin;
  std::vector<Id> Candidates;
  std::vector<double> Values; ///< at the center of the square at work
  std::vector<Id> NewIds;     ///< of cones that are listed
  double AreaDone = 0.0;
};

ConeTree::ConeTree(const std::vector<SegmentCone>& cones, double slope, const Box2& bounds,
  const Relief& relief, Monitor& monitor)
  : Slope(slope)
  , Bounds(WithExtent(bounds, cones))
  , Tree(this->Bounds)
{
  Builder(*this, cones, relief, monitor).Build();
}

} // namespace biting
