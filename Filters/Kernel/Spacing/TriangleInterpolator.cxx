// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleInterpolator.h"

#include "../Base/Numbers.h"
#include "../Base/Tasks.h"

#include <algorithm> // for min, max, none_of, sort
#include <cmath>     // for isfinite
#include <cstdint>   // for sides
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
  const auto isHole = [&source](Id point) { return std::isnan(source.Values[point]); };
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

/// The edges with triangles on one side only, or that lie on each other, in the order of their
/// ends. Sides are dealt to their lower ends; those of one point are few, and sorted.
std::vector<BorderEdge> FindBorder(
  const TriangulatedSource& source, const std::vector<Id>& corners, Pulse& pulse)
{
  using Side = std::uint32_t; // twice the higher end, and 1 where its triangle goes up there
  const auto nextOf = [&corners](std::size_t k) { return corners[k % 3 == 2 ? k - 2 : k + 1]; };
  const IdLists sides(source.Points.size(),
    [&corners, &nextOf, &pulse](const auto& add)
    {
      pulse.ForEach(corners.size(),
        [&corners, &nextOf, &add](std::size_t k)
        { add(std::min(corners[k], nextOf(k)), static_cast<Id>(k)); });
    });
  std::vector<BorderEdge> border;
  std::vector<Side> around;
  pulse.ForEach(source.Points.size(),
    [&source, &corners, &nextOf, &sides, &border, &around](std::size_t start)
    {
      around.clear();
      for (const Id side : sides[static_cast<Id>(start)])
      {
        const auto k = static_cast<std::size_t>(side);
        around.push_back(2 * static_cast<Side>(std::max(corners[k], nextOf(k))) +
          (corners[k] < nextOf(k) ? 1 : 0));
      }
      std::sort(around.begin(), around.end());
      for (auto first = around.begin(); first != around.end();)
      {
        const Side own = *first;
        first = std::find_if(first, around.end(), [own](Side side) { return side / 2 != own / 2; });
        if (first[-1] == own)
        {
          const std::size_t ends[2] = { start, static_cast<std::size_t>(own / 2) };
          const std::size_t from = ends[1 - own % 2];
          const std::size_t to = ends[own % 2];
          border.push_back({ source.Points[from], source.Points[to], source.Values[from],
            source.Values[to], static_cast<Id>(from), static_cast<Id>(to) });
        }
      }
    });
  return border;
}

/// Of linear values in a triangle; 0 where it is not known.
double SlopeOfTriangle(const TriangulatedSource& source, const Id* corners)
{
  const auto rise = [&source, corners](std::size_t k)
  { return source.Values[PointOf(corners, k)] - source.Values[PointOf(corners, 0)]; };
  const Point2& origin = source.Points[PointOf(corners, 0)];
  const Point2 firstSide = source.Points[PointOf(corners, 1)] - origin;
  const Point2 secondSide = source.Points[PointOf(corners, 2)] - origin;
  const double slope =
    Length((1.0 / Cross(firstSide, secondSide)) * (rise(1) * secondSide - rise(2) * firstSide));
  return std::isfinite(slope) ? slope : 0.0;
}

/// Lists the low edges of triangles.
class LowSides
{
public:
  LowSides(const TriangulatedSource& source, const SteepRule& rule, SegmentSource& edges)
    : Given(source)
    , Rule(rule)
    , Edges(edges)
    , Most(source.Points.size(), Infinity)
  {
  }

  void AddSide(Id start, Id end)
  {
    const CellNode a = this->At(start);
    const CellNode b = this->At(end);
    const double rise = this->Rule.Slope * Distance(a.At, b.At);
    this->Lower(start, std::min(a.Value, this->MostAt(end) + rise));
    this->Lower(end, std::min(b.Value, this->MostAt(start) + rise));
    AddLowEdge(a, b, this->Rule, this->Edges);
  }

  /// Of a triangle whose values differ.
  void AddSidesOf(const Id* corners)
  {
    const std::vector<CellNode> nodes{ this->At(corners[0]), this->At(corners[1]),
      this->At(corners[2]) };
    const auto [least, most] = std::minmax({ nodes[0].Value, nodes[1].Value, nodes[2].Value });
    for (std::size_t k = 0; k < 3 && least < most; ++k)
    {
      this->AddSide(corners[k], corners[k == 2 ? 0 : k + 1]);
    }
    AddLevelLine(nodes, this->Rule.Range, this->Edges);
  }

  /// Those of steep triangles from which f grows, when all sides are added.
  void AddPoints()
  {
    for (std::size_t point = 0; point < this->Most.size(); ++point)
    {
      const CellNode place = this->At(static_cast<Id>(point));
      if (this->Most[point] == place.Value)
      {
        this->Edges.Add(place.At, place.At, place.Value, place.Value);
      }
    }
  }

  /// Bounds of f at the points, along the sides so far.
  const std::vector<double>& AllMost() const { return this->Most; }

private:
  CellNode At(Id point) const
  {
    const double value = this->Given.Values[point];
    return { this->Given.Points[point], this->Rule.Range.Scale * value, this->Rule.Range(value) };
  }
  double MostAt(Id point) const { return this->Most[point]; }
  void Lower(Id point, double value)
  {
    double& most = this->Most[point];
    most = std::min(most, value);
  }

  const TriangulatedSource& Given;
  const SteepRule& Rule;
  SegmentSource& Edges;
  std::vector<double> Most;
};

} // namespace

TriangleInterpolator::TriangleInterpolator(
  std::shared_ptr<const TriangulatedSource> source, Monitor& monitor)
  : Triangles(std::move(source))
{
  Pulse pulse(monitor);
  this->Corners = UsableCorners(*this->Triangles, pulse);
  if (this->Corners.empty() || pulse.HasStopped())
  {
    return;
  }
  const auto makeBuckets = [this](Pulse& own) {
    this->Buckets = std::make_unique<TriangleBuckets>(this->Triangles->Points, this->Corners, own);
  };
  const auto makeBorder = [this](Pulse& own)
  { this->Border = BoxTree<BorderEdge>(FindBorder(*this->Triangles, this->Corners, own), own); };
  DoEach(pulse, { makeBuckets, makeBorder });
}

/// The least one of the triangles there where they may overlap, else that of any one. With room for
/// gaps between triangles that are there by rounding.
std::optional<double> TriangleInterpolator::ValueInside(const Point2& x) const
{
  constexpr double RoomForRounding = 1e-9; // of the area
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
    if (std::min({ first, second, rest }) >= -RoomForRounding * whole)
    {
      // By weights: differences of values would cancel what is beside a fill value.
      const double weights[3] = { std::max(rest, 0.0), std::max(first, 0.0),
        std::max(second, 0.0) };
      const double sum = weights[0] + weights[1] + weights[2];
      const double value = (weights[0] / sum) * this->ValueOf(triangle, 0) +
        (weights[1] / sum) * this->ValueOf(triangle, 1) +
        (weights[2] / sum) * this->ValueOf(triangle, 2);
      least = least ? std::min(*least, value) : value;
      if (!this->Triangles->MayOverlap)
      {
        break;
      }
    }
  }
  return least;
}

double TriangleInterpolator::AddLowEdges(
  const SteepRule& rule, SegmentSource& edges, Pulse& pulse) const
{
  const TriangulatedSource& source = *this->Triangles;
  const double least = source.IsGraded ? Infinity : rule.Slope;
  double largest = 0.0;
  LowSides low(source, rule, edges);
  pulse.ForEach(this->Corners.size() / 3,
    [this, &source, &rule, &low, &largest, least](std::size_t triangle)
    {
      const Id* corners = &this->Corners[3 * triangle];
      const double slope = SlopeOfTriangle(source, corners);
      largest = std::max(largest, slope);
      if (rule.Range.Scale * slope > least)
      {
        low.AddSidesOf(corners);
      }
    });
  if (rule.Slope < Infinity)
  {
    for (std::size_t k = 0; k < this->Border.Items().size() && source.MayOverlap; ++k)
    {
      low.AddSide(this->Border.Items()[k].StartId, this->Border.Items()[k].EndId);
    }
    low.AddPoints();
    if (!source.CoversDomain)
    {
      AddJumpsOutside(*this, low.AllMost(), rule, edges, pulse);
    }
  }
  return largest;
}

} // namespace biting
