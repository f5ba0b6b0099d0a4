// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshWarnings.h"

#include "../../Kernel/Predicates/Predicates.h"
#include "MessagesFromProblems.h"

#include <algorithm> // for min, sort
#include <cstdint>   // for counts
#include <numeric>   // for iota
#include <tuple>     // for keys

namespace biting
{

namespace
{

/// Nothing where there are none.
void AddWarning(const char* what, const std::vector<Id>& triangles, const char* advice,
  const PlanarFaces& faces, std::vector<std::string>& warnings)
{
  if (triangles.empty())
  {
    return;
  }
  std::vector<std::string> first;
  for (std::size_t k = 0; k < std::min(triangles.size(), ShownIds); ++k)
  {
    const auto triangle = static_cast<std::size_t>(triangles[k]);
    const auto corner = static_cast<std::size_t>(faces.Corners[3 * triangle]);
    first.push_back("cell " + std::to_string(faces.CellIds[triangle]) + " at " +
      PlaceText(faces.Frame.ToSpace(faces.Points[corner])));
  }
  const auto count = static_cast<std::int64_t>(triangles.size());
  warnings.push_back(std::string(what) + " (" + std::to_string(count) +
    "): " + ListText(first, count) + ". " + advice);
}

} // namespace

std::vector<std::string> WarningsOfTriangles(const PlanarFaces& faces, const TriangleLinks& links)
{
  std::vector<Id> flat;
  std::vector<Id> turned[2]; // clockwise, counterclockwise
  for (std::size_t slot = 0; slot < faces.Corners.size(); slot += 3)
  {
    const auto place = [&faces, slot](std::size_t corner) -> const Point2&
    { return faces.Points[static_cast<std::size_t>(faces.Corners[slot + corner])]; };
    const int sign = Orient2D(place(0), place(1), place(2));
    (sign == 0 ? flat : turned[sign > 0 ? 1 : 0]).push_back(static_cast<Id>(slot / 3));
  }
  std::vector<std::string> warnings;
  AddWarning(
    "Triangles without area", flat, "They have the angle 0 and infinite ratios.", faces, warnings);
  AddWarning("Triangles oriented against the majority",
    turned[turned[1].size() < turned[0].size() ? 1 : 0],
    "The mesh may overlap itself there; they are measured as if turned.", faces, warnings);
  AddWarning("Edges of more than two triangles", links.Crowded, "The mesh is not a surface there.",
    faces, warnings);
  return warnings;
}

std::string WarningOfUnusedPoints(const PlanarFaces& faces, vtkIdType numberOfPoints)
{
  const vtkIdType unused = numberOfPoints - static_cast<vtkIdType>(faces.PointIds.size());
  return unused > 0
    ? "Points that no triangle uses (" + std::to_string(unused) + ") are not measured."
    : "";
}

std::string WarningOfRepeatedPoints(const PlanarFaces& faces)
{
  const std::vector<Point2>& points = faces.Points;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  const auto key = [&points](std::size_t k)
  { return std::make_tuple(points[k].X, points[k].Y, k); };
  std::sort(
    order.begin(), order.end(), [&key](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::size_t count = 0;
  std::size_t first = points.size();
  for (std::size_t k = 1; k < order.size(); ++k)
  {
    if (points[order[k]] == points[order[k - 1]])
    {
      ++count;
      first = std::min(first, order[k]);
    }
  }
  return count == 0 ? std::string()
                    : "Points at the place of others (" + std::to_string(count) + "): point " +
      std::to_string(faces.PointIds[first]) + " at " +
      PlaceText(faces.Frame.ToSpace(points[first])) +
      ". Triangles that only touch there share no edges; merge the points (Clean) if they are "
      "meant to be one.";
}

} // namespace biting
