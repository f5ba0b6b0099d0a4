// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshedBites.h"

#include "../Base/Monitor.h"
#include "../Base/Pulse.h"
#include "../Delaunay/ConstrainedEdges.h"
#include "StageProblems.h"

#include <algorithm> // for find
#include <cmath>     // for abs
#include <cstdint>   // for flags
#include <utility>   // for move
#include <vector>    // for the arrays

namespace biting
{

namespace
{

constexpr int MostAttempts = 5; // each later one has fewer constraints in conflict

// Of a length: rounding of the sum, and of close vertices.
constexpr double CoverageTolerance = 1e-6;

// Where steps end, as shares of the time.
constexpr double FirstAttemptEnd = 0.9;
constexpr double TriangulationEnd = 0.95;

using Flags = std::vector<std::uint8_t>;

std::vector<double> LengthsOfConstraints(const BitingResult& bites, Pulse& pulse)
{
  std::vector<double> lengths(bites.EdgeStarts.size());
  pulse.ForEach(lengths.size(),
    [&bites, &lengths](std::size_t edge)
    {
      lengths[edge] =
        Distance(bites.Points[bites.EdgeStarts[edge]], bites.Points[bites.EdgeEnds[edge]]);
    });
  return lengths;
}

// The constraints that are not a union of mesh edges: as long as these are together.
std::vector<Id> FindUncovered(
  const BitingResult& bites, const Triangulation& triangulation, Pulse& pulse)
{
  const std::vector<double> lengths = LengthsOfConstraints(bites, pulse);
  std::vector<double> rest = lengths;
  ForEachConstrainedEdge(triangulation, pulse,
    [&bites, &rest](Id constraint, Id start, Id end)
    { rest[constraint] -= Distance(bites.Points[start], bites.Points[end]); });
  std::vector<Id> uncovered;
  pulse.ForEach(rest.size(),
    [&lengths, &rest, &uncovered](std::size_t edge)
    {
      if (!(std::abs(rest[edge]) <= CoverageTolerance * lengths[edge]))
      {
        uncovered.push_back(static_cast<Id>(edge));
      }
    });
  return uncovered;
}

// 1 for the segments whose parts cross or coincide with those of others, and for those that share
// an end with one that the parts of others cut off from the mesh.
Flags SegmentsInConflict(const Domain& domain, const TriangulationResult& result,
  const std::vector<Id>& uncovered, const BitingResult& bites, Pulse& pulse)
{
  Flags isInConflict(domain.NumberOfSegments(), 0);
  for (const auto* pairs : { &result.Conflicts, &result.Coincidences })
  {
    for (const ConstraintConflict& pair : *pairs)
    {
      isInConflict[bites.EdgeSegments[pair.First]] = 1;
      isInConflict[bites.EdgeSegments[pair.Second]] = 1;
    }
  }
  Flags isAtConflict(domain.NumberOfVertices(), 0);
  for (const Id edge : uncovered)
  {
    isAtConflict[domain.Starts[bites.EdgeSegments[edge]]] = 1;
    isAtConflict[domain.Ends[bites.EdgeSegments[edge]]] = 1;
  }
  pulse.ForEach(isInConflict.size(),
    [&domain, &isInConflict, &isAtConflict](std::size_t segment)
    {
      isInConflict[segment] |=
        isAtConflict[domain.Starts[segment]] | isAtConflict[domain.Ends[segment]];
    });
  return isInConflict;
}

// Removes vertices at which no constraint ends.
void RemoveVertices(const Flags& isRemoved, BitingResult& bites, Pulse& pulse)
{
  std::vector<Id> numbers(isRemoved.size(), NoId);
  std::size_t next = 0;
  pulse.ForEach(isRemoved.size(),
    [&isRemoved, &bites, &numbers, &next](std::size_t vertex)
    {
      if (!isRemoved[vertex])
      {
        numbers[vertex] = static_cast<Id>(next);
        bites.Points[next] = bites.Points[vertex];
        bites.Spacings[next] = bites.Spacings[vertex];
        bites.BiteOrders[next] = bites.BiteOrders[vertex];
        bites.Segments[next++] = bites.Segments[vertex];
      }
    });
  bites.Points.resize(next);
  bites.Spacings.resize(next);
  bites.BiteOrders.resize(next);
  bites.Segments.resize(next);
  for (std::vector<Id>* ends : { &bites.EdgeStarts, &bites.EdgeEnds })
  {
    pulse.ForEach(
      ends->size(), [&numbers, ends](std::size_t edge) { (*ends)[edge] = numbers[(*ends)[edge]]; });
  }
}

// Takes the new vertices off segments, and these back to one edge each: the segments themselves do
// not cross.
void UndoDivisions(const Domain& domain, const Flags& isUndone, BitingResult& bites, Pulse& pulse)
{
  std::size_t next = 0;
  Id last = NoId;
  pulse.ForEach(bites.EdgeSegments.size(),
    [&domain, &isUndone, &bites, &next, &last](std::size_t edge)
    {
      const Id segment = bites.EdgeSegments[edge];
      const bool isWhole = isUndone[segment] != 0;
      if (!isWhole || segment != last)
      {
        bites.EdgeStarts[next] = isWhole ? domain.Starts[segment] : bites.EdgeStarts[edge];
        bites.EdgeEnds[next] = isWhole ? domain.Ends[segment] : bites.EdgeEnds[edge];
        bites.EdgeSegments[next++] = segment;
      }
      last = segment;
    });
  bites.EdgeStarts.resize(next);
  bites.EdgeEnds.resize(next);
  bites.EdgeSegments.resize(next);
  Flags isRemoved(bites.Segments.size(), 0);
  pulse.ForEach(isRemoved.size(),
    [&bites, &isUndone, &isRemoved](std::size_t vertex)
    {
      const Id segment = bites.Segments[vertex];
      isRemoved[vertex] = segment != NoId && isUndone[segment];
    });
  RemoveVertices(isRemoved, bites, pulse);
}

// 1 for the vertices that the triangulation found on preserved segments, though none begins or ends
// there: by rounding, beside segments as short as that.
Flags VerticesOnPreserved(const Domain& domain, bool areAllPreserved, const BitingResult& bites,
  const Triangulation& triangulation, Pulse& pulse)
{
  Flags isOn(bites.Points.size(), 0);
  ForEachConstrainedEdge(triangulation, pulse,
    [&domain, areAllPreserved, &bites, &isOn](Id constraint, Id start, Id end)
    {
      const bool isPreserved =
        areAllPreserved || domain.MustPreserve(bites.EdgeSegments[constraint]);
      for (const Id vertex : { start, end })
      {
        isOn[vertex] |=
          isPreserved && vertex >= domain.NumberOfVertices() && bites.Segments[vertex] == NoId;
      }
    });
  return isOn;
}

// Leaves one edge for each preserved segment. Whether vertices had to be removed.
bool ClearPreserved(const Domain& domain, bool areAllPreserved, const Triangulation& triangulation,
  BitingResult& bites, Pulse& pulse)
{
  const Flags isOn = VerticesOnPreserved(domain, areAllPreserved, bites, triangulation, pulse);
  const bool hasSome = std::find(isOn.begin(), isOn.end(), 1) != isOn.end();
  if (hasSome)
  {
    RemoveVertices(isOn, bites, pulse);
  }
  return hasSome;
}

// Inner vertices that rounding put on a constraint divide it: they are on its segment.
void AdoptVertices(
  const Domain& domain, const Triangulation& triangulation, BitingResult& bites, Pulse& pulse)
{
  ForEachConstrainedEdge(triangulation, pulse,
    [&domain, &bites](Id constraint, Id start, Id end)
    {
      for (const Id vertex : { start, end })
      {
        if (vertex >= domain.NumberOfVertices() && bites.Segments[vertex] == NoId)
        {
          bites.Segments[vertex] = bites.EdgeSegments[constraint];
        }
      }
    });
}

// The first attempt is nearly always the only one.
PartOfStage PartOfAttempt(int attempt, Monitor& monitor)
{
  const auto begin = [](int count)
  { return count == 1 ? 0.0 : 1.0 - (1.0 - FirstAttemptEnd) / (count - 1); };
  return { monitor, begin(attempt), begin(attempt + 1) };
}

/// One triangulation, and what is wrong with it.
class Attempt
{
public:
  Attempt(const Domain& domain, const SoundTriangulationOptions& options, BitingResult& bites,
    PartOfStage& part)
    : Geometry(domain)
    , Options(options)
    , Bites(bites)
    , Part(part)
  {
  }

  /// Whether it is sound; else `bites` are changed for the next one.
  bool Run(bool isLastChance)
  {
    this->Triangulate();
    PartOfStage looking(this->Part, TriangulationEnd, 1.0);
    Pulse pulse(looking);
    if (this->Result.Conflicts.empty())
    {
      this->Uncovered = FindUncovered(this->Bites, this->Result.Mesh, pulse);
    }
    const bool isSound = this->Result.Conflicts.empty() && this->Result.Coincidences.empty() &&
      this->Uncovered.empty();
    if (!isSound)
    {
      this->Undo(isLastChance, pulse);
      return false;
    }
    const bool hasPreserved = this->Options.PreserveBoundary || !this->Geometry.IsPreserved.empty();
    if (hasPreserved &&
      ClearPreserved(
        this->Geometry, this->Options.PreserveBoundary, this->Result.Mesh, this->Bites, pulse))
    {
      return false;
    }
    AdoptVertices(this->Geometry, this->Result.Mesh, this->Bites, pulse);
    return true;
  }

  Triangulation TakeMesh() { return std::move(this->Result.Mesh); }

private:
  void Triangulate()
  {
    PartOfStage triangulating(this->Part, 0.0, TriangulationEnd);
    ConstrainedMesh made = std::move(this->Bites.Triangulated);
    this->Bites.Triangulated = {};
    this->Result = made.IsWhole()
      ? FinishTriangulation(std::move(made), triangulating)
      : biting::Triangulate(this->Bites.Points, ConstraintsOf(this->Bites, this->Geometry),
          { this->Options.Phi }, triangulating);
  }

  void Undo(bool isLastChance, Pulse& pulse)
  {
    const Flags isUndone = isLastChance
      ? Flags(this->Geometry.NumberOfSegments(), 1)
      : SegmentsInConflict(this->Geometry, this->Result, this->Uncovered, this->Bites, pulse);
    UndoDivisions(this->Geometry, isUndone, this->Bites, pulse);
  }

  const Domain& Geometry;
  const SoundTriangulationOptions& Options;
  BitingResult& Bites;
  PartOfStage& Part;
  TriangulationResult Result;
  std::vector<Id> Uncovered;
};

} // namespace

Triangulation TriangulateBites(const Domain& domain, const SoundTriangulationOptions& options,
  BitingResult& bites, ProblemList& problems, Monitor& monitor)
{
  for (int number = 1; number <= MostAttempts; ++number)
  {
    PartOfStage part = PartOfAttempt(number, monitor);
    Attempt attempt(domain, options, bites, part);
    const bool isSound = attempt.Run(number == MostAttempts - 1);
    if (AddAborted(part, problems))
    {
      return {};
    }
    if (isSound)
    {
      return attempt.TakeMesh();
    }
  }
  AddProblem(ProblemCode::CheckFailed, "a part of a segment is not in the mesh", problems);
  return {};
}

void Exchange(BitingResult& bites, Triangulation& triangles, RelaxationMesh& mesh)
{
  bites.Points.swap(mesh.Points);
  bites.Spacings.swap(mesh.Spacings);
  bites.Segments.swap(mesh.Segments);
  bites.EdgeStarts.swap(mesh.EdgeStarts);
  bites.EdgeEnds.swap(mesh.EdgeEnds);
  bites.EdgeSegments.swap(mesh.EdgeSegments);
  std::swap(triangles, mesh.Triangles);
}

void RelaxBites(const Domain& domain, const Spacing& spacing, const RelaxationOptions& options,
  BitingResult& bites, Triangulation& mesh, Monitor& monitor)
{
  RelaxationMesh work;
  Exchange(bites, mesh, work);
  const RelaxationResult result = Relax(domain, spacing, options, work, monitor);
  Exchange(bites, mesh, work);
  if (result.WasAborted)
  {
    return;
  }
  Pulse pulse(monitor);
  pulse.SetFraction(1.0);
  std::vector<Id> orders;
  orders.reserve(result.Origins.size());
  pulse.ForEach(result.Origins.size(),
    [&result, &bites, &orders](std::size_t vertex)
    {
      const Id origin = result.Origins[vertex];
      orders.push_back(origin == NoId ? NoId : bites.BiteOrders[origin]);
    });
  bites.BiteOrders = std::move(orders);
}

} // namespace biting
