// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshAssembly_h
#define BitingMeshAssembly_h

#include "Biting/BitingScheme.h"
#include "BitingMesh.h"
#include "Delaunay/Triangulation.h"
#include "Domain/Domain.h"

namespace biting
{

/// Puts the results of the rooms together: drops vertices that no triangle uses, says what each
/// vertex is, and lists the mesh edges that cover segments, in the order of these.
/// `mesh` refers to the points and edges of `bites`; its corners are renumbered in place.
BitingMesh AssembleMesh(const Domain& domain, BitingResult bites, Triangulation& mesh);

/// The largest slope |f(u) - f(v)| / |u - v| over the edges of the mesh.
double LipschitzConstant(const BitingMesh& mesh);

} // namespace biting

#endif
