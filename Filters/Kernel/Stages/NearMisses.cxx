// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "NearMisses.h"

#include "../Base/DistanceToSegment.h"
#include "../Base/Numbers.h"
#include "../Biting/Spokes.h"
#include "../Domain/PointWelding.h" // for places of points
#include "../Domain/SegmentTree.h"
#include "../Domain/VertexStars.h" // for the other end
#include "StageProblems.h"

#include <algorithm> // for max, min
#include <map>       // for what is found
#include <tuple>     // for tie

namespace biting
{

namespace
{

constexpr double ShareOfSpacing = 0.01;
constexpr double ShareOfLength = 0.0175; // the tangent of 1 degree

/// Below that share of f the mesh is not refined around short segments (FeatureSize.cxx): a segment
/// that short is a near miss of its ends.
constexpr double ShareOfShort = 0x1p-23;

/// Points move when they are merged: by less than they are apart.
constexpr double RoomToMerge = 2.0;

/// A way along a chain that is not longer than so many distances is the drawing's own: the corner
/// is no sharper than 5 degrees.
constexpr double MostWay = 12.0;

/// What a vertex nearly meets.
struct NearMiss
{
  double Distance;
  Id Own;   ///< a segment at the vertex, or the vertex as an embedded point
  Id Other; ///< the same of what it nearly meets

  bool IsBefore(const NearMiss& other) const
  {
    return std::tie(this->Distance, this->Own, this->Other) <
      std::tie(other.Distance, other.Own, other.Other);
  }
};

struct NearMisses
{
  std::map<Id, NearMiss> Nearest; ///< by vertex
  double Largest = 0.0;           ///< distance, also of those that are not the nearest
};

/// Segments after the domain's own are embedded points, whose length is no measure.
class NearMissSearch
{
public:
  NearMissSearch(const Domain& domain, const Spacing& spacing, Pulse& pulse)
    : Geometry(domain)
    , F(spacing)
    , Beats(pulse)
    , Segments(SegmentsAndPoints(domain))
    , Spokes(domain)
  {
  }

  void Run()
  {
    this->FindReach();
    const SegmentTree tree(
      this->Geometry.Vertices, this->Segments, { this->Reach, ShareOfLength }, this->Beats);
    if (!this->Beats.HasStopped())
    {
      tree.VisitPairs(std::vector<std::uint8_t>(this->Segments.size(), 1), *this);
      this->AddShort();
      this->TestTriangles();
    }
  }

  const NearMisses& Found() const { return this->Misses; }
  const std::vector<SegmentEnds>& AllSegments() const { return this->Segments; }

  // For a SegmentTree.
  bool GoesOn() { return this->Beats.Beat(); }
  void SetFraction(double) {}
  void operator()(Id first, Id second)
  {
    const double reach = std::min(this->ReachOf(first), this->ReachOf(second));
    this->TestVertex(this->Segments[first].Start, first, second, reach);
    this->TestVertex(this->Segments[first].End, first, second, reach);
    this->TestVertex(this->Segments[second].Start, second, first, reach);
    this->TestVertex(this->Segments[second].End, second, first, reach);
  }

private:
  void FindReach()
  {
    for (Id vertex = 0; vertex < this->Geometry.NumberOfVertices() && this->Beats.Beat(); ++vertex)
    {
      this->Reach = std::max(this->Reach, ShareOfSpacing * this->GivenAt(this->At(vertex)));
    }
  }

  double ReachOf(Id segment) const
  {
    const SegmentEnds& ends = this->Segments[segment];
    return ends.Start == ends.End
      ? Infinity
      : ShareOfLength * Distance(this->At(ends.Start), this->At(ends.End));
  }

  void TestVertex(Id vertex, Id own, Id other, double reach)
  {
    const Point2& place = this->At(vertex);
    const double distance = Distance(place, this->NearestOf(other, place));
    if (distance < reach && distance < ShareOfSpacing * this->GivenAt(place) &&
      (!this->AreJoined(vertex, other, MostWay * distance) ||
        this->AreAlong(vertex, own, other, 0.5 * reach)))
    {
      this->Add(vertex, { distance, own, other });
    }
  }

  void AddShort()
  {
    for (Id segment = 0; segment < this->Geometry.NumberOfSegments() && this->Beats.Beat();
         ++segment)
    {
      const Id start = this->Geometry.Starts[segment];
      const double length = Distance(this->At(start), this->At(this->Geometry.Ends[segment]));
      if (ShareOfSpacing * length < ShareOfShort * this->Reach &&
        length < ShareOfShort * this->GivenAt(this->At(start)))
      {
        this->Add(start, { length, segment, segment });
      }
    }
  }

  void TestTriangles()
  {
    for (Id vertex = 0; vertex < this->Geometry.NumberOfVertices() && this->Beats.Beat(); ++vertex)
    {
      for (const SharpSector& sector : this->Spokes.SharpSectorsAt(vertex))
      {
        this->TestTriangle(vertex, sector);
      }
    }
  }

  /// Where the end of the shorter side is joined with that of the longer one.
  void TestTriangle(Id apex, const SharpSector& sector)
  {
    if (Cross(sector.First.Direction, sector.Last.Direction) >= ShareOfLength)
    {
      return;
    }
    const bool isFirst =
      Distance(this->At(apex), sector.First.End) < Distance(this->At(apex), sector.Last.End);
    const Spoke& side = isFirst ? sector.First : sector.Last;
    const Spoke& base = isFirst ? sector.Last : sector.First;
    const Id tip = OtherEnd(this->Segments[side.Segment], apex);
    const double distance = Distance(side.End, this->NearestOf(base.Segment, side.End));
    const double most =
      std::min(this->ReachOf(side.Segment), ShareOfSpacing * this->GivenAt(side.End));
    for (const Spoke& third : this->Spokes.Around(tip))
    {
      if (third.End == base.End && distance < std::min(most, this->ReachOf(third.Segment)))
      {
        this->Add(tip, { distance, side.Segment, base.Segment });
      }
    }
  }

  /// Whether a chain leads from the vertex to an end of the other segment, on a way no longer than
  /// `most`.
  bool AreJoined(Id vertex, Id other, double most) const
  {
    for (const Spoke& first : this->Spokes.Around(vertex))
    {
      Id segment = first.Segment;
      Id place = vertex;
      double way = 0.0;
      for (bool goesOn = true; goesOn;)
      {
        const Id next = OtherEnd(this->Segments[segment], place);
        way += Distance(this->At(place), this->At(next));
        if (way <= most && this->Segments[other].Has(next))
        {
          return true;
        }
        const std::vector<Spoke> spokes = this->Spokes.Around(next);
        goesOn = way <= most && spokes.size() == 2;
        segment = goesOn && spokes[0].Segment == segment ? spokes[1].Segment : spokes[0].Segment;
        place = next;
      }
    }
    return false;
  }

  /// Whether the middle of the shorter one is that near, through the domain: sides of a thin part.
  bool AreAlong(Id vertex, Id own, Id other, double most) const
  {
    if (std::max(own, other) >= this->Geometry.NumberOfSegments())
    {
      return false;
    }
    const double way = 0.5 * std::min(this->ReachOf(own), this->ReachOf(other));
    const Point2& start = this->At(vertex);
    const Point2 middle =
      start + way / this->ReachOf(own) * (this->At(OtherEnd(this->Segments[own], vertex)) - start);
    const Point2 gap = this->NearestOf(other, middle) - middle;
    const SegmentEnds& ends = this->Segments[own];
    const bool isLeft = Cross(this->At(ends.End) - this->At(ends.Start), gap) > 0.0;
    return Length(gap) < most &&
      (isLeft ? this->Geometry.LeftInside : this->Geometry.RightInside)[own] != 0;
  }

  void Add(Id vertex, const NearMiss& miss)
  {
    NearMiss& nearest = this->Misses.Nearest.emplace(vertex, miss).first->second;
    nearest = miss.IsBefore(nearest) ? miss : nearest;
    this->Misses.Largest = std::max(this->Misses.Largest, miss.Distance);
  }

  /// f as it is given, and no more than the domain is large.
  double GivenAt(const Point2& place) const
  {
    return std::min(this->F.BeforeFeatures(place), this->Geometry.Bounds.Diagonal());
  }
  Point2 NearestOf(Id segment, const Point2& p) const
  {
    return NearestOnSegment(
      p, this->At(this->Segments[segment].Start), this->At(this->Segments[segment].End));
  }
  const Point2& At(Id vertex) const { return this->Geometry.Vertices[vertex]; }

  const Domain& Geometry;
  const Spacing& F;
  Pulse& Beats;
  const std::vector<SegmentEnds> Segments;
  const SpokesOfVertices Spokes;
  NearMisses Misses;
  double Reach = 0.0; ///< the largest
};

/// The diagonal of the box that MergeTolerance is relative to.
double DiagonalOf(const Polylines& input)
{
  Box2 box;
  for (const Id point : input.Connectivity)
  {
    box.Add(PlaceOf(input, point));
  }
  return box.Diagonal();
}

/// A cell that uses each point.
std::vector<Id> CellsOfPoints(const Polylines& input)
{
  std::vector<Id> cells(input.Points.size(), NoId);
  for (Id chain = 0; chain < input.NumberOfChains(); ++chain)
  {
    for (Id k = input.Offsets[chain]; k < input.Offsets[chain + 1]; ++k)
    {
      cells[input.Connectivity[k]] = input.Cells[chain];
    }
  }
  return cells;
}

} // namespace

void ReportNearMisses(const Domain& domain, const Spacing& spacing, const Polylines& input,
  ProblemList& problems, Pulse& pulse)
{
  NearMissSearch search(domain, spacing, pulse);
  search.Run();
  const double largest = std::max(search.Found().Largest, domain.Resolution);
  const std::map<Id, NearMiss>& found = search.Found().Nearest;
  if (found.empty() || pulse.HasStopped())
  {
    return;
  }
  double smallest = Infinity;
  for (const auto& [vertex, miss] : found)
  {
    smallest = std::min(smallest, miss.Distance);
  }
  const std::vector<Id> cellsOfPoints = CellsOfPoints(input);
  const auto cellOf = [&domain, &search, &cellsOfPoints](Id segment)
  {
    return segment < domain.NumberOfSegments()
      ? domain.Cells[segment]
      : cellsOfPoints[domain.VertexPoints[search.AllSegments()[segment].Start]];
  };
  const std::string summary = Figure(smallest) + " to " + Figure(largest) +
    " apart; Merge Tolerance " + FigureAbove(RoomToMerge * largest / DiagonalOf(input)) +
    " joins them";
  for (const auto& [vertex, miss] : found)
  {
    problems.Add(
      { ProblemCode::NearMisses, { cellOf(miss.Own), cellOf(miss.Other) }, domain.Vertices[vertex],
        problems.Has(ProblemCode::NearMisses) ? Figure(miss.Distance) + " apart" : summary });
  }
}

} // namespace biting
