// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CutStrip.h"

#include "../Base/PartOfStage.h"
#include "../Base/Pulse.h"
#include "../Base/Tasks.h"
#include "../Relaxation/Relaxation.h"
#include "RimFlips.h"
#include "TakenStrip.h"

#include <algorithm>  // for copy
#include <array>      // for lists of arrays
#include <cstdint>    // for flags
#include <functional> // for tasks

namespace biting
{

namespace
{

// Angles below 46 degrees are made better, below 44 also one by one.
constexpr double PoorInStrip = 0.80;

// Where steps end, as shares of the time.
constexpr double TakingEnd = 0.1;
constexpr double RelaxingEnd = 0.8;

// Puts the relaxed strip back into the whole.
class StripReturn
{
public:
  StripReturn(
    const TakenStrip& strip, const std::vector<Id>& origins, JoinedMesh& mesh, Pulse& pulse)
    : Strip(strip)
    , Origins(origins)
    , Whole(mesh)
    , Beats(pulse)
  {
  }

  void Run();

private:
  void NumberVertices();
  void MoveVertices();
  void CloseUp();
  template <typename Value>
  void CloseUp(std::vector<Value>& values, Pulse& own) const;
  void FillStrip();
  void NumberTriangles();
  void MoveTriangles();
  void CloseUpTriangles();
  void CloseUpTriangles(std::vector<Id>& values, std::size_t size, Pulse& own) const;
  void FindFirstParts();
  Id ConstraintOf(Id part) const;
  void AddStrip();
  void ChangeEdges();
  void CloseUpEdges();

  const TakenStrip& Strip;
  const std::vector<Id>& Origins; ///< of the relaxed vertices, in the strip before
  JoinedMesh& Whole;
  Pulse& Beats;
  std::vector<Id> NewNumbers;      ///< of the whole's vertices, NoId where they are gone
  std::vector<Id> NewStripNumbers; ///< of the strip's
  std::size_t NumberOfVertices = 0;
  std::vector<Id> NewTriangles;      ///< numbers of the whole's triangles that are not of the strip
  std::size_t NumberOfTriangles = 0; ///< of these
  std::vector<std::size_t> Rim;      ///< slots of the whole, at edges to what is not of the strip
  std::vector<Id> FirstParts;        ///< of the segments of the strip
};

void StripReturn::Run()
{
  this->NumberVertices();
  this->NumberTriangles();
  if (this->Beats.HasStopped())
  {
    return;
  }
  this->MoveVertices();
  this->MoveTriangles();
  if (!this->Beats.HasStopped())
  {
    this->FindFirstParts();
    this->AddStrip();
    this->ChangeEdges();
    this->CloseUpEdges();
    FlipUntilDelaunay(this->Whole.Bites.Points, this->Rim, this->Whole.Triangles, this->Beats);
  }
}

// What stays, in its order, then what is new.
void StripReturn::NumberVertices()
{
  const std::size_t count = this->Whole.Bites.Points.size();
  std::vector<std::uint8_t> stays(this->Strip.Vertices.size(), 0);
  for (const Id origin : this->Origins)
  {
    if (origin != NoId)
    {
      stays[origin] = 1;
    }
  }
  GrowInSteps(this->NewNumbers, count, Id{ 0 }, this->Beats);
  for (std::size_t k = 0; k < stays.size() && this->Beats.Beat(); ++k)
  {
    const bool isGone = stays[k] == 0 && !this->Strip.IsFixed(static_cast<Id>(k));
    this->NewNumbers[this->Strip.Vertices[k]] = isGone ? NoId : 0;
  }
  Id next = 0;
  this->Beats.ForEach(count,
    [this, &next](std::size_t vertex)
    {
      Id& number = this->NewNumbers[vertex];
      number = number == NoId ? NoId : next++;
    });
  for (std::size_t k = 0; k < this->Origins.size() && this->Beats.Beat(); ++k)
  {
    const Id origin = this->Origins[k];
    this->NewStripNumbers.push_back(
      origin == NoId ? next++ : this->NewNumbers[this->Strip.Vertices[origin]]);
  }
  this->NumberOfVertices = static_cast<std::size_t>(next);
}

void StripReturn::MoveVertices()
{
  this->CloseUp();
  BitingResult& bites = this->Whole.Bites;
  bites.Points.resize(this->NumberOfVertices);
  bites.Spacings.resize(this->NumberOfVertices);
  bites.BiteOrders.resize(this->NumberOfVertices, NoId);
  bites.Segments.resize(this->NumberOfVertices, NoId);
  this->FillStrip();
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
  const std::array<std::function<void(Pulse&)>, 4> tasks{ [this, &bites](Pulse& own)
    { this->CloseUp(bites.Points, own); },
    [this, &bites](Pulse& own) { this->CloseUp(bites.Spacings, own); },
    [this, &bites](Pulse& own) { this->CloseUp(bites.BiteOrders, own); },
    [this, &bites](Pulse& own) { this->CloseUp(bites.Segments, own); } };
  DoTasks(this->Beats, tasks.size(),
    [&tasks](std::size_t k, Monitor& monitor)
    {
      Pulse own(monitor);
      tasks[k](own);
    });
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

void StripReturn::FillStrip()
{
  BitingResult& bites = this->Whole.Bites;
  for (std::size_t k = 0; k < this->NewStripNumbers.size() && this->Beats.Beat(); ++k)
  {
    const std::size_t number = static_cast<std::size_t>(this->NewStripNumbers[k]);
    bites.Points[number] = this->Strip.Mesh.Points[k];
    bites.Spacings[number] = this->Strip.Mesh.Spacings[k];
    if (this->Origins[k] == NoId)
    {
      bites.BiteOrders[number] = NoId;
      bites.Segments[number] = NoId;
    }
  }
}

void StripReturn::NumberTriangles()
{
  Id count = 0;
  GrowInSteps(this->NewTriangles, this->Strip.TriangleNumbers.size(), Id{ NoId }, this->Beats);
  this->Beats.ForEach(this->NewTriangles.size(),
    [this, &count](std::size_t triangle) {
      this->NewTriangles[triangle] = this->Strip.TriangleNumbers[triangle] == NoId ? count++ : NoId;
    });
  this->NumberOfTriangles = static_cast<std::size_t>(count);
}

// Those that are not of the strip close up.
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

// Run by run between triangles of the strip, array by array as tasks.
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
  const std::vector<Id>& gone = this->Strip.Triangles;
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
void StripReturn::FindFirstParts()
{
  const std::vector<Id>& segments = this->Strip.Mesh.EdgeSegments;
  this->FirstParts.assign(this->Strip.Sides.size(), NoId);
  for (std::size_t part = segments.size(); part > 0; --part)
  {
    this->FirstParts[segments[part - 1]] = static_cast<Id>(part - 1);
  }
}

// Of the whole, or NoId. Parts of a run have its constraints, one after the other.
Id StripReturn::ConstraintOf(Id part) const
{
  const Id segment = this->Strip.Mesh.EdgeSegments[part];
  const Id first = this->Strip.Sides[segment].Constraint;
  return first == NoId ? NoId : first + part - this->FirstParts[segment];
}

void StripReturn::AddStrip()
{
  Triangulation& whole = this->Whole.Triangles;
  const RelaxationMesh& mesh = this->Strip.Mesh;
  const Triangulation& strip = mesh.Triangles;
  const Id first = whole.NumberOfTriangles();
  for (std::size_t slot = 0; slot < strip.Corners.size(); ++slot)
  {
    const Id constraint = strip.Constraints[slot];
    const Id outside =
      constraint == NoId ? NoId : this->Strip.Sides[mesh.EdgeSegments[constraint]].Outside;
    Id neighbor = strip.Neighbors[slot] == NoId ? NoId : first + strip.Neighbors[slot];
    if (outside != NoId)
    {
      this->Rim.push_back(3 * static_cast<std::size_t>(first) + slot);
      neighbor = this->NewTriangles[outside / 3];
      whole.Neighbors[3 * static_cast<std::size_t>(neighbor) + outside % 3] =
        first + static_cast<Id>(slot / 3);
    }
    whole.Corners.push_back(this->NewStripNumbers[strip.Corners[slot]]);
    whole.Neighbors.push_back(neighbor);
    whole.Constraints.push_back(constraint == NoId ? NoId : this->ConstraintOf(constraint));
  }
  whole.Regions.insert(whole.Regions.end(), strip.Regions.begin(), strip.Regions.end());
}

// Runs have other edges now, and perhaps fewer: those that are gone have no segment any more.
void StripReturn::ChangeEdges()
{
  BitingResult& bites = this->Whole.Bites;
  const RelaxationMesh& mesh = this->Strip.Mesh;
  for (std::size_t run = 0; run < this->Strip.Sides.size() && this->Beats.Beat(); ++run)
  {
    const TakenStrip::Side& side = this->Strip.Sides[run];
    for (Id k = 0; k < side.NumberOfParts && side.NumberOfParts > 1; ++k)
    {
      const std::size_t part = static_cast<std::size_t>(this->FirstParts[run] + k);
      const Id edge = side.Constraint + k;
      if (part < mesh.EdgeSegments.size() && mesh.EdgeSegments[part] == static_cast<Id>(run))
      {
        bites.EdgeStarts[edge] = this->NewStripNumbers[mesh.EdgeStarts[part]];
        bites.EdgeEnds[edge] = this->NewStripNumbers[mesh.EdgeEnds[part]];
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

void RelaxCuts(const Domain& domain, const std::vector<std::uint8_t>& areTouching,
  const Spacing& spacing, JoinedMesh& mesh, Monitor& monitor)
{
  PartOfStage taking(monitor, 0.0, TakingEnd);
  Pulse takingPulse(taking);
  TakenStrip strip = TakeStrip(domain, areTouching, mesh, takingPulse);
  if (takingPulse.HasStopped() || strip.IsEmpty())
  {
    return;
  }
  PartOfStage relaxing(monitor, TakingEnd, RelaxingEnd);
  const RelaxationResult result =
    Relax(strip.Border, spacing, { false, true, PoorInStrip }, strip.Mesh, relaxing);
  if (!result.WasAborted)
  {
    PartOfStage returning(monitor, RelaxingEnd, 1.0);
    Pulse pulse(returning);
    StripReturn(strip, result.Origins, mesh, pulse).Run();
  }
}

} // namespace biting
