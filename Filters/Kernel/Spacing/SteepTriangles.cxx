// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SteepTriangles.h"

#include "../Base/SortInSteps.h"
#include "SourceSlopes.h"

#include <array>      // for corners
#include <cstdint>    // for edge keys
#include <functional> // for greater, less
#include <queue>      // for the order of values

namespace biting
{
namespace
{

std::size_t Index(Id id)
{
  return static_cast<std::size_t>(id);
}

/// A triangle is steep where the slope along one of its edges or the mean gradient around one of
/// its corners is above the gradation by more than this share of it, or its own gradient adds more
/// than this share of f. The gradient of one triangle exceeds that of a function with slope g even
/// where its edges do not.
constexpr double SteepnessMargin = 0.005;

/// An edge of a steep triangle: the smaller point id first.
struct SteepEdge
{
  Id Low;
  Id High;

  bool operator<(const SteepEdge& other) const
  {
    return this->Low < other.Low || (this->Low == other.Low && this->High < other.High);
  }
  bool operator==(const SteepEdge& other) const
  {
    return this->Low == other.Low && this->High == other.High;
  }
};

class SteepCollector
{
public:
  SteepCollector(
    const TriangulatedSource& source, double gradation, ConeCollector& cones, Monitor& monitor)
    : Source(source)
    , Gradation(gradation)
    , Cones(cones)
    , Beats(monitor)
  {
  }

  bool Run()
  {
    return this->AverageGradients() && this->FindEdges() &&
      (this->Edges.empty() || (this->LowerValues() && this->AddEdges()));
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

  bool FindEdges()
  {
    const std::size_t size = this->Source.Triangles.size();
    for (std::size_t first = 0; first + 2 < size; first += 3)
    {
      if (!this->Beats.Beat())
      {
        return false;
      }
      if (this->IsSteep(first))
      {
        this->AddTriangle(first);
      }
    }
    SortInSteps(this->Edges, std::less<>(), this->Beats);
    this->Edges.erase(std::unique(this->Edges.begin(), this->Edges.end()), this->Edges.end());
    return !this->Beats.HasStopped();
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

  void AddTriangle(std::size_t first)
  {
    std::vector<Point2> crossings;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const Id a = this->Source.Triangles[first + corner];
      const Id b = this->Source.Triangles[first + (corner + 1) % 3];
      this->Edges.push_back({ std::min(a, b), std::max(a, b) });
      this->AddCrossing(a, b, crossings);
    }
    if (crossings.size() == 2)
    {
      const double least = this->Cones.Values().Least;
      this->Cones.AddSegment(crossings[0], crossings[1], least, least);
    }
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

  /// Lowered: for each point the least value that a path along steep edges can bring, from other
  /// points too. Never below the exact limit, so what is above it is so in truth.
  bool LowerValues()
  {
    this->CollectNeighbors();
    this->Lowered.reserve(this->Source.Values.size());
    for (double value : this->Source.Values)
    {
      this->Lowered.push_back(this->Cones.Values()(value));
    }
    Queue queue;
    for (const SteepEdge& edge : this->Edges)
    {
      this->Lower(edge.Low, edge.High, queue);
      this->Lower(edge.High, edge.Low, queue);
    }
    while (!queue.empty() && this->Beats.Beat())
    {
      const Waiting next = queue.top();
      queue.pop();
      if (next.first > this->Lowered[Index(next.second)])
      {
        continue;
      }
      for (Id position = this->FirstNeighbor[Index(next.second)];
           position < this->FirstNeighbor[Index(next.second) + 1]; ++position)
      {
        this->Lower(next.second, this->Neighbors[Index(position)], queue);
      }
    }
    return !this->Beats.HasStopped();
  }

  using Waiting = std::pair<double, Id>;
  using Queue = std::priority_queue<Waiting, std::vector<Waiting>, std::greater<Waiting>>;

  void Lower(Id from, Id to, Queue& queue)
  {
    const double value = this->Lowered[Index(from)] + this->Rise(from, to);
    if (value < this->Lowered[Index(to)])
    {
      this->Lowered[Index(to)] = value;
      queue.emplace(value, to);
    }
  }

  double Rise(Id from, Id to) const
  {
    return this->Gradation *
      Distance(this->Source.Points[Index(from)], this->Source.Points[Index(to)]);
  }

  void CollectNeighbors()
  {
    this->FirstNeighbor.assign(this->Source.Points.size() + 1, 0);
    for (const SteepEdge& edge : this->Edges)
    {
      ++this->FirstNeighbor[Index(edge.Low) + 1];
      ++this->FirstNeighbor[Index(edge.High) + 1];
    }
    for (std::size_t point = 1; point < this->FirstNeighbor.size(); ++point)
    {
      this->FirstNeighbor[point] += this->FirstNeighbor[point - 1];
    }
    std::vector<Id> next = this->FirstNeighbor;
    this->Neighbors.resize(2 * this->Edges.size());
    for (const SteepEdge& edge : this->Edges)
    {
      this->Neighbors[Index(next[Index(edge.Low)]++)] = edge.High;
      this->Neighbors[Index(next[Index(edge.High)]++)] = edge.Low;
    }
  }

  bool AddEdges()
  {
    for (const SteepEdge& edge : this->Edges)
    {
      if (!this->Beats.Beat())
      {
        return false;
      }
      if (!this->IsBounded(edge.Low, edge.High) && !this->IsBounded(edge.High, edge.Low))
      {
        this->Cones.AddGiven(this->Source.Points[Index(edge.Low)],
          this->Source.Points[Index(edge.High)], this->Source.Values[Index(edge.Low)],
          this->Source.Values[Index(edge.High)]);
      }
    }
    return true;
  }

  /// Whether all of the edge a-b is above what some other point brings to a: with what it can grow
  /// along the edge it is still not above b.
  bool IsBounded(Id a, Id b) const
  {
    const double lowered = this->Lowered[Index(a)];
    return lowered < this->Cones.Values()(this->Source.Values[Index(a)]) &&
      lowered + this->Rise(a, b) <= this->Cones.Values()(this->Source.Values[Index(b)]);
  }

  const TriangulatedSource& Source;
  const double Gradation;
  ConeCollector& Cones;
  Pulse Beats;
  std::vector<Point2> MeanGradients; ///< of what is given, at each point
  std::vector<SteepEdge> Edges;
  std::vector<Id> FirstNeighbor; ///< of each point, in Neighbors; one past the end
  std::vector<Id> Neighbors;     ///< along steep edges
  std::vector<double> Lowered;
};

} // namespace

bool AddSteepTriangles(
  const TriangulatedSource& source, double gradation, ConeCollector& cones, Monitor& monitor)
{
  return SteepCollector(source, gradation, cones, monitor).Run();
}

} // namespace biting
