// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SegmentCone.h"
#include "TriangleInterpolator.h"

#include "../Base/Tasks.h"

#include <array> // for parts
#include <cmath> // for abs

namespace biting
{
namespace
{

/// A part of a curve is replaced by its chord where its middle is no farther from that, and its
/// rays are no farther apart, than these shares of the value.
constexpr double LargestSag = 0.1;
constexpr double WidthOfPart = 2.0;

/// Where rays start no farther apart than this share of the value they stand for those between.
constexpr double LeastBase = 0.01;

/// A ray that ends nearer than this share of the value is not looked at closer.
constexpr double ShortRay = 0.1;

/// By less, as a share of the lower one, values do not jump, and chords need not be exact.
constexpr double Slight = 0.02;

/// Curves are divided this often, whatever rays meet.
constexpr int LeastDivisions = 1;
constexpr int MostDivisions = 20;

/// Edges are dealt to so many tasks. Each lists at most MostParts rays and chords.
constexpr std::size_t NumberOfTasks = 64;
constexpr std::size_t MostParts = 1 << 16;

/// From the border outward, up to where another place of the border is as near.
struct Ray
{
  Point2 Start;
  Point2 Direction;
  double Value = 0.0;    ///< of the spacing where it starts
  double Most = 0.0;     ///< what bounds f there
  double Length = 0.0;   ///< an upper bound where it does not limit f
  double Other = 0.0;    ///< the value at the other place; Value where there is none
  bool IsUseful = false; ///< limits f somewhere

  Point2 At(double length) const { return this->Start + length * this->Direction; }
  Point2 End() const { return this->At(this->Length); }
  bool IsBelow() const { return (1.0 + Slight) * this->Value < this->Other; }
  bool IsAbove() const { return (1.0 + Slight) * this->Other < this->Value; }
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

  /// From an edge, and around its end as far as the normal of the next one. Null: there is none.
  void ListFrom(const BorderEdge& edge, const BorderEdge* previous, const BorderEdge* next)
  {
    constexpr double Slightly = 1e-3;
    const double length = Distance(edge.Start, edge.End);
    const Point2 outward = OutwardOf(edge);
    if (this->Source.ValueInside(Midpoint(edge.Start, edge.End) + Slightly * length * outward))
    {
      return;
    }
    const double shares[4] = { 0.0, this->ShareAt(edge, this->Rule.Range.Least, 0.0),
      this->ShareAt(edge, this->Rule.Range.Most, 1.0), 1.0 };
    const auto [from, to] = std::minmax(shares[1], shares[2]);
    const double sorted[4] = { 0.0, from, to, 1.0 };
    Ray last = this->RayAt(edge, 0.0);
    this->CastEnd(last, previous != nullptr ? previous->Start - edge.Start : outward);
    for (std::size_t k = 1; k < 4; ++k)
    {
      if (sorted[k] > sorted[k - 1])
      {
        const Ray first = last;
        last = this->RayAt(edge, sorted[k]);
        const bool isEnd = sorted[k] == 1.0;
        this->CastEnd(last, isEnd && next != nullptr ? next->End - edge.End : -1.0 * outward);
        this->ListBetween(first, last);
      }
    }
    Ray turned = last;
    turned.Direction = next != nullptr ? OutwardOf(*next) : outward;
    if (Cross(outward, turned.Direction) > 0.0)
    {
      this->Cast(turned, last.Length);
      this->Divide(last, turned, 0);
    }
  }

private:
  static Point2 OutwardOf(const BorderEdge& edge)
  {
    const Point2 along = edge.End - edge.Start;
    return (-1.0 / Length(along)) * Perpendicular(along);
  }

  /// Where along an edge values reach a bound; `none` where they do not.
  double ShareAt(const BorderEdge& edge, double bound, double none) const
  {
    const double low = this->Rule.Range.Scale * edge.StartValue;
    const double high = this->Rule.Range.Scale * edge.EndValue;
    return (low < bound) != (high < bound) ? std::min((bound - low) / (high - low), 1.0) : none;
  }

  Ray RayAt(const BorderEdge& edge, double share) const
  {
    const double rise = this->Rule.Slope * Distance(edge.Start, edge.End);
    return { edge.Start + share * (edge.End - edge.Start), OutwardOf(edge),
      this->Rule.Range((1.0 - share) * edge.StartValue + share * edge.EndValue),
      std::min(this->Most[static_cast<std::size_t>(edge.StartId)] + share * rise,
        this->Most[static_cast<std::size_t>(edge.EndId)] + (1.0 - share) * rise) };
  }

  /// A share of a spacing, less where the slope is large.
  double ShareOf(double spacing, double share) const
  {
    return DistanceOfPoints(share, this->Rule.Slope) * spacing;
  }

  /// Into an edge that turns to its side a ray has no length.
  void CastEnd(Ray& ray, const Point2& neighbor)
  {
    ray.Other = ray.Value;
    ray.IsUseful = Dot(ray.Direction, neighbor) > 0.0;
    if (!ray.IsUseful)
    {
      this->Cast(ray, 0.0);
    }
  }

  /// Of a part of an edge.
  void ListBetween(const Ray& first, const Ray& last)
  {
    const Ray& low = first.Value < last.Value ? first : last;
    const double rise = std::abs(last.Value - first.Value);
    this->IsSteep = rise > this->Rule.Slope * Distance(first.Start, last.Start);
    if (this->IsSteep && low.IsUseful && low.Length > 0.0)
    {
      this->Add(low.Start, low.End(), low.Value, low.Value);
    }
    this->Divide(first, last, 0);
    this->IsSteep = false;
  }

  /// Whether f is limited by the curve on which a ray ends.
  bool IsNeeded(const Ray& ray) const
  {
    return ray.IsUseful && (ray.IsBelow() || (this->IsSteep && !ray.IsAbove()));
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
    const bool isNeeded = this->IsNeeded(first) || this->IsNeeded(middle) || this->IsNeeded(last);
    if (!isNeeded && divisions >= LeastDivisions)
    {
      return;
    }
    const bool isLast = divisions == MostDivisions || this->Count > MostParts ||
      (divisions > 0 && base > 0.0 && base <= this->ShareOf(middle.Value, LeastBase));
    if (isLast || this->AreOnChord(first, middle, last))
    {
      this->AddChord(first, middle);
      this->AddChord(middle, last);
      return;
    }
    this->Divide(first, middle, divisions + 1);
    this->Divide(middle, last, divisions + 1);
  }

  bool AreOnChord(const Ray& first, const Ray& middle, const Ray& last) const
  {
    const double least =
      std::min({ first.Value, last.Value, first.Other, middle.Other, last.Other });
    const double width = Distance(first.Start, last.Start) +
      Distance(first.Direction, last.Direction) *
        std::max({ first.Length, middle.Length, last.Length });
    const SegmentCone chord(first.End(), last.End(), first.Value, last.Value, this->Rule.Slope);
    const SegmentCone::View view = chord.From(middle.End());
    const double bound = std::min(view.Value + this->Rule.Slope * Length(view.Away),
      middle.Most + this->Rule.Slope * middle.Length);
    if (!first.IsUseful && !last.IsUseful)
    {
      return !middle.IsUseful;
    }
    if (!first.IsUseful || !last.IsUseful)
    {
      const Ray& useful = first.IsUseful ? first : last;
      return !middle.IsUseful ||
        std::min(useful.Value + this->Rule.Slope * Distance(useful.End(), middle.End()),
          middle.Most + this->Rule.Slope * middle.Length) <= (1.0 + Slight) * middle.Value;
    }
    return width <= this->ShareOf(least, WidthOfPart) &&
      (!middle.IsUseful || bound <= (1.0 + Slight) * middle.Value) &&
      (chord.Length == 0.0 || Length(view.Away) <= this->ShareOf(least, LargestSag));
  }

  void AddChord(const Ray& first, const Ray& last)
  {
    if (!this->IsNeeded(first) && !this->IsNeeded(last))
    {
      return;
    }
    const Ray& start = first.IsUseful ? first : last;
    const Ray& end = last.IsUseful ? last : first;
    this->Add(start.End(), end.End(), start.Value, end.Value);
  }

  void Add(const Point2& start, const Point2& end, double startValue, double endValue)
  {
    this->Count += 1;
    this->Edges.Add(start, end, startValue, endValue);
  }

  /// Finds where a ray ends: the largest ball that touches the border where it starts, with its
  /// center on the ray, is made smaller until no other place of the border is in it, or it is far
  /// smaller than both values.
  void Cast(Ray& ray, double likely)
  {
    const double own = ray.Value;
    const double most = this->LengthInBounds(ray);
    const double least = this->ShareOf(own, ShortRay);
    const double below = (own - ray.Most) / this->Rule.Slope + least;
    ray.Length = std::min(std::max(least, below), most);
    ray.Other = own;
    ray.IsUseful = false;
    NearestValue found = this->NearerAt(ray);
    if (ray.Length <= below && (found.Edge != nullptr || ray.Length == most))
    {
      return;
    }
    ray.IsUseful = true;
    for (double next = likely; found.Edge == nullptr && ray.Length < most; next = 4.0 * ray.Length)
    {
      ray.Length = std::min(std::max(ray.Length, next), most);
      found = this->NearerAt(ray);
    }
    for (bool isLast = false; found.Edge != nullptr && !isLast;)
    {
      ray.Other = found.Value;
      const Point2 toFoot = found.Foot - ray.Start;
      const double length = std::max(0.5 * Dot(toFoot, toFoot) / Dot(toFoot, ray.Direction), 0.0);
      const double lower = std::min(own, found.Value);
      // Where rounding leaves the ball as it was, it is the last one, too.
      isLast = !(length < ray.Length - this->ShareOf(lower, Slight)) ||
        length < this->ShareOf(lower, ShortRay);
      ray.Length = std::min(length, ray.Length);
      found = isLast ? found : this->NearerAt(ray);
    }
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
  bool IsSteep = false; ///< the part of an edge that rays come from
  std::size_t Count = 0;
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
    edgeFrom[static_cast<std::size_t>(edge.StartId)] = &edge;
    edgeTo[static_cast<std::size_t>(edge.EndId)] = &edge;
  }
  std::array<SegmentSource, NumberOfTasks> parts;
  DoTasks(pulse, parts.size(),
    [&source, &most, &rule, &parts, &border, &edgeFrom, &edgeTo](std::size_t k, Monitor& monitor)
    {
      Pulse own(monitor);
      BorderRays rays(source, most, rule, parts[k]);
      const std::size_t last = (k + 1) * border.size() / NumberOfTasks;
      for (std::size_t edge = k * border.size() / NumberOfTasks; edge < last && own.Beat(64);
           ++edge)
      {
        rays.ListFrom(border[edge], edgeTo[static_cast<std::size_t>(border[edge].StartId)],
          edgeFrom[static_cast<std::size_t>(border[edge].EndId)]);
      }
    });
  for (const SegmentSource& part : parts)
  {
    edges.Add(part);
  }
}

} // namespace biting
