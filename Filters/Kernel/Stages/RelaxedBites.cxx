// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RelaxedBites.h"

#include "../Base/PartOfStage.h"
#include "../Base/Pulse.h"
#include "../Delaunay/ConstrainedEdges.h"

#include <cmath>   // for abs
#include <utility> // for move
#include <vector>  // for lengths

namespace biting
{

namespace
{

constexpr double LengthTolerance = 1e-6; // of a length: rounding of the sum, and of close vertices

// Where steps end, as shares of the time.
constexpr double MeasuringEnd = 0.01;
constexpr double RelaxingEnd = 0.97;

/// Exchanges what relaxation works on, without a copy.
void Exchange(BitingResult& bites, Triangulation& triangles, RelaxationMesh& mesh)
{
  bites.Points.swap(mesh.Points);
  bites.Spacings.swap(mesh.Spacings);
  bites.Segments.swap(mesh.Segments);
  bites.EdgeStarts.swap(mesh.EdgeStarts);
  bites.EdgeEnds.swap(mesh.EdgeEnds);
  bites.EdgeSegments.swap(mesh.EdgeSegments);
  std::swap(triangles, mesh.Triangles);
}

/// Of each segment: how long the mesh edges on it are together.
std::vector<double> CoveredLengths(
  const Domain& domain, const BitingResult& bites, const Triangulation& mesh, Pulse& pulse)
{
  std::vector<double> lengths(domain.NumberOfSegments(), 0.0);
  ForEachConstrainedEdge(mesh, pulse,
    [&bites, &lengths](Id constraint, Id start, Id end) {
      lengths[bites.EdgeSegments[constraint]] += Distance(bites.Points[start], bites.Points[end]);
    });
  return lengths;
}

std::string CompareLengths(
  const std::vector<double>& before, const std::vector<double>& after, Pulse& pulse)
{
  bool areKept = true;
  pulse.ForEach(before.size(),
    [&before, &after, &areKept](std::size_t segment)
    {
      const double change = std::abs(after[segment] - before[segment]);
      areKept = areKept && change <= LengthTolerance * before[segment];
    });
  return areKept ? "" : "relaxation took a part of a segment out of the mesh";
}

std::vector<Id> OrdersOf(
  const std::vector<Id>& origins, const std::vector<Id>& oldOrders, Pulse& pulse)
{
  std::vector<Id> orders;
  orders.reserve(origins.size());
  pulse.ForEach(origins.size(),
    [&origins, &oldOrders, &orders](std::size_t vertex)
    { orders.push_back(origins[vertex] == NoId ? NoId : oldOrders[origins[vertex]]); });
  return orders;
}

} // namespace

std::string RelaxBites(const Domain& domain, const Spacing& spacing,
  const RelaxationOptions& options, BitingResult& bites, Triangulation& mesh, Monitor& monitor)
{
  PartOfStage measuring(monitor, 0.0, MeasuringEnd);
  Pulse measuringPulse(measuring);
  const std::vector<double> before = CoveredLengths(domain, bites, mesh, measuringPulse);
  if (measuring.HasStopped())
  {
    return {};
  }
  RelaxationMesh work;
  Exchange(bites, mesh, work);
  PartOfStage relaxing(monitor, MeasuringEnd, RelaxingEnd);
  const RelaxationResult result = Relax(domain, spacing, options, work, relaxing);
  Exchange(bites, mesh, work);
  if (result.WasAborted)
  {
    return {};
  }
  PartOfStage comparing(monitor, RelaxingEnd, 1.0);
  Pulse pulse(comparing);
  bites.BiteOrders = OrdersOf(result.Origins, bites.BiteOrders, pulse);
  return CompareLengths(before, CoveredLengths(domain, bites, mesh, pulse), pulse);
}

} // namespace biting
