// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Spacing.h"

#include "AdaptiveCarrier.h"
#include "GridHoles.h"
#include "GridInterpolator.h"
#include "SourceCheck.h"
#include "SourceSlopes.h"
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

} // namespace

/// What is left of the sources after preparation. A source that is one value everywhere becomes part
/// of Uniform.
struct Spacing::Implementation
{
  std::optional<GridInterpolator> Grid;
  std::optional<TriangleInterpolator> Triangulation;
  std::optional<AdaptiveCarrier> Segments;
  double Uniform = Infinity; ///< infinite: none
  double Scale = 1.0;
  double Least = std::numeric_limits<double>::min();
  double Greatest = std::numeric_limits<double>::max();
  double GivenLipschitz = 0.0;

  bool Prepare(
    const SpacingOptions& options, const Box2& bounds, ProblemList& problems, Monitor& monitor)
  {
    this->SetParameters(options);
    this->AddGrid(options);
    const bool isComplete = this->AddTriangulation(options, problems) &&
      this->AddSegments(options, bounds, problems, monitor);
    if (this->IsUniform() && this->Uniform == Infinity)
    {
      const double diagonal = bounds.Diagonal();
      this->Uniform = diagonal > 0.0 ? DefaultShareOfDiagonal * diagonal : 1.0;
    }
    return isComplete;
  }

  bool IsUniform() const { return !this->Grid && !this->Triangulation && !this->Segments; }

  double Evaluate(const Point2& x) const
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
    return std::min(std::max(this->Scale * least, this->Least), this->Greatest);
  }

private:
  void SetParameters(const SpacingOptions& options)
  {
    this->Uniform = options.Uniform > 0.0 ? options.Uniform : Infinity;
    this->Scale = options.Scale;
    this->Least = std::max(this->Least, options.Minimum);
    this->Greatest = options.Maximum > 0.0 ? options.Maximum : this->Greatest;
  }

  void AddGrid(const SpacingOptions& options)
  {
    if (!HasValues(options.Grid))
    {
      return;
    }
    const double only = OnlyValue(options.Grid->Values);
    this->Uniform = std::min(this->Uniform, only);
    if (only == Infinity)
    {
      this->AddSlope(LargestSlope(*options.Grid));
      this->Grid.emplace(FillHoles(options.Grid));
    }
  }

  bool AddTriangulation(const SpacingOptions& options, ProblemList& problems)
  {
    if (!HasTriangles(options.Triangulation))
    {
      return true;
    }
    const double only = OnlyValue(options.Triangulation->Values);
    this->Uniform = std::min(this->Uniform, only);
    if (only == Infinity)
    {
      this->AddSlope(LargestSlope(*options.Triangulation));
      this->Triangulation.emplace(*options.Triangulation);
    }
    const bool isUsable = !this->Triangulation || !this->Triangulation->IsEmpty();
    if (!isUsable)
    {
      problems.Add({ ProblemCode::BadSpacing, {}, {},
        "no triangle has an area and three values in the triangulated source" });
    }
    return isUsable;
  }

  bool AddSegments(
    const SpacingOptions& options, const Box2& bounds, ProblemList& problems, Monitor& monitor)
  {
    if (!HasSegments(options.Segments))
    {
      return true;
    }
    const double only = OnlyValue(options.Segments->Values);
    if (only < Infinity && options.Gradation == 0.0)
    {
      this->Uniform = std::min(this->Uniform, only);
      return true;
    }
    this->AddSlope(LargestSlope(*options.Segments));
    this->Segments.emplace(SegmentExtension(*options.Segments, options.Gradation),
      CarrierBox(bounds, *options.Segments), monitor);
    if (!this->Segments->IsComplete())
    {
      problems.Add({ ProblemCode::Aborted, {}, {}, {} });
    }
    return this->Segments->IsComplete();
  }

  void AddSlope(double slope)
  {
    this->GivenLipschitz = std::max(this->GivenLipschitz, this->Scale * slope);
  }
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
  if (!CheckSpacing(options, problems))
  {
    return spacing;
  }
  auto data = std::make_unique<Spacing::Implementation>();
  if (data->Prepare(options, bounds, problems, monitor))
  {
    spacing.Data = std::move(data);
  }
  return spacing;
}

} // namespace biting
