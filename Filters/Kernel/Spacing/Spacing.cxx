// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing.h"

#include "../Base/FreedMemory.h"
#include "../Base/Monitor.h"
#include "../Base/Numbers.h"
#include "../Base/Tasks.h"
#include "../Predicates/Predicates.h" // for GreatestCoordinate
#include "ConeTree.h"
#include "FeatureSize.h"
#include "GridInterpolator.h"
#include "SegmentCone.h"
#include "TriangleInterpolator.h"

#include <algorithm> // for min, max
#include <cmath>     // for isnan
#include <limits>    // for the least double
#include <optional>  // for limits that may be missing
#include <utility>   // for move

namespace biting
{
namespace
{

constexpr double DefaultShareOfDiagonal = 0.02;

/// Far above what a drawing may be large; fourth powers of it do not overflow.
constexpr double GreatestSpacing = 1e4 * GreatestCoordinate;

/// By which f may change where cones are merged, as a share.
constexpr double MergingTolerance = 0.006;

/// Where sources are as steep as this times the gradation f is below them.
constexpr double SteepTolerance = 1.02;

/// The slope of what grows from features, and falls from a floor, also where f is as given.
double GradationOf(const SpacingOptions& options)
{
  return options.Gradation > 0.0 ? options.Gradation : SpacingOptions().Gradation;
}

/// The same f, without sources that are one value everywhere, holes apart: these are part of
/// Uniform, which is infinite where there is none. From boundary values f grows, unless there is no
/// gradation. No value is above GreatestSpacing: slopes of fill values as large as numbers get
/// would not be finite.
SpacingOptions WithoutConstants(SpacingOptions options)
{
  std::vector<GivenSource> all = std::move(options.Sources);
  std::stable_sort(all.begin(), all.end(),
    [](const GivenSource& a, const GivenSource& b) { return a.index() < b.index(); });
  options.Sources.clear();
  options.Uniform = options.Uniform > 0.0 ? options.Uniform : Infinity;
  const double most = GreatestSpacing / std::max(options.Scale, 1.0);
  const auto keep = [&options, most](auto source)
  {
    using Kind = std::decay_t<decltype(*source)>;
    const bool mayGrow = std::is_same_v<Kind, SegmentSource> && options.Gradation > 0.0;
    double least = Infinity;
    double greatest = 0.0;
    if (source->IsEmpty())
    {
      return;
    }
    for (const double value : source->Values)
    {
      least = std::min(least, value);
      greatest = std::max(greatest, value);
    }
    if (!(least < greatest) && !mayGrow)
    {
      options.Uniform = std::min(options.Uniform, std::min(least, most));
      return;
    }
    if (greatest > most)
    {
      auto cut = std::make_shared<Kind>(*source);
      std::replace_if(
        cut->Values.begin(), cut->Values.end(), [most](double value) { return value > most; },
        most);
      source = std::move(cut);
    }
    options.Sources.emplace_back(std::move(source));
  };
  for (const GivenSource& source : all)
  {
    std::visit(keep, source);
  }
  return options;
}

} // namespace

/// What is left of the sources after preparation: what is given, and what limits it. A source that
/// is one value everywhere becomes part of Uniform. Steep edges of sources are among the limits;
/// boundary values, too, as long as they grow inwards with the gradation itself.
struct Spacing::Implementation
{
  std::vector<std::shared_ptr<const Source>> Sources;
  std::vector<ConeTree<2>> Segments; ///< of boundary values that do not grow with the gradation
  std::optional<ConeTree<2>> Limit;
  std::optional<SegmentExtension>
    LimitBeforeFeatures;                 ///< a part of Limit, where there are features
  std::optional<SegmentExtension> Floor; ///< of its values, negative
  double Uniform = Infinity;             ///< infinite: none
  ValueRange Range{ 1.0, std::numeric_limits<double>::min(), GreatestSpacing };
  double GivenLipschitz = 0.0;
  double Curvature = 0.0;
  double LargestStretch = 1.0; ///< in the bounds

  Implementation() = default;

  /// Of options without constants.
  Implementation(const SpacingOptions& options, const Box2& bounds)
  {
    this->Range.Scale = options.Scale;
    this->Range.Least = std::max(this->Range.Least, options.Minimum);
    this->Range.Most =
      options.Maximum > 0.0 ? std::min(options.Maximum, this->Range.Most) : this->Range.Most;
    this->Uniform = options.Uniform;
    this->Curvature = options.Curvature;
    for (const Point2& corner : { bounds.Low, bounds.High, Point2{ bounds.Low.X, bounds.High.Y },
           Point2{ bounds.High.X, bounds.Low.Y } })
    {
      this->LargestStretch = std::max(this->LargestStretch, this->StretchAt(corner));
    }
    if (this->Uniform == Infinity && options.Sources.empty())
    {
      const double diagonal = bounds.Diagonal() / this->LargestStretch;
      this->Uniform = diagonal > 0.0 ? DefaultShareOfDiagonal * diagonal : 1.0;
    }
  }

  bool IsUniform() const
  {
    return this->Sources.empty() && this->Segments.empty() && !this->Limit && !this->Floor &&
      this->Curvature == 0.0;
  }

  double StretchAt(const Point2& x) const { return biting::StretchAt(x, this->Curvature); }

  double EvaluateGiven(const Point2& x) const
  {
    double least = this->Uniform;
    for (const auto& source : this->Sources)
    {
      least = std::min(least, (*source)(x));
    }
    double given = this->StretchAt(x) * this->Range(least);
    for (const ConeTree<2>& tree : this->Segments)
    {
      given = this->Lowered(given, tree, x);
    }
    return given;
  }

  double EvaluateBeforeFeatures(const Point2& x) const
  {
    const double given = this->EvaluateGiven(x);
    return std::max((*this->LimitBeforeFeatures)(x, given), this->StretchAt(x) * this->Range.Least);
  }

  double EvaluateBeforeFloor(const Point2& x) const
  {
    const double given = this->EvaluateGiven(x);
    return this->Limit ? this->Lowered(given, *this->Limit, x) : given;
  }

  double Evaluate(const Point2& x) const
  {
    const double limited = this->EvaluateBeforeFloor(x);
    return this->Floor ? -(*this->Floor)(x, -limited) : limited;
  }

private:
  double Lowered(double value, const ConeTree<2>& bound, const Point2& x) const
  {
    return std::max(std::min(value, bound(x)), this->StretchAt(x) * this->Range.Least);
  }
};

/// Fills in the implementation. Each step is false where f cannot be, or the monitor asks to stop.
class Spacing::Preparation
{
public:
  Preparation(const SpacingOptions& options, const Box2& bounds, Implementation& data,
    ProblemList& problems, PartOfStage& stage)
    : Options(options)
    , Bounds(bounds)
    , Data(data)
    , Problems(problems)
    , Stage(stage)
    , Range({ data.Range.Scale, data.Range.Least, data.Range(data.Uniform) })
  {
  }

  bool Run()
  {
    const SpacingOptions& given = this->Options;
    return this->AddSources() && (!given.Features || this->AddFeatures()) && this->AddLimit() &&
      (!given.Floor || this->AddFloor());
  }

private:
  bool AddSources()
  {
    bool isGood = true;
    for (std::size_t k = 0; k < this->Options.Sources.size() && isGood; ++k)
    {
      const double share = 0.5 / static_cast<double>(this->Options.Sources.size());
      const double begin = 0.05 + share * static_cast<double>(k);
      PartOfStage part(this->Stage, begin, begin + share);
      isGood = std::visit([this, &part](const auto& source) { return this->Add(source, part); },
        this->Options.Sources[k]);
    }
    return isGood;
  }

  bool Add(const std::shared_ptr<const GridSource>& grid, PartOfStage& part)
  {
    Pulse pulse(part);
    return this->AddSource(std::make_shared<GridInterpolator>(grid, this->Bounds, pulse), pulse);
  }

  bool Add(const std::shared_ptr<const TriangulatedSource>& triangles, PartOfStage& part)
  {
    const auto source = std::make_shared<TriangleInterpolator>(triangles, part);
    Pulse pulse(part);
    if (source->IsEmpty() && !part.HasStopped())
    {
      this->Problems.Add({ ProblemCode::BadSpacing, {}, {},
        "no triangle has an area and three values in the triangulated source" });
      return false;
    }
    return this->AddSource(source, pulse);
  }

  /// And the edges where it is too steep.
  bool AddSource(std::shared_ptr<const Source> source, Pulse& pulse)
  {
    const double gradation = this->Options.Gradation / this->Data.LargestStretch;
    if (!this->Stage.HasStopped())
    {
      const std::size_t first = this->Low.Points.size();
      this->AddSlope(source->AddLowEdges(
        { gradation > 0.0 ? SteepTolerance * gradation : Infinity, this->Range, this->Bounds },
        this->Low, pulse));
      for (std::size_t end = first; end < this->Low.Points.size(); ++end)
      {
        this->Low.Values[end] *= this->Data.StretchAt(this->Low.Points[end]);
      }
      this->Data.Sources.push_back(std::move(source));
    }
    return !this->Stage.HasStopped();
  }

  bool Add(const std::shared_ptr<const SegmentSource>& segments, PartOfStage& part)
  {
    this->AddSlope(LargestSlope(*segments));
    const double scale = this->Options.Scale;
    if (this->Options.Gradation > 0.0 && scale >= 1.0)
    {
      this->AddScaled(*segments);
    }
    else
    {
      const double slope = scale * SlopeOfCones(*segments, this->Options.Gradation);
      this->Data.Segments.push_back(this->MakeTree(*segments, scale, slope, part));
    }
    return !this->Stage.HasStopped();
  }

  /// Boundary values are scaled, then clamped. From where f exceeds its least value on, at a
  /// distance of (Least / scale - f_i) / g from the segment, it grows with g, and not scale times
  /// g.
  void AddScaled(const SegmentSource& source)
  {
    const double scale = this->Options.Scale;
    const double least = this->Data.Range.Least * (1.0 - 1.0 / scale);
    const auto grown = [&source, scale, least](std::size_t point)
    { return std::max(scale * source.Values[point], source.Values[point] + least); };
    for (std::size_t first = 0; first < source.Segments.size(); first += 2)
    {
      const auto a = static_cast<std::size_t>(source.Segments[first]);
      const auto b = static_cast<std::size_t>(source.Segments[first + 1]);
      this->Low.Add(source.Points[a], source.Points[b], grown(a), grown(b));
    }
  }

  ConeTree<2> MakeTree(
    const SegmentSource& source, double scale, double slope, PartOfStage& part) const
  {
    Pulse pulse(part);
    return { MakeCones(source, scale, slope, pulse, MergingTolerance), slope, this->Bounds,
      this->Data.LargestStretch * this->Range.Most, part };
  }

  bool AddFeatures()
  {
    PartOfStage filing(this->Stage, 0.6, 0.62);
    Pulse pulse(filing);
    const double slope = GradationOf(this->Options);
    this->Data.LimitBeforeFeatures.emplace(
      MakeCones(this->Low, 1.0, slope, pulse, MergingTolerance), slope, pulse);
    PartOfStage sampling(this->Stage, 0.62, 0.7);
    return !filing.HasStopped() &&
      AddFeatureSizes(*this->Options.Features,
        { [this](const Point2& x) { return this->Data.EvaluateBeforeFeatures(x); },
          this->Range(LeastGiven(this->Options)), this->Data.LargestStretch * this->Range.Most,
          this->Range.Least, slope },
        this->Low, sampling);
  }

  bool AddLimit()
  {
    if (!this->Low.Segments.empty())
    {
      PartOfStage refining(this->Stage, 0.7, 1.0);
      this->Data.Limit = this->MakeTree(this->Low, 1.0, GradationOf(this->Options), refining);
    }
    return !this->Stage.HasStopped();
  }

  /// Where f is not below a point of the floor, it is not anywhere, as it falls no faster from
  /// there: unless it is as given.
  bool AddFloor()
  {
    PartOfStage sorting(this->Stage, 1.0, 1.0);
    Pulse pulse(sorting);
    const double slope = GradationOf(this->Options);
    std::vector<SegmentCone> cones = MakeCones(*this->Options.Floor, -1.0, slope, pulse);
    const auto isHigh = [this, &pulse](const SegmentCone& cone)
    {
      return this->Options.Gradation > 0.0 && cone.Length == 0.0 && pulse.Beat(16) &&
        cone.Value >= -this->Data.EvaluateBeforeFloor(cone.Start);
    };
    cones.erase(std::remove_if(cones.begin(), cones.end(), isHigh), cones.end());
    if (!cones.empty())
    {
      this->Data.Floor.emplace(cones, slope, pulse);
    }
    return !this->Stage.HasStopped();
  }

  void AddSlope(double slope)
  {
    this->Data.GivenLipschitz = std::max(this->Data.GivenLipschitz, this->Data.Range.Scale * slope);
  }

  const SpacingOptions& Options;
  const Box2& Bounds;
  Implementation& Data;
  ProblemList& Problems;
  PartOfStage& Stage;
  const ValueRange Range; ///< up to Uniform
  SegmentSource Low;      ///< from which f may grow no faster than the gradation
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

double Spacing::BeforeFeatures(const Point2& x) const
{
  return this->Data->LimitBeforeFeatures ? this->Data->EvaluateBeforeFeatures(x)
                                         : this->Data->Evaluate(x);
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
  KeepFreedMemory();
  Spacing spacing;
  PartOfStage stage(monitor, 0.0, 1.0);
  PartOfStage checking(stage, 0.0, 0.05);
  const SpacingOptions varying = WithoutConstants(options);
  auto data = std::make_unique<Spacing::Implementation>(varying, bounds);
  Spacing::Implementation& inside = *data;
  spacing.Data = std::move(data);
  if (CheckSpacing(options, problems, checking) &&
    Spacing::Preparation(varying, bounds, inside, problems, stage).Run())
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
