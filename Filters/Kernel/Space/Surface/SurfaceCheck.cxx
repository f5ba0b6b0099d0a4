// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceCheck.h"

#include "../../Base/Numbers.h"
#include "SharedWalls.h"
#include "SurfaceRepair.h"
#include "SurfaceWelding.h"

#include <cmath>   // for cos
#include <limits>  // for NaN
#include <utility> // for move

namespace biting
{

namespace
{

// One check: each step may rely on the ones before.
class SurfaceChecker
{
public:
  SurfaceChecker(CheckedSurface& result, const SurfaceCheckOptions& options, ProblemList& problems,
    Monitor& monitor)
    : Result(result)
    , Mesh(result.Mesh)
    , Options(options)
    , Problems(problems)
    , Beats(monitor)
  {
  }

  void Run(Monitor& monitor);

private:
  void Weld();
  void TellBorders();
  void TellCrowded();
  void TellPinched();
  void TellContacts(const BoxTree<SurfaceItem, 3>& tree);
  void CollectFeatures();
  void Measure();
  Point3 MiddleOf(std::size_t slot) const
  {
    return Midpoint(this->Mesh.At(NextSlotOf(slot)), this->Mesh.At(PreviousSlotOf(slot)));
  }
  std::int64_t CellOf(Id triangle) const { return this->Mesh.Cells[At(triangle)]; }

  CheckedSurface& Result;
  SurfaceMesh& Mesh;
  const SurfaceCheckOptions& Options;
  ProblemList& Problems;
  Pulse Beats;
  SurfaceLinks Links;
};

void SurfaceChecker::Run(Monitor& monitor)
{
  monitor.BeginStage("Joining triangles");
  this->Weld();
  this->Result.Shells = FindShells(this->Mesh, this->Links, this->Problems, this->Beats);
  this->TellBorders();
  this->TellCrowded();
  this->TellPinched();
  if (!this->Beats.Ask())
  {
    return;
  }
  monitor.BeginStage("Looking for crossings");
  const BoxTree<SurfaceItem, 3> tree = MakeSurfaceTree(this->Mesh, this->Beats);
  this->TellContacts(tree);
  OrientByNesting(this->Mesh, this->Links, tree, this->Result.Crossings, this->Result.Touches,
    this->Options.Noise, this->Result.Shells, this->Beats);
  monitor.BeginStage("Measuring");
  if (this->Options.TellsThickness)
  {
    this->Result.Thickness = SmallestThickness(this->Mesh, tree, this->Result.Shells, this->Beats);
  }
  this->CollectFeatures();
  this->Measure();
}

void SurfaceChecker::Weld()
{
  const auto reach = [this](const Point3& place)
  { return ClearShare * this->Options.Spacing(place); };
  std::size_t welded = WeldEqualPoints(this->Mesh, this->Beats);
  welded += WeldBorders(this->Mesh, this->Options.Rounding, this->Beats);
  this->Result.Figures.WeldedPoints = static_cast<std::int64_t>(welded);
  if (this->Options.Spacing)
  {
    WeldSlits(this->Mesh, reach, this->Problems, this->Beats);
  }
  if (!this->Mesh.Regions.empty())
  {
    JoinSharedWalls(this->Mesh, this->Problems, this->Beats);
  }
  RemoveDuplicates(this->Mesh, this->Problems, this->Beats);
  this->Links = LinkSurface(this->Mesh, this->Beats);
  RemoveFlatTriangles(this->Mesh, this->Links, this->Problems, this->Beats);
  if (this->Options.Spacing && this->Links.NumberOfOpen > 0)
  {
    CloseHoles(this->Mesh, this->Links, reach, this->Problems, this->Beats);
  }
}

void SurfaceChecker::TellBorders()
{
  for (const BorderChain& chain : BorderChains(this->Mesh, this->Links, this->Beats))
  {
    this->Problems.Add(BorderProblem(ProblemCode::OpenEdges, this->Mesh, chain));
  }
}

void SurfaceChecker::TellCrowded()
{
  for (std::size_t edge = 0; edge < this->Links.NumberOfCrowded(); ++edge)
  {
    const Id* slots = &this->Links.CrowdedSlots[At(this->Links.CrowdedOffsets[edge])];
    const Id count = this->Links.CrowdedOffsets[edge + 1] - this->Links.CrowdedOffsets[edge];
    this->Problems.Add(
      { ProblemCode::NonManifoldEdges, { this->CellOf(slots[0] / 3), this->CellOf(slots[1] / 3) },
        this->MiddleOf(At(slots[0])), std::to_string(count) + " triangles" });
  }
}

void SurfaceChecker::TellPinched()
{
  for (const Id vertex : PinchedVertices(this->Mesh, this->Links, this->Beats))
  {
    this->Problems.Add({ ProblemCode::PinchedVertices, { this->Mesh.PointIds[At(vertex)] },
      this->Mesh.Points[At(vertex)], "" });
  }
}

void SurfaceChecker::TellContacts(const BoxTree<SurfaceItem, 3>& tree)
{
  const auto tell = [this](ProblemCode code, const SurfaceContact& contact, const char* what)
  {
    this->Problems.Add({ code, { this->CellOf(contact.First), this->CellOf(contact.Second) },
      contact.Place, what + Figure(contact.Depth, 6) });
  };
  std::vector<SurfaceContact>& crossings = this->Result.Crossings;
  crossings = FindFolds(this->Mesh, this->Links, this->Options.Noise, this->Beats);
  for (const SurfaceContact& fold : crossings)
  {
    tell(ProblemCode::Folds, fold, "over a width of ");
  }
  for (const SurfaceContact& contact : FindContacts(this->Mesh, tree, this->Beats))
  {
    const bool isDeep = contact.Depth > this->Options.Noise;
    this->Result.Figures.Touches += isDeep ? 0 : 1;
    tell(isDeep ? ProblemCode::SelfCrossings : ProblemCode::SurfaceTouches, contact, "depth ");
    (isDeep ? crossings : this->Result.Touches).push_back(contact);
  }
}

void SurfaceChecker::CollectFeatures()
{
  const double turned = std::cos(this->Options.FeatureAngle / DegreesPerRadian);
  const auto add = [this](std::size_t slot, SurfaceEdgeKind kind)
  {
    this->Result.EdgeEnds.push_back(this->Mesh.Corners[NextSlotOf(slot)]);
    this->Result.EdgeEnds.push_back(this->Mesh.Corners[PreviousSlotOf(slot)]);
    this->Result.EdgeKinds.push_back(kind);
  };
  this->Beats.ForEach(this->Mesh.Corners.size(),
    [this, turned, &add](std::size_t slot)
    {
      const Id other = this->Links.Across[slot];
      if (other == OpenEdge)
      {
        add(slot, SurfaceEdgeKind::Border);
      }
      else if (other > static_cast<Id>(slot))
      {
        const Point3 a = this->Mesh.Normal(slot / 3);
        const Point3 b = this->Mesh.Normal(static_cast<std::size_t>(other / 3));
        if (Dot(a, b) < turned * Length(a) * Length(b))
        {
          add(slot, SurfaceEdgeKind::Feature);
        }
      }
    });
  for (std::size_t edge = 0; edge < this->Links.NumberOfCrowded(); ++edge)
  {
    const Id first = this->Links.CrowdedOffsets[edge];
    add(At(this->Links.CrowdedSlots[At(first)]), SurfaceEdgeKind::NonManifold);
  }
}

void SurfaceChecker::Measure()
{
  SurfaceFigures& figures = this->Result.Figures;
  figures.Edges = static_cast<std::int64_t>(this->Links.NumberOfEdges);
  figures.OpenEdges = static_cast<std::int64_t>(this->Links.NumberOfOpen);
  figures.NonManifoldEdges = static_cast<std::int64_t>(this->Links.NumberOfCrowded());
  figures.Parts = this->Result.Shells.NumberOfParts;
  figures.EulerNumber = static_cast<std::int64_t>(this->Mesh.Points.size()) - figures.Edges +
    static_cast<std::int64_t>(this->Mesh.NumberOfTriangles());
  for (const SurfaceShell& shell : this->Result.Shells.Shells)
  {
    figures.Cavities += shell.Depth % 2;
    figures.Volume += shell.Volume;
  }
  figures.Volume =
    figures.OpenEdges > 0 ? std::numeric_limits<double>::quiet_NaN() : figures.Volume;
  for (std::size_t t = 0; t < this->Mesh.NumberOfTriangles(); ++t)
  {
    figures.Area += 0.5 * Length(this->Mesh.Normal(t));
  }
  figures.Diagonal = this->Mesh.Bounds().Diagonal();
}

} // namespace

CheckedSurface CheckSurface(
  SurfaceMesh surface, const SurfaceCheckOptions& options, ProblemList& problems, Monitor& monitor)
{
  CheckedSurface result;
  result.Mesh = std::move(surface);
  SurfaceChecker(result, options, problems, monitor).Run(monitor);
  if (!monitor.Advance(1.0))
  {
    problems.Add({ ProblemCode::Aborted, {}, {}, "" });
  }
  return result;
}

} // namespace biting
