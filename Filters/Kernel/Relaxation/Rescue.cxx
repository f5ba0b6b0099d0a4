// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Rescue.h"

#include "../Base/SortInSteps.h"
#include "Hill.h"
#include "SegmentParts.h"
#include "Smoothing.h"
#include "Star.h"

#include <algorithm> // for sort, max, min

namespace biting
{

namespace
{

constexpr int JudgedRings = 4;
// Up to a hundred are usual, an attempt takes about the square of their number. Around fans of long
// segments there are thousands, which nothing helps.
constexpr std::size_t MostJudged = 150;
constexpr int MovedRings = 3;
constexpr int MovingRounds = 2;
constexpr double LeastSplitLength = 0.8; // shorter edges are no better for a vertex between them

} // namespace

void Rescue::Run(std::size_t limit, Pulse& pulse)
{
  this->AreHopeless.assign(this->Mesh.Regions.size(), 0);
  this->NumberOfAttempts = 0;
  while (this->TryAll(limit, pulse))
  {
  }
}

// Each poor triangle once; whether there is reason to go on.
bool Rescue::TryAll(std::size_t limit, Pulse& pulse)
{
  this->FindPoor(pulse);
  bool isImproved = false;
  for (std::size_t k = 0; k < this->Poor.size() && this->NumberOfAttempts < limit; ++k)
  {
    if (!pulse.Ask())
    {
      return false;
    }
    if (this->IsToBeTried(this->Poor[k].Triangle))
    {
      ++this->NumberOfAttempts;
      isImproved = this->Improve(this->Poor[k].Triangle, pulse) || isImproved;
      pulse.SetFraction(static_cast<double>(this->NumberOfAttempts) / static_cast<double>(limit));
    }
  }
  return isImproved && this->NumberOfAttempts < limit;
}

void Rescue::FindPoor(Pulse& pulse)
{
  this->Poor.clear();
  const Id numberOfTriangles = static_cast<Id>(this->Mesh.Regions.size());
  for (Id triangle = 0; triangle < numberOfTriangles && pulse.Beat(); ++triangle)
  {
    const Id* corners = this->Mesh.Corners.data() + 4 * static_cast<std::size_t>(triangle);
    if (this->IsToBeTried(triangle))
    {
      const auto& points = this->Mesh.Points;
      this->Poor.push_back(
        { WorstCotangent(points[corners[0]], points[corners[1]], points[corners[2]]), triangle });
    }
  }
  SortInSteps(
    this->Poor,
    [](const PoorTriangle& a, const PoorTriangle& b)
    { return a.Cotangent != b.Cotangent ? a.Cotangent > b.Cotangent : a.Triangle < b.Triangle; },
    pulse);
}

bool Rescue::IsToBeTried(Id triangle) const
{
  return this->Mesh.IsEdge(4 * triangle) && this->AreHopeless[triangle] == 0 &&
    IsWorseThan(this->Mesh, triangle, CotangentOf38Degrees);
}

bool Rescue::Improve(Id triangle, Pulse& pulse)
{
  const Id* first = this->Mesh.Corners.data() + 4 * static_cast<std::size_t>(triangle);
  const std::vector<Id> corners(first, first + 3);
  this->AreHopeless[triangle] = 1;
  this->Judged = this->Surroundings.Around(corners, JudgedRings);
  if (this->Judged.size() > MostJudged)
  {
    return false;
  }
  this->FindEdges(corners);
  Trial best;
  best.Worst = this->WorstOfPatch(NoId);
  for (const Id edge : this->Edges)
  {
    for (const bool isCollapse : { true, false })
    {
      Trial trial{ edge, isCollapse, 0.0 };
      this->Mesh.BeginTrial();
      const Id vertex = this->Perform(trial);
      trial.Worst = vertex == NoId ? best.Worst : this->WorstOfPatch(vertex);
      this->Mesh.EndTrial(false);
      best = trial.Worst < best.Worst ? trial : best;
    }
    if (!pulse.Beat())
    {
      return false;
    }
  }
  if (best.Edge == NoId || this->Perform(best) == NoId)
  {
    return false;
  }
  this->RenewHope();
  return true;
}

// Of the triangles near the change.
void Rescue::RenewHope()
{
  this->AreHopeless.resize(this->Mesh.Regions.size(), 0);
  for (const Id vertex : this->Judged)
  {
    if (this->Mesh.IsAlive(vertex))
    {
      const Id first = this->Mesh.FirstAround(vertex);
      Id edge = first;
      do
      {
        this->AreHopeless[MutableMesh::TriangleOf(edge)] = 0;
        edge = this->Mesh.Turn(edge);
      } while (edge != NoId && edge != first);
    }
  }
}

// Those of the triangles around the corners, each once.
void Rescue::FindEdges(const std::vector<Id>& corners)
{
  this->Edges.clear();
  for (const Id vertex : corners)
  {
    if (this->Mesh.Degrees[vertex] > Star::Capacity)
    {
      continue;
    }
    const Id first = this->Mesh.FirstAround(vertex);
    Id edge = first;
    do
    {
      for (const Id side : { edge, MutableMesh::Next(edge), MutableMesh::Previous(edge) })
      {
        this->Edges.push_back(this->Mesh.IsFirstHalf(side) ? side : this->Mesh.Twins[side]);
      }
      edge = this->Mesh.Turn(edge);
    } while (edge != NoId && edge != first);
  }
  std::sort(this->Edges.begin(), this->Edges.end());
  this->Edges.erase(std::unique(this->Edges.begin(), this->Edges.end()), this->Edges.end());
}

bool Rescue::IsAllowed(const Trial& trial) const
{
  return trial.IsCollapse ? !LeavesLongPart(this->Mesh, trial.Edge)
                          : this->Mesh.RelativeLength(trial.Edge) >= LeastSplitLength &&
      !LeavesShortParts(this->Mesh, trial.Edge);
}

Id Rescue::Perform(const Trial& trial)
{
  if (!this->IsAllowed(trial))
  {
    return NoId;
  }
  const Id vertex =
    trial.IsCollapse ? this->Mesh.Collapse(trial.Edge) : this->Mesh.Split(trial.Edge);
  if (vertex == NoId || this->Mesh.Degrees[vertex] > Star::Capacity)
  {
    return NoId;
  }
  this->Flips.RestoreAround(vertex);
  this->Moved = this->Surroundings.Around(vertex, MovedRings);
  for (const Id near : this->Moved)
  {
    if (SmoothVertex(this->Mesh, near, CotangentOf30Degrees))
    {
      this->Mesh.RefreshSpacing(near);
      this->Flips.RestoreAround(near);
    }
  }
  for (int round = 0; round < MovingRounds; ++round)
  {
    for (const Id near : this->Moved)
    {
      this->Climber.Climb(near, CotangentOf40Degrees);
    }
  }
  return vertex;
}

double Rescue::WorstOfPatch(Id added) const
{
  double worst = added == NoId ? 0.0 : this->WorstAround(added);
  for (const Id vertex : this->Judged)
  {
    worst = std::max(worst, this->Mesh.IsAlive(vertex) ? this->WorstAround(vertex) : 0.0);
  }
  return worst;
}

double Rescue::WorstAround(Id vertex) const
{
  Star star;
  if (!star.Read(this->Mesh, vertex))
  {
    return 0.0;
  }
  return Hill(this->Mesh, vertex, star).HeightHere();
}

} // namespace biting
