// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BoundaryAxes.h"

#include <algorithm> // for min_element
#include <cmath>     // for abs

namespace biting
{

namespace
{

const CubeAxes WorldAxes{ { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } } };

/// Cosines of 10 and 40 degrees: planes are the same, or others.
constexpr double SameCosine = 0.98;
constexpr double OtherCosine = 0.77;

/// What is known of the facets at a vertex.
struct FacetPlanes
{
  Point3 First{};
  Point3 Second{};
  double LeastCosine = 1.0; ///< between the first and another one
  bool IsCurved = false;

  void Add(const Point3& normal)
  {
    if (this->First == Point3())
    {
      this->First = normal;
    }
    const double cosine = std::abs(Dot(normal, this->First));
    this->IsCurved = this->IsCurved || (cosine < SameCosine && cosine > OtherCosine);
    if (cosine < this->LeastCosine)
    {
      this->LeastCosine = cosine;
      this->Second = normal;
    }
  }

  CubeAxes Axes() const
  {
    if (this->IsCurved || this->First == Point3())
    {
      return WorldAxes;
    }
    // Without a second plane, the axis of the world that is most at right angles to the first.
    const Point3 across = this->LeastCosine < OtherCosine
      ? this->Second
      : *std::min_element(WorldAxes.begin(), WorldAxes.end(),
          [this](const Point3& a, const Point3& b)
          { return std::abs(Dot(a, this->First)) < std::abs(Dot(b, this->First)); });
    const Point3 third = Cross(this->First, across);
    const Point3 unit = 1.0 / Length(third) * third;
    return { { this->First, Cross(unit, this->First), unit } };
  }
};

} // namespace

std::vector<CubeAxes> AxesOfBoundary(const BodyBoundary& boundary)
{
  std::vector<FacetPlanes> planes(boundary.Centers.size());
  for (std::size_t facet = 0; facet < boundary.Facets.size() / 3; ++facet)
  {
    const Id* corners = &boundary.Facets[3 * facet];
    const auto at = [&boundary, corners](std::size_t k)
    { return boundary.Centers[static_cast<std::size_t>(corners[k])]; };
    const Point3 normal = Cross(at(1) - at(0), at(2) - at(0));
    const double length = Length(normal);
    for (std::size_t k = 0; k < 3 && length > 0.0; ++k)
    {
      planes[static_cast<std::size_t>(corners[k])].Add(1.0 / length * normal);
    }
  }
  std::vector<CubeAxes> axes{ WorldAxes };
  axes.reserve(planes.size() + 1);
  for (const FacetPlanes& at : planes)
  {
    axes.push_back(at.Axes());
  }
  return axes;
}

} // namespace biting
