// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshedBites_h
#define BitingMeshedBites_h

#include "../Base/Monitor.h"
#include "../Base/Problem.h"
#include "../Biting/BitingScheme.h"
#include "../Delaunay/Triangulation.h"
#include "../Domain/Domain.h"
#include "../Relaxation/Relaxation.h"
#include "../Spacing/Spacing.h"

namespace biting
{

struct SoundTriangulationOptions
{
  double Phi = 1.0; ///< of the phi-Delaunay criterion
  bool PreserveBoundary = false;
};

/// The triangulation of what was bitten, in which every segment is a union of mesh edges.
///
/// Rounded division points of two close segments may make their parts cross or coincide, or cut one
/// off from the mesh. Then the division of these two is taken back, in `bites` too. Before the last
/// attempt all divisions are taken back: undivided segments do not cross. Inner vertices that
/// rounding put on a segment divide it; where segments are to be preserved they are removed. Where
/// that does not help, or the monitor wants to stop, a problem is added.
Triangulation TriangulateBites(const Domain& domain, const SoundTriangulationOptions& options,
  BitingResult& bites, ProblemList& problems, Monitor& monitor);

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
