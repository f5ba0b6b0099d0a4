// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BlockMesher.h"

#include "../Base/PartOfStage.h"
#include "../Base/Tasks.h"
#include "../Biting/BitingState.h"
#include "../Meshing/RelaxedBites.h"
#include "../Meshing/SoundTriangulation.h"
#include "../Meshing/StageProblems.h"
#include "BlockBytes.h"
#include "BlockShares.h"
#include "CutPlan.h"
#include "CutStrip.h"

#include <algorithm> // for max
#include <atomic>    // for what threads share
#include <cstdint>   // for counts
#include <string>    // for violations
#include <utility>   // for move

namespace biting
{

namespace
{

// Where steps end, as shares of the time.
constexpr double PlanEnd = 0.02;
constexpr double CuttingEnd = 0.7;
constexpr double LocatorEnd = 0.05;
constexpr double BlocksEnd = 0.8;
constexpr double JoiningEnd = 0.85;

// Blocks have more fronts that meet, and by that more chances of a poor triangle than one block.
constexpr double PoorInBlock = 0.92;

} // namespace

bool BlockMesher::Bite(const DomainLocator& locator, double vertices, double verticesPerBlock,
  const BitingOptions& options, ProblemList& problems, Monitor& monitor)
{
  if (!(verticesPerBlock > 0.0))
  {
    return false;
  }
  this->Options = options;
  this->Expected = vertices;
  PartOfStage planning(monitor, 0.0, PlanEnd);
  this->Plan(locator, vertices, verticesPerBlock, planning);
  if (AddAborted(planning, problems) || !this->IsInUse())
  {
    return planning.HasStopped();
  }
  PartOfStage biting(monitor, PlanEnd, 1.0);
  this->BiteBlocks(biting);
  if (!AddAborted(biting, problems))
  {
    this->RefuseTooManyVertices(problems);
  }
  return true;
}

void BlockMesher::Plan(
  const DomainLocator& locator, double vertices, double verticesPerBlock, Monitor& monitor)
{
  PartOfStage cutting(monitor, 0.0, CuttingEnd);
  Pulse pulse(cutting);
  const CutPlan plan = PlanCuts(this->Geometry, locator, this->F,
    { vertices, verticesPerBlock, UsedPartLength(this->Options) }, pulse);
  if (cutting.HasStopped())
  {
    return;
  }
  PartOfStage making(monitor, CuttingEnd, 1.0);
  CutDivision division;
  division.BitingConstant = UsedBitingConstant(this->Options);
  division.PartLength = UsedPartLength(this->Options);
  division.MostVertices = static_cast<Id>(this->Options.MaximumNumberOfVertices);
  this->Parts = MakeBlockDomains(this->Geometry, this->F, plan, division, making);
  this->Tree = plan.Tree;
  this->Meshes.resize(this->Parts.Blocks.size());
  if (!this->IsInUse())
  {
    return;
  }
  this->Shares = ShareBlocks(this->Parts.Blocks, static_cast<std::size_t>(this->Members.Size()));
  this->LargestFirst = this->Shares[static_cast<std::size_t>(this->Members.Own())];
  if (this->IsCollecting())
  {
    this->Members.Call();
  }
}

// Threads that find no more blocks to bite triangulate some, for as long as others bite.
void BlockMesher::BiteBlocks(Monitor& monitor)
{
  const std::size_t count = this->LargestFirst.size();
  this->Found.resize(this->Meshes.size());
  this->AreTriangulated.assign(this->Meshes.size(), 0);
  std::vector<std::atomic<bool>> areBitten(count);
  std::atomic<std::size_t> begun{ 0 };
  std::atomic<std::size_t> ended{ 0 };
  std::atomic<std::size_t> next{ 0 };
  Pulse pulse(monitor);
  DoTasks(pulse, count,
    [this, count, &areBitten, &begun, &ended, &next](std::size_t k, Monitor& own)
    {
      ++begun;
      this->BiteBlock(this->LargestFirst[k], own);
      areBitten[k] = true;
      ++ended;
      PartOfStage after(own, 1.0, 1.0);
      while (begun == count && ended < count && next < count && !after.HasStopped())
      {
        const std::size_t other = next++;
        if (other < count && areBitten[other])
        {
          this->TriangulateBlock(this->LargestFirst[other], after);
        }
      }
    });
}

void BlockMesher::RefuseTooManyVertices(ProblemList& problems) const
{
  const std::int64_t most = this->Options.MaximumNumberOfVertices;
  std::int64_t vertices = 0;
  bool isTooMuch = false;
  for (const BlockMesh& mesh : this->Meshes)
  {
    vertices += mesh.Bitten;
    isTooMuch = isTooMuch || mesh.Bites.End == BitingEnd::TooManyVertices;
  }
  if (isTooMuch || vertices > most)
  {
    // The estimate did not see all of f: more than the limit is what is known.
    AddTooManyVertices(std::max(this->Expected, static_cast<double>(most)), most, problems);
  }
}

void BlockMesher::BiteBlock(std::size_t block, Monitor& monitor)
{
  const BlockDomain& part = this->Parts.Blocks[block];
  PartOfStage locating(monitor, 0.0, LocatorEnd);
  Pulse pulse(locating);
  const DomainLocator locator(part.Geometry, pulse);
  PartOfStage biting(monitor, LocatorEnd, 1.0);
  BitingResult& bites = this->Meshes[block].Bites;
  BitingOptions options = this->Options;
  options.Stretch = part.Stretch;
  bites = BiteDomain(part.Geometry, locator, this->F, part.ExpectedVertices, options, biting);
  bites.Bites = Bites();
  this->Meshes[block].Bitten = static_cast<std::int64_t>(bites.Points.size());
}

Triangulation BlockMesher::Triangulate(ProblemList& problems, Monitor& monitor)
{
  PartOfStage part(monitor, 0.0, 1.0);
  Pulse pulse(part);
  DoTasks(pulse, this->LargestFirst.size(),
    [this](std::size_t k, Monitor& own)
    {
      if (this->AreTriangulated[this->LargestFirst[k]] == 0)
      {
        this->TriangulateBlock(this->LargestFirst[k], own);
      }
    });
  for (std::size_t block = 0; block < this->Found.size() && !AddAborted(part, problems); ++block)
  {
    AddAll(this->Found[block], problems);
  }
  this->Found.clear();
  return {};
}

void BlockMesher::TriangulateBlock(std::size_t block, Monitor& monitor)
{
  BlockMesh& mesh = this->Meshes[block];
  mesh.Triangles = TriangulateBites(
    this->Parts.Blocks[block].Geometry, {}, mesh.Bites, this->Found[block], monitor);
  this->AreTriangulated[block] = 1;
}

void BlockMesher::Relax(
  BitingResult& bites, Triangulation& triangles, ProblemList& problems, Monitor& monitor)
{
  PartOfStage relaxing(monitor, 0.0, BlocksEnd);
  this->RelaxBlocks(problems, relaxing);
  if (!AddAborted(relaxing, problems) && !problems.HasErrors() && this->IsCollecting())
  {
    this->Collect(relaxing);
    this->MakeMissing(problems, relaxing);
  }
  if (AddAborted(relaxing, problems) || problems.HasErrors())
  {
    return;
  }
  if (this->IsHelping())
  {
    this->SendOwn();
    return;
  }
  PartOfStage joining(monitor, BlocksEnd, JoiningEnd);
  this->Join(problems, joining);
  if (AddAborted(joining, problems) || problems.HasErrors())
  {
    return;
  }
  PartOfStage mending(monitor, JoiningEnd, 1.0);
  RelaxCuts(this->Geometry, this->Parts.AreTouching, this->F, this->Joined, mending);
  AddAborted(mending, problems);
  bites = std::move(this->Joined.Bites);
  triangles = std::move(this->Joined.Triangles);
}

void BlockMesher::RelaxBlocks(ProblemList& problems, Monitor& monitor)
{
  std::vector<std::string> violations(this->Meshes.size());
  RelaxationOptions options;
  options.PoorCotangents = PoorInBlock;
  Pulse pulse(monitor);
  DoTasks(pulse, this->LargestFirst.size(),
    [this, &violations, &options](std::size_t k, Monitor& own)
    {
      const std::size_t block = this->LargestFirst[k];
      BlockMesh& mesh = this->Meshes[block];
      violations[block] = RelaxBites(
        this->Parts.Blocks[block].Geometry, this->F, options, mesh.Bites, mesh.Triangles, own);
    });
  for (const std::string& violation : violations)
  {
    if (!violation.empty() && !pulse.HasStopped())
    {
      AddProblem(ProblemCode::CheckFailed, violation, problems);
    }
  }
}

void BlockMesher::SendOwn()
{
  this->Members.Send(PackBlocks(this->Parts, this->LargestFirst, this->Meshes));
}

// What the others have made; what is missing is left as the blocks that this process makes.
void BlockMesher::Collect(Monitor& monitor)
{
  this->LargestFirst.clear();
  for (std::size_t member = 1; member < this->Shares.size(); ++member)
  {
    const std::vector<char> bytes = this->Members.Receive(static_cast<int>(member), monitor);
    if (!UnpackBlocks(bytes, this->Parts, this->Shares[member], this->Meshes))
    {
      this->LargestFirst.insert(
        this->LargestFirst.end(), this->Shares[member].begin(), this->Shares[member].end());
    }
  }
}

// The stages once more, for blocks that did not arrive.
void BlockMesher::MakeMissing(ProblemList& problems, Monitor& monitor)
{
  PartOfStage making(monitor, 1.0, 1.0);
  if (!this->LargestFirst.empty() && !making.HasStopped())
  {
    this->BiteBlocks(making);
  }
  if (!making.HasStopped())
  {
    this->RefuseTooManyVertices(problems);
  }
  if (!this->LargestFirst.empty() && !AddAborted(making, problems) && !problems.HasErrors())
  {
    this->Triangulate(problems, making);
    this->RelaxBlocks(problems, making);
  }
}

void BlockMesher::Join(ProblemList& problems, Monitor& monitor)
{
  Pulse pulse(monitor);
  this->Joined = JoinBlocks(this->Geometry, this->Parts, std::move(this->Meshes), pulse);
  if (!pulse.HasStopped() && !this->Joined.IsSound)
  {
    AddProblem(ProblemCode::CheckFailed, "the sides of a cut do not fit", problems);
  }
}

} // namespace biting
