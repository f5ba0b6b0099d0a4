// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceWelding.h"

#include "PlaceTable.h"
#include "SurfaceLinks.h"

#include <cmath>   // for abs, floor
#include <cstring> // for the bits of numbers
#include <numeric> // for iota

namespace biting
{

namespace
{

PlaceTable::Key BitsOf(const Point3& place)
{
  const Point3 positive = place + Point3(); // -0 becomes 0
  PlaceTable::Key key;
  std::memcpy(key.data(), positive.Data(), sizeof key);
  return key;
}

// The cell of a grid that a place is in, or, with the side -1 or 1, the one that holds what is
// within the rounding at that side: cells are twice as wide, and a quarter is for rounding here.
std::int64_t CellOf(double value, double rounding, double side)
{
  return rounding > 0.0
    ? static_cast<std::int64_t>(std::floor(0.5 * (value / rounding + 1.25 * side)))
    : 0;
}

bool AreNear(const Point3& a, const Point3& b, const Point3& rounding)
{
  return std::abs(a.X - b.X) <= rounding.X && std::abs(a.Y - b.Y) <= rounding.Y &&
    std::abs(a.Z - b.Z) <= rounding.Z;
}

} // namespace

void MergeVertices(SurfaceMesh& mesh, const std::vector<Id>& kept)
{
  std::vector<Id> numbers(mesh.Points.size(), NoId);
  std::size_t triangles = 0;
  for (std::size_t t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    Id corners[3];
    for (std::size_t k = 0; k < 3; ++k)
    {
      corners[k] = kept[static_cast<std::size_t>(mesh.Corners[3 * t + k])];
    }
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
    {
      mesh.CopyTriangle(t, triangles);
      for (std::size_t k = 0; k < 3; ++k)
      {
        mesh.Corners[3 * triangles + k] = corners[k];
        numbers[static_cast<std::size_t>(corners[k])] = 0;
      }
      ++triangles;
    }
  }
  mesh.Resize(triangles);
  std::size_t vertices = 0;
  for (std::size_t point = 0; point < numbers.size(); ++point)
  {
    if (numbers[point] != NoId)
    {
      mesh.Points[vertices] = mesh.Points[point];
      mesh.PointIds[vertices] = mesh.PointIds[point];
      numbers[point] = static_cast<Id>(vertices++);
    }
  }
  mesh.Points.resize(vertices);
  mesh.PointIds.resize(vertices);
  for (Id& corner : mesh.Corners)
  {
    corner = numbers[static_cast<std::size_t>(corner)];
  }
}

std::size_t WeldEqualPoints(SurfaceMesh& mesh, Pulse& pulse)
{
  std::vector<Id> kept(mesh.Points.size(), NoId);
  for (const Id corner : mesh.Corners)
  {
    kept[static_cast<std::size_t>(corner)] = corner;
  }
  std::size_t welded = 0;
  PlaceTable table(mesh.Points.size());
  pulse.ForEach(mesh.Points.size(),
    [&mesh, &kept, &table, &welded](std::size_t point)
    {
      if (kept[point] == NoId)
      {
        return;
      }
      const PlaceTable::Key key = BitsOf(mesh.Points[point]);
      const Id first = table.Find(key, [](Id) { return true; });
      if (first != NoId)
      {
        kept[point] = first;
        ++welded;
      }
      else
      {
        table.Add(key, static_cast<Id>(point));
      }
    });
  MergeVertices(mesh, kept);
  return welded;
}

std::size_t WeldBorders(SurfaceMesh& mesh, const Point3& rounding, Pulse& pulse)
{
  const SurfaceLinks links = LinkSurface(mesh, pulse);
  std::vector<std::uint8_t> isOpen(mesh.Points.size(), 0);
  for (std::size_t slot = 0; slot < mesh.Corners.size() && links.NumberOfOpen > 0; ++slot)
  {
    for (const std::size_t end : { NextSlotOf(slot), PreviousSlotOf(slot) })
    {
      isOpen[static_cast<std::size_t>(mesh.Corners[end])] |= links.Across[slot] == OpenEdge;
    }
  }
  std::size_t welded = 0;
  std::vector<Id> kept(mesh.Points.size());
  std::iota(kept.begin(), kept.end(), 0);
  PlaceTable table(links.NumberOfOpen > 0 ? mesh.Points.size() : 0);
  pulse.ForEach(links.NumberOfOpen > 0 ? mesh.Points.size() : 0,
    [&](std::size_t point)
    {
      if (!isOpen[point])
      {
        return;
      }
      const Point3& place = mesh.Points[point];
      const auto keyAt = [&place, &rounding](double x, double y, double z)
      {
        return PlaceTable::Key{ CellOf(place.X, rounding.X, x), CellOf(place.Y, rounding.Y, y),
          CellOf(place.Z, rounding.Z, z) };
      };
      const auto isNear = [&mesh, &place, &rounding](Id other)
      { return AreNear(place, mesh.Points[static_cast<std::size_t>(other)], rounding); };
      Id found = NoId;
      for (int side = 0; side < 27 && found == NoId; ++side)
      {
        found = table.Find(keyAt(side % 3 - 1, side / 3 % 3 - 1, side / 9 - 1), isNear);
      }
      if (found != NoId)
      {
        kept[point] = found;
        ++welded;
      }
      else
      {
        table.Add(keyAt(0.0, 0.0, 0.0), static_cast<Id>(point));
      }
    });
  if (welded > 0)
  {
    MergeVertices(mesh, kept);
  }
  return welded;
}

} // namespace biting
