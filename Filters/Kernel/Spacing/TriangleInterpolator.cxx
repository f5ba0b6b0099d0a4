// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleInterpolator.h"

#include "../Base/Tasks.h"
#include "TriangleEdges.h"

#include <algorithm> // for min, max
#include <limits>    // for infinity
#include <utility>   // for swap

namespace biting
{
namespace
{

std::size_t PointOf(const Id* corners, std::size_t corner)
{
  return static_cast<std::size_t>(corners[corner]);
}

TriangleBuckets::Corners PointsOf(const TriangulatedSource& source, const Id* corners)
{
  return { source.Points[PointOf(corners, 0)], source.Points[PointOf(corners, 1)],
    source.Points[PointOf(corners, 2)] };
}

/// A triangle too thin for its area to be seen is no source; its neighbors stand for it.
bool IsUsable(const TriangulatedSource& source, const Id* corners)
{
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    if (std::isnan(source.Values[PointOf(corners, corner)]))
    {
      return false;
    }
  }
  const TriangleBuckets::Corners points = PointsOf(source, corners);
  return std::isnormal(Cross(points[1] - points[0], points[2] - points[0]));
}

/// The corners of triangles that are a source.
std::vector<Id> UsableCorners(const TriangulatedSource& source, Pulse& pulse)
{
  std::vector<Id> usable;
  usable.reserve(source.Triangles.size());
  pulse.ForEach(source.Triangles.size() / 3,
    [&source, &usable](std::size_t triangle)
    {
      const Id* corners = &source.Triangles[3 * triangle];
      if (IsUsable(source, corners))
      {
        usable.insert(usable.end(), corners, corners + 3);
      }
    });
  return usable;
}

std::vector<TriangleBuckets::Corners> PointsOfAll(
  const TriangulatedSource& source, const std::vector<Id>& corners)
{
  std::vector<TriangleBuckets::Corners> points;
  points.reserve(corners.size() / 3);
  for (std::size_t first = 0; first < corners.size(); first += 3)
  {
    points.push_back(PointsOf(source, &corners[first]));
  }
  return points;
}

std::vector<Id> Counterclockwise(const TriangulatedSource& source, std::vector<Id> corners)
{
  for (std::size_t first = 0; first < corners.size(); first += 3)
  {
    const TriangleBuckets::Corners places = PointsOf(source, &corners[first]);
    if (Cross(places[1] - places[0], places[2] - places[0]) < 0.0)
    {
      std::swap(corners[first + 1], corners[first + 2]);
    }
  }
  return corners;
}

/// The edges with triangles on one side only, in the order of their ends.
std::vector<BorderEdge> FindBorder(
  const TriangulatedSource& source, const std::vector<Id>& corners, Pulse& pulse)
{
  std::vector<BorderEdge> border;
  const TriangleEdges edges(Counterclockwise(source, corners), source.Points.size(), pulse);
  pulse.ForEach(source.Points.size(),
    [&source, &edges, &border](std::size_t start)
    {
      for (std::size_t edge = edges.FirstAt(start); edge < edges.FirstAt(start + 1); ++edge)
      {
        if (edges.IsBorder(edge))
        {
          const auto end = static_cast<std::size_t>(edges.HighEnd(edge));
          border.push_back({ source.Points[start], source.Points[end], source.Values[start],
            source.Values[end], static_cast<Id>(start), static_cast<Id>(end) });
        }
      }
    });
  return border;
}

} // namespace

TriangleInterpolator::TriangleInterpolator(const TriangulatedSource& source, Monitor& monitor)
  : MayOverlap(source.MayOverlap)
{
  Pulse pulse(monitor);
  const std::vector<Id> usable = UsableCorners(source, pulse);
  if (usable.empty() || pulse.HasStopped())
  {
    return;
  }
  const auto makeBuckets = [this, &source, &usable](Pulse& own)
  { this->Buckets = std::make_unique<TriangleBuckets>(PointsOfAll(source, usable), own); };
  const auto makeBorder = [this, &source, &usable](Pulse& own)
  { this->Border = BorderTree(FindBorder(source, usable, own), own); };
  if (DoEach(pulse, { makeBuckets, makeBorder }))
  {
    this->MakeRecords(source, usable, pulse);
  }
}

void TriangleInterpolator::MakeRecords(
  const TriangulatedSource& source, const std::vector<Id>& usable, Pulse& pulse)
{
  std::vector<Id> recordOf(usable.size() / 3, NoId);
  Id count = 0;
  this->Buckets->ForEachEntry(
    [&recordOf, &count, &pulse](Id& entry)
    {
      pulse.Beat(1);
      Id& record = recordOf[static_cast<std::size_t>(entry)];
      record = record == NoId ? count++ : record;
      entry = record;
    });
  this->Records.resize(static_cast<std::size_t>(count));
  ForEachAtOnce(pulse, recordOf.size(),
    [this, &source, &usable, &recordOf](std::size_t triangle)
    {
      if (recordOf[triangle] != NoId)
      {
        this->Records[static_cast<std::size_t>(recordOf[triangle])] =
          MakeRecord(source, &usable[3 * triangle]);
      }
    });
}

TriangleInterpolator::Record TriangleInterpolator::MakeRecord(
  const TriangulatedSource& source, const Id* corners)
{
  const std::vector<Point2>& places = source.Points;
  const std::vector<double>& values = source.Values;
  const Point2& origin = places[PointOf(corners, 0)];
  const Point2 first = places[PointOf(corners, 1)] - origin;
  const Point2 second = places[PointOf(corners, 2)] - origin;
  const double area = Cross(first, second);
  return { origin, { second.Y / area, -second.X / area }, { -first.Y / area, first.X / area },
    values[PointOf(corners, 0)], values[PointOf(corners, 1)], values[PointOf(corners, 2)] };
}

double TriangleInterpolator::operator()(const Point2& x) const
{
  return this->Nearest(x).Value;
}

NearestValue TriangleInterpolator::Unknown()
{
  return { std::numeric_limits<double>::infinity(), 0.0 };
}

NearestValue TriangleInterpolator::Nearest(const Point2& x, const NearestValue& known) const
{
  const Record* record = this->FindRecord(x, this->MayOverlap);
  return record ? NearestValue{ 0.0, ValueAt(*record, x), x } : this->NearestOutside(x, known);
}

/// The one with the least value, or any one.
const TriangleInterpolator::Record* TriangleInterpolator::FindRecord(
  const Point2& x, bool isLeast) const
{
  const Record* least = nullptr;
  for (Id id : this->Buckets->Near(x))
  {
    const Record& record = this->Records[static_cast<std::size_t>(id)];
    const Point2 offset = x - record.Origin;
    const double first = Dot(record.FirstWeight, offset);
    const double second = Dot(record.SecondWeight, offset);
    const bool isHere = first >= 0.0 && second >= 0.0 && first + second <= 1.0;
    if (isHere && !isLeast)
    {
      return &record;
    }
    least = isHere && (!least || ValueAt(record, x) < ValueAt(*least, x)) ? &record : least;
  }
  return least;
}

/// By weights: differences of values would cancel what is beside a fill value.
double TriangleInterpolator::ValueAt(const Record& record, const Point2& x)
{
  const Point2 offset = x - record.Origin;
  const double first = Dot(record.FirstWeight, offset);
  const double second = Dot(record.SecondWeight, offset);
  const double origin = std::max(1.0 - first - second, 0.0);
  return origin * record.Value + first * record.FirstValue + second * record.SecondValue;
}

/// The nearest point of the border is the answer outside; a triangle that is nearer yet closes a
/// gap between triangles, which is there by rounding. Those of the bucket come first: then the
/// border is searched nearby only.
NearestValue TriangleInterpolator::NearestOutside(const Point2& x, const NearestValue& known) const
{
  constexpr double NearerThanRounding = 1.0 - 1e-9;
  NearestValue best{ Unknown().Distance, this->Records.front().Value,
    this->Records.front().Origin };
  if (known.Distance > 0.0 && std::isfinite(known.Distance))
  {
    best = known;
    best.Distance = Distance(x, known.Foot);
  }
  NearestValue triangle = Unknown();
  for (Id id : this->Buckets->Near(x))
  {
    const NearestValue found = NearestOnTriangle(this->Records[static_cast<std::size_t>(id)], x);
    triangle = found.Distance < triangle.Distance ? found : triangle;
  }
  NearestValue border = best;
  border.Distance = std::min(best.Distance, triangle.Distance / NearerThanRounding);
  const double limit = border.Distance;
  border = this->Border.Nearest(x, border);
  best = border.Distance < limit ? border : best;
  return triangle.Distance < NearerThanRounding * best.Distance ? triangle : best;
}

/// For x outside the triangle. The rows of weights, inverted, give back its edges.
NearestValue TriangleInterpolator::NearestOnTriangle(const Record& record, const Point2& x)
{
  const double area = 1.0 / Cross(record.FirstWeight, record.SecondWeight);
  const Point2 origin = record.Origin;
  const Point2 first = origin - area * Perpendicular(record.SecondWeight);
  const Point2 second = origin + area * Perpendicular(record.FirstWeight);
  const BorderEdge edges[3] = { { origin, first, record.Value, record.FirstValue },
    { first, second, record.FirstValue, record.SecondValue },
    { second, origin, record.SecondValue, record.Value } };
  NearestValue best = NearestOnEdge(edges[0], x);
  for (const BorderEdge& edge : { edges[1], edges[2] })
  {
    const NearestValue found = NearestOnEdge(edge, x);
    best = found.Distance < best.Distance ? found : best;
  }
  return best;
}

} // namespace biting
