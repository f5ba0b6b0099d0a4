// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "AdaptiveCarrier.h"

#include <algorithm> // for all_of
#include <cstdint>   // for counts
#include <limits>    // for infinity
#include <utility>   // for move

namespace biting
{
namespace
{

/// With so few cones a leaf is as fast as an interpolating one, and exact.
constexpr std::size_t FewCones = 2;

/// With more cones, evaluation takes longer than a deeper tree; with fewer, the tree grows.
constexpr std::size_t MostCones = 8;

/// Lists longer than this are not looked through for cones that are nowhere lowest.
constexpr std::size_t MostConesToSift = 32;

/// Squares in which the extension may vary by more than this share of itself are not tried.
constexpr double LargestVariation = 0.25;

/// The share of the tolerance that the tested points may use: others may be worse.
constexpr double TestedShare = 0.7;

constexpr std::array<std::array<double, 2>, 13> TestPoints{ { { 0.5, 0.5 }, { 0.5, 0.0 },
  { 0.0, 0.5 }, { 1.0, 0.5 }, { 0.5, 1.0 }, { 0.25, 0.25 }, { 0.75, 0.25 }, { 0.25, 0.75 },
  { 0.75, 0.75 }, { 0.5, 0.25 }, { 0.25, 0.5 }, { 0.75, 0.5 }, { 0.5, 0.75 } } };

double Bilinear(const std::array<double, 4>& corners, double u, double v)
{
  const double low = (1.0 - u) * corners[0] + u * corners[1];
  const double high = (1.0 - u) * corners[2] + u * corners[3];
  return (1.0 - v) * low + v * high;
}

} // namespace

/// Refines the tree from the root down. Each square gets, from the list of its parent, the cones
/// that may be lowest in it: all are Lipschitz with the same constant g, so these are the ones
/// which at its center are within 2 g radius of the lowest.
class CarrierBuilder
{
public:
  CarrierBuilder(AdaptiveCarrier& carrier, Monitor& monitor)
    : Carrier(carrier)
    , Cones(carrier.Extension.Cones)
    , Gradation(carrier.Extension.Gradation)
    , Progress(monitor)
  {
  }

  void Build()
  {
    for (std::size_t cone = 0; cone < this->Cones.size(); ++cone)
    {
      this->Candidates.push_back(static_cast<Id>(cone));
    }
    this->Refine(this->Carrier.Tree.Root(), 0);
    if (this->Carrier.Complete)
    {
      this->Carrier.Tree.Finish();
    }
  }

private:
  /// The candidates of the parent are those from `parentFirst` on.
  void Refine(const Quadtree::Square& square, std::size_t parentFirst)
  {
    const std::size_t first = this->Candidates.size();
    if (!this->Carrier.Bounds.Meets(square.Box()))
    {
      this->AddUnusedLeaf(square);
      return;
    }
    const double center = this->Select(square, parentFirst);
    if (this->AddLeaf(square, first, center))
    {
      this->Candidates.resize(first);
      return;
    }
    this->Carrier.Tree.Split(square);
    for (int quarter = 0; quarter < 4 && this->Carrier.Complete; ++quarter)
    {
      this->Refine(this->Carrier.Tree.Quarter(square, quarter), first);
    }
    this->Candidates.resize(first);
  }

  /// Appends the candidates of a square; returns the extension at its center.
  double Select(const Quadtree::Square& square, std::size_t parentFirst)
  {
    const std::size_t parentLast = this->Candidates.size();
    const Point2 center = square.At(0.5, 0.5);
    const double least = this->Evaluate(center, parentFirst);
    const double limit = least + 2.0 * this->Gradation * square.Radius();
    for (std::size_t position = parentFirst; position < parentLast; ++position)
    {
      if (this->Values[position - parentFirst] <= limit)
      {
        this->Candidates.push_back(this->Candidates[position]);
      }
    }
    return least;
  }

  /// The lowest candidate from `first` on; leaves all values in Values.
  double Evaluate(const Point2& x, std::size_t first)
  {
    double least = std::numeric_limits<double>::infinity();
    this->Values.resize(this->Candidates.size() - first);
    for (std::size_t position = 0; position < this->Values.size(); ++position)
    {
      const auto cone = static_cast<std::size_t>(this->Candidates[first + position]);
      this->Values[position] = this->Cones[cone](x, this->Gradation);
      least = std::min(least, this->Values[position]);
    }
    return least;
  }

  /// False where the square is to be refined.
  bool AddLeaf(const Quadtree::Square& square, std::size_t first, double center)
  {
    this->Sift(square, first);
    if (this->Sifted.size() > FewCones && this->IsSmooth(square, first, center))
    {
      this->AddInterpolatingLeaf(square);
      return true;
    }
    if (this->Sifted.size() > MostCones && this->CanSplit(square))
    {
      return false;
    }
    this->AddExactLeaf(square);
    return true;
  }

  /// Finds those candidates that are lowest somewhere, to half the tolerance: each of 4 x 4 parts
  /// of the square keeps its own candidates.
  void Sift(const Quadtree::Square& square, std::size_t first)
  {
    this->Sifted.assign(
      this->Candidates.begin() + static_cast<std::ptrdiff_t>(first), this->Candidates.end());
    if (this->Sifted.size() <= FewCones || this->Sifted.size() > MostConesToSift)
    {
      return;
    }
    this->IsLowest.assign(this->Sifted.size(), false);
    for (int part = 0; part < 16; ++part)
    {
      this->SiftPart(
        square.At(0.125 + 0.25 * (part % 4), 0.125 + 0.25 * (part / 4)), square.Radius(), first);
    }
    std::size_t kept = 0;
    for (std::size_t position = 0; position < this->Sifted.size(); ++position)
    {
      this->Sifted[kept] = this->Sifted[position];
      kept += this->IsLowest[position] ? 1 : 0;
    }
    this->Sifted.resize(kept);
  }

  void SiftPart(const Point2& center, double radiusOfWhole, std::size_t first)
  {
    const double least = this->Evaluate(center, first);
    const double variation = 0.5 * this->Gradation * radiusOfWhole;
    const double margin = std::max(0.0, variation - 0.5 * AdaptiveCarrier::Tolerance * least);
    for (std::size_t position = 0; position < this->Values.size(); ++position)
    {
      if (this->Values[position] <= least + margin)
      {
        this->IsLowest[position] = true;
      }
    }
  }

  /// Whether interpolation between the corners is good enough; leaves these in Corners.
  bool IsSmooth(const Quadtree::Square& square, std::size_t first, double center)
  {
    if (this->Gradation * square.Radius() > LargestVariation * center)
    {
      return false;
    }
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      const Point2 place = square.At(corner % 2 == 1 ? 1.0 : 0.0, corner > 1 ? 1.0 : 0.0);
      this->Corners[corner] = this->Evaluate(place, first);
    }
    return std::all_of(TestPoints.begin(), TestPoints.end(),
      [this, &square, first](const auto& point)
      {
        const double exact = this->Evaluate(square.At(point[0], point[1]), first);
        const double error = std::abs(Bilinear(this->Corners, point[0], point[1]) - exact);
        return error <= TestedShare * AdaptiveCarrier::Tolerance * exact;
      });
  }

  bool CanSplit(const Quadtree::Square& square) const
  {
    const std::size_t leaves =
      2 * std::max(this->Carrier.CornerValues.size(), this->Carrier.Lists.size());
    return square.Level < Quadtree::MaximumLevel && leaves + 8 < Quadtree::MaximumLeafNumber;
  }

  void AddInterpolatingLeaf(const Quadtree::Square& square)
  {
    const auto number = static_cast<Id>(this->Carrier.CornerValues.size());
    this->Carrier.CornerValues.push_back(this->Corners);
    this->Carrier.Tree.SetLeaf(square, 2 * number);
    this->Report(square);
  }

  /// For squares outside of the box, which are never asked for.
  void AddUnusedLeaf(const Quadtree::Square& square)
  {
    this->Corners.fill(this->Cones.front().Value);
    this->AddInterpolatingLeaf(square);
  }

  void AddExactLeaf(const Quadtree::Square& square)
  {
    std::vector<Id>& cones = this->Carrier.ListedCones;
    const auto number = static_cast<Id>(this->Carrier.Lists.size());
    this->Carrier.Lists.push_back(
      { static_cast<Id>(cones.size()), static_cast<Id>(this->Sifted.size()) });
    cones.insert(cones.end(), this->Sifted.begin(), this->Sifted.end());
    this->Carrier.Tree.SetLeaf(square, 2 * number + 1);
    this->Report(square);
  }

  void Report(const Quadtree::Square& square)
  {
    this->AreaDone += std::ldexp(1.0, -2 * square.Level);
    if (++this->LeafCount % 1000 == 0)
    {
      this->Carrier.Complete = this->Progress.Advance(std::min(this->AreaDone, 1.0));
    }
  }

  AdaptiveCarrier& Carrier;
  const std::vector<SegmentCone>& Cones;
  const double Gradation;
  Monitor& Progress;
  std::vector<Id> Candidates; ///< a stack of lists, one a level
  std::vector<double> Values;
  std::vector<Id> Sifted;
  std::vector<bool> IsLowest;
  std::array<double, 4> Corners{};
  double AreaDone = 0.0;
  std::int64_t LeafCount = 0;
};

AdaptiveCarrier::AdaptiveCarrier(SegmentExtension extension, const Box2& bounds, Monitor& monitor)
  : Extension(std::move(extension))
  , Bounds(bounds)
  , Tree(bounds)
{
  CarrierBuilder(*this, monitor).Build();
}

double AdaptiveCarrier::operator()(const Point2& x) const
{
  const Point2 inside{ std::min(std::max(this->Bounds.Low.X, x.X), this->Bounds.High.X),
    std::min(std::max(this->Bounds.Low.Y, x.Y), this->Bounds.High.Y) };
  const Quadtree::Place place = this->Tree.Locate(inside);
  const auto number = static_cast<std::size_t>(place.Leaf / 2);
  if (place.Leaf % 2 == 0)
  {
    return Bilinear(this->CornerValues[number], place.U, place.V);
  }
  const ConeList& list = this->Lists[number];
  double least = std::numeric_limits<double>::infinity();
  for (Id position = list.First; position < list.First + list.Count; ++position)
  {
    const Id cone = this->ListedCones[static_cast<std::size_t>(position)];
    least = std::min(least,
      this->Extension.Cones[static_cast<std::size_t>(cone)](inside, this->Extension.Gradation));
  }
  return least;
}

} // namespace biting
