// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshCheck.h"

#include "../Predicates/Predicates.h"

#include <algorithm> // for max
#include <cmath>     // for abs
#include <cstdint>   // for marks
#include <limits>    // for epsilon
#include <sstream>   // for messages

namespace biting
{

namespace
{

// Marks of a triangle: bits 0 to 2, that a loop was traced along the edge opposite that corner.
constexpr std::uint8_t Visited = 8;

constexpr std::size_t Next(std::size_t slot)
{
  return slot % 3 == 2 ? slot - 2 : slot + 1;
}

constexpr std::size_t Previous(std::size_t slot)
{
  return slot % 3 == 0 ? slot + 2 : slot - 1;
}

// A sum that does not lose what its terms are too small to move (A. Neumaier, 1974).
class CompensatedSum
{
public:
  void Add(double term)
  {
    const double next = this->Total + term;
    this->Lost += std::abs(this->Total) >= std::abs(term) ? (this->Total - next) + term
                                                          : (term - next) + this->Total;
    this->Total = next;
  }
  double Value() const { return this->Total + this->Lost; }

private:
  double Total = 0.0;
  double Lost = 0.0;
};

class MeshChecker
{
public:
  explicit MeshChecker(const MeshCheckInput& mesh)
    : Mesh(mesh)
  {
  }
  std::string Check();

private:
  bool HasValidSizes();
  bool HasValidIds();
  bool IsCounterclockwise();
  bool HasMutualNeighbors();
  bool IsLink(std::size_t slot) const;
  std::size_t SlotAcross(std::size_t slot) const;
  bool HasConstrainedBoundary();
  bool HasNoUnusedVertex();
  bool FulfilsEuler();
  std::int64_t CountComponents();
  void VisitComponent(Id triangle, std::vector<Id>& front);
  std::int64_t CountLoops();
  std::size_t NextOnBoundary(std::size_t slot) const;
  bool CoversArea();
  double BoundaryRounding() const;
  bool Refuse(const std::string& violation);
  std::string EdgeText(std::size_t slot) const;

  std::size_t Corner(std::size_t slot) const
  {
    return static_cast<std::size_t>(this->Mesh.Corners[slot]);
  }
  const Point2& Place(std::size_t slot) const { return this->Mesh.Points[this->Corner(slot)]; }

  const MeshCheckInput& Mesh;
  std::string Violation;
  std::vector<std::size_t> BoundarySlots;
  std::int64_t NumberOfInnerVertices = 0;
  std::vector<std::uint8_t> Marks; ///< one a triangle
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
  const std::size_t numberOfTriangles = this->Mesh.Corners.size() / 3;
  for (std::size_t slot = 0; slot < this->Mesh.Corners.size(); ++slot)
  {
    const Id neighbor = this->Mesh.Neighbors[slot];
    // A negative id becomes a large number.
    const bool isNeighborValid =
      neighbor == NoId || static_cast<std::size_t>(neighbor) < numberOfTriangles;
    if (this->Corner(slot) >= this->Mesh.Points.size() || !isNeighborValid)
    {
      return this->Refuse("an id of triangle " + std::to_string(slot / 3) + " is out of range");
    }
  }
  return true;
}

bool MeshChecker::IsCounterclockwise()
{
  for (std::size_t slot = 0; slot < this->Mesh.Corners.size(); slot += 3)
  {
    if (Orient2D(this->Place(slot), this->Place(slot + 1), this->Place(slot + 2)) <= 0)
    {
      return this->Refuse("triangle " + std::to_string(slot / 3) + " is not counterclockwise");
    }
  }
  return true;
}

// A link to a smaller triangle is followed there, to a slot that must name this triangle. As no slot
// can answer two triangles, all links to larger triangles are answered too if there are as many.
bool MeshChecker::HasMutualNeighbors()
{
  std::int64_t unanswered = 0;
  for (std::size_t slot = 0; slot < this->Mesh.Neighbors.size(); ++slot)
  {
    const Id neighbor = this->Mesh.Neighbors[slot];
    if (neighbor == NoId)
    {
      this->BoundarySlots.push_back(slot);
      continue;
    }
    const bool isLarger = static_cast<std::size_t>(neighbor) > slot / 3;
    unanswered += isLarger ? 1 : -1;
    if (!isLarger && !this->IsLink(slot))
    {
      return this->Refuse("the triangles at " + this->EdgeText(slot) + " do not match");
    }
  }
  return unanswered == 0 || this->Refuse("neighbors are not mutual");
}

bool MeshChecker::IsLink(std::size_t slot) const
{
  const std::size_t across = this->SlotAcross(slot);
  return static_cast<std::size_t>(this->Mesh.Neighbors[across]) == slot / 3 &&
    this->Corner(Next(across)) == this->Corner(Previous(slot)) &&
    this->Corner(Previous(across)) == this->Corner(Next(slot)) &&
    this->Mesh.Constraints[across] == this->Mesh.Constraints[slot];
}

// The slot of the neighbor whose edge starts where that of `slot` ends; any where there is none.
std::size_t MeshChecker::SlotAcross(std::size_t slot) const
{
  const std::size_t first = 3 * static_cast<std::size_t>(this->Mesh.Neighbors[slot]);
  const std::size_t end = this->Corner(Previous(slot));
  if (this->Corner(first) == end)
  {
    return first + 2;
  }
  return this->Corner(first + 1) == end ? first : first + 1;
}

bool MeshChecker::HasConstrainedBoundary()
{
  for (const std::size_t slot : this->BoundarySlots)
  {
    if (this->Mesh.Constraints[slot] == NoId)
    {
      return this->Refuse("no constraint covers the boundary at " + this->EdgeText(slot));
    }
  }
  return true;
}

bool MeshChecker::HasNoUnusedVertex()
{
  enum Use : std::uint8_t
  {
    None,
    Inner,
    Boundary
  };
  std::vector<std::uint8_t> uses(this->Mesh.Points.size(), None);
  for (std::size_t slot = 0; slot < this->Mesh.Corners.size(); ++slot)
  {
    uses[this->Corner(slot)] = Inner;
  }
  for (const std::size_t slot : this->BoundarySlots)
  {
    uses[this->Corner(Next(slot))] = Boundary;
  }
  for (std::size_t vertex = 0; vertex < uses.size(); ++vertex)
  {
    this->NumberOfInnerVertices += uses[vertex] == Inner ? 1 : 0;
    if (uses[vertex] == None)
    {
      return this->Refuse("vertex " + std::to_string(vertex) + " belongs to no triangle");
    }
  }
  return true;
}

// Each fan of triangles at the boundary has one boundary edge that leaves its vertex: with B boundary
// edges and V inner vertices there are V + B fans. E = (3 F + B) / 2, so twice the formula is
// 2 V + B - F = 4 C - 2 L.
bool MeshChecker::FulfilsEuler()
{
  const std::int64_t numberOfTriangles = static_cast<std::int64_t>(this->Mesh.Corners.size() / 3);
  const std::int64_t numberOfBoundaryEdges = static_cast<std::int64_t>(this->BoundarySlots.size());
  this->Marks.assign(this->Mesh.Corners.size() / 3, 0);
  const std::int64_t components = this->CountComponents();
  const std::int64_t loops = this->CountLoops();
  const std::int64_t found =
    2 * this->NumberOfInnerVertices + numberOfBoundaryEdges - numberOfTriangles;
  return found == 4 * components - 2 * loops ||
    this->Refuse("Euler's formula fails for " + std::to_string(components) + " components and " +
      std::to_string(loops) + " boundary loops");
}

std::int64_t MeshChecker::CountComponents()
{
  std::int64_t count = 0;
  std::vector<Id> front;
  for (std::size_t triangle = 0; triangle < this->Marks.size(); ++triangle)
  {
    if ((this->Marks[triangle] & Visited) == 0)
    {
      this->VisitComponent(static_cast<Id>(triangle), front);
      count += 1;
    }
  }
  return count;
}

void MeshChecker::VisitComponent(Id triangle, std::vector<Id>& front)
{
  this->Marks[static_cast<std::size_t>(triangle)] |= Visited;
  front.push_back(triangle);
  while (!front.empty())
  {
    const std::size_t first = 3 * static_cast<std::size_t>(front.back());
    front.pop_back();
    for (std::size_t slot = first; slot < first + 3; ++slot)
    {
      const Id neighbor = this->Mesh.Neighbors[slot];
      if (neighbor != NoId && (this->Marks[static_cast<std::size_t>(neighbor)] & Visited) == 0)
      {
        this->Marks[static_cast<std::size_t>(neighbor)] |= Visited;
        front.push_back(neighbor);
      }
    }
  }
}

std::int64_t MeshChecker::CountLoops()
{
  std::int64_t count = 0;
  for (const std::size_t start : this->BoundarySlots)
  {
    std::size_t slot = start;
    while ((this->Marks[slot / 3] & (1 << slot % 3)) == 0)
    {
      this->Marks[slot / 3] |= static_cast<std::uint8_t>(1 << slot % 3);
      slot = this->NextOnBoundary(slot);
      count += slot == start ? 1 : 0;
    }
  }
  return count;
}

// Turns about the end of the boundary edge, through its fan of triangles, to the other boundary edge
// of the fan. Neighbors are mutual, so the turn cannot come to a triangle again.
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
  CompensatedSum doubledArea;
  double magnitude = 0.0;
  for (std::size_t slot = 0; slot < this->Mesh.Corners.size(); slot += 3)
  {
    const Point2 u = this->Place(slot + 1) - this->Place(slot);
    const Point2 v = this->Place(slot + 2) - this->Place(slot);
    doubledArea.Add(u.X * v.Y - u.Y * v.X);
    magnitude += std::abs(u.X * v.Y) + std::abs(u.Y * v.X);
  }
  const double area = 0.5 * doubledArea.Value();
  const double expected = this->Mesh.ExpectedArea;
  const double rounding =
    std::numeric_limits<double>::epsilon() * (magnitude + this->BoundaryRounding());
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

std::string CheckMesh(const MeshCheckInput& mesh)
{
  return MeshChecker(mesh).Check();
}

} // namespace biting
