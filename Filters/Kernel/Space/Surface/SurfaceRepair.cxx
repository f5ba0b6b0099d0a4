// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceRepair.h"

#include "../../Predicates/Predicates.h"

#include <algorithm> // for find_if, is_permutation, min_element
#include <cmath>     // for abs
#include <cstdint>   // for marks
#include <numeric>   // for iota

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
  // `flat`: the triangles that are to go.
  FlatFlips(SurfaceMesh& mesh, SurfaceLinks& links, const std::vector<std::size_t>& flat)
    : Mesh(mesh)
    , Links(links)
    , Flat(flat)
    , IsFlat(mesh.NumberOfTriangles(), 0)
    , IsGone(mesh.NumberOfTriangles(), 0)
  {
    for (const std::size_t t : flat)
    {
      this->IsFlat[t] = 1;
    }
  }

  void Run(Pulse& pulse)
  {
    bool isChanged = true;
    while (isChanged && pulse.Ask())
    {
      isChanged = false;
      for (const std::size_t t : this->Flat)
      {
        isChanged = (this->IsLeft(t) && this->Improve(t)) || isChanged;
      }
    }
  }

  bool IsLeft(std::size_t t) const { return this->IsFlat[t] != 0 && this->IsGone[t] == 0; }

  const std::vector<std::uint8_t>& Gone() const { return this->IsGone; }

private:
  bool Improve(std::size_t t);
  std::size_t MiddleSlot(std::size_t t) const;
  void Leave(std::size_t middle);
  bool KeepsSides(std::size_t middle, std::size_t across) const;
  bool HasEdge(std::size_t corner, Id vertex) const;
  void Flip(std::size_t middle, std::size_t across);
  void Join(std::size_t slot, Id other);

  SurfaceMesh& Mesh;
  SurfaceLinks& Links;
  const std::vector<std::size_t>& Flat;
  std::vector<std::uint8_t> IsFlat; ///< of triangles: it is still one of those
  std::vector<std::uint8_t> IsGone;
};

// Whether the fan of the vertex at `corner` has an edge to the other vertex, or is of that.
bool FlatFlips::HasEdge(std::size_t corner, Id vertex) const
{
  bool has = this->Mesh.Corners[corner] == vertex;
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

// Opposite the longest side; where two are equal but for rounding, of the vertex that is between
// the others along a line: in lexicographic order.
std::size_t FlatFlips::MiddleSlot(std::size_t t) const
{
  constexpr double Slack = 1.0 + 1e-14;
  std::size_t middle = 3 * t;
  double longest = 0.0;
  for (std::size_t slot = 3 * t; slot < 3 * t + 3; ++slot)
  {
    const Point3& a = this->Mesh.At(NextSlotOf(slot));
    const Point3& b = this->Mesh.At(slot);
    const Point3& c = this->Mesh.At(PreviousSlotOf(slot));
    const double length = Distance(a, c);
    const bool isBetween = (a < b && b < c) || (c < b && b < a);
    const bool isLonger = length > Slack * longest || (isBetween && Slack * length >= longest);
    middle = isLonger ? slot : middle;
    longest = isLonger ? length : longest;
  }
  return middle;
}

// Whether the triangle went, or is no longer flat, or has shorter sides now.
bool FlatFlips::Improve(std::size_t t)
{
  constexpr double Thin = 0.1; // the height at most, of the longest side
  const std::size_t middle = this->MiddleSlot(t);
  const double longest =
    Distance(this->Mesh.At(NextSlotOf(middle)), this->Mesh.At(PreviousSlotOf(middle)));
  const Id across = this->Links.Across[middle];
  if (across == CrowdedEdge || Length(this->Mesh.Normal(t)) >= Thin * longest * longest)
  {
    return false;
  }
  if (across == OpenEdge)
  {
    this->Leave(middle);
    return true;
  }
  const bool isFlat = this->IsFlat[At(across) / 3] != 0;
  const bool isBetter = isFlat
    ? Distance(this->Mesh.At(middle), this->Mesh.At(At(across))) < longest
    : this->KeepsSides(middle, At(across));
  if (!isBetter || this->HasEdge(middle, this->Mesh.Corners[At(across)]))
  {
    return false;
  }
  this->Flip(middle, At(across));
  this->IsFlat[t] = isFlat ? 1 : 0;
  return true;
}

// Whether the halves of the triangle of `across` look as it does, and lie near its plane.
bool FlatFlips::KeepsSides(std::size_t middle, std::size_t across) const
{
  constexpr double Bend = 0.04; // of the edge: arcs of 15 degrees are .033 from their chords
  const Point3 normal = this->Mesh.Normal(across / 3);
  const Point3 way = this->Mesh.At(across) - this->Mesh.At(middle);
  const Point3 next = this->Mesh.At(NextSlotOf(across)) - this->Mesh.At(middle);
  const Point3 previous = this->Mesh.At(PreviousSlotOf(across)) - this->Mesh.At(middle);
  return Dot(Cross(next, way), normal) <= 0.0 && Dot(Cross(previous, way), normal) >= 0.0 &&
    std::abs(Dot(next, normal)) <= Bend * Length(normal) * Distance(next, previous);
}

// The triangle goes; its side opposite `middle` is open.
void FlatFlips::Leave(std::size_t middle)
{
  this->IsGone[middle / 3] = 1;
  for (const std::size_t slot : { NextSlotOf(middle), PreviousSlotOf(middle) })
  {
    if (this->Links.Across[slot] >= 0)
    {
      this->Links.Across[At(this->Links.Across[slot])] = OpenEdge;
    }
  }
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
  const IdLists slotsAt = CornersOfVertices(mesh);
  pulse.ForEach(isGone.size(),
    [&mesh, &problems, &isGone, &slotsAt](std::size_t t)
    {
      const Id* const corners = &mesh.Corners[3 * t];
      const Id fewest = *std::min_element(corners, corners + 3,
        [&slotsAt](Id a, Id b) { return slotsAt[a].Size() < slotsAt[b].Size(); });
      const IdLists::List slots = slotsAt[fewest];
      const Id first = *std::find_if(slots.begin(), slots.end(),
                         [&mesh, corners](Id slot)
                         {
                           const Id* const others = &mesh.Corners[At(slot - slot % 3)];
                           return std::is_permutation(corners, corners + 3, others);
                         }) /
        3;
      if (At(first) < t)
      {
        isGone[t] = 1;
        AddRegion(mesh, t, At(first));
        problems.Add({ ProblemCode::DuplicateTriangles, { mesh.Cells[t], mesh.Cells[At(first)] },
          mesh.Middle(t), "" });
      }
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
  FlatFlips flips(mesh, links, flat);
  flips.Run(pulse);
  for (std::size_t k = 0; k < flat.size(); ++k)
  {
    told[k].Detail = flips.IsLeft(flat[k]) ? "it stays: no edge flip removes it" : "";
    problems.Add(told[k]);
  }
  Remove(mesh, flips.Gone());
  links = LinkSurface(mesh, pulse);
}

void FlipThinTriangles(SurfaceMesh& mesh, SurfaceLinks& links, std::size_t first, Pulse& pulse)
{
  std::vector<std::size_t> thin(mesh.NumberOfTriangles() - first);
  std::iota(thin.begin(), thin.end(), first);
  FlatFlips(mesh, links, thin).Run(pulse);
  links = LinkSurface(mesh, pulse);
}

} // namespace biting
