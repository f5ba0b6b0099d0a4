// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Welding.h"

#include "../Base/SortInSteps.h"
#include "../Predicates/Predicates.h" // for LeastCoordinate
#include "AreaSum.h"

#include <algorithm>  // for find, max
#include <cmath>      // for abs
#include <cstdint>    // for masks
#include <functional> // for less
#include <limits>     // for epsilon
#include <utility>    // for pair, move

namespace biting
{

namespace
{

/// Rounding of the coordinates, in ulp of the largest, below which nothing is told apart.
constexpr double ResolutionInUlp = 4.0;

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
    , PointVertices(input.Points.size(), NoId)
  {
  }

  Arrangement Run();

private:
  std::vector<Id> UsedPoints() const;
  void MakeVertices();
  std::vector<Id> FirstEquals(const std::vector<Id>& points) const;
  void AppendChain(Id chain);
  ArrangementEdge EdgeOf(Id chain) const;
  void AppendFace(Id chain);
  void AppendEdges(Id chain, const ArrangementEdge& prototype);
  void AppendEmbeddedPoints(Id chain);
  void MergeEmbeddedPoints();
  void ReportEqualPoints(Id cell, Id first, Id second);
  bool IsClosed(Id chain) const;

  Id Offset(Id chain) const { return this->Input.Offsets[static_cast<std::size_t>(chain)]; }
  Id PointAt(Id place) const { return this->Input.Connectivity[static_cast<std::size_t>(place)]; }
  Id VertexOf(Id point) const { return this->PointVertices[static_cast<std::size_t>(point)]; }
  Point2 Place(Id point) const;

  const Polylines& Input;
  ProblemList& Problems;
  Pulse& Beats;
  const bool KeepsCellEdges;
  const bool HasFaces;
  Arrangement Result;
  std::vector<Id> PointVertices;                 ///< NoId: no chain uses the point
  std::vector<std::pair<Id, Id>> EmbeddedPoints; ///< vertex, point
};

Arrangement Welder::Run()
{
  this->MakeVertices();
  this->Result.Edges.reserve(this->Input.Connectivity.size());
  this->Result.Groups = FaceGroups(this->HasFaces ? this->Input.NumberOfChains() : 0);
  for (Id chain = 0; chain < this->Input.NumberOfChains() && this->Beats.Beat(); ++chain)
  {
    this->AppendChain(chain);
  }
  this->MergeEmbeddedPoints();
  return std::move(this->Result);
}

/// Ascending, each once.
std::vector<Id> Welder::UsedPoints() const
{
  std::vector<std::uint8_t> isUsed(this->Input.Points.size(), 0);
  for (const Id point : this->Input.Connectivity)
  {
    isUsed[static_cast<std::size_t>(point)] = 1;
  }
  std::vector<Id> points;
  for (std::size_t point = 0; point < isUsed.size(); ++point)
  {
    if (isUsed[point])
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

/// Numbers the first points of equal place by point id, and gives the others their vertex.
void Welder::MakeVertices()
{
  const std::vector<Id> points = this->UsedPoints();
  const std::vector<Id> firstEquals = this->FirstEquals(points);
  if (this->Beats.HasStopped())
  {
    return;
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Id point = points[i];
    Id vertex = this->VertexOf(firstEquals[i]);
    if (firstEquals[i] == point)
    {
      vertex = static_cast<Id>(this->Result.Vertices.size());
      this->Result.Vertices.push_back(this->Place(point));
      this->Result.VertexPoints.push_back(point);
    }
    this->PointVertices[static_cast<std::size_t>(point)] = vertex;
    const Point2 place = this->Place(point);
    largest = std::max({ largest, std::abs(place.X), std::abs(place.Y) });
  }
  this->Result.Resolution = ResolutionInUlp * std::numeric_limits<double>::epsilon() * largest;
}

/// For each of `points`, which ascend, the first that lies at the same place.
std::vector<Id> Welder::FirstEquals(const std::vector<Id>& points) const
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
    first = places[i].first == places[first].first ? first : i;
    firstEquals[places[i].second] = points[places[first].second];
  }
  return firstEquals;
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

/// Any orientation will do for what encloses nothing: its edges cancel.
void Welder::AppendFace(Id chain)
{
  const Id first = this->Offset(chain);
  const Id end = this->Offset(chain + 1);
  if (first == end)
  {
    return;
  }
  AreaSum sum(this->Place(this->PointAt(first)));
  for (Id place = first + 1; place < end; ++place)
  {
    sum.Add(this->Place(this->PointAt(place - 1)), this->Place(this->PointAt(place)));
  }
  const std::vector<Id>& regions = this->Input.Regions;
  ArrangementEdge edge;
  edge.Cell = this->Input.Cells[static_cast<std::size_t>(chain)];
  edge.Faces.Count = 1;
  edge.Faces.Turn = sum.Area() < 0.0 ? -1 : 1;
  edge.Faces.First = chain;
  edge.Faces.Region = regions.empty() ? 0 : regions[static_cast<std::size_t>(chain)];
  edge.Faces.Stays = this->KeepsCellEdges;
  this->Result.FaceArea += std::abs(sum.Area());
  this->AppendEdges(chain, edge);
}

bool Welder::IsClosed(Id chain) const
{
  const Id first = this->Offset(chain);
  const Id last = this->Offset(chain + 1) - 1;
  return first <= last &&
    this->VertexOf(this->PointAt(first)) == this->VertexOf(this->PointAt(last));
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
    edge.Ends = { this->VertexOf(first), this->VertexOf(second) };
    if (edge.Ends.Start != edge.Ends.End)
    {
      this->Result.Edges.push_back(edge);
    }
    else if (edge.Faces.Count == 0)
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
    if (!merged.empty() && merged.back() == vertex)
    {
      this->Problems.Add(
        { ProblemCode::DuplicatePoints, { first, point }, this->Place(point), {} });
      continue;
    }
    merged.push_back(vertex);
    first = point;
  }
}

} // namespace

Arrangement WeldPolylines(
  const Polylines& input, const DomainOptions& options, ProblemList& problems, Pulse& pulse)
{
  return Welder(input, options, problems, pulse).Run();
}

} // namespace biting
