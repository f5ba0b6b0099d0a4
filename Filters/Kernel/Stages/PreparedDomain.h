// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPreparedDomain_h
#define BitingPreparedDomain_h

#include "../Base/PartOfStage.h"
#include "../Base/Problem.h"
#include "../Domain/Domain.h"
#include "../Mesh/BitingMeshOptions.h"
#include "../Simplification/Simplification.h"

namespace biting
{

/// The domain of a drawing; without segments where there is none.
Domain ReadDrawing(const Polylines& input, const BitingMeshOptions& options, ProblemList& problems,
  Monitor& monitor);

/// The drawing as it is meshed: with fewer vertices, where that is asked for. Refuses a drawing
/// with more vertices than the mesh may have: all are vertices of the mesh.
SimplifiedDomain SimplifyDrawing(
  Domain drawing, const BitingMeshOptions& options, ProblemList& problems, PartOfStage& part);

} // namespace biting

#endif
