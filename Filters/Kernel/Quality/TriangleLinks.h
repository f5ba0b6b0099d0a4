// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTriangleLinks_h
#define BitingTriangleLinks_h

#include "../Base/Ids.h"

#include <vector> // for the arrays

namespace biting
{

/// Which triangles share an edge, found from nothing but their corners.
struct TriangleLinks
{
  /// Three a triangle, across the edge opposite each corner, as in Triangulation; NoId where there
  /// is none. Triangles at an edge of more than two are linked in a ring, and one with two equal
  /// corners to itself, so that of the slots of an edge exactly one has no or a smaller id across.
  std::vector<Id> Neighbors;

  /// One triangle for each edge of more than two, ascending by the ends of the edge.
  std::vector<Id> Crowded;
};

/// Links triangles over points 0 .. numberOfPoints - 1, three corners each, of any orientation.
/// Cost O(n) where no point has very many triangles.
TriangleLinks LinkTriangles(const std::vector<Id>& corners, Id numberOfPoints);

} // namespace biting

#endif
