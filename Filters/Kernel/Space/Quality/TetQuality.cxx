// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TetQuality.h"

#include "../../Base/IdLists.h"
#include "../../Base/Numbers.h"
#include "../../Base/Pulse.h"

#include <algorithm> // for max, min, minmax_element, sort
#include <cmath>     // for atan2, sqrt

namespace biting
{

namespace
{

constexpr std::size_t EdgeCorners[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 },
  { 2, 3 } };
constexpr double SliverAngle = 10.0;
constexpr double SliverRatio = 2.0;
constexpr double BandFactor = 1.4142135623730951;

std::array<Point3, 4> TetrahedronOf(const TetView& mesh, std::size_t t)
{
  std::array<Point3, 4> corners;
  for (std::size_t k = 0; k < 4; ++k)
  {
    corners[k] = mesh.Points[static_cast<std::size_t>(mesh.Corners[4 * t + k])];
  }
  return corners;
}

// Infinite where the volume is 0.
double Circumradius(const std::array<Point3, 4>& tetrahedron)
{
  const Point3 a = tetrahedron[1] - tetrahedron[0];
  const Point3 b = tetrahedron[2] - tetrahedron[0];
  const Point3 c = tetrahedron[3] - tetrahedron[0];
  const double volume = std::abs(VolumeOf(tetrahedron));
  const Point3 center = Dot(a, a) * Cross(b, c) + Dot(b, b) * Cross(c, a) + Dot(c, c) * Cross(a, b);
  return volume > 0.0 ? Length(center) / (12.0 * volume) : Infinity;
}

double ShortestEdge2(const std::array<Point3, 4>& tetrahedron)
{
  double shortest2 = Infinity;
  for (const auto& ends : EdgeCorners)
  {
    const Point3 edge = tetrahedron[ends[1]] - tetrahedron[ends[0]];
    shortest2 = std::min(shortest2, Dot(edge, edge));
  }
  return shortest2;
}

/// Twice the area of facet k, of corners k, k + 1 and k + 2, as a vector: away from the
/// tetrahedron for even k, into it for odd ones; or the other way round for all.
std::array<Point3, 4> AreasOf(const std::array<Point3, 4>& tetrahedron)
{
  std::array<Point3, 4> areas;
  for (std::size_t k = 0; k < 4; ++k)
  {
    const Point3& a = tetrahedron[k];
    areas[k] = Cross(tetrahedron[(k + 1) % 4] - a, tetrahedron[(k + 2) % 4] - a);
  }
  return areas;
}

double AngleAt(const std::array<Point3, 4>& tetrahedron, std::size_t k)
{
  const Point3& begin = tetrahedron[EdgeCorners[k][0]];
  const Point3 edge = tetrahedron[EdgeCorners[k][1]] - begin;
  // The two corners that are not of the edge are those of the opposite edge.
  const Point3 a = Cross(edge, tetrahedron[EdgeCorners[5 - k][0]] - begin);
  const Point3 b = Cross(edge, tetrahedron[EdgeCorners[5 - k][1]] - begin);
  const bool isFlat = Length(a) == 0.0 || Length(b) == 0.0;
  return isFlat ? std::nan("") : DegreesPerRadian * std::atan2(Length(Cross(a, b)), Dot(a, b));
}

/// The least and the greatest dihedral angle, 0 and 180 where a face has no area. Arcs are computed
/// only at edges whose cosines, by the areas of facets, are nearly the extremes: these are off by
/// 1e-12 where no facet is thinner than 1e-3 of its length.
std::array<double, 2> ExtremeAngles(
  const std::array<Point3, 4>& tetrahedron, const std::array<Point3, 4>& areas)
{
  constexpr double Thin2 = 1e-6;
  constexpr double Near = 1e-9;
  std::array<double, 4> areas2{};
  double longest2 = 0.0;
  for (std::size_t k = 0; k < 4; ++k)
  {
    areas2[k] = Dot(areas[k], areas[k]);
    const Point3 edge = tetrahedron[(k + 1) % 4] - tetrahedron[k];
    longest2 = std::max(longest2, Dot(edge, edge));
  }
  const bool isThin =
    !(*std::min_element(areas2.begin(), areas2.end()) > Thin2 * longest2 * longest2);
  // The facet opposite corner k is k + 1: of an edge the facets opposite the other two corners.
  std::array<double, 6> cosines{};
  for (std::size_t k = 0; k < 6; ++k)
  {
    const std::size_t a = (EdgeCorners[5 - k][0] + 1) % 4;
    const std::size_t b = (EdgeCorners[5 - k][1] + 1) % 4;
    const double product = ((a + b) % 2 == 0 ? -1.0 : 1.0) * Dot(areas[a], areas[b]);
    cosines[k] = product * std::abs(product) / (areas2[a] * areas2[b]);
  }
  const auto [low, high] = std::minmax_element(cosines.begin(), cosines.end());
  std::array<double, 2> extremes{ 180.0, 0.0 };
  for (std::size_t k = 0; k < 6; ++k)
  {
    if (isThin || cosines[k] > *high - Near || cosines[k] < *low + Near)
    {
      const double angle = AngleAt(tetrahedron, k);
      extremes[0] = std::isnan(angle) ? 0.0 : std::min(extremes[0], angle);
      extremes[1] = std::isnan(angle) ? 180.0 : std::max(extremes[1], angle);
    }
  }
  return extremes;
}

double RatioTo(double radius, double shortest2)
{
  return shortest2 > 0.0 ? radius / std::sqrt(shortest2) : Infinity;
}

/// To the radius of the inscribed sphere; infinite where the volume is 0. Pyramids from the facets
/// to its middle: volume = area * radius / 3.
double AspectOf(
  const std::array<Point3, 4>& tetrahedron, const std::array<Point3, 4>& areas, double circumradius)
{
  double area = 0.0;
  for (const Point3& twice : areas)
  {
    area += 0.5 * Length(twice);
  }
  const double volume = std::abs(VolumeOf(tetrahedron));
  return volume > 0.0 ? circumradius * area / (3.0 * volume) : Infinity;
}

void MeasureShapes(const TetView& mesh, Pulse& pulse, TetQuality& quality)
{
  const std::size_t count = mesh.Corners.size() / 4;
  quality.SmallestDihedralAngle = count > 0 ? 180.0 : 0.0;
  quality.DihedralAngles.reserve(mesh.HasHistograms ? 6 * count : 0);
  for (std::vector<double>* const list : { &quality.MinimumDihedralAngle,
         &quality.MaximumDihedralAngle, &quality.RadiusEdgeRatio, &quality.AspectRatio })
  {
    list->reserve(count);
  }
  pulse.ForEach(count,
    [&mesh, &quality](std::size_t t)
    {
      const std::array<Point3, 4> corners = TetrahedronOf(mesh, t);
      const std::array<Point3, 4> areas = AreasOf(corners);
      const auto [least, most] = ExtremeAngles(corners, areas);
      if (mesh.HasHistograms)
      {
        const std::array<double, 6> angles = DihedralAngles(corners);
        quality.DihedralAngles.insert(quality.DihedralAngles.end(), angles.begin(), angles.end());
      }
      const double radius = Circumradius(corners);
      const double ratio = RatioTo(radius, ShortestEdge2(corners));
      quality.MinimumDihedralAngle.push_back(least);
      quality.MaximumDihedralAngle.push_back(most);
      quality.RadiusEdgeRatio.push_back(ratio);
      quality.AspectRatio.push_back(AspectOf(corners, areas, radius));
      quality.NumberOfSlivers += ratio <= SliverRatio && least < SliverAngle ? 1 : 0;
      quality.SmallestDihedralAngle = std::min(quality.SmallestDihedralAngle, least);
      quality.LargestDihedralAngle = std::max(quality.LargestDihedralAngle, most);
      quality.LargestRadiusEdgeRatio = std::max(quality.LargestRadiusEdgeRatio, ratio);
    });
}

/// Calls visit(a, b), a < b, for each edge, in ascending order.
template <typename Visit>
void ForEachEdge(const TetView& mesh, Pulse& pulse, const Visit& visit)
{
  const IdLists tetsAt(mesh.Points.size(),
    [&mesh, &pulse](const auto& add)
    {
      for (std::size_t slot = 0; slot < mesh.Corners.size() && pulse.Beat(1); ++slot)
      {
        add(mesh.Corners[slot], static_cast<Id>(slot / 4));
      }
    });
  std::vector<Id> lastSeen(mesh.Points.size(), NoId); // the vertex that had it as neighbor
  std::vector<Id> neighbors;
  for (Id vertex = 0; vertex < static_cast<Id>(mesh.Points.size()) && pulse.Beat(64); ++vertex)
  {
    neighbors.clear();
    for (const Id tet : tetsAt[vertex])
    {
      for (std::size_t slot = 4 * static_cast<std::size_t>(tet), end = slot + 4; slot < end; ++slot)
      {
        const Id other = mesh.Corners[slot];
        Id& last = lastSeen[static_cast<std::size_t>(other)];
        if (other > vertex && last != vertex)
        {
          last = vertex;
          neighbors.push_back(other);
        }
      }
    }
    std::sort(neighbors.begin(), neighbors.end());
    for (const Id other : neighbors)
    {
      visit(static_cast<std::size_t>(vertex), static_cast<std::size_t>(other));
    }
  }
}

void MeasureLengths(const TetView& mesh, Pulse& pulse, TetQuality& quality)
{
  quality.NearestNeighborDistance.assign(mesh.Points.size(), Infinity);
  double sum = 0.0;
  double inBand = 0.0;
  std::size_t edges = 0;
  ForEachEdge(mesh, pulse,
    [&mesh, &quality, &sum, &inBand, &edges](std::size_t a, std::size_t b)
    {
      ++edges;
      const double length = Distance(mesh.Points[a], mesh.Points[b]);
      for (const std::size_t end : { a, b })
      {
        double& nearest = quality.NearestNeighborDistance[end];
        nearest = std::min(nearest, length);
      }
      if (!mesh.Spacing.empty())
      {
        const double relative = 2.0 * length / (mesh.Spacing[a] + mesh.Spacing[b]);
        if (mesh.HasHistograms)
        {
          quality.RelativeLengths.push_back(relative);
        }
        sum += relative;
        inBand += relative >= 1.0 / BandFactor && relative <= BandFactor ? 1.0 : 0.0;
      }
    });
  const double count = std::max(static_cast<double>(edges), 1.0);
  quality.MeanRelativeLength = sum / count;
  quality.ShareOfEdgesInBand = inBand / count;
}

void MeasureConformity(const TetView& mesh, TetQuality& quality)
{
  const double unknown = std::nan("");
  quality.Conformity.assign(mesh.Points.size(), unknown);
  quality.SmallestConformity = 1.0;
  double sum = 0.0;
  for (std::size_t vertex = 0; vertex < mesh.Points.size(); ++vertex)
  {
    const double distance = quality.NearestNeighborDistance[vertex];
    if (distance == Infinity)
    {
      continue;
    }
    ++quality.NumberOfVertices;
    if (!mesh.Spacing.empty())
    {
      const double f = mesh.Spacing[vertex];
      const double conformity = std::min(distance / f, f / distance);
      quality.Conformity[vertex] = conformity;
      quality.SmallestConformity = std::min(quality.SmallestConformity, conformity);
      sum += conformity;
    }
  }
  quality.MeanConformity = sum / std::max(static_cast<double>(quality.NumberOfVertices), 1.0);
}

} // namespace

TetQuality MeasureTetrahedra(const TetView& mesh, Monitor& monitor)
{
  Pulse pulse(monitor);
  TetQuality quality;
  MeasureShapes(mesh, pulse, quality);
  MeasureLengths(mesh, pulse, quality);
  MeasureConformity(mesh, quality);
  return quality;
}

std::array<double, 6> DihedralAngles(const std::array<Point3, 4>& tetrahedron)
{
  std::array<double, 6> angles{};
  for (std::size_t k = 0; k < 6; ++k)
  {
    angles[k] = AngleAt(tetrahedron, k);
  }
  return angles;
}

double VolumeOf(const std::array<Point3, 4>& tetrahedron)
{
  const Point3& a = tetrahedron[0];
  return Dot(tetrahedron[1] - a, Cross(tetrahedron[2] - a, tetrahedron[3] - a)) / 6.0;
}

} // namespace biting
