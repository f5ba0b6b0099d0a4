// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "DrawingOracle.h"

#include "EvenOddArea.h"
#include "ExactSigns.h"

#include <algorithm> // for sort, binary_search
#include <cmath>     // for abs
#include <limits>    // for infinity
#include <map>       // for faces

namespace biting
{

namespace
{

constexpr double LeastDirection = 4.0;    // in slacks, by which directions are told apart
constexpr double LeastSlack = 1.0 / 16.0; // of all of it: a point on a line is rounded by that

} // namespace

bool DrawingOracle::Holds()
{
  return this->HasArea() && this->KeepsPoints() && this->CoversSegments() && this->LiesOnInput() &&
    this->HasKinds() && this->PreservesBoundary();
}

/// That of the triangles is that of the boundary: each edge within is there twice, in both
/// directions.
bool DrawingOracle::HasArea()
{
  if (!this->Judged.Drawn.IsExplicit)
  {
    return true;
  }
  std::vector<std::pair<Point2, Point2>> boundary;
  for (const std::size_t slot : this->Judged.BoundarySlots)
  {
    boundary.emplace_back(this->Judged.Corner(Next(slot)), this->Judged.Corner(Next(Next(slot))));
  }
  const Rational area = EnclosedArea(boundary);
  const EvenOddArea expected = MeasureEvenOddArea(this->Judged.Drawn);
  std::ostringstream text;
  text.precision(17);
  text << "the area is " << area.convert_to<double>() << " instead of "
       << expected.Area.convert_to<double>() << " +- " << expected.Tolerance;
  return abs(area - expected.Area) <= expected.Tolerance || this->Judged.Refuse(text.str());
}

bool DrawingOracle::KeepsPoints()
{
  for (const DrawnSegment& segment : this->Judged.Drawn.Segments)
  {
    const bool mayGo = segment.Face != NoId && !this->Judged.Options.Domain.KeepCellEdges;
    if (!mayGo && !this->IsOfPoint(segment) &&
      (!this->KeepsPoint(segment.Start, "an end of a segment") ||
        !this->KeepsPoint(segment.End, "an end of a segment")))
    {
      return false;
    }
  }
  return std::all_of(this->Judged.Drawn.Points.begin(), this->Judged.Drawn.Points.end(),
    [this](const Point2& p) { return this->KeepsPoint(p, "an embedded point"); });
}

/// Whether all of the chain lies within rounding of the segment: as one of length zero, it draws
/// nothing.
bool DrawingOracle::IsOfPoint(const DrawnSegment& segment) const
{
  return std::all_of(this->Judged.Drawn.Segments.begin(), this->Judged.Drawn.Segments.end(),
    [this, &segment](const DrawnSegment& other)
    {
      return other.Chain != segment.Chain ||
        (Distance(segment.Start, other.Start) <= this->Judged.Slack &&
          Distance(segment.Start, other.End) <= this->Judged.Slack);
    });
}

bool DrawingOracle::KeepsPoint(const Point2& p, const char* what)
{
  if (std::binary_search(this->Judged.SortedPoints.begin(), this->Judged.SortedPoints.end(), p) ||
    !this->Covers(p) || this->IsAtBoundary(p) || this->IsAtVertex(p))
  {
    return true;
  }
  return this->Judged.Refuse(what + (" is no vertex: " + PlaceText(p)));
}

/// Nearer to the boundary than rounding, p may as well be outside.
bool DrawingOracle::IsAtBoundary(const Point2& p) const
{
  return std::any_of(this->Judged.BoundarySlots.begin(), this->Judged.BoundarySlots.end(),
    [this, &p](std::size_t slot)
    {
      return DistanceTo(p, this->Judged.Corner(Next(slot)),
               this->Judged.Corner(Next(Next(slot)))) <= this->Judged.Slack;
    });
}

/// Nearer to a vertex than rounding, p may be that.
bool DrawingOracle::IsAtVertex(const Point2& p) const
{
  return std::any_of(this->Judged.SortedPoints.begin(), this->Judged.SortedPoints.end(),
    [this, &p](const Point2& vertex) { return Distance(p, vertex) <= this->Judged.Slack; });
}

/// Whether p lies in a triangle, exactly; its border included.
bool DrawingOracle::Covers(const Point2& p) const
{
  for (std::size_t slot = 0; slot < this->Judged.Mesh.Corners.size(); slot += 3)
  {
    const Point2& a = this->Judged.Corner(slot);
    const Point2& b = this->Judged.Corner(slot + 1);
    const Point2& c = this->Judged.Corner(slot + 2);
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

bool DrawingOracle::CoversSegments()
{
  return std::all_of(this->Judged.Drawn.Segments.begin(), this->Judged.Drawn.Segments.end(),
    [this](const DrawnSegment& segment) { return this->CoversSegment(segment); });
}

/// Along the segment, what no covering edge near it covers must lie outside.
bool DrawingOracle::CoversSegment(const DrawnSegment& segment)
{
  Box2 box;
  box.Add(segment.Start);
  box.Add(segment.End);
  box.Grow(this->Judged.Slack);
  std::vector<std::pair<double, double>> covered{ { 1.0, 1.0 } };
  for (const auto& ends : this->Judged.Covering)
  {
    const Point2& a = this->Judged.Place(ends.first);
    const Point2& b = this->Judged.Place(ends.second);
    if (box.Contains(a) && box.Contains(b) &&
      DistanceTo(a, segment.Start, segment.End) <= this->Judged.Slack &&
      DistanceTo(b, segment.Start, segment.End) <= this->Judged.Slack)
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
      return this->Judged.Refuse("a segment of cell " + std::to_string(segment.Cell) +
        " is not covered between " + PlaceText(segment.Start + done * along) + " and " +
        PlaceText(segment.Start + part.first * along));
    }
    done = std::max(done, part.second);
  }
  return true;
}

/// Whether the mesh covers the segment between two parameters, as far as samples tell.
bool DrawingOracle::CoversGap(const DrawnSegment& segment, double from, double to)
{
  const Point2 direction = segment.End - segment.Start;
  const double slack = this->Judged.Slack / std::hypot(direction.X, direction.Y);
  const BitingMeshOptions& options = this->Judged.Options;
  const bool isUnknown = options.Domain.KeepCellEdges && options.Simplification.IsAsked();
  if (to - from <= 2.0 * slack || isUnknown) // what is simplified does not tell lines from cells
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
DrawingOracle::Answer DrawingOracle::DividesFaces(
  const Point2& p, const Point2& q, double slack) const
{
  std::map<Id, const DrawnSegment*> faces; // that run there an odd number of times, and one segment
  bool isEdge = false;
  bool hasSpike = false;
  for (const DrawnSegment& segment : this->Judged.Drawn.Segments)
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
  const bool isKept = isEdge && this->Judged.Options.Domain.KeepCellEdges;
  if (isKept && this->HasTriangle(faces))
  {
    return Answer::Unknown; // triangles that stay are one region, those that cannot are none
  }
  const bool areTwo = faces.size() == 2;
  const bool differ = areTwo && faces.begin()->second->Region != faces.rbegin()->second->Region;
  return faces.size() % 2 != 0 || isKept || differ ? Answer::Yes
    : !hasSpike && (faces.empty() || areTwo)       ? Answer::No
                                                   : Answer::Unknown;
}

bool DrawingOracle::HasTriangle(const std::map<Id, const DrawnSegment*>& faces) const
{
  const std::vector<DrawnSegment>& segments = this->Judged.Drawn.Segments;
  return std::any_of(faces.begin(), faces.end(),
    [&segments](const auto& face)
    {
      return std::count_if(segments.begin(), segments.end(),
               [&face](const DrawnSegment& segment) { return segment.Face == face.first; }) == 3;
    });
}

/// Where faces are thinner than rounding, or have corners, it is not known which edges are one.
bool DrawingOracle::SurelyDividesFaces(const Point2& p, const Point2& q) const
{
  const auto isNear = [this, &p, &q](const Point2& end)
  { return DistanceTo(end, p, q) <= this->Judged.Slack; };
  const bool hasCorner =
    std::any_of(this->Judged.Drawn.Segments.begin(), this->Judged.Drawn.Segments.end(),
      [isNear](const DrawnSegment& segment)
      { return segment.Face != NoId && (isNear(segment.Start) || isNear(segment.End)); });
  return !hasCorner && this->AllSay(Answer::Yes, p, q);
}

bool DrawingOracle::MayDivideFaces(const Point2& p, const Point2& q) const
{
  return !this->AllSay(Answer::No, p, q);
}

/// Whether that is the answer however near edges must be to count: each step may take in one more.
bool DrawingOracle::AllSay(Answer answer, const Point2& p, const Point2& q) const
{
  for (double share = LeastSlack; share <= 1.0; share *= 2.0)
  {
    if (this->DividesFaces(p, q, share * this->Judged.Slack) != answer)
    {
      return false;
    }
  }
  return true;
}

/// Whether a line runs from p towards q.
bool DrawingOracle::HasLine(const Point2& p, const Point2& q) const
{
  return std::any_of(this->Judged.Drawn.Segments.begin(), this->Judged.Drawn.Segments.end(),
    [this, &p, &q](const DrawnSegment& segment)
    {
      return segment.Face == NoId &&
        DistanceTo(p, segment.Start, segment.End) <= this->Judged.Slack &&
        DistanceTo(q, segment.Start, segment.End) <= this->Judged.Slack;
    });
}

/// Whether p lies in the mesh and further than slack from what is covered.
bool DrawingOracle::CoversSafely(const Point2& p) const
{
  return this->Covers(p) &&
    std::none_of(this->Judged.Covering.begin(), this->Judged.Covering.end(),
      [this, &p](const auto& ends)
      {
        return DistanceTo(p, this->Judged.Place(ends.first), this->Judged.Place(ends.second)) <=
          this->Judged.Slack;
      });
}

bool DrawingOracle::LiesOnInput()
{
  for (std::size_t edge = 0; edge < this->Judged.Mesh.EdgeStarts.size(); ++edge)
  {
    const Point2& start = this->Judged.Place(this->Judged.Mesh.EdgeStarts[edge]);
    const Point2& end = this->Judged.Place(this->Judged.Mesh.EdgeEnds[edge]);
    const Id cell = this->Judged.Mesh.EdgeCells[edge];
    if (!this->LiesOnCell(start, cell) || !this->LiesOnCell(end, cell) ||
      !this->LiesOnCell(Midpoint(start, end), cell))
    {
      return this->Judged.Refuse(this->Judged.EdgeText(this->Judged.Mesh.EdgeStarts[edge],
                                   this->Judged.Mesh.EdgeEnds[edge]) +
        " is not on its cell " + std::to_string(cell));
    }
    const Point2 middle = Midpoint(start, end);
    if (!this->Judged.Mesh.EdgeIsBoundary[edge] && !this->HasLine(start, middle) &&
      !this->MayDivideFaces(start, middle) && !this->MayDivideFaces(middle, end))
    {
      return this->Judged.Refuse(this->Judged.EdgeText(this->Judged.Mesh.EdgeStarts[edge],
                                   this->Judged.Mesh.EdgeEnds[edge]) +
        " lies between neighbors");
    }
  }
  return true;
}

bool DrawingOracle::LiesOnCell(const Point2& p, Id cell) const
{
  return std::any_of(this->Judged.Drawn.Segments.begin(), this->Judged.Drawn.Segments.end(),
    [this, &p, cell](const DrawnSegment& segment)
    {
      return segment.Cell == cell &&
        DistanceTo(p, segment.Start, segment.End) <= this->Judged.Slack;
    });
}

bool DrawingOracle::HasKinds()
{
  std::vector<char> isOnEdge(this->Judged.Mesh.Points.size(), 0);
  for (const auto& ends : this->Judged.Covering)
  {
    isOnEdge[At(ends.first)] = 1;
    isOnEdge[At(ends.second)] = 1;
  }
  for (std::size_t vertex = 0; vertex < isOnEdge.size(); ++vertex)
  {
    if (!this->HasKind(vertex, isOnEdge[vertex] != 0))
    {
      return this->Judged.Refuse("vertex " + std::to_string(vertex) + " is not of kind " +
        std::to_string(static_cast<int>(this->Judged.Mesh.Kinds[vertex])));
    }
  }
  return true;
}

bool DrawingOracle::HasKind(std::size_t vertex, bool isOnEdge)
{
  const Id original = this->Judged.Mesh.OriginalPoints[vertex];
  const VertexKind kind = this->Judged.Mesh.Kinds[vertex];
  const bool isOld = kind == VertexKind::Input || kind == VertexKind::Embedded;
  const Point2 p = original == NoId ? Point2{} : this->Judged.Input.Points[At(original)];
  const bool isTiny = std::abs(p.X) < 1e-70 || std::abs(p.Y) < 1e-70;
  const bool mayStay =
    kind == VertexKind::Input && this->Judged.Options.Domain.KeepCellEdges; // within triangles
  return isOld == (original != NoId) &&
    (!isOld || isTiny || p == this->Judged.Mesh.Points[vertex]) &&
    (mayStay || isOnEdge == (kind == VertexKind::Input || kind == VertexKind::Boundary));
}

/// With that option, new vertices on segments are where two of these meet.
bool DrawingOracle::PreservesBoundary()
{
  for (std::size_t vertex = 0; vertex < this->Judged.Mesh.Points.size(); ++vertex)
  {
    if (this->Judged.Options.PreserveBoundary &&
      this->Judged.Mesh.Kinds[vertex] == VertexKind::Boundary)
    {
      const Point2& p = this->Judged.Mesh.Points[vertex];
      const auto segments =
        std::count_if(this->Judged.Drawn.Segments.begin(), this->Judged.Drawn.Segments.end(),
          [this, &p](const DrawnSegment& segment)
          { return DistanceTo(p, segment.Start, segment.End) <= this->Judged.Slack; });
      if (segments < 2)
      {
        return this->Judged.Refuse("vertex " + std::to_string(vertex) + " was added on a segment");
      }
    }
  }
  return true;
}

} // namespace biting
