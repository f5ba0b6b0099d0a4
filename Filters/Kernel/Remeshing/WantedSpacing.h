// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingWantedSpacing_h
#define BitingWantedSpacing_h

#include "../Base/Monitor.h"
#include "../Base/Problem.h"
#include "../Spacing/Spacing.h"
#include "ChangedRegion.h"
#include "OldMesh.h"
#include "RegionEdges.h"

#include <vector> // for values

namespace biting
{

/// The spacing wanted of an old mesh.
///
/// Where it is given by values at the vertices, whose slopes along edges are the gradation at most,
/// it is what they say, and preparing it for a region costs no more than the region. Otherwise it
/// is prepared for all of the mesh.
class WantedSpacing
{
public:
  /// `values`, one a vertex or none, count where `options` have neither a grid nor a triangulation.
  WantedSpacing(const OldMesh& mesh, const SpacingOptions& options,
    const std::vector<double>& values, ProblemList& problems, Monitor& monitor);

  /// f at the vertices; where no region is limited yet, before any limit by feature size.
  const std::vector<double>& AtVertices() const { return this->Values; }

  /// f for the region, at most the local feature size of `pieces`, if there are any; values at the
  /// vertices of the region follow.
  Spacing Prepare(const ChangedRegion& region, const RegionEdges* pieces, double mostVertices,
    ProblemList& problems, Monitor& monitor);

private:
  bool IsWithinGradation() const;
  void Combine(const std::vector<double>& values, ProblemList& problems);
  std::shared_ptr<const TriangulatedSource> SourceOn(const std::vector<Id>& triangles) const;

  const OldMesh& Mesh;
  SpacingOptions Options;
  std::vector<double> Values;
  bool IsLocal = false; ///< the values are f
};

} // namespace biting

#endif
