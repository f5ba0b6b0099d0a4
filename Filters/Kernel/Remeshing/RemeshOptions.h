// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRemeshOptions_h
#define BitingRemeshOptions_h

#include "../Spacing/Spacing.h"
#include "KeepRules.h"

#include <cstdint> // for limits
#include <vector>  // for values

namespace biting
{

/// What the user asks of a mesh that is made anew.
struct RemeshOptions
{
  SpacingOptions Spacing;

  /// The spacing wanted at each vertex of the mesh, linear on its triangles: counts where the
  /// options have neither a grid nor a triangulation. Empty: none.
  std::vector<double> Values;

  bool LimitByFeatureSize = true; ///< as BitingMeshOptions::LimitByFeatureSize
  EdgePolicy Edges = EdgePolicy::Free;

  /// How far edges that bend may move so that vertices can go from them, where the policy is Free,
  /// in units of f before the limit by feature size. 0: they stay where they are.
  double BoundaryTolerance = 0.0;
  double FeatureAngle = 30.0; ///< with it: degrees of turning, from which a corner stays

  RemeshPreference Preference = RemeshPreference::Balanced;
  int Rings = 2; ///< of triangles around what must change, that change with it

  bool Relaxation = true;

  /// True: all triangles that may change are made anew, and all vertices that may move are relaxed;
  /// they stay where that is best, but count as new.
  bool RelaxAll = false;

  std::int64_t MaximumNumberOfVertices = 20000000;
  bool KeepBites = false; ///< fill Bites of the mesh
};

} // namespace biting

#endif
