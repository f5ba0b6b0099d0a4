// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "HeldVertices.h"

#include "StarObjective.h"

#include <algorithm> // for max, sort
#include <cstddef>   // for sizes

namespace biting
{

HeldVertices::HeldVertices(
  const HoldOptions& hold, Id first, const std::vector<Id>& origins, MutableMesh& mesh)
  : Hold(hold)
  , Mesh(mesh)
  , IsHeld(hold.Count > 0 ? mesh.Points.size() : 0, 0)
  , IsLast(this->IsHeld)
{
  for (std::size_t vertex = 0; vertex < this->IsHeld.size(); ++vertex)
  {
    const bool isNamed = origins[vertex] >= first && origins[vertex] < first + hold.Count;
    if (isNamed && mesh.Freedoms[vertex] == Freedom::Free)
    {
      this->IsHeld[vertex] = 1;
      this->IsLast[vertex] = hold.AreLast.empty() ? 0 : hold.AreLast[origins[vertex] - first];
      mesh.Freedoms[vertex] = Freedom::Fixed;
    }
  }
}

std::vector<Id> HeldVertices::ReleaseThoseInTheWay(Pulse& pulse)
{
  if (this->Hold.Count == 0)
  {
    return {};
  }
  this->IsHeld.resize(this->Mesh.Points.size(), 0);
  this->IsLast.resize(this->Mesh.Points.size(), 0);
  this->Counts.assign(this->Mesh.Points.size(), 0);
  this->Complaints.clear();
  pulse.ForEach(this->Mesh.Regions.size(),
    [this](std::size_t triangle)
    {
      if (this->Mesh.IsEdge(4 * static_cast<Id>(triangle)))
      {
        this->LookAt(static_cast<Id>(triangle));
      }
    });
  std::vector<Id> released = this->Choose();
  for (const Id vertex : released)
  {
    this->WereReleased.push_back({ vertex, this->Mesh.Points[vertex] });
    this->IsHeld[vertex] = 0;
    this->Mesh.Freedoms[vertex] = Freedom::Free;
  }
  return released;
}

bool HeldVertices::TakeBack(const Released& released)
{
  return this->IsFree(released.Vertex) &&
    this->HoldAt(released.Vertex, released.Home, this->Hold.GreatestCotangent, true);
}

bool HeldVertices::HoldAtPlaceNear(Id vertex)
{
  if (!this->IsFree(vertex))
  {
    return false;
  }
  const Point2* place = this->Hold.FindPlace(
    this->Mesh.Points[vertex], this->Hold.ReachOfPlaces * this->Mesh.Spacings[vertex]);
  return place && this->HoldAt(vertex, *place, this->Hold.GreatestCotangentAtPlaces, false);
}

bool HeldVertices::HoldAt(Id vertex, const Point2& place, double greatestCotangent, bool orIfBetter)
{
  Star star;
  if (!star.Read(this->Mesh, vertex))
  {
    return false;
  }
  StarObjective objective(this->Mesh, vertex, star);
  objective.FitSlope();
  const double limit =
    orIfBetter ? std::max(objective.Here(), greatestCotangent) : greatestCotangent;
  if (!(objective.At(place - star.Center, limit) < limit) ||
    !this->AreLengthsWithinLimits(vertex, star, place) ||
    !IsValidAt(this->Mesh, vertex, star, place))
  {
    return false;
  }
  MoveWithSpacing(this->Mesh, vertex, star, place);
  this->IsHeld.resize(this->Mesh.Points.size(), 0);
  this->IsHeld[vertex] = 1;
  this->Mesh.Freedoms[vertex] = Freedom::Fixed;
  return true;
}

bool HeldVertices::AreLengthsWithinLimits(Id vertex, const Star& star, const Point2& place) const
{
  for (int k = 0; k < star.NumberOfTriangles; ++k)
  {
    const Id other = star.Vertices[k];
    const Point2 along = this->Mesh.Points[other] - place;
    const double mean = 0.5 * (this->Mesh.Spacings[vertex] + this->Mesh.Spacings[other]);
    if (!this->IsWithinLimits(Dot(along, along) / (mean * mean)))
    {
      return false;
    }
  }
  return true;
}

void HeldVertices::LookAt(Id triangle)
{
  const Id first = 4 * triangle;
  const std::vector<Id>& corners = this->Mesh.Corners;
  if (IsWorseThan(this->Mesh, triangle, this->Hold.GreatestCotangent))
  {
    this->Complain({ corners[first], corners[first + 1], corners[first + 2] });
  }
  for (Id edge = first; edge < first + 3; ++edge)
  {
    if (!this->IsWithinLimits(this->Mesh.SquaredRelativeLength(edge)))
    {
      this->Complain({ this->Mesh.Origin(edge), this->Mesh.Target(edge), NoId });
    }
  }
}

bool HeldVertices::IsWithinLimits(double squaredLength) const
{
  return squaredLength >= this->Hold.ShortestEdge * this->Hold.ShortestEdge &&
    squaredLength <= this->Hold.LongestEdge * this->Hold.LongestEdge;
}

void HeldVertices::Complain(Complaint vertices)
{
  bool hasHeld = false;
  for (Id& vertex : vertices)
  {
    vertex = vertex != NoId && this->IsHeld[vertex] ? vertex : NoId;
    if (vertex != NoId)
    {
      hasHeld = true;
      ++this->Counts[vertex];
    }
  }
  if (hasHeld)
  {
    this->Complaints.push_back(vertices);
  }
}

// Last ones after all others, those with most complaints first. Where one of the vertices of a
// complaint is chosen the others wait: they may be fine once it is gone.
std::vector<Id> HeldVertices::Choose() const
{
  std::vector<Id> chosen;
  std::vector<std::uint8_t> waits(this->IsHeld.size(), 0);
  for (const Candidate& candidate : this->ListCandidates())
  {
    const bool isChosen = !chosen.empty() && chosen.back() == candidate.Vertex;
    if (!isChosen && waits[candidate.Vertex] != 0)
    {
      continue;
    }
    if (!isChosen)
    {
      chosen.push_back(candidate.Vertex);
    }
    for (const Id vertex : this->Complaints[candidate.About])
    {
      if (vertex != NoId)
      {
        waits[vertex] = 1;
      }
    }
  }
  return chosen;
}

std::vector<HeldVertices::Candidate> HeldVertices::ListCandidates() const
{
  std::vector<Candidate> candidates;
  for (std::size_t k = 0; k < this->Complaints.size(); ++k)
  {
    for (const Id vertex : this->Complaints[k])
    {
      if (vertex != NoId)
      {
        candidates.push_back({ this->IsLast[vertex] != 0, this->Counts[vertex], vertex, k });
      }
    }
  }
  std::sort(candidates.begin(), candidates.end(),
    [](const Candidate& a, const Candidate& b)
    {
      return a.IsLast != b.IsLast ? b.IsLast
        : a.Count != b.Count      ? a.Count > b.Count
        : a.Vertex != b.Vertex    ? a.Vertex < b.Vertex
                                  : a.About < b.About;
    });
  return candidates;
}

} // namespace biting
