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
constexpr std::size_t MostCones = 10;

/// Lists longer than this are not looked through for cones that are nowhere lowest.
constexpr std::size_t MostConesToSift = 32;

/// Squares in which the extension may vary by more than this share of itself are not tried.
constexpr double LargestVariation = 0.35;

/// The share of the tolerance that the tested points may use. Others may be worse: at a third, no
/// error above the tolerance was met in millions of probes.
constexpr double TestedShare = 0.3;

/// The share of the tolerance by which a sample may be too high.
constexpr double SearchShare = 0.1;

double Bilinear(const std::array<double, 4>& corners, double u, double v)
{
  const double low = (1.0 - u) * corners[0] + u * corners[1];
  const double high = (1.0 - u) * corners[2] + u * corners[3];
  return (1.0 - v) * low + v * high;
}

} // namespace

/// Refines the tree from the root down.
class CarrierBuilder
{
public:
  CarrierBuilder(AdaptiveCarrier& carrier, Monitor& monitor)
    : Carrier(carrier)
    , Gradation(carrier.Extension.Gradation())
    , Progress(monitor)
  {
  }

  void Build()
  {
    Samples unknown;
    unknown.Part = this->Carrier.Extension.Whole();
    this->Refine(this->Carrier.Tree.Root(), unknown);
    if (this->Carrier.Complete)
    {
      this->Carrier.Tree.Finish();
    }
  }

private:
  using Sample = LowestCone;

  /// The extension at points of a square, no cone where not known yet: Grid[i + 3 j] at
  /// (i / 2, j / 2), Quarters[k] at the center of quarter k. The quarters of the square start from
  /// these.
  struct Samples
  {
    std::array<Sample, 9> Grid;
    std::array<Sample, 4> Quarters;
    SegmentExtension::Part Part; ///< what matters in the square

    Sample& Center() { return this->Grid[4]; }
    std::array<double, 4> Corners() const
    {
      return { this->Grid[0].Value, this->Grid[2].Value, this->Grid[6].Value, this->Grid[8].Value };
    }
  };

  void Refine(const Quadtree::Square& square, Samples& samples)
  {
    if (!this->Carrier.Bounds.Meets(square.Box()))
    {
      this->AddInterpolatingLeaf(square, { 1.0, 1.0, 1.0, 1.0 });
      return;
    }
    this->FindCones(square, samples);
    if (this->AddLeaf(square, samples))
    {
      return;
    }
    this->Carrier.Tree.Split(square);
    for (int quarter = 0; quarter < 4 && this->Carrier.Complete; ++quarter)
    {
      Samples known = KnownOfQuarter(samples, quarter);
      this->Refine(this->Carrier.Tree.Quarter(square, quarter), known);
    }
  }

  static Samples KnownOfQuarter(const Samples& samples, int quarter)
  {
    Samples known;
    const auto first = static_cast<std::size_t>(quarter % 2 + 3 * (quarter / 2));
    known.Grid[0] = samples.Grid[first];
    known.Grid[2] = samples.Grid[first + 1];
    known.Grid[6] = samples.Grid[first + 3];
    known.Grid[8] = samples.Grid[first + 4];
    known.Part = samples.Part;
    known.Center() = samples.Quarters[static_cast<std::size_t>(quarter)];
    return known;
  }

  /// Finds the cones that may be lowest somewhere in the square. All are Lipschitz with the same
  /// constant g, so these are the ones which at the center are within 2 g radius of the lowest.
  void FindCones(const Quadtree::Square& square, Samples& samples)
  {
    const Point2 center = square.At(0.5, 0.5);
    this->HasAllCones = false;
    if (samples.Center().Cone == NoId)
    {
      samples.Center() = this->Carrier.Extension.Evaluate(samples.Part, center, Sample(), 0.0);
    }
    const double limit = samples.Center().Value + 2.0 * this->Gradation * square.Radius();
    samples.Part = this->Carrier.Extension.Narrow(samples.Part, center, limit);
    this->Carrier.Extension.FindBelow(
      samples.Part, center, limit, MostConesToSift + 1, this->Cones);
    this->HasAllCones = this->Cones.size() <= MostConesToSift;
    this->AllCones = this->Cones;
  }

  /// False where the square is to be refined.
  bool AddLeaf(const Quadtree::Square& square, Samples& samples)
  {
    const bool isSimple = this->HasAllCones && this->Cones.size() <= FewCones;
    if (!isSimple && this->IsSmooth(square, samples))
    {
      this->AddInterpolatingLeaf(square, samples.Corners());
      return true;
    }
    if (this->HasAllCones && !isSimple)
    {
      this->Sift(square);
    }
    if (this->Cones.size() <= MostCones)
    {
      this->AddExactLeaf(square);
      return true;
    }
    if (this->CanSplit(square))
    {
      return false;
    }
    this->SampleCorners(square, samples);
    this->AddInterpolatingLeaf(square, samples.Corners());
    return true;
  }

  /// Keeps those cones that are lowest somewhere, to half the tolerance: each of 4 x 4 parts of the
  /// square keeps its own.
  void Sift(const Quadtree::Square& square)
  {
    this->IsLowest.assign(this->AllCones.size(), 0);
    for (int part = 0; part < 16; ++part)
    {
      const Point2 center = square.At(0.125 + 0.25 * (part % 4), 0.125 + 0.25 * (part / 4));
      this->SiftPart(center, 0.5 * this->Gradation * square.Radius());
    }
    this->Cones.clear();
    for (std::size_t position = 0; position < this->AllCones.size(); ++position)
    {
      if (this->IsLowest[position] != 0)
      {
        this->Cones.push_back(this->AllCones[position]);
      }
    }
  }

  void SiftPart(const Point2& center, double variation)
  {
    double least = std::numeric_limits<double>::infinity();
    this->Values.resize(this->AllCones.size());
    for (std::size_t position = 0; position < this->AllCones.size(); ++position)
    {
      this->Values[position] = this->Carrier.Extension.ConeAt(this->AllCones[position], center);
      least = std::min(least, this->Values[position]);
    }
    const double limit =
      least + std::max(0.0, variation - 0.5 * AdaptiveCarrier::Tolerance * least);
    for (std::size_t position = 0; position < this->AllCones.size(); ++position)
    {
      if (this->Values[position] <= limit)
      {
        this->IsLowest[position] = 1;
      }
    }
  }

  /// Whether interpolation between the corners is good enough: tested where the samples are.
  bool IsSmooth(const Quadtree::Square& square, Samples& samples)
  {
    if (this->Gradation * square.Radius() > LargestVariation * samples.Center().Value)
    {
      return false;
    }
    this->SampleCorners(square, samples);
    return this->FitsAt(samples, 0.5, 0.5, samples.Center().Value) &&
      this->FitsGrid(square, samples) && this->FitsQuarters(square, samples);
  }

  void SampleCorners(const Quadtree::Square& square, Samples& samples)
  {
    for (int corner : { 0, 2, 6, 8 })
    {
      this->SampleGrid(square, corner, samples);
    }
  }

  bool FitsGrid(const Quadtree::Square& square, Samples& samples)
  {
    for (int node : { 1, 3, 5, 7 })
    {
      const double exact = this->SampleGrid(square, node, samples);
      if (!this->FitsAt(samples, 0.5 * (node % 3), 0.5 * (node / 3), exact))
      {
        return false;
      }
    }
    return true;
  }

  bool FitsQuarters(const Quadtree::Square& square, Samples& samples)
  {
    for (int quarter = 0; quarter < 4; ++quarter)
    {
      const double u = 0.25 + 0.5 * (quarter % 2);
      const double v = 0.25 + 0.5 * (quarter / 2);
      Sample& sample = samples.Quarters[static_cast<std::size_t>(quarter)];
      sample = this->Evaluate(square, u, v, samples);
      if (!this->FitsAt(samples, u, v, sample.Value))
      {
        return false;
      }
    }
    return true;
  }

  static bool FitsAt(const Samples& samples, double u, double v, double exact)
  {
    const double error = std::abs(Bilinear(samples.Corners(), u, v) - exact);
    return error <= TestedShare * AdaptiveCarrier::Tolerance * exact;
  }

  double SampleGrid(const Quadtree::Square& square, int node, Samples& samples)
  {
    Sample& sample = samples.Grid[static_cast<std::size_t>(node)];
    if (sample.Cone == NoId)
    {
      sample = this->Evaluate(square, 0.5 * (node % 3), 0.5 * (node / 3), samples);
    }
    return sample.Value;
  }

  /// The extension at a point of the square: cones that are lowest nearby are tried first.
  Sample Evaluate(const Quadtree::Square& square, double u, double v, const Samples& samples)
  {
    const Point2 x = square.At(u, v);
    Sample lowest;
    if (this->HasAllCones)
    {
      for (Id cone : this->AllCones)
      {
        this->Try(cone, x, lowest);
      }
      return lowest;
    }
    for (const Sample* known :
      { &samples.Grid[4], &samples.Grid[0], &samples.Grid[2], &samples.Grid[6], &samples.Grid[8] })
    {
      this->Try(known->Cone, x, lowest);
    }
    return this->Carrier.Extension.Evaluate(
      samples.Part, x, lowest, SearchShare * AdaptiveCarrier::Tolerance);
  }

  void Try(Id cone, const Point2& x, Sample& lowest) const
  {
    if (cone != NoId && cone != lowest.Cone)
    {
      const double value = this->Carrier.Extension.ConeAt(cone, x);
      lowest = value < lowest.Value ? Sample{ value, cone } : lowest;
    }
  }

  bool CanSplit(const Quadtree::Square& square) const
  {
    const std::size_t leaves =
      2 * std::max(this->Carrier.CornerValues.size(), this->Carrier.Lists.size());
    return square.Level < Quadtree::MaximumLevel && leaves + 8 < Quadtree::MaximumLeafNumber;
  }

  void AddInterpolatingLeaf(const Quadtree::Square& square, const std::array<double, 4>& corners)
  {
    const auto number = static_cast<Id>(this->Carrier.CornerValues.size());
    this->Carrier.CornerValues.push_back(corners);
    this->Carrier.Tree.SetLeaf(square, 2 * number);
    this->Report(square);
  }

  void AddExactLeaf(const Quadtree::Square& square)
  {
    std::vector<Id>& listed = this->Carrier.ListedCones;
    const auto number = static_cast<Id>(this->Carrier.Lists.size());
    this->Carrier.Lists.push_back(
      { static_cast<Id>(listed.size()), static_cast<Id>(this->Cones.size()) });
    listed.insert(listed.end(), this->Cones.begin(), this->Cones.end());
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
  const double Gradation;
  Monitor& Progress;
  double AreaDone = 0.0;
  std::int64_t LeafCount = 0;

  // Of the square at work.
  bool HasAllCones = false; ///< AllCones is complete
  std::vector<Id> AllCones; ///< that may be lowest somewhere
  std::vector<Id> Cones;    ///< the same, as far as needed to half the tolerance
  std::vector<double> Values;
  std::vector<std::uint8_t> IsLowest;
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
    least = std::min(least, this->Extension.ConeAt(cone, inside));
  }
  return least;
}

} // namespace biting
