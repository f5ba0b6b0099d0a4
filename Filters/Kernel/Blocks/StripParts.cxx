// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "StripParts.h"

#include "../Base/DisjointSets.h"

#include <algorithm> // for sort, min
#include <cstdint>   // for flags
#include <utility>   // for move

namespace biting
{

namespace
{

void AddAcross(const Triangulation& mesh, std::size_t first, std::vector<std::uint8_t>& isTaken,
  TriangleList& triangles)
{
  for (std::size_t slot = first; slot < first + 3; ++slot)
  {
    const Id next = mesh.Neighbors[slot];
    if (next != NoId && isTaken[next] == 0)
    {
      isTaken[next] = 1;
      triangles.push_back(next);
    }
  }
}

// Grows part by part.
class PartGrower
{
public:
  PartGrower(const Triangulation& mesh, std::size_t most, Pulse& pulse)
    : Mesh(mesh)
    , Most(most)
    , Beats(pulse)
    , Parts(mesh.Regions.size(), NoId)
  {
  }

  // Of the triangles.
  std::vector<Id> Run()
  {
    std::size_t next = 0;
    for (Id triangle = 0; triangle < this->Mesh.NumberOfTriangles(); ++triangle)
    {
      this->Seeds.push_back(triangle);
      for (; next < this->Seeds.size() && this->Beats.Beat(); ++next)
      {
        this->GrowFrom(this->Seeds[next]);
      }
    }
    return std::move(this->Parts);
  }

  Id NumberOfParts() const { return this->Count; }

private:
  void GrowFrom(Id seed)
  {
    if (this->Parts[seed] != NoId)
    {
      return;
    }
    this->Own.assign(1, seed);
    this->Parts[seed] = this->Count;
    for (std::size_t k = 0; k < this->Own.size() && this->Beats.Beat(); ++k)
    {
      const std::size_t first = 3 * static_cast<std::size_t>(this->Own[k]);
      for (std::size_t slot = first; slot < first + 3; ++slot)
      {
        this->Add(this->Mesh.Neighbors[slot]);
      }
    }
    ++this->Count;
  }

  // Beyond the last triangle others begin.
  void Add(Id triangle)
  {
    if (triangle == NoId || this->Parts[triangle] != NoId)
    {
      return;
    }
    const bool hasRoom = this->Own.size() < this->Most;
    this->Parts[triangle] = hasRoom ? this->Count : NoId;
    (hasRoom ? this->Own : this->Seeds).push_back(triangle);
  }

  const Triangulation& Mesh;
  std::size_t Most;
  Pulse& Beats;
  std::vector<Id> Parts;
  std::vector<Id> Seeds; ///< triangles from which parts grow, one after the other
  std::vector<Id> Own;   ///< triangles of the part at hand
  Id Count = 0;
};

} // namespace

TriangleList TrianglesAround(const Triangulation& mesh, std::size_t vertices,
  const std::vector<Id>& seeds, Pulse& pulse, int steps)
{
  std::vector<std::uint8_t> isSeed(vertices, 0);
  for (const Id seed : seeds)
  {
    isSeed[seed] = 1;
  }
  std::vector<std::uint8_t> isTaken(mesh.Regions.size(), 0);
  TriangleList triangles;
  pulse.ForEach(isTaken.size(),
    [&mesh, &isSeed, &isTaken, &triangles](std::size_t triangle)
    {
      const Id* corners = mesh.Corners.data() + 3 * triangle;
      if (isSeed[corners[0]] != 0 || isSeed[corners[1]] != 0 || isSeed[corners[2]] != 0)
      {
        isTaken[triangle] = 1;
        triangles.push_back(static_cast<Id>(triangle));
      }
    });
  std::size_t begin = 0;
  for (int step = 0; step < steps; ++step)
  {
    const std::size_t end = triangles.size();
    for (; begin < end && pulse.Beat(); ++begin)
    {
      AddAcross(mesh, 3 * static_cast<std::size_t>(triangles[begin]), isTaken, triangles);
    }
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

// A vertex between parts is of the first: a triangle is of a part where all its corners are.
std::vector<TriangleList> DivideIntoParts(
  const Triangulation& mesh, std::size_t vertices, std::size_t most, Pulse& pulse)
{
  PartGrower grower(mesh, most, pulse);
  const std::vector<Id> ofTriangles = grower.Run();
  std::vector<Id> ofVertices(vertices, grower.NumberOfParts());
  pulse.ForEach(mesh.Corners.size(),
    [&mesh, &ofTriangles, &ofVertices](std::size_t slot)
    {
      Id& part = ofVertices[mesh.Corners[slot]];
      part = std::min(part, ofTriangles[slot / 3]);
    });
  std::vector<TriangleList> parts(static_cast<std::size_t>(grower.NumberOfParts()));
  for (std::size_t triangle = 0; triangle < ofTriangles.size() && pulse.Beat(); ++triangle)
  {
    const Id* corners = mesh.Corners.data() + 3 * triangle;
    const Id part = ofTriangles[triangle];
    if (ofVertices[corners[0]] == part && ofVertices[corners[1]] == part &&
      ofVertices[corners[2]] == part)
    {
      parts[part].push_back(static_cast<Id>(triangle));
    }
  }
  return parts;
}

std::vector<TriangleList> ConnectedParts(
  const Triangulation& mesh, std::size_t vertices, const TriangleList& triangles, Pulse& pulse)
{
  DisjointSets sets(vertices);
  for (std::size_t k = 0; k < triangles.size() && pulse.Beat(); ++k)
  {
    const Id* corners = mesh.Corners.data() + 3 * static_cast<std::size_t>(triangles[k]);
    sets.Unite(corners[0], corners[1]);
    sets.Unite(corners[1], corners[2]);
  }
  std::vector<Id> numbers(vertices, NoId);
  std::vector<TriangleList> parts;
  for (std::size_t k = 0; k < triangles.size() && pulse.Beat(); ++k)
  {
    Id& number = numbers[sets.SetOf(mesh.Corners[3 * static_cast<std::size_t>(triangles[k])])];
    if (number == NoId)
    {
      number = static_cast<Id>(parts.size());
      parts.emplace_back();
    }
    parts[number].push_back(triangles[k]);
  }
  return parts;
}

} // namespace biting
