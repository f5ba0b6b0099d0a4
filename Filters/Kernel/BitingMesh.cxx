// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BitingMesh.h"

#include "Base/PartOfStage.h"
#include "Base/Pulse.h"
#include "Biting/BitingScheme.h"
#include "Biting/VertexEstimate.h"
#include "Calibration.h"
#include "Delaunay/ConstrainedEdges.h"
#include "Delaunay/Triangulation.h"
#include "Domain/DomainLocator.h"
#include "DomainFeatures.h"
#include "FineDrawing.h"
#include "MeshAssembly.h"
#include "MeshingStages.h"
#include "NarrowAngles.h"
#include "PreservedSpacing.h"
#include "Quality/MeshCheck.h"
#include "RaisedSpacing.h"
#include "RelaxedBites.h"
#include "SegmentCover.h"
#include "SharpCornerTriangles.h"

#include <algorithm> // for find, min, max
#include <cmath>     // for abs
#include <limits>    // for the largest id
#include <optional>  // for what is released early
#include <sstream>   // for figures in messages
#include <utility>   // for move, in_place

namespace biting
{

namespace
{

constexpr int MostTriangulations = 5; // each later one has fewer constraints in conflict
constexpr double CoverageTolerance =
  1e-6; // of a length: rounding of the sum, and of close vertices

// Where steps end, as shares of the time of a stage: of preparing the spacing, biting, a
// triangulation, and the last stage.
constexpr double LocatorEnd = 0.05;
constexpr double ChoiceEnd = 0.05;
constexpr double GivenSpacingEnd = 0.3;
constexpr double EstimateEnd = 0.02;
constexpr double VerticesOfTrials = 12000.0; // as many as cost the same, roughly
constexpr double FirstAttemptEnd = 0.9;
constexpr double TriangulationEnd = 0.95;
constexpr double CountingEnd = 0.01;
constexpr double AssemblyEnd = 0.2;
constexpr double CheckEnd = 0.4;
constexpr double MeshCheckEnd = 0.95; // of that
constexpr double QualityEnd = 0.93;
constexpr double SlopesEnd = 0.98;

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

// Whether the part was stopped, which is noted then where nothing was refused before.
bool AddAborted(const PartOfStage& part, ProblemList& problems)
{
  if (part.HasStopped() && !problems.HasErrors())
  {
    AddProblem(ProblemCode::Aborted, "", problems);
  }
  return part.HasStopped();
}

BitingOptions MakeBitingOptions(const BitingMeshOptions& options)
{
  BitingOptions biting;
  biting.BitingConstant = options.BitingConstant;
  biting.Shape = options.BiteShape;
  biting.Placement = options.Placement;
  biting.Order = options.Order;
  biting.MaximumNumberOfBites = options.MaximumNumberOfBites;
  biting.MaximumNumberOfVertices =
    std::min<std::int64_t>(options.MaximumNumberOfVertices, std::numeric_limits<Id>::max() / 8);
  biting.KeepFront = options.KeepBites;
  biting.PreserveBoundary = options.PreserveBoundary;
  return biting;
}

void AddTooManyVertices(double estimate, std::int64_t limit, ProblemList& problems)
{
  AddProblem(ProblemCode::TooManyVertices,
    "about " + Figure(estimate) + " vertices, the limit is " + std::to_string(limit), problems);
}

// What is known of the mesh beforehand.
struct Forecast
{
  double Density = 0.0; ///< integral of 1/f^2
  double Vertices = 0.0;
};

Forecast MakeForecast(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
  const BitingOptions& options, EstimateEffort effort, Monitor& monitor)
{
  PartOfStage integrating(monitor, 0.0, 0.5);
  const double density = IntegrateDensity(domain, locator, spacing, integrating, effort);
  PartOfStage dividing(monitor, 0.5, 1.0);
  const double divisionPoints =
    options.PreserveBoundary ? 0.0 : EstimateDivisionPoints(domain, spacing, 1.0, dividing, effort);
  return { density,
    EstimateNumberOfVertices(density, options) + domain.NumberOfVertices() + divisionPoints };
}

double EndOfTrials(const BitingOptions& options, const Forecast& forecast)
{
  const bool hasTrials = options.BitingConstant == 0.0 && options.Placement == Placement::Corners;
  const double trials = hasTrials ? VerticesOfTrials : 0.0;
  return EstimateEnd + (1.0 - EstimateEnd) * trials / (trials + forecast.Vertices);
}

void Release(Bites& bites, Monitor& monitor)
{
  Pulse pulse(monitor);
  pulse.SetFraction(1.0);
  ReleaseInSteps(pulse, bites.Centers, bites.Axes, bites.HalfWidths, bites.Orders, bites.Phases);
}

BitingResult Bite(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
  BitingOptions options, ProblemList& problems, Monitor& monitor)
{
  PartOfStage estimating(monitor, 0.0, EstimateEnd);
  const Forecast forecast =
    MakeForecast(domain, locator, spacing, options, EstimateEffort::Full, estimating);
  const double most = static_cast<double>(options.MaximumNumberOfVertices);
  if (AddAborted(estimating, problems))
  {
    return {};
  }
  if (!(forecast.Vertices <= most))
  {
    AddTooManyVertices(forecast.Vertices, options.MaximumNumberOfVertices, problems);
    return {};
  }
  const double trialsEnd = EndOfTrials(options, forecast);
  PartOfStage trying(monitor, EstimateEnd, trialsEnd);
  if (options.BitingConstant == 0.0)
  {
    options.BitingConstant =
      CalibrateBitingConstant(domain, locator, spacing, forecast.Density, options, trying);
    options.PartLength = 1.0;
    options.FollowSlope = true;
  }
  if (AddAborted(trying, problems))
  {
    return {};
  }
  PartOfStage rest(monitor, trialsEnd, 1.0);
  BitingResult bites = BiteDomain(domain, locator, spacing, forecast.Vertices, options, rest);
  if (bites.End == BitingEnd::TooManyVertices)
  {
    // The estimate did not see all of f: more than the limit is what is known.
    AddTooManyVertices(
      std::max(forecast.Vertices, most), options.MaximumNumberOfVertices, problems);
  }
  if (!options.KeepFront)
  {
    Release(bites.Bites, rest);
  }
  AddAborted(rest, problems);
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

SpacingOptions ChooseSpacing(const BitingMeshOptions& options, const Domain& domain,
  const DomainLocator& locator, ProblemList& problems, Monitor& monitor)
{
  SpacingOptions spacing = RaiseToRounding(options.Spacing, domain, problems);
  if (options.PreserveBoundary)
  {
    return FollowSegments(spacing, domain, monitor);
  }
  const double mostVertices = static_cast<double>(options.MaximumNumberOfVertices);
  spacing.Features = options.LimitByFeatureSize ? FeaturesOf(domain, mostVertices) : nullptr;
  spacing.IsUnused = OutsideOf(locator);
  return spacing;
}

Spacing PrepareSpacing(const BitingMeshOptions& options, const Domain& domain,
  const DomainLocator& locator, ProblemList& problems, Monitor& monitor)
{
  PartOfStage choosing(monitor, 0.0, ChoiceEnd);
  SpacingOptions wanted = ChooseSpacing(options, domain, locator, problems, choosing);
  if (AddAborted(choosing, problems))
  {
    return {};
  }
  PartOfStage making(monitor, ChoiceEnd, 1.0);
  return MakeSpacing(wanted, domain.Bounds, problems, making);
}

// f before any limit by feature size. Many of the drawing's vertices will go: they are no reason to
// refuse.
Spacing PrepareGivenSpacing(
  const BitingMeshOptions& options, const Domain& drawing, ProblemList& problems, Monitor& monitor)
{
  const SpacingOptions& spacing = options.Spacing;
  if (!spacing.Grid && !spacing.Triangulation && !spacing.Segments)
  {
    return MakeSpacing(
      RaiseToRounding(spacing, drawing, problems), drawing.Bounds, problems, monitor);
  }
  BitingMeshOptions given = options;
  given.LimitByFeatureSize = false;
  given.PreserveBoundary = false;
  given.MaximumNumberOfVertices += drawing.NumberOfVertices();
  PartOfStage locating(monitor, 0.0, LocatorEnd);
  Pulse pulse(locating);
  const DomainLocator locator(drawing, pulse);
  PartOfStage preparing(monitor, LocatorEnd, 1.0);
  return locating.HasStopped() ? Spacing()
                               : PrepareSpacing(given, drawing, locator, problems, preparing);
}

// The drawing as it is meshed.
SimplifiedDomain SimplifyDrawing(
  Domain drawing, const BitingMeshOptions& options, ProblemList& problems, Monitor& monitor)
{
  SimplificationOptions wanted = options.Simplification;
  wanted.Tolerance = options.PreserveBoundary ? 0.0 : wanted.Tolerance;
  if (!wanted.IsAsked())
  {
    SimplifiedDomain whole;
    whole.Drawing = std::move(drawing);
    return whole;
  }
  PartOfStage preparing(monitor, 0.0, GivenSpacingEnd);
  const Spacing given = PrepareGivenSpacing(options, drawing, problems, preparing);
  if (AddAborted(preparing, problems) || problems.HasErrors())
  {
    return {};
  }
  PartOfStage simplifying(monitor, GivenSpacingEnd, 1.0);
  return Simplify(
    drawing, wanted, [&given](const Point2& x) { return given(x); }, problems, simplifying);
}

using Flags = std::vector<std::uint8_t>;

std::vector<double> LengthsOfConstraints(const BitingResult& bites, Pulse& pulse)
{
  std::vector<double> lengths(bites.EdgeStarts.size());
  pulse.ForEach(lengths.size(),
    [&bites, &lengths](std::size_t edge)
    {
      lengths[edge] =
        Distance(bites.Points[bites.EdgeStarts[edge]], bites.Points[bites.EdgeEnds[edge]]);
    });
  return lengths;
}

// The constraints that are not a union of mesh edges: as long as these are together.
std::vector<Id> FindUncovered(
  const BitingResult& bites, const Triangulation& triangulation, Pulse& pulse)
{
  const std::vector<double> lengths = LengthsOfConstraints(bites, pulse);
  std::vector<double> rest = lengths;
  ForEachConstrainedEdge(triangulation, pulse,
    [&bites, &rest](Id constraint, Id start, Id end)
    { rest[constraint] -= Distance(bites.Points[start], bites.Points[end]); });
  std::vector<Id> uncovered;
  pulse.ForEach(rest.size(),
    [&lengths, &rest, &uncovered](std::size_t edge)
    {
      if (!(std::abs(rest[edge]) <= CoverageTolerance * lengths[edge]))
      {
        uncovered.push_back(static_cast<Id>(edge));
      }
    });
  return uncovered;
}

// 1 for the segments whose parts cross or coincide with those of others, and for those that share an
// end with one that the parts of others cut off from the mesh.
Flags SegmentsInConflict(const Domain& domain, const TriangulationResult& result,
  const std::vector<Id>& uncovered, const BitingResult& bites, Pulse& pulse)
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
  pulse.ForEach(isInConflict.size(),
    [&domain, &isInConflict, &isAtConflict](std::size_t segment)
    {
      isInConflict[segment] |=
        isAtConflict[domain.Starts[segment]] | isAtConflict[domain.Ends[segment]];
    });
  return isInConflict;
}

// Removes vertices at which no constraint ends.
void RemoveVertices(const Flags& isRemoved, BitingResult& bites, Pulse& pulse)
{
  std::vector<Id> numbers(isRemoved.size(), NoId);
  std::size_t next = 0;
  pulse.ForEach(isRemoved.size(),
    [&isRemoved, &bites, &numbers, &next](std::size_t vertex)
    {
      if (!isRemoved[vertex])
      {
        numbers[vertex] = static_cast<Id>(next);
        bites.Points[next] = bites.Points[vertex];
        bites.Spacings[next] = bites.Spacings[vertex];
        bites.BiteOrders[next] = bites.BiteOrders[vertex];
        bites.Segments[next++] = bites.Segments[vertex];
      }
    });
  bites.Points.resize(next);
  bites.Spacings.resize(next);
  bites.BiteOrders.resize(next);
  bites.Segments.resize(next);
  for (std::vector<Id>* ends : { &bites.EdgeStarts, &bites.EdgeEnds })
  {
    pulse.ForEach(
      ends->size(), [&numbers, ends](std::size_t edge) { (*ends)[edge] = numbers[(*ends)[edge]]; });
  }
}

// Takes the new vertices off segments, and these back to one edge each: the segments themselves do
// not cross.
void UndoDivisions(const Domain& domain, const Flags& isUndone, BitingResult& bites, Pulse& pulse)
{
  std::size_t next = 0;
  Id last = NoId;
  pulse.ForEach(bites.EdgeSegments.size(),
    [&domain, &isUndone, &bites, &next, &last](std::size_t edge)
    {
      const Id segment = bites.EdgeSegments[edge];
      const bool isWhole = isUndone[segment] != 0;
      if (!isWhole || segment != last)
      {
        bites.EdgeStarts[next] = isWhole ? domain.Starts[segment] : bites.EdgeStarts[edge];
        bites.EdgeEnds[next] = isWhole ? domain.Ends[segment] : bites.EdgeEnds[edge];
        bites.EdgeSegments[next++] = segment;
      }
      last = segment;
    });
  bites.EdgeStarts.resize(next);
  bites.EdgeEnds.resize(next);
  bites.EdgeSegments.resize(next);
  Flags isRemoved(bites.Segments.size(), 0);
  pulse.ForEach(isRemoved.size(),
    [&bites, &isUndone, &isRemoved](std::size_t vertex)
    {
      const Id segment = bites.Segments[vertex];
      isRemoved[vertex] = segment != NoId && isUndone[segment];
    });
  RemoveVertices(isRemoved, bites, pulse);
}

// 1 for the vertices that the triangulation found on constraints, though none begins or ends there:
// by rounding, beside segments as short as that.
Flags VerticesOnConstraints(
  const Domain& domain, const BitingResult& bites, const Triangulation& triangulation, Pulse& pulse)
{
  Flags isOn(bites.Points.size(), 0);
  ForEachConstrainedEdge(triangulation, pulse,
    [&domain, &bites, &isOn](Id, Id start, Id end)
    {
      for (const Id vertex : { start, end })
      {
        isOn[vertex] |= vertex >= domain.NumberOfVertices() && bites.Segments[vertex] == NoId;
      }
    });
  return isOn;
}

// Leaves one edge for each segment. Whether vertices had to be removed.
bool ClearConstraints(
  const Domain& domain, const Triangulation& triangulation, BitingResult& bites, Pulse& pulse)
{
  const Flags isOn = VerticesOnConstraints(domain, bites, triangulation, pulse);
  const bool hasSome = std::find(isOn.begin(), isOn.end(), 1) != isOn.end();
  if (hasSome)
  {
    RemoveVertices(isOn, bites, pulse);
  }
  return hasSome;
}

// Inner vertices that rounding put on a constraint divide it: they are on its segment.
void AdoptVertices(
  const Domain& domain, const Triangulation& triangulation, BitingResult& bites, Pulse& pulse)
{
  ForEachConstrainedEdge(triangulation, pulse,
    [&domain, &bites](Id constraint, Id start, Id end)
    {
      for (const Id vertex : { start, end })
      {
        if (vertex >= domain.NumberOfVertices() && bites.Segments[vertex] == NoId)
        {
          bites.Segments[vertex] = bites.EdgeSegments[constraint];
        }
      }
    });
}

// The first attempt is nearly always the only one.
PartOfStage PartOfAttempt(int attempt, Monitor& monitor)
{
  const auto begin = [](int count)
  { return count == 1 ? 0.0 : 1.0 - (1.0 - FirstAttemptEnd) / (count - 1); };
  return { monitor, begin(attempt), begin(attempt + 1) };
}

// Where rounded points of two close segments make their parts cross or coincide, or cut one off from
// the mesh, their division is taken back; before the last attempt that of all segments. Where these
// are to be preserved, inner vertices that rounding put on them are removed.
Triangulation TriangulateBites(const Domain& domain, const BitingMeshOptions& options,
  BitingResult& bites, ProblemList& problems, Monitor& monitor)
{
  for (int attempt = 1; attempt <= MostTriangulations; ++attempt)
  {
    PartOfStage part = PartOfAttempt(attempt, monitor);
    PartOfStage triangulating(part, 0.0, TriangulationEnd);
    TriangulationResult result =
      Triangulate(bites.Points, MakeConstraints(domain, bites), { options.Phi }, triangulating);
    PartOfStage looking(part, TriangulationEnd, 1.0);
    Pulse pulse(looking);
    const std::vector<Id> uncovered =
      result.Conflicts.empty() ? FindUncovered(bites, result.Mesh, pulse) : std::vector<Id>();
    const bool isSound =
      result.Conflicts.empty() && result.Coincidences.empty() && uncovered.empty();
    const bool isCleared =
      isSound && options.PreserveBoundary && ClearConstraints(domain, result.Mesh, bites, pulse);
    if (isSound && !isCleared)
    {
      AdoptVertices(domain, result.Mesh, bites, pulse);
    }
    if (AddAborted(part, problems))
    {
      return {};
    }
    if (isCleared)
    {
      continue;
    }
    if (isSound)
    {
      return std::move(result.Mesh);
    }
    const bool isLastChance = attempt == MostTriangulations - 1;
    UndoDivisions(domain,
      isLastChance ? Flags(domain.NumberOfSegments(), 1)
                   : SegmentsInConflict(domain, result, uncovered, bites, pulse),
      bites, pulse);
    if (AddAborted(part, problems))
    {
      return {};
    }
  }
  AddProblem(ProblemCode::CheckFailed, "a part of a segment is not in the mesh", problems);
  return {};
}

// Not where biting was stopped: then the front is to be seen as it is.
void RelaxMesh(const Domain& domain, const Spacing& spacing, const BitingMeshOptions& options,
  BitingResult& bites, Triangulation& triangulation, ProblemList& problems, Monitor& monitor)
{
  if (!options.Relaxation || options.MaximumNumberOfBites >= 0)
  {
    return;
  }
  PartOfStage part(monitor, 0.0, 1.0);
  const std::string violation = RelaxBites(domain, spacing,
    { options.RelaxationEffort, !options.PreserveBoundary }, bites, triangulation, part);
  if (!AddAborted(part, problems) && !violation.empty())
  {
    AddProblem(ProblemCode::CheckFailed, violation, problems);
  }
}

void Check(const Domain& domain, const BitingMesh& mesh, const std::vector<Id>& constraints,
  const std::vector<Id>& segments, ProblemList& problems, Monitor& monitor)
{
  PartOfStage part(monitor, AssemblyEnd, CheckEnd);
  PartOfStage checking(part, 0.0, MeshCheckEnd);
  std::string violation =
    CheckMesh({ mesh.Points, mesh.Corners, mesh.Neighbors, constraints, domain.Area }, checking);
  if (violation.empty() && !checking.HasStopped())
  {
    PartOfStage covering(part, MeshCheckEnd, 1.0);
    violation = CheckSegmentCover(
      domain, { mesh.Points, mesh.Corners, mesh.Neighbors, constraints, segments }, covering);
  }
  if (!AddAborted(part, problems) && !violation.empty())
  {
    AddProblem(ProblemCode::CheckFailed, violation, problems);
  }
}

// The mesh as it is handed out, but for its quality.
BitingMesh Assemble(const Domain& domain, BitingResult bites, Triangulation& triangulation,
  ProblemList& problems, Monitor& monitor)
{
  PartOfStage part(monitor, CountingEnd, AssemblyEnd);
  const std::vector<Id> segments = bites.EdgeSegments;
  BitingMesh mesh = AssembleMesh(domain, std::move(bites), triangulation, part);
  if (!AddAborted(part, problems))
  {
    Check(domain, mesh, triangulation.Constraints, segments, problems, monitor);
  }
  return mesh;
}

void Measure(BitingMesh& mesh, ProblemList& problems, Monitor& monitor)
{
  const MeshView view{ mesh.Points, mesh.Spacing, mesh.Corners, mesh.Neighbors };
  PartOfStage measuring(monitor, CheckEnd, QualityEnd);
  mesh.Quality = MeasureQuality(view, measuring);
  if (!AddAborted(measuring, problems))
  {
    PartOfStage comparing(monitor, QualityEnd, SlopesEnd);
    mesh.UsedLipschitz = LargestSlope(view, comparing);
    AddAborted(comparing, problems);
  }
}

// Says so where it is large and no tolerance is set.
void TellFineDrawing(const Domain& drawing, const BitingMeshOptions& options, BitingMesh& mesh,
  ProblemList& problems, Monitor& monitor)
{
  if (options.PreserveBoundary)
  {
    return;
  }
  PartOfStage part(monitor, SlopesEnd, 1.0);
  mesh.ShareOfDrawing =
    ShareOfFineDrawing(drawing, mesh, RaiseToRounding(options.Spacing, drawing, problems), part);
  const bool isAccepted = options.Simplification.Tolerance > 0.0;
  if (!AddAborted(part, problems) && !isAccepted && mesh.ShareOfDrawing > LargeShareOfDrawing)
  {
    AddProblem(ProblemCode::FineDrawing, Figure(100.0 * mesh.ShareOfDrawing) + " % of the vertices",
      problems);
  }
}

// Before anything is made for them. All are vertices of the mesh.
bool HasTooManyVertices(
  const Domain& domain, const BitingMeshOptions& options, ProblemList& problems)
{
  const bool hasTooMany = domain.NumberOfVertices() > options.MaximumNumberOfVertices;
  if (hasTooMany)
  {
    AddProblem(ProblemCode::TooManyVertices,
      "the input alone has " + std::to_string(domain.NumberOfVertices()) +
        " vertices, the limit is " + std::to_string(options.MaximumNumberOfVertices),
      problems);
  }
  return hasTooMany;
}

// Whether nothing is left to do: there is a refusal, or the monitor wants to stop.
bool IsOver(const PartOfStage& whole, ProblemList& problems)
{
  AddAborted(whole, problems);
  return problems.HasErrors();
}

} // namespace

BitingMesh MakeBitingMesh(
  const Polylines& input, const BitingMeshOptions& options, ProblemList& problems, Monitor& monitor)
{
  PartOfStage whole(monitor, 0.0, 1.0);
  monitor.BeginStage(MeshingStages::Domain.Text);
  Domain drawing = MakeDomain(input, options.Domain, problems, whole);
  if (IsOver(whole, problems) || drawing.NumberOfSegments() == 0)
  {
    return {};
  }
  monitor.BeginStage(MeshingStages::Simplification.Text);
  const SimplifiedDomain simplified = SimplifyDrawing(std::move(drawing), options, problems, whole);
  const Domain& domain = simplified.Drawing;
  if (IsOver(whole, problems) || HasTooManyVertices(domain, options, problems))
  {
    return {};
  }
  monitor.BeginStage(MeshingStages::Spacing.Text);
  PartOfStage locating(whole, 0.0, LocatorEnd);
  Pulse pulse(locating);
  ReportNarrowAngles(domain, problems, pulse);
  std::optional<const DomainLocator> locator(std::in_place, domain, pulse);
  if (IsOver(whole, problems))
  {
    return {};
  }
  PartOfStage preparing(whole, LocatorEnd, 1.0);
  const Spacing spacing = PrepareSpacing(options, domain, *locator, problems, preparing);
  if (IsOver(whole, problems))
  {
    return {};
  }
  monitor.BeginStage(MeshingStages::Biting.Text);
  BitingResult bites = Bite(domain, *locator, spacing, MakeBitingOptions(options), problems, whole);
  locator.reset();
  if (IsOver(whole, problems))
  {
    return {};
  }
  monitor.BeginStage(MeshingStages::Triangulation.Text);
  Triangulation triangulation = TriangulateBites(domain, options, bites, problems, whole);
  if (IsOver(whole, problems))
  {
    return {};
  }
  monitor.BeginStage(MeshingStages::Relaxation.Text);
  RelaxMesh(domain, spacing, options, bites, triangulation, problems, whole);
  if (IsOver(whole, problems))
  {
    return {};
  }
  monitor.BeginStage(MeshingStages::Quality.Text);
  PartOfStage counting(whole, 0.0, CountingEnd);
  const Id sharp = CountSharpCornerTriangles(domain, bites, triangulation, counting);
  BitingMesh mesh = Assemble(domain, std::move(bites), triangulation, problems, whole);
  if (IsOver(whole, problems))
  {
    return {};
  }
  mesh.NumberOfSharpCornerTriangles = sharp;
  mesh.GivenLipschitz = spacing.GivenLipschitz();
  mesh.RemovedVertices = simplified.RemovedVertices;
  mesh.LeftOutLoops = simplified.LeftOutLoops;
  mesh.LeftOutArea = simplified.LeftOutArea;
  Measure(mesh, problems, whole);
  TellFineDrawing(domain, options, mesh, problems, whole);
  return IsOver(whole, problems) ? BitingMesh() : std::move(mesh);
}

} // namespace biting
