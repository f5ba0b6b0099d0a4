// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RimFlips.h"

#include "../Predicates/Predicates.h"

namespace biting
{

namespace
{

// In the triangle of a slot, so many corners on.
std::size_t Turned(std::size_t slot, std::size_t turn)
{
  return slot - slot % 3 + (slot + turn) % 3;
}

// The slot of the neighbour across.
std::size_t Across(const Triangulation& mesh, std::size_t slot)
{
  std::size_t across = 3 * static_cast<std::size_t>(mesh.Neighbors[slot]);
  while (mesh.Corners[Turned(across, 2)] != mesh.Corners[Turned(slot, 1)])
  {
    ++across;
  }
  return across;
}

// What lies beyond slot `from` lies beyond slot `to` from now on.
void Move(Triangulation& mesh, std::size_t from, std::size_t to)
{
  const Id neighbor = mesh.Neighbors[from];
  if (neighbor != NoId)
  {
    mesh.Neighbors[Across(mesh, from)] = static_cast<Id>(to / 3);
  }
  mesh.Neighbors[to] = neighbor;
  mesh.Constraints[to] = mesh.Constraints[from];
}

// Triangles (p, a, b) and (d, b, a) become (p, a, d) and (d, b, p).
void Flip(Triangulation& mesh, std::size_t slot, std::size_t across)
{
  Move(mesh, Turned(across, 1), slot);
  Move(mesh, Turned(slot, 1), across);
  mesh.Corners[Turned(slot, 2)] = mesh.Corners[across];
  mesh.Corners[Turned(across, 2)] = mesh.Corners[slot];
  mesh.Neighbors[Turned(slot, 1)] = static_cast<Id>(across / 3);
  mesh.Neighbors[Turned(across, 1)] = static_cast<Id>(slot / 3);
  mesh.Constraints[Turned(slot, 1)] = NoId;
  mesh.Constraints[Turned(across, 1)] = NoId;
}

} // namespace

bool FlipUntilDelaunay(const std::vector<Point2>& points, std::vector<std::size_t> slots,
  Triangulation& mesh, Pulse& pulse)
{
  bool isWhole = true;
  while (!slots.empty() && pulse.Beat())
  {
    const std::size_t slot = slots.back();
    slots.pop_back();
    if (mesh.Neighbors[slot] == NoId || mesh.Constraints[slot] != NoId)
    {
      isWhole = isWhole && mesh.Constraints[slot] != NoId;
      continue;
    }
    const std::size_t across = Across(mesh, slot);
    const auto corner = [&points, &mesh](std::size_t at) { return points[mesh.Corners[at]]; };
    if (InCircle(corner(slot), corner(Turned(slot, 1)), corner(Turned(slot, 2)), corner(across)) >
      0)
    {
      Flip(mesh, slot, across);
      slots.insert(slots.end(), { slot, Turned(slot, 2), across, Turned(across, 2) });
    }
  }
  return isWhole;
}

} // namespace biting
