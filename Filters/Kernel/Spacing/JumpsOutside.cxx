// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleInterpolator.h"

#include "../Base/Tasks.h"

#include <array> // for parts
#include <cmath> // for abs

namespace biting
{
namespace
{

/// How far apart rays are, as a share of the value: f is too large by slope times half of that.
constexpr double WidthOfRay = 0.45;

/// Of neighboring rays one of which is far shorter: where their values differ by no more than
/// LargestRise, or they start no farther apart than LeastBase, as shares of the lower value, they
/// stand for those between.
constexpr double LargestRise = 0.2;
constexpr double LeastBase = 0.06;

/// A ray that ends nearer than this share of the value is not looked at closer.
constexpr double ShortRay = 0.2;

/// By less, as a share of the lower one, values do not jump.
constexpr double Slight = 0.02;

/// Rays are divided this often, whatever they meet.
constexpr int LeastDivisions = 2;
constexpr int MostDivisions = 20;

/// Edges are dealt to so many tasks. Each lists at most MostRays rays.
constexpr std::size_t NumberOfTasks = 64;
constexpr std::size_t MostRays = 1 << 14;

/// From the border outward, with the value there.
struct Ray
{
  Point2 Start;
  Point2 Direction;
  double Value = 0.0;   ///< as given
  double Most = 0.0;    ///< of the spacing where it starts
  double Length = 0.0;  ///< as far as no other place of the border is nearer
  double Least = 0.0;   ///< of the spacings on both sides of its end
  bool HasJump = false; ///< at its end

  Point2 At(double length) const { return this->Start + length * this->Direction; }
};

/// Lists rays from the border.
class BorderRays
{
public:
  BorderRays(const TriangleInterpolator& source, const std::vector<double>& most,
    const SteepRule& rule, SegmentSource& edges)
    : Source(source)
    , Most(most)
    , Rule(rule)
    , Edges(edges)
  {
  }

  /// From an edge, and around its end as far as the normal of the next one, if there is one.
  void ListFrom(const BorderEdge& edge, const BorderEdge* next)
  {
    constexpr double Slightly = 1e-3;
    const double length = Distance(edge.Start, edge.End);
    const Ray first{ edge.Start, OutwardOf(edge), edge.StartValue, this->MostAt(edge.StartId) };
    const Ray last{ edge.End, first.Direction, edge.EndValue, this->MostAt(edge.EndId) };
    if (this->Source.ValueInside(Midpoint(first.At(Slightly * length), last.At(Slightly * length))))
    {
      return;
    }
    const double rise = this->Rule.Range(last.Value) - this->Rule.Range(first.Value);
    this->IsSteep = std::abs(rise) > this->Rule.Slope * length;
    this->Divide(first, last, 0);
    this->IsSteep = false;
    if (next != nullptr && Cross(first.Direction, OutwardOf(*next)) > 0.0)
    {
      this->Divide(last, { edge.End, OutwardOf(*next), edge.EndValue, last.Most }, 0);
    }
  }

private:
  static Point2 OutwardOf(const BorderEdge& edge)
  {
    const Point2 along = edge.End - edge.Start;
    return (-1.0 / Length(along)) * Perpendicular(along);
  }

  double MostAt(Id point) const { return this->Most[static_cast<std::size_t>(point)]; }

  /// A share of a spacing, less where the slope is large.
  double ShareOf(double spacing, double share) const
  {
    return DistanceOfPoints(share, this->Rule.Slope) * spacing;
  }

  /// Casts the ray between two others, and those on both sides of it where they are far apart, or
  /// differ in value and in length.
  void Divide(Ray first, Ray last, int divisions)
  {
    const double base = Distance(first.Start, last.Start);
    const double least = this->Rule.Range(std::min(first.Value, last.Value));
    if (divisions == 0)
    {
      this->Cast(first, this->IsSteep);
      this->Cast(last, this->IsSteep);
    }
    const Point2 sum = first.Direction + last.Direction;
    Ray middle{ Midpoint(first.Start, last.Start), (1.0 / Length(sum)) * sum,
      0.5 * (first.Value + last.Value),
      std::min(first.Most, last.Most) + 0.5 * this->Rule.Slope * base };
    this->Cast(middle, this->IsSteep || first.HasJump || last.HasJump);
    const double width = base +
      Distance(first.Direction, last.Direction) *
        std::max({ first.Length, middle.Length, last.Length });
    const double rise = this->Rule.Range(std::max(first.Value, last.Value)) - least;
    const bool isAlike = rise <= LargestRise * least || base <= this->ShareOf(least, LeastBase) ||
      std::min(first.Length, last.Length) > 0.5 * middle.Length;
    if ((isAlike && width <= this->ShareOf(std::min(least, middle.Least), WidthOfRay)) ||
      divisions == MostDivisions || this->Count > MostRays)
    {
      return;
    }
    if (divisions < LeastDivisions || this->IsSteep || first.HasJump || middle.HasJump ||
      last.HasJump)
    {
      this->Divide(first, middle, divisions + 1);
      this->Divide(middle, last, divisions + 1);
    }
  }

  /// Finds where a ray ends: the largest ball that touches the border where it starts, with its
  /// center on the ray, is made smaller until no other place of the border is in it, or it is far
  /// smaller than both values. Lists the lower value up to there, and that of steep edges.
  void Cast(Ray& ray, bool isNeeded)
  {
    const double own = this->Rule.Range(ray.Value);
    const double most = this->LengthInBounds(ray);
    const double below = (own - ray.Most) / this->Rule.Slope + this->ShareOf(own, ShortRay);
    ray.Length = std::min(std::max(this->ShareOf(own, ShortRay), below), most);
    ray.Least = own;
    ray.HasJump = false;
    NearestValue found = this->NearerAt(ray);
    if (ray.Length <= below && (found.Edge != nullptr || ray.Length == most))
    {
      return;
    }
    while (found.Edge == nullptr && ray.Length < most)
    {
      ray.Length = std::min(4.0 * ray.Length, most);
      found = this->NearerAt(ray);
    }
    NearestValue other{ 0.0, own };
    for (bool isLast = false; found.Edge != nullptr && !isLast;)
    {
      other = found;
      const Point2 toFoot = found.Foot - ray.Start;
      const double length = 0.5 * Dot(toFoot, toFoot) / Dot(toFoot, ray.Direction);
      // Where rounding leaves the ball as it was, it is the last one, too.
      isLast =
        !(length < ray.Length) || length < this->ShareOf(std::min(own, found.Value), ShortRay);
      ray.Length = std::min(length, ray.Length);
      found = isLast ? found : this->NearerAt(ray);
    }
    ray.Least = std::min(own, other.Value);
    ray.HasJump = ray.Length > 0.0 && std::abs(own - other.Value) > Slight * ray.Least;
    const bool isLow = ray.HasJump && own < other.Value;
    if (ray.Length > 0.0 && (isNeeded || isLow))
    {
      this->Add(ray.Start, ray, own);
    }
    if (ray.HasJump && !isLow)
    {
      this->Add(other.Foot, ray, other.Value);
    }
  }

  void Add(const Point2& place, const Ray& ray, double value)
  {
    this->Count += 1;
    this->Edges.Add(place, ray.At(ray.Length), value, value);
  }

  /// What is nearer to the end of a ray than its start.
  NearestValue NearerAt(const Ray& ray) const
  {
    constexpr double Nearer = 1.0 - 1e-6;
    NearestValue found =
      Nearest(this->Source.BorderEdges(), ray.At(ray.Length), { Nearer * ray.Length, Infinity });
    found.Value = this->Rule.Range(found.Value);
    return found;
  }

  double LengthInBounds(const Ray& ray) const
  {
    double length = Infinity;
    for (std::size_t d = 0; d < 2; ++d)
    {
      const Point2& limit = ray.Direction[d] < 0.0 ? this->Rule.Bounds.Low : this->Rule.Bounds.High;
      length = ray.Direction[d] != 0.0
        ? std::min(length, (limit[d] - ray.Start[d]) / ray.Direction[d])
        : length;
    }
    return length;
  }

  const TriangleInterpolator& Source;
  const std::vector<double>& Most;
  const SteepRule& Rule;
  SegmentSource& Edges;
  bool IsSteep = false; ///< the edge that rays come from
  std::size_t Count = 0;
};

} // namespace

void AddJumpsOutside(const TriangleInterpolator& source, const std::vector<double>& most,
  const SteepRule& rule, SegmentSource& edges, Pulse& pulse)
{
  const std::vector<BorderEdge>& border = source.BorderEdges().Items();
  std::vector<const BorderEdge*> edgeFrom; // of the source's points
  for (const BorderEdge& edge : border)
  {
    edgeFrom.resize(
      std::max(edgeFrom.size(), static_cast<std::size_t>(std::max(edge.StartId, edge.EndId)) + 1));
    edgeFrom[static_cast<std::size_t>(edge.StartId)] = &edge;
  }
  std::array<SegmentSource, NumberOfTasks> parts;
  DoTasks(pulse, parts.size(),
    [&source, &most, &rule, &parts, &border, &edgeFrom](std::size_t k, Monitor& monitor)
    {
      Pulse own(monitor);
      BorderRays rays(source, most, rule, parts[k]);
      const std::size_t last = (k + 1) * border.size() / NumberOfTasks;
      for (std::size_t edge = k * border.size() / NumberOfTasks; edge < last && own.Beat(64);
           ++edge)
      {
        rays.ListFrom(border[edge], edgeFrom[static_cast<std::size_t>(border[edge].EndId)]);
      }
    });
  for (const SegmentSource& part : parts)
  {
    edges.Add(part);
  }
}

} // namespace biting
