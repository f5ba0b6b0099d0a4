// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleInterpolator.h"

#include "../Base/Numbers.h"
#include "../Base/Tasks.h"
#include "TriangleEdges.h"

#include <algorithm> // for min, max, none_of
#include <utility>   // for move

namespace biting
{
namespace
{

std::size_t PointOf(const Id* corners, std::size_t corner)
{
  return static_cast<std::size_t>(corners[corner]);
}

/// Twice the area, negative where it is clockwise.
double TurnOf(const TriangulatedSource& source, const Id* corners)
{
  const Point2& origin = source.Points[PointOf(corners, 0)];
  return Cross(
    source.Points[PointOf(corners, 1)] - origin, source.Points[PointOf(corners, 2)] - origin);
}

/// The corners of triangles that are a source, counterclockwise. One too thin for its area to be
/// seen is none; its neighbors stand for it.
std::vector<Id> UsableCorners(const TriangulatedSource& source, Pulse& pulse)
{
  std::vector<Id> usable;
  usable.reserve(source.Triangles.size());
  const auto isHole = [&source](Id point)
  { return std::isnan(source.Values[static_cast<std::size_t>(point)]); };
  pulse.ForEach(source.Triangles.size() / 3,
    [&source, &usable, &isHole](std::size_t triangle)
    {
      const Id* corners = &source.Triangles[3 * triangle];
      const double turn = TurnOf(source, corners);
      if (std::isnormal(turn) && std::none_of(corners, corners + 3, isHole))
      {
        usable.insert(
          usable.end(), { corners[0], corners[turn < 0.0 ? 2 : 1], corners[turn < 0.0 ? 1 : 2] });
      }
    });
  return usable;
}

/// The edges with triangles on one side only, in the order of their ends.
std::vector<BorderEdge> FindBorder(
  const TriangulatedSource& source, const std::vector<Id>& corners, Pulse& pulse)
{
  std::vector<BorderEdge> border;
  const TriangleEdges edges(corners, source.Points.size(), pulse);
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

TriangleInterpolator::TriangleInterpolator(
  std::shared_ptr<const TriangulatedSource> source, Monitor& monitor)
  : Source(std::move(source))
{
  Pulse pulse(monitor);
  this->Corners = UsableCorners(*this->Source, pulse);
  if (this->Corners.empty() || pulse.HasStopped())
  {
    return;
  }
  const auto makeBuckets = [this](Pulse& own)
  { this->Buckets = std::make_unique<TriangleBuckets>(this->Source->Points, this->Corners, own); };
  const auto makeBorder = [this](Pulse& own)
  { this->Border = BorderTree(FindBorder(*this->Source, this->Corners, own), own); };
  DoEach(pulse, { makeBuckets, makeBorder });
}

double TriangleInterpolator::operator()(const Point2& x) const
{
  const std::optional<double> value = this->FindValue(x, this->HasOverlaps());
  return value ? *value : this->ValueOutside(x);
}

/// The least one of the triangles there, or that of any one.
std::optional<double> TriangleInterpolator::FindValue(const Point2& x, bool isLeast) const
{
  std::optional<double> least;
  for (Id triangle : this->Buckets->Near(x))
  {
    const Point2 origin = this->PlaceOf(triangle, 0);
    const Point2 toFirst = this->PlaceOf(triangle, 1) - origin;
    const Point2 toSecond = this->PlaceOf(triangle, 2) - origin;
    const double whole = Cross(toFirst, toSecond);
    const double first = Cross(x - origin, toSecond);
    const double second = Cross(toFirst, x - origin);
    const double rest = whole - first - second;
    if (first >= 0.0 && second >= 0.0 && rest >= 0.0)
    {
      // By weights: differences of values would cancel what is beside a fill value.
      const double value = (rest / whole) * this->ValueOf(triangle, 0) +
        (first / whole) * this->ValueOf(triangle, 1) +
        (second / whole) * this->ValueOf(triangle, 2);
      least = least ? std::min(*least, value) : value;
      if (!isLeast)
      {
        break;
      }
    }
  }
  return least;
}

/// That of the nearest point of the border; but a triangle that is nearer yet closes a gap between
/// triangles, which is there by rounding. Those of the bucket come first: then the border is
/// searched nearby only.
double TriangleInterpolator::ValueOutside(const Point2& x) const
{
  constexpr double NearerThanRounding = 1.0 - 1e-9;
  NearestValue nearest{ Infinity, this->ValueOf(0, 0) };
  for (Id triangle : this->Buckets->Near(x))
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t next = k == 2 ? 0 : k + 1;
      const BorderEdge side{ this->PlaceOf(triangle, k), this->PlaceOf(triangle, next),
        this->ValueOf(triangle, k), this->ValueOf(triangle, next) };
      const NearestValue found = NearestOnEdge(side, x);
      nearest = found.Distance < nearest.Distance ? found : nearest;
    }
  }
  return this->Border.Nearest(x, { nearest.Distance / NearerThanRounding, nearest.Value }).Value;
}

} // namespace biting
