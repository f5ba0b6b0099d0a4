// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingGlobe_h
#define BitingGlobe_h

#include "../../Kernel/Base/Ids.h"
#include "../../Kernel/Base/Point.h"
#include "../../Kernel/Mesh/BitingMesh.h"
#include "../../Kernel/Quality/Quality.h"
#include "../../Kernel/Spacing/Spacing.h"
#include "PlaneFrame.h"

#include <string> // for the refusal
#include <vector> // for the arrays

namespace biting
{

struct PlanarInput;

/// The mean radius of the Earth in metres, (2 a + b) / 3 of the ellipsoid WGS 84.
constexpr double EarthRadius = 6371008.8;

/// Lengths of the globe for one degree of a great circle.
constexpr double MetresPerDegree = EarthRadius * 3.14159265358979323846 / 180.0;

/// The unit vector of a place in degrees: longitude, latitude. All longitudes of a pole are one
/// place, and so are longitudes that are a whole turn apart, but for their own rounding.
Point3 DirectionOf(const double* degrees);

/// Longitude in [-180, 180) and latitude of a direction, which need not be of unit length.
Point2 DegreesOf(const Point3& direction);

/// Fits the stereographic plane to the `points` among `coordinates` (three a point, finite),
/// between which straight lines run as `ends` say, two points a line. Its middle is the direction
/// of the mean of their unit vectors; where that is too far from some of them, that of a pole which
/// is not: around a whole parallel the mean is of rounding. Their order plays no part.
///
/// Longitudes are mapped back as they are given: within [-180, 180) where all are, or within [0,
/// 360) where these are. Where lines of the input jump from one end of that range to the other, or
/// it has points at both, longitudes lie within 180 degrees of the middle: the mesh continues
/// across the jump, beyond 180. Around a pole every range has a jump: it is that of the input then.
///
/// Returns a refusal: of latitudes beyond 90 degrees, and of points more than 170 degrees from the
/// middle, with ids and places.
std::string FitGlobe(const double* coordinates, const std::vector<Id>& points,
  const std::vector<Id>& ends, PlaneFrame& frame);

/// How far a line that is straight in degrees may be from one that is straight in the plane: a
/// share of its length; and, where it is longer than LongestEdge times f, a share of f. So it is
/// within 0.028 f anywhere, and parts are no shorter than an edge of the mesh because of f.
constexpr double DeviationInLength = 0.02;
constexpr double DeviationInSpacing = 0.01;
constexpr double LongestEdge = 1.4;

/// Divides the lines of `input`, which are straight in degrees, until each part is as straight in
/// the plane as the length of it asks for; or, where `spacing` is not null, as its f does, without
/// the feature size. The new points have ids from the number of points of the input on
/// (PlanarInput::Divisions). A line goes the shorter way around the globe, and to a pole along the
/// meridian.
void DivideLines(const SpacingOptions* spacing, PlanarInput& input, Monitor& monitor);

/// Turns lengths of the plane at the `points` into those of the globe, in metres: of the spacing
/// and of the distances to neighbours. Conformity stays as it is.
void ToMetres(const PlaneFrame& frame, const std::vector<Point2>& points,
  std::vector<double>& spacing, MeshQuality& quality);

/// The same of `mesh`, which was made of `input` with `numberOfPoints` points: those that divide
/// lines are no points of the input.
void EndOnGlobe(const PlanarInput& input, std::int64_t numberOfPoints, BitingMesh& mesh);

} // namespace biting

#endif
