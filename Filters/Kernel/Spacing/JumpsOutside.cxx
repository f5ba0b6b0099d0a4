// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SegmentCone.h"
#include "TriangleInterpolator.h"

#include <array> // for neighbors
#include <cmath> // for abs, sqrt

namespace biting
{
namespace
{

/// Shares of the value. A chord stands for a part of a curve where the middle is at most LargestSag
/// away from it and rays are at most WidthOfPart apart. A ray that ends nearer than ShortRay is not
/// looked at closer. Values that differ by less than Slight do not jump.
constexpr double LargestSag = 0.1;
constexpr double WidthOfPart = 2.0;
constexpr double ShortRay = 0.1;
constexpr double Slight = 0.02;

constexpr int MostDivisions = 12;

/// From the border outward, up to where another place of the border is as near.
struct Ray
{
  Point2 Start;
  Point2 Direction;
  double Value = 0.0;    ///< of the spacing where it starts
  double Most = 0.0;     ///< what bounds f there
  double Length = 0.0;   ///< an upper bound where it is of no use
  double Other = 0.0;    ///< the value at the other place; Value where there is none
  Point2 Foot = Start;   ///< the other place; Start where there is none
  bool IsUseful = false; ///< limits f somewhere

  Point2 End() const { return this->Start + this->Length * this->Direction; }
};

/// Lists what limits f, for one edge of the border after the other.
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

  /// From an edge, and around its end as far as the normal of the next one.
  void ListFrom(const BorderEdge& edge, const BorderEdge& previous, const BorderEdge& next)
  {
    constexpr double Slightly = 1e-3;
    constexpr int PartsOfClamped = 16;
    const Point2 outward = OutwardOf(edge);
    const double length = Distance(edge.Start, edge.End);
    if (this->Source.ValueInside(Midpoint(edge.Start, edge.End) + Slightly * length * outward))
    {
      return;
    }
    this->Neighbors = { previous.Start, next.End };
    const ValueRange& range = this->Rule.Range;
    const double values[2] = { range.Scale * edge.StartValue, range.Scale * edge.EndValue };
    const bool isLinear = range(edge.StartValue) == values[0] && range(edge.EndValue) == values[1];
    const int parts = isLinear ? 1 : PartsOfClamped;
    const auto rayAt = [this, &edge, parts](int k)
    { return this->RayAt(edge, static_cast<double>(k) / parts); };
    Ray last = rayAt(0);
    this->CastEnd(last, edge.End, rayAt(1), previous.Start);
    for (int k = 1; k <= parts; ++k)
    {
      const Ray first = last;
      last = rayAt(k);
      k < parts ? this->Cast(last, 0.0) : this->CastEnd(last, edge.Start, rayAt(k - 1), next.End);
      this->ListBetween(first, last);
    }
    Ray turned = last;
    turned.Direction = OutwardOf(next);
    // Where the border meets itself the next edge may be beyond triangles.
    if (Cross(outward, turned.Direction) > 0.0 &&
      !this->Source.ValueInside(edge.End + Slightly * length * (outward + turned.Direction)))
    {
      this->Cast(turned, last.Length);
      this->Turn(last, turned, 1.0);
      this->Turn(turned, last, -1.0);
      this->Divide(last, turned, 0);
    }
  }

private:
  static Point2 OutwardOf(const BorderEdge& edge)
  {
    const Point2 along = edge.End - edge.Start;
    return (-1.0 / Length(along)) * Perpendicular(along);
  }

  Ray RayAt(const BorderEdge& edge, double share) const
  {
    const double rise = this->Rule.Slope * Distance(edge.Start, edge.End);
    return { edge.Start + share * (edge.End - edge.Start), OutwardOf(edge),
      this->Rule.Range((1.0 - share) * edge.StartValue + share * edge.EndValue),
      std::min(
        this->Most[edge.StartId] + share * rise, this->Most[edge.EndId] + (1.0 - share) * rise) };
  }

  /// A share of a spacing, less where the slope is large.
  double ShareOf(double spacing, double share) const
  {
    return DistanceOfPoints(share, this->Rule.Slope) * spacing;
  }

  /// Where the neighbor of an edge turns to its side, a ray from their corner has no length. From
  /// there the curve goes no steeper than between both edges: of no use where values grow along it
  /// above what bounds f, which grows with the slope.
  void CastEnd(Ray& ray, const Point2& end, const Ray& inner, const Point2& neighbor)
  {
    const Point2 way = neighbor - ray.Start;
    if (!(Dot(ray.Direction, way) > 0.0))
    {
      this->Cast(ray, 0.0);
      return;
    }
    const Point2 along = (1.0 / Distance(ray.Start, end)) * (end - ray.Start);
    const Point2 across = (1.0 / Length(way)) * way;
    ray.Other = ray.Value;
    ray.IsUseful = (inner.Value - ray.Most) * Length(along + across) <
      2.0 * this->Rule.Slope * Distance(ray.Start, inner.Start);
  }

  /// Turns a ray towards another one past the places where it ends, each time until it may be far
  /// longer, and lists the curve in between.
  void Turn(Ray& ray, const Ray& other, double side)
  {
    constexpr double Growth = 4.0;
    for (int k = 0; k < MostDivisions; ++k)
    {
      const Point2 way = ray.Foot - ray.Start;
      const double length = ray.IsUseful ? Growth * ray.Length : this->LeastLength(ray);
      const double share = std::min(0.5 * Length(way) / length, 1.0);
      Ray next = ray;
      next.Direction = (1.0 / Length(way)) *
        (share * way + side * std::sqrt(1.0 - share * share) * Perpendicular(way));
      if (!(side * Cross(next.Direction, other.Direction) > 0.0))
      {
        return;
      }
      this->Cast(next, ray.Length);
      this->Divide(ray, next, 0);
      ray = next;
    }
  }

  /// From where on a ray is of use.
  double LeastLength(const Ray& ray) const
  {
    return (ray.Value - ray.Most) / this->Rule.Slope + this->ShareOf(ray.Value, ShortRay);
  }

  /// Of a part of an edge.
  void ListBetween(const Ray& first, const Ray& last)
  {
    const Ray& low = first.Value < last.Value ? first : last;
    this->IsSteep =
      std::abs(last.Value - first.Value) > this->Rule.Slope * Distance(first.Start, last.Start);
    if (this->IsSteep && low.IsUseful && low.Length > 0.0)
    {
      this->Edges.Add(low.Start, low.End(), low.Value, low.Value);
    }
    this->Divide(first, last, 0);
    this->IsSteep = false;
  }

  /// Whether f is limited by the curve on which a ray ends.
  bool IsNeeded(const Ray& ray) const
  {
    return ray.IsUseful &&
      ((1.0 + Slight) * ray.Value < ray.Other ||
        (this->IsSteep && ray.Value <= (1.0 + Slight) * ray.Other));
  }

  /// Lists the chords of the curve on which the rays between two others end.
  void Divide(const Ray& first, const Ray& last, int divisions)
  {
    const double base = Distance(first.Start, last.Start);
    const Point2 sum = first.Direction + last.Direction;
    Ray middle{ Midpoint(first.Start, last.Start), (1.0 / Length(sum)) * sum,
      0.5 * (first.Value + last.Value),
      std::min(first.Most, last.Most) + 0.5 * this->Rule.Slope * base };
    this->Cast(middle, std::max(first.Length, last.Length));
    const bool isNeeded = this->IsNeeded(first) || this->IsNeeded(middle) || this->IsNeeded(last) ||
      first.IsUseful != middle.IsUseful || middle.IsUseful != last.IsUseful;
    if (divisions > 0 && !isNeeded)
    {
      return;
    }
    const double least =
      std::min({ first.Value, last.Value, first.Other, middle.Other, last.Other });
    const double width = base +
      Distance(first.Direction, last.Direction) *
        std::max({ first.Length, middle.Length, last.Length });
    const bool isAlike = std::abs(last.Value - first.Value) <= 2.0 * Slight * least;
    const bool isFine = first.IsUseful == last.IsUseful
      ? width <= this->ShareOf(least, WidthOfPart) && this->AreOnChord(first, middle, last)
      : isAlike && width <= this->ShareOf(least, LargestSag);
    if (isFine || divisions == MostDivisions)
    {
      this->AddChord(first, middle);
      this->AddChord(middle, last);
      return;
    }
    this->Divide(first, middle, divisions + 1);
    this->Divide(middle, last, divisions + 1);
  }

  /// Whether a chord, and what bounds f where a ray starts, limit f as the ray does in between.
  bool AreOnChord(const Ray& first, const Ray& middle, const Ray& last) const
  {
    const SegmentCone chord(first.End(), last.End(), first.Value, last.Value, this->Rule.Slope);
    const Point2 end = middle.End();
    const double bound =
      std::min(chord(end, this->Rule.Slope), middle.Most + this->Rule.Slope * middle.Length);
    return !middle.IsUseful ||
      (first.IsUseful && bound <= (1.0 + Slight) * middle.Value &&
        (chord.Length == 0.0 ||
          Length(chord.From(end).Away) <= this->ShareOf(middle.Value, LargestSag)));
  }

  /// Where one of the rays is of no use, the other one in place of the chord.
  void AddChord(const Ray& first, const Ray& last)
  {
    if (first.IsUseful != last.IsUseful)
    {
      const Ray& ray = first.IsUseful ? first : last;
      this->Edges.Add(ray.Start, ray.End(), ray.Value, ray.Value);
      return;
    }
    const double rise = last.Value - first.Value;
    const bool isSteep = std::abs(rise) > this->Rule.Slope * Distance(first.End(), last.End());
    if ((this->IsNeeded(first) || this->IsNeeded(last)) &&
      (!isSteep || (rise > 0.0 ? first : last).Length > 0.0))
    {
      this->Edges.Add(first.End(), last.End(), first.Value, last.Value);
    }
  }

  /// Finds where a ray ends: the largest ball that touches the border where it starts, with its
  /// center on the ray, is made smaller until no other place of the border is in it, or it is far
  /// smaller than both values. Starts from a likely length.
  void Cast(Ray& ray, double likely)
  {
    const double own = ray.Value;
    ray.Foot = ray.Start;
    double most = Distance(ray.Start, this->Rule.Bounds.Center()) + this->Rule.Bounds.Diagonal();
    for (const Point2& neighbor : this->Neighbors)
    {
      const double length = LengthTo(neighbor, ray);
      if (length > 0.0 && 1.01 * length < most)
      {
        most = 1.01 * length;
        ray.Foot = neighbor;
      }
    }
    const double below = this->LeastLength(ray);
    ray.Other = own;
    ray.IsUseful = false;
    ray.Length = std::min(std::max(this->ShareOf(own, ShortRay), below), most);
    if (most <= below)
    {
      return;
    }
    NearestValue found = this->NearerAt(ray);
    ray.Foot = found.Edge != nullptr ? found.Foot : ray.Foot;
    ray.IsUseful = ray.Length > below || found.Edge == nullptr;
    for (double next = likely; found.Edge == nullptr && ray.Length < most; next = 4.0 * ray.Length)
    {
      ray.Length = std::min(std::max(ray.Length, next), most);
      found = this->NearerAt(ray);
    }
    for (bool isLast = !ray.IsUseful; found.Edge != nullptr && !isLast;)
    {
      ray.Other = found.Value;
      ray.Foot = found.Foot;
      const double length = std::max(LengthTo(found.Foot, ray), 0.0);
      const double lower = std::min(own, found.Value);
      // Where rounding leaves the ball as it was, it is the last one, too.
      isLast = !(length < ray.Length - this->ShareOf(lower, Slight)) ||
        length < this->ShareOf(lower, ShortRay);
      ray.Length = std::min(length, ray.Length);
      found = isLast ? found : this->NearerAt(ray);
    }
  }

  /// To where a place is as near as the start; not positive for one on the other side.
  static double LengthTo(const Point2& place, const Ray& ray)
  {
    const Point2 way = place - ray.Start;
    return 0.5 * Dot(way, way) / Dot(way, ray.Direction);
  }

  /// What is nearer to the end of a ray than its start.
  NearestValue NearerAt(const Ray& ray) const
  {
    constexpr double Nearer = 1.0 - 1e-6;
    NearestValue found =
      Nearest(this->Source.BorderEdges(), ray.End(), { Nearer * ray.Length, Infinity });
    found.Value = this->Rule.Range(found.Value);
    return found;
  }

  const TriangleInterpolator& Source;
  const std::vector<double>& Most;
  const SteepRule& Rule;
  SegmentSource& Edges;
  std::array<Point2, 2> Neighbors; ///< the next points of the border, before and behind the edge
  bool IsSteep = false;            ///< the part of an edge that rays come from
};

} // namespace

void AddJumpsOutside(const TriangleInterpolator& source, const std::vector<double>& most,
  const SteepRule& rule, SegmentSource& edges, Pulse& pulse)
{
  const std::vector<BorderEdge>& border = source.BorderEdges().Items();
  std::vector<const BorderEdge*> edgeFrom(most.size()); // of the source's points
  std::vector<const BorderEdge*> edgeTo(most.size());
  for (const BorderEdge& edge : border)
  {
    // Where the border ends, by triangles on each other, an edge follows itself.
    edgeFrom[edge.EndId] = &edge;
    edgeTo[edge.StartId] = &edge;
  }
  for (const BorderEdge& edge : border)
  {
    edgeFrom[edge.StartId] = &edge;
    edgeTo[edge.EndId] = &edge;
  }
  BorderRays rays(source, most, rule, edges);
  for (std::size_t k = 0; k < border.size() && pulse.Beat(256); ++k)
  {
    const BorderEdge& edge = border[k];
    rays.ListFrom(edge, *edgeTo[edge.StartId], *edgeFrom[edge.EndId]);
  }
}

} // namespace biting
