// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMeshAssembly_h
#define BitingMeshAssembly_h

#include "../Base/Monitor.h"
#include "../Biting/BitingScheme.h"
#include "../Delaunay/Triangulation.h"
#include "../Domain/Domain.h"
#include "../Mesh/BitingMesh.h"

#include <functional> // for the choice

namespace biting
{

/// Puts the results of the rooms together: drops vertices that no triangle uses, says what each
/// vertex is, and lists the mesh edges that cover segments, in the order of these.
/// `mesh` refers to the points and edges of `bites`; all but its constraints moves into the result.
/// Where the monitor asks to stop the result has no meaning.
BitingMesh AssembleMesh(
  const Domain& domain, BitingResult bites, Triangulation& mesh, Monitor& monitor);

/// Cuts a whole mesh along the interfaces of the input cells that `opens` chooses, as cracks do:
/// a vertex on them becomes one vertex for each sector of triangles that they leave around it. So
/// the ends of a crack stay single, unless they are on the boundary, and where cracks meet there
/// are as many vertices as sectors. The first copy keeps the number, the others come last, with the
/// values of the first, but without partners. Each edge that opens is followed by that of its other
/// side, both with their triangle on their left. Measures the quality again. Cost O(n log n).
void OpenInterfaces(const std::function<bool(Id)>& opens, BitingMesh& mesh, Monitor& monitor);

} // namespace biting

#endif
