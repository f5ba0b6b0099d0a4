// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingConstraintRecovery_h
#define BitingConstraintRecovery_h

#include "../Base/Pulse.h"
#include "HalfEdgeMesh.h"
#include "Triangulation.h"

#include <vector> // for the pairs

namespace biting
{

/// Pairs of constraints that are in each other's way, the smaller number first; at most 10000 of
/// each kind. Below that, each constraint that crosses another is in a pair of Conflicts.
struct RecoveryResult
{
  std::vector<ConstraintConflict> Conflicts;    ///< they cross: the mesh has no meaning
  std::vector<ConstraintConflict> Coincidences; ///< they cover the same edge
};

/// Makes edges of the constraints, whose ends are vertices of the mesh, and marks them
/// (HalfEdgeMesh::Marks). A constraint that meets vertices on its way becomes several edges. An
/// edge that is covered more than once gets the smallest number; each boundary constraint on it
/// toggles the parity of its mark. The order is scattered, so that long constraints side by side
/// cross fewer and fewer edges, each ending at those made before: O(n log n) for n of them in all,
/// O(n^2) one after the other. Missing edges are found from both ends at once, so that a fan of
/// constraints costs no more than the degrees of its outer ends; the crossed triangles are replaced
/// in linear time, then flips.
RecoveryResult RecoverConstraints(
  HalfEdgeMesh& mesh, const ConstraintEdges& constraints, double phi, Pulse& pulse);

} // namespace biting

#endif
