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

/// A segment as seen from one of its ends.
struct Step
{
  Id Rank = NoId; ///< of the vertex it leads to
  Id Segment = NoId;

  /// The last vertex goes first.
  bool operator<(const Step& other) const { return this->Rank > other.Rank; }
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
  void SortSteps();
  void WalkFrom(Id vertex);
  bool TakeStep(Id& vertex);
  void NumberVertex(Id vertex);
  void AddSegment(Id segment, Id start, Id end);

  Id RankOf(Id vertex) const { return this->Ranks[static_cast<std::size_t>(vertex)]; }

  const Domain& Input;
  Pulse& Beats;
  std::vector<Id> ByPlace;         ///< vertices
  std::vector<Id> Ranks;           ///< of vertices, by place
  std::vector<std::size_t> Begins; ///< of each vertex's steps, and the end
  std::vector<std::size_t> Nexts;  ///< of each vertex, the step to try next
  std::vector<Step> Steps;
  std::vector<std::uint8_t> IsWalked; ///< segments
  std::vector<Id> Numbers;            ///< of vertices; NoId before
  Domain Result;
};

Domain SegmentWalk::Run()
{
  this->RankVertices();
  this->CollectSteps();
  this->SortSteps();
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
    this->Ranks[static_cast<std::size_t>(place.second)] = static_cast<Id>(this->ByPlace.size());
    this->ByPlace.push_back(place.second);
  }
}

void SegmentWalk::CollectSteps()
{
  this->Begins.assign(this->Input.Vertices.size() + 1, 0);
  const std::vector<Id>& starts = this->Input.Starts;
  const std::vector<Id>& ends = this->Input.Ends;
  for (std::size_t s = 0; s < starts.size(); ++s)
  {
    ++this->Begins[static_cast<std::size_t>(starts[s]) + 1];
    ++this->Begins[static_cast<std::size_t>(ends[s]) + 1];
  }
  for (std::size_t v = 1; v < this->Begins.size(); ++v)
  {
    this->Begins[v] += this->Begins[v - 1];
  }
  this->Steps.resize(this->Begins.back());
  this->Nexts.assign(this->Begins.begin(), this->Begins.end() - 1);
  for (std::size_t s = 0; s < starts.size() && this->Beats.Beat(); ++s)
  {
    const Id segment = static_cast<Id>(s);
    this->Steps[this->Nexts[static_cast<std::size_t>(starts[s])]++] = { this->RankOf(ends[s]),
      segment };
    this->Steps[this->Nexts[static_cast<std::size_t>(ends[s])]++] = { this->RankOf(starts[s]),
      segment };
  }
}

void SegmentWalk::SortSteps()
{
  for (std::size_t v = 0; v + 1 < this->Begins.size() && this->Beats.Beat(); ++v)
  {
    const auto first = this->Steps.begin();
    std::sort(first + static_cast<std::ptrdiff_t>(this->Begins[v]),
      first + static_cast<std::ptrdiff_t>(this->Begins[v + 1]));
    this->Nexts[v] = this->Begins[v];
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
  const auto v = static_cast<std::size_t>(vertex);
  std::size_t& next = this->Nexts[v];
  while (next < this->Begins[v + 1] &&
    this->IsWalked[static_cast<std::size_t>(this->Steps[next].Segment)])
  {
    ++next;
  }
  if (next == this->Begins[v + 1])
  {
    return false;
  }
  const Step& step = this->Steps[next];
  const Id end = this->ByPlace[static_cast<std::size_t>(step.Rank)];
  this->NumberVertex(vertex);
  this->NumberVertex(end);
  this->AddSegment(step.Segment, vertex, end);
  vertex = end;
  return true;
}

void SegmentWalk::NumberVertex(Id vertex)
{
  const auto v = static_cast<std::size_t>(vertex);
  if (this->Numbers[v] == NoId)
  {
    this->Numbers[v] = this->Result.NumberOfVertices();
    this->Result.Vertices.push_back(this->Input.Vertices[v]);
    this->Result.VertexPoints.push_back(this->Input.VertexPoints[v]);
    this->Result.IsEmbedded.push_back(this->Input.IsEmbedded[v]);
    this->Result.HasPoint.push_back(this->Input.HasPoint[v]);
  }
}

void SegmentWalk::AddSegment(Id segment, Id start, Id end)
{
  const auto s = static_cast<std::size_t>(segment);
  this->IsWalked[s] = 1;
  const bool isForward = this->Input.Starts[s] == start;
  std::uint8_t left = isForward ? this->Input.LeftInside[s] : this->Input.RightInside[s];
  std::uint8_t right = isForward ? this->Input.RightInside[s] : this->Input.LeftInside[s];
  if (this->Input.IsBoundary[s] && !left)
  {
    std::swap(start, end);
    std::swap(left, right);
  }
  this->Result.Starts.push_back(this->Numbers[static_cast<std::size_t>(start)]);
  this->Result.Ends.push_back(this->Numbers[static_cast<std::size_t>(end)]);
  this->Result.Cells.push_back(this->Input.Cells[s]);
  this->Result.IsBoundary.push_back(this->Input.IsBoundary[s]);
  this->Result.LeftInside.push_back(left);
  this->Result.RightInside.push_back(right);
}

} // namespace

void NumberAlongSegments(Domain& domain, Pulse& pulse)
{
  domain = SegmentWalk(domain, pulse).Run();
}

} // namespace biting
