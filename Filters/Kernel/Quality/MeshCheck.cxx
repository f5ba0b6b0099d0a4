// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshCheck.h"

#include "../Base/DisjointSets.h"
#include "../Base/Marks.h"
#include "../Base/Pulse.h"
#include "../Base/Tasks.h"
#include "../Base/TriangleSlots.h"
#include "../Predicates/Predicates.h"
#include "CheckSums.h"

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
constexpr double LinksEnd = 0.75;
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
  const Point2& start = mesh.Points[startId];
  const Point2& end = mesh.Points[endId];
  std::ostringstream text;
  text << "edge " << startId << " - " << endId << " of triangle " << slot / 3 << ", (" << start.X
       << ", " << start.Y << ") - (" << end.X << ", " << end.Y << ")";
  return text.str();
}

/// What triangles, their edges and their vertices add up to.
struct CheckSum
{
  FirstDefect Invalid; ///< triangles with ids out of range: the sums leave them out
  TurnSum Turns;
  FirstDefect Wrong; ///< links that lead to no common edge
  FirstDefect Bent;  ///< edges that are not locally Delaunay
  std::int64_t Unanswered = 0;
  std::vector<std::size_t> BoundarySlots;
  FirstDefect Unused; ///< vertices
  std::int64_t InnerVertices = 0;

  void Join(const CheckSum& other)
  {
    this->Invalid.Join(other.Invalid);
    this->Turns.Join(other.Turns);
    this->Wrong.Join(other.Wrong);
    this->Bent.Join(other.Bent);
    this->Unanswered += other.Unanswered;
    this->BoundarySlots.insert(
      this->BoundarySlots.end(), other.BoundarySlots.begin(), other.BoundarySlots.end());
    this->Unused.Join(other.Unused);
    this->InnerVertices += other.InnerVertices;
  }
};

class MeshChecker
{
public:
  MeshChecker(const MeshCheckInput& mesh, Pulse& pulse)
    : Mesh(mesh)
    , Beats(pulse)
    , Uses(mesh.Points.size())
  {
  }

  std::string Check()
  {
    // All that is asked of triangles at once, as their places are at hand then.
    {
      const PulsePart part(this->Beats, 0.0, LinksEnd);
      this->Triangles = SumAtOnce(this->Beats, this->Mesh.Corners.size() / 3, CheckSum(),
        [this](CheckSum& sum, std::size_t triangle) { this->LookAtTriangle(triangle, sum); });
    }
    const bool isSound = this->AreTrianglesSound() && this->HasConstrainedBoundary() &&
      this->HasNoUnusedVertex() && this->FulfilsEuler() && this->CoversArea();
    return isSound ? std::string() : this->Violation;
  }

private:
  void LookAtTriangle(std::size_t triangle, CheckSum& sum)
  {
    if (!this->HasValidIds(triangle))
    {
      sum.Invalid.Add(3 * triangle, true);
      return;
    }
    this->AddTurn(triangle, sum.Turns);
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      this->Uses.Set(this->Corner(3 * triangle + corner), Inner);
      this->FollowLink(triangle, corner, sum);
    }
  }

  bool HasValidIds(std::size_t triangle) const
  {
    const Id* corners = &this->Mesh.Corners[3 * triangle];
    const Id* neighbors = &this->Mesh.Neighbors[3 * triangle];
    const std::size_t numberOfPoints = this->Mesh.Points.size();
    const std::size_t numberOfTriangles = this->Mesh.Corners.size() / 3;
    // A negative id becomes a large number, but NoId and one more 0.
    const auto isValid = [=](int k)
    {
      return static_cast<std::size_t>(corners[k]) < numberOfPoints &&
        static_cast<std::size_t>(neighbors[k]) + 1 <= numberOfTriangles;
    };
    return isValid(0) && isValid(1) && isValid(2);
  }

  void AddTurn(std::size_t triangle, TurnSum& sum) const
  {
    const Point2& a = this->Place(3 * triangle);
    const Point2& b = this->Place(3 * triangle + 1);
    const Point2& c = this->Place(3 * triangle + 2);
    sum.Wrong.Add(3 * triangle, Orient2D(b, c, a) <= 0); // from a, as the area
    sum.AddArea(a, b, c);
  }

  // A link to a smaller triangle is followed there, to a slot that must name this triangle. As no
  // slot can answer two triangles, all links to larger triangles are answered too if there are as
  // many.
  void FollowLink(std::size_t triangle, std::size_t corner, CheckSum& sum) const
  {
    const std::size_t slot = 3 * triangle + corner;
    const Id neighbor = this->Mesh.Neighbors[slot];
    if (neighbor == NoId)
    {
      sum.BoundarySlots.push_back(slot);
      return;
    }
    const bool isLarger = static_cast<std::size_t>(neighbor) > triangle;
    sum.Unanswered += isLarger ? 1 : -1;
    if (isLarger)
    {
      return;
    }
    constexpr std::size_t Next[] = { 1, 2, 0 };
    const Id start = this->Mesh.Corners[3 * triangle + Next[corner]];
    const Id end = this->Mesh.Corners[3 * triangle + Next[Next[corner]]];
    const std::size_t first = 3 * static_cast<std::size_t>(neighbor);
    const std::size_t found = CornerOf(&this->Mesh.Corners[first], end);
    const std::size_t atEnd = found < 3 ? found : 0;
    const std::size_t across = first + Next[Next[atEnd]];
    const bool isLink = static_cast<std::size_t>(this->Mesh.Neighbors[across]) == triangle &&
      this->Mesh.Corners[first + atEnd] == end &&
      this->Mesh.Corners[first + Next[atEnd]] == start &&
      this->Mesh.Constraints[across] == this->Mesh.Constraints[slot];
    sum.Wrong.Add(slot, !isLink);
    sum.Bent.Add(slot,
      isLink && this->Mesh.IsDelaunay && this->Corner(across) < this->Mesh.Points.size() &&
        !this->IsLocallyDelaunay(triangle, slot, across));
  }

  // Of a link, where no constraint is.
  bool IsLocallyDelaunay(std::size_t triangle, std::size_t slot, std::size_t across) const
  {
    return this->Mesh.Constraints[slot] != NoId ||
      InCircle(this->Place(3 * triangle), this->Place(3 * triangle + 1),
        this->Place(3 * triangle + 2), this->Place(across)) <= 0;
  }

  bool AreTrianglesSound()
  {
    const FirstDefect& invalid = this->Triangles.Invalid;
    const FirstDefect& turned = this->Triangles.Turns.Wrong;
    const FirstDefect& wrong = this->Triangles.Wrong;
    const FirstDefect& bent = this->Triangles.Bent;
    if (invalid.Exists())
    {
      return this->Refuse(
        "an id of triangle " + std::to_string(invalid.Slot / 3) + " is out of range");
    }
    if (turned.Exists())
    {
      return this->Refuse(
        "triangle " + std::to_string(turned.Slot / 3) + " is not counterclockwise");
    }
    if (wrong.Exists())
    {
      return this->Refuse("the triangles at " + EdgeText(this->Mesh, wrong.Slot) + " do not match");
    }
    if (bent.Exists())
    {
      return this->Refuse(EdgeText(this->Mesh, bent.Slot) + " is not Delaunay");
    }
    return this->Triangles.Unanswered == 0 || this->Refuse("neighbors are not mutual");
  }

  bool HasConstrainedBoundary()
  {
    for (const std::size_t slot : this->Triangles.BoundarySlots)
    {
      if (this->Beats.Beat() && this->Mesh.Constraints[slot] == NoId)
      {
        return this->Refuse("no constraint covers the boundary at " + EdgeText(this->Mesh, slot));
      }
    }
    return true;
  }

  bool HasNoUnusedVertex()
  {
    const PulsePart part(this->Beats, LinksEnd, UsesEnd);
    for (const std::size_t slot : this->Triangles.BoundarySlots)
    {
      this->Uses.Set(this->Corner(NextSlotOf(slot)), Boundary);
    }
    const CheckSum sum = SumAtOnce(this->Beats, this->Uses.Size(), CheckSum(),
      [this](CheckSum& own, std::size_t vertex)
      {
        own.InnerVertices += this->Uses[vertex] == Inner ? 1 : 0;
        own.Unused.Add(vertex, this->Uses[vertex] == None);
      });
    this->Triangles.InnerVertices = sum.InnerVertices;
    return !sum.Unused.Exists() ||
      this->Refuse("vertex " + std::to_string(sum.Unused.Slot) + " belongs to no triangle");
  }

  // Each fan of triangles at the boundary has one boundary edge that leaves its vertex: with B
  // boundary edges and V inner vertices there are V + B fans. E = (3 F + B) / 2, so twice the
  // formula is 2 V + B - F = 4 C - 2 L.
  bool FulfilsEuler()
  {
    const std::int64_t numberOfTriangles = static_cast<std::int64_t>(this->Mesh.Corners.size() / 3);
    const std::int64_t numberOfBoundaryEdges =
      static_cast<std::int64_t>(this->Triangles.BoundarySlots.size());
    const std::int64_t components = this->CountComponents();
    const std::int64_t loops = this->CountLoops();
    const std::int64_t found =
      2 * this->Triangles.InnerVertices + numberOfBoundaryEdges - numberOfTriangles;
    return found == 4 * components - 2 * loops ||
      this->Refuse("Euler's formula fails for " + std::to_string(components) + " components and " +
        std::to_string(loops) + " boundary loops");
  }

  // Triangles of one component are connected over edges.
  std::int64_t CountComponents()
  {
    const PulsePart part(this->Beats, UsesEnd, ComponentsEnd);
    DisjointSets components(this->Mesh.Corners.size() / 3);
    this->Beats.ForEach(this->Mesh.Neighbors.size(),
      [this, &components](std::size_t slot)
      {
        const Id triangle = static_cast<Id>(slot / 3);
        if (this->Mesh.Neighbors[slot] != NoId && this->Mesh.Neighbors[slot] < triangle)
        {
          components.Unite(triangle, this->Mesh.Neighbors[slot]);
        }
      });
    return static_cast<std::int64_t>(components.NumberOfSets());
  }

  // A boundary edge is followed by the other one of the fan of triangles about its end. Neighbors
  // are mutual, so the turn through the fan meets no triangle twice.
  std::int64_t CountLoops()
  {
    const PulsePart part(this->Beats, ComponentsEnd, 1.0);
    const std::vector<Id>& neighbors = this->Mesh.Neighbors;
    std::vector<bool> isTraced(neighbors.size(), false);
    std::int64_t count = 0;
    for (std::size_t slot : this->Triangles.BoundarySlots)
    {
      count += isTraced[slot] ? 0 : 1;
      while (!isTraced[slot] && this->Beats.Beat())
      {
        isTraced[slot] = true;
        slot = NextSlotOf(slot);
        while (neighbors[slot] != NoId)
        {
          slot = NextSlotOf(SlotAcross(this->Mesh.Corners, slot, neighbors[slot]));
        }
      }
    }
    return count;
  }

  bool CoversArea()
  {
    const double area = 0.5 * this->Triangles.Turns.DoubledArea.Value();
    const double expected = this->Mesh.ExpectedArea;
    const double rounding = std::numeric_limits<double>::epsilon() *
      (this->Triangles.Turns.AreaMagnitude + this->BoundaryRounding());
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
  double BoundaryRounding() const
  {
    double length = 0.0;
    double largest = 0.0;
    for (const std::size_t slot : this->Triangles.BoundarySlots)
    {
      const Point2& start = this->Place(NextSlotOf(slot));
      length += Distance(start, this->Place(PreviousSlotOf(slot)));
      largest = std::max({ largest, std::abs(start.X), std::abs(start.Y) });
    }
    return 4.0 * length * largest;
  }

  bool Refuse(const std::string& violation)
  {
    this->Violation = violation;
    return false;
  }

  std::size_t Corner(std::size_t slot) const
  {
    return static_cast<std::size_t>(this->Mesh.Corners[slot]);
  }
  const Point2& Place(std::size_t slot) const { return this->Mesh.Points[this->Corner(slot)]; }

  const MeshCheckInput& Mesh;
  Pulse& Beats;
  std::string Violation;
  Marks Uses; ///< of each vertex
  CheckSum Triangles;
};

} // namespace

std::string CheckMesh(const MeshCheckInput& mesh, Monitor& monitor)
{
  Pulse pulse(monitor);
  return HasValidSizes(mesh) ? MeshChecker(mesh, pulse).Check()
                             : "the arrays of the triangles differ in size";
}

} // namespace biting
