// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SmallCrossings.h"

#include "../../Base/DisjointSets.h"
#include "WindingNumber.h"

#include <algorithm> // for all_of, max, min
#include <cstdint>   // for marks

namespace biting
{

namespace
{

// Boxes of what hangs together.
class CrossingBoxes
{
public:
  CrossingBoxes(const CheckedSurface& surface, Pulse& pulse)
    : Surface(surface)
    , Mesh(surface.Mesh)
    , Beats(pulse)
    , IsCrossing(this->Mesh.NumberOfTriangles(), 0)
    , Sets(this->Mesh.NumberOfTriangles())
    , Boxes(this->Mesh.NumberOfTriangles())
  {
  }

  // Of triangles: whether they cross others, or have other winding numbers.
  std::vector<std::uint8_t> IsBad;

  std::vector<Box3> Run()
  {
    std::vector<std::pair<Id, Point3>> places; // that belong to the box of a triangle
    for (const SurfaceContact& contact : this->Surface.Crossings)
    {
      this->IsCrossing[At(contact.First)] = 1;
      this->IsCrossing[At(contact.Second)] = 1;
      this->Sets.Unite(contact.First, contact.Second);
      if (!this->Beats.Beat(16))
      {
        return {};
      }
      for (const Point3& place : PlacesOfMeeting(this->Mesh, contact))
      {
        places.emplace_back(contact.First, place);
      }
    }
    const BoxTree<SurfaceItem, 3> tree = MakeSurfaceTree(this->Mesh, this->Beats);
    const std::vector<int> windings =
      WindingNumber(this->Mesh, tree)
        .InFront(LinkSurface(this->Mesh, this->Beats), this->IsCrossing, this->Beats);
    this->IsBad = this->IsCrossing;
    for (std::size_t t = 0; t < windings.size(); ++t)
    {
      this->IsBad[t] = windings[t] != 0 ? 1 : this->IsBad[t];
    }
    const IdLists slotsAt = CornersOfVertices(this->Mesh);
    for (std::size_t vertex = 0; vertex < this->Mesh.Points.size() && this->Beats.Beat(); ++vertex)
    {
      Id first = NoId; // of the triangles that cross, or have other numbers
      bool isOther = false;
      bool isLone = true;
      for (const Id slot : slotsAt[static_cast<Id>(vertex)])
      {
        const bool crosses = this->IsCrossing[At(slot / 3)] != 0;
        isOther = isOther || windings[At(slot / 3)] != 0;
        isLone = isLone && crosses;
        if (crosses || windings[At(slot / 3)] != 0)
        {
          first = first == NoId ? slot / 3 : this->Sets.Unite(first, slot / 3);
        }
      }
      if (first != NoId && (isOther || isLone))
      {
        places.emplace_back(first, this->Mesh.Points[vertex]);
      }
    }
    for (const auto& [triangle, place] : places)
    {
      this->Boxes[At(this->Sets.SetOf(triangle))].Add(place);
    }
    return std::move(this->Boxes);
  }

private:
  const CheckedSurface& Surface;
  const SurfaceMesh& Mesh;
  Pulse& Beats;
  std::vector<std::uint8_t> IsCrossing; ///< of triangles
  DisjointSets Sets;                    ///< of triangles
  std::vector<Box3> Boxes;              ///< of sets; empty ones of others
};

} // namespace

bool IsBounding(const CheckedSurface& surface)
{
  const std::vector<SurfaceShell>& shells = surface.Shells.Shells;
  return surface.Figures.OpenEdges == 0 && surface.Shells.AreBalanced &&
    std::all_of(
      shells.begin(), shells.end(), [](const SurfaceShell& shell) { return shell.IsOrientable; });
}

std::vector<Point3> PlacesOfMeeting(const SurfaceMesh& mesh, const SurfaceContact& contact)
{
  const std::array<std::size_t, 2> triangles{ At(contact.First), At(contact.Second) };
  std::vector<Point3> places;
  std::size_t shared = 0; // vertices, each seen from both sides
  for (std::size_t side = 0; side < 2; ++side)
  {
    const Triangle3 other = mesh.Triangle(triangles[1 - side]);
    const Id* const corners = &mesh.Corners[3 * triangles[1 - side]];
    const auto isShared = [&mesh, corners](std::size_t slot)
    { return mesh.Corners[slot] == corners[CornerOf(corners, mesh.Corners[slot])]; };
    for (std::size_t slot = 3 * triangles[side]; slot < 3 * triangles[side] + 3; ++slot)
    {
      const auto ends = EndsOf(mesh, slot);
      const Point3& begin = mesh.Points[At(ends.first)];
      const Point3& end = mesh.Points[At(ends.second)];
      // Of sides in the plane of the other triangle the sides beside them have the ends.
      const bool isFree = !isShared(NextSlotOf(slot)) && !isShared(PreviousSlotOf(slot)) &&
        (HeightOver(other, begin) != 0 || HeightOver(other, end) != 0);
      Point3 place = mesh.At(slot);
      shared += isShared(slot) ? 1 : 0;
      if (isShared(slot) || (isFree && Meets(other, begin, end, place)))
      {
        places.push_back(place);
      }
    }
  }
  if (shared > 2)
  {
    const Box3 one = mesh.BoxOf(triangles[0]);
    const Box3 other = mesh.BoxOf(triangles[1]);
    places.assign(2, one.Low);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      places[0][axis] = std::max(one.Low[axis], other.Low[axis]);
      places[1][axis] = std::min(one.High[axis], other.High[axis]);
    }
  }
  return places;
}

SurfaceMesh CutOutCrossings(
  const CheckedSurface& surface, const SpacingField& spacing, Pulse& pulse)
{
  if (surface.Figures.NonManifoldEdges > 0 || !IsBounding(surface))
  {
    return {};
  }
  CrossingBoxes crossings(surface, pulse);
  const std::vector<Box3> boxes = crossings.Run();
  const bool areSmall = std::all_of(boxes.begin(), boxes.end(),
    [&spacing](const Box3& box)
    { return box.IsEmpty() || box.Diagonal() <= 2.0 * ClearShare * spacing(box.Center()); });
  SurfaceMesh mesh = surface.Mesh;
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    if (crossings.IsBad[t] == 0)
    {
      mesh.CopyTriangle(t, kept++);
    }
  }
  mesh.Resize(areSmall ? kept : 0);
  return mesh;
}

} // namespace biting
