// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleLimit.h"

#include "SteepTriangles.h"

#include <algorithm> // for min, max, find, transform
#include <cmath>     // for abs

namespace biting
{
namespace
{

/// Values between bounded corners may be too high by this share of f.
constexpr double LargestError = 0.006;

/// See GridLimit.cxx.
constexpr double SlightTriangleShare = 0.003;

/// Of a triangle that has a list, in f.
constexpr double SmallestRadius = 0.4;

/// Along a line of length h, at least h away from its apex, a cone is below linear values by at
/// most this share of what it grows along h, and the less the farther it is away.
constexpr double BendOfCone = 0.15;

} // namespace

TriangleLimit::TriangleLimit(std::shared_ptr<const TriangulatedSource> source, double gradation,
  const ValueRange& range, Monitor& monitor)
  : Source(std::move(source))
  , Gradation(gradation)
  , Range(range)
  , Bound(range, gradation)
{
  Pulse pulse(monitor);
  const std::vector<bool> isSteep = FindSteepTriangles(*this->Source, gradation, range, pulse);
  if (!isSteep.empty())
  {
    this->Kinds.assign(isSteep.size(), Kind::AsGiven);
    std::transform(isSteep.begin(), isSteep.end(), this->Kinds.begin(),
      [](bool steep) { return steep ? Kind::Steep : Kind::AsGiven; });
    this->EdgesOf = SourceEdges(*this->Source, isSteep, pulse);
    this->SetGiven(pulse);
    this->HandOnAll(pulse);
    this->Classify(pulse);
  }
}

/// A point without a value is a hole: nothing leads through it.
void TriangleLimit::SetGiven(Pulse& pulse)
{
  this->Points.resize(this->Source->Points.size());
  pulse.ForEach(this->Points.size(),
    [this](std::size_t point)
    {
      const double value = this->Source->Values[point];
      this->Points[point] = { static_cast<float>(std::isnan(value) ? 0.0 : this->Range(value)),
        static_cast<Id>(point) };
    });
}

/// Of the ends of steep edges, those that no neighbor lowers. The others wait for that.
std::vector<TriangleLimit::Entry> TriangleLimit::LowPoints() const
{
  std::vector<Entry> low;
  for (std::size_t point = 0; point < this->Points.size(); ++point)
  {
    bool isLow = false;
    bool isLowered = false;
    for (const SourceEdges::Edge& edge : this->EdgesOf(static_cast<Id>(point)))
    {
      const double rise = this->Gradation * Length(edge.Along);
      isLow = isLow || edge.IsSteep;
      isLowered =
        isLowered || (edge.IsSteep && this->At(edge.To).Value + rise < this->Points[point].Value);
    }
    if (isLow && !isLowered)
    {
      low.emplace_back(this->Points[point].Value, static_cast<Id>(point));
    }
  }
  return low;
}

/// What bounds itself bounds others only across a steep triangle.
void TriangleLimit::HandOnAll(Pulse& pulse)
{
  this->Waiting = decltype(this->Waiting)(std::greater<Entry>(), this->LowPoints());
  while (!this->Waiting.empty() && pulse.Beat(32))
  {
    const auto [value, point] = this->Waiting.top();
    this->Waiting.pop();
    if (value > this->At(point).Value)
    {
      continue;
    }
    for (const SourceEdges::Edge& edge : this->EdgesOf(point))
    {
      if (edge.IsSteep || this->At(point).Source != point)
      {
        this->HandOn(point, edge.To);
      }
    }
  }
}

void TriangleLimit::HandOn(Id from, Id to)
{
  const Point& other = this->At(from);
  Point& point = this->At(to);
  if (other.Source == point.Source || !(other.Value < point.Value))
  {
    return;
  }
  const auto value = static_cast<float>(this->BoundFrom(other.Source, this->PlaceOf(to)));
  if (value < point.Value)
  {
    point = { value, other.Source };
    this->Waiting.emplace(value, to);
  }
}

/// An edge bounds by more than the point itself only where values along it, seen from the point,
/// rise less than the place comes nearer.
double TriangleLimit::BoundFrom(Id source, const Point2& x) const
{
  const Point2& place = this->PlaceOf(source);
  const Point2 offset = x - place;
  const double away = Length(offset);
  const double value = this->Raw(source);
  const double own = this->Range(value);
  double bound = own + this->Gradation * away;
  for (const SourceEdges::Edge& edge : this->EdgesOf(source))
  {
    const double rise = own > this->Range.Least ? this->Range.Scale * (edge.End - value) : 0.0;
    const double along = Dot(offset, edge.Along);
    if (rise * away < this->Gradation * along)
    {
      const double length = Length(edge.Along);
      bound = std::min(bound,
        this->Bound(along / length, Cross(offset, edge.Along) / length, length, value, edge.End));
    }
  }
  return bound;
}

void TriangleLimit::Classify(Pulse& pulse)
{
  pulse.ForEach(this->Points.size(), [this](std::size_t point) { this->ForgetSlight(point); });
  std::vector<bool> isOfSteep(this->Points.size(), false);
  pulse.ForEach(this->Source->Triangles.size(),
    [this, &isOfSteep](std::size_t corner)
    {
      if (this->Kinds[corner / 3] == Kind::Steep)
      {
        isOfSteep[static_cast<std::size_t>(this->Source->Triangles[corner])] = true;
      }
    });
  this->ConesOfPoints.assign(this->Points.size(), {});
  pulse.ForEach(this->Kinds.size(),
    [this, &isOfSteep](std::size_t triangle)
    {
      const auto id = static_cast<Id>(triangle);
      const Kind kind = this->KindOf(id, isOfSteep);
      this->Kinds[triangle] = kind == Kind::Wide ? this->ListCones(id) : kind;
    });
  this->ConesOfPoints = {};
  this->SourcesAround = {};
  this->Candidates = {};
}

void TriangleLimit::ForgetSlight(std::size_t at)
{
  Point& point = this->Points[at];
  const double given = this->Range(this->Source->Values[at]);
  if (point.Value > (1.0 - SlightTriangleShare) * given)
  {
    point = { static_cast<float>(given), static_cast<Id>(at) };
  }
}

/// What grows from within a steep triangle reaches those beside it.
TriangleLimit::Kind TriangleLimit::KindOf(Id triangle, const std::vector<bool>& isOfSteep) const
{
  const Id* corners = this->CornersOf(triangle);
  float least = std::numeric_limits<float>::infinity();
  bool isBounded = false;
  bool isNearSteep = false;
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    const Id point = corners[corner];
    least = std::min(least, this->At(point).Value);
    isBounded = isBounded || this->At(point).Source != point;
    isNearSteep = isNearSteep || isOfSteep[static_cast<std::size_t>(point)];
  }
  const bool isWide =
    (isBounded || isNearSteep) && this->ErrorBetween(corners) > LargestError * least;
  return isWide ? Kind::Wide : isBounded ? Kind::Small : Kind::AsGiven;
}

/// How much too high linear values between bounded corners may be: as far as the cones from sources
/// that bound them are bent between.
double TriangleLimit::ErrorBetween(const Id* corners) const
{
  double longest = 0.0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    const Point2& place = this->PlaceOf(corners[corner]);
    longest = std::max(longest, Distance(place, this->PlaceOf(corners[(corner + 1) % 3])));
    nearest = std::min(nearest, Distance(place, this->PlaceOf(this->At(corners[corner]).Source)));
  }
  const double away = std::max(nearest - longest, longest);
  return BendOfCone * this->Gradation * longest * (longest / away);
}

/// Of what bounds the corners of a triangle and the points around them, as that may pass between
/// the corners, the cones that may be lowest in it. Without any, it is as given; and where it is
/// smaller than f, which is asked for there once or twice, a list takes more time than it saves.
Id TriangleLimit::ListCones(Id triangle)
{
  const TriangleInside inside = this->InsideOf(this->CornersOf(triangle));
  if (inside.Radius < SmallestRadius * inside.Least)
  {
    return Kind::Wide;
  }
  const double rise = this->Gradation * inside.Radius;
  this->FindSources(triangle);
  this->Candidates.clear();
  Candidate lowest{ std::numeric_limits<double>::infinity(), NoId };
  for (const Id source : this->SourcesAround)
  {
    const ConeRange own = this->ConesOf(source);
    for (Id cone = own.First; cone < own.Last; ++cone)
    {
      this->Candidates.push_back({ this->ConeAt(cone, inside.Center), cone });
      lowest = std::min(lowest, this->Candidates.back());
    }
  }
  if (this->Candidates.empty())
  {
    return Kind::AsGiven;
  }
  const std::array<double, 3> lowestAtCorners{ this->ConeAt(lowest.second, inside.Corners[0]),
    this->ConeAt(lowest.second, inside.Corners[1]),
    this->ConeAt(lowest.second, inside.Corners[2]) };
  const double most = rise +
    std::min(lowest.first + rise, *std::max_element(inside.Given.begin(), inside.Given.end()));
  const std::size_t list = this->Lists.size();
  this->Lists.push_back(0);
  for (const Candidate& candidate : this->Candidates)
  {
    const bool mayBeLowest = candidate.first < most &&
      !this->IsAbove(candidate, inside, inside.Given) &&
      (candidate == lowest || !this->IsAbove(candidate, inside, lowestAtCorners));
    if (mayBeLowest)
    {
      this->Lists.push_back(candidate.second);
      ++this->Lists[list];
    }
  }
  if (this->Lists[list] == 0)
  {
    this->Lists.pop_back();
    return Kind::AsGiven;
  }
  return static_cast<Id>(list);
}

TriangleLimit::TriangleInside TriangleLimit::InsideOf(const Id* corners) const
{
  TriangleInside inside;
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    inside.Corners[corner] = this->PlaceOf(corners[corner]);
    inside.Given[corner] =
      std::max(this->Range.Scale * this->Raw(corners[corner]), this->Range.Least);
    inside.Least = std::min(inside.Least, static_cast<double>(this->At(corners[corner]).Value));
    inside.Center = inside.Center + (1.0 / 3.0) * inside.Corners[corner];
  }
  for (const Point2& corner : inside.Corners)
  {
    inside.Radius = std::max(inside.Radius, Distance(inside.Center, corner));
  }
  return inside;
}

/// Whether a cone is nowhere in a triangle below another one with these values at the corners, but
/// for a slight share. Cones are convex: above their tangent plane at the center, and below what is
/// linear between the corners.
bool TriangleLimit::IsAbove(const Candidate& candidate, const TriangleInside& inside,
  const std::array<double, 3>& values) const
{
  const SegmentCone& cone = this->Cones[static_cast<std::size_t>(candidate.second)];
  const Point2 away = inside.Center - cone.Foot(inside.Center);
  const Point2 gradient = (this->Gradation / Length(away)) * away;
  bool isAbove = true; // false where the gradient is not a number
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    const double least = candidate.first + Dot(gradient, inside.Corners[corner] - inside.Center);
    isAbove = isAbove && least >= (1.0 - SlightTriangleShare) * values[corner];
  }
  return isAbove;
}

/// What bounds itself bounds others only across a steep triangle.
void TriangleLimit::FindSources(Id triangle)
{
  this->SourcesAround.clear();
  const auto add = [this](Id point, bool isSteep)
  {
    const Id source = this->At(point).Source;
    const auto end = this->SourcesAround.end();
    if ((isSteep || source != point) && std::find(this->SourcesAround.begin(), end, source) == end)
    {
      this->SourcesAround.push_back(source);
    }
  };
  const Id* corners = this->CornersOf(triangle);
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    add(corners[corner], this->Kinds[static_cast<std::size_t>(triangle)] == Kind::Steep);
    for (const SourceEdges::Edge& edge : this->EdgesOf(corners[corner]))
    {
      add(edge.To, edge.IsSteep);
    }
  }
}

/// Those of the edges around it, or its own where these are steep.
TriangleLimit::ConeRange TriangleLimit::ConesOf(Id source)
{
  ConeRange& range = this->ConesOfPoints[static_cast<std::size_t>(source)];
  if (range.Last == 0)
  {
    const EdgeEnd own{ this->PlaceOf(source), this->Raw(source) };
    range.First = static_cast<Id>(this->Cones.size());
    for (const SourceEdges::Edge& edge : this->EdgesOf(source))
    {
      AddEdgeCones(
        own, { this->PlaceOf(edge.To), edge.End }, this->Range, this->Gradation, this->Cones);
    }
    if (this->Cones.size() == static_cast<std::size_t>(range.First))
    {
      const double value = this->Range(own.Value);
      this->Cones.emplace_back(own.Place, own.Place, value, value, this->Gradation);
    }
    range.Last = static_cast<Id>(this->Cones.size());
  }
  return range;
}

double TriangleLimit::operator()(const Point2& x, const TriangleInterpolator& triangles) const
{
  const TriangleInterpolator::Place place = triangles.Find(x);
  const double given = this->Range(place.Value);
  if (place.Triangle == NoId)
  {
    return std::min({ given, this->BoundFrom(this->At(place.Ends[0]).Source, x),
      this->BoundFrom(this->At(place.Ends[1]).Source, x) });
  }
  const Id kind = this->Kinds[static_cast<std::size_t>(place.Triangle)];
  switch (kind)
  {
    case Kind::AsGiven:
      return given;
    case Kind::Small:
    {
      const Id* corners = this->CornersOf(place.Triangle);
      return std::min(given,
        place.Weights[0] * this->At(corners[0]).Value +
          place.Weights[1] * this->At(corners[1]).Value +
          place.Weights[2] * this->At(corners[2]).Value);
    }
    case Kind::Wide:
      return this->ValueInWide(x, place.Triangle, given);
    default:
      return std::min(given, this->LowestOfList(x, kind));
  }
}

double TriangleLimit::LowestOfList(const Point2& x, Id start) const
{
  const Id* list = &this->Lists[static_cast<std::size_t>(start)];
  double least = std::numeric_limits<double>::infinity();
  for (const Id* cone = list + 1; cone <= list + *list; ++cone)
  {
    least = std::min(least, this->ConeAt(*cone, x));
  }
  return least;
}

/// By what bounds the corners, and the points around them.
double TriangleLimit::ValueInWide(const Point2& x, Id triangle, double given) const
{
  LookedAt<Id> looked;
  double least = given;
  const Id* corners = this->CornersOf(triangle);
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    least = this->LowerFrom(corners[corner], x, looked, least);
  }
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    for (const SourceEdges::Edge& edge : this->EdgesOf(corners[corner]))
    {
      least = this->LowerFrom(edge.To, x, looked, least);
    }
  }
  return least;
}

/// By what bounds a point, unless the way from there cannot make up for what it is higher.
double TriangleLimit::LowerFrom(Id point, const Point2& x, LookedAt<Id>& looked, double least) const
{
  const Point& own = this->At(point);
  const Point2 offset = x - this->PlaceOf(point);
  const double room = std::max(own.Value - least, 0.0);
  const bool mayBound = room * room <= this->Gradation * this->Gradation * Dot(offset, offset);
  return mayBound && looked.Add(own.Source) ? std::min(least, this->BoundFrom(own.Source, x))
                                            : least;
}

} // namespace biting
