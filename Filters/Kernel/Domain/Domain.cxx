// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Domain.h"

#include "../Base/Pulse.h"
#include "../Predicates/Predicates.h" // for the range of coordinates
#include "AreaSum.h"
#include "Arrangement.h"
#include "CellOverlaps.h"
#include "ChainKinds.h"
#include "Nesting.h"
#include "OpenOutlines.h"
#include "SegmentWalk.h"
#include "Welding.h"

#include <algorithm> // for none_of
#include <cmath>     // for isfinite, abs
#include <cstddef>   // for size_t
#include <map>       // for what is dropped

namespace biting
{

namespace
{

using Flags = std::vector<std::uint8_t>;

/// Of the time for clean input; the rest is the sweep.
constexpr double EndOfWelding = 0.15;
constexpr double EndOfResolving = 0.6;
constexpr double EndOfBoundary = 0.7;

bool IsUsable(const Polylines& input, ProblemList& problems);
InsideFlags Nest(const Arrangement& arrangement, const Flags& bounds, Pulse& pulse);
Domain KeepInside(const Arrangement& arrangement, const Flags& bounds, const Flags& isKept,
  const InsideFlags& inside);
Flags KeptEdges(const Arrangement& arrangement, const InsideFlags& inside);
void ReportOutside(const Arrangement& arrangement, const Flags& isKept, const InsideFlags& inside,
  ProblemList& problems);
double EnclosedArea(const Domain& domain);
bool AcceptOverlaps(const Arrangement& arrangement, const Polylines& input, double area,
  const DomainOptions& options, ProblemList& problems, Pulse& pulse);

Domain Refuse(ProblemCode code, ProblemList& problems)
{
  problems.Add({ code, {}, {}, {} });
  return {};
}

/// Of EndTolerance: outlines with gaps that wide are closed where they would be refused else.
constexpr double OutlineFactor = 10.0;
constexpr double SlackOfClosing = 1e-9; ///< above the rounding of distances

/// Where the drawing, or an outline of it, is open, `closing` is the EndTolerance that closes it.
Domain MakeOnce(const Polylines& input, const DomainOptions& options, double& closing,
  ProblemList& problems, Monitor& monitor);

} // namespace

Domain MakeDomain(
  const Polylines& input, const DomainOptions& options, ProblemList& problems, Monitor& monitor)
{
  const ProblemList before = problems;
  double closing = 0.0;
  Domain domain = MakeOnce(input, options, closing, problems, monitor);
  if (closing > options.EndTolerance && closing <= OutlineFactor * options.EndTolerance)
  {
    DomainOptions wider = options;
    wider.EndTolerance = (1.0 + SlackOfClosing) * closing;
    problems = before;
    domain = MakeOnce(input, wider, closing, problems, monitor);
  }
  return domain;
}

namespace
{

Domain MakeOnce(const Polylines& input, const DomainOptions& options, double& closing,
  ProblemList& problems, Monitor& monitor)
{
  if (input.NumberOfChains() == 0 || !IsUsable(input, problems))
  {
    return {};
  }
  Pulse pulse(monitor);
  Arrangement arrangement;
  Flags bounds;
  {
    const PulsePart part(pulse, 0.0, EndOfWelding);
    arrangement = WeldPolylines(input, options, problems, pulse);
  }
  {
    const PulsePart part(pulse, EndOfWelding, EndOfResolving);
    if (!ResolveArrangement(arrangement, options, problems, pulse))
    {
      return {};
    }
  }
  {
    const PulsePart part(pulse, EndOfResolving, EndOfBoundary);
    bounds = options.Rule == DomainRule::EvenOdd ? FindBoundary(arrangement, pulse)
                                                 : FindBoundaryByRule(arrangement, options, pulse);
  }
  const bool isOpen =
    std::none_of(bounds.begin(), bounds.end(), [](std::uint8_t b) { return b != 0; });
  if (isOpen && !pulse.HasStopped())
  {
    closing = RefuseOpenDrawing(arrangement, options, problems, pulse);
    return {};
  }
  const InsideFlags inside = Nest(arrangement, bounds, pulse);
  if (!pulse.Ask())
  {
    return Refuse(ProblemCode::Aborted, problems);
  }
  const Flags isKept = KeptEdges(arrangement, inside);
  closing = RefuseOpenOutlines(arrangement, isKept, options, problems, pulse);
  if (closing > 0.0)
  {
    return {};
  }
  ReportOutside(arrangement, isKept, inside, problems);
  Domain domain = KeepInside(arrangement, bounds, isKept, inside);
  NumberAlongSegments(domain, pulse);
  if (!pulse.Ask())
  {
    return Refuse(ProblemCode::Aborted, problems);
  }
  domain.Area = EnclosedArea(domain);
  if (!AcceptOverlaps(arrangement, input, domain.Area, options, problems, pulse))
  {
    return {};
  }
  return domain;
}

Flags UsedPoints(const Polylines& input)
{
  Flags isUsed(input.Points.size(), 0);
  for (const Id point : input.Connectivity)
  {
    isUsed[point] = 1;
  }
  return isUsed;
}

/// A box smaller than LeastCoordinate would be flushed to a point.
bool IsTooSmall(const Box2& bounds)
{
  const double size = std::max(bounds.Width(), bounds.Height());
  return size > 0.0 && size < LeastCoordinate;
}

/// Refuses points that the predicates cannot handle.
bool IsUsable(const Polylines& input, ProblemList& problems)
{
  const Flags isUsed = UsedPoints(input);
  bool isUsable = true;
  Box2 bounds;
  for (std::size_t point = 0; point < isUsed.size(); ++point)
  {
    const Point2& p = input.Points[point];
    const bool isFinite = std::isfinite(p.X) && std::isfinite(p.Y);
    const bool isInRange =
      std::abs(p.X) <= GreatestCoordinate && std::abs(p.Y) <= GreatestCoordinate;
    if (isUsed[point] && !(isFinite && isInRange))
    {
      const ProblemCode code = isFinite ? ProblemCode::OutOfRange : ProblemCode::NotFinite;
      problems.Add({ code, { static_cast<std::int64_t>(point) }, p, {} });
      isUsable = false;
    }
    else if (isUsed[point])
    {
      bounds.Add(p);
    }
  }
  if (isUsable && IsTooSmall(bounds))
  {
    problems.Add({ ProblemCode::OutOfRange, {}, bounds.Low, "smaller than 1e-70" });
    isUsable = false;
  }
  return isUsable;
}

/// Edges that are none of the drawing do not hide the embedded points at their ends. Flags that are
/// empty, because the monitor asked to stop, stay so.
void AddEndsOfNothing(const Arrangement& arrangement, InsideFlags& inside)
{
  for (std::size_t e = 0; e < inside.Left.size(); ++e)
  {
    const ArrangementEdge& edge = arrangement.Edges[e];
    if (arrangement.IsNothing(edge) && inside.Left[e])
    {
      inside.Vertices[edge.Ends.Start] = 1;
      inside.Vertices[edge.Ends.End] = 1;
    }
  }
}

InsideFlags Nest(const Arrangement& arrangement, const Flags& bounds, Pulse& pulse)
{
  const PulsePart part(pulse, EndOfBoundary, 1.0);
  InsideFlags inside = FindInside(arrangement.Vertices, arrangement.EdgeEnds(), bounds, pulse);
  AddEndsOfNothing(arrangement, inside);
  return inside;
}

/// Edges of the drawing with the inside on one side at least.
Flags KeptEdges(const Arrangement& arrangement, const InsideFlags& inside)
{
  Flags isKept;
  isKept.reserve(arrangement.Edges.size());
  for (std::size_t e = 0; e < arrangement.Edges.size(); ++e)
  {
    isKept.push_back(
      (inside.Left[e] || inside.Right[e]) && !arrangement.IsNothing(arrangement.Edges[e]));
  }
  return isKept;
}

/// 1 for the ends of kept edges.
Flags EndsOfKeptEdges(const Arrangement& arrangement, const Flags& isKept)
{
  Flags isEnd(arrangement.Vertices.size(), 0);
  for (std::size_t e = 0; e < arrangement.Edges.size(); ++e)
  {
    if (isKept[e])
    {
      isEnd[arrangement.Edges[e].Ends.Start] = 1;
      isEnd[arrangement.Edges[e].Ends.End] = 1;
    }
  }
  return isEnd;
}

/// Whether a dropped edge is worth a word: a boundary drawn an even number of times is none.
bool IsInterface(const ArrangementEdge& edge)
{
  return edge.IsInterface || (edge.BoundaryCount + edge.OpenCount) % 2 != 0;
}

void ReportOutside(const Arrangement& arrangement, const Flags& isKept, const InsideFlags& inside,
  ProblemList& problems)
{
  std::map<Id, Id> dropped; // by cell, where the first one begins
  for (std::size_t e = 0; e < arrangement.Edges.size(); ++e)
  {
    const ArrangementEdge& edge = arrangement.Edges[e];
    if (!isKept[e] && IsInterface(edge))
    {
      dropped.emplace(edge.Cell, edge.Ends.Start);
    }
  }
  for (const auto& [cell, start] : dropped)
  {
    problems.Add({ ProblemCode::OutsideInterfaces, { cell }, arrangement.At(start), {} });
  }
  const Flags isEnd = EndsOfKeptEdges(arrangement, isKept);
  for (const Id vertex : arrangement.EmbeddedVertices)
  {
    if (!isEnd[vertex] && !inside.Vertices[vertex])
    {
      problems.Add({ ProblemCode::OutsidePoints, { arrangement.VertexPoints[vertex] },
        arrangement.Vertices[vertex], {} });
    }
  }
}

/// Fills the vertices of the domain; returns their new numbers, NoId for those dropped.
std::vector<Id> KeepVertices(const Arrangement& arrangement, const Flags& isKeptEdge,
  const InsideFlags& inside, Domain& domain)
{
  Flags isKept = EndsOfKeptEdges(arrangement, isKeptEdge);
  Flags isLone(isKept.size(), 0);
  Flags hasPoint(isKept.size(), 0);
  for (const Id vertex : arrangement.EmbeddedVertices)
  {
    hasPoint[vertex] = 1;
    isLone[vertex] = !isKept[vertex] && inside.Vertices[vertex];
    isKept[vertex] = isKept[vertex] || isLone[vertex];
  }
  std::vector<Id> numbers(isKept.size(), NoId);
  for (std::size_t vertex = 0; vertex < isKept.size(); ++vertex)
  {
    if (isKept[vertex])
    {
      numbers[vertex] = domain.NumberOfVertices();
      domain.Vertices.push_back(arrangement.Vertices[vertex]);
      domain.VertexPoints.push_back(arrangement.VertexPoints[vertex]);
      domain.IsEmbedded.push_back(isLone[vertex]);
      domain.HasPoint.push_back(hasPoint[vertex]);
      domain.Bounds.Add(arrangement.Vertices[vertex]);
    }
  }
  return numbers;
}

Domain KeepInside(const Arrangement& arrangement, const Flags& bounds, const Flags& isKept,
  const InsideFlags& inside)
{
  Domain domain;
  domain.Resolution = arrangement.Rounding;
  const std::vector<Id> numbers = KeepVertices(arrangement, isKept, inside, domain);
  for (std::size_t e = 0; e < arrangement.Edges.size(); ++e)
  {
    if (isKept[e])
    {
      const ArrangementEdge& edge = arrangement.Edges[e];
      domain.Starts.push_back(numbers[edge.Ends.Start]);
      domain.Ends.push_back(numbers[edge.Ends.End]);
      domain.Cells.push_back(edge.Cell);
      domain.IsBoundary.push_back(bounds[e]);
      domain.LeftInside.push_back(inside.Left[e]);
      domain.RightInside.push_back(inside.Right[e]);
    }
  }
  return domain;
}

double EnclosedArea(const Domain& domain)
{
  AreaSum sum(domain.Vertices.front());
  for (std::size_t s = 0; s < domain.Starts.size(); ++s)
  {
    const Point2& start = domain.Vertices[domain.Starts[s]];
    const Point2& end = domain.Vertices[domain.Ends[s]];
    if (domain.IsBoundary[s])
    {
      sum.Add(domain.LeftInside[s] ? start : end, domain.LeftInside[s] ? end : start);
    }
  }
  return sum.Area();
}

/// Tells of cells on top of each other; false where that refuses the input.
bool AcceptOverlaps(const Arrangement& arrangement, const Polylines& input, double area,
  const DomainOptions& options, ProblemList& problems, Pulse& pulse)
{
  if (options.Rule == DomainRule::EvenOdd)
  {
    ReportCellOverlaps(arrangement, input, area, problems, pulse);
  }
  if (!pulse.Ask())
  {
    Refuse(ProblemCode::Aborted, problems);
    return false;
  }
  for (const ProblemGroup& group : problems.Groups())
  {
    if (group.Code == ProblemCode::OverlappingCells && !options.Repair)
    {
      Problem problem = group.First.front();
      problem.Code = ProblemCode::NotResolved;
      problem.Ids.push_back(problem.Ids.front());
      problems.Add(problem);
      return false;
    }
  }
  return true;
}

} // namespace

} // namespace biting
