// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "StripReturn.h"

#include "../Base/Tasks.h"
#include "../Base/TriangleSlots.h"
#include "../Predicates/Predicates.h"

#include <algorithm> // for sort
#include <cstdint>   // for flags
#include <utility>   // for move

namespace biting
{

namespace
{

// The neighbour across slot `from` becomes the neighbour across slot `to`.
void Move(Triangulation& mesh, std::size_t from, std::size_t to)
{
  const Id neighbor = mesh.Neighbors[from];
  if (neighbor != NoId)
  {
    mesh.Neighbors[SlotAcross(mesh.Corners, from, neighbor)] = static_cast<Id>(to / 3);
  }
  mesh.Neighbors[to] = neighbor;
  mesh.Constraints[to] = mesh.Constraints[from];
}

// Triangles (p, a, b) and (d, b, a) become (p, a, d) and (d, b, p).
void Flip(Triangulation& mesh, std::size_t slot, std::size_t across)
{
  Move(mesh, NextSlotOf(across), slot);
  Move(mesh, NextSlotOf(slot), across);
  mesh.Corners[PreviousSlotOf(slot)] = mesh.Corners[across];
  mesh.Corners[PreviousSlotOf(across)] = mesh.Corners[slot];
  mesh.Neighbors[NextSlotOf(slot)] = static_cast<Id>(across / 3);
  mesh.Neighbors[NextSlotOf(across)] = static_cast<Id>(slot / 3);
  mesh.Constraints[NextSlotOf(slot)] = NoId;
  mesh.Constraints[NextSlotOf(across)] = NoId;
}

// Numbers the entries that are not NoId, in their order, lists the places of the others, and
// returns the count of numbered ones.
Id NumberKept(std::vector<Id>& numbers, std::vector<Id>& gone, Pulse& pulse)
{
  Id kept = 0;
  pulse.ForEach(numbers.size(),
    [&numbers, &gone, &kept](std::size_t place)
    {
      if (numbers[place] == NoId)
      {
        gone.push_back(static_cast<Id>(place));
      }
      else
      {
        numbers[place] = kept++;
      }
    });
  return kept;
}

// Moves the values of what is kept to their new numbers: `size` values each.
template <typename Value>
void CloseUp(
  const std::vector<Id>& numbers, std::size_t size, std::vector<Value>& values, Pulse& pulse)
{
  pulse.ForEach(numbers.size(),
    [&numbers, size, &values](std::size_t place)
    {
      const Id number = numbers[place];
      for (std::size_t k = 0; k < size && number != NoId; ++k)
      {
        values[size * static_cast<std::size_t>(number) + k] = values[size * place + k];
      }
    });
}

// Puts relaxed strips back into the whole.
class StripReturn
{
public:
  StripReturn(const std::vector<RelaxedStrip>& strips, JoinedMesh& mesh, Pulse& pulse)
    : Strips(strips)
    , Whole(mesh)
    , Beats(pulse)
    , NewStripNumbers(strips.size())
  {
  }

  StripChange Run()
  {
    StripChange change;
    this->MakeRoom();
    this->NumberVertices();
    this->NumberTriangles();
    if (this->Beats.HasStopped())
    {
      return change;
    }
    change.GoneVertices = this->ListGone();
    this->MoveVertices();
    this->MoveTriangles();
    if (!this->Beats.HasStopped())
    {
      for (std::size_t k = 0; k < this->Strips.size(); ++k)
      {
        this->FindFirstParts(this->Strips[k].Strip);
        this->AddStrip(this->Strips[k].Strip, this->NewStripNumbers[k]);
        this->ChangeEdges(this->Strips[k].Strip, this->NewStripNumbers[k]);
      }
      this->CloseUpEdges();
      change.IsWhole =
        FlipUntilDelaunay(this->Whole.Bites.Points, this->Rim, this->Whole.Triangles, this->Beats);
    }
    change.Triangles = std::move(this->Gone);
    return change;
  }

private:
  // All vertices and triangles are kept unless they are marked as gone.
  void MakeRoom()
  {
    this->NewNumbers.resize(this->Whole.Bites.Points.size());
    this->NewTriangles.resize(this->Whole.Triangles.Regions.size());
  }

  // Kept vertices are numbered first, in their order, then the new ones.
  void NumberVertices()
  {
    for (const RelaxedStrip& strip : this->Strips)
    {
      this->MarkGone(strip);
    }
    std::vector<Id> gone;
    Id next = NumberKept(this->NewNumbers, gone, this->Beats);
    for (std::size_t k = 0; k < this->Strips.size(); ++k)
    {
      const RelaxedStrip& strip = this->Strips[k];
      this->NewStripNumbers[k].reserve(strip.Origins.size());
      for (std::size_t vertex = 0; vertex < strip.Origins.size() && this->Beats.Beat(); ++vertex)
      {
        const Id origin = strip.Origins[vertex];
        this->NewStripNumbers[k].push_back(
          origin == NoId ? next++ : this->NewNumbers[strip.Strip.Vertices[origin]]);
      }
    }
    this->NumberOfVertices = static_cast<std::size_t>(next);
  }

  void MarkGone(const RelaxedStrip& strip)
  {
    const std::vector<Id>& vertices = strip.Strip.Vertices;
    std::vector<std::uint8_t> stays(vertices.size(), 0);
    for (const Id origin : strip.Origins)
    {
      if (origin != NoId)
      {
        stays[origin] = 1;
      }
    }
    for (std::size_t k = 0; k < stays.size() && this->Beats.Beat(); ++k)
    {
      const bool isGone = stays[k] == 0 && !strip.Strip.IsFixed(static_cast<Id>(k));
      this->NewNumbers[vertices[k]] = isGone ? NoId : 0;
    }
  }

  std::vector<Id> ListGone() const
  {
    std::vector<Id> gone;
    for (const RelaxedStrip& strip : this->Strips)
    {
      for (const Id vertex : strip.Strip.Vertices)
      {
        if (this->NewNumbers[vertex] == NoId)
        {
          gone.push_back(vertex);
        }
      }
    }
    std::sort(gone.begin(), gone.end());
    return gone;
  }

  void MoveVertices()
  {
    BitingResult& bites = this->Whole.Bites;
    const std::vector<Id>& numbers = this->NewNumbers;
    DoEach(this->Beats,
      { [&numbers, &bites](Pulse& own) { CloseUp(numbers, 1, bites.Points, own); },
        [&numbers, &bites](Pulse& own) { CloseUp(numbers, 1, bites.Spacings, own); },
        [&numbers, &bites](Pulse& own) { CloseUp(numbers, 1, bites.BiteOrders, own); },
        [&numbers, &bites](Pulse& own) { CloseUp(numbers, 1, bites.Segments, own); } });
    bites.Points.resize(this->NumberOfVertices);
    bites.Spacings.resize(this->NumberOfVertices);
    bites.BiteOrders.resize(this->NumberOfVertices, NoId);
    bites.Segments.resize(this->NumberOfVertices, NoId);
    for (std::size_t k = 0; k < this->Strips.size(); ++k)
    {
      this->FillStrip(this->Strips[k], this->NewStripNumbers[k]);
    }
    for (std::vector<Id>* ends : { &bites.EdgeStarts, &bites.EdgeEnds })
    {
      ForEachAtOnce(this->Beats, ends->size(),
        [this, ends](std::size_t edge) { (*ends)[edge] = this->NewNumbers[(*ends)[edge]]; });
    }
  }

  void FillStrip(const RelaxedStrip& strip, const std::vector<Id>& numbers)
  {
    BitingResult& bites = this->Whole.Bites;
    for (std::size_t k = 0; k < numbers.size() && this->Beats.Beat(); ++k)
    {
      const std::size_t number = static_cast<std::size_t>(numbers[k]);
      bites.Points[number] = strip.Strip.Mesh.Points[k];
      bites.Spacings[number] = strip.Strip.Mesh.Spacings[k];
      if (strip.Origins[k] == NoId)
      {
        bites.BiteOrders[number] = NoId;
        bites.Segments[number] = NoId;
      }
    }
  }

  void NumberTriangles()
  {
    for (const RelaxedStrip& strip : this->Strips)
    {
      for (std::size_t k = 0; k < strip.Strip.Triangles.size() && this->Beats.Beat(); ++k)
      {
        this->NewTriangles[strip.Strip.Triangles[k]] = NoId;
      }
    }
    this->NumberOfTriangles =
      static_cast<std::size_t>(NumberKept(this->NewTriangles, this->Gone, this->Beats));
  }

  // The triangles outside of strips move together, in their order.
  void MoveTriangles()
  {
    Triangulation& whole = this->Whole.Triangles;
    ForEachAtOnce(this->Beats, whole.Corners.size(),
      [this, &whole](std::size_t slot)
      {
        const Id neighbor = whole.Neighbors[slot];
        whole.Corners[slot] = this->NewNumbers[whole.Corners[slot]];
        whole.Neighbors[slot] = neighbor == NoId ? NoId : this->NewTriangles[neighbor];
      });
    const std::vector<Id>& numbers = this->NewTriangles;
    DoEach(this->Beats,
      { [&numbers, &whole](Pulse& own) { CloseUp(numbers, 3, whole.Corners, own); },
        [&numbers, &whole](Pulse& own) { CloseUp(numbers, 3, whole.Neighbors, own); },
        [&numbers, &whole](Pulse& own) { CloseUp(numbers, 3, whole.Constraints, own); },
        [&numbers, &whole](Pulse& own) { CloseUp(numbers, 1, whole.Regions, own); } });
    whole.Corners.resize(3 * this->NumberOfTriangles);
    whole.Neighbors.resize(3 * this->NumberOfTriangles);
    whole.Constraints.resize(3 * this->NumberOfTriangles);
    whole.Regions.resize(this->NumberOfTriangles);
  }

  // Finds the first part of each segment; parts are listed segment by segment.
  void FindFirstParts(const TakenStrip& strip)
  {
    const std::vector<Id>& segments = strip.Mesh.EdgeSegments;
    this->FirstParts.assign(strip.Sides.size(), NoId);
    for (std::size_t part = segments.size(); part > 0; --part)
    {
      this->FirstParts[segments[part - 1]] = static_cast<Id>(part - 1);
    }
  }

  // The constraint of the whole that a part of the strip has, or NoId. The parts of a run have
  // consecutive constraints.
  Id ConstraintOf(const TakenStrip& strip, Id part) const
  {
    const Id segment = strip.Mesh.EdgeSegments[part];
    const Id first = strip.Sides[segment].Constraint;
    return first == NoId ? NoId : first + part - this->FirstParts[segment];
  }

  void AddStrip(const TakenStrip& strip, const std::vector<Id>& numbers)
  {
    Triangulation& whole = this->Whole.Triangles;
    const RelaxationMesh& mesh = strip.Mesh;
    const Triangulation& own = mesh.Triangles;
    const Id first = whole.NumberOfTriangles();
    const std::size_t begin = whole.Corners.size();
    for (std::vector<Id>* slots : { &whole.Corners, &whole.Neighbors, &whole.Constraints })
    {
      slots->resize(begin + own.Corners.size(), NoId);
    }
    ForEachAtOnce(this->Beats, own.Corners.size(),
      [this, begin, first, &whole, &own, &strip, &numbers](std::size_t slot)
      {
        const Id constraint = own.Constraints[slot];
        whole.Corners[begin + slot] = numbers[own.Corners[slot]];
        whole.Neighbors[begin + slot] =
          own.Neighbors[slot] == NoId ? NoId : first + own.Neighbors[slot];
        whole.Constraints[begin + slot] =
          constraint == NoId ? NoId : this->ConstraintOf(strip, constraint);
      });
    for (std::size_t slot = 0; slot < own.Corners.size(); ++slot)
    {
      const Id constraint = own.Constraints[slot];
      const Id outside =
        constraint == NoId ? NoId : strip.Sides[mesh.EdgeSegments[constraint]].Outside;
      if (outside != NoId)
      {
        this->Rim.push_back(begin + slot);
        const Id neighbor = this->NewTriangles[outside / 3];
        whole.Neighbors[begin + slot] = neighbor;
        whole.Neighbors[3 * static_cast<std::size_t>(neighbor) + outside % 3] =
          first + static_cast<Id>(slot / 3);
      }
    }
    whole.Regions.insert(whole.Regions.end(), own.Regions.begin(), own.Regions.end());
  }

  // A run has other edges after relaxation, perhaps fewer. An edge that is gone has no segment.
  void ChangeEdges(const TakenStrip& strip, const std::vector<Id>& numbers)
  {
    BitingResult& bites = this->Whole.Bites;
    const RelaxationMesh& mesh = strip.Mesh;
    for (std::size_t run = 0; run < strip.Sides.size() && this->Beats.Beat(); ++run)
    {
      const TakenStrip::Side& side = strip.Sides[run];
      for (Id k = 0; k < side.NumberOfParts && side.NumberOfParts > 1; ++k)
      {
        const std::size_t part = static_cast<std::size_t>(this->FirstParts[run] + k);
        const Id edge = side.Constraint + k;
        if (part < mesh.EdgeSegments.size() && mesh.EdgeSegments[part] == static_cast<Id>(run))
        {
          bites.EdgeStarts[edge] = numbers[mesh.EdgeStarts[part]];
          bites.EdgeEnds[edge] = numbers[mesh.EdgeEnds[part]];
        }
        else
        {
          bites.EdgeSegments[edge] = NoId;
        }
      }
    }
  }

  void CloseUpEdges()
  {
    BitingResult& bites = this->Whole.Bites;
    std::vector<Id> numbers(bites.EdgeSegments.size(), NoId);
    std::size_t count = 0;
    for (std::size_t edge = 0; edge < numbers.size() && this->Beats.Beat(); ++edge)
    {
      if (bites.EdgeSegments[edge] != NoId)
      {
        bites.EdgeStarts[count] = bites.EdgeStarts[edge];
        bites.EdgeEnds[count] = bites.EdgeEnds[edge];
        bites.EdgeSegments[count] = bites.EdgeSegments[edge];
        numbers[edge] = static_cast<Id>(count++);
      }
    }
    if (count == numbers.size())
    {
      return;
    }
    bites.EdgeStarts.resize(count);
    bites.EdgeEnds.resize(count);
    bites.EdgeSegments.resize(count);
    std::vector<Id>& constraints = this->Whole.Triangles.Constraints;
    ForEachAtOnce(this->Beats, constraints.size(),
      [&numbers, &constraints](std::size_t slot)
      { constraints[slot] = constraints[slot] == NoId ? NoId : numbers[constraints[slot]]; });
  }

  const std::vector<RelaxedStrip>& Strips;
  JoinedMesh& Whole;
  Pulse& Beats;
  std::vector<Id> NewNumbers; ///< of the whole's vertices, NoId where they are gone
  std::vector<std::vector<Id>> NewStripNumbers; ///< of the vertices of each strip
  std::size_t NumberOfVertices = 0;
  std::vector<Id> NewTriangles;      ///< of the whole's, NoId for those of strips
  std::vector<Id> Gone;              ///< triangles of strips, in their order
  std::size_t NumberOfTriangles = 0; ///< of the others
  std::vector<std::size_t> Rim;      ///< slots of the whole, at edges between strips and others
  std::vector<Id> FirstParts;        ///< of the segments of the strip at hand
};

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
    const std::size_t across = SlotAcross(mesh.Corners, slot, mesh.Neighbors[slot]);
    const auto corner = [&points, &mesh](std::size_t at) { return points[mesh.Corners[at]]; };
    if (InCircle(
          corner(slot), corner(NextSlotOf(slot)), corner(PreviousSlotOf(slot)), corner(across)) > 0)
    {
      Flip(mesh, slot, across);
      slots.insert(slots.end(), { slot, PreviousSlotOf(slot), across, PreviousSlotOf(across) });
    }
  }
  return isWhole;
}

StripChange ReturnStrips(const std::vector<RelaxedStrip>& strips, JoinedMesh& mesh, Pulse& pulse)
{
  return StripReturn(strips, mesh, pulse).Run();
}

} // namespace biting
