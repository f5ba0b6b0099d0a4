// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "NeededCones.h"

#include "../Base/Numbers.h"
#include "../Base/SortInSteps.h"

#include <utility> // for pairs

namespace biting
{
namespace
{

/// Cones and values are compared at so many places of a side.
constexpr int PartsOfSide = 4;

/// Items (cones, or edges) by point.
class ItemsOfPoints
{
public:
  explicit ItemsOfPoints(std::size_t points)
    : First(points, NoId)
  {
  }

  /// The items are numbered as they are added.
  void Add(Id point)
  {
    Id& first = this->First[static_cast<std::size_t>(point)];
    this->Next.push_back(first);
    first = static_cast<Id>(this->Next.size() - 1);
  }

  bool HasAny(Id point) const { return this->First[static_cast<std::size_t>(point)] != NoId; }

  template <typename Visit>
  void ForEach(Id point, Visit visit) const
  {
    for (Id item = this->First[static_cast<std::size_t>(point)]; item != NoId;
         item = this->Next[static_cast<std::size_t>(item)])
    {
      visit(item);
    }
  }

private:
  std::vector<Id> First; ///< of each point
  std::vector<Id> Next;  ///< of the same point
};

class NeededSearch
{
public:
  NeededSearch(const std::vector<LowEdge>& edges, const TrianglePart& part, const ValueRange& range,
    double gradation, Pulse& pulse)
    : Edges(edges)
    , Part(part)
    , Range(range)
    , Gradation(gradation)
    , Beats(pulse)
    , ConesAt(part.Source.Points.size())
    , WaysFrom(part.Source.Points.size())
    , LowestAt(part.Source.Points.size())
    , States(edges.size(), State::Idle)
  {
  }

  /// False where the cone of an edge is not needed.
  bool IsNeeded(std::size_t edge) const { return this->States[edge] == State::Needed; }

  void Run()
  {
    this->Cones.reserve(this->Edges.size());
    for (const LowEdge& edge : this->Edges)
    {
      this->Beats.Beat();
      this->ConesAt.Add(edge.Low);
      this->Cones.emplace_back(
        edge.Start, edge.End, edge.StartValue, edge.EndValue, this->Gradation);
    }
    this->Part.Sides.ForEachEdge(this->Beats,
      [this](const Id* side, const Id*)
      {
        const Id start = this->Part.Sides.StartOf(*side);
        const Id end = this->Part.Sides.EndOf(*side);
        this->WaysFrom.Add(this->IsBelow(start, end) ? start : end);
        this->Above.push_back(this->IsBelow(start, end) ? end : start);
      });
    for (const Id point : this->PointsFromBelow())
    {
      this->Beats.Beat(16);
      this->Settle(point);
    }
    for (const Id triangle : this->Part.Triangles)
    {
      this->Beats.Beat(32);
      this->FindNeeded(&this->Part.Source.Triangles[3 * static_cast<std::size_t>(triangle)]);
    }
  }

private:
  enum class State : std::uint8_t
  {
    Idle, ///< nowhere below the values, as far as is known
    Covered,
    Needed
  };

  /// The cone that is lowest at a point, of those that were offered.
  struct Lowest
  {
    Id Cone = NoId;
    double Value = Infinity;
  };

  const Point2& PlaceOf(Id point) const
  {
    return this->Part.Source.Points[static_cast<std::size_t>(point)];
  }
  Point2 PlaceOn(Id start, Id end, double weight) const
  {
    return this->PlaceOf(start) + weight * (this->PlaceOf(end) - this->PlaceOf(start));
  }
  double GivenAt(Id point) const
  {
    return this->Part.Source.Values[static_cast<std::size_t>(point)];
  }
  const SegmentCone& At(Id cone) const { return this->Cones[static_cast<std::size_t>(cone)]; }
  State& StateOf(Id cone) { return this->States[static_cast<std::size_t>(cone)]; }

  bool IsBelow(Id a, Id b) const
  {
    return std::make_pair(this->Range(this->GivenAt(a)), a) <
      std::make_pair(this->Range(this->GivenAt(b)), b);
  }

  /// Those that have a cone, or a way up.
  std::vector<Id> PointsFromBelow()
  {
    std::vector<Id> points;
    this->Beats.ForEach(this->LowestAt.size(),
      [this, &points](std::size_t k)
      {
        const auto point = static_cast<Id>(k);
        if (this->ConesAt.HasAny(point) || this->WaysFrom.HasAny(point))
        {
          points.push_back(point);
        }
      });
    SortInSteps(
      points, [this](Id a, Id b) { return this->IsBelow(a, b); }, this->Beats);
    return points;
  }

  /// Decides which cones of a point are covered, and hands on what covers it: the others, and what
  /// was offered.
  void Settle(Id point)
  {
    const Id offered = this->LowestAt[static_cast<std::size_t>(point)].Cone;
    this->ConesAt.ForEach(point,
      [this, offered](Id cone)
      {
        if (offered != NoId && this->StandsFor(this->At(offered), this->At(cone)))
        {
          this->StateOf(cone) = State::Covered;
          return;
        }
        this->Offer(cone, this->Edges[static_cast<std::size_t>(cone)].High);
      });
    this->WaysFrom.ForEach(point,
      [this, point, offered](Id way)
      {
        const Id above = this->Above[static_cast<std::size_t>(way)];
        this->Offer(offered, above);
        this->ConesAt.ForEach(point, [this, above](Id cone) { this->Offer(cone, above); });
      });
  }

  /// Along a segment a cone is convex, and from there it grows no faster than another one.
  bool StandsFor(const SegmentCone& cone, const SegmentCone& other) const
  {
    const double room = CoverTolerance * other.Value;
    return cone(other.Start, this->Gradation) <= other.Value + room &&
      cone(other.End(), this->Gradation) <= other.Value + other.Slope * other.Length + room;
  }

  void Offer(Id cone, Id point)
  {
    if (cone != NoId && this->StateOf(cone) != State::Covered)
    {
      Lowest& lowest = this->LowestAt[static_cast<std::size_t>(point)];
      const double value = this->At(cone)(this->PlaceOf(point), this->Gradation);
      if (value < lowest.Value &&
        value <= (1.0 + CoverTolerance) * this->Range(this->GivenAt(point)))
      {
        lowest = { cone, value };
      }
    }
  }

  /// Of the cones of the corners of a triangle, and of those that are lowest there.
  void FindNeeded(const Id* corners)
  {
    const auto look = [this, corners](Id cone)
    {
      if (cone != NoId && this->StateOf(cone) == State::Idle &&
        this->IsBelowValues(this->At(cone), corners))
      {
        this->StateOf(cone) = State::Needed;
      }
    };
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      look(this->LowestAt[static_cast<std::size_t>(corners[corner])].Cone);
      this->ConesAt.ForEach(corners[corner], look);
    }
  }

  /// Along the sides of a triangle, and along the line where its values reach the largest one: up
  /// to there they rise away from a cone, and no side may come near.
  bool IsBelowValues(const SegmentCone& cone, const Id* corners) const
  {
    Point2 atMost[3];
    int count = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const bool isRising = this->IsBelow(corners[k], corners[(k + 1) % 3]);
      const Id low = corners[isRising ? k : (k + 1) % 3];
      const Id high = corners[isRising ? (k + 1) % 3 : k];
      if (this->IsBelowSide(cone, low, high))
      {
        return true;
      }
      const double weight = this->WeightAt(this->Range.Most, low, high, 1.0);
      if (weight < 1.0)
      {
        atMost[count++] = this->PlaceOn(low, high, weight);
      }
    }
    return count == 2 && this->IsBelowMost(cone, atMost[0], atMost[1]);
  }

  bool IsBelowMost(const SegmentCone& cone, const Point2& start, const Point2& end) const
  {
    const double room = IdleTolerance * cone.Value;
    for (int part = 0; part <= PartsOfSide; ++part)
    {
      const double weight = static_cast<double>(part) / PartsOfSide;
      if (cone(start + weight * (end - start), this->Gradation) < this->Range.Most - room)
      {
        return true;
      }
    }
    return false;
  }

  /// Where its values are between the bounds, which may be on a small part of it.
  bool IsBelowSide(const SegmentCone& cone, Id low, Id high) const
  {
    const double room = IdleTolerance * cone.Value;
    const double from = this->WeightAt(this->Range.Least, low, high, 0.0);
    const double to = this->WeightAt(this->Range.Most, low, high, 1.0);
    for (int part = 0; part <= PartsOfSide; ++part)
    {
      const double weight = from + (to - from) * part / PartsOfSide;
      const double given = (1.0 - weight) * this->GivenAt(low) + weight * this->GivenAt(high);
      if (cone(this->PlaceOn(low, high, weight), this->Gradation) < this->Range(given) - room)
      {
        return true;
      }
    }
    return false;
  }

  /// Where values reach a bound; where they do not, another weight.
  double WeightAt(double bound, Id low, Id high, double other) const
  {
    const double start = this->Range.Scale * this->GivenAt(low);
    const double end = this->Range.Scale * this->GivenAt(high);
    return start < bound && bound < end ? (bound - start) / (end - start) : other;
  }

  const std::vector<LowEdge>& Edges;
  const TrianglePart& Part;
  const ValueRange& Range;
  const double Gradation;
  Pulse& Beats;
  std::vector<SegmentCone> Cones; ///< one an edge
  ItemsOfPoints ConesAt;          ///< at their low ends
  ItemsOfPoints WaysFrom;         ///< edges of triangles, at theirs
  std::vector<Id> Above;          ///< their high ends
  std::vector<Lowest> LowestAt;   ///< of each point
  std::vector<State> States;      ///< of each cone
};

} // namespace

std::vector<LowEdge> NeededCones(std::vector<LowEdge> edges, const TrianglePart& part,
  const ValueRange& range, double gradation, Pulse& pulse)
{
  NeededSearch search(edges, part, range, gradation, pulse);
  search.Run();
  std::size_t kept = 0;
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
  {
    if (search.IsNeeded(edge))
    {
      edges[kept++] = edges[edge];
    }
  }
  edges.resize(kept);
  return edges;
}

} // namespace biting
