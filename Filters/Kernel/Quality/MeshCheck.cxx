// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshCheck.h"

#include "../Base/Marks.h"
#include "../Base/Pulse.h"
#include "../Base/Tasks.h"
#include "../Predicates/Predicates.h"
#include "CheckSums.h"
#include "Components.h"

#include <algorithm> // for min, max
#include <cmath>     // for abs
#include <cstdint>   // for marks
#include <limits>    // for epsilon
#include <sstream>   // for messages

namespace biting
{

namespace
{

// Where the checks end, as shares of the time.
constexpr double IdsEnd = 0.1;
constexpr double TurnsEnd = 0.4;
constexpr double NeighborsEnd = 0.7;
constexpr double UsesEnd = 0.8;
constexpr double ComponentsEnd = 0.98;

constexpr std::size_t Next(std::size_t slot)
{
  return slot % 3 == 2 ? slot - 2 : slot + 1;
}

constexpr std::size_t Previous(std::size_t slot)
{
  return slot % 3 == 0 ? slot + 2 : slot - 1;
}

// How a vertex is used.
enum Use : std::uint8_t
{
  None,
  Inner,
  Boundary
};

class MeshChecker
{
public:
  MeshChecker(const MeshCheckInput& mesh, Pulse& pulse)
    : Mesh(mesh)
    , Beats(pulse)
  {
  }
  std::string Check();

private:
  bool HasValidSizes();
  bool HasValidIds();
  bool IsCounterclockwise();
  bool HasMutualNeighbors();
  bool IsLink(std::size_t slot, std::size_t across) const;
  bool IsLocallyDelaunay(std::size_t slot, std::size_t across) const;
  std::size_t SlotAcross(std::size_t slot) const;
  bool HasConstrainedBoundary();
  bool HasNoUnusedVertex();
  Marks FindUses();
  bool FulfilsEuler();
  std::int64_t CountComponents();
  Id PartOf(std::size_t triangle, const std::vector<Id>& partOf, ComponentSum& sum) const;
  std::int64_t CountLoops();
  std::size_t NextOnBoundary(std::size_t slot) const;
  bool CoversArea();
  double BoundaryRounding() const;
  bool IsGoingOn(std::size_t slot);
  bool Refuse(const std::string& violation);
  std::string EdgeText(std::size_t slot) const;

  std::size_t Corner(std::size_t slot) const
  {
    return static_cast<std::size_t>(this->Mesh.Corners[slot]);
  }
  const Point2& Place(std::size_t slot) const { return this->Mesh.Points[this->Corner(slot)]; }

  const MeshCheckInput& Mesh;
  Pulse& Beats;
  std::string Violation;
  std::vector<std::size_t> BoundarySlots;
  std::int64_t NumberOfInnerVertices = 0;
  TurnSum Turns;
};

std::string MeshChecker::Check()
{
  const bool isSound = this->HasValidSizes() && this->HasValidIds() && this->IsCounterclockwise() &&
    this->HasMutualNeighbors() && this->HasConstrainedBoundary() && this->HasNoUnusedVertex() &&
    this->FulfilsEuler() && this->CoversArea();
  return isSound ? std::string() : this->Violation;
}

bool MeshChecker::HasValidSizes()
{
  const std::size_t size = this->Mesh.Corners.size();
  return (size % 3 == 0 && this->Mesh.Neighbors.size() == size &&
           this->Mesh.Constraints.size() == size) ||
    this->Refuse("the arrays of the triangles differ in size");
}

bool MeshChecker::HasValidIds()
{
  const PulsePart part(this->Beats, 0.0, IdsEnd);
  const std::size_t numberOfTriangles = this->Mesh.Corners.size() / 3;
  const auto first = SumAtOnce(this->Beats, this->Mesh.Corners.size(), FirstDefect(),
    [this, numberOfTriangles](FirstDefect& defect, std::size_t slot)
    {
      const Id neighbor = this->Mesh.Neighbors[slot];
      // A negative id becomes a large number.
      const bool isNeighborValid =
        neighbor == NoId || static_cast<std::size_t>(neighbor) < numberOfTriangles;
      defect.Add(slot, this->Corner(slot) >= this->Mesh.Points.size() || !isNeighborValid);
    });
  return !first.Exists() ||
    this->Refuse("an id of triangle " + std::to_string(first.Slot / 3) + " is out of range");
}

// Adds the areas on the way, as the places are at hand.
bool MeshChecker::IsCounterclockwise()
{
  const PulsePart part(this->Beats, IdsEnd, TurnsEnd);
  this->Turns = SumAtOnce(this->Beats, this->Mesh.Corners.size() / 3, TurnSum(),
    [this](TurnSum& sum, std::size_t triangle)
    {
      const Point2& a = this->Place(3 * triangle);
      const Point2& b = this->Place(3 * triangle + 1);
      const Point2& c = this->Place(3 * triangle + 2);
      sum.Wrong.Add(3 * triangle, Orient2D(a, b, c) <= 0);
      sum.AddArea(a, b, c);
    });
  const FirstDefect& wrong = this->Turns.Wrong;
  return !wrong.Exists() ||
    this->Refuse("triangle " + std::to_string(wrong.Slot / 3) + " is not counterclockwise");
}

// A link to a smaller triangle is followed there, to a slot that must name this triangle. As no
// slot can answer two triangles, all links to larger triangles are answered too if there are as
// many.
bool MeshChecker::HasMutualNeighbors()
{
  const PulsePart part(this->Beats, TurnsEnd, NeighborsEnd);
  LinkSum links = SumAtOnce(this->Beats, this->Mesh.Neighbors.size(), LinkSum(),
    [this](LinkSum& sum, std::size_t slot)
    {
      const Id neighbor = this->Mesh.Neighbors[slot];
      if (neighbor == NoId)
      {
        sum.BoundarySlots.push_back(slot);
        return;
      }
      const bool isLarger = static_cast<std::size_t>(neighbor) > slot / 3;
      sum.Unanswered += isLarger ? 1 : -1;
      if (!isLarger)
      {
        const std::size_t across = this->SlotAcross(slot);
        const bool isLink = this->IsLink(slot, across);
        sum.Wrong.Add(slot, !isLink);
        sum.Bent.Add(
          slot, isLink && this->Mesh.IsDelaunay && !this->IsLocallyDelaunay(slot, across));
      }
    });
  this->BoundarySlots.swap(links.BoundarySlots);
  if (links.Wrong.Exists())
  {
    return this->Refuse("the triangles at " + this->EdgeText(links.Wrong.Slot) + " do not match");
  }
  if (links.Bent.Exists())
  {
    return this->Refuse(this->EdgeText(links.Bent.Slot) + " is not Delaunay");
  }
  return links.Unanswered == 0 || this->Refuse("neighbors are not mutual");
}

bool MeshChecker::IsLink(std::size_t slot, std::size_t across) const
{
  return static_cast<std::size_t>(this->Mesh.Neighbors[across]) == slot / 3 &&
    this->Corner(Next(across)) == this->Corner(Previous(slot)) &&
    this->Corner(Previous(across)) == this->Corner(Next(slot)) &&
    this->Mesh.Constraints[across] == this->Mesh.Constraints[slot];
}

// Of a link, where no constraint is.
bool MeshChecker::IsLocallyDelaunay(std::size_t slot, std::size_t across) const
{
  return this->Mesh.Constraints[slot] != NoId ||
    InCircle(this->Place(slot), this->Place(Next(slot)), this->Place(Previous(slot)),
      this->Place(across)) <= 0;
}

// The slot of the neighbor whose edge starts where that of `slot` ends; any where there is none.
// Without branches: which corner it is cannot be predicted.
std::size_t MeshChecker::SlotAcross(std::size_t slot) const
{
  constexpr std::size_t SlotBefore[] = { 2, 0, 1, 1 };
  const std::size_t first = 3 * static_cast<std::size_t>(this->Mesh.Neighbors[slot]);
  const Id end = this->Mesh.Corners[Previous(slot)];
  const std::size_t isSecond = this->Mesh.Corners[first + 1] == end ? 1 : 0;
  const std::size_t isThird = this->Mesh.Corners[first + 2] == end ? 2 : 0;
  return first + SlotBefore[isSecond + isThird];
}

bool MeshChecker::HasConstrainedBoundary()
{
  for (std::size_t k = 0; k < this->BoundarySlots.size() && this->IsGoingOn(k); ++k)
  {
    const std::size_t slot = this->BoundarySlots[k];
    if (this->Mesh.Constraints[slot] == NoId)
    {
      return this->Refuse("no constraint covers the boundary at " + this->EdgeText(slot));
    }
  }
  return true;
}

bool MeshChecker::HasNoUnusedVertex()
{
  const Marks uses = this->FindUses();
  const UseSum sum = SumAtOnce(this->Beats, uses.Size(), UseSum(),
    [&uses](UseSum& own, std::size_t vertex)
    {
      own.Inner += uses[vertex] == Inner ? 1 : 0;
      own.Unused.Add(vertex, uses[vertex] == None);
    });
  this->NumberOfInnerVertices = sum.Inner;
  return !sum.Unused.Exists() ||
    this->Refuse("vertex " + std::to_string(sum.Unused.Slot) + " belongs to no triangle");
}

// The Use of each vertex.
Marks MeshChecker::FindUses()
{
  const PulsePart part(this->Beats, NeighborsEnd, UsesEnd);
  Marks uses(this->Mesh.Points.size());
  ForEachAtOnce(this->Beats, this->Mesh.Corners.size(),
    [this, &uses](std::size_t slot) { uses.Set(this->Corner(slot), Inner); });
  this->Beats.ForEach(this->BoundarySlots.size(),
    [this, &uses](std::size_t k)
    { uses.Set(this->Corner(Next(this->BoundarySlots[k])), Boundary); });
  return uses;
}

// Each fan of triangles at the boundary has one boundary edge that leaves its vertex: with B
// boundary edges and V inner vertices there are V + B fans. E = (3 F + B) / 2, so twice the formula
// is 2 V + B - F = 4 C - 2 L.
bool MeshChecker::FulfilsEuler()
{
  const std::int64_t numberOfTriangles = static_cast<std::int64_t>(this->Mesh.Corners.size() / 3);
  const std::int64_t numberOfBoundaryEdges = static_cast<std::int64_t>(this->BoundarySlots.size());
  const std::int64_t components = this->CountComponents();
  const std::int64_t loops = this->CountLoops();
  const std::int64_t found =
    2 * this->NumberOfInnerVertices + numberOfBoundaryEdges - numberOfTriangles;
  return found == 4 * components - 2 * loops ||
    this->Refuse("Euler's formula fails for " + std::to_string(components) + " components and " +
      std::to_string(loops) + " boundary loops");
}

// Each triangle takes the part of a neighbor before it, or begins a part where there is none; where
// it has neighbors of different parts, these are one. There are few parts, so joining costs little.
// Each task does so with its triangles; then the parts of different tasks are joined.
std::int64_t MeshChecker::CountComponents()
{
  const PulsePart counting(this->Beats, UsesEnd, ComponentsEnd);
  std::vector<Id> partOf(this->Mesh.Neighbors.size() / 3, NoId);
  ComponentSum sum = SumAtOnce(this->Beats, partOf.size(), ComponentSum(),
    [this, &partOf](ComponentSum& own, std::size_t triangle)
    { partOf[triangle] = this->PartOf(triangle, partOf, own); });
  if (this->Beats.HasStopped())
  {
    return 0;
  }
  for (const ComponentSum::Link& link : sum.Links)
  {
    const std::size_t across = static_cast<std::size_t>(link.Across);
    sum.Components.Join(link.Part, sum.Begins[across / StepsPerTask] + partOf[across]);
  }
  return sum.Components.Count();
}

// Among the parts of its task. What lies across in an earlier one is kept for later.
Id MeshChecker::PartOf(std::size_t triangle, const std::vector<Id>& partOf, ComponentSum& sum) const
{
  const Id begin = static_cast<Id>(triangle - triangle % StepsPerTask);
  const Id* across = this->Mesh.Neighbors.data() + 3 * triangle;
  Id part = NoId;
  bool hasEarlier = false;
  for (int corner = 0; corner < 3; ++corner)
  {
    const bool isBefore = across[corner] < static_cast<Id>(triangle);
    if (isBefore && across[corner] >= begin)
    {
      part = sum.Components.Join(part, partOf[static_cast<std::size_t>(across[corner])]);
    }
    hasEarlier = hasEarlier || (across[corner] != NoId && across[corner] < begin);
  }
  part = part == NoId ? sum.Components.Begin() : part;
  for (int corner = 0; hasEarlier && corner < 3; ++corner)
  {
    if (across[corner] != NoId && across[corner] < begin)
    {
      sum.Links.push_back({ part, across[corner] });
    }
  }
  return part;
}

std::int64_t MeshChecker::CountLoops()
{
  const PulsePart part(this->Beats, ComponentsEnd, 1.0);
  std::vector<bool> isTraced(this->Mesh.Neighbors.size(), false);
  std::int64_t count = 0;
  for (const std::size_t start : this->BoundarySlots)
  {
    count += isTraced[start] ? 0 : 1;
    for (std::size_t slot = start; !isTraced[slot] && this->Beats.Beat();
         slot = this->NextOnBoundary(slot))
    {
      isTraced[slot] = true;
    }
  }
  return count;
}

// Turns about the end of the boundary edge, through its fan of triangles, to the other boundary
// edge of the fan. Neighbors are mutual, so the turn cannot come to a triangle again.
std::size_t MeshChecker::NextOnBoundary(std::size_t slot) const
{
  std::size_t leaving = Next(slot);
  while (this->Mesh.Neighbors[leaving] != NoId)
  {
    leaving = Next(this->SlotAcross(leaving));
  }
  return leaving;
}

bool MeshChecker::CoversArea()
{
  const double area = 0.5 * this->Turns.DoubledArea.Value();
  const double expected = this->Mesh.ExpectedArea;
  const double rounding =
    std::numeric_limits<double>::epsilon() * (this->Turns.AreaMagnitude + this->BoundaryRounding());
  if (std::abs(area - expected) <= rounding + this->Mesh.AreaTolerance * std::abs(expected))
  {
    return true;
  }
  std::ostringstream text;
  text.precision(17);
  text << "the area is " << area << " instead of " << expected;
  return this->Refuse(text.str());
}

// A boundary vertex may be off its segment by a few ulps, each at most epsilon times the largest
// coordinate; here 4 are allowed, as in the resolution of a domain.
double MeshChecker::BoundaryRounding() const
{
  double length = 0.0;
  double largest = 0.0;
  for (const std::size_t slot : this->BoundarySlots)
  {
    const Point2& start = this->Place(Next(slot));
    length += Distance(start, this->Place(Previous(slot)));
    largest = std::max({ largest, std::abs(start.X), std::abs(start.Y) });
  }
  return 4.0 * length * largest;
}

// Asks the monitor now and then; slots that are counted by threes are asked as often.
bool MeshChecker::IsGoingOn(std::size_t slot)
{
  if (slot % 4096 != 0)
  {
    return true;
  }
  this->Beats.SetFraction(
    static_cast<double>(slot) / static_cast<double>(this->Mesh.Corners.size()));
  return this->Beats.Ask();
}

bool MeshChecker::Refuse(const std::string& violation)
{
  this->Violation = violation;
  return false;
}

std::string MeshChecker::EdgeText(std::size_t slot) const
{
  const Point2& start = this->Place(Next(slot));
  const Point2& end = this->Place(Previous(slot));
  std::ostringstream text;
  text << "edge " << this->Corner(Next(slot)) << " - " << this->Corner(Previous(slot))
       << " of triangle " << slot / 3 << ", (" << start.X << ", " << start.Y << ") - (" << end.X
       << ", " << end.Y << ")";
  return text.str();
}

} // namespace

std::string CheckMesh(const MeshCheckInput& mesh, Monitor& monitor)
{
  Pulse pulse(monitor);
  return MeshChecker(mesh, pulse).Check();
}

} // namespace biting
