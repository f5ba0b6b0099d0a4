// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFineDrawing_h
#define BitingFineDrawing_h

#include "../Base/Pulse.h"
#include "../Domain/Domain.h"
#include "../Mesh/BitingMesh.h"
#include "../Quality/ExactSum.h"
#include "../Spacing/Spacing.h"

#include <vector> // for spacings

namespace biting
{

/// Whether more than half of the vertices of the drawing are more than twice as dense as the
/// spacing asks for before the limit by feature size, and are no small part of so many vertices of
/// a mesh, which has `spacings` at the first ones.
bool IsFineDrawing(const Domain& drawing, const std::vector<double>& spacings,
  double numberOfVertices, const Spacing& spacing);

/// The integral of 1/f^2 over the triangles of the mesh, but for ghosts, with f as before the limit
/// by feature size.
ExactSum CountAsked(const BitingMesh& mesh, const Spacing& spacing, Pulse& pulse);

/// The share of the vertices of a mesh that are there only because those of a fine drawing are: how
/// many more they are than the spacing asks for, which CountAsked says.
double ShareOfFineDrawing(const ExactSum& asked, double numberOfVertices);

/// Whether it is told: more than half of the vertices, and five hundred of them at least. A mesh
/// smaller than that is not worth a note.
bool IsWorthTelling(double shareOfDrawing, double numberOfVertices);

} // namespace biting

#endif
