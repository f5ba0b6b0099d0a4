// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshCheck.h"

#include "../Base/Marks.h"
#include "../Base/Pulse.h"
#include "../Base/Tasks.h"
#include "../Base/TriangleSlots.h"
#include "../Predicates/Predicates.h"
#include "CheckSums.h"
#include "Components.h" // for UseSum
#include "MeshParts.h"

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

// How a vertex is used.
enum Use : std::uint8_t
{
  None,
  Inner,
  Boundary
};

bool HasValidSizes(const MeshCheckInput& mesh)
{
  const std::size_t size = mesh.Corners.size();
  return size % 3 == 0 && mesh.Neighbors.size() == size && mesh.Constraints.size() == size;
}

std::string EdgeText(const MeshCheckInput& mesh, std::size_t slot)
{
  const Id startId = mesh.Corners[NextSlotOf(slot)];
  const Id endId = mesh.Corners[PreviousSlotOf(slot)];
  const Point2& start = mesh.Points[static_cast<std::size_t>(startId)];
  const Point2& end = mesh.Points[static_cast<std::size_t>(endId)];
  std::ostringstream text;
  text << "edge " << startId << " - " << endId << " of triangle " << slot / 3 << ", (" << start.X
       << ", " << start.Y << ") - (" << end.X << ", " << end.Y << ")";
  return text.str();
}

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
  bool HasValidIds();
  bool IsCounterclockwise();
  bool HasMutualNeighbors();
  void FollowLink(std::size_t triangle, std::size_t slot, LinkSum& sum) const;
  bool IsLink(std::size_t slot, std::size_t across) const;
  bool IsLocallyDelaunay(std::size_t slot, std::size_t across) const;
  bool HasConstrainedBoundary();
  bool HasNoUnusedVertex();
  Marks FindUses();
  bool FulfilsEuler();
  std::int64_t CountParts();
  std::int64_t CountLoops();
  bool CoversArea();
  double BoundaryRounding() const;
  bool IsGoingOn(std::size_t slot);
  bool Refuse(const std::string& violation);

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
  const bool isSound = this->HasValidIds() && this->IsCounterclockwise() &&
    this->HasMutualNeighbors() && this->HasConstrainedBoundary() && this->HasNoUnusedVertex() &&
    this->FulfilsEuler() && this->CoversArea();
  return isSound ? std::string() : this->Violation;
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
  LinkSum links = SumAtOnce(this->Beats, this->Mesh.Neighbors.size() / 3, LinkSum(),
    [this](LinkSum& sum, std::size_t triangle)
    {
      for (std::size_t slot = 3 * triangle; slot < 3 * triangle + 3; ++slot)
      {
        this->FollowLink(triangle, slot, sum);
      }
    });
  this->BoundarySlots.swap(links.BoundarySlots);
  if (links.Wrong.Exists())
  {
    return this->Refuse(
      "the triangles at " + EdgeText(this->Mesh, links.Wrong.Slot) + " do not match");
  }
  if (links.Bent.Exists())
  {
    return this->Refuse(EdgeText(this->Mesh, links.Bent.Slot) + " is not Delaunay");
  }
  return links.Unanswered == 0 || this->Refuse("neighbors are not mutual");
}

void MeshChecker::FollowLink(std::size_t triangle, std::size_t slot, LinkSum& sum) const
{
  const Id neighbor = this->Mesh.Neighbors[slot];
  if (neighbor == NoId)
  {
    sum.BoundarySlots.push_back(slot);
    return;
  }
  const bool isLarger = static_cast<std::size_t>(neighbor) > triangle;
  sum.Unanswered += isLarger ? 1 : -1;
  if (!isLarger)
  {
    const std::size_t across = SlotAcross(this->Mesh.Corners, slot, neighbor);
    const bool isLink = this->IsLink(slot, across);
    sum.Wrong.Add(slot, !isLink);
    sum.Bent.Add(slot, isLink && this->Mesh.IsDelaunay && !this->IsLocallyDelaunay(slot, across));
  }
}

bool MeshChecker::IsLink(std::size_t slot, std::size_t across) const
{
  return static_cast<std::size_t>(this->Mesh.Neighbors[across]) == slot / 3 &&
    this->Corner(NextSlotOf(across)) == this->Corner(PreviousSlotOf(slot)) &&
    this->Corner(PreviousSlotOf(across)) == this->Corner(NextSlotOf(slot)) &&
    this->Mesh.Constraints[across] == this->Mesh.Constraints[slot];
}

// Of a link, where no constraint is.
bool MeshChecker::IsLocallyDelaunay(std::size_t slot, std::size_t across) const
{
  return this->Mesh.Constraints[slot] != NoId ||
    InCircle(this->Place(slot), this->Place(NextSlotOf(slot)), this->Place(PreviousSlotOf(slot)),
      this->Place(across)) <= 0;
}

bool MeshChecker::HasConstrainedBoundary()
{
  for (std::size_t k = 0; k < this->BoundarySlots.size() && this->IsGoingOn(k); ++k)
  {
    const std::size_t slot = this->BoundarySlots[k];
    if (this->Mesh.Constraints[slot] == NoId)
    {
      return this->Refuse("no constraint covers the boundary at " + EdgeText(this->Mesh, slot));
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
    { uses.Set(this->Corner(NextSlotOf(this->BoundarySlots[k])), Boundary); });
  return uses;
}

// Each fan of triangles at the boundary has one boundary edge that leaves its vertex: with B
// boundary edges and V inner vertices there are V + B fans. E = (3 F + B) / 2, so twice the formula
// is 2 V + B - F = 4 C - 2 L.
bool MeshChecker::FulfilsEuler()
{
  const std::int64_t numberOfTriangles = static_cast<std::int64_t>(this->Mesh.Corners.size() / 3);
  const std::int64_t numberOfBoundaryEdges = static_cast<std::int64_t>(this->BoundarySlots.size());
  const std::int64_t components = this->CountParts();
  const std::int64_t loops = this->CountLoops();
  const std::int64_t found =
    2 * this->NumberOfInnerVertices + numberOfBoundaryEdges - numberOfTriangles;
  return found == 4 * components - 2 * loops ||
    this->Refuse("Euler's formula fails for " + std::to_string(components) + " components and " +
      std::to_string(loops) + " boundary loops");
}

std::int64_t MeshChecker::CountParts()
{
  const PulsePart part(this->Beats, UsesEnd, ComponentsEnd);
  return CountComponents(this->Mesh.Neighbors, this->Beats);
}

std::int64_t MeshChecker::CountLoops()
{
  const PulsePart part(this->Beats, ComponentsEnd, 1.0);
  return CountBoundaryLoops(
    this->Mesh.Corners, this->Mesh.Neighbors, this->BoundarySlots, this->Beats);
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
    const Point2& start = this->Place(NextSlotOf(slot));
    length += Distance(start, this->Place(PreviousSlotOf(slot)));
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

} // namespace

std::string CheckMesh(const MeshCheckInput& mesh, Monitor& monitor)
{
  Pulse pulse(monitor);
  return HasValidSizes(mesh) ? MeshChecker(mesh, pulse).Check()
                             : "the arrays of the triangles differ in size";
}

} // namespace biting
