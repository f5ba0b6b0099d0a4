// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "TetQuality.h"

#include "../../Base/Numbers.h"
#include "../../Base/Pulse.h"
#include "../../Base/SortInSteps.h"

#include <algorithm> // for max, min, unique
#include <cmath>     // for atan2, sqrt
#include <utility>   // for pairs

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

void MeasureShapes(const TetView& mesh, Pulse& pulse, TetQuality& quality)
{
  const std::size_t count = mesh.Corners.size() / 4;
  quality.SmallestDihedralAngle = count > 0 ? 180.0 : 0.0;
  quality.DihedralAngles.reserve(6 * count);
  pulse.ForEach(count,
    [&mesh, &quality](std::size_t t)
    {
      const std::array<Point3, 4> corners = TetrahedronOf(mesh, t);
      double least = 180.0;
      double most = 0.0;
      for (const double angle : DihedralAngles(corners))
      {
        least = std::isnan(angle) ? 0.0 : std::min(least, angle);
        most = std::isnan(angle) ? 180.0 : std::max(most, angle);
        quality.DihedralAngles.push_back(angle);
      }
      const double ratio = RadiusEdgeRatio(corners);
      quality.MinimumDihedralAngle.push_back(least);
      quality.MaximumDihedralAngle.push_back(most);
      quality.RadiusEdgeRatio.push_back(ratio);
      quality.AspectRatio.push_back(AspectRatio(corners));
      quality.NumberOfSlivers += ratio <= SliverRatio && least < SliverAngle ? 1 : 0;
      quality.SmallestDihedralAngle = std::min(quality.SmallestDihedralAngle, least);
      quality.LargestDihedralAngle = std::max(quality.LargestDihedralAngle, most);
      quality.LargestRadiusEdgeRatio = std::max(quality.LargestRadiusEdgeRatio, ratio);
    });
}

// Each edge once, from the lower vertex.
std::vector<std::pair<Id, Id>> EdgesOf(const TetView& mesh, Pulse& pulse)
{
  std::vector<std::pair<Id, Id>> edges;
  edges.reserve(mesh.Corners.size() / 4 * 6);
  for (std::size_t t = 0; t < mesh.Corners.size() / 4; ++t)
  {
    for (const auto& ends : EdgeCorners)
    {
      edges.push_back(
        std::minmax({ mesh.Corners[4 * t + ends[0]], mesh.Corners[4 * t + ends[1]] }));
    }
  }
  const auto isBefore = [](const std::pair<Id, Id>& a, const std::pair<Id, Id>& b)
  { return a < b; };
  SortInSteps(edges, isBefore, pulse);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

void MeasureLengths(const TetView& mesh, Pulse& pulse, TetQuality& quality)
{
  quality.NearestNeighborDistance.assign(mesh.Points.size(), Infinity);
  const std::vector<std::pair<Id, Id>> edges = EdgesOf(mesh, pulse);
  double sum = 0.0;
  double inBand = 0.0;
  for (const auto& edge : edges)
  {
    const auto a = static_cast<std::size_t>(edge.first);
    const auto b = static_cast<std::size_t>(edge.second);
    const double length = Distance(mesh.Points[a], mesh.Points[b]);
    for (const std::size_t end : { a, b })
    {
      double& nearest = quality.NearestNeighborDistance[end];
      nearest = std::min(nearest, length);
    }
    if (!mesh.Spacing.empty())
    {
      const double relative = 2.0 * length / (mesh.Spacing[a] + mesh.Spacing[b]);
      quality.RelativeLengths.push_back(relative);
      sum += relative;
      inBand += relative >= 1.0 / BandFactor && relative <= BandFactor ? 1.0 : 0.0;
    }
  }
  const double count = std::max(static_cast<double>(edges.size()), 1.0);
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
    const Point3& begin = tetrahedron[EdgeCorners[k][0]];
    const Point3 edge = tetrahedron[EdgeCorners[k][1]] - begin;
    // The two corners that are not of the edge are those of the opposite edge.
    const Point3 a = Cross(edge, tetrahedron[EdgeCorners[5 - k][0]] - begin);
    const Point3 b = Cross(edge, tetrahedron[EdgeCorners[5 - k][1]] - begin);
    const bool isFlat = Length(a) == 0.0 || Length(b) == 0.0;
    angles[k] =
      isFlat ? std::nan("") : DegreesPerRadian * std::atan2(Length(Cross(a, b)), Dot(a, b));
  }
  return angles;
}

double VolumeOf(const std::array<Point3, 4>& tetrahedron)
{
  const Point3& a = tetrahedron[0];
  return Dot(tetrahedron[1] - a, Cross(tetrahedron[2] - a, tetrahedron[3] - a)) / 6.0;
}

double RadiusEdgeRatio(const std::array<Point3, 4>& tetrahedron)
{
  double shortest = Infinity;
  for (const auto& ends : EdgeCorners)
  {
    shortest = std::min(shortest, Distance(tetrahedron[ends[0]], tetrahedron[ends[1]]));
  }
  return shortest > 0.0 ? Circumradius(tetrahedron) / shortest : Infinity;
}

double AspectRatio(const std::array<Point3, 4>& tetrahedron)
{
  double area = 0.0;
  for (std::size_t k = 0; k < 4; ++k)
  {
    const Point3& a = tetrahedron[k];
    area += 0.5 * Length(Cross(tetrahedron[(k + 1) % 4] - a, tetrahedron[(k + 2) % 4] - a));
  }
  // Pyramids from the faces to the middle of the inscribed sphere: volume = area * radius / 3.
  const double volume = std::abs(VolumeOf(tetrahedron));
  return volume > 0.0 ? Circumradius(tetrahedron) * area / (3.0 * volume) : Infinity;
}

} // namespace biting
