// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBodyCheck_h
#define BitingBodyCheck_h

#include "../Finishing/BodyRelaxation.h"
#include "../Surface/SurfaceCheck.h"

#include <string> // for the reason
#include <vector> // for the arrays

namespace biting
{

/// What is found of a body that is to be handed out.
struct BodyVerdict
{
  std::string What; ///< what is wrong first; empty: nothing
  Point3 Place;
  std::vector<Id> CellsBehind; ///< of facets: the tetrahedron on the side they look away from
};

/// The final check, which trusts nothing that was done before. Facets are what they are said to be
/// (RelaxedBody); they cross nowhere; pieces are edges of them; the volume of each label is nearly
/// the one that the surface encloses, whose triangles have `sides`. With tetrahedra that are all
/// positive (FindNotPositive) it follows that they overlap nowhere and fill what the facets bound.
BodyVerdict CheckBody(const CheckedSurface& surface, const std::vector<TriangleSides>& sides,
  const RelaxedBody& body, Pulse& pulse);

/// The first tetrahedron that is not positive by Orient3D, or NoId.
Id FindNotPositive(const std::vector<Point3>& points, const std::vector<Id>& corners, Pulse& pulse);

} // namespace biting

#endif
