// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingChangedRegion_h
#define BitingChangedRegion_h

#include "../Base/IdLists.h"
#include "../Base/Ids.h"
#include "KeepRules.h"
#include "OldMesh.h"

#include <cstdint> // for flags
#include <utility> // for pairs
#include <vector>  // for the arrays

namespace biting
{

/// The part of a mesh that is made anew, and numbers of its own for what is in it.
struct ChangedRegion
{
  std::vector<std::uint8_t> IsChanged; ///< one an old triangle
  std::vector<Id> Triangles;           ///< the changed ones, ascending
  std::vector<Id> Vertices;            ///< theirs, ascending: old ids
  std::vector<Id> Numbers;             ///< of each old vertex: its place in Vertices, or NoId

  // One a vertex of the region.
  std::vector<std::uint8_t> IsInside; ///< 1: all of its triangles are changed, and it is not fixed
  std::vector<double> Lengths;        ///< mean length of its edges in units of f

  IdLists Neighbors; ///< of its vertices: those that edges of changed triangles join to them

  bool IsEmpty() const { return this->Triangles.empty(); }
  Id NumberOfVertices() const { return static_cast<Id>(this->Vertices.size()); }
  bool Covers(const ChangedRegion& other) const;
};

/// Of each vertex, the mean length of its edges, each in units of the mean f of its ends.
std::vector<double> MeanLengths(const OldMesh& mesh, const std::vector<double>& spacings);

/// The triangles at the vertices that are marked (FindMisfits) or of repaired triangles, and
/// those around them: `rings` of them. Frozen triangles stay. `lengths` is what MeanLengths
/// returned. Cost O(n), little a triangle.
ChangedRegion FindChangedRegion(const OldMesh& mesh, const std::vector<double>& lengths,
  std::vector<std::uint8_t> isMarked, int rings);

/// The free edges of unchanged triangles between vertices of the region: the old ids of their ends,
/// the smaller one first, sorted. Cost O(n), little a triangle.
std::vector<std::pair<Id, Id>> FreeEdgesOfRest(const OldMesh& mesh, const ChangedRegion& region);

/// The triangles of both regions, and `rings` of them around.
ChangedRegion LargerRegion(
  const OldMesh& mesh, const ChangedRegion& one, const ChangedRegion& other, int rings);

/// All triangles that are not frozen.
ChangedRegion WholeRegion(const OldMesh& mesh, const std::vector<double>& lengths);

/// What of the marked edges may change.
struct EdgeFreedom
{
  EdgePolicy Policy = EdgePolicy::Free;
  bool MayBend = false; ///< vertices may go also where edges bend
};

/// 1 at the vertices where the mesh does not have the spacing that is wanted, and may get it. Both
/// hold for a misfit:
/// - The mean length of its edges is out of the band (KeepRules::IsUnchanged).
/// - One of its edges is out of the band of edges, from 1 / sqrt(2) to sqrt(2) spacings, on the
///   same side: longer, and it may be divided; or shorter, and one of its ends may go.
/// So a mesh whose boundary is finer than the spacing, as it was drawn, stays. `lengths` is what
/// MeanLengths returned. Cost O(n), little a triangle.
std::vector<std::uint8_t> FindMisfits(const OldMesh& mesh, const std::vector<double>& spacings,
  const std::vector<double>& lengths, const EdgeFreedom& freedom);

} // namespace biting

#endif
