// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshOracle.h"

#include "EvenOddArea.h"
#include "ExactSigns.h"

#include <algorithm> // for sort, binary_search
#include <array>     // for corners
#include <cmath>     // for isfinite
#include <limits>    // for infinity
#include <map>       // for regions
#include <sstream>   // for texts
#include <utility>   // for pair

namespace biting
{

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t MostWindings = 40;
constexpr std::size_t MostForBruteForce = 150;
constexpr double QualityRounding = 1e-9;
constexpr double LeastDirection = 4.0;    // in slacks, by which directions are told apart
constexpr double LeastSlack = 1.0 / 16.0; // of all of it: a point on a line is rounded by that

/// A directed edge of a triangle, opposite the corner at `Slot`.
struct HalfEdge
{
  Id Start;
  Id End;
  std::size_t Slot;

  std::pair<Id, Id> Ends() const { return { this->Start, this->End }; }
};

bool operator<(const HalfEdge& a, const HalfEdge& b)
{
  return a.Ends() < b.Ends();
}

std::size_t Next(std::size_t slot)
{
  return slot % 3 == 2 ? slot - 2 : slot + 1;
}

std::size_t At(Id id)
{
  return static_cast<std::size_t>(id);
}

bool IsBetween(double value, double low, double high)
{
  return value >= low && value <= high;
}

/// The parameter of the place on the segment nearest to p.
double ParameterOf(const Point2& p, const Point2& start, const Point2& end)
{
  const Point2 direction = end - start;
  const double longest = std::max(std::abs(direction.X), std::abs(direction.Y));
  const Point2 unit = 1.0 / longest * direction;
  const double t = Dot(1.0 / longest * (p - start), unit) / Dot(unit, unit);
  return std::min(std::max(t, 0.0), 1.0);
}

double DistanceTo(const Point2& p, const Point2& start, const Point2& end)
{
  const Point2 nearest = start + ParameterOf(p, start, end) * (end - start);
  return std::hypot(p.X - nearest.X, p.Y - nearest.Y);
}

std::string PlaceText(const Point2& p)
{
  std::ostringstream text;
  text.precision(17);
  text << "(" << p.X << ", " << p.Y << ")";
  return text.str();
}

bool AreCollinear(const DrawnSegment& a, const DrawnSegment& b)
{
  return ExactOrientation(a.Start, a.End, b.Start) == 0 &&
    ExactOrientation(a.Start, a.End, b.End) == 0;
}

class MeshOracle
{
public:
  MeshOracle(const BitingMesh& mesh, const Polylines& input, const BitingMeshOptions& options)
    : Mesh(mesh)
    , Input(input)
    , Options(options)
    , Drawn(ReadDrawing(input))
    , Slack(this->Drawn.Slack())
  {
  }

  std::string Find();

private:
  enum class Answer
  {
    No,
    Unknown,
    Yes
  };

  bool HasSizes();
  bool HasBiteSizes();
  bool HasIds();
  bool HasPlaces();
  bool HasPointsOnce();
  bool UsesAllPoints();
  bool IsCounterclockwise();
  bool IsManifold();
  bool IsNeighbor(const HalfEdge& half);
  bool HasCoveringEdges();
  bool IsCovering(const HalfEdge& half) const;
  bool CoversOnce();
  int WindingAbout(const Point2& p) const;
  bool HasRegions();
  bool HasArea();
  bool KeepsPoints();
  bool IsOfPoint(const DrawnSegment& segment) const;
  bool KeepsPoint(const Point2& p, const char* what);
  bool IsAtBoundary(const Point2& p) const;
  bool IsAtVertex(const Point2& p) const;
  bool Covers(const Point2& p) const;
  bool CoversSegments();
  bool CoversSegment(const DrawnSegment& segment);
  bool CoversGap(const DrawnSegment& segment, double from, double to);
  Answer DividesFaces(const Point2& p, const Point2& q, double slack) const;
  bool SurelyDividesFaces(const Point2& p, const Point2& q) const;
  bool MayDivideFaces(const Point2& p, const Point2& q) const;
  bool HasLine(const Point2& p, const Point2& q) const;
  bool CoversSafely(const Point2& p) const;
  bool LiesOnInput();
  bool LiesOnCell(const Point2& p, Id cell) const;
  bool HasKinds();
  bool HasKind(std::size_t vertex, bool isOnEdge);
  bool PreservesBoundary();
  bool IsDelaunay();
  bool HasQuality();
  bool HasQualityOfTriangles();
  bool HasDistances();
  bool HasBites();
  bool HasBiteOrders();
  bool IsCentreOf(std::size_t vertex, Id order) const;

  bool Refuse(const std::string& violation);
  bool IsRelaxed() const
  {
    return this->Options.Relaxation && this->Options.MaximumNumberOfBites < 0;
  }
  bool Require(bool holds, const char* promise) { return holds || this->Refuse(promise); }
  const Point2& Place(Id vertex) const { return this->Mesh.Points[At(vertex)]; }
  const Point2& Corner(std::size_t slot) const { return this->Place(this->Mesh.Corners[slot]); }
  const HalfEdge* FindHalf(Id start, Id end) const;
  std::string EdgeText(Id start, Id end) const;

  const BitingMesh& Mesh;
  const Polylines& Input;
  const BitingMeshOptions& Options;
  Drawing Drawn;
  double Slack;
  std::vector<HalfEdge> Halves;            ///< sorted
  std::vector<std::pair<Id, Id>> Covering; ///< smaller id first; sorted
  std::vector<std::size_t> BoundarySlots;
  std::vector<Point2> SortedPoints;
  std::string Violation;
};

std::string MeshOracle::Find()
{
  (void)(this->HasSizes() && this->HasBiteSizes() && this->HasIds() && this->HasPlaces() &&
    this->HasPointsOnce() && this->UsesAllPoints() && this->IsCounterclockwise() &&
    this->IsManifold() && this->HasCoveringEdges() && this->CoversOnce() && this->HasRegions() &&
    this->HasArea() && this->KeepsPoints() && this->CoversSegments() && this->LiesOnInput() &&
    this->HasKinds() && this->PreservesBoundary() && this->IsDelaunay() && this->HasQuality() &&
    this->HasDistances() && this->HasBites() && this->HasBiteOrders());
  return this->Violation;
}

bool MeshOracle::HasSizes()
{
  const std::size_t points = this->Mesh.Points.size();
  const std::size_t corners = this->Mesh.Corners.size();
  const std::size_t edges = this->Mesh.EdgeStarts.size();
  const MeshQuality& quality = this->Mesh.Quality;
  return this->Require(corners > 0 && corners % 3 == 0, "the mesh has triangles") &&
    this->Require(this->Mesh.Spacing.size() == points && this->Mesh.BiteOrders.size() == points &&
        this->Mesh.Kinds.size() == points && this->Mesh.OriginalPoints.size() == points &&
        quality.NearestNeighborDistance.size() == points && quality.Conformity.size() == points,
      "arrays of vertices have one size") &&
    this->Require(this->Mesh.Neighbors.size() == corners &&
        this->Mesh.Regions.size() == corners / 3 && quality.MinimumAngle.size() == corners / 3 &&
        quality.RadiusEdgeRatio.size() == corners / 3 && quality.AspectRatio.size() == corners / 3,
      "arrays of triangles have one size") &&
    this->Require(this->Mesh.EdgeEnds.size() == edges && this->Mesh.EdgeCells.size() == edges &&
        this->Mesh.EdgeIsBoundary.size() == edges,
      "arrays of edges have one size");
}

bool MeshOracle::HasBiteSizes()
{
  const Bites& bites = this->Mesh.Bites;
  const std::size_t count = bites.HalfWidths.size();
  return this->Require(bites.Centers.size() == count && bites.Axes.size() == count &&
      bites.Orders.size() == count && bites.Phases.size() == count &&
      this->Mesh.Front.size() % 2 == 0,
    "arrays of bites have one size");
}

bool MeshOracle::HasIds()
{
  const auto areWithin = [](const std::vector<Id>& ids, Id low, std::size_t end)
  {
    return std::all_of(
      ids.begin(), ids.end(), [low, end](Id id) { return id >= low && id < static_cast<Id>(end); });
  };
  const auto isCell = [this](Id cell)
  {
    return std::find(this->Input.Cells.begin(), this->Input.Cells.end(), cell) !=
      this->Input.Cells.end();
  };
  const std::size_t points = this->Mesh.Points.size();
  const std::size_t triangles = this->Mesh.Corners.size() / 3;
  return this->Require(areWithin(this->Mesh.Corners, 0, points), "corners are vertices") &&
    this->Require(areWithin(this->Mesh.Neighbors, NoId, triangles), "neighbors are triangles") &&
    this->Require(areWithin(this->Mesh.Regions, 0, triangles), "regions are numbered") &&
    this->Require(
      areWithin(this->Mesh.EdgeStarts, 0, points) && areWithin(this->Mesh.EdgeEnds, 0, points),
      "ends of edges are vertices") &&
    this->Require(areWithin(this->Mesh.OriginalPoints, NoId, this->Input.Points.size()),
      "original points are points of the input") &&
    this->Require(std::all_of(this->Mesh.EdgeCells.begin(), this->Mesh.EdgeCells.end(), isCell),
      "cells of edges are cells of the input");
}

bool MeshOracle::HasPlaces()
{
  for (std::size_t vertex = 0; vertex < this->Mesh.Points.size(); ++vertex)
  {
    const Point2& p = this->Mesh.Points[vertex];
    const double f = this->Mesh.Spacing[vertex];
    if (!std::isfinite(p.X) || !std::isfinite(p.Y) || !std::isfinite(f) || !(f > 0.0))
    {
      return this->Refuse("places and spacing are finite");
    }
  }
  return true;
}

bool MeshOracle::HasPointsOnce()
{
  this->SortedPoints = this->Mesh.Points;
  std::sort(this->SortedPoints.begin(), this->SortedPoints.end());
  const auto twice = std::adjacent_find(this->SortedPoints.begin(), this->SortedPoints.end());
  return this->Require(twice == this->SortedPoints.end(), "no point is there twice");
}

bool MeshOracle::UsesAllPoints()
{
  std::vector<char> isUsed(this->Mesh.Points.size(), 0);
  for (const Id corner : this->Mesh.Corners)
  {
    isUsed[At(corner)] = 1;
  }
  return this->Require(
    std::find(isUsed.begin(), isUsed.end(), 0) == isUsed.end(), "every point has a triangle");
}

bool MeshOracle::IsCounterclockwise()
{
  for (std::size_t slot = 0; slot < this->Mesh.Corners.size(); slot += 3)
  {
    if (ExactOrientation(this->Corner(slot), this->Corner(slot + 1), this->Corner(slot + 2)) <= 0)
    {
      return this->Refuse("triangle " + std::to_string(slot / 3) + " is not counterclockwise");
    }
  }
  return true;
}

bool MeshOracle::IsManifold()
{
  for (std::size_t slot = 0; slot < this->Mesh.Corners.size(); ++slot)
  {
    const std::size_t start = Next(slot);
    this->Halves.push_back({ this->Mesh.Corners[start], this->Mesh.Corners[Next(start)], slot });
  }
  std::sort(this->Halves.begin(), this->Halves.end());
  const auto twice = std::adjacent_find(this->Halves.begin(), this->Halves.end(),
    [](const HalfEdge& a, const HalfEdge& b) { return a.Ends() == b.Ends(); });
  return this->Require(twice == this->Halves.end(), "an edge has one triangle on each side") &&
    std::all_of(this->Halves.begin(), this->Halves.end(),
      [this](const HalfEdge& half) { return this->IsNeighbor(half); });
}

bool MeshOracle::IsNeighbor(const HalfEdge& half)
{
  const HalfEdge* twin = this->FindHalf(half.End, half.Start);
  const Id across = twin ? static_cast<Id>(twin->Slot / 3) : NoId;
  if (!twin)
  {
    this->BoundarySlots.push_back(half.Slot);
  }
  return this->Require(this->Mesh.Neighbors[half.Slot] == across, "neighbors share the edge");
}

bool MeshOracle::HasCoveringEdges()
{
  std::size_t boundaries = 0;
  for (std::size_t edge = 0; edge < this->Mesh.EdgeStarts.size(); ++edge)
  {
    const Id start = this->Mesh.EdgeStarts[edge];
    const Id end = this->Mesh.EdgeEnds[edge];
    const int sides = (this->FindHalf(start, end) ? 1 : 0) + (this->FindHalf(end, start) ? 1 : 0);
    const bool isBoundary = this->Mesh.EdgeIsBoundary[edge] != 0;
    if (sides != (isBoundary ? 1 : 2))
    {
      return this->Refuse(this->EdgeText(start, end) + " covers " +
        (isBoundary ? "boundary" : "an interface") + " and has " + std::to_string(sides) +
        " triangles");
    }
    boundaries += isBoundary ? 1 : 0;
    this->Covering.push_back(std::minmax(start, end));
  }
  std::sort(this->Covering.begin(), this->Covering.end());
  const auto twice = std::adjacent_find(this->Covering.begin(), this->Covering.end());
  return this->Require(twice == this->Covering.end(), "each covering edge is there once") &&
    this->Require(boundaries == this->BoundarySlots.size(), "all of the boundary is covered");
}

bool MeshOracle::IsCovering(const HalfEdge& half) const
{
  const std::pair<Id, Id> ends = std::minmax(half.Start, half.End);
  return std::binary_search(this->Covering.begin(), this->Covering.end(), ends);
}

/// Where the centre of a triangle is not within it, the triangle is too thin to ask.
bool MeshOracle::CoversOnce()
{
  const std::size_t triangles = this->Mesh.Corners.size() / 3;
  const std::size_t step = triangles / MostWindings + 1;
  for (std::size_t slot = 0; slot < 3 * triangles; slot += 3 * step)
  {
    const Point2& a = this->Corner(slot);
    const Point2& b = this->Corner(slot + 1);
    const Point2& c = this->Corner(slot + 2);
    const Point2 center = a + 1.0 / 3.0 * ((b - a) + (c - a));
    const bool isWithin = ExactOrientation(a, b, center) > 0 &&
      ExactOrientation(b, c, center) > 0 && ExactOrientation(c, a, center) > 0;
    if (isWithin && this->WindingAbout(center) != 1)
    {
      return this->Refuse("the boundary winds " + std::to_string(this->WindingAbout(center)) +
        " times about triangle " + std::to_string(slot / 3));
    }
  }
  return true;
}

int MeshOracle::WindingAbout(const Point2& p) const
{
  int winding = 0;
  for (const std::size_t slot : this->BoundarySlots)
  {
    const Point2& start = this->Corner(Next(slot));
    const Point2& end = this->Corner(Next(Next(slot)));
    if ((start.Y <= p.Y) != (end.Y <= p.Y))
    {
      const int side = ExactOrientation(start, end, p);
      winding += start.Y <= p.Y ? (side > 0 ? 1 : 0) : (side < 0 ? -1 : 0);
    }
  }
  return winding;
}

/// Spreads from one triangle of each region over edges that cover nothing.
bool MeshOracle::HasRegions()
{
  std::vector<char> isReached(this->Mesh.Regions.size(), 0);
  std::vector<char> isKnown(this->Mesh.Regions.size(), 0);
  for (std::size_t first = 0; first < isReached.size(); ++first)
  {
    const Id region = this->Mesh.Regions[first];
    std::vector<std::size_t> open;
    if (!isReached[first])
    {
      if (!this->Require(!isKnown[At(region)], "a region is connected"))
      {
        return false;
      }
      isKnown[At(region)] = 1;
      isReached[first] = 1;
      open.push_back(first);
    }
    while (!open.empty())
    {
      const std::size_t triangle = open.back();
      open.pop_back();
      for (std::size_t slot = 3 * triangle; slot < 3 * triangle + 3; ++slot)
      {
        const Id across = this->Mesh.Neighbors[slot];
        const std::size_t start = Next(slot);
        const HalfEdge half{ this->Mesh.Corners[start], this->Mesh.Corners[Next(start)], slot };
        if (across == NoId || this->IsCovering(half))
        {
          continue;
        }
        if (!this->Require(this->Mesh.Regions[At(across)] == region, "regions end at edges"))
        {
          return false;
        }
        if (!isReached[At(across)])
        {
          isReached[At(across)] = 1;
          open.push_back(At(across));
        }
      }
    }
  }
  return true;
}

/// That of the triangles is that of the boundary: each edge within is there twice, in both
/// directions.
bool MeshOracle::HasArea()
{
  if (!this->Drawn.IsExplicit)
  {
    return true;
  }
  std::vector<std::pair<Point2, Point2>> boundary;
  for (const std::size_t slot : this->BoundarySlots)
  {
    boundary.emplace_back(this->Corner(Next(slot)), this->Corner(Next(Next(slot))));
  }
  const Rational area = EnclosedArea(boundary);
  const EvenOddArea expected = MeasureEvenOddArea(this->Drawn);
  std::ostringstream text;
  text.precision(17);
  text << "the area is " << area.convert_to<double>() << " instead of "
       << expected.Area.convert_to<double>() << " +- " << expected.Tolerance;
  return abs(area - expected.Area) <= expected.Tolerance || this->Refuse(text.str());
}

bool MeshOracle::KeepsPoints()
{
  for (const DrawnSegment& segment : this->Drawn.Segments)
  {
    const bool mayGo = segment.Face != NoId && !this->Options.Domain.KeepCellEdges;
    if (!mayGo && !this->IsOfPoint(segment) &&
      (!this->KeepsPoint(segment.Start, "an end of a segment") ||
        !this->KeepsPoint(segment.End, "an end of a segment")))
    {
      return false;
    }
  }
  return std::all_of(this->Drawn.Points.begin(), this->Drawn.Points.end(),
    [this](const Point2& p) { return this->KeepsPoint(p, "an embedded point"); });
}

/// Whether all of the chain lies within rounding of the segment: as one of length zero, it draws
/// nothing.
bool MeshOracle::IsOfPoint(const DrawnSegment& segment) const
{
  return std::all_of(this->Drawn.Segments.begin(), this->Drawn.Segments.end(),
    [this, &segment](const DrawnSegment& other)
    {
      return other.Chain != segment.Chain ||
        (Distance(segment.Start, other.Start) <= this->Slack &&
          Distance(segment.Start, other.End) <= this->Slack);
    });
}

bool MeshOracle::KeepsPoint(const Point2& p, const char* what)
{
  if (std::binary_search(this->SortedPoints.begin(), this->SortedPoints.end(), p) ||
    !this->Covers(p) || this->IsAtBoundary(p) || this->IsAtVertex(p))
  {
    return true;
  }
  return this->Refuse(what + (" is no vertex: " + PlaceText(p)));
}

/// Nearer to the boundary than rounding, p may as well be outside.
bool MeshOracle::IsAtBoundary(const Point2& p) const
{
  return std::any_of(this->BoundarySlots.begin(), this->BoundarySlots.end(),
    [this, &p](std::size_t slot) {
      return DistanceTo(p, this->Corner(Next(slot)), this->Corner(Next(Next(slot)))) <= this->Slack;
    });
}

/// Nearer to a vertex than rounding, p may be that.
bool MeshOracle::IsAtVertex(const Point2& p) const
{
  return std::any_of(this->SortedPoints.begin(), this->SortedPoints.end(),
    [this, &p](const Point2& vertex) { return Distance(p, vertex) <= this->Slack; });
}

/// Whether p lies in a triangle, exactly; its border included.
bool MeshOracle::Covers(const Point2& p) const
{
  for (std::size_t slot = 0; slot < this->Mesh.Corners.size(); slot += 3)
  {
    const Point2& a = this->Corner(slot);
    const Point2& b = this->Corner(slot + 1);
    const Point2& c = this->Corner(slot + 2);
    Box2 box;
    box.Add(a);
    box.Add(b);
    box.Add(c);
    if (box.Contains(p) && ExactOrientation(a, b, p) >= 0 && ExactOrientation(b, c, p) >= 0 &&
      ExactOrientation(c, a, p) >= 0)
    {
      return true;
    }
  }
  return false;
}

bool MeshOracle::CoversSegments()
{
  return std::all_of(this->Drawn.Segments.begin(), this->Drawn.Segments.end(),
    [this](const DrawnSegment& segment) { return this->CoversSegment(segment); });
}

/// Along the segment, what no covering edge near it covers must lie outside.
bool MeshOracle::CoversSegment(const DrawnSegment& segment)
{
  Box2 box;
  box.Add(segment.Start);
  box.Add(segment.End);
  box.Grow(this->Slack);
  std::vector<std::pair<double, double>> covered{ { 1.0, 1.0 } };
  for (const auto& ends : this->Covering)
  {
    const Point2& a = this->Place(ends.first);
    const Point2& b = this->Place(ends.second);
    if (box.Contains(a) && box.Contains(b) &&
      DistanceTo(a, segment.Start, segment.End) <= this->Slack &&
      DistanceTo(b, segment.Start, segment.End) <= this->Slack)
    {
      covered.push_back(std::minmax({ ParameterOf(a, segment.Start, segment.End),
        ParameterOf(b, segment.Start, segment.End) }));
    }
  }
  std::sort(covered.begin(), covered.end());
  double done = 0.0;
  for (const auto& part : covered)
  {
    if (part.first > done && this->CoversGap(segment, done, part.first))
    {
      const Point2 along = segment.End - segment.Start;
      return this->Refuse("a segment of cell " + std::to_string(segment.Cell) +
        " is not covered between " + PlaceText(segment.Start + done * along) + " and " +
        PlaceText(segment.Start + part.first * along));
    }
    done = std::max(done, part.second);
  }
  return true;
}

/// Whether the mesh covers the segment between two parameters, as far as samples tell.
bool MeshOracle::CoversGap(const DrawnSegment& segment, double from, double to)
{
  const Point2 direction = segment.End - segment.Start;
  const double slack = this->Slack / std::hypot(direction.X, direction.Y);
  if (to - from <= 2.0 * slack)
  {
    return false;
  }
  for (const double share : { 0.5, 0.21, 0.79, 0.05, 0.95 })
  {
    const double t = from + share * (to - from);
    const double beyond = t + std::max(1e-3 * (to - from), LeastDirection * slack);
    const Point2 p = segment.Start + t * direction;
    const bool isWanted = segment.Face == NoId ||
      (beyond < to && this->SurelyDividesFaces(p, segment.Start + beyond * direction));
    if (isWanted && this->CoversSafely(p))
    {
      return true;
    }
  }
  return false;
}

/// Whether the edges of faces from p towards q are more than one between neighbors, of all edges
/// that are no further away than `slack`. A face that runs there and back has no area there, unless
/// it is a thin spike. Where three faces or more meet they overlap: there it is not known of which
/// region the mesh is.
MeshOracle::Answer MeshOracle::DividesFaces(const Point2& p, const Point2& q, double slack) const
{
  std::map<Id, const DrawnSegment*> faces; // that run there an odd number of times, and one segment
  bool isEdge = false;
  bool hasSpike = false;
  for (const DrawnSegment& segment : this->Drawn.Segments)
  {
    if (segment.Face != NoId && DistanceTo(p, segment.Start, segment.End) <= slack &&
      DistanceTo(q, segment.Start, segment.End) <= slack)
    {
      isEdge = true;
      const auto known = faces.emplace(segment.Face, &segment);
      if (!known.second)
      {
        hasSpike = hasSpike || !AreCollinear(segment, *known.first->second);
        faces.erase(known.first);
      }
    }
  }
  const bool isKept = isEdge && this->Options.Domain.KeepCellEdges;
  const bool areTwo = faces.size() == 2;
  const bool differ = areTwo && faces.begin()->second->Region != faces.rbegin()->second->Region;
  return faces.size() % 2 != 0 || isKept || differ ? Answer::Yes
    : !hasSpike && (faces.empty() || areTwo)       ? Answer::No
                                                   : Answer::Unknown;
}

/// Where faces are thinner than rounding, or have corners, it is not known which edges are one.
bool MeshOracle::SurelyDividesFaces(const Point2& p, const Point2& q) const
{
  const auto isNear = [this, &p, &q](const Point2& end)
  { return DistanceTo(end, p, q) <= this->Slack; };
  const bool hasCorner = std::any_of(this->Drawn.Segments.begin(), this->Drawn.Segments.end(),
    [isNear](const DrawnSegment& segment)
    { return segment.Face != NoId && (isNear(segment.Start) || isNear(segment.End)); });
  return !hasCorner && this->DividesFaces(p, q, this->Slack) == Answer::Yes &&
    this->DividesFaces(p, q, LeastSlack * this->Slack) == Answer::Yes;
}

bool MeshOracle::MayDivideFaces(const Point2& p, const Point2& q) const
{
  return this->DividesFaces(p, q, this->Slack) != Answer::No ||
    this->DividesFaces(p, q, LeastSlack * this->Slack) != Answer::No;
}

/// Whether a line runs from p towards q.
bool MeshOracle::HasLine(const Point2& p, const Point2& q) const
{
  return std::any_of(this->Drawn.Segments.begin(), this->Drawn.Segments.end(),
    [this, &p, &q](const DrawnSegment& segment)
    {
      return segment.Face == NoId && DistanceTo(p, segment.Start, segment.End) <= this->Slack &&
        DistanceTo(q, segment.Start, segment.End) <= this->Slack;
    });
}

/// Whether p lies in the mesh and further than slack from what is covered.
bool MeshOracle::CoversSafely(const Point2& p) const
{
  return this->Covers(p) &&
    std::none_of(this->Covering.begin(), this->Covering.end(),
      [this, &p](const auto& ends)
      { return DistanceTo(p, this->Place(ends.first), this->Place(ends.second)) <= this->Slack; });
}

bool MeshOracle::LiesOnInput()
{
  for (std::size_t edge = 0; edge < this->Mesh.EdgeStarts.size(); ++edge)
  {
    const Point2& start = this->Place(this->Mesh.EdgeStarts[edge]);
    const Point2& end = this->Place(this->Mesh.EdgeEnds[edge]);
    const Id cell = this->Mesh.EdgeCells[edge];
    if (!this->LiesOnCell(start, cell) || !this->LiesOnCell(end, cell) ||
      !this->LiesOnCell(Midpoint(start, end), cell))
    {
      return this->Refuse(this->EdgeText(this->Mesh.EdgeStarts[edge], this->Mesh.EdgeEnds[edge]) +
        " is not on its cell " + std::to_string(cell));
    }
    const Point2 middle = Midpoint(start, end);
    if (!this->Mesh.EdgeIsBoundary[edge] && !this->HasLine(start, middle) &&
      !this->MayDivideFaces(start, middle) && !this->MayDivideFaces(middle, end))
    {
      return this->Refuse(this->EdgeText(this->Mesh.EdgeStarts[edge], this->Mesh.EdgeEnds[edge]) +
        " lies between neighbors");
    }
  }
  return true;
}

bool MeshOracle::LiesOnCell(const Point2& p, Id cell) const
{
  return std::any_of(this->Drawn.Segments.begin(), this->Drawn.Segments.end(),
    [this, &p, cell](const DrawnSegment& segment)
    { return segment.Cell == cell && DistanceTo(p, segment.Start, segment.End) <= this->Slack; });
}

bool MeshOracle::HasKinds()
{
  std::vector<char> isOnEdge(this->Mesh.Points.size(), 0);
  for (const auto& ends : this->Covering)
  {
    isOnEdge[At(ends.first)] = 1;
    isOnEdge[At(ends.second)] = 1;
  }
  for (std::size_t vertex = 0; vertex < isOnEdge.size(); ++vertex)
  {
    if (!this->HasKind(vertex, isOnEdge[vertex] != 0))
    {
      return this->Refuse("vertex " + std::to_string(vertex) + " is not of kind " +
        std::to_string(static_cast<int>(this->Mesh.Kinds[vertex])));
    }
  }
  return true;
}

bool MeshOracle::HasKind(std::size_t vertex, bool isOnEdge)
{
  const Id original = this->Mesh.OriginalPoints[vertex];
  const VertexKind kind = this->Mesh.Kinds[vertex];
  const bool isOld = kind == VertexKind::Input || kind == VertexKind::Embedded;
  const Point2 p = original == NoId ? Point2{} : this->Input.Points[At(original)];
  const bool isTiny = std::abs(p.X) < 1e-70 || std::abs(p.Y) < 1e-70;
  return isOld == (original != NoId) && (!isOld || isTiny || p == this->Mesh.Points[vertex]) &&
    isOnEdge == (kind == VertexKind::Input || kind == VertexKind::Boundary);
}

/// With that option, new vertices on segments are where two of these meet.
bool MeshOracle::PreservesBoundary()
{
  for (std::size_t vertex = 0; vertex < this->Mesh.Points.size(); ++vertex)
  {
    if (this->Options.PreserveBoundary && this->Mesh.Kinds[vertex] == VertexKind::Boundary)
    {
      const Point2& p = this->Mesh.Points[vertex];
      const auto segments = std::count_if(this->Drawn.Segments.begin(), this->Drawn.Segments.end(),
        [this, &p](const DrawnSegment& segment)
        { return DistanceTo(p, segment.Start, segment.End) <= this->Slack; });
      if (segments < 2)
      {
        return this->Refuse("vertex " + std::to_string(vertex) + " was added on a segment");
      }
    }
  }
  return true;
}

bool MeshOracle::IsDelaunay()
{
  for (const HalfEdge& half : this->Halves)
  {
    const HalfEdge* twin = this->FindHalf(half.End, half.Start);
    const bool isExpected = this->Options.Phi == 1.0 || this->IsRelaxed();
    if (isExpected && twin && half.Start < half.End && !this->IsCovering(half))
    {
      const std::size_t first = half.Slot / 3 * 3;
      if (ExactInCircle(this->Corner(first), this->Corner(first + 1), this->Corner(first + 2),
            this->Corner(twin->Slot)) > 0)
      {
        return this->Refuse(this->EdgeText(half.Start, half.End) + " is not Delaunay");
      }
    }
  }
  return true;
}

bool MeshOracle::HasQuality()
{
  const MeshQuality& quality = this->Mesh.Quality;
  const auto isShare = [](double share) { return IsBetween(share, 0.0, 1.0); };
  const std::vector<double>& conformity = quality.Conformity;
  return this->Require(std::all_of(conformity.begin(), conformity.end(), isShare) &&
             isShare(quality.SmallestConformity) && isShare(quality.MeanConformity) &&
             isShare(quality.ShareOfEdgesInBand),
           "shares are within 0 and 1") &&
    this->Require(quality.NumberOfVertices == static_cast<std::int64_t>(this->Mesh.Points.size()) &&
        quality.NumberOfTriangles == static_cast<std::int64_t>(this->Mesh.Corners.size() / 3),
      "the mesh is counted") &&
    this->Require(std::isfinite(quality.MeanRelativeLength), "the mean length is finite") &&
    this->Require(std::isfinite(this->Mesh.UsedLipschitz) && this->Mesh.UsedLipschitz >= 0.0,
      "the used Lipschitz constant is finite") &&
    this->Require(std::isfinite(this->Mesh.GivenLipschitz) && this->Mesh.GivenLipschitz >= 0.0,
      "the given Lipschitz constant is finite") &&
    this->HasQualityOfTriangles();
}

bool MeshOracle::HasQualityOfTriangles()
{
  const MeshQuality& quality = this->Mesh.Quality;
  const double leastRatio = std::sqrt(1.0 / 3.0) - QualityRounding;
  double smallest = Infinity;
  for (std::size_t triangle = 0; triangle < quality.MinimumAngle.size(); ++triangle)
  {
    smallest = std::min(smallest, quality.MinimumAngle[triangle]);
    if (!IsBetween(quality.MinimumAngle[triangle], 0.0, 60.0 + QualityRounding) ||
      !(quality.RadiusEdgeRatio[triangle] >= leastRatio) ||
      !(quality.AspectRatio[triangle] >= 2.0 - QualityRounding))
    {
      return this->Refuse("quality of triangle " + std::to_string(triangle) + " is within range");
    }
  }
  return this->Require(smallest == quality.SmallestAngle, "the smallest angle is the smallest");
}

bool MeshOracle::HasDistances()
{
  const std::size_t count = this->Mesh.Points.size();
  for (std::size_t k = 0; k < count && count <= MostForBruteForce; ++k)
  {
    double nearest = Infinity;
    for (std::size_t other = 0; other < count; ++other)
    {
      const Point2 gap = this->Mesh.Points[other] - this->Mesh.Points[k];
      nearest = other == k ? nearest : std::min(nearest, std::hypot(gap.X, gap.Y));
    }
    const double told = this->Mesh.Quality.NearestNeighborDistance[k];
    if (!(std::abs(told - nearest) <= 1e-12 * nearest))
    {
      return this->Refuse("the nearest neighbor of " + std::to_string(k) + " is nearest");
    }
  }
  return true;
}

bool MeshOracle::HasBites()
{
  const Bites& bites = this->Mesh.Bites;
  const std::int64_t most = this->Options.MaximumNumberOfBites;
  if (!this->Options.KeepBites)
  {
    return this->Require(bites.Size() == 0 && this->Mesh.Front.empty(), "bites were not wanted");
  }
  bool areValid = true;
  for (std::size_t bite = 0; bite < bites.HalfWidths.size(); ++bite)
  {
    const double axis = std::hypot(bites.Axes[bite].X, bites.Axes[bite].Y);
    const bool isCircle = axis == 0.0 && this->Options.BiteShape == BiteShape::Circle;
    areValid = areValid && std::isfinite(bites.HalfWidths[bite]) && bites.HalfWidths[bite] > 0.0 &&
      (isCircle || std::abs(axis - 1.0) <= QualityRounding) && bites.Orders[bite] >= 0 &&
      (most < 0 || bites.Orders[bite] < most);
  }
  return this->Require(areValid, "bites have a size, an axis and a number") &&
    this->Require(std::is_sorted(bites.Orders.begin(), bites.Orders.end()), "bites are in order") &&
    this->Require(most >= 0 || this->Mesh.Front.empty(), "no front is left");
}

/// A relaxed mesh has vertices without a bite, and others are not where they were bitten.
bool MeshOracle::HasBiteOrders()
{
  const std::int64_t most = this->Options.MaximumNumberOfBites;
  const Id least = most < 0 && !this->IsRelaxed() ? 0 : NoId;
  std::vector<Id> orders;
  for (std::size_t vertex = 0; vertex < this->Mesh.Points.size(); ++vertex)
  {
    const Id order = this->Mesh.BiteOrders[vertex];
    if (order < least || (most >= 0 && order >= most) || !this->IsCentreOf(vertex, order))
    {
      return this->Refuse(
        "vertex " + std::to_string(vertex) + " has no bite " + std::to_string(order));
    }
    if (order != NoId)
    {
      orders.push_back(order);
    }
  }
  std::sort(orders.begin(), orders.end());
  return this->Require(
    std::adjacent_find(orders.begin(), orders.end()) == orders.end(), "a bite makes one vertex");
}

/// True also where bites were not kept, or the vertex has none.
bool MeshOracle::IsCentreOf(std::size_t vertex, Id order) const
{
  const Bites& bites = this->Mesh.Bites;
  if (order == NoId || !this->Options.KeepBites)
  {
    return true;
  }
  const auto bite = std::lower_bound(bites.Orders.begin(), bites.Orders.end(), order);
  const bool mayHaveMoved = this->IsRelaxed() && this->Mesh.OriginalPoints[vertex] == NoId;
  return bite != bites.Orders.end() && *bite == order &&
    (mayHaveMoved ||
      bites.Centers[static_cast<std::size_t>(bite - bites.Orders.begin())] ==
        this->Mesh.Points[vertex]);
}

bool MeshOracle::Refuse(const std::string& violation)
{
  this->Violation = violation;
  return false;
}

const HalfEdge* MeshOracle::FindHalf(Id start, Id end) const
{
  const HalfEdge wanted{ start, end, 0 };
  const auto found = std::lower_bound(this->Halves.begin(), this->Halves.end(), wanted);
  return found != this->Halves.end() && found->Ends() == wanted.Ends() ? &*found : nullptr;
}

std::string MeshOracle::EdgeText(Id start, Id end) const
{
  return "edge " + PlaceText(this->Place(start)) + " - " + PlaceText(this->Place(end));
}

} // namespace

std::string FindMeshViolation(
  const BitingMesh& mesh, const Polylines& input, const BitingMeshOptions& options)
{
  return MeshOracle(mesh, input, options).Find();
}

} // namespace biting
