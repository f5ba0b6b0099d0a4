// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "Meetings.h"

#include "../Base/SortInSteps.h"
#include "../Base/Tasks.h"
#include "../Predicates/Predicates.h"
#include "SegmentTree.h"
#include "VertexStars.h"

#include <algorithm> // for unique, any_of, min, max
#include <atomic>    // for what tasks share
#include <cmath>     // for abs
#include <cstddef>   // for size_t
#include <cstdint>   // for masks
#include <tuple>     // for tie

namespace biting
{

namespace
{

// Of the time for clean input.
constexpr double ShareOfPreparing = 0.4;
constexpr double ShareOfTesting = 0.5;

/// Whose pairs are a task: milliseconds.
constexpr std::size_t EdgesOfPart = 2048;

/// With more splits many edges lie along one line: n of them that all overlap have n^2 / 2.
constexpr std::size_t LeastSplits = 1000000;
constexpr std::size_t SplitsOfEdge = 50;

/// The edges of an arrangement, and how they are found.
struct FiledEdges
{
  FiledEdges(const Arrangement& arrangement, Pulse& pulse)
    : Ends(arrangement.EdgeEnds())
    , Stars(arrangement.Vertices, this->Ends, pulse)
    , Tree(arrangement.Vertices, this->Ends, arrangement.Resolution, pulse)
  {
  }

  const std::vector<SegmentEnds> Ends;
  const VertexStars Stars;
  const SegmentTree Tree;
};

/// Which of the places where edges meet the user hears of. Edges are those of the arrangement; the
/// list of reports is added to.
class MeetingReporter
{
public:
  MeetingReporter(const Arrangement& arrangement, std::vector<MeetingReport>& reports)
    : Input(arrangement)
    , Reports(reports)
  {
  }

  /// Faces share parts of edges, and lines run over faces.
  void ReportOverlap(Id first, Id second, Id vertex);

  /// Interfaces may end anywhere; only boundaries that touch are worth a word.
  void ReportTouch(Id edge, Id toucher, Id vertex);

  /// Where what may bound the domain is moved to a vertex near it, one of `other`: by more than
  /// rounding, or to one that a chain passes (`isPassed`). That an interface ends on it but for
  /// rounding, or a point lies on it, is no news.
  void ReportNear(Id edge, Id other, Id vertex, bool isPassed);

  /// Faces on top of each other are told of in another way (CellOverlaps.h), but not what crosses
  /// itself.
  void ReportCrossing(Id first, Id second);

private:
  bool IsNews(Id first, Id second) const;
  bool AreOfOneFace(Id first, Id second) const;
  bool IsBoundary(Id edge) const { return this->Input.Edge(edge).BoundaryCount > 0; }
  bool MayBound(Id edge) const;

  const Arrangement& Input;
  std::vector<MeetingReport>& Reports;
};

void MeetingReporter::ReportOverlap(Id first, Id second, Id vertex)
{
  if (this->IsNews(first, second))
  {
    this->Reports.push_back({ ProblemCode::DuplicateSegments, first, second, vertex });
  }
}

void MeetingReporter::ReportTouch(Id edge, Id toucher, Id vertex)
{
  if (this->IsBoundary(edge) && this->IsBoundary(toucher))
  {
    this->Reports.push_back({ ProblemCode::Touches, edge, toucher, vertex });
  }
}

void MeetingReporter::ReportNear(Id edge, Id other, Id vertex, bool isPassed)
{
  const SegmentEnds& ends = this->Input.Edge(edge).Ends;
  const Point2& start = this->Input.At(ends.Start);
  const Point2& end = this->Input.At(ends.End);
  const Point2& p = this->Input.At(vertex);
  const bool isRounding =
    std::abs(Cross(end - start, p - start)) <= this->Input.Rounding * Distance(start, end);
  const bool isMoved = !isRounding || (isPassed && this->MayBound(other));
  if (this->MayBound(edge) && isMoved && !IsOnSegment(p, start, end))
  {
    this->Reports.push_back({ ProblemCode::NearPoints, edge, other, vertex });
  }
}

void MeetingReporter::ReportCrossing(Id first, Id second)
{
  if (this->IsNews(first, second) || this->AreOfOneFace(first, second))
  {
    this->Reports.push_back({ ProblemCode::Crossings, first, second, NoId });
  }
}

bool MeetingReporter::IsNews(Id first, Id second) const
{
  const bool isOfLines = this->Input.Edge(first).HasLine() && this->Input.Edge(second).HasLine();
  return isOfLines || this->IsBoundary(first) || this->IsBoundary(second);
}

bool MeetingReporter::AreOfOneFace(Id first, Id second) const
{
  const Id face = this->Input.Edge(first).Faces.First();
  return face != NoId && face == this->Input.Edge(second).Faces.First();
}

bool MeetingReporter::MayBound(Id edge) const
{
  return this->IsBoundary(edge) || this->Input.Edge(edge).OpenCount > 0;
}

class MeetingFinder
{
public:
  MeetingFinder(const Arrangement& arrangement, const FiledEdges& edges, std::size_t most,
    Meetings& meetings, Pulse& pulse)
    : Input(arrangement)
    , Most(most)
    , MostSplits(LeastSplits + SplitsOfEdge * edges.Ends.size())
    , Found(meetings)
    , Beats(pulse)
    , Edges(edges)
    , News(arrangement, meetings.Reports)
  {
  }

  void TestEdges();
  void TestStars();
  void TestLooseVertices();

  // For SegmentTree::VisitPairs.
  bool GoesOn();
  void SetFraction(double fraction) { this->Beats.SetFraction(fraction); }
  void operator()(Id first, Id second)
  {
    this->TestApart(std::min(first, second), std::max(first, second));
  }

private:
  void TestPart(std::size_t part, const std::vector<std::uint8_t>& isNew, Meetings& found,
    Monitor& monitor) const;
  void TakeAll(const std::vector<Meetings>& parts);
  void TestApart(Id first, Id second);
  bool IsBeside(const SegmentEnds& ends, const SegmentEnds& other) const;
  void TestStar(Id vertex);
  bool TestFan(Id first, Id second, Id apex, bool tells);

  bool TestVertex(Id edge, Id vertex);
  bool IsOn(Id vertex, Id edge) const;
  bool IsSpike(Id vertex, Id edge) const;
  bool AreOfTwoFaces(Id first, Id second) const;
  void ReportNear(Id edge, Id other, Id vertex)
  {
    this->News.ReportNear(edge, other, vertex, this->Edges.Stars.Degree(vertex) > 1);
  }
  const SegmentEnds& EndsOf(Id edge) const { return this->Edges.Ends[edge]; }

  const Arrangement& Input;
  const std::size_t Most; ///< crossings
  const std::size_t MostSplits;
  Meetings& Found;
  Pulse& Beats;
  const FiledEdges& Edges;
  MeetingReporter News;
};

void MeetingFinder::TestEdges()
{
  std::vector<std::uint8_t> isNew;
  isNew.reserve(this->Input.Edges.size());
  for (const ArrangementEdge& edge : this->Input.Edges)
  {
    isNew.push_back(edge.IsNew);
  }
  std::vector<Meetings> found((this->Edges.Tree.Size() + EdgesOfPart - 1) / EdgesOfPart);
  // Of the parts that are done: no more parts are begun where these are too many together.
  std::atomic<std::size_t> splits{ 0 };
  std::atomic<std::size_t> crossings{ 0 };
  const auto areFew = [this, &splits, &crossings]
  { return splits <= this->MostSplits && crossings <= this->Most; };
  DoTasks(this->Beats, found.size(),
    [this, &isNew, &found, &splits, &crossings, &areFew](std::size_t k, Monitor& monitor)
    {
      if (areFew())
      {
        this->TestPart(k, isNew, found[k], monitor);
        splits += found[k].Splits.size();
        crossings += found[k].Crossings.size();
      }
    });
  if (areFew())
  {
    this->TakeAll(found);
  }
  else if (!this->Beats.HasStopped())
  {
    // Which of them are found before the search is given up should not depend on threads.
    std::vector<Meetings>().swap(found);
    this->Edges.Tree.VisitPairs(isNew, *this);
  }
}

void MeetingFinder::TestPart(
  std::size_t part, const std::vector<std::uint8_t>& isNew, Meetings& found, Monitor& monitor) const
{
  const std::size_t first = part * EdgesOfPart;
  Pulse own(monitor);
  MeetingFinder finder(this->Input, this->Edges, this->Most, found, own);
  this->Edges.Tree.VisitPairsOf(
    first, std::min(first + EdgesOfPart, this->Edges.Tree.Size()), isNew, finder);
}

void MeetingFinder::TakeAll(const std::vector<Meetings>& parts)
{
  const auto append = [](const auto& from, auto& to)
  { to.insert(to.end(), from.begin(), from.end()); };
  for (const Meetings& part : parts)
  {
    append(part.Splits, this->Found.Splits);
    append(part.Crossings, this->Found.Crossings);
    append(part.Reports, this->Found.Reports);
  }
}

/// Whether there is time and room to look for more.
bool MeetingFinder::GoesOn()
{
  Meetings& found = this->Found;
  found.AreTooMany = found.Splits.size() > this->MostSplits || found.Crossings.size() > this->Most;
  return !found.AreTooMany && this->Beats.Beat();
}

/// Two edges without a common end.
void MeetingFinder::TestApart(Id first, Id second)
{
  const SegmentEnds& a = this->EndsOf(first);
  const SegmentEnds& b = this->EndsOf(second);
  if (this->IsBeside(a, b) || this->IsBeside(b, a))
  {
    return;
  }
  const Meeting meeting = Meet(
    this->Input.At(a.Start), this->Input.At(a.End), this->Input.At(b.Start), this->Input.At(b.End));
  Id touched = NoId;
  for (const Id vertex : { b.Start, b.End, a.Start, a.End })
  {
    const Id edge = a.Has(vertex) ? second : first;
    if (this->TestVertex(edge, vertex))
    {
      touched = vertex;
      const Id toucher = edge == first ? second : first;
      if (meeting == Meeting::Touch || meeting == Meeting::Crossing)
      {
        this->News.ReportTouch(edge, toucher, vertex);
      }
      else
      {
        this->ReportNear(edge, toucher, vertex);
      }
    }
  }
  if (touched != NoId && meeting == Meeting::Overlap)
  {
    this->News.ReportOverlap(first, second, touched);
  }
  if (touched == NoId && meeting == Meeting::Crossing)
  {
    this->News.ReportCrossing(first, second);
    this->Found.Crossings.push_back({ first, second });
  }
}

/// Whether `other` lies clearly on one side of the line along `ends`: further than Resolution at
/// both of its ends, so that neither comes near the other anywhere. False where that is uncertain.
///
/// With u the unit roundoff and M the largest coordinate, a cross product of differences is off by
/// at most 4 u times the product of their lengths in the 1-norm; that of the second is below 4 M,
/// and Resolution is 8 u M: the error is below 2 Resolution times the 1-norm of the first.
bool MeetingFinder::IsBeside(const SegmentEnds& ends, const SegmentEnds& other) const
{
  const Point2& origin = this->Input.At(ends.Start);
  const Point2 direction = this->Input.At(ends.End) - origin;
  const double start = Cross(direction, this->Input.At(other.Start) - origin);
  const double end = Cross(direction, this->Input.At(other.End) - origin);
  const double bound =
    4.0 * this->Input.Resolution * (std::abs(direction.X) + std::abs(direction.Y));
  return (start > bound && end > bound) || (start < -bound && end < -bound);
}

void MeetingFinder::TestStars()
{
  const auto isNew = [this](Id edge) { return this->Input.Edge(edge).IsNew; };
  for (Id vertex = 0; vertex < this->Edges.Stars.NumberOfVertices() && this->GoesOn(); ++vertex)
  {
    if (std::any_of(this->Edges.Stars.Begin(vertex), this->Edges.Stars.End(vertex), isNew))
    {
      this->TestStar(vertex);
    }
  }
}

/// From each edge counterclockwise, as long as the next lies along it. The walk passes the end of
/// the star and goes on from its beginning, unless all edges lie along the first.
void MeetingFinder::TestStar(Id vertex)
{
  const Id degree = this->Edges.Stars.Degree(vertex);
  const Id* star = this->Edges.Stars.Begin(vertex);
  Id last = 2 * degree - 1;
  for (Id i = 0; i < degree && this->GoesOn(); ++i)
  {
    Id next = i + 1;
    while (next < std::min(i + degree, last) &&
      this->TestFan(star[i], star[next % degree], vertex, next == i + 1))
    {
      ++next;
    }
    last = i == 0 && next == degree ? degree : last;
  }
}

/// Two edges with the common end `apex`: whether the nearer of their other ends lies on the other.
bool MeetingFinder::TestFan(Id first, Id second, Id apex, bool tells)
{
  const Id a = OtherEnd(this->EndsOf(first), apex);
  const Id b = OtherEnd(this->EndsOf(second), apex);
  const bool isSecondNearer = this->TestVertex(first, b);
  if (!isSecondNearer && !this->TestVertex(second, a))
  {
    return false;
  }
  if (tells && Orient2D(this->Input.At(apex), this->Input.At(a), this->Input.At(b)) == 0)
  {
    this->News.ReportOverlap(
      std::min(first, second), std::max(first, second), isSecondNearer ? b : a);
  }
  else if (tells)
  {
    this->ReportNear(
      isSecondNearer ? first : second, isSecondNearer ? second : first, isSecondNearer ? b : a);
  }
  return true;
}

/// Embedded points that end no edge split the edges on which they lie.
void MeetingFinder::TestLooseVertices()
{
  for (const Id vertex : this->Input.EmbeddedVertices)
  {
    if (this->Edges.Stars.Degree(vertex) > 0 || !this->GoesOn())
    {
      continue;
    }
    const Point2& place = this->Input.At(vertex);
    this->Edges.Tree.Visit(Box2::Around(place, place), SegmentEnds(),
      [this, vertex](Id edge)
      {
        if (this->TestVertex(edge, vertex))
        {
          this->ReportNear(edge, edge, vertex);
        }
      });
  }
}

bool MeetingFinder::TestVertex(Id edge, Id vertex)
{
  const bool isOn = this->IsOn(vertex, edge);
  if (isOn)
  {
    this->Found.Splits.push_back({ edge, vertex });
  }
  return isOn;
}

bool MeetingFinder::IsOn(Id vertex, Id edge) const
{
  const SegmentEnds& ends = this->EndsOf(edge);
  const Point2& p = this->Input.At(vertex);
  const Point2& a = this->Input.At(ends.Start);
  const Point2& b = this->Input.At(ends.End);
  if (Dot(a - p, b - p) >= 0.0)
  {
    return false;
  }
  const double reach = this->Input.ReachAcross(b - a);
  const bool isNear = std::abs(Cross(b - a, p - a)) <= reach && !this->IsSpike(vertex, edge);
  return isNear || IsOnSegment(p, a, b);
}

/// Whether an edge joins the vertex to an end of the edge beside it where nothing else ends: both
/// are the sides of a spike. Thinner than Resolution it stays open, or its tip would be lost. Two
/// faces side by side make no spike, but a slit.
bool MeetingFinder::IsSpike(Id vertex, Id edge) const
{
  const VertexStars& stars = this->Edges.Stars;
  const auto isOtherSide = [this, vertex, edge, &stars](Id side)
  {
    const Id tip = OtherEnd(this->EndsOf(side), vertex);
    return this->EndsOf(edge).Has(tip) && stars.Degree(tip) == 2 &&
      !this->AreOfTwoFaces(edge, side);
  };
  return this->Input.KeepsSpikes && stars.Degree(vertex) > 0 &&
    std::any_of(stars.Begin(vertex), stars.End(vertex), isOtherSide);
}

/// Whether the area that each bounds is that of one face, which has one, and these are two.
bool MeetingFinder::AreOfTwoFaces(Id first, Id second) const
{
  const FaceEdge& a = this->Input.Edge(first).Faces;
  const FaceEdge& b = this->Input.Edge(second).Faces;
  return a.Count == 1 && b.Count == 1 && a.Turn != 0 && b.Turn != 0 && a.First() != b.First();
}

/// Of entries with equal keys the least is kept.
template <typename Entry, typename Key, typename Rest>
bool SortUnique(std::vector<Entry>& entries, Key key, Rest rest, Pulse& pulse)
{
  const auto isBefore = [key, rest](const Entry& a, const Entry& b)
  { return key(a) != key(b) ? key(a) < key(b) : rest(a) < rest(b); };
  if (!SortInSteps(entries, isBefore, pulse))
  {
    return false;
  }
  const auto last = std::unique(entries.begin(), entries.end(),
    [key](const Entry& a, const Entry& b) { return key(a) == key(b); });
  entries.erase(last, entries.end());
  return true;
}

/// A touch is told once for each vertex on an edge, whatever edge brings the vertex.
std::tuple<ProblemCode, Id, Id> MatterOf(const MeetingReport& report)
{
  const bool isTouch =
    report.Code == ProblemCode::Touches || report.Code == ProblemCode::NearPoints;
  return { report.Code, report.First, isTouch ? report.Vertex : report.Second };
}

std::tuple<Id, Id> RestOf(const MeetingReport& report)
{
  return { report.Second, report.Vertex };
}

bool SortMeetings(Meetings& meetings, Pulse& pulse)
{
  const auto none = [](const auto&) { return 0; };
  const auto split = [](const EdgeSplit& s) { return std::make_tuple(s.Edge, s.Vertex); };
  const auto crossing = [](const EdgeCrossing& c) { return std::make_tuple(c.First, c.Second); };
  return SortUnique(meetings.Splits, split, none, pulse) &&
    SortUnique(meetings.Crossings, crossing, none, pulse) &&
    SortUnique(meetings.Reports, MatterOf, RestOf, pulse);
}

} // namespace

bool FindMeetings(
  const Arrangement& arrangement, std::size_t most, Meetings& meetings, Pulse& pulse)
{
  meetings = Meetings();
  const FiledEdges edges(arrangement, pulse);
  MeetingFinder finder(arrangement, edges, most, meetings, pulse);
  {
    PulsePart testing(pulse, ShareOfPreparing, ShareOfPreparing + ShareOfTesting);
    finder.TestEdges();
  }
  pulse.SetFraction(ShareOfPreparing + ShareOfTesting);
  finder.TestStars();
  finder.TestLooseVertices();
  return SortMeetings(meetings, pulse);
}

} // namespace biting
