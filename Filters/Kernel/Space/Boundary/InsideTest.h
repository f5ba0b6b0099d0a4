// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingInsideTest_h
#define BitingInsideTest_h

#include "../../Base/BoxTree.h"
#include "../Surface/SurfaceMesh.h"

namespace biting
{

/// Whether a place is inside a closed surface: an odd number of its triangles is met by the ray
/// along the first axis. Exact: the ray passes no edge, as if its place were moved by infinitely
/// little along the third axis and by less along the second. Places on the surface are either.
class InsideTest
{
public:
  InsideTest(const SurfaceMesh& mesh, const BoxTree<SurfaceItem, 3>& tree)
    : Mesh(mesh)
    , Tree(tree)
    , Bounds(mesh.Bounds())
  {
  }

  bool IsInside(const Point3& place) const;

private:
  bool IsMet(std::size_t triangle, const Point3& place) const;

  const SurfaceMesh& Mesh;
  const BoxTree<SurfaceItem, 3>& Tree;
  Box3 Bounds;
};

} // namespace biting

#endif
