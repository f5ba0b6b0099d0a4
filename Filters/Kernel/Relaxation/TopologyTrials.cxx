// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TopologyTrials.h"

#include "../Base/Numbers.h"
#include "../Base/SortInSteps.h"
#include "EdgeOperations.h"
#include "SegmentParts.h"
#include "Smoothing.h"
#include "Star.h"
#include "StarObjective.h"
#include "ValenceRound.h"

#include <algorithm> // for sort, max, min

namespace biting
{

namespace
{

constexpr int JudgedRings = 4;
// Up to a hundred are usual, an attempt takes about the square of their number. Around fans of long
// segments there are thousands, which nothing helps.
constexpr std::size_t MostJudged = 150;
constexpr double LeastSplitLength = 0.8; // shorter edges are no better for a vertex between them

// Poor triangles with smaller angles than that are worth more vertices that move.
constexpr double CotangentOf34Degrees = 1.482561;
constexpr int MovedRings = 2;
constexpr int MovedRingsOfWorst = 3;
constexpr int LaterRounds = 1; // of moves after the first; only what has changed is looked at
constexpr int UtmostLaterRounds = 5;
constexpr std::size_t EnoughTrials = 2; // in full, where one of them helps
constexpr int QuickRings = 1;
constexpr int QuickJudgedRings = 2;

// Of the worst after the best trial so far: where all is better by so much, vertices need not move
// further for a trial to be the best; where it is worse by so much after half of the moves, it will
// not be.
constexpr double BetterThanBest = 0.97;
constexpr double FarFromBest = 1.1;

// The last attempts: where nothing else has helped, and angles are smaller than that.
constexpr double CotangentOfLast = 1.351; // of 36.5 degrees
constexpr int NumberOfLast = 4;
constexpr int MostFailures = 2;

} // namespace

struct TopologyTrials::Effort
{
  double GreatestValenceChange;
  std::size_t TrialsInFull;
  bool IsCutOff; ///< trials that are far from the best end soon

  static Effort Usual() { return { 8.0, 3, true }; }
  static Effort Utmost() { return { Infinity, 100, false }; }
};

void TopologyTrials::Run(std::size_t limit, Pulse& pulse)
{
  this->AreTried.assign(this->Mesh.Regions.size(), 0);
  this->NumberOfTried = 0;
  this->FindCandidates(pulse);
  while (this->TryAll(limit, pulse))
  {
  }
  this->TryWorst(pulse);
}

// Each poor triangle once; whether there is reason to go on.
bool TopologyTrials::TryAll(std::size_t limit, Pulse& pulse)
{
  this->FindPoor(pulse);
  bool isImproved = false;
  for (std::size_t k = 0; k < this->Poor.size() && this->NumberOfTried < limit; ++k)
  {
    if (!pulse.Ask())
    {
      return false;
    }
    if (this->IsToBeTried(this->Poor[k].Triangle))
    {
      ++this->NumberOfTried;
      isImproved = this->Improve(this->Poor[k], Effort::Usual(), pulse) || isImproved;
      pulse.SetFraction(static_cast<double>(this->NumberOfTried) / static_cast<double>(limit));
    }
  }
  return isImproved && this->NumberOfTried < limit;
}

void TopologyTrials::TryWorst(Pulse& pulse)
{
  this->AreTried.assign(this->Mesh.Regions.size(), 0);
  int failures = 0;
  for (int k = 0; k < NumberOfLast && failures < MostFailures && pulse.Ask(); ++k)
  {
    this->FindPoor(pulse);
    if (this->Poor.empty() || this->Poor.front().Cotangent < CotangentOfLast)
    {
      return;
    }
    failures += this->Improve(this->Poor.front(), Effort::Utmost(), pulse) ? 0 : 1;
  }
}

void TopologyTrials::FindCandidates(Pulse& pulse)
{
  this->Candidates.clear();
  this->NumberOfSorted = 0;
  pulse.ForEach(this->Mesh.Regions.size(),
    [this](std::size_t slot)
    {
      if (this->IsToBeTried(static_cast<Id>(slot)))
      {
        this->Candidates.push_back(static_cast<Id>(slot));
      }
    });
}

// Of the candidates, the worst first.
void TopologyTrials::FindPoor(Pulse& pulse)
{
  const auto added = this->Candidates.begin() + static_cast<std::ptrdiff_t>(this->NumberOfSorted);
  std::sort(added, this->Candidates.end());
  std::inplace_merge(this->Candidates.begin(), added, this->Candidates.end());
  this->Candidates.erase(
    std::unique(this->Candidates.begin(), this->Candidates.end()), this->Candidates.end());
  this->NumberOfSorted = this->Candidates.size();
  this->Poor.clear();
  for (const Id triangle : this->Candidates)
  {
    if (this->IsToBeTried(triangle))
    {
      this->Poor.push_back({ WorstFreeCotangent(this->Mesh, triangle), triangle });
    }
  }
  SortInSteps(
    this->Poor,
    [](const PoorTriangle& a, const PoorTriangle& b)
    { return a.Cotangent != b.Cotangent ? a.Cotangent > b.Cotangent : a.Triangle < b.Triangle; },
    pulse);
}

bool TopologyTrials::IsToBeTried(Id triangle) const
{
  return this->Mesh.IsEdge(4 * triangle) && this->AreTried[triangle] == 0 &&
    IsWorseThan(this->Mesh, triangle, this->Mesh.PoorCotangents * CotangentOf38Degrees);
}

bool TopologyTrials::Improve(const PoorTriangle& poor, const Effort& effort, Pulse& pulse)
{
  this->AreTried[poor.Triangle] = 1;
  if (!this->LookAround(poor) || !this->RankOperations(effort, pulse))
  {
    return false;
  }
  const Operation best = this->TryInFull(effort);
  const bool isImproved = best.Edge != NoId && this->Keep(best);
  if (isImproved)
  {
    this->MarkUntried();
  }
  return isImproved;
}

// False where there is too much.
bool TopologyTrials::LookAround(const PoorTriangle& poor)
{
  const Id* first = this->Mesh.Corners.data() + 4 * static_cast<std::size_t>(poor.Triangle);
  const std::vector<Id> corners(first, first + 3);
  this->Worst = { WorstFreeCotangent(this->Mesh, poor.Triangle), poor.Triangle };
  this->Judged = this->Mesh.Around(corners, JudgedRings);
  if (this->Judged.size() > MostJudged)
  {
    return false;
  }
  this->Before.clear();
  for (const Id vertex : this->Judged)
  {
    this->Before.push_back(ObjectiveAround(this->Mesh, vertex));
  }
  this->FindEdges(corners);
  return true;
}

// Those of the triangles around the corners, each once.
void TopologyTrials::FindEdges(const std::vector<Id>& corners)
{
  this->Edges.clear();
  for (const Id vertex : corners)
  {
    if (this->Mesh.Degrees[vertex] > Star::Capacity)
    {
      continue;
    }
    this->Mesh.ForEachAround(vertex,
      [this](Id edge)
      {
        for (const Id side : { edge, MutableMesh::Next(edge), MutableMesh::Previous(edge) })
        {
          this->Edges.push_back(this->Mesh.IsFirstHalf(side) ? side : this->Mesh.Twins[side]);
        }
      });
  }
  std::sort(this->Edges.begin(), this->Edges.end());
  this->Edges.erase(std::unique(this->Edges.begin(), this->Edges.end()), this->Edges.end());
}

// The most promising first, as many as are tried. False where the monitor wants to stop.
bool TopologyTrials::RankOperations(const Effort& effort, Pulse& pulse)
{
  this->Operations.clear();
  std::vector<double> lowest(effort.TrialsInFull, Infinity); // of the trials so far, ascending
  for (const Id edge : this->Edges)
  {
    for (const bool isCollapse : { true, false })
    {
      Operation operation{ edge, isCollapse, Infinity };
      if (this->IsPromising(operation, effort))
      {
        operation.Worst = this->QuickTrial(operation, lowest.back());
      }
      if (operation.Worst < lowest.back())
      {
        lowest.pop_back();
        lowest.insert(
          std::upper_bound(lowest.begin(), lowest.end(), operation.Worst), operation.Worst);
        this->Operations.push_back(operation);
      }
    }
    if (!pulse.Beat())
    {
      return false;
    }
  }
  std::stable_sort(this->Operations.begin(), this->Operations.end(),
    [](const Operation& a, const Operation& b) { return a.Worst < b.Worst; });
  return true;
}

bool TopologyTrials::IsPromising(const Operation& operation, const Effort& effort) const
{
  const Id edge = operation.Edge;
  const double change = operation.IsCollapse ? ValenceChangeOfCollapse(this->Mesh, edge)
                                             : ValenceChangeOfSplit(this->Mesh, edge);
  if (!(change <= effort.GreatestValenceChange))
  {
    return false;
  }
  return operation.IsCollapse
    ? !LeavesLongPart(this->Mesh, edge)
    : this->Mesh.RelativeLength(edge) >= LeastSplitLength && !LeavesShortParts(this->Mesh, edge);
}

// The worst that it leaves near by, after little smoothing; or anything not below `limit`.
double TopologyTrials::QuickTrial(const Operation& operation, double limit)
{
  this->Mesh.BeginTrial();
  const Id vertex = this->Perform(operation);
  double worst = vertex == NoId ? Infinity : 0.0;
  if (vertex != NoId)
  {
    this->SmoothNear(vertex, QuickRings);
    const std::vector<Id>& judged = this->Mesh.Around(vertex, QuickJudgedRings);
    for (std::size_t k = 0; k < judged.size() && worst < limit; ++k)
    {
      worst = std::max(worst, ObjectiveAround(this->Mesh, judged[k]));
    }
  }
  this->Mesh.EndTrial(false);
  return worst;
}

TopologyTrials::Operation TopologyTrials::TryInFull(const Effort& effort)
{
  Operation best;
  best.Worst = this->Worst.Cotangent;
  const std::size_t count = std::min(this->Operations.size(), effort.TrialsInFull);
  for (std::size_t k = 0; k < count; ++k)
  {
    if (effort.IsCutOff && best.Edge != NoId && k >= EnoughTrials)
    {
      break;
    }
    Operation operation = this->Operations[k];
    this->Mesh.BeginTrial();
    const double good = std::max(CotangentOf40Degrees, BetterThanBest * best.Worst);
    operation.Worst = this->FullTrial(operation, good, best.Worst, effort.IsCutOff);
    this->Mesh.EndTrial(false);
    best = operation.Worst < best.Worst ? operation : best;
  }
  return best;
}

// The worst of what it changes, or anything not below `limit`. Vertices move until they are better
// than `good`.
double TopologyTrials::FullTrial(
  const Operation& operation, double good, double limit, bool isCutOff)
{
  const Id vertex = this->Perform(operation);
  if (vertex == NoId)
  {
    return Infinity;
  }
  const bool isWorst = this->Worst.Cotangent > CotangentOf34Degrees;
  this->SmoothNear(vertex, isWorst ? MovedRingsOfWorst : MovedRings);
  this->Descent.Wake(this->Moved);
  this->Descent.Improve(this->Moved, good);
  if (isCutOff && !(this->WorstChanged(vertex, FarFromBest * limit) < FarFromBest * limit))
  {
    return Infinity;
  }
  const int laterRounds = isCutOff ? LaterRounds : UtmostLaterRounds;
  for (int round = 0; round < laterRounds; ++round)
  {
    this->Descent.Improve(this->Moved, good);
  }
  return this->WorstChanged(vertex, limit);
}

// Once more, without a limit to the moves. False, and it is taken back, where that does not help.
bool TopologyTrials::Keep(const Operation& operation)
{
  this->Mesh.BeginTrial();
  const double worst =
    this->FullTrial(operation, CotangentOf40Degrees, this->Worst.Cotangent, false);
  const bool isBetter = worst < this->Worst.Cotangent;
  this->Mesh.EndTrial(isBetter);
  return isBetter;
}

// With flips. NoId where the mesh does not allow it.
Id TopologyTrials::Perform(const Operation& operation)
{
  const Id edge = operation.Edge;
  const Id vertex =
    operation.IsCollapse ? CollapseEdge(this->Mesh, edge) : SplitEdge(this->Mesh, edge);
  if (vertex == NoId || this->Mesh.Degrees[vertex] > Star::Capacity)
  {
    return NoId;
  }
  this->Mesh.RestoreAround(vertex);
  return vertex;
}

void TopologyTrials::SmoothNear(Id vertex, int rings)
{
  this->Moved = this->Mesh.Around(vertex, rings);
  for (const Id near : this->Moved)
  {
    SmoothVertex(this->Mesh, near);
  }
}

// Of the stars that are not as they were before, and of the poor triangle where it is left; or
// anything not below `limit`, where it is not below that.
double TopologyTrials::WorstChanged(Id added, double limit) const
{
  double worst = ObjectiveAround(this->Mesh, added);
  if (this->Mesh.IsEdge(4 * this->Worst.Triangle))
  {
    worst = std::max(worst, WorstFreeCotangent(this->Mesh, this->Worst.Triangle));
  }
  for (std::size_t k = 0; k < this->Judged.size() && worst < limit; ++k)
  {
    const Id vertex = this->Judged[k];
    const double here =
      this->Mesh.IsAlive(vertex) ? ObjectiveAround(this->Mesh, vertex) : this->Before[k];
    worst = here == this->Before[k] ? worst : std::max(worst, here);
  }
  return worst;
}

// The triangles near what was changed.
void TopologyTrials::MarkUntried()
{
  this->AreTried.resize(this->Mesh.Regions.size(), 0);
  for (const Id vertex : this->Judged)
  {
    if (this->Mesh.IsAlive(vertex))
    {
      this->Mesh.ForEachAround(vertex,
        [this](Id edge)
        {
          this->AreTried[MutableMesh::TriangleOf(edge)] = 0;
          this->Candidates.push_back(MutableMesh::TriangleOf(edge));
        });
    }
  }
}

} // namespace biting
