// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "GivenTriangles.h"

#include "../Base/BoxTree.h"
#include "../Base/Directory.h"
#include "../Base/DisjointSets.h"
#include "../Base/Pulse.h"
#include "../Predicates/Predicates.h"
#include "../Quality/TriangleLinks.h"
#include "PreparedInput.h"

#include <algorithm> // for max, sort, swap
#include <array>     // for corners
#include <cstdint>   // for flags
#include <utility>   // for move

namespace biting
{

namespace
{

using Flags = std::vector<std::uint8_t>;

constexpr double DefaultShareOfDiagonal = 0.02; // as where nothing is given

/// The place before which the edge from corner k of a triangle ends.
std::size_t NextCorner(std::size_t k)
{
  return k % 3 == 2 ? k - 2 : k + 1;
}

Directory<UndirectedEnds> SegmentsOf(const Domain& domain)
{
  Directory<UndirectedEnds> segments;
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    segments.Add(EndsOf(domain.Starts[segment], domain.Ends[segment]), segment);
  }
  segments.Sort();
  return segments;
}

struct VertexItem
{
  Point2 Place;

  Box2 Box() const { return Box2::Around(this->Place, this->Place); }
  double Least() const { return 0.0; }
};

/// Takes the triangles out of the domain, one after the other.
class TriangleTaker
{
public:
  TriangleTaker(const Polylines& input, const Domain& domain, Pulse& pulse);

  /// All but what is told of the rest.
  GivenTriangles Take();

  /// What is left, which `given` is told.
  Domain MakeRest(GivenTriangles& given) const;

private:
  using Triangle = std::array<Id, 3>;

  /// A side of a segment.
  struct Side
  {
    std::uint8_t IsFree = 0; ///< inside, and not taken
    Id Region = NoId;        ///< of the triangle that was taken
  };

  bool FindTriangle(Id chain, Triangle& corners) const;
  bool FindSides(const Triangle& corners, std::array<Side*, 3>& sides);
  bool IsHollow(const Triangle& corners) const;
  bool IsDropped(Id segment) const;
  const Point2& At(Id vertex) const { return this->Whole.Vertices[vertex]; }

  const Polylines& Input;
  const Domain& Whole;
  Pulse& Beats;
  Directory<Point2> Places;
  Directory<UndirectedEnds> Segments;
  BoxTree<VertexItem> Vertices;
  Flags IsFaceCell; ///< of input cells
  std::vector<Side> Lefts;
  std::vector<Side> Rights;
};

TriangleTaker::TriangleTaker(const Polylines& input, const Domain& domain, Pulse& pulse)
  : Input(input)
  , Whole(domain)
  , Beats(pulse)
  , Segments(SegmentsOf(domain))
{
  std::vector<VertexItem> items;
  for (Id vertex = 0; vertex < domain.NumberOfVertices(); ++vertex)
  {
    this->Places.Add(this->At(vertex), vertex);
    items.push_back({ this->At(vertex) });
  }
  this->Places.Sort();
  this->Vertices = BoxTree<VertexItem>(items, pulse);
  for (Id segment = 0; segment < domain.NumberOfSegments(); ++segment)
  {
    this->Lefts.push_back({ domain.LeftInside[segment], NoId });
    this->Rights.push_back({ domain.RightInside[segment], NoId });
  }
  for (std::size_t chain = 0; chain < input.Kinds.size(); ++chain)
  {
    const auto cell = static_cast<std::size_t>(input.Cells[chain]);
    this->IsFaceCell.resize(std::max(this->IsFaceCell.size(), cell + 1), 0);
    this->IsFaceCell[cell] = input.Kinds[chain] == ChainKind::Face;
  }
}

/// Counterclockwise; false where the chain is no triangle of vertices of the domain.
bool TriangleTaker::FindTriangle(Id chain, Triangle& corners) const
{
  const Id first = this->Input.Offsets[chain];
  if (this->Input.Kinds[chain] != ChainKind::Face || this->Input.Offsets[chain + 1] - first != 4)
  {
    return false;
  }
  for (Id k = 0; k < 3; ++k)
  {
    corners[k] = this->Places[this->Input.Points[this->Input.Connectivity[first + k]]];
    if (corners[k] == NoId)
    {
      return false;
    }
  }
  const int turn = Orient2D(this->At(corners[0]), this->At(corners[1]), this->At(corners[2]));
  if (turn < 0)
  {
    std::swap(corners[1], corners[2]);
  }
  return turn != 0;
}

/// The sides of segments within the triangle; false where not all are there and free.
bool TriangleTaker::FindSides(const Triangle& corners, std::array<Side*, 3>& sides)
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Id segment = this->Segments[EndsOf(corners[k], corners[NextCorner(k)])];
    if (segment == NoId)
    {
      return false;
    }
    const bool isForward = this->Whole.Starts[segment] == corners[k];
    sides[k] = &(isForward ? this->Lefts : this->Rights)[segment];
    if (!sides[k]->IsFree)
    {
      return false;
    }
  }
  return true;
}

bool TriangleTaker::IsHollow(const Triangle& corners) const
{
  const Point2& a = this->At(corners[0]);
  const Point2& b = this->At(corners[1]);
  const Point2& c = this->At(corners[2]);
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
  std::array<Side*, 3> sides{};
  for (Id chain = 0; chain < this->Input.NumberOfChains() && this->Beats.Beat(32); ++chain)
  {
    if (this->FindTriangle(chain, corners) && this->FindSides(corners, sides) &&
      this->IsHollow(corners))
    {
      for (Side* side : sides)
      {
        *side = { 0, this->Input.Regions.empty() ? 0 : this->Input.Regions[chain] };
      }
      given.Corners.insert(given.Corners.end(), corners.begin(), corners.end());
    }
  }
  return given;
}

/// Whether it is an edge between two triangles that stay, and nothing else.
bool TriangleTaker::IsDropped(Id segment) const
{
  return this->Lefts[segment].Region != NoId &&
    this->Lefts[segment].Region == this->Rights[segment].Region &&
    this->IsFaceCell[this->Whole.Cells[segment]];
}

void AddSegment(const Domain& from, Id segment, Domain& to)
{
  to.Starts.push_back(from.Starts[segment]);
  to.Ends.push_back(from.Ends[segment]);
  to.Cells.push_back(from.Cells[segment]);
  to.IsBoundary.push_back(from.IsBoundary[segment]);
  to.LeftInside.push_back(from.LeftInside[segment]);
  to.RightInside.push_back(from.RightInside[segment]);
}

Domain WithoutSegments(Domain domain)
{
  domain.Starts.clear();
  domain.Ends.clear();
  domain.Cells.clear();
  domain.IsBoundary.clear();
  domain.LeftInside.clear();
  domain.RightInside.clear();
  return domain;
}

double AreaOf(const std::vector<Id>& corners, const std::vector<Point2>& points)
{
  double doubled = 0.0;
  for (std::size_t k = 0; k < corners.size(); k += 3)
  {
    const Point2& a = points[corners[k]];
    doubled += Cross(points[corners[k + 1]] - a, points[corners[k + 2]] - a);
  }
  return 0.5 * doubled;
}

/// In the order of the whole; boundary with the inside on its left.
Domain TriangleTaker::MakeRest(GivenTriangles& given) const
{
  const Domain& all = this->Whole;
  Domain rest;
  rest.Resolution = all.Resolution;
  rest.Area = all.Area - AreaOf(given.Corners, all.Vertices);
  given.Whole = WithoutSegments(all);
  std::vector<Id> numbers(all.Vertices.size(), NoId);
  const auto keep = [&all, &rest, &given, &numbers](Id vertex)
  {
    if (numbers[vertex] == NoId)
    {
      numbers[vertex] = rest.NumberOfVertices();
      rest.Vertices.push_back(all.Vertices[vertex]);
      rest.VertexPoints.push_back(all.VertexPoints[vertex]);
      rest.IsEmbedded.push_back(all.IsEmbedded[vertex]);
      rest.HasPoint.push_back(all.HasPoint[vertex]);
      rest.Bounds.Add(all.Vertices[vertex]);
      given.Vertices.push_back(vertex);
    }
    return numbers[vertex];
  };
  for (Id segment = 0; segment < all.NumberOfSegments(); ++segment)
  {
    const std::uint8_t isLeft = this->Lefts[segment].IsFree;
    const std::uint8_t isRight = this->Rights[segment].IsFree;
    if (isLeft || isRight)
    {
      const Id start = keep(all.Starts[segment]);
      const Id end = keep(all.Ends[segment]);
      AddSegment(all, segment, rest);
      rest.Starts.back() = isLeft ? start : end;
      rest.Ends.back() = isLeft ? end : start;
      rest.IsBoundary.back() = isLeft != isRight;
      rest.LeftInside.back() = 1;
      rest.RightInside.back() = isLeft && isRight;
      rest.IsPreserved.push_back(
        this->Lefts[segment].Region != NoId || this->Rights[segment].Region != NoId);
      given.Segments.push_back(given.Whole.NumberOfSegments());
    }
    if (!this->IsDropped(segment))
    {
      AddSegment(all, segment, given.Whole);
    }
  }
  for (Id vertex = 0; vertex < all.NumberOfVertices(); ++vertex)
  {
    if (all.IsEmbedded[vertex])
    {
      keep(vertex);
    }
  }
  return rest;
}

/// Of vertices that only triangles have.
void TellLengths(const GivenTriangles& given, std::vector<double>& spacings)
{
  const std::vector<Point2>& points = given.Whole.Vertices;
  std::vector<double> sums(points.size(), 0.0);
  std::vector<double> counts(points.size(), 0.0);
  for (std::size_t k = 0; k < given.Corners.size(); ++k)
  {
    const Id end = given.Corners[NextCorner(k)];
    for (const Id vertex : { given.Corners[k], end })
    {
      sums[vertex] += Distance(points[given.Corners[k]], points[end]);
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

/// The vertices of the whole come first, then those that the mesh of the rest has made. Returns the
/// new number of each vertex.
std::vector<Id> PutVertices(const GivenTriangles& given, BitingResult& bites)
{
  const std::size_t first = given.Whole.Vertices.size();
  BitingResult all;
  all.Points = given.Whole.Vertices;
  all.Spacings.assign(first, 0.0);
  all.BiteOrders.assign(first, NoId);
  all.Segments.assign(first, NoId);
  std::vector<Id> numbers = given.Vertices;
  for (std::size_t vertex = 0; vertex < bites.Points.size(); ++vertex)
  {
    if (vertex < given.Vertices.size())
    {
      all.Spacings[numbers[vertex]] = bites.Spacings[vertex];
      all.BiteOrders[numbers[vertex]] = bites.BiteOrders[vertex];
      continue;
    }
    const Id segment = bites.Segments[vertex];
    numbers.push_back(static_cast<Id>(all.Points.size()));
    all.Points.push_back(bites.Points[vertex]);
    all.Spacings.push_back(bites.Spacings[vertex]);
    all.BiteOrders.push_back(bites.BiteOrders[vertex]);
    all.Segments.push_back(segment == NoId ? NoId : given.Segments[segment]);
  }
  TellLengths(given, all.Spacings);
  bites.Points.swap(all.Points);
  bites.Spacings.swap(all.Spacings);
  bites.BiteOrders.swap(all.BiteOrders);
  bites.Segments.swap(all.Segments);
  return numbers;
}

/// Segments that the rest does not have are edges as they are. Returns an edge of each segment: the
/// only one where a triangle stays at it.
std::vector<Id> PutEdges(
  const GivenTriangles& given, const std::vector<Id>& numbers, BitingResult& bites)
{
  std::vector<Id> edges(given.Whole.Starts.size(), NoId);
  for (std::size_t edge = 0; edge < bites.EdgeSegments.size(); ++edge)
  {
    bites.EdgeStarts[edge] = numbers[bites.EdgeStarts[edge]];
    bites.EdgeEnds[edge] = numbers[bites.EdgeEnds[edge]];
    bites.EdgeSegments[edge] = given.Segments[bites.EdgeSegments[edge]];
    edges[bites.EdgeSegments[edge]] = static_cast<Id>(edge);
  }
  for (Id segment = 0; segment < given.Whole.NumberOfSegments(); ++segment)
  {
    if (edges[segment] == NoId)
    {
      edges[segment] = static_cast<Id>(bites.EdgeSegments.size());
      bites.EdgeStarts.push_back(given.Whole.Starts[segment]);
      bites.EdgeEnds.push_back(given.Whole.Ends[segment]);
      bites.EdgeSegments.push_back(segment);
    }
  }
  return edges;
}

/// Of the faces between constraints, by their first segments, on the left of these first.
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
    const Point2& start = bites.Points[mesh.Corners[NextCorner(k)]];
    const Point2& end = bites.Points[mesh.Corners[NextCorner(NextCorner(k))]];
    const Point2 way =
      bites.Points[bites.EdgeEnds[constraint]] - bites.Points[bites.EdgeStarts[constraint]];
    border.push_back(
      { bites.EdgeSegments[constraint], Dot(end - start, way) > 0.0 ? 0 : 1, triangle });
  }
  std::sort(border.begin(), border.end());
  std::vector<Id> numbers(count, NoId); // of the sets
  Id regions = 0;
  for (const auto& place : border)
  {
    Id& number = numbers[faces.SetOf(place[2])];
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
    domain = taker.MakeRest(given);
  }
  return given;
}

SpacingOptions FollowPreserved(SpacingOptions spacing, const Domain& rest, Monitor& monitor)
{
  Domain rim;
  rim.Vertices = rest.Vertices;
  rim.IsEmbedded.assign(rest.Vertices.size(), 1);
  for (Id segment = 0; segment < rest.NumberOfSegments(); ++segment)
  {
    if (rest.MustPreserve(segment))
    {
      AddSegment(rest, segment, rim);
      rim.IsEmbedded[rest.Starts[segment]] = 0;
      rim.IsEmbedded[rest.Ends[segment]] = 0;
    }
  }
  if (spacing.Uniform == 0.0 && spacing.Sources.empty())
  {
    spacing.Uniform = DefaultShareOfDiagonal * rest.Bounds.Diagonal();
  }
  return rim.Starts.empty() ? spacing : FollowSegments(std::move(spacing), rim, monitor);
}

void PutBackTriangles(const GivenTriangles& given, BitingResult& bites, Triangulation& mesh)
{
  const std::vector<Id> numbers = PutVertices(given, bites);
  const std::vector<Id> edges = PutEdges(given, numbers, bites);
  const Directory<UndirectedEnds> segments = SegmentsOf(given.Whole);
  const std::vector<Id>& corners = given.Corners;
  for (Id& corner : mesh.Corners)
  {
    corner = numbers[corner];
  }
  mesh.Corners.insert(mesh.Corners.end(), corners.begin(), corners.end());
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    const std::size_t next = NextCorner(k);
    const Id segment = segments[EndsOf(corners[next], corners[NextCorner(next)])];
    mesh.Constraints.push_back(segment == NoId ? NoId : edges[segment]);
  }
  mesh.Neighbors = LinkTriangles(mesh.Corners, static_cast<Id>(bites.Points.size())).Neighbors;
  NumberRegions(bites, mesh);
}

} // namespace biting
