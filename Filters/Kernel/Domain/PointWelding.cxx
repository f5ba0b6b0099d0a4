// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PointWelding.h"

#include "../Base/Box.h"
#include "../Base/SortInSteps.h"
#include "../Predicates/Predicates.h" // for LeastCoordinate
#include "VertexGrid.h"

#include <algorithm>  // for max, min, sort
#include <cmath>      // for abs
#include <cstdint>    // for masks
#include <functional> // for less
#include <limits>     // for epsilon
#include <tuple>      // for an order
#include <utility>    // for pair, move

namespace biting
{

namespace
{

/// What keeps its place where points are too near to each other: the lesser.
enum class PointUse : std::uint8_t
{
  Boundary,
  Interface,
  End, ///< open, of either
  Embedded,
  None
};

class PointWelder
{
public:
  PointWelder(const Polylines& input, double mergeTolerance, ProblemList& problems, Pulse& pulse)
    : Input(input)
    , Problems(problems)
    , Beats(pulse)
    , MergeTolerance(mergeTolerance)
    , Uses(input.Points.size(), PointUse::None)
    , Degrees(input.Points.size(), 0)
  {
    this->Result.VertexOf.assign(input.Points.size(), NoId);
  }

  WeldedPoints Run()
  {
    this->MakeVertices();
    return std::move(this->Result);
  }

private:
  void FindUses();
  std::vector<Id> UsedPoints() const;
  void FindResolution(const std::vector<Id>& points);
  Point2 StretchTo(double most, double least) const;
  void MakeVertices();
  std::vector<Id> FirstEquals(const std::vector<Id>& points);
  void ShareUse(Id point, Id first);
  void AddDegree(Id point, int added);
  PointUse UseWhereMerged(Id first) const;
  std::vector<Id> Leaders(const std::vector<Id>& firstEquals);
  std::vector<Id> Candidates(const std::vector<Id>& leaders) const;
  void ReportNear(std::vector<Id> merged, const std::vector<Id>& leaders);

  Id Offset(Id chain) const { return this->Input.Offsets[chain]; }
  Id PointAt(Id place) const { return this->Input.Connectivity[place]; }
  PointUse& UseOf(Id point) { return this->Uses[point]; }
  PointUse UseOf(Id point) const { return this->Uses[point]; }

  const Polylines& Input;
  ProblemList& Problems;
  Pulse& Beats;
  const double MergeTolerance;
  WeldedPoints Result;
  double LeastReach = 0.0;           ///< along x and along y
  std::vector<PointUse> Uses;        ///< one a point; of equal ones the first has the least
  std::vector<std::uint8_t> Degrees; ///< segments that end there, two or more as two; as Uses
  std::vector<Id> InOrder;           ///< the first of equal points, by their places
};

PointUse UseBy(ChainKind kind)
{
  switch (kind)
  {
    case ChainKind::Interface:
      return PointUse::Interface;
    case ChainKind::EmbeddedPoint:
      return PointUse::Embedded;
    default:
      return PointUse::Boundary;
  }
}

void PointWelder::FindUses()
{
  for (Id chain = 0; chain < this->Input.NumberOfChains(); ++chain)
  {
    const PointUse use = UseBy(this->Input.Kinds[chain]);
    for (Id place = this->Offset(chain); place < this->Offset(chain + 1); ++place)
    {
      PointUse& known = this->UseOf(this->PointAt(place));
      known = std::min(known, use);
      const bool isAtEnd = place == this->Offset(chain) || place + 1 == this->Offset(chain + 1);
      this->AddDegree(this->PointAt(place), use == PointUse::Embedded ? 0 : isAtEnd ? 1 : 2);
    }
  }
}

/// Ascending, each once.
std::vector<Id> PointWelder::UsedPoints() const
{
  std::vector<Id> points;
  for (std::size_t point = 0; point < this->Uses.size(); ++point)
  {
    if (this->Uses[point] != PointUse::None)
    {
      points.push_back(static_cast<Id>(point));
    }
  }
  return points;
}

void PointWelder::FindResolution(const std::vector<Id>& points)
{
  Box2 box;
  double largest = 0.0;
  for (const Id point : points)
  {
    const Point2 place = PlaceOf(this->Input, point);
    box.Add(place);
    largest = std::max({ largest, std::abs(place.X), std::abs(place.Y) });
  }
  WeldedPoints& result = this->Result;
  result.Rounding = RoundingInUlp * std::numeric_limits<double>::epsilon() * largest;
  const double merged = points.empty() ? 0.0 : this->MergeTolerance * box.Diagonal();
  this->LeastReach = std::max(result.Rounding, merged);
  result.Resolution =
    std::max({ this->LeastReach, this->Input.Rounding.X, this->Input.Rounding.Y });
  result.Stretch = this->StretchTo(result.Resolution, this->LeastReach);
}

/// The half-axes of the ellipse are those of the rounding, or `least`.
Point2 PointWelder::StretchTo(double most, double least) const
{
  const Point2& rounding = this->Input.Rounding;
  return most > 0.0
    ? Point2{ most / std::max(rounding.X, least), most / std::max(rounding.Y, least) }
    : Point2{ 1.0, 1.0 };
}

/// Numbers the points that are vertices by their places, and gives the others their vertex.
void PointWelder::MakeVertices()
{
  this->FindUses();
  const std::vector<Id> points = this->UsedPoints();
  this->FindResolution(points);
  const std::vector<Id> firstEquals = this->FirstEquals(points);
  std::vector<Id> numbers(this->Input.Points.size(), NoId);
  const std::vector<Id> leaders = this->Leaders(firstEquals);
  if (this->Beats.HasStopped())
  {
    return;
  }
  for (const Id point : this->InOrder)
  {
    if (leaders[point] == point)
    {
      numbers[point] = static_cast<Id>(this->Result.Vertices.size());
      this->Result.Vertices.push_back(PlaceOf(this->Input, point));
      this->Result.VertexPoints.push_back(point);
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Id leader = leaders[firstEquals[i]];
    this->Result.VertexOf[points[i]] = numbers[leader];
  }
}

/// For each of `points`, which ascend, the first that lies at the same place; fills InOrder, and
/// learns what all of them are used for.
std::vector<Id> PointWelder::FirstEquals(const std::vector<Id>& points)
{
  std::vector<std::pair<Point2, std::size_t>> places;
  places.reserve(points.size());
  for (const Id point : points)
  {
    places.emplace_back(PlaceOf(this->Input, point), places.size());
  }
  std::vector<Id> firstEquals(points.size());
  const bool isSorted = SortInSteps(places, std::less<>(), this->Beats);
  for (std::size_t i = 0, first = 0; i < places.size() && isSorted; ++i)
  {
    if (i == 0 || places[i].first != places[first].first)
    {
      first = i;
      this->InOrder.push_back(points[places[i].second]);
    }
    firstEquals[places[i].second] = points[places[first].second];
    this->ShareUse(points[places[i].second], points[places[first].second]);
  }
  return firstEquals;
}

void PointWelder::ShareUse(Id point, Id first)
{
  this->UseOf(first) = std::min(this->UseOf(first), this->UseOf(point));
  if (point != first)
  {
    this->AddDegree(first, this->Degrees[point]);
  }
}

void PointWelder::AddDegree(Id point, int added)
{
  std::uint8_t& degree = this->Degrees[point];
  degree = static_cast<std::uint8_t>(std::min(degree + added, 2));
}

/// What it meets stays, and an open end goes there.
PointUse PointWelder::UseWhereMerged(Id first) const
{
  const PointUse use = this->UseOf(first);
  return this->Degrees[first] == 1 ? std::max(use, PointUse::End) : use;
}

/// By point: for the first of equal ones the point that is its vertex; NoId for the others.
std::vector<Id> PointWelder::Leaders(const std::vector<Id>& firstEquals)
{
  std::vector<Id> leaders(this->Input.Points.size(), NoId);
  for (const Id first : firstEquals)
  {
    leaders[first] = first;
  }
  const double reach = std::max(this->Result.Resolution, this->Input.SeamNoise);
  const std::vector<Id> candidates = this->Candidates(leaders);
  std::vector<Point2> places;
  std::vector<Id> chosen;
  std::vector<Id> merged;
  VertexGrid grid(
    places, reach, this->StretchTo(reach, std::max(this->LeastReach, this->Input.SeamNoise)));
  for (std::size_t i = 0; i < candidates.size() && reach > 0.0 && this->Beats.Beat(1); ++i)
  {
    grid.Update();
    const Point2 place = PlaceOf(this->Input, candidates[i]);
    const bool isApart = grid.Find(place) == NoId;
    (isApart ? chosen : merged).push_back(candidates[i]);
    if (isApart)
    {
      places.push_back(place);
    }
  }
  grid.Update();
  for (std::size_t i = 0; i < merged.size() && this->Beats.Beat(1); ++i)
  {
    const Id nearest = grid.Find(PlaceOf(this->Input, merged[i]));
    leaders[merged[i]] = chosen[nearest];
  }
  this->ReportNear(merged, leaders);
  return leaders;
}

/// The points that lead themselves, in the order in which they may become vertices.
std::vector<Id> PointWelder::Candidates(const std::vector<Id>& leaders) const
{
  using Candidate = std::tuple<PointUse, Point2, Id>;
  std::vector<Candidate> candidates;
  for (const Id point : leaders)
  {
    if (point != NoId)
    {
      candidates.emplace_back(this->UseWhereMerged(point), PlaceOf(this->Input, point), point);
    }
  }
  SortInSteps(candidates, std::less<>(), this->Beats);
  std::vector<Id> points;
  points.reserve(candidates.size());
  for (const Candidate& candidate : candidates)
  {
    points.push_back(std::get<Id>(candidate));
  }
  return points;
}

/// In the order of the points.
void PointWelder::ReportNear(std::vector<Id> merged, const std::vector<Id>& leaders)
{
  std::sort(merged.begin(), merged.end());
  for (std::size_t i = 0; i < merged.size() && this->Beats.Beat(1); ++i)
  {
    const Id leader = leaders[merged[i]];
    const Point2 place = PlaceOf(this->Input, merged[i]);
    const bool isKept = this->Problems.Count(ProblemCode::NearPoints) <
      static_cast<std::int64_t>(ProblemList::KeptPerKind);
    this->Problems.Add({ ProblemCode::NearPoints, { merged[i], leader }, place,
      isKept ? Figure(Distance(place, PlaceOf(this->Input, leader))) + " apart" : "" });
  }
}

double FlushTiny(double coordinate)
{
  return std::abs(coordinate) < LeastCoordinate ? 0.0 : coordinate;
}

} // namespace

Point2 PlaceOf(const Polylines& input, Id point)
{
  const Point2& p = input.Points[point];
  return { FlushTiny(p.X), FlushTiny(p.Y) };
}

WeldedPoints WeldPoints(
  const Polylines& input, double mergeTolerance, ProblemList& problems, Pulse& pulse)
{
  return PointWelder(input, mergeTolerance, problems, pulse).Run();
}

} // namespace biting
