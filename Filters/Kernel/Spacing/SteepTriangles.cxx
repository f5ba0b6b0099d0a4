// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SteepTriangles.h"

#include "../Base/Numbers.h"
#include "../Base/SortInSteps.h"
#include "SegmentCone.h"
#include "SourceSlopes.h"
#include "TriangleEdges.h"

#include <algorithm>     // for min, max, none_of, remove_if
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
constexpr Id MostComparedCones = 32;

/// Those parts of the steep triangles where the spacing is between its bounds, as triangles. Points
/// of the source come first, in its order; some may be corners of none.
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

  SteepParts Collect(Pulse& pulse) &&
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
    return std::move(this->Whole);
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

  const TriangulatedSource& Source;
  const double Gradation;
  const ValueRange& Range;
  std::vector<Point2> Gradients; ///< around points of the source
  SteepParts Whole;
  Cuts CutsAtLeast; ///< points by the ends of edges
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
    , Edges(parts.Corners, parts.Points.size(), pulse, parts.Values)
  {
    this->Nodes.reserve(parts.Points.size());
    for (std::size_t point = 0; point < parts.Points.size(); ++point)
    {
      this->Nodes.push_back({ parts.Points[point], parts.Values[point] });
    }
  }

  void Run(ConeCollector& cones)
  {
    for (const auto& [value, point] : this->LowEnds())
    {
      if (this->Beats.Beat(32))
      {
        this->Settle(point);
      }
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
        const Node& low = this->At(this->Ends[cone].first);
        const Node& high = this->At(this->Ends[cone].second);
        cones.AddSegment(low.Place, high.Place, low.Value, high.Value);
      }
    }
  }

private:
  struct Node
  {
    Point2 Place;
    double Value;
    double LowestValue = Infinity; ///< of the cone that is lowest here, of those that were offered
    Id Lowest = NoId;
    Id FirstCone = 0; ///< of those from here
    Id ConeCount = 0;

    Id ComparedCones() const { return std::min(this->ConeCount, MostComparedCones); }
  };

  const Node& At(Id point) const { return this->Nodes[static_cast<std::size_t>(point)]; }
  const SegmentCone& Cone(Id id) const { return this->Cones[static_cast<std::size_t>(id)]; }

  /// The points that edges go up from, in the order of their values.
  std::vector<std::pair<double, Id>> LowEnds()
  {
    std::vector<std::pair<double, Id>> ends;
    this->Beats.ForEach(this->Nodes.size(),
      [this, &ends](std::size_t point)
      {
        if (this->Edges.FirstAt(point) < this->Edges.FirstAt(point + 1))
        {
          ends.emplace_back(this->Nodes[point].Value, static_cast<Id>(point));
        }
      });
    SortInSteps(ends, std::less<>(), this->Beats);
    return ends;
  }

  void Settle(Id point)
  {
    Node& low = this->Nodes[static_cast<std::size_t>(point)];
    const std::size_t first = this->Edges.FirstAt(static_cast<std::size_t>(point));
    const std::size_t end = this->Edges.FirstAt(static_cast<std::size_t>(point) + 1);
    low.FirstCone = static_cast<Id>(this->Cones.size());
    for (std::size_t edge = first; edge < end; ++edge)
    {
      const Id high = this->Edges.HighEnd(edge);
      if (!(low.Lowest != NoId &&
            this->IsCovered(low, this->Nodes[static_cast<std::size_t>(high)])))
      {
        this->AddCone(point, high);
      }
    }
    if (low.Lowest == NoId && this->Cones.size() == static_cast<std::size_t>(low.FirstCone))
    {
      this->AddCone(point, point);
    }
    low.ConeCount = static_cast<Id>(this->Cones.size()) - low.FirstCone;
    this->AreNeeded.resize(this->Cones.size(), low.ConeCount > MostComparedCones);
    for (std::size_t edge = first; edge < end && low.ConeCount > 0; ++edge)
    {
      Node& high = this->Nodes[static_cast<std::size_t>(this->Edges.HighEnd(edge))];
      for (Id cone = low.FirstCone; cone < low.FirstCone + low.ComparedCones(); ++cone)
      {
        Offer(cone, this->Cone(cone)(high.Place, this->Gradation), high);
      }
    }
  }

  /// Hands the cone that is lowest at the lower end of an edge on to the other one. Whether it
  /// stands for the cone of that edge: it does at the lower end.
  bool IsCovered(const Node& low, Node& high) const
  {
    const double value = this->Cone(low.Lowest)(high.Place, this->Gradation);
    Offer(low.Lowest, value, high);
    return value <= high.Value + CoverTolerance * low.Value;
  }

  static void Offer(Id cone, double value, Node& node)
  {
    if (value < node.LowestValue && value <= (1.0 + CoverTolerance) * node.Value)
    {
      node.LowestValue = value;
      node.Lowest = cone;
    }
  }

  /// Unless it is steep.
  void AddCone(Id point, Id end)
  {
    const Node& low = this->At(point);
    const Node& high = this->At(end);
    const SegmentCone cone(low.Place, high.Place, low.Value, high.Value, this->Gradation);
    if (low.Value < this->Most && (cone.Length > 0.0 || point == end))
    {
      this->Cones.push_back(cone);
      this->Ends.emplace_back(point, end);
    }
  }

  /// The cones of the corners of a triangle, and those that are lowest there.
  void MarkNeeded(const Id* corners)
  {
    this->Near.clear();
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Node& corner = this->At(corners[k]);
      this->LookAt(corner.Lowest);
      for (Id cone = corner.FirstCone; cone < corner.FirstCone + corner.ComparedCones(); ++cone)
      {
        this->LookAt(cone);
      }
    }
    for (std::size_t k = 0; k < 3 && !this->Near.empty(); ++k)
    {
      this->MarkAlong(this->At(corners[k]), this->At(corners[k == 2 ? 0 : k + 1]));
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
  void MarkAlong(const Node& start, const Node& end)
  {
    this->MarkAt(start, end, 0.0);
    this->MarkAt(start, end, 0.5);
    const double growth = this->Gradation * Distance(start.Place, end.Place);
    const double least = GrowthBetween * std::min(start.Value, end.Value);
    for (double share = 0.25; share * growth > least && share > LeastPartOfSide; share *= 0.5)
    {
      this->MarkAt(start, end, share);
      this->MarkAt(start, end, 1.0 - share);
    }
  }

  void MarkAt(const Node& start, const Node& end, double share)
  {
    const Point2 place = start.Place + share * (end.Place - start.Place);
    const double given = (1.0 - share) * start.Value + share * end.Value;
    const auto isNeeded = [this, &place, given](Id cone)
    {
      const double value = this->Cone(cone)(place, this->Gradation);
      const bool isBelow = value < given - IdleTolerance * this->Cone(cone).Value;
      if (isBelow)
      {
        this->AreNeeded[static_cast<std::size_t>(cone)] = true;
      }
      return isBelow;
    };
    this->Near.erase(
      std::remove_if(this->Near.begin(), this->Near.end(), isNeeded), this->Near.end());
  }

  const SteepParts& Parts;
  const double Gradation;
  const double Most;
  Pulse& Beats;
  const TriangleEdges Edges;
  std::vector<Node> Nodes; ///< one a point
  std::vector<SegmentCone> Cones;
  std::vector<std::pair<Id, Id>> Ends; ///< of their segments: points
  std::vector<bool> AreNeeded;
  std::vector<Id> Near; ///< at work
};

} // namespace

void AddSteepTriangles(
  const TriangulatedSource& source, double gradation, ConeCollector& cones, Pulse& pulse)
{
  const SteepParts parts = PartCollector(source, gradation, cones.Values()).Collect(pulse);
  if (!parts.Corners.empty() && !pulse.HasStopped())
  {
    ConeFinder(parts, gradation, cones.Values().Most, pulse).Run(cones);
  }
}

} // namespace biting
