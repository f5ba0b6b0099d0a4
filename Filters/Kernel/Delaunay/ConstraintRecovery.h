// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingConstraintRecovery_h
#define BitingConstraintRecovery_h

#include "HalfEdgeMesh.h"
#include "Pulse.h"
#include "Triangulation.h"

#include <vector> // for the conflicts

namespace biting
{

/// Makes edges of the constraints, whose ends are vertices of the mesh, one after the other, and
/// marks them (HalfEdgeMesh::Marks). A constraint that meets vertices on its way becomes several
/// edges. An edge that is covered more than once keeps the first number; each boundary constraint on
/// it toggles the parity of its mark.
/// Missing edges are found from both ends at once, so that a fan of constraints costs no more than
/// the degrees of its outer ends; the crossed triangles are replaced in linear time, then flips.
/// Returns pairs of constraints that cross, the first 10000; the mesh has no meaning then.
std::vector<ConstraintConflict> RecoverConstraints(
  HalfEdgeMesh& mesh, const ConstraintEdges& constraints, double phi, Pulse& pulse);

} // namespace biting

#endif
