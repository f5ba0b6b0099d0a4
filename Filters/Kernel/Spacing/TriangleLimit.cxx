// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleLimit.h"

#include "SourceSlopes.h"

#include <algorithm> // for min, max, find_if
#include <cmath>     // for abs
#include <numeric>   // for partial_sum

namespace biting
{
namespace
{

/// A triangle is steep where the slope along one of its edges or the mean gradient around one of
/// its corners is above the gradation by more than this share of it, or its own gradient adds more
/// than this share of f. The gradient of one triangle exceeds that of a function with slope g even
/// where its edges do not.
constexpr double SteepnessMargin = 0.005;

/// See GridLimit.cxx.
constexpr double WidestGrowth = 0.09;
constexpr double SlightShare = 0.003;

} // namespace

TriangleLimit::TriangleLimit(std::shared_ptr<const TriangulatedSource> source, double gradation,
  const ValueRange& range, Monitor& monitor)
  : Source(std::move(source))
  , Gradation(gradation)
  , Range(range)
  , Bound(range, gradation)
{
  Pulse pulse(monitor);
  if (this->FindSteep(pulse))
  {
    this->FileEdges(pulse);
    this->SetGiven(pulse);
    this->HandOnAll(pulse);
    this->Classify(pulse);
  }
}

/// Whether there are any: Kinds says which.
bool TriangleLimit::FindSteep(Pulse& pulse)
{
  std::vector<Point2> gradients;
  this->AverageGradients(gradients, pulse);
  const std::size_t count = this->Source->Triangles.size() / 3;
  this->Kinds.assign(count, Triangle::AsGiven);
  bool isFound = false;
  pulse.ForEach(count,
    [this, &gradients, &isFound](std::size_t triangle)
    {
      if (this->IsSteep(static_cast<Id>(triangle), gradients))
      {
        this->Kinds[triangle] = Triangle::Steep;
        isFound = true;
      }
    });
  return isFound && !pulse.HasStopped();
}

/// Of the triangles around each point, weighted by area.
void TriangleLimit::AverageGradients(std::vector<Point2>& gradients, Pulse& pulse) const
{
  gradients.resize(this->Source->Points.size());
  std::vector<double> areas(gradients.size(), 0.0);
  pulse.ForEach(this->Source->Triangles.size() / 3,
    [this, &gradients, &areas](std::size_t triangle)
    {
      const std::size_t first = 3 * triangle;
      const Point2 gradient = GradientOfTriangle(*this->Source, first);
      const double area = AreaOfTriangle(*this->Source, first);
      for (std::size_t corner = first; corner < first + 3 && area > 0.0; ++corner)
      {
        const auto point = static_cast<std::size_t>(this->Source->Triangles[corner]);
        areas[point] += area;
        gradients[point] = gradients[point] + (area / areas[point]) * (gradient - gradients[point]);
      }
    });
}

bool TriangleLimit::IsSteep(Id triangle, const std::vector<Point2>& gradients) const
{
  const double most = (1.0 + SteepnessMargin) * this->Gradation;
  const Point2 gradient = GradientOfTriangle(*this->Source, 3 * static_cast<std::size_t>(triangle));
  const double slope = this->Range.Scale * Length(gradient);
  const Id* corners = this->CornersOf(triangle);
  const double values[3] = { this->Range(this->Raw(corners[0])), this->Range(this->Raw(corners[1])),
    this->Range(this->Raw(corners[2])) };
  const double least = std::min({ values[0], values[1], values[2] });
  if (!(slope > most) || !(std::max({ values[0], values[1], values[2] }) > least))
  {
    return false;
  }
  double longest = 0.0;
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    const Id a = corners[corner];
    const Id b = corners[(corner + 1) % 3];
    const double length = Distance(this->PlaceOf(a), this->PlaceOf(b));
    if (this->Range.Scale * std::abs(this->Raw(a) - this->Raw(b)) > most * length ||
      this->Range.Scale * Length(gradients[static_cast<std::size_t>(a)]) > most)
    {
      return true;
    }
    longest = std::max(longest, length);
  }
  return (slope - this->Gradation) * 0.5 * longest > SteepnessMargin * least;
}

void TriangleLimit::FileEdges(Pulse& pulse)
{
  const std::size_t count = this->Source->Points.size();
  std::vector<Id> starts(count + 1, 0);
  for (Id point : this->Source->Triangles)
  {
    ++starts[static_cast<std::size_t>(point) + 1];
  }
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<Id> next = starts;
  std::vector<Id> around(this->Source->Triangles.size());
  pulse.ForEach(around.size(),
    [this, &next, &around](std::size_t corner)
    {
      const auto point = static_cast<std::size_t>(this->Source->Triangles[corner]);
      around[static_cast<std::size_t>(next[point]++)] = static_cast<Id>(corner / 3);
    });
  this->Edges.reserve(around.size() + count / 8);
  pulse.ForEach(count,
    [this, &starts, &around](std::size_t point)
    {
      this->FirstEdges.push_back(static_cast<Id>(this->Edges.size()));
      for (Id k = starts[point]; k < starts[point + 1]; ++k)
      {
        this->AddEdges(static_cast<Id>(point), around[static_cast<std::size_t>(k)]);
      }
    });
  this->FirstEdges.push_back(static_cast<Id>(this->Edges.size()));
}

/// Those of a triangle that begin at the point.
void TriangleLimit::AddEdges(Id point, Id triangle)
{
  const bool isSteep = this->Kinds[static_cast<std::size_t>(triangle)] == Triangle::Steep;
  const Id* corners = this->CornersOf(triangle);
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    const Id to = corners[corner];
    const auto known = std::find_if(this->Edges.begin() + this->FirstEdges.back(),
      this->Edges.end(), [to](const Edge& edge) { return edge.To == to; });
    if (known != this->Edges.end())
    {
      known->IsSteep = known->IsSteep || isSteep;
    }
    else if (to != point)
    {
      this->Edges.push_back(
        { this->PlaceOf(to) - this->PlaceOf(point), this->Raw(to), to, isSteep });
    }
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
    for (const Edge& edge : this->EdgesOf(static_cast<Id>(point)))
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
    for (const Edge& edge : this->EdgesOf(point))
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

/// An edge bounds by more than the point itself only where values along it, seen from the point, rise
/// less than the place comes nearer.
double TriangleLimit::BoundFrom(Id source, const Point2& x) const
{
  const Point2& place = this->PlaceOf(source);
  const Point2 offset = x - place;
  const double away = Length(offset);
  const double value = this->Raw(source);
  const double own = this->Range(value);
  double bound = own + this->Gradation * away;
  for (const Edge& edge : this->EdgesOf(source))
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
      if (this->Kinds[corner / 3] == Triangle::Steep)
      {
        isOfSteep[static_cast<std::size_t>(this->Source->Triangles[corner])] = true;
      }
    });
  pulse.ForEach(this->Kinds.size(),
    [this, &isOfSteep](std::size_t triangle)
    { this->Kinds[triangle] = this->KindOf(static_cast<Id>(triangle), isOfSteep); });
}

void TriangleLimit::ForgetSlight(std::size_t at)
{
  Point& point = this->Points[at];
  const double given = this->Range(this->Source->Values[at]);
  if (point.Value > (1.0 - SlightShare) * given)
  {
    point = { static_cast<float>(given), static_cast<Id>(at) };
  }
}

/// What grows from within a steep triangle reaches those beside it.
TriangleLimit::Triangle TriangleLimit::KindOf(Id triangle, const std::vector<bool>& isOfSteep) const
{
  const Id* corners = this->CornersOf(triangle);
  double longest = 0.0;
  float least = std::numeric_limits<float>::infinity();
  bool isBounded = false;
  bool isNearSteep = false;
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    const Id point = corners[corner];
    least = std::min(least, this->At(point).Value);
    isBounded = isBounded || this->At(point).Source != point;
    isNearSteep = isNearSteep || isOfSteep[static_cast<std::size_t>(point)];
    longest =
      std::max(longest, Distance(this->PlaceOf(point), this->PlaceOf(corners[(corner + 1) % 3])));
  }
  const bool isWide = this->Gradation * longest > WidestGrowth * least;
  return isWide && (isBounded || isNearSteep) ? Triangle::Wide
    : isBounded                               ? Triangle::Small
                                              : Triangle::AsGiven;
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
  switch (this->Kinds[static_cast<std::size_t>(place.Triangle)])
  {
    case Triangle::AsGiven:
      return given;
    case Triangle::Small:
    {
      const Id* corners = this->CornersOf(place.Triangle);
      return std::min(given,
        place.Weights[0] * this->At(corners[0]).Value +
          place.Weights[1] * this->At(corners[1]).Value +
          place.Weights[2] * this->At(corners[2]).Value);
    }
    default:
      return this->ValueInWide(x, place.Triangle, given);
  }
}

/// By what bounds the corners, and the points around them, as that may pass between the corners.
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
    for (const Edge& edge : this->EdgesOf(corners[corner]))
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
