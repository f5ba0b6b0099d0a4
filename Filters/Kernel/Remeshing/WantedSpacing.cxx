// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "WantedSpacing.h"

#include "../Base/Box2.h"
#include "../Spacing/SourceCheck.h"

#include <algorithm> // for min, max
#include <cmath>     // for abs, isfinite
#include <string>    // for details

namespace biting
{

namespace
{

constexpr double SlopeTolerance = 1.02; // that of the law of Spacing

std::shared_ptr<const FeatureSource> FeaturesOf(
  const OldMesh& mesh, const ChangedRegion& region, const RegionEdges& pieces, double mostVertices)
{
  auto features = std::make_shared<FeatureSource>();
  features->MostPieces = 2.0 * mostVertices; // two for an edge
  for (const Id vertex : region.Vertices)
  {
    features->Points.push_back(mesh.Points[vertex]);
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
  return features->Starts.empty() ? nullptr : features;
}

template <typename Vertices>
Box2 BoundsOf(const OldMesh& mesh, const Vertices& vertices)
{
  Box2 box;
  for (const Id vertex : vertices)
  {
    box.Add(mesh.Points[vertex]);
  }
  return box;
}

} // namespace

WantedSpacing::WantedSpacing(const OldMesh& mesh, const SpacingOptions& options,
  const std::vector<double>& values, ProblemList& problems, Monitor& monitor)
  : Mesh(mesh)
  , Options(options)
{
  const bool hasSource = options.Grid || options.Triangulation;
  if (!CheckSpacing(options, problems, monitor))
  {
    return;
  }
  if (!hasSource && !values.empty())
  {
    this->Combine(values, problems);
    this->IsLocal = options.Gradation == 0.0 || this->IsWithinGradation();
    if (this->IsLocal || problems.HasErrors())
    {
      return;
    }
    this->Options.Triangulation = this->SourceOn({});
    this->Options.Scale = 1.0;
    this->Options.Uniform = 0.0;
  }
  const Spacing f = MakeSpacing(this->Options, BoundsOf(mesh, mesh.Corners), problems, monitor);
  this->Values.resize(mesh.Points.size(), 1.0);
  for (std::size_t vertex = 0; vertex < this->Values.size(); ++vertex)
  {
    this->Values[vertex] = f(mesh.Points[vertex]);
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
  for (const double given : values)
  {
    double value = options.Uniform > 0.0 ? std::min(given, options.Uniform) : given;
    value *= options.Scale;
    value = options.Maximum > 0.0 ? std::min(value, options.Maximum) : value;
    this->Values.push_back(std::max(value, options.Minimum));
  }
}

bool WantedSpacing::IsWithinGradation() const
{
  const OldMesh& mesh = this->Mesh;
  const double steepest = SlopeTolerance * this->Options.Gradation;
  for (Id slot = 0; slot < static_cast<Id>(mesh.Corners.size()); ++slot)
  {
    const Id a = mesh.Start(slot);
    const Id b = mesh.End(slot);
    if (std::abs(this->Values[a] - this->Values[b]) >
      steepest * Distance(mesh.Points[a], mesh.Points[b]))
    {
      return false;
    }
  }
  return true;
}

// Of all triangles, where none are given.
std::shared_ptr<const TriangulatedSource> WantedSpacing::SourceOn(
  const std::vector<Id>& triangles) const
{
  auto source = std::make_shared<TriangulatedSource>();
  if (triangles.empty())
  {
    source->Points = this->Mesh.Points;
    source->Values = this->Values;
    source->Triangles = this->Mesh.Corners;
    return source;
  }
  source->CoversDomain = true;
  for (const Id triangle : triangles)
  {
    for (Id slot = 3 * triangle; slot < 3 * triangle + 3; ++slot)
    {
      const Id vertex = this->Mesh.Corners[slot];
      source->Triangles.push_back(static_cast<Id>(source->Points.size()));
      source->Points.push_back(this->Mesh.Points[vertex]);
      source->Values.push_back(this->Values[vertex]);
    }
  }
  return source;
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
    options.Triangulation = this->SourceOn(region.Triangles);
  }
  options.Minimum = this->Options.Minimum;
  options.Features = pieces ? FeaturesOf(this->Mesh, region, *pieces, mostVertices) : nullptr;
  options.Gradation = this->IsLocal && !options.Features ? 0.0 : options.Gradation;
  Spacing f = MakeSpacing(options, BoundsOf(this->Mesh, region.Vertices), problems, monitor);
  if (!problems.HasErrors() && options.Features)
  {
    for (const Id vertex : region.Vertices)
    {
      this->Values[vertex] = f(this->Mesh.Points[vertex]);
    }
  }
  return f;
}

} // namespace biting
