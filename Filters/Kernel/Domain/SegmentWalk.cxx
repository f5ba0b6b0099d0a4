// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SegmentWalk.h"

#include "../Base/SortInSteps.h"

#include <algorithm>  // for sort, swap
#include <cstddef>    // for size_t
#include <functional> // for less
#include <utility>    // for pair, move
#include <vector>     // for the arrays

namespace biting
{

namespace
{

/// A segment as seen from one of its ends. At a vertex the step to the last one, by place, comes
/// first.
struct Step
{
  Id Vertex = NoId;
  Id Rank = NoId; ///< of the vertex it leads to
  Id Segment = NoId;

  bool operator<(const Step& other) const
  {
    return this->Vertex != other.Vertex ? this->Vertex < other.Vertex : this->Rank > other.Rank;
  }
};

class SegmentWalk
{
public:
  SegmentWalk(const Domain& domain, Pulse& pulse)
    : Input(domain)
    , Beats(pulse)
  {
  }

  Domain Run();

private:
  void RankVertices();
  void CollectSteps();
  void WalkFrom(Id vertex);
  bool TakeStep(Id& vertex);
  void NumberVertex(Id vertex);
  void AddSegment(Id segment, Id start, Id end);

  const Domain& Input;
  Pulse& Beats;
  std::vector<Id> ByPlace;            ///< vertices
  std::vector<Id> Ranks;              ///< of vertices, by place
  std::vector<std::size_t> Nexts;     ///< of each vertex, the step to try next
  std::vector<Step> Steps;            ///< sorted
  std::vector<std::uint8_t> IsWalked; ///< segments
  std::vector<Id> Numbers;            ///< of vertices; NoId before
  Domain Result;
};

Domain SegmentWalk::Run()
{
  this->RankVertices();
  this->CollectSteps();
  this->IsWalked.assign(this->Input.Starts.size(), 0);
  this->Numbers.assign(this->Input.Vertices.size(), NoId);
  for (std::size_t k = 0; k < this->ByPlace.size() && this->Beats.Beat(); ++k)
  {
    this->WalkFrom(this->ByPlace[k]);
  }
  for (std::size_t k = 0; k < this->ByPlace.size() && this->Beats.Beat(); ++k)
  {
    this->NumberVertex(this->ByPlace[k]);
  }
  this->Result.Bounds = this->Input.Bounds;
  this->Result.Area = this->Input.Area;
  this->Result.Resolution = this->Input.Resolution;
  return std::move(this->Result);
}

void SegmentWalk::RankVertices()
{
  std::vector<std::pair<Point2, Id>> places;
  places.reserve(this->Input.Vertices.size());
  for (const Point2& place : this->Input.Vertices)
  {
    places.emplace_back(place, static_cast<Id>(places.size()));
  }
  SortInSteps(places, std::less<>(), this->Beats);
  this->Ranks.resize(places.size());
  this->ByPlace.reserve(places.size());
  for (const auto& place : places)
  {
    this->Ranks[place.second] = static_cast<Id>(this->ByPlace.size());
    this->ByPlace.push_back(place.second);
  }
}

void SegmentWalk::CollectSteps()
{
  const std::vector<Id>& starts = this->Input.Starts;
  const std::vector<Id>& ends = this->Input.Ends;
  this->Steps.reserve(2 * starts.size());
  for (std::size_t s = 0; s < starts.size(); ++s)
  {
    this->Steps.push_back({ starts[s], this->Ranks[ends[s]], static_cast<Id>(s) });
    this->Steps.push_back({ ends[s], this->Ranks[starts[s]], static_cast<Id>(s) });
  }
  SortInSteps(this->Steps, std::less<>(), this->Beats);
  this->Nexts.assign(this->Input.Vertices.size(), this->Steps.size());
  for (std::size_t step = this->Steps.size(); step-- > 0;)
  {
    this->Nexts[this->Steps[step].Vertex] = step;
  }
}

void SegmentWalk::WalkFrom(Id vertex)
{
  Id place = vertex;
  while (this->TakeStep(place) && this->Beats.Beat())
  {
    Id end = place;
    while (this->TakeStep(end) && this->Beats.Beat())
    {
    }
    place = vertex;
  }
}

/// Walks along the first segment that is left, and moves `vertex` to its other end.
bool SegmentWalk::TakeStep(Id& vertex)
{
  std::size_t& next = this->Nexts[vertex];
  const auto isLeft = [this, &next, vertex]
  { return next < this->Steps.size() && this->Steps[next].Vertex == vertex; };
  while (isLeft() && this->IsWalked[this->Steps[next].Segment])
  {
    ++next;
  }
  if (!isLeft())
  {
    return false;
  }
  const Step& step = this->Steps[next];
  const Id end = this->ByPlace[step.Rank];
  this->NumberVertex(vertex);
  this->NumberVertex(end);
  this->AddSegment(step.Segment, vertex, end);
  vertex = end;
  return true;
}

void SegmentWalk::NumberVertex(Id vertex)
{
  if (this->Numbers[vertex] == NoId)
  {
    this->Numbers[vertex] = this->Result.NumberOfVertices();
    this->Result.Vertices.push_back(this->Input.Vertices[vertex]);
    this->Result.VertexPoints.push_back(this->Input.VertexPoints[vertex]);
    this->Result.IsEmbedded.push_back(this->Input.IsEmbedded[vertex]);
    this->Result.HasPoint.push_back(this->Input.HasPoint[vertex]);
  }
}

void SegmentWalk::AddSegment(Id segment, Id start, Id end)
{
  this->IsWalked[segment] = 1;
  const bool isForward = this->Input.Starts[segment] == start;
  std::uint8_t left =
    isForward ? this->Input.LeftInside[segment] : this->Input.RightInside[segment];
  std::uint8_t right =
    isForward ? this->Input.RightInside[segment] : this->Input.LeftInside[segment];
  if (this->Input.IsBoundary[segment] && !left)
  {
    std::swap(start, end);
    std::swap(left, right);
  }
  this->Result.Starts.push_back(this->Numbers[start]);
  this->Result.Ends.push_back(this->Numbers[end]);
  this->Result.Cells.push_back(this->Input.Cells[segment]);
  this->Result.IsBoundary.push_back(this->Input.IsBoundary[segment]);
  this->Result.LeftInside.push_back(left);
  this->Result.RightInside.push_back(right);
}

} // namespace

void NumberAlongSegments(Domain& domain, Pulse& pulse)
{
  domain = SegmentWalk(domain, pulse).Run();
}

} // namespace biting
