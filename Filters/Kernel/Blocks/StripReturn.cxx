// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "StripReturn.h"

#include "../Base/Tasks.h"
#include "../Predicates/Predicates.h"

#include <algorithm> // for copy, count, min, sort
#include <array>     // for lists of arrays
#include <cstdint>   // for flags
#include <numeric>   // for sums
#include <utility>   // for move

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

// Numbers what is not NoId, in its order, and lists the places of what is. Returns how many the
// first are.
Id NumberKept(std::vector<Id>& numbers, std::vector<Id>& gone, Pulse& pulse)
{
  const std::size_t size = numbers.size();
  std::vector<Id> before((size + StepsPerTask - 1) / StepsPerTask + 1, 0); // kept ones, of tasks
  const auto endOf = [size](std::size_t k) { return std::min(size, (k + 1) * StepsPerTask); };
  DoTasks(pulse, before.size() - 1,
    [&numbers, &before, &endOf](std::size_t k, Monitor&)
    {
      const Id* first = numbers.data();
      const auto left = std::count(first + k * StepsPerTask, first + endOf(k), NoId);
      before[k + 1] = static_cast<Id>(endOf(k) - k * StepsPerTask) - static_cast<Id>(left);
    });
  std::partial_sum(before.begin(), before.end(), before.begin());
  gone.resize(size - static_cast<std::size_t>(before.back()));
  DoTasks(pulse, before.size() - 1,
    [&numbers, &gone, &before, &endOf](std::size_t k, Monitor&)
    {
      Id kept = before[k];
      Id* next = gone.data() + (k * StepsPerTask - static_cast<std::size_t>(kept));
      for (std::size_t place = k * StepsPerTask; place < endOf(k); ++place)
      {
        Id& number = numbers[place];
        number == NoId ? void(*next++ = static_cast<Id>(place)) : void(number = kept++);
      }
    });
  return before.back();
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

  StripChange Run();

private:
  void MakeRoom();
  void NumberVertices();
  void MarkGone(const RelaxedStrip& strip);
  std::vector<Id> ListGone() const;
  void MoveVertices();
  void CloseUp();
  template <typename Value>
  void CloseUp(std::vector<Value>& values, Pulse& own) const;
  void FillStrip(const RelaxedStrip& strip, const std::vector<Id>& numbers);
  void NumberTriangles();
  void MoveTriangles();
  void CloseUpTriangles();
  void CloseUpTriangles(std::vector<Id>& values, std::size_t size, Pulse& own) const;
  void FindFirstParts(const TakenStrip& strip);
  Id ConstraintOf(const TakenStrip& strip, Id part) const;
  void AddStrip(const TakenStrip& strip, const std::vector<Id>& numbers);
  void ChangeEdges(const TakenStrip& strip, const std::vector<Id>& numbers);
  void CloseUpEdges();

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

StripChange StripReturn::Run()
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

// What stays as long as nobody says otherwise.
void StripReturn::MakeRoom()
{
  const std::size_t vertices = this->Whole.Bites.Points.size();
  const std::size_t triangles = this->Whole.Triangles.Regions.size();
  DoEach(this->Beats,
    { [this, vertices](Pulse& own) { GrowInSteps(this->NewNumbers, vertices, Id{ 0 }, own); },
      [this, triangles](Pulse& own)
      { GrowInSteps(this->NewTriangles, triangles, Id{ 0 }, own); } });
}

// What stays, in its order, then what is new.
void StripReturn::NumberVertices()
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

void StripReturn::MarkGone(const RelaxedStrip& strip)
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

std::vector<Id> StripReturn::ListGone() const
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

void StripReturn::MoveVertices()
{
  this->CloseUp();
  BitingResult& bites = this->Whole.Bites;
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

// Array by array as tasks.
void StripReturn::CloseUp()
{
  BitingResult& bites = this->Whole.Bites;
  DoEach(this->Beats,
    { [this, &bites](Pulse& own) { this->CloseUp(bites.Points, own); },
      [this, &bites](Pulse& own) { this->CloseUp(bites.Spacings, own); },
      [this, &bites](Pulse& own) { this->CloseUp(bites.BiteOrders, own); },
      [this, &bites](Pulse& own) { this->CloseUp(bites.Segments, own); } });
}

template <typename Value>
void StripReturn::CloseUp(std::vector<Value>& values, Pulse& own) const
{
  own.ForEach(this->NewNumbers.size(),
    [this, &values](std::size_t vertex)
    {
      const Id number = this->NewNumbers[vertex];
      if (number != NoId)
      {
        values[number] = values[vertex];
      }
    });
}

void StripReturn::FillStrip(const RelaxedStrip& strip, const std::vector<Id>& numbers)
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

void StripReturn::NumberTriangles()
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

// Those that are of no strip close up.
void StripReturn::MoveTriangles()
{
  Triangulation& whole = this->Whole.Triangles;
  ForEachAtOnce(this->Beats, whole.Corners.size(),
    [this, &whole](std::size_t slot)
    {
      const Id neighbor = whole.Neighbors[slot];
      whole.Corners[slot] = this->NewNumbers[whole.Corners[slot]];
      whole.Neighbors[slot] = neighbor == NoId ? NoId : this->NewTriangles[neighbor];
    });
  this->CloseUpTriangles();
  whole.Corners.resize(3 * this->NumberOfTriangles);
  whole.Neighbors.resize(3 * this->NumberOfTriangles);
  whole.Constraints.resize(3 * this->NumberOfTriangles);
  whole.Regions.resize(this->NumberOfTriangles);
}

// Run by run between triangles of strips, array by array as tasks.
void StripReturn::CloseUpTriangles()
{
  Triangulation& whole = this->Whole.Triangles;
  const std::array<std::vector<Id>*, 4> arrays{ &whole.Corners, &whole.Neighbors,
    &whole.Constraints, &whole.Regions };
  DoTasks(this->Beats, arrays.size(),
    [this, &arrays](std::size_t k, Monitor& monitor)
    {
      Pulse own(monitor);
      this->CloseUpTriangles(*arrays[k], k < 3 ? 3 : 1, own);
    });
}

void StripReturn::CloseUpTriangles(std::vector<Id>& values, std::size_t size, Pulse& own) const
{
  const std::vector<Id>& gone = this->Gone;
  for (std::size_t k = 0; k < gone.size() && own.Beat(); ++k)
  {
    const std::size_t first = size * (static_cast<std::size_t>(gone[k]) + 1);
    const std::size_t last = size *
      (k + 1 < gone.size() ? static_cast<std::size_t>(gone[k + 1]) : this->NewTriangles.size());
    std::copy(values.data() + first, values.data() + last,
      values.data() + size * (static_cast<std::size_t>(gone[k]) - k));
  }
}

// They are listed segment by segment.
void StripReturn::FindFirstParts(const TakenStrip& strip)
{
  const std::vector<Id>& segments = strip.Mesh.EdgeSegments;
  this->FirstParts.assign(strip.Sides.size(), NoId);
  for (std::size_t part = segments.size(); part > 0; --part)
  {
    this->FirstParts[segments[part - 1]] = static_cast<Id>(part - 1);
  }
}

// Of the whole, or NoId. Parts of a run have its constraints, one after the other.
Id StripReturn::ConstraintOf(const TakenStrip& strip, Id part) const
{
  const Id segment = strip.Mesh.EdgeSegments[part];
  const Id first = strip.Sides[segment].Constraint;
  return first == NoId ? NoId : first + part - this->FirstParts[segment];
}

void StripReturn::AddStrip(const TakenStrip& strip, const std::vector<Id>& numbers)
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

// Runs have other edges now, and perhaps fewer: those that are gone have no segment any more.
void StripReturn::ChangeEdges(const TakenStrip& strip, const std::vector<Id>& numbers)
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

void StripReturn::CloseUpEdges()
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

StripChange ReturnStrips(const std::vector<RelaxedStrip>& strips, JoinedMesh& mesh, Pulse& pulse)
{
  return StripReturn(strips, mesh, pulse).Run();
}

} // namespace biting
