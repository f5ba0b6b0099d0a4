// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BitingMesh.h"

#include "Biting/BitingScheme.h"
#include "Biting/VertexEstimate.h"
#include "Calibration.h"
#include "Delaunay/Triangulation.h"
#include "Domain/DomainLocator.h"
#include "MeshAssembly.h"
#include "Quality/MeshCheck.h"

#include <cmath>   // for abs
#include <limits>  // for the largest id
#include <sstream> // for figures in messages
#include <utility> // for move

namespace biting
{

namespace
{

constexpr int MostTriangulations = 5; // each later one has fewer constraints in conflict
constexpr double CoverageTolerance =
  1e-6; // of a length: rounding of the sum, and of close vertices

// The order of the mesh's figures.
std::string Figure(double value)
{
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

void AddProblem(ProblemCode code, const std::string& detail, ProblemList& problems)
{
  Problem problem;
  problem.Code = code;
  problem.Detail = detail;
  problems.Add(problem);
}

BitingOptions MakeBitingOptions(const BitingMeshOptions& options)
{
  BitingOptions biting;
  biting.BitingConstant = options.BitingConstant;
  biting.Order = options.Order;
  biting.MaximumNumberOfBites = options.MaximumNumberOfBites;
  biting.MaximumNumberOfVertices =
    std::min<std::int64_t>(options.MaximumNumberOfVertices, std::numeric_limits<Id>::max() / 8);
  biting.KeepFront = options.KeepBites;
  return biting;
}

void AddTooManyVertices(double estimate, std::int64_t limit, ProblemList& problems)
{
  AddProblem(ProblemCode::TooManyVertices,
    "about " + Figure(estimate) + " vertices, the limit is " + std::to_string(limit), problems);
}

BitingResult Bite(const Domain& domain, const Spacing& spacing, BitingOptions options,
  ProblemList& problems, Monitor& monitor)
{
  const DomainLocator locator(domain);
  const double density = IntegrateDensity(domain, locator, spacing);
  const double estimate = EstimateNumberOfVertices(density, options) + domain.NumberOfVertices() +
    EstimateDivisionPoints(domain, spacing, 1.0);
  if (!(estimate <= static_cast<double>(options.MaximumNumberOfVertices)))
  {
    AddTooManyVertices(estimate, options.MaximumNumberOfVertices, problems);
    return {};
  }
  if (options.BitingConstant == 0.0)
  {
    options.BitingConstant =
      CalibrateBitingConstant(domain, locator, spacing, density, options, monitor);
    options.PartLength = 1.0;
  }
  BitingResult bites = BiteDomain(domain, locator, spacing, estimate, options, monitor);
  if (bites.End == BitingEnd::TooManyVertices)
  {
    // The estimate did not see all of f: more than the limit is what is known.
    AddTooManyVertices(std::max(estimate, static_cast<double>(options.MaximumNumberOfVertices)),
      options.MaximumNumberOfVertices, problems);
  }
  if (bites.End == BitingEnd::Aborted)
  {
    AddProblem(ProblemCode::Aborted, "", problems);
  }
  if (!options.KeepFront)
  {
    bites.Bites = {};
  }
  return bites;
}

ConstraintEdges MakeConstraints(const Domain& domain, const BitingResult& bites)
{
  ConstraintEdges constraints{ bites.EdgeStarts, bites.EdgeEnds, {} };
  for (Id segment : bites.EdgeSegments)
  {
    constraints.IsBoundary.push_back(domain.IsBoundary[segment]);
  }
  return constraints;
}

// Vertices nearer to each other than rounding are none.
SpacingOptions AboveRounding(SpacingOptions spacing, const Domain& domain)
{
  const bool isBelow = spacing.Minimum >= 0.0 && spacing.Minimum < domain.Resolution;
  const bool isFree = spacing.Maximum == 0.0 || spacing.Maximum > domain.Resolution;
  spacing.Minimum = isBelow && isFree ? domain.Resolution : spacing.Minimum;
  return spacing;
}

using Flags = std::vector<std::uint8_t>;

// The constraints that are not a union of mesh edges: as long as these are together.
std::vector<Id> FindUncovered(const BitingResult& bites, const Triangulation& triangulation)
{
  std::vector<double> rest;
  for (std::size_t edge = 0; edge < bites.EdgeStarts.size(); ++edge)
  {
    rest.push_back(
      Distance(bites.Points[bites.EdgeStarts[edge]], bites.Points[bites.EdgeEnds[edge]]));
  }
  const std::vector<double> lengths = rest;
  for (std::size_t half = 0; half < triangulation.Corners.size(); ++half)
  {
    const Id constraint = triangulation.Constraints[half];
    const bool isFirst = triangulation.Neighbors[half] < static_cast<Id>(half / 3);
    if (constraint != NoId && isFirst)
    {
      const std::size_t corner = half % 3;
      const Id u = triangulation.Corners[half - corner + (corner + 1) % 3];
      const Id v = triangulation.Corners[half - corner + (corner + 2) % 3];
      rest[constraint] -= Distance(bites.Points[u], bites.Points[v]);
    }
  }
  std::vector<Id> uncovered;
  for (std::size_t edge = 0; edge < rest.size(); ++edge)
  {
    if (!(std::abs(rest[edge]) <= CoverageTolerance * lengths[edge]))
    {
      uncovered.push_back(static_cast<Id>(edge));
    }
  }
  return uncovered;
}

// 1 for the segments whose parts cross or coincide with those of others, and for those that share an
// end with one that the parts of others cut off from the mesh.
Flags SegmentsInConflict(const Domain& domain, const TriangulationResult& result,
  const std::vector<Id>& uncovered, const BitingResult& bites)
{
  Flags isInConflict(domain.NumberOfSegments(), 0);
  for (const auto* pairs : { &result.Conflicts, &result.Coincidences })
  {
    for (const ConstraintConflict& pair : *pairs)
    {
      isInConflict[bites.EdgeSegments[pair.First]] = 1;
      isInConflict[bites.EdgeSegments[pair.Second]] = 1;
    }
  }
  Flags isAtConflict(domain.NumberOfVertices(), 0);
  for (const Id edge : uncovered)
  {
    isAtConflict[domain.Starts[bites.EdgeSegments[edge]]] = 1;
    isAtConflict[domain.Ends[bites.EdgeSegments[edge]]] = 1;
  }
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    isInConflict[segment] |=
      isAtConflict[domain.Starts[segment]] | isAtConflict[domain.Ends[segment]];
  }
  return isInConflict;
}

// Takes the new vertices off segments, and these back to one edge each: the segments themselves do
// not cross.
void UndoDivisions(const Domain& domain, const Flags& isUndone, BitingResult& bites)
{
  BitingResult kept;
  std::vector<Id> numbers;
  for (std::size_t vertex = 0; vertex < bites.Points.size(); ++vertex)
  {
    const Id segment = bites.Segments[vertex];
    const bool isKept = segment == NoId || !isUndone[segment];
    numbers.push_back(isKept ? static_cast<Id>(kept.Points.size()) : NoId);
    if (isKept)
    {
      kept.Points.push_back(bites.Points[vertex]);
      kept.Spacings.push_back(bites.Spacings[vertex]);
      kept.BiteOrders.push_back(bites.BiteOrders[vertex]);
      kept.Segments.push_back(segment);
    }
  }
  Id last = NoId;
  for (std::size_t edge = 0; edge < bites.EdgeSegments.size(); ++edge)
  {
    const Id segment = bites.EdgeSegments[edge];
    if (isUndone[segment] && segment == last)
    {
      continue;
    }
    last = segment;
    kept.EdgeStarts.push_back(
      isUndone[segment] ? domain.Starts[segment] : numbers[bites.EdgeStarts[edge]]);
    kept.EdgeEnds.push_back(
      isUndone[segment] ? domain.Ends[segment] : numbers[bites.EdgeEnds[edge]]);
    kept.EdgeSegments.push_back(segment);
  }
  kept.Bites = std::move(bites.Bites);
  kept.Front = std::move(bites.Front);
  bites = std::move(kept);
}

// Where rounded points of two close segments make their parts cross or coincide, or cut one off from
// the mesh, their division is taken back; before the last attempt that of all segments.
Triangulation TriangulateBites(const Domain& domain, const TriangulationOptions& options,
  BitingResult& bites, ProblemList& problems, Monitor& monitor)
{
  for (int attempt = 1; attempt <= MostTriangulations; ++attempt)
  {
    TriangulationResult result =
      Triangulate(bites.Points, MakeConstraints(domain, bites), options, monitor);
    if (result.WasAborted)
    {
      AddProblem(ProblemCode::Aborted, "", problems);
      return {};
    }
    const std::vector<Id> uncovered =
      result.Conflicts.empty() ? FindUncovered(bites, result.Mesh) : std::vector<Id>();
    if (result.Conflicts.empty() && result.Coincidences.empty() && uncovered.empty())
    {
      return std::move(result.Mesh);
    }
    const bool isLastChance = attempt == MostTriangulations - 1;
    UndoDivisions(domain,
      isLastChance ? Flags(domain.NumberOfSegments(), 1)
                   : SegmentsInConflict(domain, result, uncovered, bites),
      bites);
  }
  AddProblem(ProblemCode::CheckFailed, "a part of a segment is not in the mesh", problems);
  return {};
}

void Check(const Domain& domain, const BitingMesh& mesh, const std::vector<Id>& constraints,
  ProblemList& problems)
{
  const std::string violation =
    CheckMesh({ mesh.Points, mesh.Corners, mesh.Neighbors, constraints, domain.Area });
  if (!violation.empty())
  {
    AddProblem(ProblemCode::CheckFailed, violation, problems);
  }
}

} // namespace

BitingMesh MakeBitingMesh(
  const Polylines& input, const BitingMeshOptions& options, ProblemList& problems, Monitor& monitor)
{
  monitor.BeginStage("Reading the domain");
  const Domain domain = MakeDomain(input, options.Domain, problems, monitor);
  if (problems.HasErrors() || domain.NumberOfSegments() == 0)
  {
    return {};
  }
  monitor.BeginStage("Preparing the spacing");
  const Spacing spacing =
    MakeSpacing(AboveRounding(options.Spacing, domain), domain.Bounds, problems, monitor);
  if (problems.HasErrors())
  {
    return {};
  }
  monitor.BeginStage("Biting");
  BitingResult bites = Bite(domain, spacing, MakeBitingOptions(options), problems, monitor);
  if (problems.HasErrors())
  {
    return {};
  }
  monitor.BeginStage("Triangulating");
  Triangulation triangulation = TriangulateBites(domain, { options.Phi }, bites, problems, monitor);
  if (problems.HasErrors())
  {
    return {};
  }
  monitor.BeginStage("Measuring quality");
  BitingMesh mesh = AssembleMesh(domain, std::move(bites), triangulation);
  Check(domain, mesh, triangulation.Constraints, problems);
  if (problems.HasErrors())
  {
    return {};
  }
  mesh.Quality = MeasureQuality({ mesh.Points, mesh.Spacing, mesh.Corners, mesh.Neighbors });
  mesh.GivenLipschitz = spacing.GivenLipschitz();
  mesh.UsedLipschitz = LipschitzConstant(mesh);
  return mesh;
}

} // namespace biting
