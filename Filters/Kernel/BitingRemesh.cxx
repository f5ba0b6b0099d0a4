// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BitingRemesh.h"

#include "Base/Ids.h"
#include "Base/Monitor.h"
#include "Base/Pulse.h"
#include "Biting/BitingScheme.h"
#include "Domain/DomainLocator.h"
#include "Domain/Polylines.h"
#include "Quality/MeshCheck.h"
#include "Remeshing/EdgeSimplification.h"
#include "Remeshing/FaceRegions.h"
#include "Remeshing/KeptVertices.h"
#include "Remeshing/ReleasedVertices.h"
#include "Remeshing/RemeshRegion.h"
#include "Remeshing/Stitching.h"
#include "Simplification/Simplification.h" // for areas that changed
#include "Stages/MeshedBites.h"
#include "Stages/SegmentCover.h"
#include "Stages/StageProblems.h"

#include <algorithm> // for min
#include <string>    // for figures
#include <utility>   // for move

namespace biting
{

namespace
{

// Where steps end, as shares of the time of their stage.
constexpr double EdgesEnd = 0.05;
constexpr double LocatorEnd = 0.2;
constexpr double CheckEnd = 0.3;

constexpr int ReleaseRounds = 4; // further rounds release few vertices more

double AreaOf(const std::vector<Point2>& points, const std::vector<Id>& corners)
{
  double area = 0.0;
  for (std::size_t first = 0; first < corners.size(); first += 3)
  {
    area += AreaOfTriangle(points, corners.data() + first);
  }
  return area;
}

class Remesher
{
public:
  /// `nearest` as ReadOldMesh has it.
  Remesher(const RemeshInput& input, double nearest, const RemeshOptions& options,
    ProblemList& problems, Monitor& monitor)
    : Input(input)
    , Nearest(nearest)
    , Options(options)
    , Rules(RulesFor(options.Preference))
    , Problems(problems)
    , Listener(monitor)
    , Whole(monitor, 0.0, 1.0)
  {
  }

  RemeshResult Run();

private:
  bool IsOver();
  void Read();
  void Compare();
  void Keep();
  void Make();
  void MakeWith(EdgePolicy policy);
  void ChooseVertices(EdgePolicy policy, Monitor& monitor);
  void Bite();
  void Triangulate();
  void Relax();
  void Finish();
  void CheckCavity();
  std::vector<std::uint8_t> FindFitting(const std::vector<Id>& held) const;
  HoldOptions HoldBy(const InnerPlaces& places, const std::vector<Id>& held) const;
  double ExpectedVertices() const;
  std::vector<double> RegionSpacings() const;
  void Begin(const Stage& stage) { this->Listener.BeginStage(stage.Text); }

  const RemeshInput& Input;
  double Nearest;
  const RemeshOptions& Options;
  KeepRules Rules;
  ProblemList& Problems;
  Monitor& Listener;
  PartOfStage Whole;
  EdgeTolerance Tolerance;
  RemeshResult Result;
  ChangedRegion Region;
  RegionEdges Edges;
  Spacing F;
  CavityMesh Cavity;
  Id NumberOfMiddles = 0; ///< among the vertices of the cavity
};

RemeshResult Remesher::Run()
{
  using Step = void (Remesher::*)();
  for (const Step step :
    { &Remesher::Read, &Remesher::Compare, &Remesher::Make, &Remesher::Finish })
  {
    const bool isUnchanged = this->Result.IsUnchanged;
    (this->*(isUnchanged ? &Remesher::Keep : step))();
    if (this->IsOver())
    {
      return {};
    }
    if (isUnchanged)
    {
      break;
    }
  }
  return std::move(this->Result);
}

bool Remesher::IsOver()
{
  AddAborted(this->Whole, this->Problems);
  return this->Problems.HasErrors();
}

void Remesher::Read()
{
  this->Begin(RemeshingStages::Reading);
  this->Result.Old = ReadOldMesh(this->Input, this->Nearest, this->Problems, this->Whole);
  this->Result.IsUnchanged = this->Result.Old.Corners.empty();
}

void Remesher::Compare()
{
  this->Begin(RemeshingStages::Spacing);
  RemeshRegion found =
    FindRemeshRegion(this->Result.Old, this->Options, this->Problems, this->Whole);
  this->Region = std::move(found.Region);
  this->F = std::move(found.F);
  this->Tolerance = std::move(found.Tolerance);
  this->Result.OldSpacings = std::move(found.OldSpacings);
  this->Result.IsUnchanged = this->Region.IsEmpty();
}

// All triangles stay; where points of them were made one the mesh is another.
void Remesher::Keep()
{
  if (!this->Result.Old.IsWelded)
  {
    this->Result.Mesh = EdgesOf(this->Result.Old);
    return;
  }
  this->Result.IsUnchanged = false;
  this->Region.IsChanged.resize(this->Result.Old.Regions.size(), 0);
  this->Finish();
}

std::vector<double> Remesher::RegionSpacings() const
{
  std::vector<double> spacings;
  for (const Id vertex : this->Region.Vertices)
  {
    spacings.push_back(this->Result.OldSpacings[vertex]);
  }
  return spacings;
}

// Where vertices of straight parts lie as near to other edges as rounding, they cannot go, nor
// others come.
void Remesher::Make()
{
  for (const EdgePolicy policy : { EdgePolicy::Free, EdgePolicy::SplitOnly, EdgePolicy::Frozen })
  {
    if (policy < this->Options.Edges)
    {
      continue;
    }
    const ProblemList before = this->Problems;
    this->Tolerance = policy == EdgePolicy::Free ? this->Tolerance : EdgeTolerance();
    this->MakeWith(policy);
    if (policy == EdgePolicy::Frozen || !this->Problems.Has(ProblemCode::CheckFailed))
    {
      return;
    }
    this->Problems = before;
  }
}

void Remesher::MakeWith(EdgePolicy policy)
{
  this->Begin(RemeshingStages::Biting);
  PartOfStage choosing(this->Whole, 0.0, EdgesEnd);
  this->ChooseVertices(policy, choosing);
  using Step = void (Remesher::*)();
  for (const Step step :
    { &Remesher::Bite, &Remesher::Triangulate, &Remesher::Relax, &Remesher::CheckCavity })
  {
    (this->*step)();
    if (this->IsOver())
    {
      return;
    }
  }
}

void Remesher::ChooseVertices(EdgePolicy policy, Monitor& monitor)
{
  const OldMesh& old = this->Result.Old;
  const std::vector<double> spacings = this->RegionSpacings();
  this->Edges = this->Tolerance.IsAsked()
    ? SimplifiedEdges(old, this->Region, spacings, this->Rules, this->Tolerance, monitor)
    : ThinnedEdges(old, this->Region, spacings, this->Rules, policy);
  const std::vector<std::uint8_t> isKept =
    ChooseKeptVertices(old, this->Region, this->Edges, spacings, this->Rules);
  const std::vector<Point2> middles = FindMiddles(old, this->Region, isKept, spacings);
  this->NumberOfMiddles = static_cast<Id>(middles.size());
  this->Cavity.Geometry = MakeCavityDomain(old, this->Region, this->Edges, isKept, middles, policy);
}

// By the area of the triangles in units of f: their vertices say enough of f.
double Remesher::ExpectedVertices() const
{
  const OldMesh& old = this->Result.Old;
  const std::vector<double>& spacings = this->Result.OldSpacings;
  double density = 0.0;
  for (const Id triangle : this->Region.Triangles)
  {
    const Id* corners = old.Corners.data() + 3 * static_cast<std::size_t>(triangle);
    const double f = (spacings[corners[0]] + spacings[corners[1]] + spacings[corners[2]]) / 3.0;
    density += AreaOfTriangle(old.Points, corners) / (f * f);
  }
  return EstimateNumberOfVertices(density) + this->Cavity.Geometry.NumberOfVertices() -
    this->NumberOfMiddles;
}

void Remesher::Bite()
{
  const double expected = this->ExpectedVertices();
  const double most = std::min(static_cast<double>(this->Options.MaximumNumberOfVertices),
    static_cast<double>(MostVerticesInIds));
  const double unchanged = static_cast<double>(this->Result.Old.NumberOfVertices()) -
    static_cast<double>(this->Region.Vertices.size());
  BitingOptions options(BiteShape::Square, Placement::Bisectors);
  options.MaximumNumberOfVertices = static_cast<std::int64_t>(std::max(most - unchanged, 1.0));
  if (expected + unchanged <= most)
  {
    PartOfStage locating(this->Whole, EdgesEnd, LocatorEnd);
    Pulse pulse(locating);
    const DomainLocator locator(this->Cavity.Geometry, pulse);
    PartOfStage biting(this->Whole, LocatorEnd, 1.0);
    this->Cavity.Bites =
      BiteDomain(this->Cavity.Geometry, locator, this->F, expected, options, biting);
  }
  if (!(expected + unchanged <= most) || this->Cavity.Bites.End == BitingEnd::TooManyVertices)
  {
    AddProblem(ProblemCode::TooManyVertices,
      "about " + std::to_string(static_cast<std::int64_t>(std::min(expected + unchanged, 1e18))) +
        " vertices, the limit is " + std::to_string(static_cast<std::int64_t>(most)),
      this->Problems);
  }
}

void Remesher::Triangulate()
{
  this->Begin(RemeshingStages::Triangulation);
  this->Cavity.Triangles =
    TriangulateBites(this->Cavity.Geometry, {}, this->Cavity.Bites, this->Problems, this->Whole);
}

// 1 for those where the spacing agrees with the old mesh: they go last.
std::vector<std::uint8_t> Remesher::FindFitting(const std::vector<Id>& held) const
{
  std::vector<std::uint8_t> isFitting;
  isFitting.reserve(held.size());
  for (const Id point : held)
  {
    const Id number = this->Region.Numbers[point];
    isFitting.push_back(KeepRules::IsUnchanged(this->Region.Lengths[number]));
  }
  return isFitting;
}

HoldOptions Remesher::HoldBy(const InnerPlaces& places, const std::vector<Id>& held) const
{
  HoldOptions hold;
  hold.Count = static_cast<Id>(held.size());
  hold.GreatestCotangent = this->Rules.GreatestCotangent;
  hold.ShortestEdge = this->Rules.ShortestEdge;
  hold.LongestEdge = this->Rules.LongestEdge;
  hold.Rounds = ReleaseRounds;
  hold.AreLast = this->FindFitting(held);
  if (this->Rules.GreatestCotangentAtPlaces > 0.0)
  {
    hold.FindPlace = [&places](const Point2& place, double reach)
    { return places.FindNear(place, reach); };
  }
  hold.ReachOfPlaces = KeepRules::ReachOfPlaces;
  hold.GreatestCotangentAtPlaces = this->Rules.GreatestCotangentAtPlaces;
  return hold;
}

// Kept vertices stay, but for those that leave poor triangles; others become old ones.
void Remesher::Relax()
{
  this->Begin(RemeshingStages::Relaxation);
  if (!this->Options.Relaxation)
  {
    ReleaseVertices(FindAddedVertices(this->Cavity.Geometry), this->Cavity.Geometry,
      this->Cavity.Bites, this->Cavity.Triangles);
    return;
  }
  const std::vector<std::uint8_t> mayGo =
    FindVerticesThatMayGo(this->Result.Old, this->Cavity.Geometry);
  const std::vector<Id> held = ListHeld(mayGo, this->Cavity.Geometry);
  ReleaseVertices(mayGo, this->Cavity.Geometry, this->Cavity.Bites, this->Cavity.Triangles);
  Pulse pulse(this->Whole);
  const InnerPlaces places(this->Result.Old, this->Region, this->Edges, pulse);
  if (this->IsOver())
  {
    return;
  }
  RelaxationOptions options;
  if (!this->Options.RelaxAll)
  {
    options.Hold = this->HoldBy(places, held);
  }
  RelaxBites(this->Cavity.Geometry, this->F, options, this->Cavity.Bites, this->Cavity.Triangles,
    this->Whole);
  if (!this->IsOver() && !this->Options.RelaxAll)
  {
    ReturnVertices(places, this->Cavity.Geometry, this->Cavity.Bites, this->Cavity.Triangles);
  }
}

// The second look at what is new, as FinalCheck has it; what is unchanged was looked at before.
void Remesher::CheckCavity()
{
  this->Begin(RemeshingStages::Quality);
  PartOfStage checking(this->Whole, 0.0, CheckEnd);
  const Domain& domain = this->Cavity.Geometry;
  const Triangulation& mesh = this->Cavity.Triangles;
  const std::vector<Point2>& points = this->Cavity.Bites.Points;
  std::string violation =
    CheckMesh({ points, mesh.Corners, mesh.Neighbors, mesh.Constraints, domain.Area }, checking);
  if (violation.empty())
  {
    violation = CheckSegmentCover(domain,
      { points, mesh.Corners, mesh.Neighbors, mesh.Constraints, this->Cavity.Bites.EdgeSegments },
      checking);
  }
  if (violation.empty())
  {
    violation = CheckRim(this->Result.Old, this->Region, this->Edges, this->Cavity);
  }
  if (violation.empty())
  {
    Pulse pulse(checking);
    this->Cavity.FaceRegions =
      FindFaceRegions(this->Result.Old, this->Region, this->Edges, this->Cavity, pulse);
    violation = pulse.HasStopped()
      ? ""
      : CheckAreas(this->Result.Old, this->Region, this->Cavity, this->Tolerance);
  }
  if (!this->IsOver() && !violation.empty())
  {
    AddProblem(ProblemCode::CheckFailed, violation, this->Problems);
  }
}

void Remesher::Finish()
{
  StitchedMesh stitched =
    Stitch(this->Result.Old, this->Region, this->Edges, this->Result.OldSpacings, this->Cavity);
  BitingMesh& mesh = this->Result.Mesh;
  mesh = std::move(stitched.Mesh);
  if (this->Tolerance.IsAsked())
  {
    const OldMesh& old = this->Result.Old;
    ReportChangedArea(
      AreaOf(old.Points, old.Corners), AreaOf(mesh.Points, mesh.Corners), this->Problems);
  }
  this->Result.OriginalTriangles = std::move(stitched.OriginalTriangles);
  this->Result.ChangedTriangles = std::move(this->Region.Triangles);
  const MeshView view{ mesh.Points, mesh.Spacing, mesh.Corners, mesh.Neighbors };
  PartOfStage measuring(this->Whole, CheckEnd, 1.0);
  mesh.Quality = MeasureQuality(view, measuring);
  mesh.UsedLipschitz = mesh.Quality.LargestSlope;
  mesh.GivenLipschitz = this->F.GivenLipschitz();
  if (this->Options.KeepBites)
  {
    mesh.Bites = std::move(this->Cavity.Bites.Bites);
  }
}

bool IsNoMesh(const ProblemList& problems)
{
  return problems.Has(ProblemCode::CheckFailed) || problems.Has(ProblemCode::BadTriangles);
}

} // namespace

// Points that are meant to be one are mostly within a unit in the last place. Where what is left of
// slits then forms no mesh, all that rounding may have moved apart is made one.
RemeshResult Remesh(
  const RemeshInput& input, const RemeshOptions& options, ProblemList& problems, Monitor& monitor)
{
  const double nearest = input.Rounding / NoiseInUlp;
  const ProblemList before = problems;
  StagesOnce stages(monitor);
  RemeshResult result = Remesher(input, nearest, options, problems, stages).Run();
  if (IsNoMesh(problems) && nearest < input.Rounding)
  {
    ProblemList told = before;
    result = Remesher(input, input.Rounding, options, told, stages).Run();
    problems = told.HasErrors() && !told.Has(ProblemCode::Aborted) ? problems : told;
  }
  return result;
}

} // namespace biting
