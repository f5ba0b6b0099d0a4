// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshAssembly_h
#define BitingMeshAssembly_h

#include "../Biting/BitingScheme.h"
#include "../Delaunay/Triangulation.h"
#include "../Domain/Domain.h"
#include "../Mesh/BitingMesh.h"

namespace biting
{

/// Puts the results of the rooms together: drops vertices that no triangle uses, says what each
/// vertex is, and lists the mesh edges that cover segments, in the order of these.
/// `mesh` refers to the points and edges of `bites`; all but its constraints moves into the result.
/// Where the monitor asks to stop the result has no meaning.
BitingMesh AssembleMesh(
  const Domain& domain, BitingResult bites, Triangulation& mesh, Monitor& monitor);

} // namespace biting

#endif
