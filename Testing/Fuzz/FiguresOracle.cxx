// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "FiguresOracle.h"

#include "Base/Numbers.h"
#include "ExactSigns.h"

#include <algorithm> // for all_of, min
#include <array>     // for corners
#include <cmath>     // for abs

namespace biting
{

namespace
{

constexpr double QualityRounding = 1e-9;

} // namespace

bool FiguresOracle::Holds()
{
  return this->IsDelaunay() && this->HasQuality() && this->HasDistances() && this->HasBites() &&
    this->HasBiteOrders();
}

bool FiguresOracle::IsDelaunay()
{
  for (const HalfEdge& half : this->Judged.Halves)
  {
    const HalfEdge* twin = this->Judged.FindHalf(half.End, half.Start);
    const bool mayStay = this->Judged.Options.Domain.KeepCellEdges; // triangles as they are
    const bool isExpected =
      !mayStay && (this->Judged.Options.Phi == 1.0 || this->Judged.IsRelaxed());
    if (isExpected && twin && half.Start < half.End && !this->Judged.IsCovering(half))
    {
      const std::size_t first = half.Slot / 3 * 3;
      if (ExactInCircle(this->Judged.Corner(first), this->Judged.Corner(first + 1),
            this->Judged.Corner(first + 2), this->Judged.Corner(twin->Slot)) > 0)
      {
        return this->Judged.Refuse(
          this->Judged.EdgeText(half.Start, half.End) + " is not Delaunay");
      }
    }
  }
  return true;
}

bool FiguresOracle::HasQuality()
{
  const MeshQuality& quality = this->Judged.Mesh.Quality;
  const auto isShare = [](double share) { return IsBetween(share, 0.0, 1.0); };
  const std::vector<double>& conformity = quality.Conformity;
  return this->Judged.Require(std::all_of(conformity.begin(), conformity.end(), isShare) &&
             isShare(quality.SmallestConformity) && isShare(quality.MeanConformity) &&
             isShare(quality.ShareOfEdgesInBand),
           "shares are within 0 and 1") &&
    this->Judged.Require(
      quality.NumberOfVertices == static_cast<std::int64_t>(this->Judged.Mesh.Points.size()) &&
        quality.NumberOfTriangles ==
          static_cast<std::int64_t>(this->Judged.Mesh.Corners.size() / 3),
      "the mesh is counted") &&
    this->Judged.Require(std::isfinite(quality.MeanRelativeLength), "the mean length is finite") &&
    this->Judged.Require(
      std::isfinite(this->Judged.Mesh.UsedLipschitz) && this->Judged.Mesh.UsedLipschitz >= 0.0,
      "the used Lipschitz constant is finite") &&
    this->Judged.Require(
      std::isfinite(this->Judged.Mesh.GivenLipschitz) && this->Judged.Mesh.GivenLipschitz >= 0.0,
      "the given Lipschitz constant is finite") &&
    this->HasQualityOfTriangles();
}

bool FiguresOracle::HasQualityOfTriangles()
{
  const MeshQuality& quality = this->Judged.Mesh.Quality;
  const double leastRatio = std::sqrt(1.0 / 3.0) - QualityRounding;
  double smallest = Infinity;
  for (std::size_t triangle = 0; triangle < quality.MinimumAngle.size(); ++triangle)
  {
    smallest = std::min(smallest, quality.MinimumAngle[triangle]);
    if (!IsBetween(quality.MinimumAngle[triangle], 0.0, 60.0 + QualityRounding) ||
      !(quality.RadiusEdgeRatio[triangle] >= leastRatio) ||
      !(quality.AspectRatio[triangle] >= 2.0 - QualityRounding))
    {
      return this->Judged.Refuse(
        "quality of triangle " + std::to_string(triangle) + " is within range");
    }
  }
  return this->Judged.Require(
    smallest == quality.SmallestAngle, "the smallest angle is the smallest");
}

bool FiguresOracle::HasDistances()
{
  const BitingMesh& mesh = this->Judged.Mesh;
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
      return this->Judged.Refuse("N of " + std::to_string(k) + " is its shortest edge");
    }
  }
  return true;
}

bool FiguresOracle::HasBites()
{
  const Bites& bites = this->Judged.Mesh.Bites;
  const std::int64_t most = this->Judged.Options.MaximumNumberOfBites;
  if (!this->Judged.Options.KeepBites)
  {
    return this->Judged.Require(
      bites.Size() == 0 && this->Judged.Mesh.Front.empty(), "bites were not wanted");
  }
  bool areValid = true;
  for (std::size_t bite = 0; bite < bites.HalfWidths.size(); ++bite)
  {
    const double axis = std::hypot(bites.Axes[bite].X, bites.Axes[bite].Y);
    const bool isCircle = axis == 0.0 && this->Judged.Options.BiteShape == BiteShape::Circle;
    areValid = areValid && std::isfinite(bites.HalfWidths[bite]) && bites.HalfWidths[bite] > 0.0 &&
      (isCircle || std::abs(axis - 1.0) <= QualityRounding) && bites.Orders[bite] >= 0 &&
      (most < 0 || bites.Orders[bite] < most);
  }
  return this->Judged.Require(areValid, "bites have a size, an axis and a number") &&
    this->Judged.Require(
      std::is_sorted(bites.Orders.begin(), bites.Orders.end()), "bites are in order") &&
    this->Judged.Require(most >= 0 || this->Judged.Mesh.Front.empty(), "no front is left");
}

/// A relaxed mesh has vertices without a bite, and others are not where they were bitten. So have
/// triangles that stay.
bool FiguresOracle::HasBiteOrders()
{
  const std::int64_t most = this->Judged.Options.MaximumNumberOfBites;
  const bool mayStay = this->Judged.Options.Domain.KeepCellEdges;
  const Id least = most < 0 && !mayStay && !this->Judged.IsRelaxed() ? 0 : NoId;
  std::vector<Id> orders;
  for (std::size_t vertex = 0; vertex < this->Judged.Mesh.Points.size(); ++vertex)
  {
    const Id order = this->Judged.Mesh.BiteOrders[vertex];
    if (order < least || (most >= 0 && order >= most) || !this->IsCentreOf(vertex, order))
    {
      return this->Judged.Refuse(
        "vertex " + std::to_string(vertex) + " has no bite " + std::to_string(order));
    }
    if (order != NoId)
    {
      orders.push_back(order);
    }
  }
  std::sort(orders.begin(), orders.end());
  return this->Judged.Require(
    std::adjacent_find(orders.begin(), orders.end()) == orders.end(), "a bite makes one vertex");
}

/// True also where bites were not kept, or the vertex has none.
bool FiguresOracle::IsCentreOf(std::size_t vertex, Id order) const
{
  const Bites& bites = this->Judged.Mesh.Bites;
  if (order == NoId || !this->Judged.Options.KeepBites)
  {
    return true;
  }
  const auto bite = std::lower_bound(bites.Orders.begin(), bites.Orders.end(), order);
  const bool mayHaveMoved =
    this->Judged.IsRelaxed() && this->Judged.Mesh.OriginalPoints[vertex] == NoId;
  return bite != bites.Orders.end() && *bite == order &&
    (mayHaveMoved ||
      bites.Centers[static_cast<std::size_t>(bite - bites.Orders.begin())] ==
        this->Judged.Mesh.Points[vertex]);
}

} // namespace biting
