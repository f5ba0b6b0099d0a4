// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "HangingVertices.h"

#include "../Base/DistanceToSegment.h"
#include "../Domain/SegmentTree.h"
#include "../Predicates/Predicates.h"

#include <algorithm> // for sort, unique
#include <cstddef>   // for sizes
#include <cstdint>   // for flags
#include <utility>   // for pairs

namespace biting
{

namespace
{

/// A vertex that hangs on an edge, by its place along it.
struct Hanging
{
  Id Slot = NoId;
  double Share = 0.0;
  Id Vertex = NoId;

  bool operator<(const Hanging& other) const
  {
    return this->Slot != other.Slot ? this->Slot < other.Slot
      : this->Share != other.Share  ? this->Share < other.Share
                                    : this->Vertex < other.Vertex;
  }
  bool operator==(const Hanging& other) const
  {
    return this->Slot == other.Slot && this->Vertex == other.Vertex;
  }
};

class HangingSearch
{
public:
  HangingSearch(const OldMesh& mesh, double nearest)
    : Mesh(mesh)
    , Nearest(nearest)
    , Slots(mesh.FreeSlots())
  {
    for (const Id slot : this->Slots)
    {
      this->Edges.push_back({ mesh.Start(slot), mesh.End(slot) });
    }
  }

  std::vector<Hanging> Find()
  {
    Pulse pulse(NoMonitor());
    const SegmentTree tree(this->Mesh.Points, this->Edges, this->Nearest, pulse);
    for (const auto& [vertex, beside] : this->ListEnds())
    {
      const Point2& place = this->Mesh.Points[vertex];
      const Id other =
        this->Mesh.Start(beside) == vertex ? this->Mesh.End(beside) : this->Mesh.Start(beside);
      const Point2 across =
        0.5 * (this->Mesh.Points[this->Mesh.Corners[beside]] + this->Mesh.Points[other]);
      tree.Visit(Box2::Around(place, place), { vertex, vertex },
        [this, vertex = vertex, &across](Id edge) { this->Compare(edge, vertex, across); });
    }
    std::sort(this->Found.begin(), this->Found.end());
    this->Found.erase(std::unique(this->Found.begin(), this->Found.end()), this->Found.end());
    return std::move(this->Found);
  }

private:
  // Each end once, with one of the edges there; where several parts of the mesh touch, for each.
  std::vector<std::pair<Id, Id>> ListEnds() const
  {
    std::vector<std::uint8_t> isStart(this->Mesh.Points.size(), 0);
    std::vector<std::pair<Id, Id>> ends;
    for (std::size_t k = 0; k < this->Slots.size(); ++k)
    {
      ends.emplace_back(this->Edges[k].Start, this->Slots[k]);
      isStart[this->Edges[k].Start] = 1;
    }
    for (std::size_t k = 0; k < this->Slots.size(); ++k)
    {
      if (!isStart[this->Edges[k].End])
      {
        ends.emplace_back(this->Edges[k].End, this->Slots[k]);
      }
    }
    return ends;
  }

  // `across`: the middle of the side across the vertex, of a triangle there.
  void Compare(Id edge, Id vertex, const Point2& across)
  {
    const Id slot = this->Slots[edge];
    const Point2& start = this->Mesh.Points[this->Edges[edge].Start];
    const Point2& end = this->Mesh.Points[this->Edges[edge].End];
    const Point2& place = this->Mesh.Points[vertex];
    const double along = Dot(place - start, end - start);
    const double whole = Dot(end - start, end - start);
    const bool isAtEnd =
      Distance(place, start) <= this->Nearest || Distance(place, end) <= this->Nearest;
    if (isAtEnd || !(along > 0.0 && along < whole))
    {
      return;
    }
    const bool isNear =
      DistanceToSegment(place, start, end) <= this->Nearest || Orient2D(start, end, place) == 0;
    const Point2& apex = this->Mesh.Points[this->Mesh.Corners[slot]];
    if (isNear && Orient2D(start, end, apex) * Orient2D(start, end, across) < 0)
    {
      this->Found.push_back({ slot, along / whole, vertex });
    }
  }

  const OldMesh& Mesh;
  double Nearest;
  std::vector<Id> Slots;
  std::vector<SegmentEnds> Edges;
  std::vector<Hanging> Found;
};

} // namespace

std::vector<HangingVertices> FindHangingVertices(const OldMesh& mesh, double nearest)
{
  std::vector<HangingVertices> edges;
  for (const Hanging& one : HangingSearch(mesh, nearest).Find())
  {
    if (edges.empty() || edges.back().Slot != one.Slot)
    {
      edges.push_back({ one.Slot, {} });
    }
    edges.back().Vertices.push_back(one.Vertex);
  }
  return edges;
}

// Each between the ends of a part and the vertex in its middle: so few rounds mend them all.
std::vector<std::array<Id, 3>> FillBeside(const OldMesh& mesh, const HangingVertices& hanging)
{
  std::vector<Id> path{ mesh.Start(hanging.Slot) };
  path.insert(path.end(), hanging.Vertices.begin(), hanging.Vertices.end());
  path.push_back(mesh.End(hanging.Slot));
  std::vector<std::array<Id, 3>> triangles;
  std::vector<std::pair<std::size_t, std::size_t>> parts{ { 0, path.size() - 1 } };
  for (std::size_t next = 0; next < parts.size(); ++next)
  {
    const auto [first, last] = parts[next];
    if (last - first > 1)
    {
      const std::size_t middle = first + (last - first) / 2;
      triangles.push_back({ path[first], path[middle], path[last] });
      parts.emplace_back(first, middle);
      parts.emplace_back(middle, last);
    }
  }
  return triangles;
}

} // namespace biting
