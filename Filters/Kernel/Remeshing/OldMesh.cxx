// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OldMesh.h"

#include "../Base/Pulse.h"
#include "../Domain/AreaSum.h"
#include "../Domain/Domain.h"
#include "../Domain/Polylines.h"
#include "../Predicates/Predicates.h"
#include "OldMeshRepair.h"

#include <algorithm> // for lower_bound, sort
#include <cmath>     // for abs
#include <cstdint>   // for flags
#include <set>       // for parts of lines
#include <string>    // for details
#include <utility>   // for swap

namespace biting
{

namespace
{

// Of the area: far above the rounding of its sum.
constexpr double AreaTolerance = 1e-13;

// Where free edges meet, how wide the strips along them are that count twice or not at all, in
// units of the rounding of coordinates.
constexpr double WidthOfStrips = 8.0;

/// A slot by the ends of its edge, both in one number.
struct EdgeSlot
{
  std::uint64_t Ends;
  Id Slot;

  static std::uint64_t EndsOf(Id start, Id end)
  {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(start)) << 32) |
      static_cast<std::uint32_t>(end);
  }
  bool operator<(const EdgeSlot& other) const { return this->Ends < other.Ends; }
};

// Whether an edge of a triangle leads from one vertex to another, in its turn.
bool IsEdge(const OldMesh& mesh, Id triangle, Id start, Id end)
{
  const Id* corners = mesh.Corners.data() + 3 * static_cast<std::size_t>(triangle);
  return (corners[0] == start && corners[1] == end) || (corners[1] == start && corners[2] == end) ||
    (corners[2] == start && corners[0] == end);
}

// The free edges, with their triangles as cells.
Polylines DrawingOf(const OldMesh& mesh)
{
  Polylines edges;
  edges.Points = mesh.Points;
  for (const Id slot : mesh.FreeSlots())
  {
    edges.Connectivity.push_back(mesh.Start(slot));
    edges.Connectivity.push_back(mesh.End(slot));
    edges.Offsets.push_back(static_cast<Id>(edges.Connectivity.size()));
    edges.Kinds.push_back(ChainKind::Boundary);
    edges.Cells.push_back(slot / 3);
  }
  return edges;
}

class Reader
{
public:
  Reader(const RemeshInput& input, double nearest, ProblemList& problems, Monitor& monitor)
    : Input(input)
    , Nearest(nearest)
    , Problems(problems)
    , Listener(monitor)
    , Progress(monitor)
  {
  }

  OldMesh Read()
  {
    this->Copy();
    this->CheckRange();
    if (this->IsOver())
    {
      return {};
    }
    this->Mend();
    this->Orient();
    if (!this->IsOver() && this->CheckSides())
    {
      this->MarkEdges();
      this->CheckOverlaps();
    }
    return this->IsOver() ? OldMesh() : std::move(this->Mesh);
  }

private:
  bool IsOver() const { return this->Problems.HasErrors() || this->Progress.HasStopped(); }

  void Copy()
  {
    const std::size_t triangles = this->Input.Corners.size() / 3;
    this->Mesh.Points = this->Input.Points;
    this->Mesh.Corners = this->Input.Corners;
    this->Mesh.Regions = this->Input.Regions;
    this->Mesh.IsFixed = this->Input.IsFixed;
    this->Mesh.IsFrozen = this->Input.IsFrozen;
    this->Mesh.Regions.resize(triangles, 0);
    this->Mesh.IsFixed.resize(this->Input.Points.size(), 0);
    this->Mesh.IsFrozen.resize(triangles, 0);
    this->Mesh.LineCells = this->Input.LineCells;
    this->Mesh.IsFrozenLine = this->Input.IsFrozenLine;
    this->Mesh.AreAlike = this->Input.AreAlike;
    this->Mesh.Rounding = this->Input.Rounding;
  }

  // As MakeDomain does it.
  void CheckRange()
  {
    const std::vector<Point2>& points = this->Mesh.Points;
    std::vector<std::uint8_t> isSeen(points.size(), 0);
    double greatest = 0.0;
    for (const Id corner : this->Mesh.Corners)
    {
      const Point2& p = points[corner];
      const double magnitude = std::max(std::abs(p.X), std::abs(p.Y));
      greatest = std::max(greatest, magnitude);
      if (magnitude > GreatestCoordinate && isSeen[corner] == 0)
      {
        const std::vector<std::int64_t>& ids = this->Input.PointIds;
        this->Problems.Add(
          { ProblemCode::OutOfRange, { ids.empty() ? corner : ids[corner] }, p, {} });
        isSeen[corner] = 1;
      }
    }
    if (greatest > 0.0 && greatest < LeastCoordinate)
    {
      this->Problems.Add({ ProblemCode::OutOfRange, {}, {}, "smaller than 1e-70" });
    }
  }

  void Orient()
  {
    OldMesh& mesh = this->Mesh;
    this->Progress.ForEach(static_cast<std::size_t>(mesh.NumberOfTriangles()),
      [this, &mesh](std::size_t triangle)
      {
        Id* corners = mesh.Corners.data() + 3 * triangle;
        const Point2& a = mesh.Points[corners[0]];
        const Point2& b = mesh.Points[corners[1]];
        const Point2& c = mesh.Points[corners[2]];
        const int side = Orient2D(a, b, c);
        if (side == 0)
        {
          this->AddBad(static_cast<Id>(triangle), "it has no area");
        }
        if (side < 0)
        {
          std::swap(corners[1], corners[2]);
          std::swap(mesh.Neighbors[3 * triangle + 1], mesh.Neighbors[3 * triangle + 2]);
        }
      });
  }

  void Mend()
  {
    MendedMesh mended = MendOldMesh(this->Input, this->Nearest, this->Mesh, this->Problems);
    this->Numbers = std::move(mended.Numbers);
    this->Divided = std::move(mended.Divided);
    for (const Id triangle : mended.Crowded)
    {
      this->AddBad(triangle, "more than two triangles share an edge of it");
    }
    this->Progress.Ask();
  }

  Id NumberOf(Id vertex) const { return this->Numbers.empty() ? vertex : this->Numbers[vertex]; }

  bool CheckSides()
  {
    const OldMesh& mesh = this->Mesh;
    this->Progress.ForEach(mesh.Corners.size(),
      [this, &mesh](std::size_t place)
      {
        const Id slot = static_cast<Id>(place);
        const Id neighbor = mesh.Neighbors[slot];
        if (neighbor != NoId && !IsEdge(mesh, neighbor, mesh.End(slot), mesh.Start(slot)))
        {
          this->AddBad(slot / 3, "another triangle lies on the same side of an edge of it");
        }
      });
    return !this->IsOver();
  }

  void MarkEdges()
  {
    OldMesh& mesh = this->Mesh;
    mesh.Marks.assign(mesh.Corners.size(), NoId);
    this->Progress.ForEach(mesh.Corners.size(),
      [&mesh](std::size_t slot)
      {
        const Id neighbor = mesh.Neighbors[slot];
        const bool isMarked = neighbor == NoId || mesh.Regions[neighbor] != mesh.Regions[slot / 3];
        mesh.Marks[slot] = isMarked ? OldMesh::Untagged : NoId;
      });
    if (!this->Input.LineStarts.empty())
    {
      this->MarkLines();
    }
  }

  // Those between ends of lines, and of their parts, by their ends.
  std::vector<EdgeSlot> SlotsOfLines() const
  {
    const OldMesh& mesh = this->Mesh;
    std::vector<std::uint8_t> isEnd(mesh.Points.size(), 0);
    for (const std::vector<Id>* ends : { &this->Input.LineStarts, &this->Input.LineEnds })
    {
      for (const Id end : *ends)
      {
        isEnd[this->NumberOf(end)] = 1;
      }
    }
    for (const DividedSide& side : this->Divided)
    {
      isEnd[side[2]] = 1;
    }
    std::vector<EdgeSlot> slots;
    for (Id slot = 0; slot < static_cast<Id>(mesh.Corners.size()); ++slot)
    {
      const Id start = mesh.Start(slot);
      const Id end = mesh.End(slot);
      if (isEnd[start] && isEnd[end])
      {
        slots.push_back({ EdgeSlot::EndsOf(start, end), slot });
      }
    }
    std::sort(slots.begin(), slots.end());
    return slots;
  }

  void MarkLines()
  {
    const std::vector<EdgeSlot> slots = this->SlotsOfLines();
    for (std::size_t line = 0; line < this->Input.LineStarts.size(); ++line)
    {
      if (!this->MarkLine(static_cast<Id>(line), slots))
      {
        this->Problems.Add({ ProblemCode::OutsideInterfaces, { this->Input.LineCells[line] },
          this->Mesh.Points[this->NumberOf(this->Input.LineStarts[line])],
          "it is no edge of the mesh" });
      }
    }
  }

  // A line that is no edge, as a side of a flat triangle was divided, is both parts of it.
  bool MarkLine(Id line, const std::vector<EdgeSlot>& slots)
  {
    std::vector<std::pair<Id, Id>> parts{ std::minmax(
      { this->NumberOf(this->Input.LineStarts[line]),
        this->NumberOf(this->Input.LineEnds[line]) }) };
    std::set<std::pair<Id, Id>> seen(parts.begin(), parts.end());
    bool isEdge = false;
    while (!parts.empty())
    {
      const auto [start, end] = parts.back();
      parts.pop_back();
      if (this->MarkEdge(start, end, line, slots))
      {
        isEdge = true;
        continue;
      }
      const DividedSide first{ start, end, 0 };
      for (auto side = std::lower_bound(this->Divided.begin(), this->Divided.end(), first);
           side != this->Divided.end() && (*side)[0] == start && (*side)[1] == end; ++side)
      {
        for (const Id other : { start, end })
        {
          const std::pair<Id, Id> part = std::minmax({ other, (*side)[2] });
          if (seen.insert(part).second)
          {
            parts.push_back(part);
          }
        }
      }
    }
    return isEdge;
  }

  // Both sides of the edge. Whether there is one. Of several lines on it the first counts, but it
  // is frozen where one of them is.
  bool MarkEdge(Id start, Id end, Id line, const std::vector<EdgeSlot>& slots)
  {
    OldMesh& mesh = this->Mesh;
    bool isEdge = false;
    for (const std::uint64_t ends : { EdgeSlot::EndsOf(start, end), EdgeSlot::EndsOf(end, start) })
    {
      const auto slot = std::lower_bound(slots.begin(), slots.end(), EdgeSlot{ ends, NoId });
      if (slot != slots.end() && slot->Ends == ends)
      {
        Id& mark = mesh.Marks[slot->Slot];
        mark = mark > OldMesh::Untagged ? mark : 1 + line;
        if (mesh.IsFrozenEdge(1 + line))
        {
          mesh.IsFrozenLine[mark - 1] = 1;
        }
        isEdge = true;
      }
    }
    return isEdge;
  }

  // The free edges as a drawing: it must bound as much as the triangles have, which lie left of
  // them.
  void CheckOverlaps()
  {
    const std::vector<Id> slots = this->Mesh.FreeSlots();
    if (slots.empty())
    {
      return;
    }
    AreaSum sum(this->Mesh.Points[this->Mesh.Start(slots.front())]);
    double length = 0.0;
    for (const Id slot : slots)
    {
      const Point2& start = this->Mesh.Points[this->Mesh.Start(slot)];
      const Point2& end = this->Mesh.Points[this->Mesh.End(slot)];
      sum.Add(start, end);
      length += Distance(start, end);
    }
    this->Mesh.Area = sum.Area();
    ProblemList found;
    const Domain domain = MakeDomain(DrawingOf(this->Mesh), {}, found, this->Listener);
    this->Progress.Ask();
    const double strips =
      found.Groups().empty() ? 0.0 : WidthOfStrips * this->Mesh.Rounding * length;
    const double difference = std::abs(domain.Area - this->Mesh.Area);
    if (this->Progress.HasStopped() || difference <= AreaTolerance * this->Mesh.Area + strips)
    {
      return;
    }
    this->AddMeetings(found);
    this->AddCovered(domain);
    if (!this->Problems.HasErrors())
    {
      this->Problems.Add({ ProblemCode::BadTriangles, {}, {},
        "triangles lie on top of others: together they have " +
          std::to_string(this->Mesh.Area / domain.Area) + " times the area that they cover" });
    }
  }

  void AddMeetings(const ProblemList& found)
  {
    for (const ProblemGroup& group : found.Groups())
    {
      const bool isMeeting = group.Code == ProblemCode::Crossings ||
        group.Code == ProblemCode::Touches || group.Code == ProblemCode::DuplicateSegments;
      for (std::size_t k = 0; isMeeting && k < group.First.size(); ++k)
      {
        this->AddBad(static_cast<Id>(group.First[k].Ids[0]), "a free edge of it meets another");
      }
    }
  }

  // Of triangles on top of others the free edges are those of a hole, by even-odd.
  void AddCovered(const Domain& domain)
  {
    for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
    {
      const Id triangle = domain.Cells[segment];
      const Id* corners = this->Mesh.Corners.data() + 3 * static_cast<std::size_t>(triangle);
      const Point2 middle = (1.0 / 3.0) *
        (this->Mesh.Points[corners[0]] + this->Mesh.Points[corners[1]] +
          this->Mesh.Points[corners[2]]);
      const Point2& start = domain.Vertices[domain.Starts[segment]];
      const Point2& end = domain.Vertices[domain.Ends[segment]];
      const bool isLeft = Orient2D(start, end, middle) > 0;
      if (!(isLeft ? domain.LeftInside : domain.RightInside)[segment])
      {
        this->AddBad(triangle, "it lies on top of others");
      }
    }
  }

  void AddBad(Id triangle, const char* detail)
  {
    const std::vector<Id>& corners = this->Mesh.Corners;
    const Point2 sum = this->Mesh.Points[corners[3 * triangle]] +
      this->Mesh.Points[corners[3 * triangle + 1]] + this->Mesh.Points[corners[3 * triangle + 2]];
    this->Problems.Add(
      { ProblemCode::BadTriangles, { this->CellId(triangle) }, (1.0 / 3.0) * sum, detail });
  }

  std::int64_t CellId(Id triangle) const
  {
    const Id origin = this->Mesh.Origins.empty() ? triangle : this->Mesh.Origins[triangle];
    return this->Input.CellIds.empty() ? origin : this->Input.CellIds[origin];
  }

  const RemeshInput& Input;
  double Nearest;
  ProblemList& Problems;
  Monitor& Listener;
  Pulse Progress;
  OldMesh Mesh;
  std::vector<Id> Numbers; ///< of each vertex of the input: the one that it was made; empty: itself
  std::vector<DividedSide> Divided; ///< as MendedMesh has them
};

} // namespace

OldMesh ReadOldMesh(
  const RemeshInput& input, double nearest, ProblemList& problems, Monitor& monitor)
{
  return Reader(input, nearest, problems, monitor).Read();
}

} // namespace biting
