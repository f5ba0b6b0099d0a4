// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SteepTriangles.h"

#include "../Base/Numbers.h"
#include "../Base/SortInSteps.h"
#include "SegmentCone.h"
#include "SourceSlopes.h"
#include "TriangleEdges.h"

#include <algorithm>     // for min, max, none_of
#include <unordered_map> // for cuts of edges
#include <utility>       // for pairs

namespace biting
{
namespace
{

/// A triangle is steep where its gradient is above the gradation by more than this share of it, and
/// that is no artifact of its shape: so is the mean gradient around one of its corners, or it adds
/// more than this share of f.
constexpr double SteepMargin = 0.005;

/// A cone is left out where another one is nowhere in the plane above it by more than this share of
/// its least value; or where it is nowhere below what is given by more than this share of that.
constexpr double CoverTolerance = 0.005;
constexpr double IdleTolerance = 0.01;

/// Sides are looked at at their ends, in the middle, and at a quarter, an eighth and so on from
/// both ends, while f may grow as far as that by more than this share of it, but no nearer than the
/// least part of a side.
constexpr double GrowthBetween = 0.025;
constexpr double LeastPartOfSide = 1.0 / 256.0;

/// Of more cones at one point all are kept, and only so many are compared to others.
constexpr std::size_t MostComparedCones = 32;

/// Those parts of the steep triangles where the spacing is between its bounds, as triangles. Their
/// points are in the order of their values.
struct SteepParts
{
  std::vector<Point2> Points;
  std::vector<double> Values; ///< of f
  std::vector<Id> Corners;    ///< three a triangle
};

class PartCollector
{
public:
  PartCollector(const TriangulatedSource& source, double gradation, const ValueRange& range)
    : Source(source)
    , Gradation(gradation)
    , Range(range)
    , Gradients(source.Points.size())
    , Whole{ source.Points, source.Values, {} }
  {
    for (double& value : this->Whole.Values)
    {
      value *= range.Scale;
    }
  }

  SteepParts Collect(Pulse& pulse)
  {
    this->AverageGradients(pulse);
    pulse.ForEach(this->Source.Triangles.size() / 3,
      [this](std::size_t triangle)
      {
        if (this->IsSteep(3 * triangle))
        {
          this->AddParts(&this->Source.Triangles[3 * triangle]);
        }
      });
    return this->Sorted(pulse);
  }

private:
  using Cuts = std::unordered_map<std::uint64_t, Id>;

  /// Of the triangles around each point, weighted by area.
  void AverageGradients(Pulse& pulse)
  {
    std::vector<double> areas(this->Gradients.size(), 0.0);
    pulse.ForEach(this->Source.Triangles.size() / 3,
      [this, &areas](std::size_t triangle)
      {
        const Point2 gradient = GradientOfTriangle(this->Source, 3 * triangle);
        const double area = AreaOfTriangle(this->Source, 3 * triangle);
        for (std::size_t corner = 3 * triangle; corner < 3 * triangle + 3 && area > 0.0; ++corner)
        {
          const auto point = static_cast<std::size_t>(this->Source.Triangles[corner]);
          areas[point] += area;
          Point2& mean = this->Gradients[point];
          mean = mean + (area / areas[point]) * (gradient - mean);
        }
      });
  }

  bool IsSteep(std::size_t first) const
  {
    const double most = (1.0 + SteepMargin) * this->Gradation;
    const double slope = this->Range.Scale * Length(GradientOfTriangle(this->Source, first));
    if (!(slope > most))
    {
      return false;
    }
    Box2 box;
    double least = Infinity;
    for (std::size_t corner = first; corner < first + 3; ++corner)
    {
      const auto point = static_cast<std::size_t>(this->Source.Triangles[corner]);
      if (this->Range.Scale * Length(this->Gradients[point]) > most)
      {
        return true;
      }
      box.Add(this->Source.Points[point]);
      least = std::min(least, this->Range(this->Source.Values[point]));
    }
    return (slope - this->Gradation) * 0.5 * box.Diagonal() > SteepMargin * least;
  }

  void AddParts(const Id* corners)
  {
    this->Part.assign(corners, corners + 3);
    this->Cut(this->Range.Least, 1.0, this->CutsAtLeast);
    this->Cut(this->Range.Most, -1.0, this->CutsAtMost);
    for (std::size_t k = 2; k < this->Part.size(); ++k)
    {
      this->Whole.Corners.insert(
        this->Whole.Corners.end(), { this->Part[0], this->Part[k - 1], this->Part[k] });
    }
  }

  /// Keeps of the part what is on one side of a bound.
  void Cut(double bound, double sign, Cuts& cuts)
  {
    const auto isBeyond = [this, bound, sign](Id point)
    { return sign * this->ValueOf(point) < sign * bound; };
    if (std::none_of(this->Part.begin(), this->Part.end(), isBeyond))
    {
      return;
    }
    const std::vector<Id> before = this->Part;
    this->Part.clear();
    for (std::size_t k = 0; k < before.size(); ++k)
    {
      const Id start = before[k];
      const Id end = before[k + 1 < before.size() ? k + 1 : 0];
      if (!isBeyond(start))
      {
        this->Part.push_back(start);
      }
      if (isBeyond(start) != isBeyond(end) && this->ValueOf(start) != bound &&
        this->ValueOf(end) != bound)
      {
        this->Part.push_back(this->CutOf(std::min(start, end), std::max(start, end), bound, cuts));
      }
    }
  }

  /// The same point for both triangles of an edge.
  Id CutOf(Id start, Id end, double bound, Cuts& cuts)
  {
    constexpr int IdBits = 32;
    const auto [cut, isNew] = cuts.emplace(
      static_cast<std::uint64_t>(start) << IdBits | static_cast<std::uint64_t>(end), NoId);
    if (isNew)
    {
      const Point2 from = this->Whole.Points[static_cast<std::size_t>(start)];
      const Point2 to = this->Whole.Points[static_cast<std::size_t>(end)];
      const double weight =
        (bound - this->ValueOf(start)) / (this->ValueOf(end) - this->ValueOf(start));
      cut->second = static_cast<Id>(this->Whole.Points.size());
      this->Whole.Points.push_back(from + weight * (to - from));
      this->Whole.Values.push_back(bound);
    }
    return cut->second;
  }

  double ValueOf(Id point) const { return this->Whole.Values[static_cast<std::size_t>(point)]; }

  /// Those points that are corners, in the order of their values.
  SteepParts Sorted(Pulse& pulse)
  {
    std::vector<Id> newIds(this->Whole.Points.size(), NoId);
    std::vector<std::pair<double, Id>> order;
    std::vector<Id>& corners = this->Whole.Corners;
    pulse.ForEach(corners.size(),
      [this, &corners, &newIds, &order](std::size_t k)
      {
        Id& newId = newIds[static_cast<std::size_t>(corners[k])];
        if (newId == NoId)
        {
          newId = 0;
          order.emplace_back(this->ValueOf(corners[k]), corners[k]);
        }
      });
    SortInSteps(order, std::less<>(), pulse);
    SteepParts parts;
    for (const auto& [value, point] : order)
    {
      newIds[static_cast<std::size_t>(point)] = static_cast<Id>(parts.Points.size());
      parts.Points.push_back(this->Whole.Points[static_cast<std::size_t>(point)]);
      parts.Values.push_back(value);
    }
    pulse.ForEach(corners.size(),
      [&corners, &newIds](std::size_t k)
      { corners[k] = newIds[static_cast<std::size_t>(corners[k])]; });
    parts.Corners = std::move(corners);
    return parts;
  }

  const TriangulatedSource& Source;
  const double Gradation;
  const ValueRange& Range;
  std::vector<Point2> Gradients; ///< around points of the source
  SteepParts Whole;              ///< with all points of the source first, in its order
  Cuts CutsAtLeast;              ///< points by the ends of edges
  Cuts CutsAtMost;
  std::vector<Id> Part; ///< at work: corners of a polygon
};

/// Finds the edges and points from which f grows. Any edge that is not steep itself may be one, and
/// the lower end of steep ones. From the lowest point up, each hands the cone that is lowest there
/// on to those above; one is left out where such a cone stands for it. Of the others those are
/// needed that are below the values along a side of a triangle beside them.
class ConeFinder
{
public:
  ConeFinder(const SteepParts& parts, double gradation, double most, Pulse& pulse)
    : Parts(parts)
    , Gradation(gradation)
    , Most(most)
    , Beats(pulse)
    , Edges(parts.Corners, parts.Points.size(), pulse)
    , LowestAt(parts.Points.size())
    , FirstConeAt(parts.Points.size() + 1, 0)
  {
  }

  void Run(ConeCollector& cones)
  {
    for (std::size_t point = 0; point < this->Parts.Points.size() && this->Beats.Beat(32); ++point)
    {
      this->Settle(point);
    }
    for (std::size_t first = 0; first < this->Parts.Corners.size() && this->Beats.Beat(16);
         first += 3)
    {
      this->MarkNeeded(&this->Parts.Corners[first]);
    }
    for (std::size_t cone = 0; cone < this->Cones.size(); ++cone)
    {
      if (this->AreNeeded[cone])
      {
        const auto [low, high] = this->Ends[cone];
        cones.AddSegment(this->Parts.Points[low], this->Parts.Points[high], this->Parts.Values[low],
          this->Parts.Values[high]);
      }
    }
  }

private:
  /// The cone that is lowest at a point, of those that were offered.
  struct Lowest
  {
    Id Cone = NoId;
    double Value = Infinity;
  };

  const SegmentCone& At(Id cone) const { return this->Cones[static_cast<std::size_t>(cone)]; }

  void Settle(std::size_t point)
  {
    const std::size_t first = this->Edges.FirstAt(point);
    const std::size_t end = this->Edges.FirstAt(point + 1);
    for (std::size_t edge = first; edge < end; ++edge)
    {
      this->AddCone(point, static_cast<std::size_t>(this->Edges.HighEnd(edge)));
    }
    if (first < end && this->FirstConeAt[point] == this->Cones.size())
    {
      this->AddCone(point, point);
    }
    this->FirstConeAt[point + 1] = this->Cones.size();
    const bool areMany = this->Cones.size() > this->EndOfCompared(point);
    this->AreNeeded.resize(this->Cones.size(), areMany);
    const Id offered = this->LowestAt[point].Cone;
    for (std::size_t edge = first; edge < end; ++edge)
    {
      const auto high = static_cast<std::size_t>(this->Edges.HighEnd(edge));
      if (offered != NoId)
      {
        this->Offer(offered, high);
      }
      for (std::size_t cone = this->FirstConeAt[point]; cone < this->EndOfCompared(point); ++cone)
      {
        this->Offer(static_cast<Id>(cone), high);
      }
    }
  }

  std::size_t EndOfCompared(std::size_t point) const
  {
    return std::min(this->FirstConeAt[point + 1], this->FirstConeAt[point] + MostComparedCones);
  }

  /// Unless it is steep, or what is offered to its lower end stands for it.
  void AddCone(std::size_t low, std::size_t high)
  {
    const double value = this->Parts.Values[low];
    const SegmentCone cone(this->Parts.Points[low], this->Parts.Points[high], value,
      this->Parts.Values[high], this->Gradation);
    const Id offered = this->LowestAt[low].Cone;
    const bool isCovered = offered != NoId &&
      this->At(offered).StandsFor(cone, this->Gradation, CoverTolerance * cone.Value);
    if (value < this->Most && (cone.Length > 0.0 || low == high) && !isCovered)
    {
      this->Cones.push_back(cone);
      this->Ends.emplace_back(low, high);
    }
  }

  void Offer(Id cone, std::size_t point)
  {
    Lowest& lowest = this->LowestAt[point];
    const double value = this->At(cone)(this->Parts.Points[point], this->Gradation);
    if (value < lowest.Value && value <= (1.0 + CoverTolerance) * this->Parts.Values[point])
    {
      lowest = { cone, value };
    }
  }

  /// The cones of the corners of a triangle, and those that are lowest there.
  void MarkNeeded(const Id* corners)
  {
    this->Near.clear();
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto corner = static_cast<std::size_t>(corners[k]);
      this->LookAt(this->LowestAt[corner].Cone);
      for (std::size_t cone = this->FirstConeAt[corner]; cone < this->EndOfCompared(corner); ++cone)
      {
        this->LookAt(static_cast<Id>(cone));
      }
    }
    for (std::size_t k = 0; k < 3 && !this->Near.empty(); ++k)
    {
      this->MarkAlong(static_cast<std::size_t>(corners[k]),
        static_cast<std::size_t>(corners[k == 2 ? 0 : k + 1]));
    }
  }

  void LookAt(Id cone)
  {
    if (cone != NoId && !this->AreNeeded[static_cast<std::size_t>(cone)])
    {
      this->Near.push_back(cone);
    }
  }

  /// What a linear value is above a cone is concave along a side, so at half the way from an end to
  /// where it is largest no less than half of that.
  void MarkAlong(std::size_t start, std::size_t end)
  {
    this->MarkAt(start, end, 0.0);
    this->MarkAt(start, end, 0.5);
    const double growth =
      this->Gradation * Distance(this->Parts.Points[start], this->Parts.Points[end]);
    const double least = GrowthBetween * this->Parts.Values[std::min(start, end)];
    for (double share = 0.25; share * growth > least && share > LeastPartOfSide; share *= 0.5)
    {
      this->MarkAt(start, end, share);
      this->MarkAt(start, end, 1.0 - share);
    }
  }

  void MarkAt(std::size_t start, std::size_t end, double share)
  {
    const Point2& from = this->Parts.Points[start];
    const Point2 place = from + share * (this->Parts.Points[end] - from);
    const double given =
      (1.0 - share) * this->Parts.Values[start] + share * this->Parts.Values[end];
    for (const Id cone : this->Near)
    {
      const double value = this->At(cone)(place, this->Gradation);
      if (value < given - IdleTolerance * this->At(cone).Value)
      {
        this->AreNeeded[static_cast<std::size_t>(cone)] = true;
      }
    }
  }

  const SteepParts& Parts;
  const double Gradation;
  const double Most;
  Pulse& Beats;
  const TriangleEdges Edges;
  std::vector<Lowest> LowestAt;         ///< of each point
  std::vector<std::size_t> FirstConeAt; ///< of each point; and the end of the last one's
  std::vector<SegmentCone> Cones;
  std::vector<std::pair<std::size_t, std::size_t>> Ends; ///< of their segments: points
  std::vector<bool> AreNeeded;
  std::vector<Id> Near; ///< at work
};

} // namespace

void AddSteepTriangles(
  const TriangulatedSource& source, double gradation, ConeCollector& cones, Pulse& pulse)
{
  const SteepParts parts = PartCollector(source, gradation, cones.Values()).Collect(pulse);
  if (!pulse.HasStopped())
  {
    ConeFinder(parts, gradation, cones.Values().Most, pulse).Run(cones);
  }
}

} // namespace biting
