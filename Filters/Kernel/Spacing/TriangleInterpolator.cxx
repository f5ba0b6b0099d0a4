// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleInterpolator.h"

#include "../Base/Pulse.h"

#include <algorithm> // for min, max, sort, upper_bound
#include <limits>    // for infinity
#include <numeric>   // for partial_sum

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

std::vector<const Id*> UsableTriangles(const TriangulatedSource& source, Pulse& pulse)
{
  std::vector<const Id*> usable;
  usable.reserve(source.Triangles.size() / 3);
  for (std::size_t first = 0; first + 2 < source.Triangles.size() && pulse.Beat(); first += 3)
  {
    if (IsUsable(source, &source.Triangles[first]))
    {
      usable.push_back(&source.Triangles[first]);
    }
  }
  return usable;
}

std::vector<TriangleBuckets::Corners> CornersOf(
  const TriangulatedSource& source, const std::vector<const Id*>& triangles)
{
  std::vector<TriangleBuckets::Corners> corners;
  corners.reserve(triangles.size());
  for (const Id* triangle : triangles)
  {
    corners.push_back(PointsOf(source, triangle));
  }
  return corners;
}

/// Calls visit(low, high) for every edge of every triangle, with the smaller id of its ends first.
template <typename Visitor>
void ForEachEdge(const std::vector<const Id*>& triangles, Pulse& pulse, const Visitor& visit)
{
  for (std::size_t triangle = 0; triangle < triangles.size() && pulse.Beat(1); ++triangle)
  {
    const Id* corners = triangles[triangle];
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const Id start = corners[corner];
      const Id end = corners[(corner + 1) % 3];
      visit(static_cast<std::size_t>(std::min(start, end)), std::max(start, end));
    }
  }
}

/// Edges by the smaller id of their ends: for point p the larger ids stand in Ends from Offsets[p]
/// on, as often as triangles share the edge.
struct EdgesByPoint
{
  std::vector<std::size_t> Offsets;
  std::vector<Id> Ends;
};

EdgesByPoint Distribute(
  const std::vector<const Id*>& triangles, std::size_t numberOfPoints, Pulse& pulse)
{
  EdgesByPoint edges;
  edges.Offsets.assign(numberOfPoints + 1, 0);
  edges.Ends.resize(3 * triangles.size());
  ForEachEdge(triangles, pulse, [&edges](std::size_t low, Id) { ++edges.Offsets[low]; });
  std::partial_sum(edges.Offsets.begin(), edges.Offsets.end(), edges.Offsets.begin());
  ForEachEdge(triangles, pulse,
    [&edges](std::size_t low, Id high) { edges.Ends[--edges.Offsets[low]] = high; });
  return edges;
}

/// The edges that belong to one triangle only, in the order of their ends.
std::vector<BorderEdge> FindBorder(
  const TriangulatedSource& source, const std::vector<const Id*>& triangles, Pulse& pulse)
{
  EdgesByPoint edges = Distribute(triangles, source.Points.size(), pulse);
  std::vector<BorderEdge> border;
  for (std::size_t low = 0; low < source.Points.size() && pulse.Beat(1); ++low)
  {
    const auto end = edges.Ends.begin() + static_cast<std::ptrdiff_t>(edges.Offsets[low + 1]);
    auto first = edges.Ends.begin() + static_cast<std::ptrdiff_t>(edges.Offsets[low]);
    std::sort(first, end);
    while (first != end)
    {
      const auto next = std::upper_bound(first, end, *first);
      if (next - first == 1)
      {
        const auto high = static_cast<std::size_t>(*first);
        border.push_back({ source.Points[low], source.Points[high], source.Values[low],
          source.Values[high], static_cast<Id>(low), static_cast<Id>(high) });
      }
      first = next;
    }
  }
  return border;
}

} // namespace

TriangleInterpolator::TriangleInterpolator(const TriangulatedSource& source, Monitor& monitor)
  : MayOverlap(source.MayOverlap)
{
  Pulse pulse(monitor);
  const std::vector<const Id*> usable = UsableTriangles(source, pulse);
  if (usable.empty() || pulse.HasStopped())
  {
    return;
  }
  this->Buckets = std::make_unique<TriangleBuckets>(CornersOf(source, usable), pulse);
  this->Border = BorderTree(FindBorder(source, usable, pulse), pulse);
  this->Records.reserve(usable.size());
  std::vector<Id> recordOf(usable.size(), NoId);
  this->Buckets->ForEachEntry(
    [this, &source, &usable, &recordOf, &pulse](Id& entry)
    {
      pulse.Beat();
      const auto triangle = static_cast<std::size_t>(entry);
      if (recordOf[triangle] == NoId)
      {
        recordOf[triangle] = static_cast<Id>(this->Records.size());
        this->Records.push_back(MakeRecord(source, usable[triangle]));
      }
      entry = recordOf[triangle];
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
    values[PointOf(corners, 0)], values[PointOf(corners, 1)], values[PointOf(corners, 2)],
    static_cast<Id>((corners - source.Triangles.data()) / 3) };
}

double TriangleInterpolator::operator()(const Point2& x) const
{
  return this->Find(x).Value;
}

TriangleInterpolator::Place TriangleInterpolator::Find(const Point2& x) const
{
  const Record* record = this->FindRecord(x);
  NearestValue nearest{ 0.0, 0.0, x };
  const bool isOutside = !record;
  if (isOutside)
  {
    nearest = this->NearestOutside(x, Unknown(), record);
  }
  if (!record)
  {
    return { nearest.Value, NoId, {}, { nearest.StartId, nearest.EndId } };
  }
  const Point2 offset = nearest.Foot - record->Origin;
  double first = Dot(record->FirstWeight, offset);
  double second = Dot(record->SecondWeight, offset);
  if (isOutside)
  {
    // Of a triangle whose height is rounding, weights beside it may be anything.
    first = std::min(std::max(first, 0.0), 1.0);
    second = std::min(std::max(second, 0.0), 1.0 - first);
  }
  const double origin = std::max(1.0 - first - second, 0.0);
  return { origin * record->Value + first * record->FirstValue + second * record->SecondValue,
    record->Triangle, { origin, first, second }, { NoId, NoId } };
}

NearestValue TriangleInterpolator::Unknown()
{
  return { std::numeric_limits<double>::infinity(), 0.0 };
}

NearestValue TriangleInterpolator::Nearest(const Point2& x, const NearestValue& known) const
{
  const Record* record = this->FindRecord(x);
  return record ? NearestValue{ 0.0, ValueAt(*record, x), x }
                : this->NearestOutside(x, known, record);
}

const TriangleInterpolator::Record* TriangleInterpolator::FindRecord(const Point2& x) const
{
  const Record* least = nullptr;
  for (Id id : this->Buckets->Near(x))
  {
    const Record& record = this->Records[static_cast<std::size_t>(id)];
    const Point2 offset = x - record.Origin;
    const double first = Dot(record.FirstWeight, offset);
    const double second = Dot(record.SecondWeight, offset);
    const bool isHere = first >= 0.0 && second >= 0.0 && first + second <= 1.0;
    if (isHere && !this->MayOverlap)
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
NearestValue TriangleInterpolator::NearestOutside(
  const Point2& x, const NearestValue& known, const Record*& closed) const
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
  const Record* record = nullptr;
  for (Id id : this->Buckets->Near(x))
  {
    const NearestValue found = NearestOnTriangle(this->Records[static_cast<std::size_t>(id)], x);
    if (found.Distance < triangle.Distance)
    {
      triangle = found;
      record = &this->Records[static_cast<std::size_t>(id)];
    }
  }
  NearestValue border = best;
  border.Distance = std::min(best.Distance, triangle.Distance / NearerThanRounding);
  const double limit = border.Distance;
  border = this->Border.Nearest(x, border);
  best = border.Distance < limit ? border : best;
  if (triangle.Distance < NearerThanRounding * best.Distance)
  {
    closed = record;
    return triangle;
  }
  return best;
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
