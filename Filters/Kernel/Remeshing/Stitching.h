// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingStitching_h
#define BitingStitching_h

#include "../Biting/BitingScheme.h"
#include "../Delaunay/Triangulation.h"
#include "../Domain/Domain.h"
#include "../Mesh/BitingMesh.h"
#include "ChangedRegion.h"
#include "OldMesh.h"
#include "RegionEdges.h"

#include <cstdint> // for flags
#include <string>  // for the violation
#include <vector>  // for the arrays

namespace biting
{

/// What is meshed in the place of a region: its edges are the segments, in their order, those of
/// the rim and frozen ones preserved, and all of them where the policy is Frozen; its vertices are
/// those that are kept, with old ids as VertexPoints, and embedded where they are on no edge; then
/// `added`, embedded, without an id.
///
/// The invariant of a domain holds, as the old mesh is valid; straight parts that lost vertices are
/// off these by rounding.
Domain MakeCavityDomain(const OldMesh& mesh, const ChangedRegion& region, const RegionEdges& edges,
  const std::vector<std::uint8_t>& isKept, const std::vector<Point2>& added, EdgePolicy policy);

/// What was made in the place of a region.
struct CavityMesh
{
  Domain Geometry; ///< of MakeCavityDomain: segments are the edges of the region, in their order
  BitingResult Bites;
  Triangulation Triangles;
  std::vector<Id> FaceRegions; ///< of the old mesh, one a region of Triangles
};

/// The old mesh with a part of it made anew.
struct StitchedMesh
{
  /// Vertices: old ones that are left, in their order (OriginalPoints: old ids), then new ones.
  /// Triangles: unchanged ones, in their order, then those of the cavity. Edges on lines have their
  /// number as EdgeCells, others NoId. Without quality.
  BitingMesh Mesh;
  std::vector<Id> OriginalTriangles; ///< of each triangle: the old one with its vertices, or NoId
};

/// Lists the marked edges of a mesh that stays as it is: its EdgeStarts, EdgeEnds, EdgeCells and
/// EdgeIsBoundary, all else is empty.
BitingMesh EdgesOf(const OldMesh& mesh);

/// Looks for triangles of the cavity beyond its rim, and for edges of it that lie on free edges of
/// what is unchanged, where these were as near to the region as rounding. Returns what is wrong as
/// text, empty where nothing is.
std::string CheckRim(const OldMesh& mesh, const ChangedRegion& region, const RegionEdges& edges,
  const CavityMesh& cavity);

/// Puts `cavity` in the place of the region. `spacings` is f at the old vertices, for those that
/// the cavity does not have. Cost O(n), little for what is unchanged.
StitchedMesh Stitch(const OldMesh& mesh, const ChangedRegion& region, const RegionEdges& edges,
  const std::vector<double>& spacings, const CavityMesh& cavity);

} // namespace biting

#endif
