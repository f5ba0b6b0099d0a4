// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRemesh_h
#define BitingRemesh_h

#include "Base/Ids.h"
#include "Base/Monitor.h"
#include "Base/Problem.h"
#include "Mesh/BitingMesh.h"
#include "Remeshing/OldMesh.h"
#include "Remeshing/RemeshOptions.h"
#include "Stages/MeshingStages.h"

#include <array>  // for the stages
#include <vector> // for the arrays

namespace biting
{

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
