// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "AdaptiveCarrier.h"

#include "../Base/PartOfStage.h"

#include <algorithm> // for min, max, find, transform
#include <cmath>     // for isfinite, ldexp
#include <cstdint>   // for counts
#include <limits>    // for infinity
#include <utility>   // for move

namespace biting
{
namespace
{

/// With so few cones a leaf is as fast as an interpolating one, and exact, however large.
constexpr std::size_t FewCones = 2;

/// With more cones, evaluation takes longer than in a deeper tree.
constexpr std::size_t MostCones = 12;

/// Squares in which the extension may vary by more than this share of itself are not interpolated:
/// there the tests would see too little.
constexpr double InterpolatedVariation = 0.35;

/// The same for squares of many cones that the samples have to find: a cone that no sample sees is
/// lower than the others by no more than a small share of the variation.
constexpr double SampledVariation = 0.1;

/// The share of the tolerance that an interpolating leaf may use where it is tested: elsewhere it is
/// a few times as wrong.
constexpr double TestedShare = 0.2;

/// The share of the tolerance by which a sample may be too high.
constexpr double SearchShare = 0.1;

/// Of the largest coordinate: more than the rounding of a square, and of a place that is looked up.
/// Such a place may be found in a square that it lies beside.
constexpr double RoundingShare = 8.0 * std::numeric_limits<double>::epsilon();

/// Searches between two calls of the monitor.
constexpr std::int64_t StepsPerReport = 1000;

/// The parabola through three values at 0, 1/2 and 1.
double Parabola(const double* values, std::size_t step, double u)
{
  return values[0] * (1.0 - u) * (1.0 - 2.0 * u) + values[step] * 4.0 * u * (1.0 - u) +
    values[2 * step] * u * (2.0 * u - 1.0);
}

double LargestCoordinate(const Box2& box)
{
  return std::max(
    { std::abs(box.Low.X), std::abs(box.Low.Y), std::abs(box.High.X), std::abs(box.High.Y) });
}

double Biquadratic(const std::array<double, 9>& nodes, double u, double v)
{
  const double rows[3] = { Parabola(&nodes[0], 1, u), Parabola(&nodes[3], 1, u),
    Parabola(&nodes[6], 1, u) };
  return Parabola(rows, 1, v);
}

} // namespace

/// Refines the tree from the root down.
class CarrierBuilder
{
public:
  CarrierBuilder(AdaptiveCarrier& carrier, const AdaptiveCarrier::Relief& relief, Monitor& monitor)
    : Carrier(carrier)
    , Gradation(carrier.Extension.Gradation())
    , Relief(relief)
    , Progress(monitor)
    , Margin(RoundingShare * LargestCoordinate(carrier.Bounds))
  {
  }

  enum class End
  {
    Complete,
    TooLarge,
    Stopped
  };

  End Build()
  {
    Samples unknown;
    unknown.Part = this->Carrier.Extension.Whole();
    this->Refine(this->Carrier.Tree.Root(), unknown);
    if (this->IsOver)
    {
      return this->IsTooLarge ? End::TooLarge : End::Stopped;
    }
    this->Carrier.Tree.Finish();
    return End::Complete;
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
    std::array<double, 9> Values() const
    {
      std::array<double, 9> values;
      std::transform(this->Grid.begin(), this->Grid.end(), values.begin(),
        [](const Sample& sample) { return sample.Value; });
      return values;
    }
  };

  void Refine(const Quadtree::Square& square, Samples& samples)
  {
    if (!this->Carrier.Bounds.Meets(this->BoxOf(square)))
    {
      this->AddLevelLeaf(square, 1.0);
      return;
    }
    if (this->AddLeaf(square, samples))
    {
      return;
    }
    this->Carrier.Tree.Split(square);
    for (int quarter = 0; quarter < 4 && !this->IsOver; ++quarter)
    {
      Samples known = KnownOfQuarter(samples, quarter);
      this->Refine(this->Carrier.Tree.Quarter(square, quarter), known);
    }
  }

  /// Of all places that are found in the square.
  Box2 BoxOf(const Quadtree::Square& square) const
  {
    Box2 box = square.Box();
    box.Grow(this->Margin);
    return box;
  }

  static Samples KnownOfQuarter(const Samples& samples, int quarter)
  {
    Samples known;
    const auto first = static_cast<std::size_t>(quarter % 2 + 3 * (quarter / 2));
    known.Grid[0] = samples.Grid[first];
    known.Grid[2] = samples.Grid[first + 1];
    known.Grid[6] = samples.Grid[first + 3];
    known.Grid[8] = samples.Grid[first + 4];
    known.Center() = samples.Quarters[static_cast<std::size_t>(quarter)];
    known.Part = samples.Part;
    return known;
  }

  /// False where the square is to be refined. All cones are Lipschitz with the same constant g, so
  /// those that may be lowest somewhere in a square are those which at the center are within
  /// 2 g radius of the lowest.
  bool AddLeaf(const Quadtree::Square& square, Samples& samples)
  {
    const double variation = this->Gradation * square.Radius();
    this->Complete(square, 0.5, 0.5, samples, samples.Center());
    const double value = samples.Center().Value;
    const bool isRough = variation <= InterpolatedVariation * value;
    if (value - variation >= this->Relief.Most ||
      (isRough && this->Relief.IsUnused && this->Relief.IsUnused(this->BoxOf(square))))
    {
      this->AddLevelLeaf(square, value);
      return true;
    }
    const Point2 center = square.At(0.5, 0.5);
    // The search finds what is below it, also where a slope next to none is lost in rounding.
    const double limit =
      std::nextafter(value + 2.0 * variation, std::numeric_limits<double>::infinity());
    samples.Part = this->Carrier.Extension.Narrow(samples.Part, center, limit);
    this->Carrier.Extension.FindBelow(samples.Part, center, limit, MostCones + 1, this->Cones);
    const bool isLast = !this->CanSplit(square);
    return (this->Cones.size() <= FewCones && this->AddListLeaf(square)) ||
      (isRough && this->AddSmoothLeaf(square, samples)) ||
      (this->Cones.size() <= MostCones && this->AddListLeaf(square)) ||
      ((variation <= SampledVariation * value || isLast) &&
        this->AddSampledLeaf(square, samples, isLast));
  }

  /// A leaf that interpolates, if it does so well.
  bool AddSmoothLeaf(const Quadtree::Square& square, Samples& samples)
  {
    for (int node = 0; node < 9; ++node)
    {
      this->Complete(square, 0.5 * (node % 3), 0.5 * (node / 3), samples,
        samples.Grid[static_cast<std::size_t>(node)]);
    }
    const std::array<double, 9> values = samples.Values();
    for (int quarter = 0; quarter < 4; ++quarter)
    {
      const double u = 0.25 + 0.5 * (quarter % 2);
      const double v = 0.25 + 0.5 * (quarter / 2);
      Sample& sample = samples.Quarters[static_cast<std::size_t>(quarter)];
      this->Complete(square, u, v, samples, sample);
      const double error = std::abs(Biquadratic(values, u, v) - sample.Value);
      if (error > TestedShare * AdaptiveCarrier::Tolerance * sample.Value)
      {
        return false;
      }
    }
    this->AddNodes(square, values);
    return true;
  }

  /// A leaf of the cones that are lowest at the samples. All are known: the square was tried for
  /// interpolation.
  bool AddSampledLeaf(const Quadtree::Square& square, const Samples& samples, bool isLast)
  {
    this->Cones.clear();
    for (const Sample& sample : samples.Grid)
    {
      this->List(sample.Cone);
    }
    for (const Sample& sample : samples.Quarters)
    {
      this->List(sample.Cone);
    }
    return (this->Cones.size() <= MostCones || isLast) && this->AddListLeaf(square);
  }

  void List(Id cone)
  {
    if (cone != NoId &&
      std::find(this->Cones.begin(), this->Cones.end(), cone) == this->Cones.end())
    {
      this->Cones.push_back(cone);
    }
  }

  /// Finds the extension at (u, v) of the square, if it is not known. Cones that are lowest nearby
  /// are tried first.
  void Complete(
    const Quadtree::Square& square, double u, double v, const Samples& samples, Sample& sample)
  {
    if (sample.Cone != NoId)
    {
      return;
    }
    if (++this->StepCount % StepsPerReport == 0)
    {
      this->IsOver |= !this->Progress.Advance(std::min(this->AreaDone, 1.0));
    }
    const Point2 x = square.At(u, v);
    Sample lowest;
    for (int known : { 4, 0, 2, 6, 8 })
    {
      this->Try(samples.Grid[static_cast<std::size_t>(known)].Cone, x, lowest);
    }
    sample = this->Carrier.Extension.Evaluate(
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
      2 * std::max(this->Carrier.NodeValues.size(), this->Carrier.Lists.size());
    return square.Level < Quadtree::MaximumLevel && leaves + 8 < Quadtree::MaximumLeafNumber;
  }

  void AddLevelLeaf(const Quadtree::Square& square, double value)
  {
    std::array<double, 9> values;
    values.fill(value);
    this->AddNodes(square, values);
  }

  void AddNodes(const Quadtree::Square& square, const std::array<double, 9>& values)
  {
    const auto number = static_cast<Id>(this->Carrier.NodeValues.size());
    this->Carrier.NodeValues.push_back(values);
    this->Carrier.Tree.SetLeaf(square, 2 * number);
    this->CountLeaf(square);
  }

  bool AddListLeaf(const Quadtree::Square& square)
  {
    std::vector<Id>& listed = this->Carrier.ListedCones;
    const auto number = static_cast<Id>(this->Carrier.Lists.size());
    this->Carrier.Lists.push_back(
      { static_cast<Id>(listed.size()), static_cast<Id>(this->Cones.size()) });
    listed.insert(listed.end(), this->Cones.begin(), this->Cones.end());
    this->Carrier.Tree.SetLeaf(square, 2 * number + 1);
    this->CountLeaf(square);
    return true;
  }

  void CountLeaf(const Quadtree::Square& square)
  {
    this->AreaDone += std::ldexp(1.0, -2 * square.Level);
    ++this->Leaves;
    if (this->Leaves == this->Relief.ManyLeaves && this->Relief.ForecastVertices)
    {
      const double done = std::min(this->AreaDone, 1.0);
      PartOfStage asking(this->Progress, done, done);
      const double vertices = this->Relief.ForecastVertices(asking);
      const double many = std::max(vertices, static_cast<double>(this->Leaves));
      this->MostLeaves = AdaptiveCarrier::LeavesPerVertex * many;
      this->IsOver |= !std::isfinite(vertices) || asking.HasStopped();
    }
    this->IsTooLarge = static_cast<double>(this->Leaves) > this->MostLeaves;
    this->IsOver |= this->IsTooLarge;
  }

  AdaptiveCarrier& Carrier;
  const double Gradation;
  const AdaptiveCarrier::Relief& Relief;
  Monitor& Progress;
  const double Margin;
  bool IsOver = false;
  bool IsTooLarge = false;
  double MostLeaves = std::numeric_limits<double>::infinity();
  double AreaDone = 0.0;
  std::size_t Leaves = 0;
  std::int64_t StepCount = 0;
  std::vector<Id> Cones; ///< of the square at work
};

AdaptiveCarrier::AdaptiveCarrier(SegmentExtension extension, const Box2& bounds)
  : Extension(std::move(extension))
  , Bounds(bounds)
  , Tree(bounds)
{
}

bool AdaptiveCarrier::Refine(const Relief& relief, Monitor& monitor)
{
  const CarrierBuilder::End end = CarrierBuilder(*this, relief, monitor).Build();
  this->Complete = end == CarrierBuilder::End::Complete;
  if (!this->Complete)
  {
    this->Tree = Quadtree(this->Bounds);
    this->NodeValues = {};
    this->Lists = {};
    this->ListedCones = {};
  }
  return end != CarrierBuilder::End::Stopped;
}

double AdaptiveCarrier::operator()(const Point2& x) const
{
  const Point2 inside{ std::min(std::max(this->Bounds.Low.X, x.X), this->Bounds.High.X),
    std::min(std::max(this->Bounds.Low.Y, x.Y), this->Bounds.High.Y) };
  if (!this->Complete)
  {
    return this->Extension(inside);
  }
  const Quadtree::Place place = this->Tree.Locate(inside);
  const auto number = static_cast<std::size_t>(place.Leaf / 2);
  if (place.Leaf % 2 == 0)
  {
    return Biquadratic(this->NodeValues[number], place.U, place.V);
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
