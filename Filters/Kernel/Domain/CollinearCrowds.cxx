// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CollinearCrowds.h"

#include "../Base/Box.h"
#include "../Base/SortInSteps.h"
#include "../Predicates/Predicates.h"

#include <algorithm>  // for max_element, remove_if, sort, unique
#include <cmath>      // for abs, floor
#include <cstdint>    // for keys
#include <functional> // for less
#include <iterator>   // for next
#include <set>        // for the edges along a piece
#include <tuple>      // for keys
#include <utility>    // for pair

namespace biting
{

namespace
{

/// Lines are told apart by slope and height to this share of the drawing's size.
constexpr double LinesPerSize = 0x1p20;
constexpr std::size_t LeastCrowd = 3;

/// A piece, and its place among the edges: those of one edge follow each other along it.
struct Piece
{
  Id Source = NoId; ///< the first edge along it
  Id Step = 0;      ///< along that edge
  ArrangementEdge Edge;
};

/// Edges that run along one piece.
struct Bundle
{
  std::set<Id> Ids;
  Id BoundaryCount = 0;
  Id OpenCount = 0;
  Id InterfaceCount = 0;
  Id FaceCount = 0;

  /// Adds an edge, or takes it out where it is already there.
  void Toggle(Id id, const ArrangementEdge& edge)
  {
    const bool isIn = this->Ids.erase(id) == 0 && this->Ids.insert(id).second;
    const Id sign = isIn ? 1 : -1;
    this->BoundaryCount += sign * edge.BoundaryCount;
    this->OpenCount += sign * edge.OpenCount;
    this->InterfaceCount += edge.IsInterface ? sign : 0;
    this->FaceCount += sign * edge.Faces.Count;
  }
};

class CrowdMerger
{
public:
  CrowdMerger(Arrangement& arrangement, ProblemList& problems, Pulse& pulse)
    : Data(arrangement)
    , Problems(problems)
    , Beats(pulse)
    , IsReplaced(arrangement.Edges.size(), 0)
  {
  }

  void Run();

private:
  using LineKey = std::tuple<bool, std::int64_t, std::int64_t>;
  using Crowd = std::vector<Id>;

  std::vector<std::pair<LineKey, Id>> SortByLine();
  LineKey KeyOf(Id edge, const Box2& bounds) const;
  void MergeCrowd(Crowd edges);
  Id LongestOf(const Crowd& edges) const;
  bool LiesAlong(Id edge, Id line) const;
  std::vector<Id> SortedEnds(const Crowd& edges, Id line) const;
  std::vector<std::pair<Id, Id>> Events(const Crowd& edges, const std::vector<Id>& path) const;
  void MakePieces(const Crowd& edges, const std::vector<Id>& path);
  void AddPiece(const Bundle& edges, Id start, Id end, Id rank);
  void AddFaces(const Bundle& edges, ArrangementEdge& piece) const;
  void Report(Id first, Id second, Id vertex);
  void ReplaceEdges();

  const SegmentEnds& EndsOf(Id edge) const { return this->Data.Edge(edge).Ends; }
  Point2 Direction(Id edge) const
  {
    return this->Data.At(this->EndsOf(edge).End) - this->Data.At(this->EndsOf(edge).Start);
  }

  Arrangement& Data;
  ProblemList& Problems;
  Pulse& Beats;
  std::vector<std::uint8_t> IsReplaced;
  std::vector<Piece> Pieces;
};

void CrowdMerger::Run()
{
  const std::vector<std::pair<LineKey, Id>> edges = this->SortByLine();
  Crowd crowd;
  for (std::size_t i = 0; i < edges.size() && this->Beats.Beat(); ++i)
  {
    crowd.push_back(edges[i].second);
    if (i + 1 == edges.size() || edges[i + 1].first != edges[i].first)
    {
      this->MergeCrowd(std::move(crowd));
      crowd = Crowd();
    }
  }
  if (!this->Beats.HasStopped())
  {
    this->ReplaceEdges();
  }
}

std::vector<std::pair<CrowdMerger::LineKey, Id>> CrowdMerger::SortByLine()
{
  Box2 bounds;
  for (const Point2& p : this->Data.Vertices)
  {
    bounds.Add(p);
  }
  std::vector<std::pair<LineKey, Id>> edges;
  edges.reserve(this->Data.Edges.size());
  for (Id edge = 0; edge < static_cast<Id>(this->Data.Edges.size()); ++edge)
  {
    edges.emplace_back(this->KeyOf(edge, bounds), edge);
  }
  SortInSteps(edges, std::less<>(), this->Beats);
  return edges;
}

/// Slope, and height above the middle of the drawing, of the line along an edge.
CrowdMerger::LineKey CrowdMerger::KeyOf(Id edge, const Box2& bounds) const
{
  const Point2 direction = this->Direction(edge);
  const Point2 place = this->Data.At(this->EndsOf(edge).Start) - bounds.Center();
  const bool isSteep = std::abs(direction.Y) > std::abs(direction.X);
  const double slope = isSteep ? direction.X / direction.Y : direction.Y / direction.X;
  const double height = isSteep ? place.X - slope * place.Y : place.Y - slope * place.X;
  const double size = std::max(bounds.Width(), bounds.Height());
  const auto rounded = [](double x) { return static_cast<std::int64_t>(std::floor(x + 0.5)); };
  return { isSteep, rounded(LinesPerSize * slope), rounded(LinesPerSize * (height / size)) };
}

void CrowdMerger::MergeCrowd(Crowd edges)
{
  if (edges.size() < LeastCrowd)
  {
    return;
  }
  const Id line = this->LongestOf(edges);
  const auto isOff = [this, line](Id edge) { return !this->LiesAlong(edge, line); };
  edges.erase(std::remove_if(edges.begin(), edges.end(), isOff), edges.end());
  if (edges.size() >= LeastCrowd)
  {
    this->MakePieces(edges, this->SortedEnds(edges, line));
  }
}

Id CrowdMerger::LongestOf(const Crowd& edges) const
{
  const auto isShorter = [this](Id a, Id b)
  {
    const Point2 first = this->Direction(a);
    const Point2 second = this->Direction(b);
    return std::abs(first.X) + std::abs(first.Y) < std::abs(second.X) + std::abs(second.Y);
  };
  return *std::max_element(edges.begin(), edges.end(), isShorter);
}

bool CrowdMerger::LiesAlong(Id edge, Id line) const
{
  const Point2& origin = this->Data.At(this->EndsOf(line).Start);
  const Point2 direction = this->Direction(line);
  const double reach = 0.5 * this->Data.ReachAcross(this->Data.At(this->EndsOf(line).End) - origin);
  const auto isNear = [this, &origin, &direction, reach](Id vertex)
  { return std::abs(Cross(direction, this->Data.At(vertex) - origin)) <= reach; };
  return isNear(this->EndsOf(edge).Start) && isNear(this->EndsOf(edge).End);
}

/// All ends in the order in which the line passes them: by its longer extent, which is exact for
/// what lies on it exactly.
std::vector<Id> CrowdMerger::SortedEnds(const Crowd& edges, Id line) const
{
  const Point2 direction = this->Direction(line);
  const bool alongX = std::abs(direction.X) >= std::abs(direction.Y);
  const auto keyOf = [this, alongX](Id vertex)
  {
    const Point2& p = this->Data.At(vertex);
    return alongX ? p : Point2{ p.Y, p.X };
  };
  std::vector<Id> path;
  for (const Id edge : edges)
  {
    path.push_back(this->EndsOf(edge).Start);
    path.push_back(this->EndsOf(edge).End);
  }
  std::sort(path.begin(), path.end(), [keyOf](Id a, Id b) { return keyOf(a) < keyOf(b); });
  path.erase(std::unique(path.begin(), path.end()), path.end());
  return path;
}

/// For each end, its place along the path, and the edge that begins or ends there; along the path.
std::vector<std::pair<Id, Id>> CrowdMerger::Events(
  const Crowd& edges, const std::vector<Id>& path) const
{
  std::vector<std::pair<Id, Id>> ranks; // of vertices, by vertex
  for (std::size_t rank = 0; rank < path.size(); ++rank)
  {
    ranks.emplace_back(path[rank], static_cast<Id>(rank));
  }
  std::sort(ranks.begin(), ranks.end());
  std::vector<std::pair<Id, Id>> events;
  for (const Id edge : edges)
  {
    for (const Id end : { this->EndsOf(edge).Start, this->EndsOf(edge).End })
    {
      const auto rank = std::lower_bound(ranks.begin(), ranks.end(), std::make_pair(end, Id(0)));
      events.emplace_back(rank->second, edge);
    }
  }
  std::sort(events.begin(), events.end());
  return events;
}

/// Walks along the path with the edges that run along each of its pieces.
void CrowdMerger::MakePieces(const Crowd& edges, const std::vector<Id>& path)
{
  for (const Id edge : edges)
  {
    this->IsReplaced[static_cast<std::size_t>(edge)] = 1;
  }
  const std::vector<std::pair<Id, Id>> events = this->Events(edges, path);
  Bundle present;
  for (std::size_t i = 0; i < events.size() && this->Beats.Beat(); ++i)
  {
    const Id rank = events[i].first;
    present.Toggle(events[i].second, this->Data.Edge(events[i].second));
    const bool isLast = i + 1 == events.size() || events[i + 1].first != rank;
    if (isLast && !present.Ids.empty())
    {
      const auto place = static_cast<std::size_t>(rank);
      this->AddPiece(present, path[place], path[place + 1], rank);
    }
  }
}

/// Directed as the first of the edges.
void CrowdMerger::AddPiece(const Bundle& edges, Id start, Id end, Id rank)
{
  Piece piece;
  piece.Source = *edges.Ids.begin();
  piece.Edge = this->Data.Edge(piece.Source);
  const Point2 direction = this->Direction(piece.Source);
  const bool isForward = Dot(this->Data.At(end) - this->Data.At(start), direction) > 0.0;
  piece.Step = isForward ? rank : -rank;
  piece.Edge.Ends = isForward ? SegmentEnds{ start, end } : SegmentEnds{ end, start };
  piece.Edge.BoundaryCount = edges.BoundaryCount;
  piece.Edge.OpenCount = edges.OpenCount;
  piece.Edge.IsInterface = edges.InterfaceCount > 0;
  this->AddFaces(edges, piece.Edge);
  if (edges.Ids.size() > 1)
  {
    this->Report(piece.Source, *std::next(edges.Ids.begin()), start);
  }
  this->Pieces.push_back(piece);
}

/// Where faces are among the edges: one after the other.
void CrowdMerger::AddFaces(const Bundle& edges, ArrangementEdge& piece) const
{
  if (edges.FaceCount == 0)
  {
    return;
  }
  const SegmentEnds ends = piece.Ends;
  const Point2 direction = this->Data.At(ends.End) - this->Data.At(ends.Start);
  piece = this->Data.Edge(*edges.Ids.begin());
  piece.Ends = ends;
  for (auto id = std::next(edges.Ids.begin()); id != edges.Ids.end(); ++id)
  {
    ArrangementEdge other = this->Data.Edge(*id);
    const bool isForward = Dot(this->Direction(*id), direction) > 0.0;
    other.Ends = isForward ? ends : SegmentEnds{ ends.End, ends.Start };
    Absorb(piece, other);
  }
}

/// That faces share edges, or lines run along faces, is no news.
void CrowdMerger::Report(Id first, Id second, Id vertex)
{
  if (!this->Data.Edge(first).HasLine() || !this->Data.Edge(second).HasLine())
  {
    return;
  }
  const SegmentEnds& a = this->EndsOf(first);
  const SegmentEnds& b = this->EndsOf(second);
  const auto isOnLine = [this, &a](Id end)
  { return Orient2D(this->Data.At(a.Start), this->Data.At(a.End), this->Data.At(end)) == 0; };
  if (isOnLine(b.Start) && isOnLine(b.End))
  {
    this->Problems.Add({ ProblemCode::DuplicateSegments,
      { this->Data.Edge(first).Cell, this->Data.Edge(second).Cell }, this->Data.At(vertex), {} });
  }
}

void CrowdMerger::ReplaceEdges()
{
  std::sort(this->Pieces.begin(), this->Pieces.end(),
    [](const Piece& a, const Piece& b)
    { return std::make_pair(a.Source, a.Step) < std::make_pair(b.Source, b.Step); });
  std::vector<ArrangementEdge> edges;
  std::size_t next = 0;
  for (std::size_t edge = 0; edge < this->Data.Edges.size(); ++edge)
  {
    if (!this->IsReplaced[edge])
    {
      edges.push_back(this->Data.Edges[edge]);
    }
    for (; next < this->Pieces.size() && this->Pieces[next].Source == static_cast<Id>(edge); ++next)
    {
      edges.push_back(this->Pieces[next].Edge);
    }
  }
  this->Data.Edges.swap(edges);
}

} // namespace

void MergeCollinearCrowds(Arrangement& arrangement, ProblemList& problems, Pulse& pulse)
{
  CrowdMerger(arrangement, problems, pulse).Run();
}

} // namespace biting
