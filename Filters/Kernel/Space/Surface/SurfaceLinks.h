// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSurfaceLinks_h
#define BitingSurfaceLinks_h

#include "../../Base/IdLists.h"
#include "../../Base/Pulse.h"
#include "SurfaceMesh.h"

#include <algorithm> // for minmax
#include <utility>   // for pairs
#include <vector>    // for the arrays

namespace biting
{

constexpr Id OpenEdge = NoId;
constexpr Id CrowdedEdge = -2;

/// Which triangles meet at edges, whatever their orientation.
struct SurfaceLinks
{
  /// Of each slot, the slot at the other side of its edge; OpenEdge if no other triangle has the
  /// edge, CrowdedEdge if more than two have it.
  std::vector<Id> Across;
  std::size_t NumberOfEdges = 0;
  std::size_t NumberOfOpen = 0;
  std::vector<Id> CrowdedSlots;        ///< edge by edge
  std::vector<Id> CrowdedOffsets{ 0 }; ///< edge k has the slots from [k] to [k + 1]

  std::size_t NumberOfCrowded() const { return this->CrowdedOffsets.size() - 1; }
};

/// Cost O(n) where no vertex has many edges. Without meaning where the monitor wants to stop.
SurfaceLinks LinkSurface(const SurfaceMesh& mesh, Pulse& pulse);

/// The slots of each vertex, as a corner of triangles.
IdLists CornersOfVertices(const SurfaceMesh& mesh);

/// Whether the vertices have an edge, by these slots.
bool HasEdge(const SurfaceMesh& mesh, const IdLists& slotsAt, Id one, Id other);

/// Both vertices of the edge of `slot`, the lower one first.
inline std::pair<Id, Id> EndsOf(const SurfaceMesh& mesh, std::size_t slot)
{
  return std::minmax({ mesh.Corners[NextSlotOf(slot)], mesh.Corners[PreviousSlotOf(slot)] });
}

/// Whether the triangles at both sides of the edge of `slot` are oriented alike: they run through
/// it in opposite directions. Precondition: two triangles have it.
bool AreAlike(const SurfaceMesh& mesh, const SurfaceLinks& links, std::size_t slot);

/// Goes around `vertex`, of which `slot` is an edge, away from that edge: through the triangle of
/// `slot` and on through edges of two triangles, calling visit(corner) for the slot of the vertex
/// in each triangle. Returns the slot of the edge where the fan ends, open or crowded; NoId if it
/// closes.
template <typename Visit>
Id WalkFan(const SurfaceMesh& mesh, const SurfaceLinks& links, Id vertex, Id slot, Visit visit)
{
  const Id first = slot;
  do
  {
    const std::size_t base = 3 * static_cast<std::size_t>(slot / 3);
    const std::size_t corner = base + CornerOf(&mesh.Corners[base], vertex);
    visit(corner);
    // Two of the three edges are at the vertex; the third is opposite it.
    const Id other = static_cast<Id>(3 * base + 3 - corner) - slot;
    if (links.Across[static_cast<std::size_t>(other)] < 0)
    {
      return other;
    }
    slot = links.Across[static_cast<std::size_t>(other)];
  } while (slot != first);
  return NoId;
}

/// Vertices where several fans of triangles meet, but for those at crowded edges.
std::vector<Id> PinchedVertices(const SurfaceMesh& mesh, const SurfaceLinks& links, Pulse& pulse);

/// Open edges, one after the other.
struct BorderChain
{
  std::vector<Id> Slots;
  std::vector<Id> Vertices; ///< those of the slots in order, one more than these
  bool IsLoop = true;       ///< otherwise it ends at edges of more than two triangles
  double Length = 0.0;
  double Area = 0.0; ///< of the fan of triangles about the mean of the vertices
};

/// All open edges, each once. Where several fans meet a border goes on along
/// the open edge of another fan at the smallest angle, across the gap; no loop meets itself.
std::vector<BorderChain> BorderChains(
  const SurfaceMesh& mesh, const SurfaceLinks& links, Pulse& pulse);

} // namespace biting

#endif
