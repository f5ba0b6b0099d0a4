// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceShells.h"

#include "../../Base/DisjointSets.h"
#include "../../Base/Numbers.h"
#include "NearestOnTriangle.h"
#include "TriangleContact.h" // for MeetRay

#include <algorithm> // for count_if, max
#include <cstdint>   // for marks
#include <map>       // for sums of shells
#include <set>       // for pairs
#include <string>    // for figures
#include <utility>   // for swap

namespace biting
{

namespace
{

// Turns the triangles that isTurned(t); links follow.
template <typename Question>
void Turn(SurfaceMesh& mesh, SurfaceLinks& links, const Question& isTurned, Pulse& pulse)
{
  bool isAny = false;
  for (std::size_t t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    if (isTurned(t))
    {
      isAny = true;
      std::swap(mesh.Corners[3 * t + 1], mesh.Corners[3 * t + 2]);
    }
  }
  if (isAny)
  {
    links = LinkSurface(mesh, pulse); // the slots of edges have changed
  }
}

// Walks through shells, triangle by triangle.
class ShellSearch
{
public:
  ShellSearch(SurfaceMesh& mesh, const SurfaceLinks& links, SurfaceShells& shells)
    : IsTurned(mesh.NumberOfTriangles(), 0)
    , Mesh(mesh)
    , Links(links)
    , Result(shells)
  {
    shells.ShellOf.assign(mesh.NumberOfTriangles(), NoId);
  }

  void Fill(std::size_t triangle, ProblemList& problems);

  std::vector<std::uint8_t> IsTurned; ///< of triangles

private:
  void Cross(std::size_t slot, SurfaceShell& shell, Problem& twist);

  SurfaceMesh& Mesh;
  const SurfaceLinks& Links;
  SurfaceShells& Result;
  std::vector<Id> Members; ///< of the shell at hand
};

void ShellSearch::Fill(std::size_t triangle, ProblemList& problems)
{
  SurfaceShell shell;
  shell.FirstTriangle = static_cast<Id>(triangle);
  Problem twist{ ProblemCode::NotOrientable, {}, {}, "" };
  this->Members.assign(1, shell.FirstTriangle);
  this->Result.ShellOf[triangle] = static_cast<Id>(this->Result.Shells.size());
  for (; At(shell.Triangles) < this->Members.size(); ++shell.Triangles) // Cross adds members
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      this->Cross(3 * At(this->Members[At(shell.Triangles)]) + corner, shell, twist);
    }
  }
  if (!shell.IsOrientable)
  {
    problems.Add(twist);
  }
  const auto turned = std::count_if(this->Members.begin(), this->Members.end(),
    [this](Id t) { return this->IsTurned[At(t)] != 0; });
  for (const Id t : this->Members)
  {
    this->IsTurned[At(t)] ^= 2 * turned > shell.Triangles ? 1u : 0u;
  }
  this->Result.Shells.push_back(shell);
}

// Two triangles agree if their orientations differ as often as they were turned against each other.
void ShellSearch::Cross(std::size_t slot, SurfaceShell& shell, Problem& twist)
{
  if (this->Links.Across[slot] < 0)
  {
    shell.IsClosed = false;
    shell.IsBounding = shell.IsBounding && this->Links.Across[slot] == CrowdedEdge;
    return;
  }
  const auto next = static_cast<std::size_t>(this->Links.Across[slot] / 3);
  const std::uint8_t turned = AreAlike(this->Mesh, this->Links, slot) ? 0 : 1;
  const std::uint8_t wanted = this->IsTurned[slot / 3] ^ turned;
  if (this->Result.ShellOf[next] == NoId)
  {
    this->Result.ShellOf[next] = this->Result.ShellOf[slot / 3];
    this->IsTurned[next] = wanted;
    this->Members.push_back(static_cast<Id>(next));
  }
  else if (this->IsTurned[next] != wanted && shell.IsOrientable)
  {
    shell.IsOrientable = false;
    shell.IsBounding = false;
    twist.Ids = { this->Mesh.Cells[slot / 3], this->Mesh.Cells[next] };
    twist.Place = Midpoint(this->Mesh.At(NextSlotOf(slot)), this->Mesh.At(PreviousSlotOf(slot)));
  }
}

// Before anything is turned: the first edge of each shell whose triangles are not oriented alike,
// and how many there are.
void TellInconsistent(const SurfaceMesh& mesh, const SurfaceLinks& links,
  const SurfaceShells& shells, ProblemList& problems)
{
  std::map<Id, std::vector<std::size_t>> slotsOf; // of shells
  for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
  {
    if (links.Across[slot] > static_cast<Id>(slot) && !AreAlike(mesh, links, slot))
    {
      slotsOf[shells.ShellOf[slot / 3]].push_back(slot);
    }
  }
  for (const auto& [shell, slots] : slotsOf)
  {
    const std::size_t slot = slots.front();
    const std::size_t other = At(links.Across[slot] / 3);
    problems.Add({ ProblemCode::InconsistentEdges, { mesh.Cells[slot / 3], mesh.Cells[other] },
      Midpoint(mesh.At(NextSlotOf(slot)), mesh.At(PreviousSlotOf(slot))),
      std::to_string(slots.size()) + " edges" });
  }
}

// At edges of more than two triangles, by the orientation of these.
void FindBounding(const SurfaceMesh& mesh, const SurfaceLinks& links, SurfaceShells& shells)
{
  for (std::size_t edge = 0; edge < links.NumberOfCrowded(); ++edge)
  {
    std::map<Id, Id> turns; // of shells: how many more run along the edge than against it
    Id all = 0;
    for (Id k = links.CrowdedOffsets[edge]; k < links.CrowdedOffsets[edge + 1]; ++k)
    {
      const std::size_t slot = At(links.CrowdedSlots[At(k)]);
      const Id turn = mesh.Corners[NextSlotOf(slot)] == EndsOf(mesh, slot).first ? 1 : -1;
      turns[shells.ShellOf[slot / 3]] += turn;
      all += turn;
    }
    for (const auto& [shell, sum] : turns)
    {
      shells.Shells[At(shell)].IsBounding = shells.Shells[At(shell)].IsBounding && sum == 0;
    }
    shells.AreBalanced = shells.AreBalanced && all == 0;
  }
}

void FindParts(const SurfaceMesh& mesh, SurfaceShells& shells)
{
  DisjointSets sets(mesh.Points.size());
  for (std::size_t t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    sets.Unite(sets.Unite(mesh.Corners[3 * t], mesh.Corners[3 * t + 1]), mesh.Corners[3 * t + 2]);
  }
  std::vector<Id> numbers(mesh.Points.size(), NoId);
  shells.RegionOf.resize(mesh.NumberOfTriangles());
  for (std::size_t t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    Id& number = numbers[static_cast<std::size_t>(sets.SetOf(mesh.Corners[3 * t]))];
    number = number == NoId ? shells.NumberOfParts++ : number;
    shells.RegionOf[t] = number;
  }
}

// Pairs of shells, in both orders.
using ShellPairs = std::set<std::pair<Id, Id>>;

// How many bounding shells that do not cross its own are around the point; NoId where one is nearer
// than the noise.
Id DepthOf(const Point3& p, Id own, const BoxTree<SurfaceItem, 3>& tree, const SurfaceMesh& mesh,
  const SurfaceShells& shells, const ShellPairs& crossing, double noise)
{
  std::set<Id> around; // met an odd number of times
  Box3 ray = Box3::Around(p, p);
  ray.Grow(noise);
  ray.High.X = Infinity;
  const bool isClear = tree.AllOf(ray,
    [&p, own, &mesh, &shells, &crossing, noise, &around](const SurfaceItem& item)
    {
      const auto t = static_cast<std::size_t>(item.Triangle);
      const Id shell = shells.ShellOf[t];
      if (shell == own || !shells.Of(t).IsBounding || crossing.count({ own, shell }) > 0)
      {
        return true;
      }
      if (MeetRay(mesh.Triangle(t), p) && !around.insert(shell).second)
      {
        around.erase(shell);
      }
      return Distance(p, NearestPoint(mesh.Triangle(t), p)) > noise;
    });
  return isClear ? static_cast<Id>(around.size()) : NoId;
}

// Of each shell the corner farthest along x: the ray from there is short.
std::vector<std::size_t> FarthestSlots(const SurfaceMesh& mesh, const SurfaceShells& shells)
{
  std::vector<std::size_t> slots(shells.Shells.size(), mesh.Corners.size());
  for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
  {
    std::size_t& best = slots[static_cast<std::size_t>(shells.ShellOf[slot / 3])];
    best = best == mesh.Corners.size() || mesh.At(best).X < mesh.At(slot).X ? slot : best;
  }
  return slots;
}

void AddVolumes(const SurfaceMesh& mesh, SurfaceShells& shells, Pulse& pulse)
{
  const Point3 center = mesh.Bounds().Center();
  pulse.ForEach(mesh.NumberOfTriangles(),
    [&mesh, &shells, &center](std::size_t t)
    {
      const double volume = Dot(mesh.At(3 * t) - center, mesh.Normal(t)) / 6.0;
      shells.Shells[static_cast<std::size_t>(shells.ShellOf[t])].Volume += volume;
    });
}

} // namespace

SurfaceShells FindShells(
  SurfaceMesh& mesh, SurfaceLinks& links, ProblemList& problems, Pulse& pulse)
{
  SurfaceShells shells;
  ShellSearch search(mesh, links, shells);
  pulse.ForEach(mesh.NumberOfTriangles(),
    [&shells, &search, &problems](std::size_t t)
    {
      if (shells.ShellOf[t] == NoId)
      {
        search.Fill(t, problems);
      }
    });
  if (pulse.HasStopped())
  {
    return shells;
  }
  TellInconsistent(mesh, links, shells, problems);
  Turn(
    mesh, links, [&search](std::size_t t) { return search.IsTurned[t] != 0; }, pulse);
  FindBounding(mesh, links, shells);
  FindParts(mesh, shells);
  AddVolumes(mesh, shells, pulse);
  return shells;
}

void OrientByNesting(SurfaceMesh& mesh, SurfaceLinks& links, const BoxTree<SurfaceItem, 3>& tree,
  const std::vector<SurfaceContact>& crossings, const std::vector<SurfaceContact>& touches,
  double noise, SurfaceShells& shells, Pulse& pulse)
{
  ShellPairs crossing;
  for (const SurfaceContact& contact : crossings)
  {
    const Id one = shells.ShellOf[At(contact.First)];
    const Id other = shells.ShellOf[At(contact.Second)];
    crossing.insert({ { one, other }, { other, one } });
  }
  std::set<Id> touching; // shells
  for (const SurfaceContact& touch : touches)
  {
    touching.insert({ shells.ShellOf[At(touch.First)], shells.ShellOf[At(touch.Second)] });
  }
  const std::vector<std::size_t> farthest = FarthestSlots(mesh, shells);
  std::vector<std::uint8_t> isTurned(shells.Shells.size(), 0);
  for (std::size_t k = 0; k < shells.Shells.size() && pulse.Beat(); ++k)
  {
    SurfaceShell& shell = shells.Shells[k];
    if (!shell.IsBounding)
    {
      continue;
    }
    const Id own = static_cast<Id>(k);
    shell.Depth = DepthOf(mesh.At(farthest[k]), own, tree, mesh, shells, crossing, noise);
    Id left = shell.Depth == NoId || touching.count(own) > 0 ? shell.Triangles : 0;
    for (std::size_t t = At(shell.FirstTriangle); left > 0 && shell.Depth != 0 && pulse.Beat(); ++t)
    {
      const bool isOwn = shells.ShellOf[t] == own;
      const Id depth =
        isOwn ? DepthOf(mesh.Middle(t), own, tree, mesh, shells, crossing, noise) : NoId;
      left -= isOwn ? 1 : 0;
      const bool isLess = depth != NoId && (shell.Depth == NoId || depth < shell.Depth);
      shell.Depth = isLess ? depth : shell.Depth; // of shells that overlap, flush: the least
    }
    shell.Depth = std::max(shell.Depth, Id{ 0 });
    isTurned[k] = (shell.Volume < 0.0) == (shell.Depth % 2 == 0) && shell.Volume != 0.0 ? 1 : 0;
    shell.Volume = isTurned[k] ? -shell.Volume : shell.Volume;
  }
  Turn(
    mesh, links,
    [&shells, &isTurned](std::size_t t) { return isTurned[At(shells.ShellOf[t])] != 0; }, pulse);
}

} // namespace biting
