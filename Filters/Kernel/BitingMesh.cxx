// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BitingMesh.h"

#include "Base/FreedMemory.h"
#include "Base/Monitor.h"
#include "Base/Pulse.h"
#include "Biting/BitingScheme.h"
#include "Blocks/BlockMesher.h"
#include "Delaunay/Triangulation.h"
#include "Domain/DomainLocator.h"
#include "Pieces/FinishedMesh.h"
#include "Stages/Calibration.h"
#include "Stages/GivenTriangles.h"
#include "Stages/MeshAssembly.h"
#include "Stages/MeshSettings.h"
#include "Stages/MeshedBites.h"
#include "Stages/MeshingStages.h"
#include "Stages/NearMisses.h"
#include "Stages/PeriodicDivision.h"
#include "Stages/PreparedInput.h"
#include "Stages/SharpSectors.h"
#include "Stages/StageProblems.h"

#include <algorithm> // for min, max
#include <memory>    // for the first spacing
#include <optional>  // for what is released early
#include <utility>   // for move

namespace biting
{

namespace
{

// Where steps end, as shares of the time of their stage.
constexpr double LocatorEnd = 0.05;
constexpr double SpacingEnd = 0.95;
constexpr double EstimateEnd = 0.02;

constexpr double FloorFactor = 1.4; // that FeatureSource::Floor has

void Release(Bites& bites, Monitor& monitor)
{
  Pulse pulse(monitor);
  pulse.SetFraction(1.0);
  ReleaseInSteps(pulse, bites.Centers, bites.Axes, bites.HalfWidths, bites.Orders, bites.Phases);
}

/// The stages, in the order of the paper. None begins once nothing is left to do.
class MeshMaker
{
public:
  MeshMaker(const Polylines& input, const BitingMeshOptions& options, ProblemList& problems,
    PartOfStage& whole, Crew& members)
    : Input(input)
    , Options(options)
    , Settings(options, members)
    , Problems(problems)
    , Whole(whole)
    , Members(members)
  {
  }

  BitingMesh Make();

private:
  void Do(const Stage& stage, void (MeshMaker::*step)());
  void MeshDomain();
  void ReadDomain();
  void Simplify();
  void FindSpacing();
  void DivideSidesAlike();
  void Bite();
  void BiteWhole(double expectedVertices, PartOfStage& part);
  void Triangulate();
  void Relax();
  void Finish();

  /// All of the domain is triangles that stay.
  bool IsAllGiven() const { return this->Simplified.Drawing.NumberOfSegments() == 0; }

  bool HasFailedInBlocks() const
  {
    return this->Blocks && this->Blocks->IsInUse() && !this->Blocks->IsHelping() &&
      this->Problems.Has(ProblemCode::CheckFailed);
  }

  const Polylines& Input;
  const BitingMeshOptions& Options;
  MeshSettings Settings;
  ProblemList& Problems;
  PartOfStage& Whole;
  Crew& Members;
  bool IsDone = false; ///< there is nothing to mesh, or nothing for this member
  SimplifiedDomain Simplified;
  GivenTriangles Given; ///< taken out of the domain
  PeriodicSides Sides;
  Spacing F;
  std::optional<const DomainLocator> Locator; ///< until the domain is bitten
  std::optional<BlockMesher> Blocks;
  BitingResult Bites;
  Triangulation Triangles;
  BitingMesh Mesh;
};

// A mesh of blocks that does not pass the check, as by rounding along cuts, is made again in one
// block.
BitingMesh MeshMaker::Make()
{
  this->Do(MeshingStages::Domain, &MeshMaker::ReadDomain);
  this->Do(MeshingStages::Simplification, &MeshMaker::Simplify);
  this->Do(MeshingStages::Spacing, &MeshMaker::FindSpacing);
  const ProblemList before = this->Problems;
  this->MeshDomain();
  if (this->HasFailedInBlocks())
  {
    const std::string violation = FirstDetail(ProblemCode::CheckFailed, this->Problems);
    BitingMeshOptions inOneBlock = this->Options;
    inOneBlock.VerticesPerBlock = 0;
    this->Settings = MeshSettings(inOneBlock, this->Members);
    this->Problems = before;
    this->MeshDomain();
    this->Mesh.BlocksViolation = violation;
  }
  return std::move(this->Mesh);
}

void MeshMaker::Do(const Stage& stage, void (MeshMaker::*step)())
{
  if (!IsOver(this->Whole, this->Problems) && !this->IsDone)
  {
    this->Whole.BeginStage(stage.Text);
    (this->*step)();
  }
}

void MeshMaker::MeshDomain()
{
  this->Do(MeshingStages::Biting, &MeshMaker::Bite);
  this->Do(MeshingStages::Triangulation, &MeshMaker::Triangulate);
  this->Do(MeshingStages::Relaxation, &MeshMaker::Relax);
  this->Do(MeshingStages::Quality, &MeshMaker::Finish);
}

void MeshMaker::ReadDomain()
{
  this->Simplified.Drawing = ReadDrawing(this->Input, this->Options, this->Problems, this->Whole);
  this->IsDone = this->Simplified.Drawing.NumberOfSegments() == 0;
}

void MeshMaker::Simplify()
{
  this->Simplified = SimplifyDrawing(
    std::move(this->Simplified.Drawing), this->Options, this->Problems, this->Whole);
  const bool mayKeep =
    this->Options.Domain.KeepCellEdges && this->Options.PeriodicTranslations.empty();
  if (mayKeep && !IsOver(this->Whole, this->Problems))
  {
    PartOfStage taking(this->Whole, 1.0, 1.0);
    this->Given = TakeGivenTriangles(this->Input, this->Simplified.Drawing, taking);
  }
  this->IsDone = this->IsAllGiven() && this->Given.IsEmpty();
}

void MeshMaker::FindSpacing()
{
  if (this->IsAllGiven())
  {
    this->F = PrepareGivenSpacing(this->Options, this->Given.Whole, this->Problems, this->Whole);
    return;
  }
  Domain& domain = this->Simplified.Drawing;
  PartOfStage locating(this->Whole, 0.0, LocatorEnd);
  this->Sides = FindPeriodicSides(domain, this->Input, this->Options, this->Problems, locating);
  Pulse pulse(locating);
  ReportNarrowAngles(domain, this->Problems, pulse);
  this->Locator.emplace(domain, pulse);
  if (IsOver(this->Whole, this->Problems))
  {
    return;
  }
  PartOfStage preparing(this->Whole, LocatorEnd, SpacingEnd);
  BitingMeshOptions options = this->Options;
  if (!this->Given.IsEmpty() && !options.PreserveBoundary)
  {
    options.Spacing = FollowPreserved(std::move(options.Spacing), domain, preparing);
  }
  this->F = PrepareSpacing(options, this->Simplified, this->Problems, preparing);
  if (!IsOver(this->Whole, this->Problems))
  {
    PartOfStage looking(this->Whole, SpacingEnd, 1.0);
    Pulse looks(looking);
    ReportNearMisses(domain, this->F, this->Input, this->Problems, looks);
  }
  this->DivideSidesAlike();
}

// f is the lower one of both sides.
void MeshMaker::DivideSidesAlike()
{
  if (this->Sides.IsEmpty() || this->Options.PreserveBoundary ||
    IsOver(this->Whole, this->Problems))
  {
    return;
  }
  Domain& domain = this->Simplified.Drawing;
  PartOfStage part(this->Whole, 1.0, 1.0);
  const auto first = std::make_shared<const Spacing>(std::move(this->F));
  this->F = PrepareSpacing(WithLowerOfSides(this->Options, domain, this->Sides, *first, part),
    this->Simplified, this->Problems, part,
    [first](const Point2& x) { return (*first)(x) / FloorFactor; });
  DivideSides(this->F, this->Settings.Biting, this->Sides, domain, part);
  if (!AddAborted(part, this->Problems))
  {
    Pulse pulse(part);
    this->Locator.emplace(domain, pulse);
  }
}

void MeshMaker::Bite()
{
  const Domain& domain = this->Simplified.Drawing;
  BitingOptions& options = this->Settings.Biting;
  this->Blocks.emplace(domain, this->F, this->Settings.IsShared ? this->Members : NoCrew(),
    this->Options.GhostLevels, this->Options.MostVerticesOfProcess);
  if (this->IsAllGiven())
  {
    return;
  }
  if (!this->Locator)
  {
    Pulse pulse(this->Whole);
    this->Locator.emplace(domain, pulse);
  }
  PartOfStage estimating(this->Whole, 0.0, EstimateEnd);
  const Forecast forecast = MakeForecast(domain, *this->Locator, this->F, options, estimating);
  if (AddAborted(estimating, this->Problems) ||
    RefuseMoreThan(options.MaximumNumberOfVertices, forecast.Vertices, this->Problems))
  {
    return;
  }
  const double trialsEnd =
    EstimateEnd + (1.0 - EstimateEnd) * ShareOfTrials(options, forecast.Vertices);
  PartOfStage trying(this->Whole, EstimateEnd, trialsEnd);
  options.BitingConstant =
    CalibrateBitingConstant(domain, *this->Locator, this->F, forecast.Density, options, trying);
  if (AddAborted(trying, this->Problems))
  {
    return;
  }
  PartOfStage rest(this->Whole, trialsEnd, 1.0);
  if (!this->Blocks->Bite(*this->Locator, forecast.Vertices, this->Settings.VerticesPerBlock,
        options, this->Problems, rest) &&
    !this->Blocks->IsHelping())
  {
    this->BiteWhole(forecast.Vertices, rest);
  }
  this->Locator.reset();
  this->IsDone = this->Blocks->IsHelping() && !this->Blocks->IsInUse();
}

void MeshMaker::BiteWhole(double expectedVertices, PartOfStage& part)
{
  BitingOptions& options = this->Settings.Biting;
  options.MaximumNumberOfVertices =
    std::min(options.MaximumNumberOfVertices, std::int64_t{ MostVerticesInIds });
  this->Bites =
    BiteDomain(this->Simplified.Drawing, *this->Locator, this->F, expectedVertices, options, part);
  if (this->Bites.End == BitingEnd::TooManyVertices)
  {
    // The estimate did not see all of f: more than the limit is what is known.
    const double most = static_cast<double>(options.MaximumNumberOfVertices);
    AddTooManyVertices(
      std::max(expectedVertices, most), options.MaximumNumberOfVertices, this->Problems);
  }
  if (!options.KeepFront)
  {
    Release(this->Bites.Bites, part);
  }
  AddAborted(part, this->Problems);
}

// Blocks are triangulated where they are bitten.
void MeshMaker::Triangulate()
{
  if (!this->Blocks->IsInUse() && !this->IsAllGiven())
  {
    this->Triangles = TriangulateBites(this->Simplified.Drawing,
      { this->Options.Phi, this->Options.PreserveBoundary }, this->Bites, this->Problems,
      this->Whole);
  }
}

void MeshMaker::Relax()
{
  if (this->Blocks->IsInUse())
  {
    this->Blocks->Relax(this->Bites, this->Triangles, this->Problems, this->Whole);
    return;
  }
  if (this->Settings.IsRelaxed && !this->IsAllGiven())
  {
    PartOfStage part(this->Whole, 0.0, 1.0);
    RelaxBites(this->Simplified.Drawing, this->F, { !this->Options.PreserveBoundary }, this->Bites,
      this->Triangles, part);
    AddAborted(part, this->Problems);
  }
}

void MeshMaker::Finish()
{
  SimplifiedDomain whole;
  if (!this->Given.IsEmpty())
  {
    PutBackTriangles(this->Given, this->Bites, this->Triangles);
    whole = this->Simplified;
    whole.Drawing = this->Given.Whole;
    this->Settings.IsDelaunay = false;
  }
  this->Mesh = FinishMesh({ this->Given.IsEmpty() ? this->Simplified : whole, this->F,
                            this->Options, this->Settings, this->Members },
    *this->Blocks, std::move(this->Bites), this->Triangles, this->Problems, this->Whole);
  if (IsOver(this->Whole, this->Problems))
  {
    return;
  }
  TellPartners(
    this->Simplified.Drawing, this->Sides, this->Options.PeriodicTranslations.size(), this->Mesh);
  if (this->Options.Opens)
  {
    PartOfStage opening(this->Whole, 1.0, 1.0);
    OpenInterfaces(this->Options.Opens, this->Mesh, opening);
    AddAborted(opening, this->Problems);
  }
}

} // namespace

BitingMesh MakeBitingMesh(const Polylines& input, const BitingMeshOptions& options,
  ProblemList& problems, Monitor& monitor, Crew& crew)
{
  KeepFreedMemory();
  StagesOnce stages(monitor);
  PartOfStage whole(stages, 0.0, 1.0);
  return MeshMaker(input, options, problems, whole, crew).Make();
}

} // namespace biting
