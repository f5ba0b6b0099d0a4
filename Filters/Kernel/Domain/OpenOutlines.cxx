// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "OpenOutlines.h"

#include "../Base/Box.h"
#include "../Base/DisjointSets.h"
#include "BoundaryComponents.h"
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

/// A vertex at which nothing goes on, and the other one at its gap.
struct OpenEnd
{
  Id Vertex = NoId;
  Id Cell = NoId; ///< of its edge
  Id Partner = NoId;
  double Gap = 0.0;
};

constexpr std::size_t MostEnds = 10000;

/// How many edges end at each vertex, those that are drawn several times as often.
std::vector<Id> Degrees(const Arrangement& arrangement)
{
  std::vector<Id> degrees(arrangement.Vertices.size(), 0);
  for (const ArrangementEdge& edge : arrangement.Edges)
  {
    const Id count = std::max<Id>(1, edge.BoundaryCount + edge.OpenCount + edge.Faces.Count);
    degrees[edge.Ends.Start] += count;
    degrees[edge.Ends.End] += count;
  }
  return degrees;
}

/// Of edges that are not kept, by their vertices.
std::vector<OpenEnd> FindEnds(const Arrangement& arrangement, const Flags& isKept)
{
  const std::vector<Id> degrees = Degrees(arrangement);
  std::vector<OpenEnd> ends;
  for (std::size_t e = 0; e < isKept.size(); ++e)
  {
    const ArrangementEdge& edge = arrangement.Edges[e];
    for (const Id vertex : { edge.Ends.Start, edge.Ends.End })
    {
      if (!isKept[e] && degrees[vertex] == 1 && arrangement.VertexPoints[vertex] != NoId)
      {
        ends.push_back({ vertex, edge.Cell });
      }
    }
  }
  std::sort(ends.begin(), ends.end(),
    [](const OpenEnd& a, const OpenEnd& b) { return a.Vertex < b.Vertex; });
  return ends;
}

/// By number, for each of `ends`, which are sorted along the first axis, the nearest other one.
std::vector<std::size_t> NearestOthers(
  const Arrangement& arrangement, const std::vector<OpenEnd>& ends, Pulse& pulse)
{
  std::vector<std::size_t> nearest;
  for (std::size_t i = 0; i < ends.size() && pulse.Beat(); ++i)
  {
    const Point2& place = arrangement.At(ends[i].Vertex);
    double least = std::numeric_limits<double>::infinity();
    nearest.push_back(i);
    const auto look = [&arrangement, &ends, &place, &least, &nearest](std::size_t other)
    {
      const Point2& there = arrangement.At(ends[other].Vertex);
      const double distance = Distance(place, there);
      if (distance < least)
      {
        least = distance;
        nearest.back() = other;
      }
      return std::abs(there.X - place.X) <= least;
    };
    for (std::size_t below = i; below > 0 && look(below - 1); --below)
    {
    }
    for (std::size_t above = i + 1; above < ends.size() && look(above); ++above)
    {
    }
  }
  return nearest;
}

/// Those that are the nearest of each other become partners, then those of the rest, and so on.
void FindPartners(const Arrangement& arrangement, std::vector<OpenEnd>& ends, Pulse& pulse)
{
  std::vector<OpenEnd> left = ends;
  std::sort(left.begin(), left.end(),
    [&arrangement](const OpenEnd& a, const OpenEnd& b)
    { return arrangement.At(a.Vertex) < arrangement.At(b.Vertex); });
  std::vector<OpenEnd> done;
  while (left.size() > 1 && left.size() <= MostEnds && !pulse.HasStopped())
  {
    const std::vector<std::size_t> nearest = NearestOthers(arrangement, left, pulse);
    std::vector<OpenEnd> rest;
    for (std::size_t i = 0; i < nearest.size(); ++i)
    {
      const bool isPair = nearest[nearest[i]] == i;
      OpenEnd& end = left[i];
      end.Partner = isPair ? left[nearest[i]].Vertex : NoId;
      end.Gap = isPair ? Distance(arrangement.At(end.Vertex), arrangement.At(end.Partner)) : 0.0;
      (isPair ? done : rest).push_back(end);
    }
    if (rest.size() == left.size())
    {
      break;
    }
    left.swap(rest);
  }
  done.insert(done.end(), left.begin(), left.end());
  ends.swap(done);
}

/// The vertices at which an odd number of the edges of a cell end, by cells; of those of the ends.
std::vector<std::pair<Id, Id>> EndsOfCells(
  const Arrangement& arrangement, const std::vector<OpenEnd>& ends)
{
  std::vector<Id> wanted;
  wanted.reserve(ends.size());
  for (const OpenEnd& end : ends)
  {
    wanted.push_back(end.Cell);
  }
  std::sort(wanted.begin(), wanted.end());
  std::vector<std::pair<Id, Id>> places;
  for (const ArrangementEdge& edge : arrangement.Edges)
  {
    if (std::binary_search(wanted.begin(), wanted.end(), edge.Cell))
    {
      places.emplace_back(edge.Cell, edge.Ends.Start);
      places.emplace_back(edge.Cell, edge.Ends.End);
    }
  }
  std::sort(places.begin(), places.end());
  std::vector<std::pair<Id, Id>> odd;
  for (const std::pair<Id, Id>& place : places)
  {
    const bool isSecond = !odd.empty() && odd.back() == place;
    isSecond ? odd.pop_back() : odd.push_back(place);
  }
  return odd;
}

void PreferOwnCell(const Arrangement& arrangement, std::vector<OpenEnd>& ends)
{
  const std::vector<std::pair<Id, Id>> endsOfCells = EndsOfCells(arrangement, ends);
  for (OpenEnd& end : ends)
  {
    const std::pair<Id, Id> lowest(end.Cell, NoId);
    const auto first = std::lower_bound(endsOfCells.begin(), endsOfCells.end(), lowest);
    const bool areTwo = endsOfCells.end() - first >= 2 && first[1].first == end.Cell &&
      (endsOfCells.end() - first == 2 || first[2].first != end.Cell);
    const Id other = areTwo ? first[first->second == end.Vertex ? 1 : 0].second : NoId;
    const double gap =
      areTwo ? Distance(arrangement.At(end.Vertex), arrangement.At(other)) : end.Gap;
    if (areTwo && (end.Partner == NoId || gap < end.Gap))
    {
      end.Partner = other;
      end.Gap = gap;
    }
  }
}

/// The open ends of edges that are not `isKept`, those with the widest gaps first.
///
/// The two that are nearest to each other are partners, then the two of the rest, and so on; where
/// more than 10000 ends are open they have none. Where the other end of the same cell is nearer, it
/// is the partner: what else ends there, it is not open.
std::vector<OpenEnd> PairOpenEnds(
  const Arrangement& arrangement, const std::vector<std::uint8_t>& isKept, Pulse& pulse)
{
  std::vector<OpenEnd> ends = FindEnds(arrangement, isKept);
  FindPartners(arrangement, ends, pulse);
  PreferOwnCell(arrangement, ends);
  std::sort(ends.begin(), ends.end(),
    [](const OpenEnd& a, const OpenEnd& b)
    { return a.Gap != b.Gap ? a.Gap > b.Gap : a.Vertex < b.Vertex; });
  return ends;
}

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
