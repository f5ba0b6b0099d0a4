// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// The triangulation, which then forgets which edges a constraint covers.
#define Triangulate TriangulateFaultlessly
#define FinishTriangulation FinishFaultlessly
#include "Kernel/Delaunay/Triangulation.cxx" // NOLINT: under other names
#undef FinishTriangulation
#undef Triangulate

#include "Fault.h"

#include <algorithm> // for replace
#include <utility>   // for move

namespace biting
{

namespace
{

TriangulationResult WithFault(TriangulationResult result)
{
  if (second_look::TheFault == second_look::Fault::UncoveredSegment)
  {
    std::vector<Id>& covered = result.Mesh.Constraints;
    std::replace(covered.begin(), covered.end(), Id(0), NoId);
  }
  return result;
}

} // namespace

TriangulationResult FinishTriangulation(ConstrainedMesh made, Monitor& monitor)
{
  return WithFault(FinishFaultlessly(std::move(made), monitor));
}

TriangulationResult Triangulate(const std::vector<Point2>& points,
  const ConstraintEdges& constraints, const TriangulationOptions& options, Monitor& monitor)
{
  return WithFault(TriangulateFaultlessly(points, constraints, options, monitor));
}

} // namespace biting
