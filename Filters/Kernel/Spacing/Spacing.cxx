// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing.h"

#include "../Base/PartOfStage.h"
#include "AdaptiveCarrier.h"
#include "ConeCollector.h"
#include "FeatureSize.h"
#include "GridHoles.h"
#include "GridInterpolator.h"
#include "GridLimit.h"
#include "LowerBound.h"
#include "OutsideJumps.h"
#include "SourceCheck.h"
#include "SourceSlopes.h"
#include "SteepTriangles.h"
#include "TriangleInterpolator.h"

#include <algorithm> // for min, max
#include <limits>    // for infinity
#include <optional>  // for sources that may be missing
#include <utility>   // for move

namespace biting
{
namespace
{

constexpr double DefaultShareOfDiagonal = 0.02;
/// Leaves of a carrier, at which it is asked whether a mesh with so many vertices is affordable.
constexpr double LeavesPerVertex = 0.1;
constexpr double LeastLeaves = 10000.0;
constexpr double MostLeaves = 50000.0;

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// The one value that all have, holes apart; infinite where they differ or there is none.
double OnlyValue(const std::vector<double>& values)
{
  double only = Infinity;
  for (double value : values)
  {
    if (only == Infinity && !std::isnan(value))
    {
      only = value;
    }
    if (value < only || value > only)
    {
      return Infinity;
    }
  }
  return only;
}

bool HasValues(const std::shared_ptr<const GridSource>& source)
{
  return source && !source->Values.empty();
}

bool HasTriangles(const std::shared_ptr<const TriangulatedSource>& source)
{
  return source && !source->Triangles.empty();
}

bool HasSegments(const std::shared_ptr<const SegmentSource>& source)
{
  return source && !source->Segments.empty();
}

/// Whether a source is given that is not one value everywhere.
bool HasGrid(const SpacingOptions& options)
{
  return HasValues(options.Grid) && OnlyValue(options.Grid->Values) == Infinity;
}

bool HasTriangulation(const SpacingOptions& options)
{
  return HasTriangles(options.Triangulation) &&
    OnlyValue(options.Triangulation->Values) == Infinity;
}

/// The same for boundary values, from which f grows.
bool HasExtension(const SpacingOptions& options)
{
  return HasSegments(options.Segments) &&
    (options.Gradation > 0.0 || OnlyValue(options.Segments->Values) == Infinity);
}

/// The least of what is one value everywhere; infinite where there is none.
double UniformOf(const SpacingOptions& options)
{
  double uniform = options.Uniform > 0.0 ? options.Uniform : Infinity;
  if (HasValues(options.Grid))
  {
    uniform = std::min(uniform, OnlyValue(options.Grid->Values));
  }
  if (HasTriangles(options.Triangulation))
  {
    uniform = std::min(uniform, OnlyValue(options.Triangulation->Values));
  }
  if (HasSegments(options.Segments) && !HasExtension(options))
  {
    uniform = std::min(uniform, OnlyValue(options.Segments->Values));
  }
  return uniform;
}

/// The domain's box; a box of no extent is replaced by that of the source, grown to have one.
Box2 CarrierBox(const Box2& bounds, const SegmentSource& source)
{
  Box2 box = bounds;
  if (!(box.Diagonal() > 0.0))
  {
    for (const Point2& point : source.Points)
    {
      box.Add(point);
    }
    const double extent = box.Diagonal();
    box.Grow(extent > 0.0 ? extent : source.Values.front());
  }
  return box;
}

/// The slope of what grows from features, and falls from a floor, also where f is as given.
double GradationOf(const SpacingOptions& options)
{
  return options.Gradation > 0.0 ? options.Gradation : SpacingOptions().Gradation;
}

} // namespace

/// What is left of the sources after preparation: what is given, and what limits it. A source that is
/// one value everywhere becomes part of Uniform. Boundary values are among the limits, as long as they
/// grow inwards with the gradation itself.
struct Spacing::Implementation
{
  std::optional<GridInterpolator> Grid;
  std::optional<TriangleInterpolator> Triangulation;
  std::optional<AdaptiveCarrier> Segments; ///< before scale and clamp
  std::optional<AdaptiveCarrier> Limit;    ///< of f itself
  std::optional<LowerBound> Floor;
  double Uniform = Infinity; ///< infinite: none
  ValueRange Range{ 1.0, std::numeric_limits<double>::min(), std::numeric_limits<double>::max() };
  double GivenLipschitz = 0.0;

  Implementation() = default;

  Implementation(const SpacingOptions& options, const Box2& bounds)
  {
    this->Range.Scale = options.Scale;
    this->Range.Least = std::max(this->Range.Least, options.Minimum);
    this->Range.Most = options.Maximum > 0.0 ? options.Maximum : this->Range.Most;
    this->Uniform = UniformOf(options);
    if (this->Uniform == Infinity && !HasGrid(options) && !HasTriangulation(options) &&
      !HasExtension(options))
    {
      const double diagonal = bounds.Diagonal();
      this->Uniform = diagonal > 0.0 ? DefaultShareOfDiagonal * diagonal : 1.0;
    }
  }

  bool IsUniform() const
  {
    return !this->Grid && !this->Triangulation && !this->Segments && !this->Limit && !this->Floor;
  }

  double EvaluateGiven(const Point2& x) const
  {
    double least = this->Uniform;
    if (this->Grid)
    {
      least = std::min(least, (*this->Grid)(x));
    }
    if (this->Triangulation)
    {
      least = std::min(least, (*this->Triangulation)(x));
    }
    if (this->Segments)
    {
      least = std::min(least, (*this->Segments)(x));
    }
    return this->Range(least);
  }

  double Evaluate(const Point2& x) const
  {
    const double given = this->EvaluateGiven(x);
    const double limited =
      this->Limit ? std::max(std::min(given, (*this->Limit)(x)), this->Range.Least) : given;
    return this->Floor ? this->Floor->Raise(x, limited) : limited;
  }
};

/// Fills in the implementation. Each step is false where f cannot be, or the monitor asks to stop.
class Spacing::Preparation
{
public:
  Preparation(const SpacingOptions& options, const Box2& bounds, const Spacing& whole,
    Implementation& data, ProblemList& problems, PartOfStage& stage)
    : Options(options)
    , Bounds(bounds)
    , Whole(whole)
    , Data(data)
    , Problems(problems)
    , Stage(stage)
    , Cones({ data.Range.Scale, data.Range.Least, data.Range(data.Uniform) })
  {
  }

  bool Run()
  {
    return this->AddGrid() && this->AddTriangulation() && this->AddSegments() &&
      this->AddFeatures() && this->AddLimit() && this->AddFloor();
  }

private:
  bool AddGrid()
  {
    if (!HasGrid(this->Options))
    {
      return true;
    }
    PartOfStage measuring(this->Stage, 0.05, 0.08);
    this->AddSlope(LargestSlope(*this->Options.Grid, measuring));
    PartOfStage filling(this->Stage, 0.08, 0.15);
    std::shared_ptr<const GridSource> grid = FillHoles(this->Options.Grid, filling);
    if (grid && this->Options.Gradation > 0.0)
    {
      PartOfStage limiting(this->Stage, 0.15, 0.3);
      grid = LimitGrid(grid, this->Options.Gradation, this->Cones, limiting);
    }
    if (grid && !this->Stage.HasStopped())
    {
      this->Data.Grid.emplace(grid);
    }
    return !this->Stage.HasStopped();
  }

  bool AddTriangulation()
  {
    if (!HasTriangulation(this->Options))
    {
      return true;
    }
    PartOfStage measuring(this->Stage, 0.3, 0.32);
    this->AddSlope(LargestSlope(*this->Options.Triangulation, measuring));
    PartOfStage sorting(this->Stage, 0.32, 0.45);
    this->Data.Triangulation.emplace(*this->Options.Triangulation, sorting);
    if (this->Stage.HasStopped())
    {
      return false;
    }
    if (this->Data.Triangulation->IsEmpty())
    {
      this->Problems.Add({ ProblemCode::BadSpacing, {}, {},
        "no triangle has an area and three values in the triangulated source" });
      return false;
    }
    return this->Options.Gradation == 0.0 || this->LimitTriangulation();
  }

  bool LimitTriangulation()
  {
    PartOfStage inside(this->Stage, 0.45, 0.48);
    PartOfStage outside(this->Stage, 0.48, 0.5);
    return AddSteepTriangles(
             *this->Options.Triangulation, this->Options.Gradation, this->Cones, inside) &&
      AddOutsideJumps(
        *this->Data.Triangulation, this->Bounds, this->Options.Gradation, this->Cones, outside);
  }

  bool AddSegments()
  {
    if (!HasExtension(this->Options))
    {
      return true;
    }
    const SegmentSource& source = *this->Options.Segments;
    this->AddSlope(LargestSlope(source));
    PartOfStage sorting(this->Stage, 0.5, 0.52);
    SegmentExtension extension(source, this->Options.Gradation, sorting);
    if (this->Stage.HasStopped())
    {
      return false;
    }
    if (this->Options.Gradation > 0.0 && this->Options.Scale >= 1.0)
    {
      this->Exact.emplace(std::move(extension));
      return true;
    }
    PartOfStage refining(this->Stage, 0.52, 0.6);
    const double most = std::min(this->Data.Uniform, this->Data.Range.Most / this->Options.Scale);
    this->Data.Segments.emplace(std::move(extension), CarrierBox(this->Bounds, source));
    return this->Data.Segments->Refine(this->ReliefAbove(most), refining);
  }

  AdaptiveCarrier::Relief ReliefAbove(double most) const
  {
    AdaptiveCarrier::Relief relief{ most, this->Options.IsUnused, nullptr, 0 };
    if (this->Options.ForecastVertices)
    {
      relief.ForecastVertices = [this](Monitor& monitor)
      { return this->Options.ForecastVertices(this->Whole, monitor); };
      relief.ManyLeaves = static_cast<std::size_t>(
        std::min(std::max(LeavesPerVertex * this->Options.ManyVertices, LeastLeaves), MostLeaves));
    }
    return relief;
  }

  /// The extension is scaled, then clamped: below the least value m of f it is cut off at a distance
  /// of (m / scale - f_i) / g from its segments. From there on f grows with g, and not scale times g.
  void AddScaled(const SegmentSource& source)
  {
    const double scale = this->Options.Scale;
    const double least = this->Data.Range.Least;
    const auto grown = [scale, least](double value)
    { return std::max(scale * value, value + least * (1.0 - 1.0 / scale)); };
    for (std::size_t first = 0; first + 1 < source.Segments.size(); first += 2)
    {
      const auto a = static_cast<std::size_t>(source.Segments[first]);
      const auto b = static_cast<std::size_t>(source.Segments[first + 1]);
      this->Cones.AddSegment(
        source.Points[a], source.Points[b], grown(source.Values[a]), grown(source.Values[b]));
    }
  }

  bool AddFeatures()
  {
    PartOfStage sampling(this->Stage, 0.6, 0.7);
    return !this->Options.Features ||
      AddFeatureSizes(
        *this->Options.Features, [this](const Point2& x) { return this->EvaluateGiven(x); },
        this->Data.Range(this->Data.Uniform), GradationOf(this->Options), this->Cones, sampling);
  }

  double EvaluateGiven(const Point2& x) const
  {
    const double given = this->Data.EvaluateGiven(x);
    return this->Exact ? std::min(given, this->Data.Range((*this->Exact)(x))) : given;
  }

  bool AddLimit()
  {
    const bool isExact =
      this->Exact && this->Cones.Segments().Segments.empty() && this->Options.Scale == 1.0;
    if (isExact)
    {
      return this->AddLimit(std::move(*this->Exact), *this->Options.Segments);
    }
    if (this->Exact)
    {
      this->Exact.reset();
      this->AddScaled(*this->Options.Segments);
    }
    const SegmentSource& source = this->Cones.Segments();
    PartOfStage sorting(this->Stage, 0.7, 0.75);
    return source.Segments.empty() ||
      this->AddLimit(SegmentExtension(source, GradationOf(this->Options), sorting), source);
  }

  bool AddLimit(SegmentExtension extension, const SegmentSource& source)
  {
    if (this->Stage.HasStopped())
    {
      return false;
    }
    PartOfStage refining(this->Stage, 0.75, 1.0);
    this->Data.Limit.emplace(std::move(extension), CarrierBox(this->Bounds, source));
    return this->Data.Limit->Refine(this->ReliefAbove(this->Cones.Values().Most), refining);
  }

  bool AddFloor()
  {
    if (HasSegments(this->Options.Floor))
    {
      PartOfStage sorting(this->Stage, 1.0, 1.0);
      this->Data.Floor.emplace(*this->Options.Floor, GradationOf(this->Options), sorting);
    }
    return !this->Stage.HasStopped();
  }

  void AddSlope(double slope)
  {
    this->Data.GivenLipschitz = std::max(this->Data.GivenLipschitz, this->Data.Range.Scale * slope);
  }

  const SpacingOptions& Options;
  const Box2& Bounds;
  const Spacing& Whole; ///< of which Data is the inside
  Implementation& Data;
  ProblemList& Problems;
  PartOfStage& Stage;
  ConeCollector Cones;
  std::optional<SegmentExtension> Exact; ///< of boundary values that will be among the cones
};

Spacing::Spacing()
{
  auto constant = std::make_unique<Implementation>();
  constant->Uniform = 1.0;
  this->Data = std::move(constant);
}

Spacing::~Spacing() = default;
Spacing::Spacing(Spacing&&) noexcept = default;
Spacing& Spacing::operator=(Spacing&&) noexcept = default;

double Spacing::operator()(const Point2& x) const
{
  return this->Data->Evaluate(x);
}

double Spacing::GivenLipschitz() const
{
  return this->Data->GivenLipschitz;
}

bool Spacing::IsUniform() const
{
  return this->Data->IsUniform();
}

Spacing MakeSpacing(
  const SpacingOptions& options, const Box2& bounds, ProblemList& problems, Monitor& monitor)
{
  Spacing spacing;
  PartOfStage stage(monitor, 0.0, 1.0);
  PartOfStage checking(stage, 0.0, 0.05);
  auto data = std::make_unique<Spacing::Implementation>(options, bounds);
  Spacing::Implementation& inside = *data;
  spacing.Data = std::move(data);
  if (CheckSpacing(options, problems, checking) &&
    Spacing::Preparation(options, bounds, spacing, inside, problems, stage).Run())
  {
    return spacing;
  }
  if (stage.HasStopped())
  {
    problems.Add({ ProblemCode::Aborted, {}, {}, {} });
  }
  return Spacing();
}

} // namespace biting
