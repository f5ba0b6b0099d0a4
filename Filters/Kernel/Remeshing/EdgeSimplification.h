// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingEdgeSimplification_h
#define BitingEdgeSimplification_h

#include "../Base/Monitor.h"
#include "ChangedRegion.h"
#include "KeepRules.h"
#include "OldMesh.h"
#include "RegionEdges.h"

#include <vector> // for spacings

namespace biting
{

/// How far the edges of a region may move from where they are.
struct EdgeTolerance
{
  double Tolerance = 0.0;       ///< in units of f at the old vertices
  double FeatureAngle = 0.0;    ///< degrees of turning, from which corners stay
  std::vector<double> Spacings; ///< f at all old vertices, before the limit by feature size

  bool IsAsked() const { return this->Tolerance > 0.0; }
};

/// The largest pieces within the tolerance, as StraightPieces has them for none. Distance, topology
/// and what stays are as Simplify (Simplification.h) promises; what is on the rim stays, and no
/// edge moves over a fixed vertex. Where the monitor wants to stop the result has no meaning.
RegionEdges SimplifiedPieces(const OldMesh& mesh, const ChangedRegion& region,
  const EdgeTolerance& tolerance, Monitor& monitor);

/// As ThinnedEdges for policy Free, but of edges that bend, too, vertices go: those that
/// `spacings` do not ask for, as far as the tolerance allows.
///
/// Old vertices that an edge moved over, or close to, are gone as well: they would be outside, or
/// in another region.
RegionEdges SimplifiedEdges(const OldMesh& mesh, const ChangedRegion& region,
  const std::vector<double>& spacings, const KeepRules& rules, const EdgeTolerance& tolerance,
  Monitor& monitor);

} // namespace biting

#endif
