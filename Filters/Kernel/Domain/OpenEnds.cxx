// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OpenEnds.h"

#include "../Base/Box.h"
#include "EndSurroundings.h"
#include "VertexGrid.h"

#include <algorithm> // for max, min, remove_if, sort
#include <map>       // for the feet of a segment
#include <tuple>     // for orders
#include <utility>   // for pair, move

namespace biting
{

namespace
{

/// No edge shorter than this, in spacings, is made by joining.
constexpr double ShortestEdge = 0.01;

/// Two ends meet on a segment between them, at about half of their distance. A segment that is no
/// nearer than this share of it does not lie between them.
constexpr double LargestShareBetween = 0.75;

/// Of the distance to a segment: a vertex that near to the foot counts as near as the segment.
constexpr double AboutEqual = 0.5;

class EndJoiner
{
public:
  EndJoiner(std::vector<ChainSegment> segments, const DomainOptions& options, std::vector<Id> ends,
    WeldedPoints& points, Pulse& pulse)
    : Options(options)
    , Ends(std::move(ends))
    , Points(points)
    , Beats(pulse)
    , Around(std::move(segments), points, pulse)
    , Reaches(points.Vertices.size(), 0.0)
    , Shortest(points.Vertices.size(), 0.0)
    , Places(points.Vertices)
  {
    for (std::size_t vertex = 0; vertex < this->Places.size(); ++vertex)
    {
      this->Targets.push_back(static_cast<Id>(vertex));
    }
  }

  std::vector<SegmentFoot> Run(ProblemList& problems);

private:
  using Cluster = std::vector<Id>;
  struct Move
  {
    double Distance = 0.0;
    Point2 Place;
    Id Point = NoId;
    Id Cell = NoId;
  };

  void FindReaches();
  bool IsSettled(Id end) const;
  std::vector<Cluster> MakeClusters();
  bool AreWithinReach(Id end, Id leader);
  void JoinCluster(const Cluster& cluster);
  Foot NearestFoot(const Cluster& cluster) const;
  bool JoinWithVertexAt(const Foot& foot, const Cluster& cluster);
  void JoinWithSegment(const Foot& foot, const Cluster& cluster);
  void JoinWith(Id vertex, Id cell, const Cluster& cluster);
  void Divide(const Foot& foot, Id vertex);
  void HoldWhatTouches();
  void Report(ProblemList& problems);
  void Renumber();

  const Point2& At(Id vertex) const { return this->Points.Vertices[vertex]; }
  double ReachOf(Id vertex) const { return this->Reaches[vertex]; }

  const DomainOptions& Options;
  std::vector<Id> Ends;
  WeldedPoints& Points;
  Pulse& Beats;
  EndSurroundings Around;
  std::vector<double> Reaches;        ///< of vertices; above zero for open ends only
  std::vector<double> Shortest;       ///< of open ends: the least length of edges made there
  std::vector<Id> Targets;            ///< of vertices: the vertex that each becomes
  std::vector<Point2> Places;         ///< of vertices, in the end
  std::map<Id, std::vector<Id>> Feet; ///< of segments: vertices that divide them
  std::vector<SegmentFoot> Result;
  std::vector<Move> Moves;
};

std::vector<SegmentFoot> EndJoiner::Run(ProblemList& problems)
{
  this->FindReaches();
  for (const Cluster& cluster : this->MakeClusters())
  {
    if (this->Beats.Beat())
    {
      this->JoinCluster(cluster);
    }
  }
  if (!this->Moves.empty() && !this->Beats.HasStopped())
  {
    this->HoldWhatTouches();
    this->Report(problems);
    this->Renumber();
  }
  return std::move(this->Result);
}

/// Ends that lie on a segment are open no more.
void EndJoiner::FindReaches()
{
  const auto isSettled = [this](Id end) { return !this->Beats.Beat() || this->IsSettled(end); };
  this->Ends.erase(
    std::remove_if(this->Ends.begin(), this->Ends.end(), isSettled), this->Ends.end());
  const SpacingAtEnds spacingAt(this->Options, this->Places);
  const double tolerance = this->Options.EndTolerance;
  for (const Id end : this->Ends)
  {
    const double spacing = tolerance > 0.0 ? spacingAt(this->At(end)) : 0.0;
    const double least = this->Points.Resolution;
    const double reach = std::max(tolerance * spacing, least);
    this->Reaches[end] = reach;
    this->Shortest[end] = std::min(reach, std::max(ShortestEdge * spacing, least));
  }
}

bool EndJoiner::IsSettled(Id end) const
{
  bool isSettled = false;
  const double rounding = this->Points.Rounding;
  this->Around.VisitNear(this->At(end), rounding,
    [this, end, rounding, &isSettled](Id segment)
    {
      isSettled = isSettled ||
        (!this->Around.Segment(segment).Ends.Has(end) &&
          this->Around.FootOn(segment, end).Distance <= rounding);
    });
  return isSettled;
}

/// Ends within reach of the first of them.
std::vector<EndJoiner::Cluster> EndJoiner::MakeClusters()
{
  double farthest = 0.0;
  for (const double reach : this->Reaches)
  {
    farthest = std::max(farthest, reach);
  }
  std::vector<Cluster> clusters;
  std::vector<Point2> leaders;
  VertexGrid grid(leaders, farthest);
  for (std::size_t i = 0; i < this->Ends.size() && farthest > 0.0 && this->Beats.Beat(); ++i)
  {
    const Id end = this->Ends[i];
    grid.Update();
    const Id nearest = grid.Find(this->At(end));
    if (nearest != NoId && this->AreWithinReach(end, clusters[nearest].front()))
    {
      clusters[nearest].push_back(end);
      continue;
    }
    clusters.push_back({ end });
    leaders.push_back(this->At(end));
  }
  return clusters;
}

bool EndJoiner::AreWithinReach(Id end, Id leader)
{
  const double reach = std::max(this->ReachOf(end), this->ReachOf(leader));
  this->Around.AddOwn(end, reach);
  const bool isOwn = this->Around.IsOwn(leader);
  this->Around.ForgetOwn();
  return !isOwn && Distance(this->At(end), this->At(leader)) <= reach;
}

void EndJoiner::JoinCluster(const Cluster& cluster)
{
  const Id leader = cluster.front();
  double apart = 0.0;
  for (const Id end : cluster)
  {
    this->Around.AddOwn(end, this->ReachOf(end));
    apart = std::max(apart, Distance(this->At(end), this->At(leader)));
  }
  const Foot foot = this->NearestFoot(cluster);
  const bool isBetween = cluster.size() == 1 || foot.Distance <= LargestShareBetween * apart;
  if (foot.Segment == NoId || !isBetween)
  {
    this->JoinWith(leader, this->Around.SegmentAt(leader).Cell, cluster);
  }
  else if (!this->JoinWithVertexAt(foot, cluster))
  {
    this->JoinWithSegment(foot, cluster);
  }
  this->Around.ForgetOwn();
}

/// The nearest one that any of the ends has within its reach, but for those at other open ends.
Foot EndJoiner::NearestFoot(const Cluster& cluster) const
{
  Foot nearest;
  const auto orderOf = [](const Foot& foot)
  { return std::make_tuple(foot.Distance, foot.Place, foot.Segment); };
  for (const Id end : cluster)
  {
    this->Around.VisitNear(this->At(end), this->ReachOf(end),
      [this, end, &nearest, orderOf](Id segment)
      {
        const SegmentEnds& ends = this->Around.Segment(segment).Ends;
        const bool isOwn = this->Around.IsOwn(ends.Start) || this->Around.IsOwn(ends.End);
        const Foot foot = this->Around.FootOn(segment, end);
        const bool isFirst = nearest.Segment == NoId;
        const bool isAtOpenEnd = (foot.Along == 0.0 && this->ReachOf(ends.Start) > 0.0) ||
          (foot.Along == 1.0 && this->ReachOf(ends.End) > 0.0);
        if (!isOwn && !isAtOpenEnd && foot.Distance <= this->ReachOf(end) &&
          (isFirst || orderOf(foot) < orderOf(nearest)))
        {
          nearest = foot;
        }
      });
  }
  return nearest;
}

/// A vertex of a segment that is no open end, or one that an end has made on it before. Whether
/// there is one near the foot.
bool EndJoiner::JoinWithVertexAt(const Foot& foot, const Cluster& cluster)
{
  const double reach = std::max(AboutEqual * foot.Distance, this->Shortest[foot.End]);
  using Candidate = std::tuple<double, Point2, Id, Id>; // distance, place, vertex, cell
  std::vector<Candidate> candidates;
  const auto take = [this, reach, &foot, &candidates](Id vertex, Id cell)
  {
    const Point2& place = this->Places[vertex];
    const double distance = Distance(place, foot.Place);
    if (distance <= reach)
    {
      candidates.emplace_back(distance, place, vertex, cell);
    }
  };
  this->Around.VisitNear(foot.Place, reach,
    [this, take](Id segment)
    {
      const ChainSegment& here = this->Around.Segment(segment);
      for (const Id vertex : { here.Ends.Start, here.Ends.End })
      {
        if (!this->Around.IsOwn(vertex) && this->ReachOf(vertex) == 0.0)
        {
          take(vertex, here.Cell);
        }
      }
      const auto feet = this->Feet.find(segment);
      for (std::size_t i = 0; feet != this->Feet.end() && i < feet->second.size(); ++i)
      {
        take(feet->second[i], here.Cell);
      }
    });
  const auto nearest = std::min_element(candidates.begin(), candidates.end());
  if (nearest != candidates.end())
  {
    this->JoinWith(std::get<2>(*nearest), std::get<3>(*nearest), cluster);
  }
  return nearest != candidates.end();
}

/// The first end becomes the foot, which is no point of the input.
void EndJoiner::JoinWithSegment(const Foot& foot, const Cluster& cluster)
{
  const Id vertex = cluster.front();
  const ChainSegment& segment = this->Around.Segment(foot.Segment);
  this->Places[vertex] = foot.Place;
  this->JoinWith(vertex, segment.Cell, cluster);
  this->Points.VertexPoints[vertex] = NoId;
  this->Feet[foot.Segment].push_back(vertex);
  this->Divide(foot, vertex);
}

void EndJoiner::Divide(const Foot& foot, Id vertex)
{
  const ChainSegment& segment = this->Around.Segment(foot.Segment);
  const double along = segment.IsReversed ? 1.0 - foot.Along : foot.Along;
  this->Result.push_back({ segment.Place, along, vertex });
}

/// Vertices that lie on the segment of an end stay on it where the end moves.
void EndJoiner::HoldWhatTouches()
{
  for (const Id end : this->Ends)
  {
    const bool isMoved =
      this->Beats.Beat() && (this->Targets[end] != end || this->Places[end] != this->At(end));
    for (const Foot& foot : isMoved ? this->Around.VerticesOnSegmentAt(end) : std::vector<Foot>())
    {
      if (this->ReachOf(foot.End) == 0.0)
      {
        this->Divide(foot, foot.End);
      }
    }
  }
}

void EndJoiner::JoinWith(Id vertex, Id cell, const Cluster& cluster)
{
  for (const Id end : cluster)
  {
    this->Targets[end] = vertex;
    const double distance = Distance(this->At(end), this->Places[vertex]);
    if (distance > 0.0)
    {
      const Id point = this->Points.VertexPoints[end];
      this->Moves.push_back({ distance, this->At(end), point, cell });
    }
  }
}

void EndJoiner::Report(ProblemList& problems)
{
  std::sort(this->Moves.begin(), this->Moves.end(),
    [](const Move& a, const Move& b)
    { return std::tie(b.Distance, a.Place) < std::tie(a.Distance, b.Place); });
  for (const Move& move : this->Moves)
  {
    problems.Add({ ProblemCode::JoinedEnds, { move.Point, move.Cell }, move.Place,
      "moved by " + Figure(move.Distance) +
        (problems.Has(ProblemCode::JoinedEnds) ? "" : ", which is the most") });
  }
}

/// Vertices at one place become one.
void EndJoiner::Renumber()
{
  std::vector<std::pair<Point2, Id>> order;
  for (std::size_t vertex = 0; vertex < this->Targets.size(); ++vertex)
  {
    if (this->Targets[vertex] == static_cast<Id>(vertex))
    {
      order.emplace_back(this->Places[vertex], this->Targets[vertex]);
    }
  }
  std::sort(order.begin(), order.end());
  const std::vector<Id> points = std::move(this->Points.VertexPoints);
  std::vector<Id> numbers(this->Targets.size(), NoId);
  this->Points.Vertices.clear();
  this->Points.VertexPoints.clear();
  for (const auto& [place, vertex] : order)
  {
    if (this->Points.Vertices.empty() || this->Points.Vertices.back() != place)
    {
      this->Points.Vertices.push_back(place);
      this->Points.VertexPoints.push_back(NoId);
    }
    Id& point = this->Points.VertexPoints.back();
    point = std::max(point, points[vertex]);
    numbers[vertex] = static_cast<Id>(this->Points.Vertices.size()) - 1;
  }
  const auto renumber = [this, &numbers](Id& vertex)
  { vertex = vertex == NoId ? NoId : numbers[this->Targets[vertex]]; };
  std::for_each(this->Points.VertexOf.begin(), this->Points.VertexOf.end(), renumber);
  for (SegmentFoot& foot : this->Result)
  {
    renumber(foot.Vertex);
  }
  std::sort(this->Result.begin(), this->Result.end(),
    [](const SegmentFoot& a, const SegmentFoot& b)
    { return std::tie(a.Place, a.Along) < std::tie(b.Place, b.Along); });
}

} // namespace

SpacingAtEnds::SpacingAtEnds(const DomainOptions& options, const std::vector<Point2>& vertices)
  : Options(options)
  , Largest(Box2::Around(vertices).Diagonal())
{
}

double SpacingAtEnds::operator()(const Point2& place) const
{
  return this->Options.GivenSpacing ? std::min(this->Options.GivenSpacing(place), this->Largest)
                                    : 0.0;
}

std::vector<SegmentFoot> JoinOpenEnds(const Polylines& input, const DomainOptions& options,
  WeldedPoints& points, ProblemList& problems, Pulse& pulse)
{
  std::vector<ChainSegment> segments = SegmentsOf(input, points, pulse);
  std::vector<Id> ends = FindOpenEnds(segments, points.Vertices.size());
  return ends.empty()
    ? std::vector<SegmentFoot>()
    : EndJoiner(std::move(segments), options, std::move(ends), points, pulse).Run(problems);
}

} // namespace biting
