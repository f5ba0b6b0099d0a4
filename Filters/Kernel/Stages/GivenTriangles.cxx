// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GivenTriangles.h"

#include "../Base/BoxTree.h"
#include "../Base/DisjointSets.h"
#include "../Base/Pulse.h"
#include "../Domain/SegmentWalk.h"
#include "../Predicates/Predicates.h"
#include "../Quality/TriangleLinks.h"
#include "PreservedSpacing.h"

#include <algorithm> // for lower_bound, minmax, sort, swap
#include <array>     // for corners
#include <cstdint>   // for flags
#include <utility>   // for move, pair

namespace biting
{

namespace
{

using Ends = std::pair<Id, Id>;

constexpr double DefaultShareOfDiagonal = 0.02; // as where nothing is given

/// Numbers by key; NoId where there is none.
template <typename Key>
class Directory
{
public:
  void Add(const Key& key, Id number) { this->Entries.emplace_back(key, number); }
  void Sort() { std::sort(this->Entries.begin(), this->Entries.end()); }

  Id operator[](const Key& key) const
  {
    const auto found =
      std::lower_bound(this->Entries.begin(), this->Entries.end(), std::make_pair(key, Id(0)));
    return found != this->Entries.end() && found->first == key ? found->second : NoId;
  }

private:
  std::vector<std::pair<Key, Id>> Entries;
};

Directory<Point2> PlacesOf(const Domain& domain)
{
  Directory<Point2> places;
  for (Id vertex = 0; vertex < domain.NumberOfVertices(); ++vertex)
  {
    places.Add(domain.Vertices[vertex], vertex);
  }
  places.Sort();
  return places;
}

Directory<Ends> SegmentsOf(const Domain& domain)
{
  Directory<Ends> segments;
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    segments.Add(std::minmax({ domain.Starts[segment], domain.Ends[segment] }), segment);
  }
  segments.Sort();
  return segments;
}

struct VertexItem
{
  Id Vertex;
  Point2 Place;

  Box2 Box() const { return Box2::Around(this->Place, this->Place); }
  double Least() const { return 0.0; }
};

/// Takes the triangles out of the domain, one after the other.
class TriangleTaker
{
public:
  TriangleTaker(const Polylines& input, const Domain& domain, Pulse& pulse);

  GivenTriangles Take();

  /// What is left.
  Domain Rest() const;

private:
  using Triangle = std::array<Id, 3>;

  bool FindTriangle(Id chain, Triangle& corners) const;
  bool IsFree(const Triangle& corners) const;
  bool IsHollow(const Triangle& corners) const;
  std::vector<std::uint8_t>& SideOf(Id start, Id end, Id& segment);
  bool IsDropped(Id segment) const;

  const Polylines& Input;
  const Domain& Whole;
  Pulse& Beats;
  Directory<Point2> Places;
  Directory<Ends> Segments;
  BoxTree<VertexItem> Vertices;
  std::vector<std::uint8_t> IsFaceCell; // of input cells
  std::vector<std::uint8_t> LeftFree;   // what of the sides of segments is inside, and left
  std::vector<std::uint8_t> RightFree;
  std::vector<Id> LeftRegions; // of the triangles taken there
  std::vector<Id> RightRegions;
};

TriangleTaker::TriangleTaker(const Polylines& input, const Domain& domain, Pulse& pulse)
  : Input(input)
  , Whole(domain)
  , Beats(pulse)
  , Places(PlacesOf(domain))
  , Segments(SegmentsOf(domain))
  , LeftFree(domain.LeftInside)
  , RightFree(domain.RightInside)
  , LeftRegions(domain.Starts.size(), NoId)
  , RightRegions(domain.Starts.size(), NoId)
{
  std::vector<VertexItem> items;
  for (Id vertex = 0; vertex < domain.NumberOfVertices(); ++vertex)
  {
    items.push_back({ vertex, domain.Vertices[vertex] });
  }
  this->Vertices = BoxTree<VertexItem>(items, pulse);
  for (std::size_t chain = 0; chain < input.Kinds.size(); ++chain)
  {
    const auto cell = static_cast<std::size_t>(input.Cells[chain]);
    this->IsFaceCell.resize(std::max(this->IsFaceCell.size(), cell + 1), 0);
    this->IsFaceCell[cell] = input.Kinds[chain] == ChainKind::Face;
  }
}

/// Counterclockwise; false where the chain is no triangle of the domain's segments.
bool TriangleTaker::FindTriangle(Id chain, Triangle& corners) const
{
  const Id first = this->Input.Offsets[chain];
  if (this->Input.Kinds[chain] != ChainKind::Face || this->Input.Offsets[chain + 1] - first != 4)
  {
    return false;
  }
  for (Id k = 0; k < 3; ++k)
  {
    const Id point = this->Input.Connectivity[first + k];
    corners[k] = this->Places[this->Input.Points[point]];
    if (corners[k] == NoId)
    {
      return false;
    }
  }
  const std::vector<Point2>& points = this->Whole.Vertices;
  const int turn = Orient2D(points[corners[0]], points[corners[1]], points[corners[2]]);
  if (turn < 0)
  {
    std::swap(corners[1], corners[2]);
  }
  return turn != 0;
}

/// The flags of the side on the left of the way, of a segment that is told; NoId: there is none.
std::vector<std::uint8_t>& TriangleTaker::SideOf(Id start, Id end, Id& segment)
{
  segment = this->Segments[std::minmax({ start, end })];
  return segment != NoId && this->Whole.Starts[segment] == start ? this->LeftFree : this->RightFree;
}

bool TriangleTaker::IsFree(const Triangle& corners) const
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id start = corners[k];
    const Id segment = this->Segments[std::minmax({ start, corners[(k + 1) % 3] })];
    if (segment == NoId ||
      !(this->Whole.Starts[segment] == start ? this->LeftFree : this->RightFree)[segment])
    {
      return false;
    }
  }
  return this->IsHollow(corners);
}

bool TriangleTaker::IsHollow(const Triangle& corners) const
{
  const Point2& a = this->Whole.Vertices[corners[0]];
  const Point2& b = this->Whole.Vertices[corners[1]];
  const Point2& c = this->Whole.Vertices[corners[2]];
  Box2 box = Box2::Around(a, b);
  box.Add(c);
  return this->Vertices.AllOf(box,
    [&a, &b, &c](const VertexItem& item)
    {
      const Point2& p = item.Place;
      return Orient2D(a, b, p) <= 0 || Orient2D(b, c, p) <= 0 || Orient2D(c, a, p) <= 0;
    });
}

GivenTriangles TriangleTaker::Take()
{
  GivenTriangles given;
  Triangle corners{};
  for (Id chain = 0; chain < this->Input.NumberOfChains() && this->Beats.Beat(32); ++chain)
  {
    if (!this->FindTriangle(chain, corners) || !this->IsFree(corners))
    {
      continue;
    }
    const Id region = this->Input.Regions.empty() ? 0 : this->Input.Regions[chain];
    for (std::size_t k = 0; k < 3; ++k)
    {
      Id segment = NoId;
      std::vector<std::uint8_t>& side = this->SideOf(corners[k], corners[(k + 1) % 3], segment);
      side[segment] = 0;
      (&side == &this->LeftFree ? this->LeftRegions : this->RightRegions)[segment] = region;
    }
    given.Corners.insert(given.Corners.end(), corners.begin(), corners.end());
  }
  if (given.IsEmpty())
  {
    return given;
  }
  given.Whole = this->Whole;
  Domain& whole = given.Whole;
  Id kept = 0;
  for (Id segment = 0; segment < this->Whole.NumberOfSegments(); ++segment)
  {
    if (!this->IsDropped(segment))
    {
      whole.Starts[kept] = whole.Starts[segment];
      whole.Ends[kept] = whole.Ends[segment];
      whole.Cells[kept] = whole.Cells[segment];
      whole.IsBoundary[kept] = whole.IsBoundary[segment];
      whole.LeftInside[kept] = whole.LeftInside[segment];
      whole.RightInside[kept] = whole.RightInside[segment];
      ++kept;
    }
  }
  for (auto* values : { &whole.Starts, &whole.Ends, &whole.Cells })
  {
    values->resize(static_cast<std::size_t>(kept));
  }
  for (auto* values : { &whole.IsBoundary, &whole.LeftInside, &whole.RightInside })
  {
    values->resize(static_cast<std::size_t>(kept));
  }
  return given;
}

/// Whether it is an edge between two triangles that stay, and nothing else.
bool TriangleTaker::IsDropped(Id segment) const
{
  return this->LeftRegions[segment] != NoId &&
    this->LeftRegions[segment] == this->RightRegions[segment] &&
    this->IsFaceCell[this->Whole.Cells[segment]];
}

Domain TriangleTaker::Rest() const
{
  const Domain& whole = this->Whole;
  Domain rest;
  rest.Resolution = whole.Resolution;
  std::vector<Id> numbers(whole.Vertices.size(), NoId);
  const auto numberOf = [&whole, &rest, &numbers](Id vertex)
  {
    if (numbers[vertex] == NoId)
    {
      numbers[vertex] = rest.NumberOfVertices();
      rest.Vertices.push_back(whole.Vertices[vertex]);
      rest.VertexPoints.push_back(whole.VertexPoints[vertex]);
      rest.IsEmbedded.push_back(whole.IsEmbedded[vertex]);
      rest.HasPoint.push_back(whole.HasPoint[vertex]);
      rest.Bounds.Add(whole.Vertices[vertex]);
    }
    return numbers[vertex];
  };
  for (Id segment = 0; segment < whole.NumberOfSegments(); ++segment)
  {
    const bool isLeft = this->LeftFree[segment] != 0;
    const bool isRight = this->RightFree[segment] != 0;
    if (!isLeft && !isRight)
    {
      continue;
    }
    const Id start = numberOf(whole.Starts[segment]);
    const Id end = numberOf(whole.Ends[segment]);
    rest.Starts.push_back(isLeft ? start : end);
    rest.Ends.push_back(isLeft ? end : start);
    rest.Cells.push_back(whole.Cells[segment]);
    rest.IsBoundary.push_back(isLeft != isRight);
    rest.LeftInside.push_back(1);
    rest.RightInside.push_back(isLeft && isRight);
  }
  for (Id vertex = 0; vertex < whole.NumberOfVertices(); ++vertex)
  {
    if (whole.IsEmbedded[vertex])
    {
      numberOf(vertex);
    }
  }
  return rest;
}

double AreaOf(const GivenTriangles& given)
{
  double doubled = 0.0;
  for (std::size_t k = 0; k < given.Corners.size(); k += 3)
  {
    const Point2& a = given.Whole.Vertices[given.Corners[k]];
    doubled += Cross(given.Whole.Vertices[given.Corners[k + 1]] - a,
      given.Whole.Vertices[given.Corners[k + 2]] - a);
  }
  return 0.5 * doubled;
}

/// The segments of the rest at which a triangle was taken.
std::vector<std::uint8_t> FindRim(const GivenTriangles& given, const Domain& rest)
{
  Directory<Ends> edges;
  for (std::size_t k = 0; k < given.Corners.size(); ++k)
  {
    const Id next = given.Corners[k % 3 == 2 ? k - 2 : k + 1];
    edges.Add(std::minmax({ given.Corners[k], next }), static_cast<Id>(k));
  }
  edges.Sort();
  const Directory<Point2> places = PlacesOf(given.Whole);
  std::vector<std::uint8_t> isRim;
  for (Id segment = 0; segment < rest.NumberOfSegments(); ++segment)
  {
    const Ends ends = std::minmax(
      { places[rest.Vertices[rest.Starts[segment]]], places[rest.Vertices[rest.Ends[segment]]] });
    isRim.push_back(edges[ends] != NoId);
  }
  return isRim;
}

/// Puts the arrays of the rest into those of the whole.
class Return
{
public:
  Return(const GivenTriangles& given, const Domain& rest)
    : Given(given)
    , Rest(rest)
  {
    const Directory<Point2> places = PlacesOf(given.Whole);
    const Directory<Ends> segments = SegmentsOf(given.Whole);
    for (const Point2& place : rest.Vertices)
    {
      this->WholeOf.push_back(places[place]);
    }
    for (Id segment = 0; segment < rest.NumberOfSegments(); ++segment)
    {
      this->SegmentOf.push_back(segments[std::minmax(
        { this->WholeOf[rest.Starts[segment]], this->WholeOf[rest.Ends[segment]] })]);
    }
  }

  void PutVertices(BitingResult& bites) const;
  void PutEdges(BitingResult& bites, Directory<Ends>& constraints) const;
  void PutTriangles(const Directory<Ends>& constraints, Triangulation& mesh) const;

private:
  void TellLengths(std::vector<double>& spacings) const;
  Id NumberOf(Id vertex) const
  {
    const Id first = this->Rest.NumberOfVertices();
    return vertex < first ? this->WholeOf[vertex]
                          : vertex - first + this->Given.Whole.NumberOfVertices();
  }

  const GivenTriangles& Given;
  const Domain& Rest;
  std::vector<Id> WholeOf;   // vertices
  std::vector<Id> SegmentOf; // the same of segments
};

void Return::PutVertices(BitingResult& bites) const
{
  const Domain& whole = this->Given.Whole;
  BitingResult all;
  all.Points = whole.Vertices;
  all.Spacings.assign(whole.Vertices.size(), 0.0);
  all.BiteOrders.assign(whole.Vertices.size(), NoId);
  all.Segments.assign(whole.Vertices.size(), NoId);
  for (Id vertex = 0; vertex < static_cast<Id>(bites.Points.size()); ++vertex)
  {
    const Id number = this->NumberOf(vertex);
    if (number < whole.NumberOfVertices())
    {
      all.Spacings[number] = bites.Spacings[vertex];
      all.BiteOrders[number] = bites.BiteOrders[vertex];
      continue;
    }
    const Id segment = bites.Segments[vertex];
    all.Points.push_back(bites.Points[vertex]);
    all.Spacings.push_back(bites.Spacings[vertex]);
    all.BiteOrders.push_back(bites.BiteOrders[vertex]);
    all.Segments.push_back(segment == NoId ? NoId : this->SegmentOf[segment]);
  }
  this->TellLengths(all.Spacings);
  bites.Points.swap(all.Points);
  bites.Spacings.swap(all.Spacings);
  bites.BiteOrders.swap(all.BiteOrders);
  bites.Segments.swap(all.Segments);
}

/// Of vertices that only triangles have, whose spacing is zero: the mean length of their edges.
void Return::TellLengths(std::vector<double>& spacings) const
{
  const std::vector<Id>& corners = this->Given.Corners;
  const std::vector<Point2>& points = this->Given.Whole.Vertices;
  std::vector<double> sums(points.size(), 0.0);
  std::vector<double> counts(points.size(), 0.0);
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    const Id next = corners[k % 3 == 2 ? k - 2 : k + 1];
    for (const Id vertex : { corners[k], next })
    {
      sums[vertex] += Distance(points[corners[k]], points[next]);
      counts[vertex] += 1.0;
    }
  }
  for (std::size_t vertex = 0; vertex < points.size(); ++vertex)
  {
    if (spacings[vertex] == 0.0 && counts[vertex] > 0.0)
    {
      spacings[vertex] = sums[vertex] / counts[vertex];
    }
  }
}

/// Segments that the rest does not have are edges as they are.
void Return::PutEdges(BitingResult& bites, Directory<Ends>& constraints) const
{
  const Domain& whole = this->Given.Whole;
  std::vector<std::uint8_t> isThere(whole.Starts.size(), 0);
  for (std::size_t edge = 0; edge < bites.EdgeSegments.size(); ++edge)
  {
    bites.EdgeStarts[edge] = this->NumberOf(bites.EdgeStarts[edge]);
    bites.EdgeEnds[edge] = this->NumberOf(bites.EdgeEnds[edge]);
    bites.EdgeSegments[edge] = this->SegmentOf[bites.EdgeSegments[edge]];
    isThere[bites.EdgeSegments[edge]] = 1;
  }
  for (Id segment = 0; segment < whole.NumberOfSegments(); ++segment)
  {
    if (!isThere[segment])
    {
      bites.EdgeStarts.push_back(whole.Starts[segment]);
      bites.EdgeEnds.push_back(whole.Ends[segment]);
      bites.EdgeSegments.push_back(segment);
    }
  }
  for (std::size_t edge = 0; edge < bites.EdgeSegments.size(); ++edge)
  {
    constraints.Add(
      std::minmax({ bites.EdgeStarts[edge], bites.EdgeEnds[edge] }), static_cast<Id>(edge));
  }
  constraints.Sort();
}

void Return::PutTriangles(const Directory<Ends>& constraints, Triangulation& mesh) const
{
  for (Id& corner : mesh.Corners)
  {
    corner = this->NumberOf(corner);
  }
  const std::vector<Id>& corners = this->Given.Corners;
  mesh.Corners.insert(mesh.Corners.end(), corners.begin(), corners.end());
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    const std::size_t first = k - k % 3;
    mesh.Constraints.push_back(
      constraints[std::minmax({ corners[first + (k + 1) % 3], corners[first + (k + 2) % 3] })]);
  }
}

/// Between constraints, numbered by their first segments, on the left of these first.
void NumberRegions(const BitingResult& bites, Triangulation& mesh)
{
  const std::size_t count = mesh.Corners.size() / 3;
  DisjointSets faces(count);
  std::vector<std::array<Id, 3>> border; // segment, side, triangle
  for (std::size_t k = 0; k < mesh.Corners.size(); ++k)
  {
    const Id triangle = static_cast<Id>(k / 3);
    const Id constraint = mesh.Constraints[k];
    if (constraint == NoId)
    {
      faces.Unite(triangle, mesh.Neighbors[k]);
      continue;
    }
    const std::size_t first = k - k % 3;
    const Point2& start = bites.Points[mesh.Corners[first + (k + 1) % 3]];
    const Point2& end = bites.Points[mesh.Corners[first + (k + 2) % 3]];
    const Point2 way =
      bites.Points[bites.EdgeEnds[constraint]] - bites.Points[bites.EdgeStarts[constraint]];
    border.push_back(
      { bites.EdgeSegments[constraint], Dot(end - start, way) > 0.0 ? 0 : 1, triangle });
  }
  std::sort(border.begin(), border.end());
  std::vector<Id> numbers(count, NoId); // of the sets
  Id regions = 0;
  for (const auto& [segment, side, triangle] : border)
  {
    Id& number = numbers[faces.SetOf(triangle)];
    number = number == NoId ? regions++ : number;
  }
  mesh.Regions.clear();
  for (Id triangle = 0; triangle < static_cast<Id>(count); ++triangle)
  {
    mesh.Regions.push_back(numbers[faces.SetOf(triangle)]);
  }
}

} // namespace

GivenTriangles TakeGivenTriangles(const Polylines& input, Domain& domain, Monitor& monitor)
{
  Pulse pulse(monitor);
  TriangleTaker taker(input, domain, pulse);
  GivenTriangles given = taker.Take();
  if (!given.IsEmpty() && !pulse.HasStopped())
  {
    Domain rest = taker.Rest();
    rest.Area = domain.Area - AreaOf(given);
    NumberAlongSegments(rest, pulse);
    rest.IsPreserved = FindRim(given, rest);
    domain = std::move(rest);
  }
  return given;
}

SpacingOptions FollowPreserved(SpacingOptions spacing, const Domain& rest, Monitor& monitor)
{
  Domain rim;
  for (Id segment = 0; segment < rest.NumberOfSegments(); ++segment)
  {
    if (rest.MustPreserve(segment))
    {
      const Id vertex = rim.NumberOfVertices();
      rim.Starts.push_back(vertex);
      rim.Ends.push_back(vertex + 1);
      rim.Vertices.push_back(rest.Vertices[rest.Starts[segment]]);
      rim.Vertices.push_back(rest.Vertices[rest.Ends[segment]]);
    }
  }
  rim.IsEmbedded.assign(rim.Vertices.size(), 0);
  if (spacing.Uniform == 0.0 && !spacing.Grid && !spacing.Triangulation && !spacing.Segments)
  {
    spacing.Uniform = DefaultShareOfDiagonal * rest.Bounds.Diagonal();
  }
  return rim.Starts.empty() ? spacing : FollowSegments(std::move(spacing), rim, monitor);
}

void PutBackTriangles(
  const GivenTriangles& given, const Domain& rest, BitingResult& bites, Triangulation& mesh)
{
  const Return back(given, rest);
  Directory<Ends> constraints;
  back.PutVertices(bites);
  back.PutEdges(bites, constraints);
  back.PutTriangles(constraints, mesh);
  mesh.Neighbors = LinkTriangles(mesh.Corners, static_cast<Id>(bites.Points.size())).Neighbors;
  NumberRegions(bites, mesh);
}

} // namespace biting
