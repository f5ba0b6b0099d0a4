// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleInterpolator.h"

#include "../Base/Numbers.h"
#include "../Base/Tasks.h"
#include "SourceSlopes.h"

#include <algorithm> // for min, max, none_of, sort
#include <cstdint>   // for sides
#include <numeric>   // for partial_sum
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

/// The edges with triangles on one side only, or that lie on each other, in the order of their
/// ends. Sides are dealt to their lower ends; those of one point are few, and sorted.
std::vector<BorderEdge> FindBorder(
  const TriangulatedSource& source, const std::vector<Id>& corners, Pulse& pulse)
{
  using Side = std::uint32_t; // twice the higher end, and 1 where its triangle goes up there
  std::vector<std::size_t> begins(source.Points.size() + 1, 0);
  std::vector<Side> sides(corners.size());
  const auto forEachSide = [&corners, &pulse](auto visit)
  {
    pulse.ForEach(corners.size(),
      [&corners, &visit](std::size_t k)
      {
        const Id start = corners[k];
        const Id end = corners[k % 3 == 2 ? k - 2 : k + 1];
        visit(static_cast<std::size_t>(std::min(start, end)),
          2 * static_cast<Side>(std::max(start, end)) + (start < end ? 1 : 0));
      });
  };
  forEachSide([&begins](std::size_t low, Side) { ++begins[low]; });
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  forEachSide([&begins, &sides](std::size_t low, Side side) { sides[--begins[low]] = side; });
  std::vector<BorderEdge> border;
  pulse.ForEach(source.Points.size(),
    [&source, &begins, &sides, &border](std::size_t start)
    {
      const Side* last = sides.data() + begins[start + 1];
      std::sort(sides.data() + begins[start], sides.data() + begins[start + 1]);
      for (const Side* first = sides.data() + begins[start]; first < last;)
      {
        const Side own = *first;
        first = std::find_if(first, last, [own](Side side) { return side / 2 != own / 2; });
        if (first[-1] == own)
        {
          const auto end = static_cast<std::size_t>(own / 2);
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
  return Nearest(this->Border, x, { nearest.Distance / NearerThanRounding, nearest.Value }).Value;
}

Source<2>::Sample TriangleInterpolator::At(const Point<2>& x) const
{
  const Point2 place{ x[0], x[1] };
  const std::optional<double> value = this->FindValue(place, this->HasOverlaps());
  return value ? Sample{ *value, true } : Sample{ this->ValueOutside(place), false };
}

namespace
{

/// Lists the low places of triangles.
class LowPoints
{
public:
  LowPoints(const TriangulatedSource& source, double slope, const ValueRange& range)
    : Given(source)
    , Slope(slope)
    , Range(range)
    , MostOnEdge(MostPlacesOnEdge(source.Triangles.size()))
    , States(source.Points.size(), 0)
  {
  }

  void AddSteep(const Id* corners)
  {
    const LowPlace<2> ends[3] = { this->At(corners[0]), this->At(corners[1]),
      this->At(corners[2]) };
    const auto [least, most] = std::minmax({ ends[0].Value, ends[1].Value, ends[2].Value });
    if (least<most&& this->Range.Scale * Length(GradientOfTriangle(this->Given, corners))> this
          ->Slope)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        this->AddEdge(corners[k], corners[k == 2 ? 0 : k + 1]);
      }
    }
  }

  void AddEdge(Id start, Id end)
  {
    const LowPlace<2> a = this->At(start);
    const LowPlace<2> b = this->At(end);
    const double most = this->Slope * Distance<2>(a.At, b.At);
    this->StateOf(start) |= a.Value > b.Value + most ? IsUpper : IsListed;
    this->StateOf(end) |= b.Value > a.Value + most ? IsUpper : IsListed;
    AddPlacesOnEdge<2>(a, b, this->Slope, this->MostOnEdge, this->Places);
  }

  std::vector<LowPlace<2>> List()
  {
    for (std::size_t point = 0; point < this->States.size(); ++point)
    {
      if (this->States[point] == IsListed)
      {
        this->Places.push_back(this->At(static_cast<Id>(point)));
      }
    }
    return std::move(this->Places);
  }

private:
  static constexpr std::uint8_t IsListed = 1;
  static constexpr std::uint8_t IsUpper = 2; ///< of an edge that is steep itself

  LowPlace<2> At(Id point) const
  {
    const auto id = static_cast<std::size_t>(point);
    const Point2& place = this->Given.Points[id];
    return { { place.X, place.Y }, this->Range(this->Given.Values[id]) };
  }
  std::uint8_t& StateOf(Id point) { return this->States[static_cast<std::size_t>(point)]; }

  const TriangulatedSource& Given;
  const double Slope;
  const ValueRange& Range;
  const double MostOnEdge;
  std::vector<std::uint8_t> States; ///< of points
  std::vector<LowPlace<2>> Places;
};

} // namespace

std::vector<LowPlace<2>> TriangleInterpolator::LowPlaces(
  double slope, const ValueRange& range, Pulse& pulse) const
{
  LowPoints low(*this->Triangles, slope, range);
  if (!this->Triangles->IsGraded)
  {
    pulse.ForEach(this->Corners.size() / 3,
      [this, &low](std::size_t triangle) { low.AddSteep(&this->Corners[3 * triangle]); });
  }
  for (std::size_t k = 0; k < this->BorderEdges().size() && this->HasOverlaps(); ++k)
  {
    low.AddEdge(this->BorderEdges()[k].StartId, this->BorderEdges()[k].EndId);
  }
  return low.List();
}

} // namespace biting
