// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ValenceRound.h"

#include "../Base/Numbers.h"
#include "../Base/SortInSteps.h"
#include "EdgeOperations.h"
#include "SegmentParts.h"
#include "Smoothing.h"
#include "Star.h"

#include <algorithm> // for max, clamp
#include <cstddef>   // for slots

namespace biting
{

namespace
{

constexpr double LengthWeight = 12.0;
constexpr double LongPartWeight = 60.0; // of a part of a segment that is too long
constexpr double CollapseLength = 0.67;
constexpr double SplitLength = 1.28;
constexpr double ShiftPerError = 5.0; // of these lengths, by what the mean length lacks
constexpr double GreatestShift = 0.1;
constexpr double BoundMargin = 1e-9; // of relative lengths: far above rounding
constexpr Id SampledEdges = 60000;   // half-edges, for the mean length

} // namespace

void ValenceRound::Run(int rings, Pulse& pulse)
{
  this->ChooseShift(pulse);
  this->FindCandidates(pulse);
  this->Locks.assign(this->Mesh.Points.size(), 0);
  for (const Candidate& candidate : this->Candidates)
  {
    if (!pulse.Beat())
    {
      return;
    }
    const Id vertex = this->Perform(candidate);
    if (vertex != NoId)
    {
      this->Lock(vertex);
      this->SmoothAround(vertex, rings);
    }
  }
}

// A sample of the edges tells the mean; its odd stride meets all three of a triangle.
void ValenceRound::ChooseShift(Pulse& pulse)
{
  const Id stride = 2 * (this->Mesh.NumberOfEdges() / SampledEdges) + 1;
  double sum = 0.0;
  double count = 0.0;
  const Id samples = (this->Mesh.NumberOfEdges() + stride - 1) / stride;
  pulse.ForEach(static_cast<std::size_t>(samples),
    [this, stride, &sum, &count](std::size_t k)
    {
      const Id edge = stride * static_cast<Id>(k);
      if (this->Mesh.IsFirstHalf(edge))
      {
        sum += this->Mesh.RelativeLength(edge);
        count += 1.0;
      }
    });
  const double lack = count > 0.0 ? 1.0 - sum / count : 0.0;
  this->Shift = std::clamp(ShiftPerError * lack, -GreatestShift, GreatestShift);
}

void ValenceRound::FindCandidates(Pulse& pulse)
{
  this->Candidates.clear();
  pulse.ForEach(this->Mesh.Regions.size(),
    [this](std::size_t triangle)
    {
      for (Id edge = 4 * static_cast<Id>(triangle); (edge & 3) < 3; ++edge)
      {
        if (this->Mesh.IsFirstHalf(edge))
        {
          this->AddCandidates(edge);
        }
      }
    });
  SortInSteps(
    this->Candidates,
    [](const Candidate& a, const Candidate& b)
    {
      return a.Score != b.Score ? a.Score < b.Score
        : a.Edge != b.Edge      ? a.Edge < b.Edge
                                : a.IsCollapse && !b.IsCollapse;
    },
    pulse);
}

// Most edges are neither short nor long enough for a negative score: a comparison of squares tells.
void ValenceRound::AddCandidates(Id edge)
{
  const MutableMesh& mesh = this->Mesh;
  const double square = mesh.SquaredRelativeLength(edge);
  const double shortest =
    CollapseLength + this->Shift + BoundMargin - ValenceChangeOfCollapse(mesh, edge) / LengthWeight;
  const double longest =
    SplitLength + this->Shift - BoundMargin + ValenceChangeOfSplit(mesh, edge) / LengthWeight;
  const bool isShort = shortest > 0.0 && square < shortest * shortest;
  const bool isLong = mesh.Marks[edge] != NoId || longest < 0.0 || square > longest * longest;
  if (isShort || isLong)
  {
    const double length = mesh.RelativeLength(edge);
    for (const bool isCollapse : { true, false })
    {
      const double score = this->Score(edge, isCollapse, length);
      if (score < 0.0)
      {
        this->Candidates.push_back({ score, edge, isCollapse });
      }
    }
  }
}

double ValenceRound::Score(Id edge, bool isCollapse, double length) const
{
  return isCollapse ? this->CollapseScore(edge, length) : this->SplitScore(edge, length);
}

double ValenceRound::CollapseScore(Id edge, double length) const
{
  const MutableMesh& mesh = this->Mesh;
  const double change = ValenceChangeOfCollapse(mesh, edge);
  return change == Infinity || LeavesLongPart(mesh, edge)
    ? Infinity
    : LengthWeight * (length - CollapseLength - this->Shift) + change;
}

double ValenceRound::SplitScore(Id edge, double length) const
{
  const MutableMesh& mesh = this->Mesh;
  const double weight = IsTooLongPart(mesh, edge) ? LongPartWeight : LengthWeight;
  const double score =
    weight * (SplitLength + this->Shift - length) + ValenceChangeOfSplit(mesh, edge);
  return score < 0.0 && LeavesShortParts(mesh, edge) ? Infinity : score;
}

bool ValenceRound::IsLocked(Id edge) const
{
  const MutableMesh& mesh = this->Mesh;
  const Id twin = mesh.Twins[edge];
  const auto isLocked = [this](Id vertex)
  { return vertex >= static_cast<Id>(this->Locks.size()) || this->Locks[vertex] != 0; };
  return isLocked(mesh.Origin(edge)) || isLocked(mesh.Target(edge)) ||
    isLocked(mesh.Corners[edge]) || (twin != NoId && isLocked(mesh.Corners[twin]));
}

Id ValenceRound::Perform(const Candidate& candidate)
{
  MutableMesh& mesh = this->Mesh;
  const Id edge = candidate.Edge;
  if (!mesh.IsEdge(edge) || this->IsLocked(edge) ||
    !(this->Score(edge, candidate.IsCollapse, mesh.RelativeLength(edge)) < 0.0))
  {
    return NoId;
  }
  const double before =
    std::max(WorstAround(mesh, mesh.Origin(edge)), WorstAround(mesh, mesh.Target(edge)));
  if (before == Infinity)
  {
    return NoId;
  }
  mesh.BeginTrial();
  const Id vertex = candidate.IsCollapse ? CollapseEdge(mesh, edge) : SplitEdge(mesh, edge);
  const bool isGood =
    vertex != NoId && WorstAround(mesh, vertex) <= std::max(before, CotangentOf20Degrees);
  mesh.EndTrial(isGood);
  return isGood ? vertex : NoId;
}

void ValenceRound::Lock(Id vertex)
{
  this->Locks.resize(this->Mesh.Points.size(), 1);
  for (const Id near : this->Mesh.Around(vertex, 1))
  {
    this->Locks[near] = 1;
  }
}

void ValenceRound::SmoothAround(Id vertex, int rings)
{
  this->Mesh.RestoreAround(vertex);
  for (const Id near : this->Mesh.Around(vertex, rings))
  {
    SmoothVertex(this->Mesh, near);
  }
}

} // namespace biting
