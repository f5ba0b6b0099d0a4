// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OpenOutlines.h"

#include "../Base/Box.h"
#include "../Base/DisjointSets.h"
#include "BoundaryComponents.h"
#include "EndPairs.h"
#include "OpenEnds.h" // for the spacing at an end

#include <algorithm> // for all_of, any_of, find_if, max, min, minmax_element, sort
#include <cmath>     // for abs
#include <limits>    // for infinity
#include <map>       // for runs
#include <set>       // for pairs
#include <string>    // for details
#include <utility>   // for move, pair

namespace biting
{

namespace
{

using Flags = std::vector<std::uint8_t>;

constexpr double LargestTolerance = 10.0; ///< that is worth a try

/// Of the length of a loop, all of its gaps together.
struct LargestShare
{
  double OfOneGap;
  double OfSeveral;
};
constexpr LargestShare AroundWhatIsKept{ 0.5, 0.25 };
constexpr LargestShare Elsewhere{ 0.1, 0.01 };

/// Of ends: with more the widest gaps are not left out one by one.
constexpr std::size_t MostTried = 40;

/// How wide the gap is, and what closes it: "a gap of .1; an End Tolerance of .5 closes it".
std::string DetailOf(double gap, double tolerance)
{
  const bool mayClose = tolerance <= LargestTolerance;
  return "a gap of " + Figure(gap) +
    (mayClose ? "; an End Tolerance of " + FigureAbove(tolerance) + " closes it" : "");
}

/// With which the end reaches over its gap; infinity where no spacing is known.
double ToleranceOf(const OpenEnd& end, const Arrangement& arrangement, const SpacingAtEnds& spacing)
{
  const double wanted =
    std::max(spacing(arrangement.At(end.Vertex)), spacing(arrangement.At(end.Partner)));
  return wanted > 0.0 ? end.Gap / wanted : std::numeric_limits<double>::infinity();
}

/// What there is instead of a boundary, and where it begins.
void TellWhatThereIs(const Arrangement& arrangement, Problem& problem)
{
  if (!arrangement.Edges.empty())
  {
    problem.Place = arrangement.At(arrangement.Edges.front().Ends.Start);
    problem.Detail = "there are interfaces only, the first of cell " +
      std::to_string(arrangement.Edges.front().Cell);
  }
  else if (!arrangement.EmbeddedVertices.empty())
  {
    const Id vertex = arrangement.EmbeddedVertices.front();
    problem.Place = arrangement.At(vertex);
    problem.Detail = "there are embedded points only, the first of them point " +
      std::to_string(arrangement.VertexPoints[vertex]);
  }
  else if (!arrangement.Vertices.empty())
  {
    problem.Place = arrangement.At(0);
    problem.Detail = "all segments have length 0, the first of them";
  }
}

/// Whether all vertices lie on one line, but for what counts as one point.
bool AreOnOneLine(const Arrangement& arrangement)
{
  const std::vector<Point2>& places = arrangement.Vertices;
  const auto [first, last] = std::minmax_element(places.begin(), places.end());
  const Point2 direction = *last - *first;
  const double reach = arrangement.Resolution * Length(direction);
  return std::all_of(places.begin(), places.end(),
    [first = *first, direction, reach](const Point2& place)
    { return std::abs(Cross(direction, place - first)) <= reach; });
}

/// A refusal where nothing is open; says how many segments were drawn twice, if any, and where one
/// is.
Problem NothingBounds(const Arrangement& arrangement, DomainRule rule)
{
  Problem problem{ ProblemCode::NoClosedLoop, {}, {}, {} };
  Id cancelled = 0;
  for (const ArrangementEdge& edge : arrangement.Edges)
  {
    const Id count = edge.BoundaryCount + edge.OpenCount + edge.Faces.Count;
    if (count > 0 && count % 2 == 0)
    {
      problem.Place = cancelled == 0 ? arrangement.At(edge.Ends.Start) : problem.Place;
      ++cancelled;
    }
  }
  if (cancelled > 0)
  {
    problem.Detail = std::to_string(cancelled) +
      " boundary segments are drawn an even number of times, which cancels them" +
      (AreOnOneLine(arrangement) ? ", and all lie on one straight line" : "") +
      "; the first of them";
  }
  else
  {
    TellWhatThereIs(arrangement, problem);
    const bool hasLoop = std::any_of(arrangement.Edges.begin(), arrangement.Edges.end(),
      [](const ArrangementEdge& edge) { return !edge.HasLine(); });
    problem.Detail = rule != DomainRule::EvenOdd && hasLoop
      ? "the others cover all of the largest loop"
      : problem.Detail;
  }
  return problem;
}

/// Chains that are left out, with their gaps as edges.
class ClosedGaps
{
public:
  ClosedGaps(const Arrangement& arrangement, const Flags& isKept, const std::vector<OpenEnd>& ends);

  double AddProblems(const DomainOptions& options, ProblemList& problems, Pulse& pulse);

private:
  std::vector<std::vector<Id>> RunsOf(const BoundaryComponent& loop);
  bool IsOutline(const std::vector<Id>& run, bool isLoop) const;
  bool HasKeptInside(const std::vector<Id>& loop) const;
  bool IsInside(const Point2& place, const std::vector<Id>& loop) const;
  bool IsAtKept(Id vertex) const { return this->AtKept[vertex] != 0; }
  Id CellOf(Id edge) const { return this->Drawing.Edge(edge).Cell; }
  bool IsGap(Id edge) const { return static_cast<std::size_t>(edge) >= this->IsKept.size(); }
  const OpenEnd& EndOf(Id gap) const
  {
    return this->Gaps[static_cast<std::size_t>(gap) - this->IsKept.size()];
  }
  double LengthOf(Id edge) const
  {
    const SegmentEnds& ends = this->Drawing.Edge(edge).Ends;
    return Distance(this->Drawing.At(ends.Start), this->Drawing.At(ends.End));
  }

  Arrangement Drawing;
  const Flags& IsKept;
  Flags AtKept;        ///< vertices
  DisjointSets Groups; ///< of vertices that what is not kept joins, away from what is
  std::vector<Id> Counts;
  std::vector<OpenEnd> Gaps;
};

ClosedGaps::ClosedGaps(
  const Arrangement& arrangement, const Flags& isKept, const std::vector<OpenEnd>& ends)
  : Drawing(arrangement)
  , IsKept(isKept)
  , AtKept(arrangement.Vertices.size(), 0)
  , Groups(arrangement.Vertices.size())
{
  for (std::size_t e = 0; e < isKept.size(); ++e)
  {
    const ArrangementEdge& edge = arrangement.Edges[e];
    this->Counts.push_back(edge.BoundaryCount + edge.OpenCount);
    this->AtKept[edge.Ends.Start] |= isKept[e];
    this->AtKept[edge.Ends.End] |= isKept[e];
  }
  std::set<std::pair<Id, Id>> pairs;
  for (const OpenEnd& end : ends)
  {
    const auto pair = std::minmax(end.Vertex, end.Partner);
    if (end.Partner != NoId && pairs.insert({ pair.first, pair.second }).second)
    {
      ArrangementEdge gap;
      gap.Ends = { std::min(end.Vertex, end.Partner), std::max(end.Vertex, end.Partner) };
      this->Drawing.Edges.push_back(gap);
      this->Counts.push_back(1);
      this->Gaps.push_back(end);
    }
  }
  for (const ArrangementEdge& edge : this->Drawing.Edges)
  {
    if (!this->IsAtKept(edge.Ends.Start) && !this->IsAtKept(edge.Ends.End))
    {
      this->Groups.Unite(edge.Ends.Start, edge.Ends.End);
    }
  }
}

double ClosedGaps::AddProblems(const DomainOptions& options, ProblemList& problems, Pulse& pulse)
{
  const SpacingAtEnds spacing(options, this->Drawing.Vertices);
  double largest = 0.0;
  for (const BoundaryComponent& loop : FindBoundaryComponents(this->Drawing, this->Counts, pulse))
  {
    for (const std::vector<Id>& run : this->RunsOf(loop))
    {
      OpenEnd widest;
      double tolerance = 0.0;
      for (const Id edge : run)
      {
        const OpenEnd end = this->IsGap(edge) ? this->EndOf(edge) : OpenEnd();
        widest = end.Gap > widest.Gap ? end : widest;
        tolerance =
          std::max(tolerance, end.Vertex == NoId ? 0.0 : ToleranceOf(end, this->Drawing, spacing));
      }
      if (widest.Vertex != NoId && this->IsOutline(run, run.size() == loop.Edges.size()))
      {
        largest = std::max(largest, tolerance);
        const auto pointOf = [this](Id vertex) { return this->Drawing.VertexPoints[vertex]; };
        problems.Add(
          { ProblemCode::OpenOutlines, { pointOf(widest.Vertex), pointOf(widest.Partner) },
            this->Drawing.At(widest.Vertex), DetailOf(widest.Gap, tolerance) });
      }
    }
  }
  return largest;
}

/// What is left out of the loop, and gaps, as far as it hangs together without what is kept.
std::vector<std::vector<Id>> ClosedGaps::RunsOf(const BoundaryComponent& loop)
{
  std::map<Id, std::vector<Id>> runs;
  for (const Id edge : loop.Edges)
  {
    const SegmentEnds& ends = this->Drawing.Edge(edge).Ends;
    if (this->IsGap(edge) || !this->IsKept[edge])
    {
      runs[this->Groups.SetOf(this->IsAtKept(ends.Start) ? ends.End : ends.Start)].push_back(edge);
    }
  }
  std::vector<std::vector<Id>> lists;
  lists.reserve(runs.size());
  for (auto& [group, edges] : runs)
  {
    lists.push_back(std::move(edges));
  }
  return lists;
}

bool ClosedGaps::IsOutline(const std::vector<Id>& run, bool isLoop) const
{
  double length = 0.0;
  double gaps = 0.0;
  std::size_t count = 0;
  bool areOfOneCell = true;
  for (const Id edge : run)
  {
    length += this->LengthOf(edge);
    gaps += this->IsGap(edge) ? this->LengthOf(edge) : 0.0;
    count += this->IsGap(edge) ? 1 : 0;
    areOfOneCell =
      areOfOneCell && (this->IsGap(edge) || this->CellOf(edge) == this->CellOf(run[0]));
  }
  const bool isOneGap = count == 1 && (isLoop || areOfOneCell);
  const auto areSmall = [length, gaps, isOneGap](const LargestShare& share)
  { return gaps <= (isOneGap ? share.OfOneGap : share.OfSeveral) * length; };
  return areSmall(Elsewhere) || (isLoop && areSmall(AroundWhatIsKept) && this->HasKeptInside(run));
}

/// The outermost of the vertices that are kept are looked at: one that is the first, or the last,
/// along an axis.
bool ClosedGaps::HasKeptInside(const std::vector<Id>& loop) const
{
  std::vector<Point2> outermost;
  const auto isLower = [](const Point2& a, const Point2& b)
  { return a.Y != b.Y ? a.Y < b.Y : a.X < b.X; };
  for (std::size_t e = 0; e < this->IsKept.size(); ++e)
  {
    const Point2& place = this->Drawing.At(this->Drawing.Edges[e].Ends.Start);
    if (this->IsKept[e])
    {
      outermost.resize(4, place);
      outermost = { std::min(outermost[0], place), std::max(outermost[1], place),
        std::min(outermost[2], place, isLower), std::max(outermost[3], place, isLower) };
    }
  }
  return std::any_of(outermost.begin(), outermost.end(),
    [this, &loop](const Point2& place) { return this->IsInside(place, loop); });
}

bool ClosedGaps::IsInside(const Point2& place, const std::vector<Id>& loop) const
{
  bool isInside = false;
  for (const Id edge : loop)
  {
    const SegmentEnds& ends = this->Drawing.Edge(edge).Ends;
    const Point2& a = this->Drawing.At(ends.Start);
    const Point2& b = this->Drawing.At(ends.End);
    const bool isPassed = (a.Y > place.Y) != (b.Y > place.Y);
    isInside ^= isPassed && (Cross(b - a, place - a) > 0.0) == (b.Y > a.Y);
  }
  return isInside;
}

} // namespace

double RefuseOpenDrawing(
  const Arrangement& arrangement, const DomainOptions& options, ProblemList& problems, Pulse& pulse)
{
  const std::vector<OpenEnd> ends =
    PairOpenEnds(arrangement, Flags(arrangement.Edges.size(), 0), pulse);
  const SpacingAtEnds spacing(options, arrangement.Vertices);
  double largest = ends.empty() ? std::numeric_limits<double>::infinity() : 0.0;
  for (const OpenEnd& end : ends)
  {
    const double tolerance = end.Partner == NoId ? std::numeric_limits<double>::infinity()
                                                 : ToleranceOf(end, arrangement, spacing);
    largest = std::max(largest, tolerance);
    problems.Add({ ProblemCode::NoClosedLoop, { arrangement.VertexPoints[end.Vertex] },
      arrangement.At(end.Vertex), end.Partner == NoId ? "" : DetailOf(end.Gap, tolerance) });
  }
  if (ends.empty())
  {
    problems.Add(NothingBounds(arrangement, options.Rule));
  }
  return largest;
}

double RefuseOpenOutlines(const Arrangement& arrangement, const Flags& isKept,
  const DomainOptions& options, ProblemList& problems, Pulse& pulse)
{
  Flags isNoLine;
  for (std::size_t e = 0; e < isKept.size(); ++e)
  {
    const ArrangementEdge& edge = arrangement.Edges[e];
    isNoLine.push_back(isKept[e] || edge.BoundaryCount + edge.OpenCount == 0);
  }
  std::vector<OpenEnd> ends = PairOpenEnds(arrangement, isNoLine, pulse);
  double closing = 0.0;
  while (!ends.empty() && closing == 0.0 && !pulse.HasStopped())
  {
    closing = ClosedGaps(arrangement, isKept, ends).AddProblems(options, problems, pulse);
    // An outline with narrow gaps may hang together with others over a wide one.
    const double widest = ends.front().Gap;
    const auto isNarrower = [widest](const OpenEnd& end) { return end.Gap < widest; };
    ends.erase(ends.begin(), std::find_if(ends.begin(), ends.end(), isNarrower));
    ends.resize(ends.size() > MostTried ? 0 : ends.size());
  }
  return closing;
}

} // namespace biting
