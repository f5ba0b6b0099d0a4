// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPredicates3_h
#define BitingPredicates3_h

#include "../Base/Point.h"

namespace biting
{

/// The exact signs that decide topology in space: the sisters of those of the plane
/// (Predicates.h), made in the same way. The first stage is a filter in double arithmetic with a
/// proven error bound, the second has DoubleDouble, the third expansions. Calls are counted with
/// those of the plane (PredicateCounts).
///
/// Exact for coordinates that are zero or between LeastCoordinate3 and GreatestCoordinate3 in
/// magnitude, and for weights that are zero or between the squares of these; differences may be
/// as small as they come.
constexpr double GreatestCoordinate3 = 1e50;
constexpr double LeastCoordinate3 = 1e-50;

/// A point with a weight: the square of the radius of a sphere around it. May be negative.
struct WeightedPoint
{
  Point3 Place;
  double Weight = 0.0;
};

/// Sign of the volume of the tetrahedron (a, b, c, d): that of (b - a) x (c - a) . (d - a), which
/// is positive for VTK's tetrahedra; 0 exactly coplanar.
/// Laws: an even permutation of the arguments keeps the sign, an odd one negates it.
int Orient3D(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// Position of e against the sphere through a, b, c, d, which are oriented positively:
/// +1 inside, -1 outside, 0 exactly on it.
/// Laws: an even permutation of the five keeps the sign, an odd one negates it.
int InSphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e);

/// Position of e against the sphere that is orthogonal to a, b, c, d, which are oriented
/// positively: +1 where the power distance of the two is negative (in a regular triangulation e
/// and the tetrahedron exclude each other), -1 where it is positive, 0 where it is exactly 0.
/// Laws: those of InSphere; the same weight added to all five changes nothing if the sums are
/// exact; equal weights give InSphere.
int PowerTest(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c,
  const WeightedPoint& d, const WeightedPoint& e);

/// What InSphere and PowerTest say where they are 0 if each weight is lowered by a power of an
/// infinitely small number, that of the lexicographically greatest point most: +1 or -1, never 0.
/// Precondition: the five places are distinct, a, b, c, d oriented positively.
/// Laws: those of InSphere, for permutations that keep the orientation positive. The answers for
/// all tetrahedra of a set of points fit together: they are those of weights in general position,
/// so one triangulation has them, and none of its tetrahedra is flat.
/// Source: O. Devillers, M. Teillaud, "Perturbations for Delaunay and weighted Delaunay 3D
/// triangulations", 2011.
int TieInSphere(
  const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e);

/// The centre of the sphere that is orthogonal to a, b, c, d (through them, without weights), as a
/// vector from a. Precondition: Orient3D is not 0.
/// Off by less than 1e-10 of the greatest distance between two of the four and 1e-15 of its length,
/// if their weights are not larger than the square of that distance; however flat the four are.
Point3 PowerCenter(
  const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c, const WeightedPoint& d);

} // namespace biting

#include "PredicateFilters3.h" // for the first stages, inline

#endif
