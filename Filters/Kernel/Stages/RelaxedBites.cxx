// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "RelaxedBites.h"

#include "../Base/Pulse.h"

#include <utility> // for move, swap
#include <vector>  // for orders

namespace biting
{

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

void RelaxBites(const Domain& domain, const Spacing& spacing, const RelaxationOptions& options,
  BitingResult& bites, Triangulation& mesh, Monitor& monitor)
{
  RelaxationMesh work;
  Exchange(bites, mesh, work);
  const RelaxationResult result = Relax(domain, spacing, options, work, monitor);
  Exchange(bites, mesh, work);
  if (result.WasAborted)
  {
    return;
  }
  Pulse pulse(monitor);
  pulse.SetFraction(1.0);
  std::vector<Id> orders;
  orders.reserve(result.Origins.size());
  pulse.ForEach(result.Origins.size(),
    [&result, &bites, &orders](std::size_t vertex)
    {
      const Id origin = result.Origins[vertex];
      orders.push_back(origin == NoId ? NoId : bites.BiteOrders[origin]);
    });
  bites.BiteOrders = std::move(orders);
}

} // namespace biting
