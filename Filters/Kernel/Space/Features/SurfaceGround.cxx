// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceGround.h"

#include "../../Base/SortInSteps.h"
#include "../../Base/Tasks.h"
#include "../Surface/SurfaceLinks.h"

#include <algorithm>  // for count, min, minmax, rotate
#include <array>      // for triangles
#include <functional> // for less
#include <utility>    // for pairs, move

namespace biting
{

namespace
{

/// An edge that is to be halved, by its ends, the lower first; and a slot of it.
using LongSlot = std::pair<std::pair<Id, Id>, std::size_t>;

std::vector<LongSlot> FindLongSlots(const SurfaceGround& ground, Pulse& pulse)
{
  std::vector<LongSlot> slots;
  slots.reserve(ground.Mesh.Corners.size() / 4);
  for (std::size_t slot = 0; slot < ground.Mesh.Corners.size(); ++slot)
  {
    const auto [low, high] =
      std::minmax(ground.Mesh.Corners[NextSlotOf(slot)], ground.Mesh.Corners[PreviousSlotOf(slot)]);
    const double most = LongestEdge * std::min(ground.Sizes[At(low)], ground.Sizes[At(high)]);
    if (Distance(ground.Mesh.Points[At(low)], ground.Mesh.Points[At(high)]) > most)
    {
      slots.push_back({ { low, high }, slot });
    }
  }
  SortInSteps(slots, std::less<>(), pulse);
  return slots;
}

/// Whether the way a, b, c turns to the left by more than half a degree, as seen from the normal.
bool TurnsLeft(const Point3& a, const Point3& b, const Point3& c, const Point3& normal)
{
  constexpr double LeastSine = 0.01;
  const Point3 in = b - a;
  const Point3 out = c - b;
  return Dot(Cross(in, out), normal) > LeastSine * Length(in) * Length(out) * Length(normal);
}

/// Marks the long slots in `middles`, but no diagonal of a quad of which two opposite sides are
/// long and nothing else: it is halved by the line between the middles of these. Else strips would
/// be divided across, too: k rounds would make 3^k triangles of a needle, not 2^k.
/// Returns for triangles of such quads the slot of the diagonal in the other one, else NoId.
std::vector<Id> FindQuads(
  const SurfaceGround& ground, const std::vector<LongSlot>& slots, std::vector<Id>& middles)
{
  const SurfaceMesh& mesh = ground.Mesh;
  std::vector<Id> quads(mesh.NumberOfTriangles(), NoId);
  middles.assign(mesh.Corners.size(), NoId);
  for (const LongSlot& slot : slots)
  {
    middles[slot.second] = 0;
  }
  const auto isLong = [&middles](std::size_t slot) { return middles[slot] != NoId; };
  const auto hasTwo = [&isLong](std::size_t slot)
  { return isLong(NextSlotOf(slot)) != isLong(PreviousSlotOf(slot)); };
  for (std::size_t k = 1; k < slots.size(); ++k)
  {
    const std::size_t own = slots[k - 1].second;
    const std::size_t other = slots[k].second;
    if (slots[k].first == slots[k - 1].first && mesh.Cells[own / 3] == mesh.Cells[other / 3] &&
      quads[own / 3] == NoId && quads[other / 3] == NoId && hasTwo(own) && hasTwo(other) &&
      isLong(NextSlotOf(own)) == isLong(NextSlotOf(other)) &&
      TurnsLeft(mesh.At(own), mesh.At(NextSlotOf(own)), mesh.At(other), mesh.Normal(own / 3)) &&
      TurnsLeft(mesh.At(other), mesh.At(NextSlotOf(other)), mesh.At(own), mesh.Normal(own / 3)))
    {
      quads[own / 3] = static_cast<Id>(other);
      quads[other / 3] = static_cast<Id>(own);
      middles[own] = NoId;
      middles[other] = NoId;
    }
  }
  return quads;
}

/// Makes the triangles of a round of halving.
class Halving
{
public:
  Halving(SurfaceGround& ground, const std::vector<Id>& middles, const std::vector<Id>& quads)
    : Ground(ground)
    , Middles(middles)
    , Quads(quads)
  {
    const auto kept = std::count(middles.begin(), middles.end(), NoId);
    const std::size_t triangles = middles.size() / 3 + middles.size() - At(kept);
    this->Corners.reserve(3 * triangles);
    this->Flags.reserve(3 * triangles);
    this->Cells.reserve(triangles);
  }

  void Divide(std::size_t triangle)
  {
    const Id other = this->Quads[triangle];
    if (other == NoId)
    {
      this->DivideTriangle(triangle);
    }
    else if (At(other) > 3 * triangle)
    {
      const Id own = this->Quads[At(other) / 3];
      this->DivideQuad(At(own), At(other));
    }
  }

  void Finish()
  {
    this->Ground.Mesh.Corners = std::move(this->Corners);
    this->Ground.Mesh.Cells = std::move(this->Cells);
    this->Ground.Flags = std::move(this->Flags);
  }

private:
  void DivideTriangle(std::size_t triangle)
  {
    const std::size_t base = 3 * triangle;
    std::size_t turn = 0;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      count += this->Middles[base + k] != NoId ? 1 : 0;
      turn = this->Side2(base + k) > this->Side2(base + turn) ? k : turn;
    }
    // The longest of three long edges comes first, one long edge, too, or one that is not of two.
    while (count % 3 != 0 && (this->Middles[base + turn] != NoId) != (count == 1))
    {
      turn = (turn + 1) % 3;
    }
    const std::array<std::size_t, 3> slot{ base + turn, base + (turn + 1) % 3,
      base + (turn + 2) % 3 };
    const auto corner = [this, &slot](std::size_t k) { return this->Ground.Mesh.Corners[slot[k]]; };
    const auto flag = [this, &slot](std::size_t k) { return this->Ground.Flags[slot[k]]; };
    const auto middle = [this, &slot](std::size_t k) { return this->Middles[slot[k]]; };
    const Id cell = this->Ground.Mesh.Cells[triangle];
    if (count == 0)
    {
      this->Add({ corner(0), corner(1), corner(2) }, { flag(0), flag(1), flag(2) }, cell);
    }
    else if (count == 1)
    {
      this->Add({ corner(0), corner(1), middle(0) }, { flag(0), 0, flag(2) }, cell);
      this->Add({ corner(0), middle(0), corner(2) }, { flag(0), flag(1), 0 }, cell);
    }
    else if (count == 2)
    {
      this->Add({ corner(0), middle(2), middle(1) }, { 0, flag(1), flag(2) }, cell);
      this->AddQuad(
        { middle(2), corner(1), corner(2), middle(1) }, { flag(2), flag(0), flag(1), 0 }, cell);
    }
    else
    {
      this->Add({ middle(2), corner(1), middle(0) }, { flag(0), 0, flag(2) }, cell);
      this->Add({ middle(1), middle(0), corner(2) }, { flag(0), flag(1), 0 }, cell);
      this->AddQuad(
        { corner(0), middle(2), middle(0), middle(1) }, { flag(2), 0, 0, flag(1) }, cell);
    }
  }

  /// Of two triangles at a diagonal, whose slots are given.
  void DivideQuad(std::size_t own, std::size_t other)
  {
    std::array<std::size_t, 4> side{ PreviousSlotOf(own), NextSlotOf(other), PreviousSlotOf(other),
      NextSlotOf(own) };
    if (this->Middles[side[0]] == NoId)
    {
      std::rotate(side.begin(), side.begin() + 1, side.end());
    }
    const auto from = [this, &side](std::size_t k)
    { return this->Ground.Mesh.Corners[NextSlotOf(side[k])]; };
    const auto flag = [this, &side](std::size_t k) { return this->Ground.Flags[side[k]]; };
    const Id first = this->Middles[side[0]];
    const Id second = this->Middles[side[2]];
    const Id cell = this->Ground.Mesh.Cells[own / 3];
    this->AddQuad({ from(0), first, second, from(3) }, { flag(0), 0, flag(2), flag(3) }, cell);
    this->AddQuad({ first, from(1), from(2), second }, { flag(0), flag(1), flag(2), 0 }, cell);
  }

  /// Two triangles at the shorter diagonal. Flags are of the sides from the corners on.
  void AddQuad(const std::array<Id, 4>& c, const std::array<EdgeFlag, 4>& flags, Id cell)
  {
    if (this->Length2(c[0], c[2]) < this->Length2(c[1], c[3]))
    {
      this->Add({ c[0], c[1], c[2] }, { flags[1], 0, flags[0] }, cell);
      this->Add({ c[0], c[2], c[3] }, { flags[2], flags[3], 0 }, cell);
    }
    else
    {
      this->Add({ c[1], c[2], c[3] }, { flags[2], 0, flags[1] }, cell);
      this->Add({ c[1], c[3], c[0] }, { flags[3], flags[0], 0 }, cell);
    }
  }

  /// Flags are of the edges opposite the corners.
  void Add(const std::array<Id, 3>& corners, const std::array<EdgeFlag, 3>& flags, Id cell)
  {
    this->Corners.insert(this->Corners.end(), corners.begin(), corners.end());
    this->Flags.insert(this->Flags.end(), flags.begin(), flags.end());
    this->Cells.push_back(cell);
  }

  double Length2(Id a, Id b) const
  {
    const Point3 side = this->Ground.Mesh.Points[At(b)] - this->Ground.Mesh.Points[At(a)];
    return Dot(side, side);
  }

  double Side2(std::size_t slot) const
  {
    return this->Length2(
      this->Ground.Mesh.Corners[NextSlotOf(slot)], this->Ground.Mesh.Corners[PreviousSlotOf(slot)]);
  }

  SurfaceGround& Ground;
  const std::vector<Id>& Middles;
  const std::vector<Id>& Quads; ///< of triangles: FindQuads
  std::vector<Id> Corners;
  std::vector<Id> Cells;
  std::vector<EdgeFlag> Flags;
};

} // namespace

IdLists PlacesByOwner(const std::vector<Id>& owners, std::size_t count, std::size_t step)
{
  return { count,
    [&owners, step](const auto& add)
    {
      for (std::size_t place = 0; place < owners.size(); ++place)
      {
        add(owners[place], static_cast<Id>(place / step));
      }
    } };
}

double SurfaceGround::LengthOf(Id chain) const
{
  const Id* vertices = this->Chains.Vertices.data();
  return this->LengthOf(
    { vertices + this->Chains.Begin(chain), vertices + this->Chains.End(chain) });
}

double SurfaceGround::LengthOf(const std::vector<Id>& path) const
{
  double length = 0.0;
  for (std::size_t k = 1; k < path.size(); ++k)
  {
    length += Distance(this->Mesh.Points[At(path[k - 1])], this->Mesh.Points[At(path[k])]);
  }
  return length;
}

double SurfaceGround::SizeAt(Id triangle, const Point3& place) const
{
  const auto t = At(triangle);
  double sum = 0.0;
  double weights = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t slot = 3 * t + k;
    const double weight = Length(
      Cross(this->Mesh.At(NextSlotOf(slot)) - place, this->Mesh.At(PreviousSlotOf(slot)) - place));
    weights += weight;
    sum += weight * this->Sizes[At(this->Mesh.Corners[slot])];
  }
  return weights > 0.0 ? sum / weights : this->Sizes[At(this->Mesh.Corners[3 * t])];
}

bool DivideGround(SurfaceGround& ground, const std::function<double(const Point3&)>& given,
  std::size_t mostTriangles, Pulse& pulse)
{
  std::vector<Id> middles;
  std::vector<LongSlot> slots = FindLongSlots(ground, pulse);
  while (!slots.empty() && pulse.Ask())
  {
    const std::vector<Id> quads = FindQuads(ground, slots, middles);
    const std::size_t before = ground.Mesh.Points.size();
    for (std::size_t k = 0; k < slots.size(); ++k)
    {
      if (middles[slots[k].second] == NoId)
      {
        continue;
      }
      const auto low = At(slots[k].first.first);
      const auto high = At(slots[k].first.second);
      if (k == 0 || slots[k].first != slots[k - 1].first)
      {
        ground.Mesh.Points.push_back(Midpoint(ground.Mesh.Points[low], ground.Mesh.Points[high]));
        ground.Mesh.PointIds.push_back(NoId);
        const double mean = 0.5 * (ground.Sizes[low] + ground.Sizes[high]);
        const bool isCapped = mean < 0.5 * (ground.Given[low] + ground.Given[high]);
        ground.Sizes.push_back(isCapped ? mean : Infinity);
      }
      middles[slots[k].second] = static_cast<Id>(ground.Mesh.Points.size()) - 1;
    }
    constexpr std::size_t CheapSteps = 31;
    ground.Given.resize(ground.Mesh.Points.size());
    ForRowsAtOnce(pulse, ground.Mesh.Points.size() - before, CheapSteps,
      [&ground, &given, before](std::size_t begin, std::size_t end)
      {
        for (std::size_t v = before + begin; v < before + end; ++v)
        {
          ground.Given[v] = given(ground.Mesh.Points[v]);
          ground.Sizes[v] = std::min(ground.Sizes[v], ground.Given[v]);
        }
      });
    if (pulse.HasStopped())
    {
      break;
    }
    Halving halving(ground, middles, quads);
    if (quads.size() > mostTriangles)
    {
      return false;
    }
    pulse.Ask();
    for (std::size_t t = 0; t < quads.size(); ++t)
    {
      halving.Divide(t);
    }
    halving.Finish();
    pulse.Ask();
    slots = FindLongSlots(ground, pulse);
  }
  return true;
}

void LinkGround(SurfaceGround& ground, Pulse& pulse)
{
  const std::vector<Id>& corners = ground.Mesh.Corners;
  ground.Across = LinkSurface(ground.Mesh, pulse).Across;
  for (std::size_t slot = 0; slot < corners.size(); ++slot)
  {
    const bool isInner = ground.Flags[slot] == 0 && ground.Across[slot] >= 0;
    ground.Across[slot] = isInner ? ground.Across[slot] : NoId;
  }
  pulse.Ask();
  ground.TrianglesAt = PlacesByOwner(corners, ground.Mesh.Points.size(), 3);
}

} // namespace biting
