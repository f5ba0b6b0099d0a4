// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "JudgedMesh.h"

#include "EvenOddArea.h"
#include "ExactSigns.h"

#include <algorithm> // for sort, binary_search
#include <cmath>     // for abs
#include <map>       // for faces

namespace biting
{

namespace
{

constexpr double LeastDirection = 4.0;    // in slacks, by which directions are told apart
constexpr double LeastSlack = 1.0 / 16.0; // of all of it: a point on a line is rounded by that

enum class Answer
{
  No,
  Unknown,
  Yes
};

/// That of the triangles is that of the boundary: each edge within is there twice, in both
/// directions.
bool HasArea(JudgedMesh& judged)
{
  if (!judged.Drawn.IsExplicit)
  {
    return true;
  }
  std::vector<std::pair<Point2, Point2>> boundary;
  for (const std::size_t slot : judged.BoundarySlots)
  {
    boundary.emplace_back(judged.Corner(Next(slot)), judged.Corner(Next(Next(slot))));
  }
  const Rational area = EnclosedArea(boundary);
  const EvenOddArea expected = MeasureEvenOddArea(judged.Drawn);
  std::ostringstream text;
  text.precision(17);
  text << "the area is " << area.convert_to<double>() << " instead of "
       << expected.Area.convert_to<double>() << " +- " << expected.Tolerance;
  return abs(area - expected.Area) <= expected.Tolerance || judged.Refuse(text.str());
}

/// Whether all of the chain lies within rounding of the segment: as one of length zero, it draws
/// nothing.
bool IsOfPoint(const JudgedMesh& judged, const DrawnSegment& segment)
{
  return std::all_of(judged.Drawn.Segments.begin(), judged.Drawn.Segments.end(),
    [&judged, &segment](const DrawnSegment& other)
    {
      return other.Chain != segment.Chain ||
        (Distance(segment.Start, other.Start) <= judged.Slack &&
          Distance(segment.Start, other.End) <= judged.Slack);
    });
}

/// Nearer to the boundary than rounding, p may as well be outside.
bool IsAtBoundary(const JudgedMesh& judged, const Point2& p)
{
  return std::any_of(judged.BoundarySlots.begin(), judged.BoundarySlots.end(),
    [&judged, &p](std::size_t slot)
    {
      return DistanceTo(p, judged.Corner(Next(slot)), judged.Corner(Next(Next(slot)))) <=
        judged.Slack;
    });
}

/// Nearer to a vertex than rounding, p may be that.
bool IsAtVertex(const JudgedMesh& judged, const Point2& p)
{
  return std::any_of(judged.SortedPoints.begin(), judged.SortedPoints.end(),
    [&judged, &p](const Point2& vertex) { return Distance(p, vertex) <= judged.Slack; });
}

/// Whether p lies in a triangle, exactly; its border included.
bool Covers(const JudgedMesh& judged, const Point2& p)
{
  for (std::size_t slot = 0; slot < judged.Mesh.Corners.size(); slot += 3)
  {
    const Point2& a = judged.Corner(slot);
    const Point2& b = judged.Corner(slot + 1);
    const Point2& c = judged.Corner(slot + 2);
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

bool KeepsPoint(JudgedMesh& judged, const Point2& p, const char* what)
{
  if (std::binary_search(judged.SortedPoints.begin(), judged.SortedPoints.end(), p) ||
    !Covers(judged, p) || IsAtBoundary(judged, p) || IsAtVertex(judged, p))
  {
    return true;
  }
  return judged.Refuse(what + (" is no vertex: " + PlaceText(p)));
}

bool KeepsPoints(JudgedMesh& judged)
{
  for (const DrawnSegment& segment : judged.Drawn.Segments)
  {
    const bool mayGo = segment.Face != NoId && !judged.Options.Domain.KeepCellEdges;
    if (!mayGo && !IsOfPoint(judged, segment) &&
      (!KeepsPoint(judged, segment.Start, "an end of a segment") ||
        !KeepsPoint(judged, segment.End, "an end of a segment")))
    {
      return false;
    }
  }
  return std::all_of(judged.Drawn.Points.begin(), judged.Drawn.Points.end(),
    [&judged](const Point2& p) { return KeepsPoint(judged, p, "an embedded point"); });
}

bool HasTriangle(const JudgedMesh& judged, const std::map<Id, const DrawnSegment*>& faces)
{
  const std::vector<DrawnSegment>& segments = judged.Drawn.Segments;
  return std::any_of(faces.begin(), faces.end(),
    [&segments](const auto& face)
    {
      return std::count_if(segments.begin(), segments.end(),
               [&face](const DrawnSegment& segment) { return segment.Face == face.first; }) == 3;
    });
}

/// Whether the edges of faces from p towards q are more than one between neighbors, of all edges
/// that are no further away than `slack`. A face that runs there and back has no area there, unless
/// it is a thin spike. Where three faces or more meet they overlap: there it is not known of which
/// region the mesh is.
Answer DividesFaces(const JudgedMesh& judged, const Point2& p, const Point2& q, double slack)
{
  std::map<Id, const DrawnSegment*> faces; // that run there an odd number of times, and one segment
  bool isEdge = false;
  bool hasSpike = false;
  for (const DrawnSegment& segment : judged.Drawn.Segments)
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
  const bool isKept = isEdge && judged.Options.Domain.KeepCellEdges;
  if (isKept && HasTriangle(judged, faces))
  {
    return Answer::Unknown; // triangles that stay are one region, those that cannot are none
  }
  const bool areTwo = faces.size() == 2;
  const bool differ = areTwo && faces.begin()->second->Region != faces.rbegin()->second->Region;
  return faces.size() % 2 != 0 || isKept || differ ? Answer::Yes
    : !hasSpike && (faces.empty() || areTwo)       ? Answer::No
                                                   : Answer::Unknown;
}

/// Whether that is the answer however near edges must be to count: each step may take in one more.
bool AllSay(const JudgedMesh& judged, Answer answer, const Point2& p, const Point2& q)
{
  for (double share = LeastSlack; share <= 1.0; share *= 2.0)
  {
    if (DividesFaces(judged, p, q, share * judged.Slack) != answer)
    {
      return false;
    }
  }
  return true;
}

/// Where faces are thinner than rounding, or have corners, it is not known which edges are one.
bool SurelyDividesFaces(const JudgedMesh& judged, const Point2& p, const Point2& q)
{
  const auto isNear = [&judged, &p, &q](const Point2& end)
  { return DistanceTo(end, p, q) <= judged.Slack; };
  const bool hasCorner = std::any_of(judged.Drawn.Segments.begin(), judged.Drawn.Segments.end(),
    [isNear](const DrawnSegment& segment)
    { return segment.Face != NoId && (isNear(segment.Start) || isNear(segment.End)); });
  return !hasCorner && AllSay(judged, Answer::Yes, p, q);
}

/// Whether p lies in the mesh and further than slack from what is covered.
bool CoversSafely(const JudgedMesh& judged, const Point2& p)
{
  return Covers(judged, p) &&
    std::none_of(judged.Covering.begin(), judged.Covering.end(),
      [&judged, &p](const auto& ends) {
        return DistanceTo(p, judged.Place(ends.first), judged.Place(ends.second)) <= judged.Slack;
      });
}

/// Whether the mesh covers the segment between two parameters, as far as samples tell.
bool CoversGap(JudgedMesh& judged, const DrawnSegment& segment, double from, double to)
{
  const Point2 direction = segment.End - segment.Start;
  const double slack = judged.Slack / std::hypot(direction.X, direction.Y);
  const BitingMeshOptions& options = judged.Options;
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
      (beyond < to && SurelyDividesFaces(judged, p, segment.Start + beyond * direction));
    if (isWanted && CoversSafely(judged, p))
    {
      return true;
    }
  }
  return false;
}

/// Along the segment, what no covering edge near it covers must lie outside.
bool CoversSegment(JudgedMesh& judged, const DrawnSegment& segment)
{
  Box2 box;
  box.Add(segment.Start);
  box.Add(segment.End);
  box.Grow(judged.Slack);
  std::vector<std::pair<double, double>> covered{ { 1.0, 1.0 } };
  for (const auto& ends : judged.Covering)
  {
    const Point2& a = judged.Place(ends.first);
    const Point2& b = judged.Place(ends.second);
    if (box.Contains(a) && box.Contains(b) &&
      DistanceTo(a, segment.Start, segment.End) <= judged.Slack &&
      DistanceTo(b, segment.Start, segment.End) <= judged.Slack)
    {
      covered.push_back(std::minmax({ ParameterOf(a, segment.Start, segment.End),
        ParameterOf(b, segment.Start, segment.End) }));
    }
  }
  std::sort(covered.begin(), covered.end());
  double done = 0.0;
  for (const auto& part : covered)
  {
    if (part.first > done && CoversGap(judged, segment, done, part.first))
    {
      const Point2 along = segment.End - segment.Start;
      return judged.Refuse("a segment of cell " + std::to_string(segment.Cell) +
        " is not covered between " + PlaceText(segment.Start + done * along) + " and " +
        PlaceText(segment.Start + part.first * along));
    }
    done = std::max(done, part.second);
  }
  return true;
}

bool CoversSegments(JudgedMesh& judged)
{
  return std::all_of(judged.Drawn.Segments.begin(), judged.Drawn.Segments.end(),
    [&judged](const DrawnSegment& segment) { return CoversSegment(judged, segment); });
}

bool MayDivideFaces(const JudgedMesh& judged, const Point2& p, const Point2& q)
{
  return !AllSay(judged, Answer::No, p, q);
}

/// Whether a line runs from p towards q.
bool HasLine(const JudgedMesh& judged, const Point2& p, const Point2& q)
{
  return std::any_of(judged.Drawn.Segments.begin(), judged.Drawn.Segments.end(),
    [&judged, &p, &q](const DrawnSegment& segment)
    {
      return segment.Face == NoId && DistanceTo(p, segment.Start, segment.End) <= judged.Slack &&
        DistanceTo(q, segment.Start, segment.End) <= judged.Slack;
    });
}

bool LiesOnCell(const JudgedMesh& judged, const Point2& p, Id cell)
{
  return std::any_of(judged.Drawn.Segments.begin(), judged.Drawn.Segments.end(),
    [&judged, &p, cell](const DrawnSegment& segment)
    { return segment.Cell == cell && DistanceTo(p, segment.Start, segment.End) <= judged.Slack; });
}

bool LiesOnInput(JudgedMesh& judged)
{
  for (std::size_t edge = 0; edge < judged.Mesh.EdgeStarts.size(); ++edge)
  {
    const Point2& start = judged.Place(judged.Mesh.EdgeStarts[edge]);
    const Point2& end = judged.Place(judged.Mesh.EdgeEnds[edge]);
    const Id cell = judged.Mesh.EdgeCells[edge];
    if (!LiesOnCell(judged, start, cell) || !LiesOnCell(judged, end, cell) ||
      !LiesOnCell(judged, Midpoint(start, end), cell))
    {
      return judged.Refuse(
        judged.EdgeText(judged.Mesh.EdgeStarts[edge], judged.Mesh.EdgeEnds[edge]) +
        " is not on its cell " + std::to_string(cell));
    }
    const Point2 middle = Midpoint(start, end);
    if (!judged.Mesh.EdgeIsBoundary[edge] && !HasLine(judged, start, middle) &&
      !MayDivideFaces(judged, start, middle) && !MayDivideFaces(judged, middle, end))
    {
      return judged.Refuse(
        judged.EdgeText(judged.Mesh.EdgeStarts[edge], judged.Mesh.EdgeEnds[edge]) +
        " lies between neighbors");
    }
  }
  return true;
}

bool HasKind(JudgedMesh& judged, std::size_t vertex, bool isOnEdge)
{
  const Id original = judged.Mesh.OriginalPoints[vertex];
  const VertexKind kind = judged.Mesh.Kinds[vertex];
  const bool isOld = kind == VertexKind::Input || kind == VertexKind::Embedded;
  const Point2 p = original == NoId ? Point2{} : judged.Input.Points[At(original)];
  const bool isTiny = std::abs(p.X) < 1e-70 || std::abs(p.Y) < 1e-70;
  const bool mayStay =
    kind == VertexKind::Input && judged.Options.Domain.KeepCellEdges; // within triangles
  return isOld == (original != NoId) && (!isOld || isTiny || p == judged.Mesh.Points[vertex]) &&
    (mayStay || isOnEdge == (kind == VertexKind::Input || kind == VertexKind::Boundary));
}

bool HasKinds(JudgedMesh& judged)
{
  std::vector<char> isOnEdge(judged.Mesh.Points.size(), 0);
  for (const auto& ends : judged.Covering)
  {
    isOnEdge[At(ends.first)] = 1;
    isOnEdge[At(ends.second)] = 1;
  }
  for (std::size_t vertex = 0; vertex < isOnEdge.size(); ++vertex)
  {
    if (!HasKind(judged, vertex, isOnEdge[vertex] != 0))
    {
      return judged.Refuse("vertex " + std::to_string(vertex) + " is not of kind " +
        std::to_string(static_cast<int>(judged.Mesh.Kinds[vertex])));
    }
  }
  return true;
}

/// With that option, new vertices on segments are where two of these meet.
bool PreservesBoundary(JudgedMesh& judged)
{
  for (std::size_t vertex = 0; vertex < judged.Mesh.Points.size(); ++vertex)
  {
    if (judged.Options.PreserveBoundary && judged.Mesh.Kinds[vertex] == VertexKind::Boundary)
    {
      const Point2& p = judged.Mesh.Points[vertex];
      const auto segments =
        std::count_if(judged.Drawn.Segments.begin(), judged.Drawn.Segments.end(),
          [&judged, &p](const DrawnSegment& segment)
          { return DistanceTo(p, segment.Start, segment.End) <= judged.Slack; });
      if (segments < 2)
      {
        return judged.Refuse("vertex " + std::to_string(vertex) + " was added on a segment");
      }
    }
  }
  return true;
}

} // namespace

bool HoldsDrawing(JudgedMesh& judged)
{
  return HasArea(judged) && KeepsPoints(judged) && CoversSegments(judged) && LiesOnInput(judged) &&
    HasKinds(judged) && PreservesBoundary(judged);
}

} // namespace biting
