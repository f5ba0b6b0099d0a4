// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTriangleContact_h
#define BitingTriangleContact_h

#include "../../Base/Point.h"

#include <array> // for corners

namespace biting
{

using Triangle3 = std::array<Point3, 3>;

/// Sign of the height of p over the plane of the triangle: +1 where its normal points to, 0 exactly
/// on it.
int HeightOver(const Triangle3& triangle, const Point3& p);

/// Whether the ray from p along the first axis meets the triangle; p is not on that. Exact, and no
/// ray meets an edge: p counts as moved by (e, e^2) along the other axes, e being infinitesimal.
bool MeetRay(const Triangle3& triangle, const Point3& p);

/// Whether the closed segment pq and the closed triangle have a common point, decided exactly. The
/// triangle is not flat, and p is not q. `place` then is one, rounded.
bool Meets(const Triangle3& triangle, const Point3& p, const Point3& q, Point3& place);

/// Whether two triangles that are not flat have a common point beside those where they are joined:
/// their first `shared` corners (0 or 1), which are equal. `place` then is one, rounded.
bool Meet(const Triangle3& a, const Triangle3& b, std::size_t shared, Point3& place);

/// How far one of two triangles that meet has to be moved until they only touch, rounded: the least
/// overlap of their shadows on the normals, on the normals of the sides in the planes, and on the
/// cross products of sides.
double DepthOfMeeting(const Triangle3& a, const Triangle3& b);

} // namespace biting

#endif
