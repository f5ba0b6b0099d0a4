// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceRepair.h"

#include "../../Predicates/Predicates.h"
#include "PlaceTable.h"

#include <algorithm> // for fill_n, max, sort
#include <cstdint>   // for marks

namespace biting
{

namespace
{

// Keeps the triangles that are not marked, in their order.
void Remove(SurfaceMesh& mesh, const std::vector<std::uint8_t>& isGone)
{
  std::size_t kept = 0;
  for (std::size_t t = 0; t < isGone.size(); ++t)
  {
    if (!isGone[t])
    {
      mesh.CopyTriangle(t, kept++);
    }
  }
  mesh.Resize(kept);
}

// The triangle that stays bounds the region of its double, too.
void AddRegion(SurfaceMesh& mesh, std::size_t from, std::size_t to)
{
  if (!mesh.Regions.empty() && mesh.Regions[to][1] == NoId &&
    mesh.Regions[from][0] != mesh.Regions[to][0])
  {
    mesh.Regions[to][1] = mesh.Regions[from][0];
  }
}

// Whether three points lie on one line: their shadows along all axes do.
bool IsFlat(const std::array<Point3, 3>& p)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t x = (axis + 1) % 3;
    const std::size_t y = (axis + 2) % 3;
    if (Orient2D({ p[0][x], p[0][y] }, { p[1][x], p[1][y] }, { p[2][x], p[2][y] }) != 0)
    {
      return false;
    }
  }
  return true;
}

// Flips flat triangles away.
class FlatFlips
{
public:
  FlatFlips(SurfaceMesh& mesh, SurfaceLinks& links)
    : Mesh(mesh)
    , Links(links)
    , IsGone(mesh.NumberOfTriangles(), 0)
  {
  }

  // Whether the flat triangle t went, or has shorter sides now.
  bool Improve(std::size_t t);

  // Whether the thin triangle t, which is new, was flipped.
  bool Absorb(std::size_t t, std::vector<std::uint8_t>& isNew);

  const std::vector<std::uint8_t>& Gone() const { return this->IsGone; }

private:
  std::size_t MiddleSlot(std::size_t t) const;
  bool IsBetween(std::size_t slot, std::size_t from, std::size_t to) const;
  bool HasEdge(std::size_t corner, Id vertex) const;
  void Flip(std::size_t middle, std::size_t across);
  void Join(std::size_t slot, Id other);

  SurfaceMesh& Mesh;
  SurfaceLinks& Links;
  std::vector<std::uint8_t> IsGone;
};

bool FlatFlips::IsBetween(std::size_t slot, std::size_t from, std::size_t to) const
{
  const Point3& b = this->Mesh.At(slot);
  const Point3& a = this->Mesh.At(from);
  const Point3& c = this->Mesh.At(to);
  return (a < b && b < c) || (c < b && b < a); // along a line the lexicographic order is the line's
}

std::size_t FlatFlips::MiddleSlot(std::size_t t) const
{
  std::size_t slot = 3 * t;
  while (slot < 3 * t + 2 && !this->IsBetween(slot, NextSlotOf(slot), PreviousSlotOf(slot)))
  {
    ++slot;
  }
  return slot;
}

// Whether the fan of the vertex at `corner` has an edge to the other vertex.
bool FlatFlips::HasEdge(std::size_t corner, Id vertex) const
{
  bool has = false;
  const auto look = [this, &has, vertex](std::size_t slot)
  {
    has = has || this->Mesh.Corners[NextSlotOf(slot)] == vertex ||
      this->Mesh.Corners[PreviousSlotOf(slot)] == vertex;
  };
  const Id own = this->Mesh.Corners[corner];
  const Id end = WalkFan(this->Mesh, this->Links, own, static_cast<Id>(NextSlotOf(corner)), look);
  if (end != NoId)
  {
    WalkFan(this->Mesh, this->Links, own, end, look);
  }
  return has;
}

bool FlatFlips::Improve(std::size_t t)
{
  const std::size_t middle = this->MiddleSlot(t);
  const Id across = this->Links.Across[middle];
  if (across == OpenEdge)
  {
    this->IsGone[t] = 1;
    for (const std::size_t slot : { NextSlotOf(middle), PreviousSlotOf(middle) })
    {
      if (this->Links.Across[slot] >= 0)
      {
        this->Links.Across[static_cast<std::size_t>(this->Links.Across[slot])] = OpenEdge;
      }
    }
    return true;
  }
  if (across == CrowdedEdge)
  {
    return false;
  }
  const auto apex = static_cast<std::size_t>(across);
  const bool isFlat = IsFlat(this->Mesh.Triangle(apex / 3));
  const bool isLower = !isFlat || this->IsBetween(apex, NextSlotOf(apex), PreviousSlotOf(apex));
  if (!isLower || this->HasEdge(middle, this->Mesh.Corners[apex]))
  {
    return false;
  }
  this->Flip(middle, apex);
  return true;
}

bool FlatFlips::Absorb(std::size_t t, std::vector<std::uint8_t>& isNew)
{
  constexpr double Thin = 0.1; // of the longest side: how high a thin triangle is
  std::size_t slot = 3 * t;
  double longest = 0.0;
  for (std::size_t k = 3 * t; k < 3 * t + 3; ++k)
  {
    const double length = Distance(this->Mesh.At(NextSlotOf(k)), this->Mesh.At(PreviousSlotOf(k)));
    slot = length > longest ? k : slot;
    longest = std::max(length, longest);
  }
  const Id across = this->Links.Across[slot];
  if (across < 0 || Length(this->Mesh.Normal(t)) >= Thin * longest * longest)
  {
    return false;
  }
  const bool isOld = isNew[At(across) / 3] == 0;
  if ((!isOld && Distance(this->Mesh.At(slot), this->Mesh.At(At(across))) >= longest) ||
    this->HasEdge(slot, this->Mesh.Corners[At(across)]))
  {
    return false;
  }
  this->Flip(slot, At(across));
  isNew[t] = isOld ? 0 : 1;
  return true;
}

// Both triangles take over the corners of that across, one in each half.
void FlatFlips::Flip(std::size_t middle, std::size_t across)
{
  std::vector<Id>& corners = this->Mesh.Corners;
  const std::vector<Id>& links = this->Links.Across;
  const std::size_t shift = 3 * (middle / 3);
  const std::size_t base = 3 * (across / 3);
  const std::size_t p = NextSlotOf(across);
  const std::size_t q = PreviousSlotOf(across);
  const Id b = corners[middle];
  const bool isTurned = corners[NextSlotOf(middle)] == corners[p];
  const std::size_t slotOfP = isTurned ? NextSlotOf(middle) : PreviousSlotOf(middle);
  const std::size_t slotOfQ = isTurned ? PreviousSlotOf(middle) : NextSlotOf(middle);
  const Id beyondBP = links[slotOfQ];
  const Id beyondBQ = links[slotOfP];
  const Id beyondDP = links[q];
  const auto inOther = [shift, base](std::size_t slot) { return shift + slot - base; };
  this->Mesh.CopyTriangle(across / 3, middle / 3);
  corners[p] = b;          // (b, q, d)
  corners[inOther(q)] = b; // (p, b, d)
  this->Join(across, beyondBQ);
  this->Join(inOther(across), beyondBP);
  this->Join(inOther(q), beyondDP);
  this->Join(q, static_cast<Id>(inOther(p)));
}

void FlatFlips::Join(std::size_t slot, Id other)
{
  this->Links.Across[slot] = other;
  if (other >= 0)
  {
    this->Links.Across[static_cast<std::size_t>(other)] = static_cast<Id>(slot);
  }
}

} // namespace

void RemoveDuplicates(SurfaceMesh& mesh, ProblemList& problems, Pulse& pulse)
{
  std::vector<std::uint8_t> isGone(mesh.NumberOfTriangles(), 0);
  PlaceTable table(isGone.size());
  pulse.ForEach(isGone.size(),
    [&mesh, &problems, &isGone, &table](std::size_t t)
    {
      PlaceTable::Key key{ mesh.Corners[3 * t], mesh.Corners[3 * t + 1], mesh.Corners[3 * t + 2] };
      std::sort(key.begin(), key.end());
      const Id first = table.Find(key, [](Id) { return true; });
      if (first == NoId)
      {
        table.Add(key, static_cast<Id>(t));
        return;
      }
      isGone[t] = 1;
      AddRegion(mesh, t, At(first));
      problems.Add({ ProblemCode::DuplicateTriangles, { mesh.Cells[t], mesh.Cells[At(first)] },
        mesh.Middle(t), "" });
    });
  if (problems.Has(ProblemCode::DuplicateTriangles))
  {
    Remove(mesh, isGone);
  }
}

void RemoveFlatTriangles(
  SurfaceMesh& mesh, SurfaceLinks& links, ProblemList& problems, Pulse& pulse)
{
  std::vector<std::size_t> flat;
  pulse.ForEach(mesh.NumberOfTriangles(),
    [&mesh, &flat](std::size_t t)
    {
      if (IsFlat(mesh.Triangle(t)))
      {
        flat.push_back(t);
      }
    });
  if (flat.empty())
  {
    return;
  }
  std::vector<Problem> told;
  told.reserve(flat.size());
  for (const std::size_t t : flat)
  {
    told.push_back({ ProblemCode::FlatTriangles, { mesh.Cells[t] }, mesh.Middle(t), "" });
  }
  FlatFlips flips(mesh, links);
  bool isChanged = true;
  while (isChanged && pulse.Ask())
  {
    isChanged = false;
    for (const std::size_t t : flat)
    {
      const bool isLeft = flips.Gone()[t] == 0 && IsFlat(mesh.Triangle(t));
      isChanged = (isLeft && flips.Improve(t)) || isChanged;
    }
  }
  for (std::size_t k = 0; k < flat.size(); ++k)
  {
    const bool isLeft = flips.Gone()[flat[k]] == 0 && IsFlat(mesh.Triangle(flat[k]));
    told[k].Detail = isLeft ? "it stays: no edge flip removes it" : "";
    problems.Add(told[k]);
  }
  Remove(mesh, flips.Gone());
  links = LinkSurface(mesh, pulse);
}

void FlipThinTriangles(SurfaceMesh& mesh, SurfaceLinks& links, std::size_t first, Pulse& pulse)
{
  FlatFlips flips(mesh, links);
  std::vector<std::uint8_t> isNew(mesh.NumberOfTriangles(), 1);
  std::fill_n(isNew.begin(), first, std::uint8_t{ 0 });
  bool isChanged = first < isNew.size();
  while (isChanged && pulse.Ask())
  {
    isChanged = false;
    for (std::size_t t = first; t < isNew.size(); ++t)
    {
      isChanged = (isNew[t] != 0 && flips.Absorb(t, isNew)) || isChanged;
    }
  }
  links = LinkSurface(mesh, pulse);
}

} // namespace biting
