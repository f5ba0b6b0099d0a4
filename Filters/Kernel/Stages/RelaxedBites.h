// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRelaxedBites_h
#define BitingRelaxedBites_h

#include "../Biting/BitingScheme.h"
#include "../Delaunay/Triangulation.h"
#include "../Domain/Domain.h"
#include "../Relaxation/Relaxation.h"
#include "../Spacing/Spacing.h"

namespace biting
{

/// Exchanges what relaxation works on, without a copy.
void Exchange(BitingResult& bites, Triangulation& triangles, RelaxationMesh& mesh);

/// Relaxes the triangulation of `bites` (Relaxation/Relaxation.h): its vertices and edges, and the
/// triangles and constraints of `mesh`, are then those of the relaxed mesh. A vertex keeps the
/// number of its bite; one that is new has none. Whether the edges still cover the segments is
/// looked at in the end (SegmentCover.h).
/// Where the monitor asks to stop the result has no meaning.
void RelaxBites(const Domain& domain, const Spacing& spacing, const RelaxationOptions& options,
  BitingResult& bites, Triangulation& mesh, Monitor& monitor);

} // namespace biting

#endif
