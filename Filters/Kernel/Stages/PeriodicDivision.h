// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPeriodicDivision_h
#define BitingPeriodicDivision_h

#include "../Base/Monitor.h"
#include "../Base/Problem.h"
#include "../Biting/BitingScheme.h"
#include "../Domain/PeriodicSides.h"
#include "../Mesh/BitingMesh.h"
#include "../Mesh/BitingMeshOptions.h"
#include "../Spacing/Spacing.h"

namespace biting
{

/// The sides of `domain` that the translations of the options map onto each other (MatchSides),
/// within the rounding of the input and MergeTolerance.
PeriodicSides FindPeriodicSides(Domain& domain, const Polylines& input,
  const BitingMeshOptions& options, ProblemList& problems, Monitor& monitor);

/// The options with the lower f of both sides given along both, so that the gradation sees it.
BitingMeshOptions WithLowerOfSides(const BitingMeshOptions& options, const Domain& domain,
  const PeriodicSides& sides, const Spacing& f, Monitor& monitor);

/// Divides both segments of each pair alike, as edges are divided (Biting/EdgeDivision.h). The
/// parts are preserved: nothing after it moves, adds or removes vertices there.
void DivideSides(const Spacing& f, const BitingOptions& options, PeriodicSides& sides,
  Domain& domain, Monitor& monitor);

/// Fills BitingMesh::Partners, for each translation.
void TellPartners(
  const Domain& domain, const PeriodicSides& sides, std::size_t translations, BitingMesh& mesh);

} // namespace biting

#endif
