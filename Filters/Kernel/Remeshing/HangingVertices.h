// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingHangingVertices_h
#define BitingHangingVertices_h

#include "../Base/Ids.h"
#include "OldMesh.h"

#include <array>  // for corners
#include <vector> // for the arrays

namespace biting
{

/// Vertices between the ends of a free edge, of triangles on its other side.
struct HangingVertices
{
  Id Slot = NoId;           ///< of the edge
  std::vector<Id> Vertices; ///< from its start to its end
};

/// Those of all free edges that are no further off the edge than `nearest`, which may be 0, as
/// where a coarse mesh and a fine one lie side by side, but further off its ends. In the order of
/// slots. Triangles have any orientation. Cost O(m log m) in the free edges.
std::vector<HangingVertices> FindHangingVertices(const OldMesh& mesh, double nearest);

/// The triangles between an edge and the vertices that hang on it: as flat as these are near. With
/// them in the mesh none hangs any more. Such a triangle lies across an edge from one that is not
/// among them, or from one before, with its own longest side.
std::vector<std::array<Id, 3>> FillBeside(const OldMesh& mesh, const HangingVertices& hanging);

} // namespace biting

#endif
