// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SteepTriangles.h"

#include "NeededCones.h"
#include "SourceSlopes.h"
#include "TriangleSides.h"

#include <algorithm> // for min, max, none_of
#include <array>     // for sides

namespace biting
{
namespace
{

/// A triangle is steep where the slope along one of its edges or the mean gradient around one of
/// its corners is above the gradation by more than this share of it, or its own gradient adds more
/// than this share of f. The gradient of one triangle exceeds that of a function with slope g even
/// where its edges do not.
constexpr double TriangleMargin = 0.005;

/// Where there are more edges that f grows from than this share of the triangles, most of these are
/// hardly steep, and many of the edges are not needed.
constexpr double ShareOfSlight = 0.3;

/// Of the triangles around each point, weighted by area.
std::vector<Point2> AverageGradients(const TriangulatedSource& source, Pulse& pulse)
{
  std::vector<Point2> gradients(source.Points.size());
  std::vector<double> areas(gradients.size(), 0.0);
  pulse.ForEach(source.Triangles.size() / 3,
    [&source, &gradients, &areas](std::size_t triangle)
    {
      const std::size_t first = 3 * triangle;
      const Point2 gradient = GradientOfTriangle(source, first);
      const double area = AreaOfTriangle(source, first);
      for (std::size_t corner = first; corner < first + 3 && area > 0.0; ++corner)
      {
        const auto point = static_cast<std::size_t>(source.Triangles[corner]);
        areas[point] += area;
        gradients[point] = gradients[point] + (area / areas[point]) * (gradient - gradients[point]);
      }
    });
  return gradients;
}

bool IsSteep(const TriangulatedSource& source, std::size_t triangle, double gradation,
  const ValueRange& range, const std::vector<Point2>& gradients)
{
  const double most = (1.0 + TriangleMargin) * gradation;
  const double slope = range.Scale * Length(GradientOfTriangle(source, 3 * triangle));
  std::size_t corners[3];
  double values[3];
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    corners[corner] = static_cast<std::size_t>(source.Triangles[3 * triangle + corner]);
    values[corner] = range(source.Values[corners[corner]]);
  }
  const double least = std::min({ values[0], values[1], values[2] });
  if (!(slope > most) || !(std::max({ values[0], values[1], values[2] }) > least))
  {
    return false;
  }
  double longest = 0.0;
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    const std::size_t a = corners[corner];
    const std::size_t b = corners[(corner + 1) % 3];
    const double length = Distance(source.Points[a], source.Points[b]);
    if (range.Scale * std::abs(source.Values[a] - source.Values[b]) > most * length ||
      range.Scale * Length(gradients[a]) > most)
    {
      return true;
    }
    longest = std::max(longest, length);
  }
  return (slope - gradation) * 0.5 * longest > TriangleMargin * least;
}

std::vector<Id> FindSteepTriangles(
  const TriangulatedSource& source, double gradation, const ValueRange& range, Pulse& pulse)
{
  const std::vector<Point2> gradients = AverageGradients(source, pulse);
  std::vector<Id> steep;
  pulse.ForEach(source.Triangles.size() / 3,
    [&](std::size_t triangle)
    {
      if (IsSteep(source, triangle, gradation, range, gradients))
      {
        steep.push_back(static_cast<Id>(triangle));
      }
    });
  return steep;
}

/// From a point of a steep triangle the way down its gradient leads to lower values than the
/// gradation allows. So f grows from points only from which no steep triangle leads down: the edges
/// that all steep triangles beside them lead down to; the low ends of edges that are steep
/// themselves; and where triangles reach below the least spacing, the line where they do.
class ConeFinder
{
public:
  ConeFinder(const TriangulatedSource& source, double gradation, ConeCollector& cones)
    : Source(source)
    , Gradation(gradation)
    , Cones(cones)
    , IsLowEnd(source.Points.size(), false)
    , HasWayDown(source.Points.size(), false)
  {
  }

  std::vector<LowEdge> Find(const std::vector<Id>& steep, const TriangleSides& sides, Pulse& pulse)
  {
    for (std::size_t k = 0; k < steep.size() && pulse.Beat(); ++k)
    {
      this->MarkPoints(&this->Source.Triangles[3 * static_cast<std::size_t>(steep[k])]);
    }
    sides.ForEachEdge(pulse,
      [this, &sides](const Id* first, const Id* last)
      {
        const bool isBottom = std::none_of(first, last,
          [this, &sides](Id side) {
            return this->LeadsDown(sides.StartOf(side), sides.EndOf(side), sides.OppositeOf(side));
          });
        if (isBottom && !this->IsSteepEdge(sides.StartOf(*first), sides.EndOf(*first)))
        {
          this->AddEdge(sides.StartOf(*first), sides.EndOf(*first));
        }
      });
    for (std::size_t point = 0; point < this->IsLowEnd.size() && pulse.Beat(1); ++point)
    {
      if (this->IsLowEnd[point] && !this->HasWayDown[point])
      {
        this->AddEdge(static_cast<Id>(point), static_cast<Id>(point));
      }
    }
    return std::move(this->Found);
  }

private:
  const Point2& PlaceOf(Id point) const
  {
    return this->Source.Points[static_cast<std::size_t>(point)];
  }

  /// As spacing, without bounds.
  double ValueOf(Id point) const
  {
    return this->Cones.Values().Scale * this->Source.Values[static_cast<std::size_t>(point)];
  }

  /// Whether the gradient of a triangle leads down from the edge between two of its corners.
  bool LeadsDown(Id start, Id end, Id opposite) const
  {
    const Point2 along = this->PlaceOf(end) - this->PlaceOf(start);
    const Point2 toOpposite = this->PlaceOf(opposite) - this->PlaceOf(start);
    const double rise = this->ValueOf(end) - this->ValueOf(start);
    return (this->ValueOf(opposite) - this->ValueOf(start)) * Dot(along, along) <
      rise * Dot(toOpposite, along);
  }

  bool IsSteepEdge(Id start, Id end) const
  {
    return !(std::abs(this->ValueOf(end) - this->ValueOf(start)) <
      this->Gradation * Distance(this->PlaceOf(start), this->PlaceOf(end)));
  }

  void MarkPoints(const Id* corners)
  {
    std::array<bool, 3> leadsDown{};
    std::vector<Point2> atLeast;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id start = corners[k];
      const Id end = corners[(k + 1) % 3];
      leadsDown[k] = this->LeadsDown(start, end, corners[(k + 2) % 3]);
      if (this->IsSteepEdge(start, end))
      {
        const bool isRising = this->ValueOf(start) < this->ValueOf(end);
        this->IsLowEnd[static_cast<std::size_t>(isRising ? start : end)] = true;
        this->HasWayDown[static_cast<std::size_t>(isRising ? end : start)] = true;
      }
      if ((this->ValueOf(start) < this->Least()) != (this->ValueOf(end) < this->Least()))
      {
        atLeast.push_back(this->PlaceAtLeast(start, end));
      }
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto corner = static_cast<std::size_t>(corners[k]);
      this->HasWayDown[corner] =
        this->HasWayDown[corner] || (leadsDown[k] && leadsDown[(k + 2) % 3]);
    }
    if (atLeast.size() == 2)
    {
      this->Cones.AddSegment(atLeast[0], atLeast[1], this->Least(), this->Least());
    }
  }

  double Least() const { return this->Cones.Values().Least; }

  Point2 PlaceAtLeast(Id start, Id end) const
  {
    const double weight =
      (this->Least() - this->ValueOf(start)) / (this->ValueOf(end) - this->ValueOf(start));
    return this->PlaceOf(start) + weight * (this->PlaceOf(end) - this->PlaceOf(start));
  }

  /// Or a point; as far as it has a spacing between the bounds.
  void AddEdge(Id start, Id end)
  {
    const Id low = this->ValueOf(start) < this->ValueOf(end) ? start : end;
    const Id high = low == start ? end : start;
    if (this->ValueOf(low) < this->Cones.Values().Most && this->ValueOf(high) >= this->Least())
    {
      const bool isCut = this->ValueOf(low) < this->Least();
      this->Found.push_back(
        { isCut ? this->PlaceAtLeast(low, high) : this->PlaceOf(low), this->PlaceOf(high),
          std::max(this->ValueOf(low), this->Least()), this->ValueOf(high), low, high });
    }
  }

  const TriangulatedSource& Source;
  const double Gradation;
  ConeCollector& Cones;
  std::vector<LowEdge> Found;
  std::vector<bool> IsLowEnd;   ///< of an edge that is steep
  std::vector<bool> HasWayDown; ///< within a steep triangle, or along such an edge
};

} // namespace

void AddSteepTriangles(
  const TriangulatedSource& source, double gradation, ConeCollector& cones, Pulse& pulse)
{
  const std::vector<Id> steep = FindSteepTriangles(source, gradation, cones.Values(), pulse);
  if (steep.empty() || pulse.HasStopped())
  {
    return;
  }
  const TriangleSides sides(source, steep, pulse);
  std::vector<LowEdge> edges = ConeFinder(source, gradation, cones).Find(steep, sides, pulse);
  if (static_cast<double>(edges.size()) > ShareOfSlight * static_cast<double>(steep.size()))
  {
    edges =
      NeededCones(std::move(edges), { source, steep, sides }, cones.Values(), gradation, pulse);
  }
  for (const LowEdge& edge : edges)
  {
    cones.AddSegment(edge.Start, edge.End, edge.StartValue, edge.EndValue);
  }
}

} // namespace biting
