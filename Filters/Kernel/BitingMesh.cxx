// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BitingMesh.h"

#include "Base/FreedMemory.h"
#include "Base/PartOfStage.h"
#include "Base/Pulse.h"
#include "Base/StagesOnce.h"
#include "Biting/BitingScheme.h"
#include "Blocks/BlockMesher.h"
#include "Delaunay/Triangulation.h"
#include "Domain/DomainLocator.h"
#include "Pieces/FinishedMesh.h"
#include "Stages/Calibration.h"
#include "Stages/DomainFeatures.h"
#include "Stages/Forecast.h"
#include "Stages/MeshingStages.h"
#include "Stages/NarrowAngles.h"
#include "Stages/NearMisses.h"
#include "Stages/PreparedSpacing.h"
#include "Stages/RelaxedBites.h"
#include "Stages/SoundTriangulation.h"
#include "Stages/StageProblems.h"

#include <algorithm>  // for min, max
#include <functional> // for the spacing
#include <memory>     // for what is made once
#include <optional>   // for what is released early
#include <utility>    // for move, in_place

namespace biting
{

namespace
{

// Where steps end, as shares of the time of their stage.
constexpr double LocatorEnd = 0.05;
constexpr double SpacingEnd = 0.95;
constexpr double GivenSpacingEnd = 0.3;
constexpr double EstimateEnd = 0.02;

BitingOptions MakeBitingOptions(const BitingMeshOptions& options, const Crew& members)
{
  BitingOptions biting;
  biting.BitingConstant = options.BitingConstant;
  biting.Shape = options.BiteShape;
  biting.Placement = options.Placement;
  biting.Order = options.Order;
  biting.MaximumNumberOfBites = options.MaximumNumberOfBites;
  biting.MaximumNumberOfVertices = std::min(
    options.MaximumNumberOfVertices, MostVerticesOf(members, options.MostVerticesOfProcess));
  biting.KeepFront = options.KeepBites;
  biting.Phi = options.Phi;
  biting.PreserveBoundary = options.PreserveBoundary;
  return biting;
}

void Release(Bites& bites, Monitor& monitor)
{
  Pulse pulse(monitor);
  pulse.SetFraction(1.0);
  ReleaseInSteps(pulse, bites.Centers, bites.Axes, bites.HalfWidths, bites.Orders, bites.Phases);
}

// 0: the mesh is to be of one block.
double VerticesPerBlock(const BitingMeshOptions& options)
{
  const bool mayCut = IsRelaxed(options) && options.Order != FrontOrder::LargestY &&
    !options.KeepBites && !options.PreserveBoundary;
  return mayCut ? static_cast<double>(options.VerticesPerBlock) : 0.0;
}

BitingResult Bite(const Domain& domain, const DomainLocator& locator, const Spacing& spacing,
  BitingOptions options, double verticesPerBlock, BlockMesher& blocks, ProblemList& problems,
  Monitor& monitor)
{
  PartOfStage estimating(monitor, 0.0, EstimateEnd);
  const Forecast forecast =
    MakeForecast(domain, locator, spacing, options, EstimateEffort::Full, estimating);
  if (AddAborted(estimating, problems) ||
    RefuseMoreThan(options.MaximumNumberOfVertices, forecast.Vertices, problems))
  {
    return {};
  }
  const double trialsEnd =
    EstimateEnd + (1.0 - EstimateEnd) * ShareOfTrials(options, forecast.Vertices);
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
  if (blocks.Bite(locator, forecast.Vertices, verticesPerBlock, options, problems, rest) ||
    blocks.IsHelping())
  {
    return {};
  }
  const std::int64_t most =
    std::min(options.MaximumNumberOfVertices, std::int64_t{ MostVerticesInIds });
  options.MaximumNumberOfVertices = most;
  BitingResult bites = BiteDomain(domain, locator, spacing, forecast.Vertices, options, rest);
  if (bites.End == BitingEnd::TooManyVertices)
  {
    // The estimate did not see all of f: more than the limit is what is known.
    AddTooManyVertices(std::max(forecast.Vertices, static_cast<double>(most)), most, problems);
  }
  if (!options.KeepFront)
  {
    Release(bites.Bites, rest);
  }
  AddAborted(rest, problems);
  return bites;
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

void RelaxMesh(const Domain& domain, const Spacing& spacing, const BitingMeshOptions& options,
  BitingResult& bites, Triangulation& triangulation, ProblemList& problems, Monitor& monitor)
{
  if (!IsRelaxed(options))
  {
    return;
  }
  PartOfStage part(monitor, 0.0, 1.0);
  const std::string violation =
    RelaxBites(domain, spacing, { !options.PreserveBoundary }, bites, triangulation, part);
  if (!AddAborted(part, problems) && !violation.empty())
  {
    AddProblem(ProblemCode::CheckFailed, violation, problems);
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

// The spacing before gradation and any limit by feature size, made where it is first asked for.
// What is wrong with it is said later.
std::function<double(const Point2&)> SpacingAsGiven(
  const Polylines& input, const BitingMeshOptions& options, Monitor& monitor)
{
  auto made = std::make_shared<std::optional<Spacing>>();
  return [&input, &options, &monitor, made](const Point2& x)
  {
    if (!*made)
    {
      Box2 bounds;
      for (const Id point : input.Connectivity)
      {
        bounds.Add(input.Points[static_cast<std::size_t>(point)]);
      }
      SpacingOptions given = options.Spacing;
      given.Gradation = 0.0;
      ProblemList unheard;
      PartOfStage standing(monitor, 0.0, 0.0);
      made->emplace(MakeSpacing(given, bounds, unheard, standing));
    }
    return (**made)(x);
  };
}

// The domain as it is meshed; without segments where there is none.
SimplifiedDomain PrepareDomain(const Polylines& input, const BitingMeshOptions& options,
  ProblemList& problems, PartOfStage& whole)
{
  whole.BeginStage(MeshingStages::Domain.Text);
  DomainOptions wanted = options.Domain;
  wanted.GivenSpacing = SpacingAsGiven(input, options, whole);
  Domain drawing = MakeDomain(input, wanted, problems, whole);
  if (IsOver(whole, problems) || drawing.NumberOfSegments() == 0)
  {
    return {};
  }
  whole.BeginStage(MeshingStages::Simplification.Text);
  return SimplifyDrawing(std::move(drawing), options, problems, whole);
}

// From biting on. The locator is released on the way.
BitingMesh MeshPrepared(const MeshingInput& input, double verticesPerBlock,
  std::optional<const DomainLocator>& locator, bool& isOfBlocks, ProblemList& problems,
  PartOfStage& whole)
{
  const Domain& domain = input.Simplified.Drawing;
  const BitingMeshOptions& options = input.Options;
  whole.BeginStage(MeshingStages::Biting.Text);
  Crew& members = verticesPerBlock > 0.0 ? input.Members : NoCrew();
  BlockMesher blocks(domain, input.F, members, options.GhostLevels, options.MostVerticesOfProcess);
  BitingResult bites = Bite(domain, *locator, input.F, MakeBitingOptions(options, members),
    verticesPerBlock, blocks, problems, whole);
  locator.reset();
  isOfBlocks = blocks.IsInUse();
  if (IsOver(whole, problems) || (blocks.IsHelping() && !isOfBlocks))
  {
    return {};
  }
  whole.BeginStage(MeshingStages::Triangulation.Text);
  Triangulation triangulation = isOfBlocks
    ? blocks.Triangulate(problems, whole)
    : TriangulateBites(domain, { options.Phi, options.PreserveBoundary }, bites, problems, whole);
  if (IsOver(whole, problems))
  {
    return {};
  }
  whole.BeginStage(MeshingStages::Relaxation.Text);
  isOfBlocks ? blocks.Relax(bites, triangulation, problems, whole)
             : RelaxMesh(domain, input.F, options, bites, triangulation, problems, whole);
  if (IsOver(whole, problems))
  {
    return {};
  }
  if (blocks.IsHelping())
  {
    return TakeOwnPiece(input, blocks, problems, whole);
  }
  whole.BeginStage(MeshingStages::Quality.Text);
  return FinishMesh(input, blocks, std::move(bites), triangulation, problems, whole);
}

// What fails in blocks, for which rounding of their cuts would be the reason, is made as a whole.
BitingMesh MeshBlocksOrWhole(const MeshingInput& input, std::optional<const DomainLocator>& locator,
  ProblemList& problems, PartOfStage& whole)
{
  const ProblemList before = problems;
  bool isOfBlocks = false;
  BitingMesh mesh =
    MeshPrepared(input, VerticesPerBlock(input.Options), locator, isOfBlocks, problems, whole);
  if (!isOfBlocks || input.Members.Own() != 0 || !problems.Has(ProblemCode::CheckFailed))
  {
    return mesh;
  }
  const std::string violation = FirstDetail(ProblemCode::CheckFailed, problems);
  problems = before;
  Pulse pulse(whole);
  locator.emplace(input.Simplified.Drawing, pulse);
  mesh = MeshPrepared(input, 0.0, locator, isOfBlocks, problems, whole);
  mesh.BlocksViolation = violation;
  return mesh;
}

} // namespace

BitingMesh MakeBitingMesh(const Polylines& input, const BitingMeshOptions& options,
  ProblemList& problems, Monitor& monitor, Crew& crew)
{
  KeepFreedMemory();
  StagesOnce stages(monitor);
  PartOfStage whole(stages, 0.0, 1.0);
  const SimplifiedDomain simplified = PrepareDomain(input, options, problems, whole);
  const Domain& domain = simplified.Drawing;
  if (IsOver(whole, problems) || domain.NumberOfSegments() == 0 ||
    HasTooManyVertices(domain, options, problems))
  {
    return {};
  }
  whole.BeginStage(MeshingStages::Spacing.Text);
  PartOfStage locating(whole, 0.0, LocatorEnd);
  Pulse pulse(locating);
  ReportNarrowAngles(domain, problems, pulse);
  std::optional<const DomainLocator> locator(std::in_place, domain, pulse);
  if (IsOver(whole, problems))
  {
    return {};
  }
  PartOfStage preparing(whole, LocatorEnd, SpacingEnd);
  const double mostVertices = static_cast<double>(options.MaximumNumberOfVertices);
  const Spacing spacing = PrepareSpacing(options, domain,
    options.LimitByFeatureSize ? FeaturesOf(simplified, mostVertices) : nullptr, problems,
    preparing);
  if (!IsOver(whole, problems))
  {
    PartOfStage looking(whole, SpacingEnd, 1.0);
    Pulse looks(looking);
    ReportNearMisses(domain, spacing, input, problems, looks);
  }
  return IsOver(whole, problems)
    ? BitingMesh()
    : MeshBlocksOrWhole({ simplified, spacing, options, crew }, locator, problems, whole);
}

} // namespace biting
