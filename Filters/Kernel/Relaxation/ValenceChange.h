// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingValenceChange_h
#define BitingValenceChange_h

#include "../Base/Ids.h"
#include "MutableMesh.h"

#include <limits>  // for infinity
#include <utility> // for swap

namespace biting
{

// By how much an operation changes the sum of squared excesses (see MutableMesh::Excess) of the
// vertices that it touches: negative where it brings them nearer to the best numbers of triangles.

inline double ChangeOfSquaredExcess(double excess, double change)
{
  return change * (2.0 * excess + change);
}

/// Of the collapse of an edge; infinite where both of its ends are fixed.
inline double ValenceChangeOfCollapse(const MutableMesh& mesh, Id edge)
{
  Id kept = mesh.Origin(edge);
  Id gone = mesh.Target(edge);
  if (mesh.Freedoms[gone] < mesh.Freedoms[kept])
  {
    std::swap(kept, gone);
  }
  if (mesh.Freedoms[gone] == Freedom::Fixed)
  {
    return std::numeric_limits<double>::infinity();
  }
  const Id twin = mesh.Twins[edge];
  const double sides = twin == NoId ? 1.0 : 2.0;
  const double goneExcess = mesh.Excess(gone);
  const double change = ChangeOfSquaredExcess(mesh.Excess(kept), mesh.Degrees[gone] - 2.0 * sides) -
    goneExcess * goneExcess + ChangeOfSquaredExcess(mesh.Excess(mesh.Corners[edge]), -1.0);
  return twin == NoId ? change
                      : change + ChangeOfSquaredExcess(mesh.Excess(mesh.Corners[twin]), -1.0);
}

/// Of the split of an edge.
inline double ValenceChangeOfSplit(const MutableMesh& mesh, Id edge)
{
  const Id twin = mesh.Twins[edge];
  const double excess = twin == NoId ? -1.0 : -2.0; // of the vertex between the ends
  const double change =
    excess * excess + ChangeOfSquaredExcess(mesh.Excess(mesh.Corners[edge]), 1.0);
  return twin == NoId ? change
                      : change + ChangeOfSquaredExcess(mesh.Excess(mesh.Corners[twin]), 1.0);
}

} // namespace biting

#endif
