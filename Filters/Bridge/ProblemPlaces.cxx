// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "ProblemPlaces.h"

#include "MessagesFromProblems.h"

#include <algorithm> // for all_of
#include <cmath>     // for isfinite

namespace biting
{

namespace
{

bool IsFinite(const Point3& place)
{
  return std::all_of(place.begin(), place.end(), [](double value) { return std::isfinite(value); });
}

// For each point that is not finite, a finite one beside it in a chain; NoId where there is none.
class Neighbors
{
public:
  explicit Neighbors(const PlanarInput& input)
    : Input(input)
    , Beside(input.IsUsed.size(), NoId)
  {
    const Polylines& chains = input.Chains;
    for (Id chain = 0; chain < chains.NumberOfChains(); ++chain)
    {
      const Id first = chains.Offsets[static_cast<std::size_t>(chain)];
      const Id last = chains.Offsets[static_cast<std::size_t>(chain) + 1] - 1;
      this->Walk(first, last, 1);
      this->Walk(last, first, -1);
    }
  }

  Id operator[](std::int64_t point) const { return this->Beside[static_cast<std::size_t>(point)]; }

private:
  void Walk(Id from, Id to, Id step)
  {
    Id finite = NoId;
    for (Id k = from; k != to + step; k += step)
    {
      const Id point = this->Input.Chains.Connectivity[static_cast<std::size_t>(k)];
      const double* place = this->Input.Place(point);
      if (IsFinite({ place[0], place[1], place[2] }))
      {
        finite = point;
      }
      else if (this->Beside[static_cast<std::size_t>(point)] == NoId)
      {
        this->Beside[static_cast<std::size_t>(point)] = finite;
      }
    }
  }

  const PlanarInput& Input;
  std::vector<Id> Beside;
};

void SetKindAndIds(const Problem& problem, ProblemPlace& place)
{
  place.Kind = problem.Code;
  const std::vector<std::int64_t> ids = ShownIdsOf(problem);
  place.FirstId = ids.empty() ? -1 : ids[0];
  place.SecondId = ids.size() < 2 ? -1 : ids[1];
}

ProblemPlace PlaceFrom(const Problem& problem, const PlanarInput& input)
{
  ProblemPlace place;
  SetKindAndIds(problem, place);
  place.Place = PlaceInSpace(problem, input);
  place.Message = MessageOfPlace(problem, input);
  return place;
}

void MoveToNeighbors(const PlanarInput& input, std::size_t first, std::vector<ProblemPlace>& places)
{
  const Neighbors neighbors(input);
  for (std::size_t k = first; k < places.size(); ++k)
  {
    const Id neighbor = neighbors[places[k].FirstId];
    if (neighbor != NoId)
    {
      const double* place = input.Place(neighbor);
      places[k].Place = { place[0], place[1], place[2] };
    }
  }
}

void AddGroup(const ProblemGroup& group, const PlanarInput& input, bool isError,
  std::vector<ProblemPlace>& places)
{
  const std::size_t first = places.size();
  for (const Problem& problem : group.First)
  {
    if (!problem.Ids.empty())
    {
      places.push_back(PlaceFrom(problem, input));
      places.back().IsError = isError;
    }
  }
  if (group.Code == ProblemCode::NotFinite)
  {
    MoveToNeighbors(input, first, places);
  }
  const auto end = std::remove_if(places.begin() + static_cast<std::ptrdiff_t>(first), places.end(),
    [](const ProblemPlace& place) { return !IsFinite(place.Place); });
  places.erase(end, places.end());
}

} // namespace

void AddPlaces(
  const ProblemList& problems, const PlanarInput& input, RepairPolicy policy, ProblemPlaces& places)
{
  const bool isLeft = policy == RepairPolicy::Left && problems.Has(ProblemCode::NotResolved);
  for (const ProblemGroup& group : problems.Groups())
  {
    // What was left is there already, kind by kind.
    const bool isSaid = isLeft && group.Code == ProblemCode::NotResolved;
    if (group.Code != ProblemCode::Aborted && !isSaid)
    {
      AddGroup(group, input, isLeft || IsError(group.Code), places.Places);
      places.Counts[static_cast<std::size_t>(group.Code)] += group.Count;
    }
  }
}

void AddPlacesInSpace(const ProblemList& problems, ProblemPlaces& places)
{
  for (const ProblemGroup& group : problems.Groups())
  {
    if (group.Code == ProblemCode::Aborted)
    {
      continue;
    }
    for (const Problem& problem : group.First)
    {
      ProblemPlace place;
      SetKindAndIds(problem, place);
      place.IsError = IsError(problem.Code);
      place.Place = problem.Place;
      place.Message = MessageInSpace(problem);
      places.Places.push_back(place);
    }
    places.Counts[static_cast<std::size_t>(group.Code)] += group.Count;
  }
}

} // namespace biting
