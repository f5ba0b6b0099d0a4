// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RemeshRegion.h"

#include "../Base/Box.h"
#include "../Base/IdLists.h"
#include "../Base/Monitor.h"
#include "../Base/Pulse.h"
#include "../Spacing/SegmentCone.h"
#include "../Spacing/TriangleInterpolator.h"
#include "RegionEdges.h"

#include <algorithm>  // for all_of, min, max
#include <cmath>      // for isfinite, isnormal
#include <cstdint>    // for flags
#include <functional> // for greater
#include <limits>     // for infinity
#include <queue>      // for the order of values
#include <string>     // for details
#include <utility>    // for pair, swap

namespace biting
{

namespace
{

constexpr double SlopeTolerance = 1.02; // that of the law of Spacing
constexpr double SlightShare = 0.003;   // less than this is not handed on

class Lowering
{
public:
  Lowering(const OldMesh& mesh, double gradation, std::vector<double>& values, Pulse& pulse)
    : Mesh(mesh)
    , Gradation(gradation)
    , Values(values)
    , Progress(pulse)
  {
  }

  void Run()
  {
    this->FindSteep();
    if (this->Waiting.empty())
    {
      return;
    }
    this->ListSlots();
    while (!this->Waiting.empty() && this->Progress.Beat())
    {
      const auto [value, vertex] = this->Waiting.top();
      this->Waiting.pop();
      if (value == this->Values[vertex])
      {
        this->HandOn(vertex);
      }
    }
  }

private:
  using Entry = std::pair<double, Id>;

  // The lower ends of edges that are.
  void FindSteep()
  {
    std::vector<std::uint8_t> isLow(this->Values.size(), 0);
    this->Progress.ForEach(this->Mesh.Corners.size(),
      [this, &isLow](std::size_t place)
      {
        const Id slot = static_cast<Id>(place);
        const Id a = this->Mesh.Start(slot);
        const Id b = this->Mesh.End(slot);
        const double rise = this->Values[b] - this->Values[a];
        const double most =
          SlopeTolerance * this->Gradation * Distance(this->Mesh.Points[a], this->Mesh.Points[b]);
        isLow[a] |= rise > most;
        isLow[b] |= -rise > most;
      });
    for (std::size_t vertex = 0; vertex < isLow.size(); ++vertex)
    {
      if (isLow[vertex])
      {
        this->Waiting.emplace(this->Values[vertex], static_cast<Id>(vertex));
      }
    }
  }

  void ListSlots()
  {
    // The last slot first: the order in which values are handed on decides in the last digits.
    this->Slots = IdLists(this->Values.size(),
      [this](const auto& add)
      {
        const std::vector<Id>& corners = this->Mesh.Corners;
        this->Progress.ForEach(corners.size(),
          [&corners, &add](std::size_t k)
          {
            const std::size_t slot = corners.size() - 1 - k;
            add(corners[slot], static_cast<Id>(slot));
          });
      });
  }

  void HandOn(Id vertex)
  {
    for (const Id slot : this->Slots[vertex])
    {
      const Id start = this->Mesh.Start(slot);
      const Id end = this->Mesh.End(slot);
      this->Lower(start, vertex, end);
      this->Lower(end, vertex, start);
    }
  }

  // To what the edge allows.
  void Lower(Id vertex, Id start, Id end)
  {
    if (!(this->Values[start] < this->Values[vertex]))
    {
      return;
    }
    const Point2 edge = this->Mesh.Points[end] - this->Mesh.Points[start];
    const Point2 way = this->Mesh.Points[vertex] - this->Mesh.Points[start];
    const double length = Length(edge);
    double along = Dot(way, edge) / length;
    const double across = Cross(edge, way) / length;
    if (this->Values[end] < this->Values[start])
    {
      std::swap(start, end);
      along = length - along;
    }
    SegmentCone cone; // of an edge along the x axis
    cone.SetValues(
      length, this->Values[start], this->Values[end] - this->Values[start], this->Gradation);
    const double value = cone({ along, across }, this->Gradation);
    if (value < (1.0 - SlightShare) * this->Values[vertex])
    {
      this->Values[vertex] = value;
      this->Waiting.emplace(value, vertex);
    }
  }

  const OldMesh& Mesh;
  const double Gradation;
  std::vector<double>& Values;
  Pulse& Progress;
  IdLists Slots; ///< at each vertex
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> Waiting;
};

// Where steps end, as shares of the time.
constexpr double FirstComparisonEnd = 0.4;
constexpr double PiecesEnd = 0.5;

class RegionFinder
{
public:
  RegionFinder(
    const OldMesh& mesh, const RemeshOptions& options, ProblemList& problems, Monitor& monitor)
    : Mesh(mesh)
    , Options(options)
    , Problems(problems)
    , Whole(monitor, 0.0, 1.0)
  {
    const bool mayMove = options.Edges == EdgePolicy::Free;
    this->Result.Tolerance.Tolerance = mayMove ? options.BoundaryTolerance : 0.0;
    this->Result.Tolerance.FeatureAngle = options.FeatureAngle;
  }

  RemeshRegion Find()
  {
    PartOfStage comparing(this->Whole, 0.0, FirstComparisonEnd);
    WantedSpacing wanted(
      this->Mesh, this->Options.Spacing, this->Options.Values, this->Problems, comparing);
    this->Result.OldSpacings = wanted.AtVertices();
    if (!this->IsOver())
    {
      this->FindRegion();
    }
    if (this->Result.Region.IsEmpty())
    {
      return std::move(this->Result);
    }
    if (this->Result.Tolerance.IsAsked())
    {
      this->Result.Tolerance.Spacings = this->Result.OldSpacings;
    }
    if (this->Options.LimitByFeatureSize)
    {
      this->Limit(wanted);
    }
    else
    {
      this->Prepare(wanted, this->Result.Region, nullptr);
    }
    return std::move(this->Result);
  }

private:
  bool IsOver() const { return this->Problems.HasErrors() || this->Whole.HasStopped(); }

  void FindRegion()
  {
    const std::vector<double>& spacings = this->Result.OldSpacings;
    const std::vector<double> lengths = MeanLengths(this->Mesh, spacings);
    const EdgeFreedom freedom{ this->Options.Edges, this->Result.Tolerance.IsAsked() };
    this->Result.Region = this->Options.RelaxAll
      ? WholeRegion(this->Mesh, lengths)
      : FindChangedRegion(this->Mesh, lengths, FindMisfits(this->Mesh, spacings, lengths, freedom),
          this->Options.Rings);
  }

  void Limit(WantedSpacing& wanted)
  {
    ChangedRegion around = this->Result.Region;
    for (int rings = 1;; rings *= 2)
    {
      const RegionEdges pieces = this->FindPieces(around);
      this->Prepare(wanted, around, &pieces);
      if (this->IsOver())
      {
        return;
      }
      this->Result.OldSpacings = wanted.AtVertices();
      this->FindRegion();
      if (around.Covers(this->Result.Region))
      {
        return;
      }
      around = LargerRegion(this->Mesh, around, this->Result.Region, rings);
    }
  }

  void Prepare(WantedSpacing& wanted, const ChangedRegion& region, const RegionEdges* pieces)
  {
    PartOfStage preparing(this->Whole, PiecesEnd, 1.0);
    this->Result.F = wanted.Prepare(region, pieces,
      static_cast<double>(this->Options.MaximumNumberOfVertices), this->Problems, preparing);
  }

  RegionEdges FindPieces(const ChangedRegion& region)
  {
    PartOfStage finding(this->Whole, FirstComparisonEnd, PiecesEnd);
    return this->Result.Tolerance.IsAsked()
      ? SimplifiedPieces(this->Mesh, region, this->Result.Tolerance, finding)
      : StraightPieces(this->Mesh, region, this->Options.Edges);
  }

  const OldMesh& Mesh;
  const RemeshOptions& Options;
  ProblemList& Problems;
  PartOfStage Whole;
  RemeshRegion Result;
};

} // namespace

void LowerToGradation(
  const OldMesh& mesh, double gradation, std::vector<double>& values, Monitor& monitor)
{
  Pulse pulse(monitor);
  if (gradation > 0.0)
  {
    Lowering(mesh, gradation, values, pulse).Run();
  }
}

WantedSpacing::WantedSpacing(const OldMesh& mesh, const SpacingOptions& options,
  const std::vector<double>& values, ProblemList& problems, Monitor& monitor)
  : Mesh(mesh)
  , Options(options)
{
  if (!CheckSpacing(options, problems, monitor))
  {
    return;
  }
  this->IsLocal = options.Sources.empty() && !values.empty();
  if (this->IsLocal)
  {
    this->Combine(values, problems);
    if (!problems.HasErrors())
    {
      LowerToGradation(mesh, options.Gradation, this->Values, monitor);
    }
    return;
  }
  const Spacing f =
    MakeSpacing(options, Box2::Around(mesh.Points, mesh.Corners), problems, monitor);
  for (const Point2& point : mesh.Points)
  {
    this->Values.push_back(f(point));
  }
}

// As MakeSpacing does, but for the gradation.
void WantedSpacing::Combine(const std::vector<double>& values, ProblemList& problems)
{
  for (std::size_t vertex = 0; vertex < values.size(); ++vertex)
  {
    if (!(values[vertex] > 0.0 && std::isfinite(this->Options.Scale * values[vertex])))
    {
      problems.Add({ ProblemCode::BadSpacing, { static_cast<std::int64_t>(vertex) },
        this->Mesh.Points[vertex], "value " + std::to_string(values[vertex]) + " of the mesh" });
    }
  }
  const SpacingOptions& options = this->Options;
  for (std::size_t vertex = 0; vertex < values.size(); ++vertex)
  {
    const double given = values[vertex];
    double value = options.Uniform > 0.0 ? std::min(given, options.Uniform) : given;
    value *= options.Scale;
    value = options.Maximum > 0.0 ? std::min(value, options.Maximum) : value;
    this->Values.push_back(
      StretchAt(this->Mesh.Points[vertex], options.Curvature) * std::max(value, options.Minimum));
  }
}

double WantedSpacing::LeastOf(const ChangedRegion& region) const
{
  double least = std::numeric_limits<double>::infinity();
  for (const Id vertex : region.Vertices)
  {
    least = std::min(least, this->Values[vertex]);
  }
  return least;
}

// Null where rounding sees no area of any triangle: nothing is linear there.
std::shared_ptr<const TriangulatedSource> WantedSpacing::SourceOn(const ChangedRegion& region) const
{
  const auto isThin = [this](Id triangle)
  {
    const Id* corners = this->Mesh.Corners.data() + 3 * static_cast<std::size_t>(triangle);
    const Point2& a = this->Mesh.Points[corners[0]];
    return !std::isnormal(
      Cross(this->Mesh.Points[corners[1]] - a, this->Mesh.Points[corners[2]] - a));
  };
  if (std::all_of(region.Triangles.begin(), region.Triangles.end(), isThin))
  {
    return nullptr;
  }
  auto source = std::make_shared<TriangulatedSource>();
  source->CoversDomain = true;
  source->IsGraded = true;
  for (const Id vertex : region.Vertices)
  {
    source->Points.push_back(this->Mesh.Points[vertex]);
    source->Values.push_back(this->Values[vertex]);
  }
  for (const Id triangle : region.Triangles)
  {
    for (Id slot = 3 * triangle; slot < 3 * triangle + 3; ++slot)
    {
      source->Triangles.push_back(region.Numbers[this->Mesh.Corners[slot]]);
    }
  }
  return source;
}

std::shared_ptr<const FeatureSource> WantedSpacing::FeaturesOf(const ChangedRegion& region,
  const RegionEdges& pieces, double mostVertices, Monitor& monitor) const
{
  auto features = std::make_shared<FeatureSource>();
  features->MostPieces = 2.0 * mostVertices; // two for an edge
  for (const Id vertex : region.Vertices)
  {
    features->Points.push_back(this->Mesh.Points[vertex]);
  }
  for (const RegionEdge& edge : pieces.Edges)
  {
    if (edge.RimSlot == NoId)
    {
      features->Starts.push_back(edge.Start);
      features->Ends.push_back(edge.End);
      features->LeftInside.push_back(edge.LeftRegion != NoId);
      features->RightInside.push_back(edge.RightRegion != NoId);
    }
  }
  if (features->Starts.empty())
  {
    return nullptr;
  }
  features->Floor = this->LengthsOn(region, monitor);
  return features;
}

// Of the longest marked edge at each vertex, linear in the triangles beside these. Edges across a
// slit say nothing of f, nor do those that were divided for it.
std::function<double(const Point2&)> WantedSpacing::LengthsOn(
  const ChangedRegion& region, Monitor& monitor) const
{
  TriangulatedSource lengths;
  lengths.Values.resize(region.Vertices.size(), 0.0);
  for (const Id vertex : region.Vertices)
  {
    lengths.Points.push_back(this->Mesh.Points[vertex]);
  }
  for (const Id triangle : region.Triangles)
  {
    bool hasMarked = false;
    for (Id slot = 3 * triangle; slot < 3 * triangle + 3; ++slot)
    {
      if (this->Mesh.Marks[slot] != NoId)
      {
        const Id start = region.Numbers[this->Mesh.Start(slot)];
        const Id end = region.Numbers[this->Mesh.End(slot)];
        const double length = Distance(lengths.Points[start], lengths.Points[end]);
        lengths.Values[start] = std::max(lengths.Values[start], length);
        lengths.Values[end] = std::max(lengths.Values[end], length);
        hasMarked = true;
      }
    }
    for (Id slot = 3 * triangle; hasMarked && slot < 3 * triangle + 3; ++slot)
    {
      lengths.Triangles.push_back(region.Numbers[this->Mesh.Corners[slot]]);
    }
  }
  const auto interpolator = std::make_shared<const TriangleInterpolator>(
    std::make_shared<const TriangulatedSource>(std::move(lengths)), monitor);
  if (interpolator->IsEmpty())
  {
    return {};
  }
  return [interpolator](const Point2& place) { return (*interpolator)(place); };
}

Spacing WantedSpacing::Prepare(const ChangedRegion& region, const RegionEdges* pieces,
  double mostVertices, ProblemList& problems, Monitor& monitor)
{
  SpacingOptions options = this->Options;
  if (this->IsLocal)
  {
    const double gradation = options.Gradation;
    options = SpacingOptions();
    options.Gradation = pieces ? gradation : 0.0;
    if (const auto source = this->SourceOn(region))
    {
      options.Sources.emplace_back(source);
    }
    options.Uniform = options.Sources.empty() ? this->LeastOf(region) : 0.0;
  }
  options.Minimum = this->Options.Minimum;
  options.Features = pieces ? this->FeaturesOf(region, *pieces, mostVertices, monitor) : nullptr;
  options.Gradation = this->IsLocal && !options.Features ? 0.0 : options.Gradation;
  Spacing f =
    MakeSpacing(options, Box2::Around(this->Mesh.Points, region.Vertices), problems, monitor);
  this->Limited.clear();
  if (!problems.HasErrors() && options.Features)
  {
    this->Limited = this->Values;
    for (const Id vertex : region.Vertices)
    {
      this->Limited[vertex] = f(this->Mesh.Points[vertex]);
    }
  }
  return f;
}

RemeshRegion FindRemeshRegion(
  const OldMesh& mesh, const RemeshOptions& options, ProblemList& problems, Monitor& monitor)
{
  return RegionFinder(mesh, options, problems, monitor).Find();
}

} // namespace biting
