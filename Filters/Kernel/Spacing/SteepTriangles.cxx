// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SteepTriangles.h"

#include "SourceSlopes.h"

#include <algorithm> // for min, max

namespace biting
{
namespace
{

/// A triangle is steep where the slope along one of its edges or the mean gradient around one of
/// its corners is above the gradation by more than this share of it, or its own gradient adds more
/// than this share of f. The gradient of one triangle exceeds that of a function with slope g even
/// where its edges do not.
constexpr double TriangleMargin = 0.005;

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

} // namespace

std::vector<bool> FindSteepTriangles(
  const TriangulatedSource& source, double gradation, const ValueRange& range, Pulse& pulse)
{
  const std::vector<Point2> gradients = AverageGradients(source, pulse);
  std::vector<bool> isSteep(source.Triangles.size() / 3, false);
  bool isFound = false;
  pulse.ForEach(isSteep.size(),
    [&](std::size_t triangle)
    {
      isSteep[triangle] = IsSteep(source, triangle, gradation, range, gradients);
      isFound = isFound || isSteep[triangle];
    });
  return isFound && !pulse.HasStopped() ? isSteep : std::vector<bool>();
}

} // namespace biting
