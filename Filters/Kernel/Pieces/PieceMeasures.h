// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPieceMeasures_h
#define BitingPieceMeasures_h

#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Base/Problem.h"
#include "../Domain/Domain.h"
#include "../Mesh/BitingMesh.h"
#include "../Quality/ExactSum.h"
#include "../Spacing/Spacing.h"
#include "CrewRounds.h"

#include <vector> // for constraints

namespace biting
{

/// A piece to be measured, with two more rings of triangles around its own than it will have.
struct MeasuredPiece
{
  const Domain& Geometry;
  const Spacing& F;
  const std::vector<Id>& Constraints;
  bool CountsAsked = false; ///< vertices that the spacing asks for (FineDrawing.h)
};

/// Checks the pieces of a mesh, each by itself, with the area of all of them together, and measures
/// each. All members of a crew that have one call it.
///
/// The pieces pass where they would as one mesh: each is sound (CheckMesh), as far as its ghosts
/// reach, so that all that is across edges is looked at; and the areas of their own triangles add
/// up to that of the domain. On the first member the figures of `mesh.Quality` are those of the
/// whole, and what is wrong is added to the problems. Returns whether all is well on all members.
bool MeasurePieces(const MeasuredPiece& piece, CrewRounds& rounds, BitingMesh& mesh,
  ExactSum& density, ProblemList& problems, PartOfStage& part);

} // namespace biting

#endif
