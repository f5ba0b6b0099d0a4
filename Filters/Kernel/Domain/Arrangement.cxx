// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Arrangement.h"

#include "../Predicates/Predicates.h"
#include "Meetings.h"
#include "PartOfStage.h"
#include "VertexGrid.h"

#include <algorithm> // for sort, minmax
#include <cmath>     // for abs
#include <cstdint>   // for masks
#include <utility>   // for pair

namespace biting
{

namespace
{

constexpr int MostRounds = 40;
constexpr int MostRoundsWithSpikes = 6; // twice what is seen where edges are not crowded

class Resolver
{
public:
  Resolver(Arrangement& arrangement, ProblemList& problems)
    : Data(arrangement)
    , Problems(problems)
    , Grid(arrangement.Vertices, arrangement.Resolution)
  {
  }

  bool Run(const DomainOptions& options, Monitor& monitor);

private:
  void ReportMeetings();
  void Report(const MeetingReport& report);
  void RememberFirst(Id firstCell, Id secondCell, const Point2& place);
  bool Refuse(ProblemCode code);

  void MakeCrossingVertices();
  Id VertexAt(const Point2& place);
  void SplitEdges();
  void AppendPieces(
    const ArrangementEdge& edge, std::vector<Id>& path, std::vector<ArrangementEdge>& pieces);
  void SortAlong(const ArrangementEdge& edge, std::vector<Id>& path) const;

  void MergeEqualEdges();
  std::vector<std::uint8_t> AbsorbEqualEdges();
  void Absorb(ArrangementEdge& kept, const ArrangementEdge& other);
  void MarkAllNew();

  Arrangement& Data;
  ProblemList& Problems;
  VertexGrid Grid;
  Meetings Found;
  bool IsFirstRound = true;
  Problem FirstDefect; ///< the cells and the place of the first report
};

bool Resolver::Run(const DomainOptions& options, Monitor& monitor)
{
  this->MergeEqualEdges();
  bool isFullRound = true;
  double rest = 1.0;
  for (int round = 0; round < MostRounds; ++round)
  {
    PartOfStage half(monitor, 1.0 - rest, 1.0 - 0.5 * rest);
    rest *= 0.5;
    this->Data.KeepsSpikes = round < MostRoundsWithSpikes;
    if (!FindMeetings(this->Data, this->Found, half))
    {
      return this->Refuse(ProblemCode::Aborted);
    }
    this->ReportMeetings();
    if (!options.Repair && !this->FirstDefect.Ids.empty())
    {
      return this->Refuse(ProblemCode::NotResolved);
    }
    const bool isClean = this->Found.IsEmpty();
    if (isClean && isFullRound)
    {
      return true;
    }
    this->SplitEdges();
    this->MergeEqualEdges();
    isFullRound = isClean;
    if (isFullRound)
    {
      this->MarkAllNew();
    }
  }
  return this->Refuse(ProblemCode::NotResolved);
}

/// Later rounds mend what the first one has bent: no news for the user.
void Resolver::ReportMeetings()
{
  if (this->IsFirstRound)
  {
    for (const MeetingReport& report : this->Found.Reports)
    {
      this->Report(report);
    }
  }
  this->IsFirstRound = false;
}

void Resolver::Report(const MeetingReport& report)
{
  const Id first = this->Data.Edge(report.First).Cell;
  const Id second = this->Data.Edge(report.Second).Cell;
  const Id other = report.Code == ProblemCode::Touches
    ? this->Data.VertexPoints[static_cast<std::size_t>(report.Vertex)]
    : second;
  this->Problems.Add({ report.Code, { first, other }, report.Place, {} });
  this->RememberFirst(first, second, report.Place);
}

void Resolver::RememberFirst(Id firstCell, Id secondCell, const Point2& place)
{
  if (this->FirstDefect.Ids.empty())
  {
    this->FirstDefect.Ids = { firstCell, secondCell };
    this->FirstDefect.Place = place;
  }
}

bool Resolver::Refuse(ProblemCode code)
{
  Problem problem;
  if (code != ProblemCode::Aborted)
  {
    problem = this->FirstDefect;
  }
  problem.Code = code;
  this->Problems.Add(problem);
  return false;
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
  std::stable_sort(splits.begin(), splits.end(),
    [](const EdgeSplit& a, const EdgeSplit& b) { return a.Edge < b.Edge; });
  std::vector<ArrangementEdge> pieces;
  pieces.reserve(this->Data.Edges.size() + splits.size());
  std::size_t next = 0;
  std::vector<Id> path;
  for (const ArrangementEdge& edge : this->Data.Edges)
  {
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

/// Keeps the first of equal edges, with the counts of all.
void Resolver::MergeEqualEdges()
{
  const std::vector<std::uint8_t> isAbsorbed = this->AbsorbEqualEdges();
  std::size_t size = 0;
  for (std::size_t e = 0; e < isAbsorbed.size(); ++e)
  {
    if (!isAbsorbed[e])
    {
      this->Data.Edges[size++] = this->Data.Edges[e];
    }
  }
  this->Data.Edges.resize(size);
}

std::vector<std::uint8_t> Resolver::AbsorbEqualEdges()
{
  std::vector<std::pair<std::pair<Id, Id>, std::size_t>> keys;
  keys.reserve(this->Data.Edges.size());
  for (const ArrangementEdge& edge : this->Data.Edges)
  {
    keys.emplace_back(std::minmax({ edge.Ends.Start, edge.Ends.End }), keys.size());
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint8_t> isAbsorbed(keys.size(), 0);
  for (std::size_t i = 1, kept = 0; i < keys.size(); ++i)
  {
    if (keys[i].first != keys[kept].first)
    {
      kept = i;
      continue;
    }
    this->Absorb(this->Data.Edges[keys[kept].second], this->Data.Edges[keys[i].second]);
    isAbsorbed[keys[i].second] = 1;
  }
  return isAbsorbed;
}

void Resolver::Absorb(ArrangementEdge& kept, const ArrangementEdge& other)
{
  kept.BoundaryCount += other.BoundaryCount;
  kept.OpenCount += other.OpenCount;
  kept.IsInterface = kept.IsInterface || other.IsInterface;
  kept.IsNew = kept.IsNew && other.IsNew;
  if (this->IsFirstRound)
  {
    const Point2& place = this->Data.At(kept.Ends.Start);
    this->Problems.Add({ ProblemCode::DuplicateSegments, { kept.Cell, other.Cell }, place, {} });
    this->RememberFirst(kept.Cell, other.Cell, place);
  }
}

void Resolver::MarkAllNew()
{
  for (ArrangementEdge& edge : this->Data.Edges)
  {
    edge.IsNew = true;
  }
}

} // namespace

std::vector<SegmentEnds> Arrangement::EdgeEnds() const
{
  std::vector<SegmentEnds> ends;
  ends.reserve(this->Edges.size());
  for (const ArrangementEdge& edge : this->Edges)
  {
    ends.push_back(edge.Ends);
  }
  return ends;
}

bool ResolveArrangement(
  Arrangement& arrangement, const DomainOptions& options, ProblemList& problems, Monitor& monitor)
{
  return Resolver(arrangement, problems).Run(options, monitor);
}

} // namespace biting
