// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFineDrawing_h
#define BitingFineDrawing_h

#include "BitingMesh.h"

namespace biting
{

/// The share of the vertices of a mesh that are there only because those of the drawing are: how
/// many more they are than the spacing asks for before the limit by feature size. 0 unless more
/// than half of the vertices of the drawing are more than twice as dense as that.
double ShareOfFineDrawing(
  const Domain& drawing, const BitingMesh& mesh, const Spacing& spacing, Monitor& monitor);

/// Whether it is told: more than half of the vertices, and five hundred of them at least. A mesh
/// smaller than that is not worth a note.
bool IsWorthTelling(double shareOfDrawing, const BitingMesh& mesh);

} // namespace biting

#endif
