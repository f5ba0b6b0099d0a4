// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// The triangulation, which then forgets which edges a constraint covers.
#define Triangulate TriangulateFaultlessly
#include "Kernel/Delaunay/Triangulation.cxx" // NOLINT: under another name
#undef Triangulate

#include "Fault.h"

#include <algorithm> // for replace

namespace biting
{

TriangulationResult Triangulate(const std::vector<Point2>& points,
  const ConstraintEdges& constraints, const TriangulationOptions& options, Monitor& monitor)
{
  TriangulationResult result = TriangulateFaultlessly(points, constraints, options, monitor);
  if (second_look::TheFault == second_look::Fault::UncoveredSegment)
  {
    std::vector<Id>& covered = result.Mesh.Constraints;
    std::replace(covered.begin(), covered.end(), Id(0), NoId);
  }
  return result;
}

} // namespace biting
