// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BlockMesher.h"

#include "../Base/Monitor.h"
#include "../Base/Tasks.h"
#include "../Stages/MeshedBites.h"
#include "../Stages/StageProblems.h"
#include "CutPlan.h"
#include "StripParts.h"

#include <algorithm> // for max
#include <cstdint>   // for counts
#include <limits>    // for the largest number of a bite
#include <utility>   // for move

namespace biting
{

namespace
{

// Where steps end, as shares of the time.
constexpr double PlanEnd = 0.02;
constexpr double CuttingEnd = 0.7;
constexpr double LocatorEnd = 0.05;
constexpr double BitingEnds = 0.8; // of a block
constexpr double BlocksEnd = 0.8;
constexpr double JoiningEnd = 0.25; // of what follows

// How many steps across edges collars are wider than the strips: for flips at their rims, and for
// what lies around the part of a member; a ring of vertices takes two to three.
constexpr int StepsAround = 6;
constexpr int StepsALevel = 3;

// Of vertices, for what is measured at a vertex: triangles at it, and those beyond them.
constexpr int RingsBeyond = 2;

// Blocks have more fronts that meet, and by that more chances of a poor triangle than one block.
constexpr double PoorInBlock = 0.92;

// Whether a share is more than a member may have. The limit that is told is that of a whole which
// is shared in the same way.
bool RefuseLargeShares(const std::vector<std::vector<std::size_t>>& shares,
  const std::vector<BlockDomain>& blocks, double expected, std::int64_t mostOfMember,
  ProblemList& problems)
{
  const double most = static_cast<double>(mostOfMember);
  double largest = 0.0;
  for (const std::vector<std::size_t>& share : shares)
  {
    double vertices = 0.0;
    for (const std::size_t block : share)
    {
      vertices += blocks[block].ExpectedVertices;
    }
    largest = std::max(largest, vertices);
  }
  // A share that is the whole was compared before, by the better estimate.
  return shares.size() > 1 && largest > most &&
    RefuseMoreThan(static_cast<std::int64_t>(expected / largest * most), expected, problems);
}

// Whether the mesh of collars has more vertices than a process may have, or a piece with ghosts
// from it, or all blocks together have more bites than there are numbers.
bool AreTooLarge(
  const std::vector<BlockCollar>& collars, double ofShareWithGhosts, std::int64_t mostOfMember)
{
  std::int64_t vertices = 0;
  std::int64_t orders = 0;
  for (const BlockCollar& collar : collars)
  {
    vertices += static_cast<std::int64_t>(collar.Mesh.Bites.Points.size());
    orders += collar.Mesh.NumberOfOrders;
  }
  return static_cast<double>(vertices) + ofShareWithGhosts > static_cast<double>(mostOfMember) ||
    orders > std::numeric_limits<Id>::max();
}

} // namespace

bool BlockMesher::Bite(const DomainLocator& locator, double vertices, double verticesPerBlock,
  const BitingOptions& options, ProblemList& problems, Monitor& monitor)
{
  if (!(verticesPerBlock > 0.0))
  {
    return false;
  }
  this->Options = options;
  this->MostOfWhole = options.MaximumNumberOfVertices;
  this->Options.MaximumNumberOfVertices = std::min(this->MostOfWhole, this->MostOfMember);
  this->Expected = vertices;
  PartOfStage planning(monitor, 0.0, PlanEnd);
  this->Plan(locator, vertices, verticesPerBlock, problems, planning);
  if (AddAborted(planning, problems) || problems.HasErrors())
  {
    return true;
  }
  if (!this->IsInUse())
  {
    return RefuseMoreThan(this->Options.MaximumNumberOfVertices, vertices, problems);
  }
  PartOfStage biting(monitor, PlanEnd, 1.0);
  this->BiteBlocks(biting);
  if (!AddAborted(biting, problems))
  {
    this->ConcludeBiting(problems);
  }
  return true;
}

void BlockMesher::Plan(const DomainLocator& locator, double vertices, double verticesPerBlock,
  ProblemList& problems, Monitor& monitor)
{
  PartOfStage cutting(monitor, 0.0, CuttingEnd);
  Pulse pulse(cutting);
  const CutPlan plan = PlanCuts(this->Geometry, locator, this->F,
    { vertices, verticesPerBlock, this->Options.PartLength }, pulse);
  if (cutting.HasStopped())
  {
    return;
  }
  PartOfStage making(monitor, CuttingEnd, 1.0);
  CutDivision division;
  division.BitingConstant = this->Options.BitingConstant;
  division.PartLength = this->Options.PartLength;
  division.MostVertices = static_cast<Id>(this->Options.MaximumNumberOfVertices);
  this->Own.Parts = MakeBlockDomains(this->Geometry, this->F, plan, division, making);
  this->Tree = plan.Tree;
  this->Own.Meshes.resize(this->Own.Parts.Blocks.size());
  if (!this->IsInUse())
  {
    return;
  }
  const auto members = static_cast<std::size_t>(this->Members.Size());
  this->Shares =
    ShareBlocks(this->Own.Parts.Blocks, DealLeaves(this->Tree, static_cast<Id>(members)), members);
  this->LargestFirst = this->Shares[this->Members.Own()];
  const bool isRefused = RefuseLargeShares(
    this->Shares, this->Own.Parts.Blocks, this->Expected, this->MostOfMember, problems);
  if (!isRefused && !this->IsHelping() && members > 1)
  {
    this->Members.Call();
  }
}

void BlockMesher::BiteBlocks(Monitor& monitor)
{
  this->Found.resize(this->Own.Meshes.size());
  Pulse pulse(monitor);
  DoTasks(pulse, this->LargestFirst.size(),
    [this](std::size_t k, Monitor& own) { this->BiteBlock(this->LargestFirst[k], own); });
}

void BlockMesher::ConcludeBiting(ProblemList& problems)
{
  std::int64_t most = this->MostOfWhole;
  std::int64_t vertices = 0;
  std::int64_t atHand = 0;
  bool isTooMuch = false;
  for (const BlockMesh& mesh : this->Own.Meshes)
  {
    vertices += mesh.Bitten;
    atHand += static_cast<std::int64_t>(mesh.Bites.Points.size());
    isTooMuch = isTooMuch || mesh.Bites.End == BitingEnd::TooManyVertices;
  }
  if (atHand > this->MostOfMember)
  {
    most = std::min(most, this->MostOfMember);
  }
  if (isTooMuch || std::max(vertices, atHand) > most)
  {
    // The estimate did not see all of f: more than the limit is what is known.
    AddTooManyVertices(std::max(this->Expected, static_cast<double>(most)), most, problems);
  }
  for (const ProblemList& found : this->Found)
  {
    AddAll(found, problems);
  }
  this->Found.clear();
}

// Its triangulation follows at once: no thread waits for the blocks of others.
void BlockMesher::BiteBlock(std::size_t block, Monitor& monitor)
{
  const BlockDomain& part = this->Own.Parts.Blocks[block];
  PartOfStage locating(monitor, 0.0, LocatorEnd);
  Pulse pulse(locating);
  const DomainLocator locator(part.Geometry, pulse);
  PartOfStage biting(monitor, LocatorEnd, BitingEnds);
  BlockMesh& mesh = this->Own.Meshes[block];
  BitingOptions options = this->Options;
  options.Stretch = part.Stretch;
  mesh.Bites = BiteDomain(part.Geometry, locator, this->F, part.ExpectedVertices, options, biting);
  mesh.Bites.Bites = Bites();
  mesh.Bitten = static_cast<std::int64_t>(mesh.Bites.Points.size());
  PartOfStage triangulating(monitor, BitingEnds, 1.0);
  if (!biting.HasStopped() && mesh.Bites.End == BitingEnd::Complete)
  {
    mesh.Triangles =
      TriangulateBites(part.Geometry, {}, mesh.Bites, this->Found[block], triangulating);
  }
}

void BlockMesher::Relax(
  BitingResult& bites, Triangulation& triangles, ProblemList& problems, Monitor& monitor)
{
  PartOfStage relaxing(monitor, 0.0, BlocksEnd);
  this->RelaxBlocks(relaxing);
  if (AddAborted(relaxing, problems))
  {
    return;
  }
  if (this->Members.Size() > 1)
  {
    this->TakeCollars();
  }
  if (this->IsHelping())
  {
    this->Members.Send(PackCollars(this->Own.Parts, this->LargestFirst, this->Own.Collars));
    return;
  }
  PartOfStage joining(monitor, BlocksEnd, 1.0);
  this->Own.AreSpread = this->Members.Size() > 1 && this->MendCollars(problems, joining);
  if (AddAborted(joining, problems) || problems.HasErrors())
  {
    return;
  }
  if (!this->Own.AreSpread)
  {
    this->MendWhole(problems, joining);
  }
  AddAborted(joining, problems);
  bites = std::move(this->Joined.Bites);
  triangles = std::move(this->Joined.Triangles);
}

void BlockMesher::RelaxBlocks(Monitor& monitor)
{
  RelaxationOptions options;
  options.PoorCotangents = PoorInBlock;
  Pulse pulse(monitor);
  DoTasks(pulse, this->LargestFirst.size(),
    [this, &options](std::size_t k, Monitor& own)
    {
      const std::size_t block = this->LargestFirst[k];
      BlockMesh& mesh = this->Own.Meshes[block];
      RelaxBites(
        this->Own.Parts.Blocks[block].Geometry, this->F, options, mesh.Bites, mesh.Triangles, own);
    });
}

// Of the blocks at hand.
void BlockMesher::TakeCollars()
{
  this->Own.Collars.resize(this->Own.Meshes.size());
  const std::vector<std::uint8_t> isOnCut = VerticesOnCuts(this->Own.Parts.Graph);
  for (const std::size_t block : this->LargestFirst)
  {
    this->Own.Collars[block] = TakeCollar(this->Own.Parts.Blocks[block], isOnCut,
      this->Own.Meshes[block], StripSteps + StepsAround + StepsALevel * this->GhostLevels);
  }
}

// Receives the collars of the other members. Blocks that do not arrive become blocks of this
// process. Returns whether a member holds blocks.
bool BlockMesher::Collect(Monitor& monitor)
{
  KeptBlocks& own = this->Own;
  own.Holders.assign(own.Meshes.size(), 0);
  own.AreHolding.assign(this->Shares.size(), false);
  this->LargestFirst.clear();
  bool isAny = false;
  for (std::size_t member = 1; member < this->Shares.size(); ++member)
  {
    const std::vector<std::size_t>& share = this->Shares[member];
    const std::vector<char> bytes = this->Members.Receive(static_cast<int>(member), monitor);
    if (!UnpackCollars(bytes, own.Parts, share, own.Collars))
    {
      this->LargestFirst.insert(this->LargestFirst.end(), share.begin(), share.end());
      continue;
    }
    own.AreHolding[member] = true;
    isAny = isAny || !share.empty();
    for (const std::size_t block : share)
    {
      own.Holders[block] = static_cast<Id>(member);
      own.Meshes[block].Bitten = own.Collars[block].Mesh.Bitten;
    }
  }
  return isAny;
}

// Does all stages for the blocks that did not arrive.
void BlockMesher::MakeMissing(ProblemList& problems, Monitor& monitor)
{
  PartOfStage making(monitor, 1.0, 1.0);
  if (!this->LargestFirst.empty() && !making.HasStopped())
  {
    this->BiteBlocks(making);
  }
  if (!making.HasStopped())
  {
    this->ConcludeBiting(problems);
  }
  if (!this->LargestFirst.empty() && !AddAborted(making, problems) && !problems.HasErrors())
  {
    this->RelaxBlocks(making);
  }
}

// Joins and relaxes the collars. False where the result is not that of the whole.
bool BlockMesher::MendCollars(ProblemList& problems, PartOfStage& part)
{
  KeptBlocks& own = this->Own;
  const bool isAny = this->Collect(part);
  if (!isAny || part.HasStopped())
  {
    return false;
  }
  this->MakeMissing(problems, part);
  if (part.HasStopped() || problems.HasErrors())
  {
    return false;
  }
  this->TakeCollars();
  const double share = this->Expected / static_cast<double>(this->Shares.size());
  if (AreTooLarge(own.Collars, this->GhostLevels > 0 ? share : 0.0, this->MostOfMember))
  {
    return false;
  }
  std::vector<BlockMesh> meshes;
  for (BlockCollar& collar : own.Collars)
  {
    meshes.push_back(std::move(collar.Mesh));
    collar.Mesh = BlockMesh();
  }
  const StripChange change = this->Mend(std::move(meshes), problems, part);
  if (part.HasStopped() || problems.HasErrors() || !change.IsWhole)
  {
    return false;
  }
  own.Numbers = NumberWhole(own.Collars, this->Joined, change);
  own.Owners = OwnersOfTriangles(this->Joined.Triangles, own.Numbers, own.Holders);
  return HasRingsAround(this->Joined.Triangles, own.Owners, this->Joined.Bites.Points.size(),
    this->GhostLevels + RingsBeyond);
}

void BlockMesher::MendWhole(ProblemList& problems, PartOfStage& part)
{
  this->LargestFirst.clear();
  for (std::size_t block = 0; block < this->Own.Meshes.size(); ++block)
  {
    if (this->Own.Meshes[block].Triangles.Corners.empty())
    {
      this->LargestFirst.push_back(block);
    }
  }
  if (this->Members.Size() == 1 || !RefuseMoreThan(this->MostOfMember, this->Expected, problems))
  {
    this->MakeMissing(problems, part);
  }
  if (!AddAborted(part, problems) && !problems.HasErrors())
  {
    this->Mend(std::move(this->Own.Meshes), problems, part);
  }
}

StripChange BlockMesher::Mend(
  std::vector<BlockMesh> meshes, ProblemList& problems, Monitor& monitor)
{
  PartOfStage joining(monitor, 0.0, JoiningEnd);
  Pulse pulse(joining);
  this->Joined = JoinBlocks(this->Geometry, this->Own.Parts, std::move(meshes), pulse);
  if (!pulse.HasStopped() && !this->Joined.IsSound)
  {
    AddProblem(ProblemCode::CheckFailed, "the sides of a cut do not fit", problems);
  }
  if (pulse.HasStopped() || problems.HasErrors())
  {
    return {};
  }
  PartOfStage mending(monitor, JoiningEnd, 1.0);
  return RelaxCuts(this->Geometry, this->Own.Parts.AreTouching, this->F, this->Joined, mending);
}

} // namespace biting
