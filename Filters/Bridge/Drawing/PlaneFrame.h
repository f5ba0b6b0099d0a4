// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPlaneFrame_h
#define BitingPlaneFrame_h

#include "../../Kernel/Base/Ids.h"
#include "../../Kernel/Base/Point.h"
#include "../../Kernel/Base/Pulse.h"

#include <array>  // for axes
#include <vector> // for point lists

namespace biting
{

/// A plane in space with coordinates of its own: what the kernel meshes in.
///
/// Where all points share one coordinate, but for rounding, the plane's coordinates are the other
/// two as they are: the mapping is exact both ways. Otherwise the plane is fitted: through a large
/// triangle of the points, then by least squares; its origin is the centre of the points' box, and
/// its first axis is the projection of a coordinate axis. The axes and the normal are right-handed;
/// the normal's largest component is positive.
///
/// Or the stereographic plane of the globe (Globe.h): x and y are longitude and latitude in degrees
/// then, z is `level`, and lengths of the plane are metres at its middle, StretchAt times those of
/// the globe elsewhere.
class PlaneFrame
{
public:
  /// Fits to the `points` among `coordinates` (three a point, finite), which `rounding` may have
  /// moved (CoordinateRounding.h). Neither their order nor how often a place occurs matters. Cost
  /// O(n log n), where all share one coordinate O(n). Points that are collinear in space, or all
  /// equal, get one of the planes that hold them. On abort the plane has no meaning.
  static PlaneFrame FitTo(
    const double* coordinates, const std::vector<Id>& points, double rounding, Pulse& pulse);

  /// The stereographic plane about `middle`, a unit vector. Longitudes that are mapped back lie
  /// within 180 degrees of `longitude`.
  static PlaneFrame OnGlobe(const Point3& middle, double longitude, double level);

  /// Degrees as a plane of their own, at the level of this frame.
  PlaneFrame OfDegrees() const { return Aligned(2, this->Level); }

  bool IsOnGlobe() const { return this->SquaredDiameter > 0.0; }
  double StretchAt(const Point2& p) const { return 1.0 + this->Curvature() * Dot(p, p); }
  double Curvature() const { return this->IsOnGlobe() ? 1.0 / this->SquaredDiameter : 0.0; }

  /// On the globe, the cosine of the angle between a place and the middle.
  double LevelOf(const double* place) const;

  /// The longitude by whole turns near that of the frame; as it is where it is no farther than 180
  /// degrees from it.
  double TurnedLongitude(double longitude) const;

  Point2 ToPlane(const double* place) const;
  Point3 ToSpace(const Point2& p) const;

  /// A vector of space as one of the plane. False where it is off by more than 1e-6 of its length,
  /// or not finite.
  bool TakeVector(const Point3& vector, Point2& inPlane) const;

  /// Signed distance from the plane, positive on the side of the normal.
  double Distance(const double* place) const;

  /// Whether the plane's coordinates are coordinates of space as they are; then Axis(0) and Axis(1)
  /// say which, and Axis(2) the one that is constant.
  bool IsAxisAligned() const { return this->IsAligned; }
  int Axis(int k) const { return this->Axes[k]; }

private:
  static PlaneFrame Aligned(int normalAxis, double level);
  static PlaneFrame WithNormal(const Point3& origin, const Point3& normal);

  bool IsAligned = true;
  std::array<int, 3> Axes{ 0, 1, 2 };
  double Level = 0.0;
  double SquaredDiameter = 0.0; ///< of the globe; 0: a plane
  double Longitude = 0.0;       ///< about which longitudes are mapped back

  Point3 Origin{ 0.0, 0.0, 0.0 };
  Point3 First{ 1.0, 0.0, 0.0 };
  Point3 Second{ 0.0, 1.0, 0.0 };
  Point3 Normal{ 0.0, 0.0, 1.0 };
};

} // namespace biting

#endif
