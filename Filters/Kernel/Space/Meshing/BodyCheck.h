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

/// The result of the final check of a body.
struct BodyVerdict
{
  std::string What;     ///< the first fault; empty: none
  bool IsCoarse = true; ///< it is a volume: f is too large for the surface
  Point3 Place;
  std::vector<Id> CellsBehind; ///< of facets: the tetrahedron on the side they look away from
};

/// The final check, which trusts no earlier step. Checks: facets are those of RelaxedBody::Facets;
/// they cross nowhere; pieces are edges of facets; the volume of each label is nearly that inside
/// the surface, whose triangles have `sides`. With tetrahedra that are all positive
/// (FindNotPositive) it follows that they overlap nowhere and fill the space that facets bound.
BodyVerdict CheckBody(const CheckedSurface& surface, const std::vector<TriangleSides>& sides,
  const RelaxedBody& body, Pulse& pulse);

/// The first tetrahedron that is not positive by Orient3D, or NoId.
Id FindNotPositive(const std::vector<Point3>& points, const std::vector<Id>& corners, Pulse& pulse);

} // namespace biting

#endif
