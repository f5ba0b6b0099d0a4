// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceShells.h"

#include "../../Base/DisjointSets.h"
#include "../../Base/Numbers.h"
#include "NearestOnTriangle.h"
#include "TriangleContact.h" // for MeetRay

#include <algorithm> // for count_if, find, max, min, sort, upper_bound
#include <cstdint>   // for marks
#include <set>       // for pairs
#include <string>    // for figures
#include <utility>   // for swap

namespace biting
{

namespace
{

void Turn(SurfaceMesh& mesh, std::size_t triangle)
{
  std::swap(mesh.Corners[3 * triangle + 1], mesh.Corners[3 * triangle + 2]);
}

// Walks through shells, triangle by triangle.
class ShellSearch
{
public:
  ShellSearch(SurfaceMesh& mesh, const SurfaceLinks& links, SurfaceShells& shells)
    : Mesh(mesh)
    , Links(links)
    , Result(shells)
    , IsTurned(mesh.NumberOfTriangles(), 0)
  {
    shells.ShellOf.assign(mesh.NumberOfTriangles(), NoId);
  }

  void Fill(std::size_t triangle, ProblemList& problems);
  bool TurnAll();

private:
  void Cross(std::size_t slot, SurfaceShell& shell, Problem& twist);

  SurfaceMesh& Mesh;
  const SurfaceLinks& Links;
  SurfaceShells& Result;
  std::vector<std::uint8_t> IsTurned;
  std::vector<Id> Members; ///< of the shell at hand
};

void ShellSearch::Fill(std::size_t triangle, ProblemList& problems)
{
  const Id number = static_cast<Id>(this->Result.Shells.size());
  SurfaceShell shell;
  shell.FirstTriangle = static_cast<Id>(triangle);
  Problem twist{ ProblemCode::NotOrientable, {}, {}, "" };
  this->Members.assign(1, shell.FirstTriangle);
  this->Result.ShellOf[triangle] = number;
  std::size_t next = 0;
  while (next < this->Members.size()) // Cross adds members
  {
    const auto member = static_cast<std::size_t>(this->Members[next++]);
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      this->Cross(3 * member + corner, shell, twist);
    }
  }
  shell.Triangles = static_cast<Id>(this->Members.size());
  if (!shell.IsOrientable)
  {
    problems.Add(twist);
  }
  const auto turned = std::count_if(this->Members.begin(), this->Members.end(),
    [this](Id t) { return this->IsTurned[static_cast<std::size_t>(t)] != 0; });
  if (2 * turned > shell.Triangles)
  {
    for (const Id t : this->Members)
    {
      this->IsTurned[static_cast<std::size_t>(t)] ^= 1u;
    }
  }
  this->Result.Shells.push_back(shell);
}

// Two triangles agree if their orientations differ as often as they were turned against each other.
void ShellSearch::Cross(std::size_t slot, SurfaceShell& shell, Problem& twist)
{
  if (this->Links.Across[slot] < 0)
  {
    shell.IsClosed = false;
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
    twist.Ids = { this->Mesh.Cells[slot / 3], this->Mesh.Cells[next] };
    twist.Place = Midpoint(this->Mesh.At(NextSlotOf(slot)), this->Mesh.At(PreviousSlotOf(slot)));
  }
}

// Returns whether any was turned.
bool ShellSearch::TurnAll()
{
  for (std::size_t t = 0; t < this->IsTurned.size(); ++t)
  {
    if (this->IsTurned[t])
    {
      Turn(this->Mesh, t);
    }
  }
  return std::find(this->IsTurned.begin(), this->IsTurned.end(), 1) != this->IsTurned.end();
}

// Before anything is turned: the first edge of each shell whose triangles are not oriented alike,
// and how many there are.
void TellInconsistent(const SurfaceMesh& mesh, const SurfaceLinks& links,
  const SurfaceShells& shells, ProblemList& problems)
{
  std::vector<Id> first(shells.Shells.size(), NoId);
  std::vector<Id> counts(shells.Shells.size(), 0);
  for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
  {
    const Id other = links.Across[slot];
    if (other > static_cast<Id>(slot) && !AreAlike(mesh, links, slot))
    {
      const auto shell = static_cast<std::size_t>(shells.ShellOf[slot / 3]);
      first[shell] = counts[shell]++ == 0 ? static_cast<Id>(slot) : first[shell];
    }
  }
  for (std::size_t shell = 0; shell < first.size(); ++shell)
  {
    if (counts[shell] > 0)
    {
      const auto slot = static_cast<std::size_t>(first[shell]);
      const auto other = static_cast<std::size_t>(links.Across[slot] / 3);
      problems.Add({ ProblemCode::InconsistentEdges, { mesh.Cells[slot / 3], mesh.Cells[other] },
        Midpoint(mesh.At(NextSlotOf(slot)), mesh.At(PreviousSlotOf(slot))),
        std::to_string(counts[shell]) + " edges" });
    }
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

// How many closed shells that do not cross its own are around the point; NoId where one is nearer
// than the noise.
Id DepthOf(const Point3& p, Id own, const BoxTree<SurfaceItem, 3>& tree, const SurfaceMesh& mesh,
  const SurfaceShells& shells, const ShellPairs& crossing, double noise)
{
  std::vector<Id> met;
  Box3 ray = Box3::Around(p, p);
  ray.Grow(noise);
  ray.High.X = Infinity;
  const bool isClear = tree.AllOf(ray,
    [&p, own, &mesh, &shells, &crossing, noise, &met](const SurfaceItem& item)
    {
      const auto t = static_cast<std::size_t>(item.Triangle);
      const Id shell = shells.ShellOf[t];
      if (shell == own || !shells.IsSolid(t) || crossing.count({ own, shell }) > 0)
      {
        return true;
      }
      if (MeetRay(mesh.Triangle(t), p))
      {
        met.push_back(shell);
      }
      return Distance(p, NearestPoint(mesh.Triangle(t), p)) > noise;
    });
  std::sort(met.begin(), met.end());
  Id depth = 0;
  for (auto first = met.begin(); first != met.end();)
  {
    const auto last = std::upper_bound(first, met.end(), *first);
    depth += static_cast<Id>((last - first) % 2);
    first = last;
  }
  return isClear ? depth : NoId;
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
  if (search.TurnAll())
  {
    links = LinkSurface(mesh, pulse); // the slots of edges have changed
  }
  FindParts(mesh, shells);
  AddVolumes(mesh, shells, pulse);
  return shells;
}

void OrientByNesting(SurfaceMesh& mesh, SurfaceLinks& links, const BoxTree<SurfaceItem, 3>& tree,
  const std::vector<SurfaceContact>& crossings, double noise, SurfaceShells& shells, Pulse& pulse)
{
  ShellPairs crossing;
  for (const SurfaceContact& contact : crossings)
  {
    const Id one = shells.ShellOf[At(contact.First)];
    const Id other = shells.ShellOf[At(contact.Second)];
    crossing.insert({ { one, other }, { other, one } });
  }
  constexpr std::size_t MostTries = 300; // triangles, where shells touch in many places
  const std::vector<std::size_t> farthest = FarthestSlots(mesh, shells);
  std::vector<std::uint8_t> isTurned(shells.Shells.size(), 0);
  for (std::size_t k = 0; k < shells.Shells.size() && pulse.Beat(); ++k)
  {
    SurfaceShell& shell = shells.Shells[k];
    const auto first = static_cast<std::size_t>(shell.FirstTriangle);
    if (!shells.IsSolid(first))
    {
      continue;
    }
    const Id own = static_cast<Id>(k);
    shell.Depth = DepthOf(mesh.At(farthest[k]), own, tree, mesh, shells, crossing, noise);
    const std::size_t end =
      std::min(mesh.NumberOfTriangles(), shell.Depth == NoId ? first + MostTries : 0);
    for (std::size_t t = first; t < end; ++t)
    {
      const Id depth = shells.ShellOf[t] == own
        ? DepthOf(mesh.Middle(t), own, tree, mesh, shells, crossing, noise)
        : NoId;
      const bool isLess = depth != NoId && (shell.Depth == NoId || depth < shell.Depth);
      shell.Depth = isLess ? depth : shell.Depth; // of shells that overlap, flush: the least
    }
    shell.Depth = std::max(shell.Depth, Id{ 0 });
    isTurned[k] = (shell.Volume < 0.0) == (shell.Depth % 2 == 0) && shell.Volume != 0.0 ? 1 : 0;
    shell.Volume = isTurned[k] ? -shell.Volume : shell.Volume;
  }
  for (std::size_t t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    if (isTurned[static_cast<std::size_t>(shells.ShellOf[t])])
    {
      Turn(mesh, t);
    }
  }
  if (std::find(isTurned.begin(), isTurned.end(), 1) != isTurned.end())
  {
    links = LinkSurface(mesh, pulse);
  }
}

} // namespace biting
