// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRemesh_h
#define BitingRemesh_h

#include "Base/Ids.h"
#include "Base/Monitor.h"
#include "Base/Problem.h"
#include "BitingMesh.h"
#include "MeshingStages.h"
#include "Remeshing/ChangedRegion.h"
#include "Remeshing/KeepRules.h"
#include "Remeshing/OldMesh.h"
#include "Remeshing/RegionEdges.h"
#include "Spacing/Spacing.h"

#include <array>   // for the stages
#include <cstdint> // for limits
#include <vector>  // for the arrays

namespace biting
{

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

struct RemeshResult
{
  /// As MakeBitingMesh makes it. OriginalPoints are vertices of the input, EdgeCells its lines, by
  /// their places, or NoId. Where nothing changes it has its edges only.
  BitingMesh Mesh;
  std::vector<Id> OriginalTriangles; ///< triangles of the input that are unchanged, NoId = new
  bool IsUnchanged = false;          ///< the input is what is wanted
  OldMesh Old;                       ///< the input as it was understood
  std::vector<Id> ChangedTriangles;  ///< of the input: what is new lies in these
  std::vector<double> OldSpacings;   ///< f at the vertices of the input
};

/// The stages of Remesh.
namespace RemeshingStages
{
inline constexpr Stage Reading{ "Reading the mesh", 0.1 };
inline constexpr Stage Spacing{ "Comparing the spacing", 0.2 };
inline constexpr Stage Biting{ "Biting", 0.2 };
inline constexpr Stage Triangulation{ "Triangulating", 0.15 };
inline constexpr Stage Relaxation{ "Relaxing", 0.25 };
inline constexpr Stage Quality{ "Measuring quality", 0.1 };

inline constexpr std::array<Stage, 6> InOrder{ Reading, Spacing, Biting, Triangulation, Relaxation,
  Quality };
} // namespace RemeshingStages

/// Makes a mesh anew where it does not have the spacing that is wanted (paper, section 7): old mesh
/// -> what must change -> the vertices that are kept -> the rest is bitten -> Delaunay ->
/// relaxation -> stitched into what is unchanged. Kept vertices and unchanged triangles are what
/// they were, bit for bit. Repairs and refusals are added to `problems`; where it has errors
/// afterwards the result is empty. Deterministic. Cost: one pass over the mesh, and that of meshing
/// what changes.
RemeshResult Remesh(
  const RemeshInput& input, const RemeshOptions& options, ProblemList& problems, Monitor& monitor);

} // namespace biting

#endif
