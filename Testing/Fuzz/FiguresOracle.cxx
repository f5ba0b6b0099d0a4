// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "JudgedMesh.h"

#include "Base/Numbers.h"
#include "ExactSigns.h"

#include <algorithm> // for all_of, min
#include <cmath>     // for abs

namespace biting
{

namespace
{

constexpr double QualityRounding = 1e-9;

bool IsDelaunay(JudgedMesh& judged)
{
  for (const HalfEdge& half : judged.Halves)
  {
    const HalfEdge* twin = judged.FindHalf(half.End, half.Start);
    const bool mayStay = judged.Options.Domain.KeepCellEdges; // triangles as they are
    const bool isExpected = !mayStay && (judged.Options.Phi == 1.0 || judged.IsRelaxed());
    if (isExpected && twin && half.Start < half.End && !judged.IsCovering(half))
    {
      const std::size_t first = half.Slot / 3 * 3;
      if (ExactInCircle(judged.Corner(first), judged.Corner(first + 1), judged.Corner(first + 2),
            judged.Corner(twin->Slot)) > 0)
      {
        return judged.Refuse(judged.EdgeText(half.Start, half.End) + " is not Delaunay");
      }
    }
  }
  return true;
}

bool HasQualityOfTriangles(JudgedMesh& judged)
{
  const MeshQuality& quality = judged.Mesh.Quality;
  const double leastRatio = std::sqrt(1.0 / 3.0) - QualityRounding;
  double smallest = Infinity;
  for (std::size_t triangle = 0; triangle < quality.MinimumAngle.size(); ++triangle)
  {
    smallest = std::min(smallest, quality.MinimumAngle[triangle]);
    if (!IsBetween(quality.MinimumAngle[triangle], 0.0, 60.0 + QualityRounding) ||
      !(quality.RadiusEdgeRatio[triangle] >= leastRatio) ||
      !(quality.AspectRatio[triangle] >= 2.0 - QualityRounding))
    {
      return judged.Refuse("quality of triangle " + std::to_string(triangle) + " is within range");
    }
  }
  return judged.Require(smallest == quality.SmallestAngle, "the smallest angle is the smallest");
}

bool HasQuality(JudgedMesh& judged)
{
  const MeshQuality& quality = judged.Mesh.Quality;
  const auto isShare = [](double share) { return IsBetween(share, 0.0, 1.0); };
  const std::vector<double>& conformity = quality.Conformity;
  return judged.Require(std::all_of(conformity.begin(), conformity.end(), isShare) &&
             isShare(quality.SmallestConformity) && isShare(quality.MeanConformity) &&
             isShare(quality.ShareOfEdgesInBand),
           "shares are within 0 and 1") &&
    judged.Require(
      quality.NumberOfVertices == static_cast<std::int64_t>(judged.Mesh.Points.size()) &&
        quality.NumberOfTriangles == static_cast<std::int64_t>(judged.Mesh.Corners.size() / 3),
      "the mesh is counted") &&
    judged.Require(std::isfinite(quality.MeanRelativeLength), "the mean length is finite") &&
    judged.Require(std::isfinite(judged.Mesh.UsedLipschitz) && judged.Mesh.UsedLipschitz >= 0.0,
      "the used Lipschitz constant is finite") &&
    judged.Require(std::isfinite(judged.Mesh.GivenLipschitz) && judged.Mesh.GivenLipschitz >= 0.0,
      "the given Lipschitz constant is finite") &&
    HasQualityOfTriangles(judged);
}

bool HasDistances(JudgedMesh& judged)
{
  const BitingMesh& mesh = judged.Mesh;
  std::vector<double> shortest(mesh.Points.size(), Infinity);
  for (std::size_t slot = 0; slot < mesh.Corners.size(); ++slot)
  {
    const auto start = static_cast<std::size_t>(mesh.Corners[slot]);
    const auto end = static_cast<std::size_t>(mesh.Corners[slot % 3 == 2 ? slot - 2 : slot + 1]);
    const Point2 gap = mesh.Points[end] - mesh.Points[start];
    const double length = std::hypot(gap.X, gap.Y);
    shortest[start] = std::min(shortest[start], length);
    shortest[end] = std::min(shortest[end], length);
  }
  for (std::size_t k = 0; k < shortest.size(); ++k)
  {
    const double told = mesh.Quality.NearestNeighborDistance[k];
    if (!(std::abs(told - shortest[k]) <= 1e-12 * shortest[k]))
    {
      return judged.Refuse("N of " + std::to_string(k) + " is its shortest edge");
    }
  }
  return true;
}

bool HasBites(JudgedMesh& judged)
{
  const Bites& bites = judged.Mesh.Bites;
  const std::int64_t most = judged.Options.MaximumNumberOfBites;
  if (!judged.Options.KeepBites)
  {
    return judged.Require(bites.Size() == 0 && judged.Mesh.Front.empty(), "bites were not wanted");
  }
  bool areValid = true;
  for (std::size_t bite = 0; bite < bites.HalfWidths.size(); ++bite)
  {
    const double axis = std::hypot(bites.Axes[bite].X, bites.Axes[bite].Y);
    const bool isCircle = axis == 0.0 && judged.Options.BiteShape == BiteShape::Circle;
    areValid = areValid && std::isfinite(bites.HalfWidths[bite]) && bites.HalfWidths[bite] > 0.0 &&
      (isCircle || std::abs(axis - 1.0) <= QualityRounding) && bites.Orders[bite] >= 0 &&
      (most < 0 || bites.Orders[bite] < most);
  }
  return judged.Require(areValid, "bites have a size, an axis and a number") &&
    judged.Require(
      std::is_sorted(bites.Orders.begin(), bites.Orders.end()), "bites are in order") &&
    judged.Require(most >= 0 || judged.Mesh.Front.empty(), "no front is left");
}

/// True also where bites were not kept, or the vertex has none.
bool IsCentreOf(const JudgedMesh& judged, std::size_t vertex, Id order)
{
  const Bites& bites = judged.Mesh.Bites;
  if (order == NoId || !judged.Options.KeepBites)
  {
    return true;
  }
  const auto bite = std::lower_bound(bites.Orders.begin(), bites.Orders.end(), order);
  const bool mayHaveMoved = judged.IsRelaxed() && judged.Mesh.OriginalPoints[vertex] == NoId;
  return bite != bites.Orders.end() && *bite == order &&
    (mayHaveMoved ||
      bites.Centers[static_cast<std::size_t>(bite - bites.Orders.begin())] ==
        judged.Mesh.Points[vertex]);
}

/// A relaxed mesh has vertices without a bite, and others are not where they were bitten. So have
/// triangles that stay.
bool HasBiteOrders(JudgedMesh& judged)
{
  const std::int64_t most = judged.Options.MaximumNumberOfBites;
  const bool mayStay = judged.Options.Domain.KeepCellEdges;
  const Id least = most < 0 && !mayStay && !judged.IsRelaxed() ? 0 : NoId;
  std::vector<Id> orders;
  for (std::size_t vertex = 0; vertex < judged.Mesh.Points.size(); ++vertex)
  {
    const Id order = judged.Mesh.BiteOrders[vertex];
    if (order < least || (most >= 0 && order >= most) || !IsCentreOf(judged, vertex, order))
    {
      return judged.Refuse(
        "vertex " + std::to_string(vertex) + " has no bite " + std::to_string(order));
    }
    if (order != NoId)
    {
      orders.push_back(order);
    }
  }
  std::sort(orders.begin(), orders.end());
  return judged.Require(
    std::adjacent_find(orders.begin(), orders.end()) == orders.end(), "a bite makes one vertex");
}

} // namespace

bool HoldsFigures(JudgedMesh& judged)
{
  return IsDelaunay(judged) && HasQuality(judged) && HasDistances(judged) && HasBites(judged) &&
    HasBiteOrders(judged);
}

} // namespace biting
