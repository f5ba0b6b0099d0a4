// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Arrangement.h"

#include "../Base/SortInSteps.h"
#include "../Predicates/Predicates.h"
#include "Meetings.h"
#include "VertexGrid.h"

#include <algorithm>  // for sort, minmax, count_if
#include <cmath>      // for abs
#include <cstdint>    // for masks and counts
#include <functional> // for less
#include <string>     // for to_string
#include <utility>    // for pair

namespace biting
{

namespace
{

/// How many edges are looked at in all rounds, and how many splits are found: nearly always less
/// than ten for an edge of the drawing. But long edges that lean against a curve of short ones,
/// nearly as near as rounding, close up with it vertex by vertex, one a round.
constexpr std::size_t LeastWork = 2000000;
constexpr std::size_t WorkOfEdge = 100;
constexpr double MostForSpikes = NoiseInUlp / RoundingInUlp; // of the resolution, in roundings
constexpr int MostRoundsWithSpikes = 6; // twice what is seen where edges are not crowded

/// What the user hears of the resolution of an arrangement: what its first round finds, and why it
/// was refused.
class ResolutionReport
{
public:
  /// Ends that were joined before are among what must not be.
  ResolutionReport(const Arrangement& arrangement, ProblemList& problems);

  /// Later rounds mend what the first one has bent: no news for the user.
  void AddRound(const Meetings& found, Pulse& pulse);

  /// Two edges with the same ends. Faces share edges, and lines carry the tags of their edges: that
  /// is no news.
  void AddEqual(const ArrangementEdge& kept, const ArrangementEdge& other);

  /// Whether anything was reported that must not be where nothing is repaired.
  bool HasDefect() const { return !this->FirstDefect.Ids.empty(); }

  /// Adds why the arrangement is not resolved, with a place; returns false.
  bool Refuse(ProblemCode code);
  bool RefuseCrowd(const Meetings& found);

private:
  void Add(const MeetingReport& report);
  Point2 PlaceOf(const MeetingReport& report) const;
  void RememberFirst(Id firstCell, Id secondCell, const Point2& place);
  void RememberLast(const Meetings& found);

  const Arrangement& Data;
  ProblemList& Problems;
  bool IsFirstRound = true;
  Problem FirstDefect; ///< the cells and the place of the first report
  Problem LastDefect;  ///< of something that the last round has found
};

ResolutionReport::ResolutionReport(const Arrangement& arrangement, ProblemList& problems)
  : Data(arrangement)
  , Problems(problems)
{
  for (const ProblemGroup& group : problems.Groups())
  {
    if (group.Code == ProblemCode::JoinedEnds)
    {
      const Problem& first = group.First.front();
      const auto cell = static_cast<Id>(first.Ids.back());
      this->RememberFirst(cell, cell, InPlane(first.Place));
    }
  }
}

void ResolutionReport::AddRound(const Meetings& found, Pulse& pulse)
{
  for (const MeetingReport& report : found.Reports)
  {
    if (this->IsFirstRound && pulse.Beat())
    {
      this->Add(report);
    }
  }
  this->IsFirstRound = false;
  this->RememberLast(found);
}

void ResolutionReport::Add(const MeetingReport& report)
{
  if (report.Code == ProblemCode::NearPoints)
  {
    this->Problems.Add(
      { report.Code, { this->Data.VertexPoints[report.Vertex], NoId }, this->Data.At(report.Vertex),
        "on a segment of cell " + std::to_string(this->Data.Edge(report.First).Cell) });
    return;
  }
  const auto [first, second] =
    std::minmax({ this->Data.Edge(report.First).Cell, this->Data.Edge(report.Second).Cell });
  const Id other =
    report.Code == ProblemCode::Touches ? this->Data.VertexPoints[report.Vertex] : second;
  constexpr auto MostKept = static_cast<std::int64_t>(ProblemList::KeptPerKind);
  const bool isKept = this->Problems.Count(report.Code) < MostKept;
  const Point2 place = isKept ? this->PlaceOf(report) : Point2();
  this->Problems.Add({ report.Code, { first, other }, place, {} });
  this->RememberFirst(first, second, place);
}

Point2 ResolutionReport::PlaceOf(const MeetingReport& report) const
{
  if (report.Vertex != NoId)
  {
    return this->Data.At(report.Vertex);
  }
  const SegmentEnds& a = this->Data.Edge(report.First).Ends;
  const SegmentEnds& b = this->Data.Edge(report.Second).Ends;
  return CrossingPoint(
    this->Data.At(a.Start), this->Data.At(a.End), this->Data.At(b.Start), this->Data.At(b.End));
}

void ResolutionReport::RememberFirst(Id firstCell, Id secondCell, const Point2& place)
{
  if (this->FirstDefect.Ids.empty())
  {
    this->FirstDefect.Ids = { firstCell, secondCell };
    this->FirstDefect.Place = place;
  }
}

/// For a refusal where the first round had nothing to report, as all was within rounding.
void ResolutionReport::RememberLast(const Meetings& found)
{
  if (!found.Crossings.empty())
  {
    const auto [first, second] = found.Crossings.front();
    this->LastDefect.Ids = { this->Data.Edge(first).Cell, this->Data.Edge(second).Cell };
    this->LastDefect.Place = this->PlaceOf({ ProblemCode::Crossings, first, second, NoId });
  }
  else if (!found.Splits.empty())
  {
    const EdgeSplit& split = found.Splits.front();
    const Id cell = this->Data.Edge(split.Edge).Cell;
    this->LastDefect.Ids = { cell, cell };
    this->LastDefect.Place = this->Data.At(split.Vertex);
  }
}

void ResolutionReport::AddEqual(const ArrangementEdge& kept, const ArrangementEdge& other)
{
  const bool areLines = kept.HasLine() && other.HasLine();
  const bool countsTwice = kept.BoundaryCount + other.BoundaryCount > 0;
  if (this->IsFirstRound && (areLines || countsTwice))
  {
    const Point2& place = this->Data.At(kept.Ends.Start);
    const auto [first, second] = std::minmax({ kept.Cell, other.Cell });
    this->Problems.Add({ ProblemCode::DuplicateSegments, { first, second }, place, {} });
    this->RememberFirst(first, second, place);
  }
}

bool ResolutionReport::Refuse(ProblemCode code)
{
  Problem problem;
  if (code != ProblemCode::Aborted)
  {
    problem = this->FirstDefect.Ids.empty() ? this->LastDefect : this->FirstDefect;
  }
  problem.Code = code;
  this->Problems.Add(problem);
  return false;
}

/// One place stands for all.
bool ResolutionReport::RefuseCrowd(const Meetings& found)
{
  this->RememberLast(found);
  this->FirstDefect = this->LastDefect;
  this->FirstDefect.Detail = "one of " +
    std::to_string(found.Splits.size() + found.Crossings.size()) +
    " places or more where segments meet";
  return this->Refuse(ProblemCode::NotResolved);
}

class Resolver
{
public:
  Resolver(Arrangement& arrangement, ProblemList& problems, Pulse& pulse)
    : Data(arrangement)
    , Beats(pulse)
    , Grid(arrangement.Vertices, arrangement.Resolution, arrangement.Stretch)
    , Report(arrangement, problems)
  {
  }

  bool Run(const DomainOptions& options);

private:
  void MakeCrossingVertices();
  Id VertexAt(const Point2& place);
  void SplitEdges();
  void AppendPieces(
    const ArrangementEdge& edge, std::vector<Id>& path, std::vector<ArrangementEdge>& pieces);
  void SortAlong(const ArrangementEdge& edge, std::vector<Id>& path) const;

  void MergeEqualEdges();
  bool Drop(const ArrangementEdge& edge);
  std::vector<std::size_t> AbsorbEqualEdges();
  bool MarkAllNew(bool isWanted);

  Arrangement& Data;
  Pulse& Beats;
  VertexGrid Grid;
  Meetings Found;
  ResolutionReport Report;
};

bool Resolver::Run(const DomainOptions& options)
{
  this->MergeEqualEdges();
  bool isFullRound = true;
  double rest = 1.0;
  const std::size_t mostWork = LeastWork + WorkOfEdge * this->Data.Edges.size();
  std::size_t work = 0;
  const auto mostMeetings =
    static_cast<std::size_t>(std::max<std::int64_t>(options.MaximumNumberOfCrossings, 0));
  for (int round = 0; work <= mostWork; ++round)
  {
    PulsePart half(this->Beats, 1.0 - rest, 1.0 - 0.5 * rest);
    rest *= 0.5;
    this->Data.KeepsSpikes =
      round < MostRoundsWithSpikes && this->Data.Resolution <= MostForSpikes * this->Data.Rounding;
    if (!FindMeetings(this->Data, mostMeetings, this->Found, this->Beats))
    {
      return this->Report.Refuse(ProblemCode::Aborted);
    }
    if (this->Found.AreTooMany)
    {
      return this->Report.RefuseCrowd(this->Found);
    }
    this->Report.AddRound(this->Found, this->Beats);
    if (!options.Repair && this->Report.HasDefect())
    {
      return this->Report.Refuse(ProblemCode::NotResolved);
    }
    const bool isClean = this->Found.IsEmpty();
    if (isClean && isFullRound)
    {
      return true;
    }
    work += this->Data.Edges.size() + this->Found.Splits.size();
    this->SplitEdges();
    this->MergeEqualEdges();
    isFullRound = this->MarkAllNew(isClean);
  }
  return this->Report.Refuse(
    this->Beats.HasStopped() ? ProblemCode::Aborted : ProblemCode::NotResolved);
}

void Resolver::MakeCrossingVertices()
{
  if (this->Found.Crossings.empty())
  {
    return;
  }
  this->Grid.Update();
  for (const EdgeCrossing& crossing : this->Found.Crossings)
  {
    if (!this->Beats.Beat(16))
    {
      return;
    }
    const SegmentEnds& a = this->Data.Edge(crossing.First).Ends;
    const SegmentEnds& b = this->Data.Edge(crossing.Second).Ends;
    const Id vertex = this->VertexAt(CrossingPoint(
      this->Data.At(a.Start), this->Data.At(a.End), this->Data.At(b.Start), this->Data.At(b.End)));
    this->Found.Splits.push_back({ crossing.First, vertex });
    this->Found.Splits.push_back({ crossing.Second, vertex });
  }
}

/// The vertex that cannot be told from `place`, or a new one.
Id Resolver::VertexAt(const Point2& place)
{
  const Id known = this->Grid.Find(place);
  if (known != NoId)
  {
    return known;
  }
  this->Data.Vertices.push_back(place);
  this->Data.VertexPoints.push_back(NoId);
  this->Grid.Update();
  return static_cast<Id>(this->Data.Vertices.size()) - 1;
}

void Resolver::SplitEdges()
{
  this->MakeCrossingVertices();
  std::vector<EdgeSplit>& splits = this->Found.Splits;
  const auto isBefore = [](const EdgeSplit& a, const EdgeSplit& b)
  { return a.Edge != b.Edge ? a.Edge < b.Edge : a.Vertex < b.Vertex; };
  SortInSteps(splits, isBefore, this->Beats);
  std::vector<ArrangementEdge> pieces;
  pieces.reserve(this->Data.Edges.size() + splits.size());
  std::size_t next = 0;
  std::vector<Id> path;
  for (const ArrangementEdge& edge : this->Data.Edges)
  {
    if (!this->Beats.Beat())
    {
      return;
    }
    const Id id = static_cast<Id>(&edge - this->Data.Edges.data());
    path.clear();
    for (; next < splits.size() && splits[next].Edge == id; ++next)
    {
      path.push_back(splits[next].Vertex);
    }
    this->AppendPieces(edge, path, pieces);
  }
  this->Data.Edges.swap(pieces);
}

/// Replaces `edge` by the edges along `path`, the vertices that split it.
void Resolver::AppendPieces(
  const ArrangementEdge& edge, std::vector<Id>& path, std::vector<ArrangementEdge>& pieces)
{
  this->SortAlong(edge, path);
  ArrangementEdge piece = edge;
  piece.IsNew = !path.empty();
  for (const Id vertex : path)
  {
    piece.Ends.End = vertex;
    pieces.push_back(piece);
    piece.Ends.Start = vertex;
  }
  piece.Ends.End = edge.Ends.End;
  pieces.push_back(piece);
}

/// Sorts by the longer extent of the edge, which is exact for vertices exactly on it; drops its own
/// ends and repetitions.
void Resolver::SortAlong(const ArrangementEdge& edge, std::vector<Id>& path) const
{
  const auto isEnd = [&edge](Id vertex) { return edge.Ends.Has(vertex); };
  path.erase(std::remove_if(path.begin(), path.end(), isEnd), path.end());
  const Point2 direction = this->Data.At(edge.Ends.End) - this->Data.At(edge.Ends.Start);
  const bool alongX = std::abs(direction.X) >= std::abs(direction.Y);
  const double signX = direction.X < 0.0 ? -1.0 : 1.0;
  const double signY = direction.Y < 0.0 ? -1.0 : 1.0;
  const auto keyOf = [this, alongX, signX, signY](Id vertex)
  {
    const Point2& p = this->Data.At(vertex);
    const double x = signX * p.X;
    const double y = signY * p.Y;
    return alongX ? Point2{ x, y } : Point2{ y, x };
  };
  std::sort(path.begin(), path.end(), [keyOf](Id a, Id b) { return keyOf(a) < keyOf(b); });
  path.erase(std::unique(path.begin(), path.end()), path.end());
}

/// Keeps one of equal edges, with the counts of all, sorted by their ends.
void Resolver::MergeEqualEdges()
{
  std::vector<ArrangementEdge> merged;
  for (const std::size_t e : this->AbsorbEqualEdges())
  {
    if (!this->Drop(this->Data.Edges[e]))
    {
      merged.push_back(this->Data.Edges[e]);
    }
  }
  this->Data.Edges.swap(merged);
}

/// Whether `edge` is nothing but an edge between two neighbors, one on each side; these go together
/// then. What lies between faces on top of each other is needed to find these.
bool Resolver::Drop(const ArrangementEdge& edge)
{
  const FaceEdge& faces = edge.Faces;
  const bool areNeighbors = faces.Count == 2 && faces.Turn == 0 && faces.Second() != NoId;
  const bool isDropped =
    this->Data.IsNothing(edge) && (areNeighbors || (faces.Count == 0 && faces.Turn == 0));
  if (isDropped && areNeighbors)
  {
    this->Data.Groups.Unite(faces.First(), faces.Second());
  }
  return isDropped;
}

/// The edges that are kept, by their ends.
std::vector<std::size_t> Resolver::AbsorbEqualEdges()
{
  std::vector<std::pair<std::pair<Id, Id>, std::size_t>> keys;
  keys.reserve(this->Data.Edges.size());
  for (const ArrangementEdge& edge : this->Data.Edges)
  {
    keys.emplace_back(std::minmax({ edge.Ends.Start, edge.Ends.End }), keys.size());
  }
  std::vector<std::size_t> kept;
  const bool isSorted = SortInSteps(keys, std::less<>(), this->Beats);
  for (std::size_t i = 0, first = 0; i < keys.size() && isSorted; ++i)
  {
    if (i == 0 || keys[i].first != keys[first].first)
    {
      first = i;
      kept.push_back(keys[i].second);
      continue;
    }
    ArrangementEdge& edge = this->Data.Edges[keys[first].second];
    const ArrangementEdge& other = this->Data.Edges[keys[i].second];
    this->Report.AddEqual(edge, other);
    Absorb(edge, other);
  }
  return kept;
}

/// Where that is wanted, or most are new anyway: one round then does for two. Returns whether it
/// did.
bool Resolver::MarkAllNew(bool isWanted)
{
  std::vector<ArrangementEdge>& edges = this->Data.Edges;
  const auto isNew = [](const ArrangementEdge& edge) { return edge.IsNew; };
  const auto count = std::count_if(edges.begin(), edges.end(), isNew);
  if (!isWanted && 2 * static_cast<std::size_t>(count) < edges.size())
  {
    return false;
  }
  for (ArrangementEdge& edge : edges)
  {
    edge.IsNew = true;
  }
  return true;
}

} // namespace

bool ResolveArrangement(
  Arrangement& arrangement, const DomainOptions& options, ProblemList& problems, Pulse& pulse)
{
  return Resolver(arrangement, problems, pulse).Run(options);
}

} // namespace biting
