// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "PlaneFrame.h"

#include "../../Kernel/Base/SortInSteps.h"
#include "Globe.h"

#include <algorithm>  // for min, max, unique
#include <cmath>      // for abs, isfinite, sqrt
#include <functional> // for less

namespace biting
{

namespace
{

// The points to fit to, relative to the centre of their box and scaled to half extents of at most
// 1, so that neither offsets nor units of the input matter. Sorted, each once: sums are rounded in
// the order of their terms, which shall not be that of the input.
struct ScaledPoints
{
  std::vector<Point3> Places;
  Pulse& Beats;
  Point3 Low;
  Point3 High;
  Point3 Center{ 0.0, 0.0, 0.0 };
  double Scale = 1.0;

  Point3 operator[](std::size_t k) const;
};

// A plane by a point of it and its normal.
struct Plane
{
  Point3 Origin;
  Point3 Normal;
  bool IsOfNeedle = false; ///< least squares are of no use
};

// Of the length; narrower triangles are needles.
constexpr double NeedleWidth = 1e-6;

Point3 Unit(const Point3& a)
{
  return (1.0 / std::sqrt(Dot(a, a))) * a;
}

Point3 ScaledPoints::operator[](std::size_t k) const
{
  return (1.0 / this->Scale) * (this->Places[k] - this->Center);
}

// Of zeros the positive one.
Point3 PlaceOf(const double* coordinates, Id point)
{
  const double* place = coordinates + 3 * static_cast<std::size_t>(point);
  return { place[0] + 0.0, place[1] + 0.0, place[2] + 0.0 };
}

ScaledPoints Scaled(const double* coordinates, const std::vector<Id>& points, Pulse& pulse)
{
  const Point3 start = PlaceOf(coordinates, points.front());
  ScaledPoints scaled{ {}, pulse, start, start };
  pulse.ForEach(points.size(),
    [coordinates, &points, &scaled](std::size_t k)
    {
      const Point3 place = PlaceOf(coordinates, points[k]);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        scaled.Low[axis] = std::min(scaled.Low[axis], place[axis]);
        scaled.High[axis] = std::max(scaled.High[axis], place[axis]);
      }
    });
  scaled.Center = 0.5 * scaled.Low + 0.5 * scaled.High;
  const Point3 half = 0.5 * scaled.High - 0.5 * scaled.Low;
  scaled.Scale = std::max({ half[0], half[1], half[2] });
  return scaled;
}

void AddPlaces(
  const double* coordinates, const std::vector<Id>& points, ScaledPoints& scaled, Pulse& pulse)
{
  std::vector<Point3>& places = scaled.Places;
  places.reserve(points.size());
  pulse.ForEach(points.size(),
    [coordinates, &points, &places](std::size_t k)
    { places.push_back(PlaceOf(coordinates, points[k])); });
  SortInSteps(places, std::less<>(), pulse);
  places.erase(std::unique(places.begin(), places.end()), places.end());
}

// The number of the point with the largest `measure`, the first of them where several are equal.
template <typename Measure>
std::size_t Largest(const ScaledPoints& points, Measure measure)
{
  std::size_t largest = 0;
  double value = -1.0;
  points.Beats.ForEach(points.Places.size(),
    [&points, &measure, &largest, &value](std::size_t k)
    {
      const double candidate = measure(points[k]);
      if (candidate > value)
      {
        value = candidate;
        largest = k;
      }
    });
  return largest;
}

Point3 AnyNormalTo(const Point3& direction)
{
  const auto least = std::min_element(direction.begin(), direction.end(),
    [](double a, double b) { return std::abs(a) < std::abs(b); });
  Point3 axis{ 0.0, 0.0, 0.0 };
  axis[least - direction.begin()] = 1.0;
  return Unit(Cross(direction, axis));
}

// The plane through a triangle of three points that is large among all such. Where none is further
// than `rounding` from the line through two of them, one through that line: the normal would be of
// rounding alone. Where they are a needle the normal is made perpendicular to it: rounding turns it
// by its unit over the width, which matters along the needle only.
Plane ThroughLargeTriangle(const ScaledPoints& points, double rounding)
{
  const Point3 a = points[Largest(points, [](const Point3& p) { return Dot(p, p); })];
  const Point3 b = points[Largest(points, [&a](const Point3& p) { return Dot(p - a, p - a); })];
  const auto area = [&a, &b](const Point3& p)
  {
    const Point3 cross = Cross(b - a, p - a);
    return Dot(cross, cross);
  };
  const Point3 c = points[Largest(points, area)];
  const double squaredLength = Dot(b - a, b - a);
  if (area(c) <= rounding * rounding * squaredLength)
  {
    return { a, AnyNormalTo(b - a), true };
  }
  const Point3 normal = Unit(Cross(b - a, c - a));
  const bool isNeedle = area(c) <= NeedleWidth * NeedleWidth * squaredLength * squaredLength;
  const Point3 excess = (Dot(normal, b - a) / squaredLength) * (b - a);
  return { a, isNeedle ? Unit(normal - excess) : normal, isNeedle };
}

// Least squares of the distances from `plane` over axes in it: the plane that is left after
// subtracting what is linear in the distances.
Plane Refined(const ScaledPoints& points, const Plane& plane)
{
  const Point3 first = AnyNormalTo(plane.Normal);
  const Point3 second = Cross(plane.Normal, first);
  const double weight = 1.0 / static_cast<double>(points.Places.size());
  Point3 mean{ 0.0, 0.0, 0.0 };
  points.Beats.ForEach(points.Places.size(),
    [&points, &mean, weight](std::size_t k) { mean = mean + weight * points[k]; });
  double uu = 0.0;
  double uv = 0.0;
  double vv = 0.0;
  double uw = 0.0;
  double vw = 0.0;
  for (std::size_t k = 0; k < points.Places.size() && points.Beats.Beat(); ++k)
  {
    const Point3 offset = points[k] - mean;
    const double u = Dot(offset, first);
    const double v = Dot(offset, second);
    const double w = Dot(offset, plane.Normal);
    uu += weight * u * u;
    uv += weight * u * v;
    vv += weight * v * v;
    uw += weight * u * w;
    vw += weight * v * w;
  }
  const double determinant = uu * vv - uv * uv;
  const double slopeU = (uw * vv - vw * uv) / determinant;
  const double slopeV = (vw * uu - uw * uv) / determinant;
  const Point3 normal = plane.Normal - (slopeU * first + slopeV * second);
  // Collinear points have no such plane.
  const bool isDefined = determinant > 0.0 && std::isfinite(Dot(normal, normal));
  return isDefined ? Plane{ mean, Unit(normal), false } : plane;
}

// The axis along which the points extend least: the last of equal ones, then the first.
std::size_t ThinnestAxis(const ScaledPoints& points)
{
  const Point3 extent = points.High - points.Low;
  const std::size_t first = extent[0] <= extent[1] ? 0 : 1;
  return extent[2] <= extent[first] ? 2 : first;
}

double LargestDistance(const ScaledPoints& points, const Plane& plane)
{
  const auto distance = [&plane](const Point3& p)
  { return std::abs(Dot(p - plane.Origin, plane.Normal)); };
  return distance(points[Largest(points, distance)]);
}

} // namespace

PlaneFrame PlaneFrame::FitTo(
  const double* coordinates, const std::vector<Id>& points, double rounding, Pulse& pulse)
{
  const PulsePart part(pulse, 0.0, 0.0);
  if (points.empty())
  {
    return {};
  }
  ScaledPoints scaled = Scaled(coordinates, points, pulse);
  const std::size_t thinnest = ThinnestAxis(scaled);
  if (scaled.High[thinnest] - scaled.Low[thinnest] <= rounding)
  {
    const double low = scaled.Low[thinnest];
    const double high = scaled.High[thinnest];
    return Aligned(static_cast<int>(thinnest), low == high ? low : scaled.Center[thinnest]);
  }
  AddPlaces(coordinates, points, scaled, pulse);
  const Plane rough = ThroughLargeTriangle(scaled, rounding / scaled.Scale);
  const Plane refined = rough.IsOfNeedle ? rough : Refined(scaled, rough);
  const bool isBetter = LargestDistance(scaled, refined) <= LargestDistance(scaled, rough);
  const Plane& best = isBetter ? refined : rough;
  // The box's centre, moved into the plane.
  const double offset = Dot(best.Origin, best.Normal);
  return WithNormal(scaled.Center + (scaled.Scale * offset) * best.Normal, best.Normal);
}

PlaneFrame PlaneFrame::Aligned(int normalAxis, double level)
{
  PlaneFrame frame;
  frame.Axes = { (normalAxis + 1) % 3, (normalAxis + 2) % 3, normalAxis };
  frame.Level = level;
  return frame;
}

PlaneFrame PlaneFrame::WithNormal(const Point3& origin, const Point3& normal)
{
  const auto largest = std::max_element(
    normal.begin(), normal.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  const auto normalAxis = static_cast<std::size_t>(largest - normal.begin());
  PlaneFrame frame;
  frame.IsAligned = false;
  frame.Origin = origin;
  frame.Normal = *largest > 0.0 ? normal : -1.0 * normal;
  Point3 axis{ 0.0, 0.0, 0.0 };
  axis[(normalAxis + 1) % 3] = 1.0;
  frame.First = Unit(axis - Dot(axis, frame.Normal) * frame.Normal);
  frame.Second = Cross(frame.Normal, frame.First);
  return frame;
}

PlaneFrame PlaneFrame::OnGlobe(const Point3& middle, double longitude, double level)
{
  constexpr double NearPole = 1e-9; // where the direction of east is one of rounding
  const bool isPole = std::hypot(middle.X, middle.Y) < NearPole;
  PlaneFrame frame;
  frame.IsAligned = false;
  frame.SquaredDiameter = 4.0 * EarthRadius * EarthRadius;
  frame.Longitude = longitude;
  frame.Level = level;
  frame.Normal = middle;
  frame.First = isPole ? Point3{ 0.0, 1.0, 0.0 } : Unit(Point3{ -middle.Y, middle.X, 0.0 });
  frame.Second = Cross(frame.Normal, frame.First);
  return frame;
}

double PlaneFrame::LevelOf(const double* place) const
{
  return Dot(DirectionOf(place), this->Normal);
}

double PlaneFrame::TurnedLongitude(double longitude) const
{
  const double turns = std::round((longitude - this->Longitude) / 360.0);
  return std::abs(longitude - this->Longitude) <= 180.0 ? longitude : longitude - 360.0 * turns;
}

// With d the unit vector of a place, m that of the middle: p = 2 R (d - (d.m) m) / (1 + d.m). So
// |p| = 2 R tan(c / 2) at the angle c from the middle, and k = 2 / (1 + cos c) = 1 + |p|^2 / 4 R^2.
Point2 PlaneFrame::ToPlane(const double* place) const
{
  if (this->IsOnGlobe())
  {
    const Point3 direction = DirectionOf(place);
    const double factor = std::sqrt(this->SquaredDiameter) / (1.0 + Dot(direction, this->Normal));
    return { factor * Dot(direction, this->First), factor * Dot(direction, this->Second) };
  }
  if (this->IsAligned)
  {
    return { place[this->Axes[0]], place[this->Axes[1]] };
  }
  const Point3 offset = Point3{ place[0], place[1], place[2] } - this->Origin;
  return { Dot(offset, this->First), Dot(offset, this->Second) };
}

bool PlaneFrame::TakeVector(const Point3& vector, Point2& inPlane) const
{
  constexpr double MostOff = 1e-6;
  inPlane = this->IsAligned ? Point2{ vector[this->Axes[0]], vector[this->Axes[1]] }
                            : Point2{ Dot(vector, this->First), Dot(vector, this->Second) };
  const double off = this->IsAligned ? vector[this->Axes[2]] : Dot(vector, this->Normal);
  return std::abs(off) <= MostOff * biting::Length(inPlane) &&
    std::isfinite(biting::Length(inPlane));
}

Point3 PlaneFrame::ToSpace(const Point2& p) const
{
  if (this->IsOnGlobe())
  {
    const double along = 2.0 / this->StretchAt(p); // 1 + cos c
    const double across = along / std::sqrt(this->SquaredDiameter);
    const Point3 degrees = DegreesOf(
      (along - 1.0) * this->Normal + (across * p.X * this->First + across * p.Y * this->Second));
    return { this->TurnedLongitude(degrees.X), degrees.Y, this->Level };
  }
  if (this->IsAligned)
  {
    Point3 place{};
    place[this->Axes[0]] = p.X;
    place[this->Axes[1]] = p.Y;
    place[this->Axes[2]] = this->Level;
    return place;
  }
  return this->Origin + (p.X * this->First + p.Y * this->Second);
}

double PlaneFrame::Distance(const double* place) const
{
  if (this->IsAligned || this->IsOnGlobe())
  {
    return place[this->Axes[2]] - this->Level;
  }
  return Dot(Point3{ place[0], place[1], place[2] } - this->Origin, this->Normal);
}

} // namespace biting
