// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTriangulationCheck_h
#define BitingTriangulationCheck_h

#include "Delaunay/Triangulation.h"
#include "Quality/MeshCheck.h"

#include <limits> // for infinity
#include <string> // for the violation
#include <vector> // for the arrays

namespace biting
{

/// What CheckMesh says of a triangulation, whose points need not all be used, whatever its area;
/// and whether regions are the same across edges without a constraint. Delaunay where phi is 1.
inline std::string CheckTriangulation(
  const std::vector<Point2>& points, const Triangulation& mesh, const TriangulationOptions& options)
{
  std::vector<Point2> used;
  std::vector<Id> numbers(points.size(), NoId);
  std::vector<Id> corners;
  for (const Id corner : mesh.Corners)
  {
    if (corner < 0 || corner >= static_cast<Id>(points.size()))
    {
      return "the corner is no point";
    }
    if (numbers[corner] == NoId)
    {
      numbers[corner] = static_cast<Id>(used.size());
      used.push_back(points[corner]);
    }
    corners.push_back(numbers[corner]);
  }
  MeshCheckInput input{ used, corners, mesh.Neighbors, mesh.Constraints, 1.0,
    std::numeric_limits<double>::infinity() };
  input.IsDelaunay = options.Phi >= 1.0;
  const std::string violation = CheckMesh(input);
  if (!violation.empty() || mesh.Regions.size() != corners.size() / 3)
  {
    return violation.empty() ? "not one region a triangle" : violation;
  }
  for (std::size_t slot = 0; slot < corners.size(); ++slot)
  {
    const Id region = mesh.Regions[slot / 3];
    const bool isFree = mesh.Constraints[slot] == NoId;
    if (region < 0 || (isFree && region != mesh.Regions[mesh.Neighbors[slot]]))
    {
      return "the region changes where there is no constraint";
    }
  }
  return {};
}

} // namespace biting

#endif
