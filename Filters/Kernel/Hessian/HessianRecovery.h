// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

// The numerical spacing of the paper (section 2.1): f = sqrt(epsilon / lambda), with lambda the
// largest absolute eigenvalue of the Hessian of a solution that is known at points.
//
// What f is worth: between the ends of an edge of length h, the linear interpolant of a function
// whose second derivatives are at most lambda is off by at most lambda h^2 / 8; inside of a
// triangle by at most lambda R^2 / 2, R being the radius of the smallest circle that holds it (both
// are reached by quadratics). With edges of length f that is epsilon / 8 along edges, and epsilon /
// 6 inside of an equilateral triangle, where R = h / sqrt(3).

#ifndef BitingHessianRecovery_h
#define BitingHessianRecovery_h

#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Base/Point.h"

#include <vector> // for the arrays

namespace biting
{

/// The second derivatives of a function of the plane at a point; all NaN where they are unknown.
struct Hessian2
{
  double XX = 0.0;
  double XY = 0.0;
  double YY = 0.0;
};

/// Cells of any number of corners over points: cell c has Corners[Offsets[c] .. Offsets[c + 1]).
struct CellsView
{
  const std::vector<Point2>& Points;
  const std::vector<Id>& Offsets; ///< one more than cells
  const std::vector<Id>& Corners;
};

/// The Hessian of the function with `values` at the points: that of the quadratic polynomial with
/// the least sum of squared differences at the points of the cells around each point. Where these
/// do not determine one well, as at corners, the cells around them are added, up to four rings or
/// 64 points. Laws: exact, up to rounding, for quadratics, at the boundary as inside; an affine map
/// of the plane changes it as it changes a Hessian; a point is never compared with one across a
/// hole or a slit. Values that are not finite are left out, and their points, like those with too
/// few others around, get NaN. Cost O(n), memory that of the cells once more. Empty where the
/// monitor asked to stop.
std::vector<Hessian2> RecoverHessians(
  const CellsView& cells, const std::vector<double>& values, Monitor& monitor);

/// The largest absolute eigenvalue: the largest absolute second derivative in any direction.
double SpectralNorm(const Hessian2& hessian);

/// `norms` at the points, and where one is NaN, though the value there is finite, the largest of
/// the points around it in cells that have one; ring by ring, as far as cells are joined. Cost
/// O(n).
std::vector<double> WithThoseAround(
  const CellsView& cells, const std::vector<double>& values, std::vector<double> norms);

/// f = sqrt(errorTolerance / norm), at least `minimum` and at most `maximum`, which is also f where
/// the norm or errorTolerance is 0; NaN where the norm is NaN. minimum <= maximum. Law: f is never
/// 0; where it is none of the normal numbers it is the smallest of these.
double NumericalSpacing(double norm, double errorTolerance, double minimum, double maximum);

} // namespace biting

#endif
