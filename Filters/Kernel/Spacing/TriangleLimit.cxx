// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleLimit.h"

#include "../Base/SortInSteps.h"
#include "NodeBound.h"
#include "SegmentCone.h"
#include "SourceSlopes.h"

#include <array>      // for corners
#include <cstdint>    // for marks
#include <functional> // for greater, less
#include <queue>      // for the order of values
#include <tuple>      // for keys

namespace biting
{
namespace
{

/// A triangle is steep where the slope along one of its edges or the mean gradient around one of
/// its corners is above the gradation by more than this share of it, or its own gradient adds more
/// than this share of f. The gradient of one triangle exceeds that of a function with slope g even
/// where its edges do not.
constexpr double SteepnessMargin = 0.005;

/// A gradient so many times as steep as the gradation is above it along an edge of most triangles.
constexpr double SeenByPoints = 1.45;

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

class TriangleLimiter
{
public:
  TriangleLimiter(
    const TriangulatedSource& source, double gradation, ConeCollector& cones, Monitor& monitor)
    : Source(source)
    , Gradation(gradation)
    , Cones(cones)
    , Beats(monitor)
  {
  }

  std::vector<double> Run()
  {
    if (!this->AverageGradients() || !this->FindSteep())
    {
      return {};
    }
    this->FileTriangles();
    this->SetGiven();
    this->PushSources();
    this->HandOn();
    this->FindWide();
    this->AddCones();
    return this->Limits();
  }

private:
  /// MeanGradients: of the triangles around each point, weighted by area.
  bool AverageGradients()
  {
    this->MeanGradients.resize(this->Source.Points.size());
    std::vector<double> areas(this->Source.Points.size(), 0.0);
    const std::size_t size = this->Source.Triangles.size();
    for (std::size_t first = 0; first + 2 < size && this->Beats.Beat(); first += 3)
    {
      const Point2 gradient = GradientOfTriangle(this->Source, first);
      const double area = AreaOfTriangle(this->Source, first);
      for (std::size_t corner = first; corner < first + 3 && area > 0.0; ++corner)
      {
        const std::size_t point = Index(this->Source.Triangles[corner]);
        areas[point] += area;
        this->MeanGradients[point] = this->MeanGradients[point] +
          (area / areas[point]) * (gradient - this->MeanGradients[point]);
      }
    }
    return !this->Beats.HasStopped();
  }

  /// Whether there is any.
  bool FindSteep()
  {
    bool isFound = false;
    this->IsSteepOne.reserve(this->Source.Triangles.size() / 3);
    for (std::size_t first = 0; first + 2 < this->Source.Triangles.size(); first += 3)
    {
      const bool isSteep = this->Beats.Beat() && this->IsSteep(first);
      const bool isSeen = isSteep &&
        this->SlopeOf(GradientOfTriangle(this->Source, first)) > SeenByPoints * this->Gradation;
      this->IsSteepOne.push_back(isSteep ? (isSeen ? 2 : 1) : 0);
      isFound = isFound || this->IsSteepOne.back() != 0;
    }
    return isFound && !this->Beats.HasStopped();
  }

  bool IsSteep(std::size_t first) const
  {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = 0.0;
    for (std::size_t corner = first; corner < first + 3; ++corner)
    {
      const double value = this->Source.Values[Index(this->Source.Triangles[corner])];
      if (std::isnan(value))
      {
        return false;
      }
      lowest = std::min(lowest, this->Cones.Values()(value));
      highest = std::max(highest, this->Cones.Values()(value));
    }
    const double slope = this->SlopeOf(GradientOfTriangle(this->Source, first));
    return highest > lowest && slope > this->MostSlope() &&
      this->IsSteepAround(first, slope, lowest);
  }

  double MostSlope() const { return (1.0 + SteepnessMargin) * this->Gradation; }

  double SlopeOf(const Point2& gradient) const
  {
    return this->Cones.Values().Scale * Length(gradient);
  }

  /// Whether a slope in one triangle is more than the rounding of a field that is nowhere steep.
  bool IsSteepAround(std::size_t first, double slope, double least) const
  {
    double longest = 0.0;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const std::size_t a = Index(this->Source.Triangles[first + corner]);
      const std::size_t b = Index(this->Source.Triangles[first + (corner + 1) % 3]);
      const double length = Distance(this->Source.Points[a], this->Source.Points[b]);
      const double rise =
        this->Cones.Values().Scale * std::abs(this->Source.Values[a] - this->Source.Values[b]);
      if (rise > this->MostSlope() * length ||
        this->SlopeOf(this->MeanGradients[a]) > this->MostSlope())
      {
        return true;
      }
      longest = std::max(longest, length);
    }
    return (slope - this->Gradation) * 0.5 * longest > SteepnessMargin * least;
  }

  // Lowering points.

  /// Triangles around point p: Around[Starts[p]] to Around[Starts[p + 1]], by their first corners.
  void FileTriangles()
  {
    this->Starts.assign(this->Source.Points.size() + 1, 0);
    for (Id point : this->Source.Triangles)
    {
      ++this->Starts[Index(point) + 1];
    }
    for (std::size_t point = 1; point < this->Starts.size(); ++point)
    {
      this->Starts[point] += this->Starts[point - 1];
    }
    std::vector<Id> next = this->Starts;
    this->Around.resize(this->Source.Triangles.size());
    for (std::size_t corner = 0; corner < this->Source.Triangles.size() && this->Beats.Beat(1);
         ++corner)
    {
      this->Around[Index(next[Index(this->Source.Triangles[corner])]++)] =
        static_cast<Id>(corner - corner % 3);
    }
  }

  double Given(Id point) const { return this->Cones.Values()(this->Source.Values[Index(point)]); }
  const Point2& Place(Id point) const { return this->Source.Points[Index(point)]; }
  Point2 Offset(const Point2& place) const { return place - this->Source.Points.front(); }
  static NodeBound::Offset Rounded(const Point2& offset)
  {
    return { static_cast<float>(offset.X), static_cast<float>(offset.Y) };
  }

  void SetGiven()
  {
    this->Bounds.reserve(this->Source.Points.size());
    for (Id point = 0; Index(point) < this->Source.Points.size() && this->Beats.Beat(1); ++point)
    {
      // A point without a value is a hole, which nothing leads through.
      const bool isHole = std::isnan(this->Source.Values[Index(point)]);
      const auto value = static_cast<float>(isHole ? 0.0 : this->Given(point));
      this->Bounds.push_back({ value, value, Rounded(this->Offset(this->Place(point))) });
    }
  }

  /// Of the corners of steep triangles, those that no neighbor lowers: from others f grows only after
  /// it was lowered there, and they wait for that.
  void PushSources()
  {
    std::vector<std::uint8_t> isLow(this->Source.Points.size(), 0);
    this->ForEachSteep(
      [this, &isLow](std::size_t first)
      {
        for (std::size_t corner = 0; corner < 3; ++corner)
        {
          const Id a = this->Source.Triangles[first + corner];
          const Id b = this->Source.Triangles[first + (corner + 1) % 3];
          const double rise = this->Gradation * Distance(this->Place(a), this->Place(b));
          isLow[Index(a)] |= this->Given(b) + rise < this->Given(a) ? 2 : 1;
          isLow[Index(b)] |= this->Given(a) + rise < this->Given(b) ? 2 : 1;
        }
      });
    for (Id point = 0; Index(point) < isLow.size(); ++point)
    {
      if (isLow[Index(point)] == 1)
      {
        this->Waiting.emplace(this->Bounds[Index(point)].Value, point);
      }
    }
  }

  template <typename Visit>
  void ForEachSteep(Visit visit)
  {
    for (std::size_t triangle = 0; triangle < this->IsSteepOne.size() && this->Beats.Beat();
         ++triangle)
    {
      if (this->IsSteepOne[triangle] != 0)
      {
        visit(3 * triangle);
      }
    }
  }

  void HandOn()
  {
    while (!this->Waiting.empty() && this->Beats.Beat())
    {
      const auto [value, point] = this->Waiting.top();
      this->Waiting.pop();
      if (value > this->Bounds[Index(point)].Value)
      {
        continue;
      }
      for (Id k = this->Starts[Index(point)]; k < this->Starts[Index(point) + 1]; ++k)
      {
        this->HandOnIn(Index(this->Around[Index(k)]), point);
      }
    }
  }

  /// To the other corners of a triangle: what bounds the point, and in a triangle that is
  /// a little too steep what is between it and a lower corner.
  void HandOnIn(std::size_t first, Id point)
  {
    for (std::size_t corner = first; corner < first + 3; ++corner)
    {
      const Id other = this->Source.Triangles[corner];
      if (other == point)
      {
        const Id next = this->Source.Triangles[first + (corner - first + 1) % 3];
        const Id last = this->Source.Triangles[first + (corner - first + 2) % 3];
        this->LowerFromEdge(point, next, last, first);
        this->LowerFromEdge(point, last, next, first);
        continue;
      }
      const NodeBound& from = this->Bounds[Index(point)];
      const Point2 place{ from.Place.X, from.Place.Y };
      this->Lower(other, place, from.Base);
    }
  }

  void LowerFromEdge(Id point, Id lower, Id target, std::size_t first)
  {
    const double from = this->Bounds[Index(point)].Value;
    const double to = this->Bounds[Index(lower)].Value;
    if (this->IsSteepOne[first / 3] == 0 ||
      !(to < from && from < this->Bounds[Index(target)].Value))
    {
      return;
    }
    const SegmentCone cone(this->Place(point), this->Place(lower), from, to, this->Gradation);
    const Point2 foot = cone.Foot(this->Place(target));
    this->Lower(target, this->Offset(foot), cone(foot, this->Gradation));
  }

  void Lower(Id point, const Point2& place, double base)
  {
    NodeBound& bound = this->Bounds[Index(point)];
    if (!(base < bound.Value))
    {
      return;
    }
    const auto value = static_cast<float>(
      base + this->Gradation * Distance(this->Offset(this->Place(point)), place));
    if (value < bound.Value)
    {
      bound = { value, static_cast<float>(base), Rounded(place) };
      this->Waiting.emplace(value, point);
    }
  }

  // Cones where triangles are wide.

  bool IsWide(std::size_t first) const
  {
    double longest = 0.0;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const Id a = this->Source.Triangles[first + corner];
      const Id b = this->Source.Triangles[first + (corner + 1) % 3];
      longest = std::max(longest, Distance(this->Place(a), this->Place(b)));
      least = std::min(least, this->Bounds[Index(a)].Value);
    }
    return this->Gradation * longest > WidestGrowth * least;
  }

  /// IsWidePoint: 2 for points of wide triangles, 1 for those of triangles that have such points.
  void FindWide()
  {
    this->IsWidePoint.assign(this->Source.Points.size(), 0);
    for (const std::uint8_t mark : { 2, 1 })
    {
      for (std::size_t first = 0; first + 2 < this->Source.Triangles.size() && this->Beats.Beat();
           first += 3)
      {
        const Id* corners = &this->Source.Triangles[first];
        const auto isMarked = [this](Id point) { return this->IsWidePoint[Index(point)] == 2; };
        if (mark == 2 ? this->IsWide(first) : std::any_of(corners, corners + 3, isMarked))
        {
          for (std::size_t corner = 0; corner < 3; ++corner)
          {
            std::uint8_t& old = this->IsWidePoint[Index(corners[corner])];
            old = std::max(old, mark);
          }
        }
      }
    }
  }

  void AddCones()
  {
    std::vector<NodeBound> places;
    for (std::size_t point = 0; point < this->IsWidePoint.size() && this->Beats.Beat(1); ++point)
    {
      if (this->IsWidePoint[point] != 0 && this->Bounds[point].IsOfOther())
      {
        places.push_back(this->Bounds[point]);
      }
    }
    const auto key = [](const NodeBound& bound)
    { return std::make_tuple(bound.Place.X, bound.Place.Y, bound.Base); };
    const auto isBefore = [&key](const NodeBound& a, const NodeBound& b)
    { return key(a) < key(b); };
    SortInSteps(places, isBefore, this->Beats);
    for (std::size_t k = 0; k < places.size() && this->Beats.Beat(1); ++k)
    {
      if (k == 0 || isBefore(places[k - 1], places[k]))
      {
        const Point2 offset{ places[k].Place.X, places[k].Place.Y };
        this->Cones.AddPoint(this->Source.Points.front() + offset, places[k].Base);
      }
    }
    this->ForEachSteep(
      [this](std::size_t first)
      {
        if (this->IsWide(first))
        {
          this->AddTriangle(first);
        }
      });
    SortInSteps(this->Edges, std::less<>(), this->Beats);
    this->Edges.erase(std::unique(this->Edges.begin(), this->Edges.end()), this->Edges.end());
    for (std::size_t edge = 0; edge < this->Edges.size() && this->Beats.Beat(); ++edge)
    {
      const auto [a, b] = this->Edges[edge];
      this->Cones.AddGiven(this->Place(a), this->Place(b), this->Source.Values[Index(a)],
        this->Source.Values[Index(b)]);
    }
  }

  void AddTriangle(std::size_t first)
  {
    std::vector<Point2> crossings;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const Id a = this->Source.Triangles[first + corner];
      const Id b = this->Source.Triangles[first + (corner + 1) % 3];
      this->AddCrossing(a, b, crossings);
      if (!this->IsBounded(a, a, b) && !this->IsBounded(b, a, b))
      {
        this->Edges.emplace_back(std::min(a, b), std::max(a, b));
      }
    }
    if (crossings.size() == 2)
    {
      const double least = this->Cones.Values().Least;
      this->Cones.AddSegment(crossings[0], crossings[1], least, least);
    }
  }

  /// Whether all of the edge a-b is above what bounds one of its ends.
  bool IsBounded(Id point, Id a, Id b) const
  {
    const NodeBound& bound = this->Bounds[Index(point)];
    return bound.IsOfOther() &&
      bound.Reaches(this->Offset(this->Place(a)), this->Given(a), this->Gradation) &&
      bound.Reaches(this->Offset(this->Place(b)), this->Given(b), this->Gradation);
  }

  /// Where f begins to exceed its least value, if that is within the edge.
  void AddCrossing(Id a, Id b, std::vector<Point2>& crossings) const
  {
    const double start = this->Cones.Values().Scale * this->Source.Values[Index(a)];
    const double end = this->Cones.Values().Scale * this->Source.Values[Index(b)];
    const double least = this->Cones.Values().Least;
    if ((start < least) != (end < least))
    {
      const double weight = (least - start) / (end - start);
      const Point2& from = this->Source.Points[Index(a)];
      crossings.push_back(from + weight * (this->Source.Points[Index(b)] - from));
    }
  }

  std::vector<double> Limits() const
  {
    std::vector<double> limits = this->Source.Values;
    for (std::size_t point = 0; point < this->Bounds.size(); ++point)
    {
      const NodeBound& bound = this->Bounds[point];
      if (this->IsWidePoint[point] != 2 && bound.IsBelow(this->Given(static_cast<Id>(point))))
      {
        limits[point] = bound.Value / this->Cones.Values().Scale;
      }
    }
    return limits;
  }

  using Entry = std::pair<float, Id>;

  const TriangulatedSource& Source;
  const double Gradation;
  ConeCollector& Cones;
  Pulse Beats;
  std::vector<Point2> MeanGradients;    ///< of what is given, at each point
  std::vector<std::uint8_t> IsSteepOne; ///< of each triangle: 2 where points alone see it
  std::vector<Id> Starts;
  std::vector<Id> Around;
  std::vector<NodeBound> Bounds;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> Waiting;
  std::vector<std::uint8_t> IsWidePoint;
  std::vector<std::pair<Id, Id>> Edges; ///< of wide steep triangles, that nothing bounds
};

} // namespace

std::vector<double> LimitTriangles(
  const TriangulatedSource& source, double gradation, ConeCollector& cones, Monitor& monitor)
{
  return TriangleLimiter(source, gradation, cones, monitor).Run();
}

} // namespace biting
