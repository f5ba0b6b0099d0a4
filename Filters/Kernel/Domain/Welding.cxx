// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Welding.h"

#include "../Base/Box2.h"
#include "../Base/SortInSteps.h"
#include "../Predicates/Predicates.h" // for LeastCoordinate
#include "AreaSum.h"
#include "VertexGrid.h"

#include <algorithm>  // for find, max, min, sort
#include <cmath>      // for abs
#include <cstdint>    // for masks
#include <functional> // for less
#include <limits>     // for epsilon
#include <sstream>    // for a distance
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
  Embedded,
  None
};

class Welder
{
public:
  Welder(const Polylines& input, const DomainOptions& options, ProblemList& problems, Pulse& pulse)
    : Input(input)
    , Problems(problems)
    , Beats(pulse)
    , KeepsCellEdges(options.KeepCellEdges)
    , HasFaces(
        std::find(input.Kinds.begin(), input.Kinds.end(), ChainKind::Face) != input.Kinds.end())
    , MergeTolerance(options.MergeTolerance)
    , Uses(input.Points.size(), PointUse::None)
    , PointVertices(input.Points.size(), NoId)
  {
  }

  Arrangement Run();

private:
  void FindUses();
  std::vector<Id> UsedPoints() const;
  void FindResolution(const std::vector<Id>& points);
  void MakeVertices();
  std::vector<Id> FirstEquals(const std::vector<Id>& points);
  void ShareUse(Id point, Id first);
  std::vector<Id> Leaders(const std::vector<Id>& firstEquals);
  std::vector<Id> Candidates(const std::vector<Id>& leaders);
  void ReportNear(std::vector<Id> merged, const std::vector<Id>& leaders);
  void AppendChain(Id chain);
  ArrangementEdge EdgeOf(Id chain) const;
  void AppendFace(Id chain);
  void AppendEdges(Id chain, const ArrangementEdge& prototype);
  void AppendEmbeddedPoints(Id chain);
  void MergeEmbeddedPoints();
  void ReportEqualPoints(Id cell, Id first, Id second);
  bool IsClosed(Id chain) const;
  bool AreEqual(Id first, Id second) const { return this->Place(first) == this->Place(second); }

  Id Offset(Id chain) const { return this->Input.Offsets[static_cast<std::size_t>(chain)]; }
  Id PointAt(Id place) const { return this->Input.Connectivity[static_cast<std::size_t>(place)]; }
  Id VertexOf(Id point) const { return this->PointVertices[static_cast<std::size_t>(point)]; }
  Point2 Place(Id point) const;

  PointUse& UseOf(Id point) { return this->Uses[static_cast<std::size_t>(point)]; }

  const Polylines& Input;
  ProblemList& Problems;
  Pulse& Beats;
  const bool KeepsCellEdges;
  const bool HasFaces;
  const double MergeTolerance;
  Arrangement Result;
  AreaSum FaceArea{ {} };        ///< of all faces
  std::vector<PointUse> Uses;    ///< one a point; of equal ones the first has the least
  std::vector<Id> PointVertices; ///< NoId: no chain uses the point
  std::vector<Id> InOrder;       ///< the first of equal points, by their places
  std::vector<std::pair<Id, Id>> EmbeddedPoints; ///< vertex, point
};

Arrangement Welder::Run()
{
  this->MakeVertices();
  this->Result.Edges.reserve(this->Input.Connectivity.size());
  this->Result.Groups = FaceGroups(this->HasFaces ? this->Input.NumberOfChains() : 0);
  this->Result.Regions = this->Input.Regions;
  for (Id chain = 0; chain < this->Input.NumberOfChains() && this->Beats.Beat(); ++chain)
  {
    this->AppendChain(chain);
  }
  this->MergeEmbeddedPoints();
  this->Result.FaceArea = this->FaceArea.Area();
  return std::move(this->Result);
}

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

void Welder::FindUses()
{
  for (Id chain = 0; chain < this->Input.NumberOfChains(); ++chain)
  {
    const PointUse use = UseBy(this->Input.Kinds[static_cast<std::size_t>(chain)]);
    for (Id place = this->Offset(chain); place < this->Offset(chain + 1); ++place)
    {
      PointUse& known = this->UseOf(this->PointAt(place));
      known = std::min(known, use);
    }
  }
}

/// Ascending, each once.
std::vector<Id> Welder::UsedPoints() const
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

double FlushTiny(double coordinate)
{
  return std::abs(coordinate) < LeastCoordinate ? 0.0 : coordinate;
}

Point2 Welder::Place(Id point) const
{
  const Point2& p = this->Input.Points[static_cast<std::size_t>(point)];
  return { FlushTiny(p.X), FlushTiny(p.Y) };
}

void Welder::FindResolution(const std::vector<Id>& points)
{
  Box2 box;
  double largest = 0.0;
  for (const Id point : points)
  {
    const Point2 place = this->Place(point);
    box.Add(place);
    largest = std::max({ largest, std::abs(place.X), std::abs(place.Y) });
  }
  Arrangement& result = this->Result;
  result.Rounding = RoundingInUlp * std::numeric_limits<double>::epsilon() * largest;
  const double merged = points.empty() ? 0.0 : this->MergeTolerance * box.Diagonal();
  result.Resolution = std::max({ result.Rounding, this->Input.Rounding, merged });
}

/// Numbers the points that are vertices by their places, and gives the others their vertex.
void Welder::MakeVertices()
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
    if (leaders[static_cast<std::size_t>(point)] == point)
    {
      numbers[static_cast<std::size_t>(point)] = static_cast<Id>(this->Result.Vertices.size());
      this->Result.Vertices.push_back(this->Place(point));
      this->Result.VertexPoints.push_back(point);
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Id leader = leaders[static_cast<std::size_t>(firstEquals[i])];
    this->PointVertices[static_cast<std::size_t>(points[i])] =
      numbers[static_cast<std::size_t>(leader)];
  }
}

/// For each of `points`, which ascend, the first that lies at the same place; fills InOrder, and
/// learns what all of them are used for.
std::vector<Id> Welder::FirstEquals(const std::vector<Id>& points)
{
  std::vector<std::pair<Point2, std::size_t>> places;
  places.reserve(points.size());
  for (const Id point : points)
  {
    places.emplace_back(this->Place(point), places.size());
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

void Welder::ShareUse(Id point, Id first)
{
  this->UseOf(first) = std::min(this->UseOf(first), this->UseOf(point));
}

/// By point: for the first of equal ones the point that is its vertex; NoId for the others.
std::vector<Id> Welder::Leaders(const std::vector<Id>& firstEquals)
{
  std::vector<Id> leaders(this->Input.Points.size(), NoId);
  for (const Id first : firstEquals)
  {
    leaders[static_cast<std::size_t>(first)] = first;
  }
  const double reach = this->Result.Resolution;
  const std::vector<Id> candidates = this->Candidates(leaders);
  std::vector<Point2> places;
  std::vector<Id> chosen;
  std::vector<Id> merged;
  VertexGrid grid(places, reach);
  for (std::size_t i = 0; i < candidates.size() && reach > 0.0 && this->Beats.Beat(1); ++i)
  {
    grid.Update();
    const Point2 place = this->Place(candidates[i]);
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
    const Id nearest = grid.Find(this->Place(merged[i]));
    leaders[static_cast<std::size_t>(merged[i])] = chosen[static_cast<std::size_t>(nearest)];
  }
  this->ReportNear(merged, leaders);
  return leaders;
}

/// The points that lead themselves, in the order in which they may become vertices.
std::vector<Id> Welder::Candidates(const std::vector<Id>& leaders)
{
  using Candidate = std::tuple<PointUse, Point2, Id>;
  std::vector<Candidate> candidates;
  for (const Id point : leaders)
  {
    if (point != NoId)
    {
      candidates.emplace_back(this->UseOf(point), this->Place(point), point);
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

std::string Figure(double value)
{
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

/// In the order of the points.
void Welder::ReportNear(std::vector<Id> merged, const std::vector<Id>& leaders)
{
  std::sort(merged.begin(), merged.end());
  for (std::size_t i = 0; i < merged.size() && this->Beats.Beat(1); ++i)
  {
    const Id leader = leaders[static_cast<std::size_t>(merged[i])];
    const Point2 place = this->Place(merged[i]);
    const bool isKept = this->Problems.Count(ProblemCode::NearPoints) <
      static_cast<std::int64_t>(ProblemList::KeptPerKind);
    this->Problems.Add({ ProblemCode::NearPoints, { merged[i], leader }, place,
      isKept ? Figure(Distance(place, this->Place(leader))) + " apart" : "" });
  }
}

void Welder::AppendChain(Id chain)
{
  const ChainKind kind = this->Input.Kinds[static_cast<std::size_t>(chain)];
  if (kind == ChainKind::EmbeddedPoint)
  {
    this->AppendEmbeddedPoints(chain);
    return;
  }
  if (kind == ChainKind::Face)
  {
    this->AppendFace(chain);
    return;
  }
  this->AppendEdges(chain, this->EdgeOf(chain));
}

/// What an edge of the line `chain` counts for.
ArrangementEdge Welder::EdgeOf(Id chain) const
{
  const ChainKind kind = this->Input.Kinds[static_cast<std::size_t>(chain)];
  const bool isAutomatic = kind == ChainKind::Automatic && !this->HasFaces;
  const bool isBoundary = kind == ChainKind::Boundary || (isAutomatic && this->IsClosed(chain));
  ArrangementEdge edge;
  edge.Cell = this->Input.Cells[static_cast<std::size_t>(chain)];
  edge.BoundaryCount = isBoundary ? 1 : 0;
  edge.OpenCount = isAutomatic && !isBoundary ? 1 : 0;
  edge.IsInterface = !isAutomatic && !isBoundary;
  return edge;
}

/// What is thinner than rounding may be turned over when it is welded: it lies on neither side.
void Welder::AppendFace(Id chain)
{
  const Id first = this->Offset(chain);
  const Id end = this->Offset(chain + 1);
  if (first == end)
  {
    return;
  }
  AreaSum sum(this->Place(this->PointAt(first)));
  double length = 0.0;
  for (Id place = first + 1; place < end; ++place)
  {
    const Point2 start = this->Place(this->PointAt(place - 1));
    const Point2 stop = this->Place(this->PointAt(place));
    sum.Add(start, stop);
    length += Distance(start, stop);
  }
  const bool isReversed = sum.Area() < 0.0;
  const bool isThin = std::abs(sum.Area()) <= this->Result.Resolution * length;
  ArrangementEdge edge;
  edge.Cell = this->Input.Cells[static_cast<std::size_t>(chain)];
  edge.Faces.Turn = isThin ? 0 : isReversed ? -1 : 1;
  edge.Faces.AddRun(isReversed ? FaceEdge::OtherSide(chain) : chain);
  edge.Faces.Stays = this->KeepsCellEdges;
  this->FaceArea.AddMagnitude(sum);
  this->AppendEdges(chain, edge);
}

bool Welder::IsClosed(Id chain) const
{
  const Id first = this->Offset(chain);
  const Id last = this->Offset(chain + 1) - 1;
  return first <= last &&
    this->VertexOf(this->PointAt(first)) == this->VertexOf(this->PointAt(last));
}

/// Directs `edge` from the lesser of its ends to the greater.
void SetEnds(Id first, Id second, const FaceEdge& faces, ArrangementEdge& edge)
{
  edge.Ends = { std::min(first, second), std::max(first, second) };
  edge.Faces = FaceEdge();
  edge.Faces.Absorb(faces, first > second);
}

/// That corners of a face coincide is no news: so do those of a quad that is a triangle.
void Welder::AppendEdges(Id chain, const ArrangementEdge& prototype)
{
  ArrangementEdge edge = prototype;
  const Id end = this->Offset(chain + 1);
  for (Id place = this->Offset(chain) + 1; place < end && this->Beats.Beat(1); ++place)
  {
    const Id first = this->PointAt(place - 1);
    const Id second = this->PointAt(place);
    SetEnds(this->VertexOf(first), this->VertexOf(second), prototype.Faces, edge);
    if (edge.Ends.Start != edge.Ends.End)
    {
      this->Result.Edges.push_back(edge);
    }
    else if (edge.Faces.Count == 0 && this->AreEqual(first, second))
    {
      this->ReportEqualPoints(edge.Cell, first, second);
    }
  }
}

void Welder::ReportEqualPoints(Id cell, Id first, Id second)
{
  const bool isRepeated = first == second;
  this->Problems.Add({ isRepeated ? ProblemCode::ZeroLengthSegments : ProblemCode::DuplicatePoints,
    { isRepeated ? cell : first, second }, this->Place(first), {} });
}

void Welder::AppendEmbeddedPoints(Id chain)
{
  const Id end = this->Offset(chain + 1);
  for (Id place = this->Offset(chain); place < end && this->Beats.Beat(1); ++place)
  {
    const Id point = this->PointAt(place);
    this->EmbeddedPoints.emplace_back(this->VertexOf(point), point);
  }
}

void Welder::MergeEmbeddedPoints()
{
  if (!SortInSteps(this->EmbeddedPoints, std::less<>(), this->Beats))
  {
    return;
  }
  Id first = NoId;
  for (const auto& [vertex, point] : this->EmbeddedPoints)
  {
    std::vector<Id>& merged = this->Result.EmbeddedVertices;
    if (merged.empty() || merged.back() != vertex)
    {
      merged.push_back(vertex);
      first = point;
    }
    else if (this->AreEqual(first, point))
    {
      this->Problems.Add(
        { ProblemCode::DuplicatePoints, { first, point }, this->Place(point), {} });
    }
  }
}

} // namespace

Arrangement WeldPolylines(
  const Polylines& input, const DomainOptions& options, ProblemList& problems, Pulse& pulse)
{
  return Welder(input, options, problems, pulse).Run();
}

} // namespace biting
