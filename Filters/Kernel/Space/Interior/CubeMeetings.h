// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingCubeMeetings_h
#define BitingCubeMeetings_h

#include "BallTree.h"
#include "InteriorBites.h"

#include <cstddef> // for indices
#include <vector>  // for the arrays

namespace biting
{

/// Half of the side of a cube, in that of half its diagonal.
constexpr double HalfSideShare = 0.57735026918962576;

/// The places of one cube's surface where the surfaces of two others meet it, or one at an edge, or
/// its own edges meet, and no guard has them. Others are cubes and balls.
///
/// Face by face: in the plane of a face other cubes have convex polygons, balls have disks. Sides
/// that one guard has are left out. Meetings are the ends of sides, and where sides and circles of
/// different ones cross.
class CubeMeetings
{
public:
  /// `axes`: of all cubes, by GuardedBall::Frame.
  explicit CubeMeetings(const std::vector<CubeAxes>& axes)
    : Axes(axes)
  {
  }

  void Start(const GuardedBall& cube);
  void Add(const GuardedBall& other);

  /// Meetings, each once.
  const std::vector<Point3>& Find();

  /// Whether the place is in the guard of a cube or a ball.
  static bool IsGuarded(
    const GuardedBall& ball, const std::vector<CubeAxes>& axes, const Point3& place);

private:
  struct Other
  {
    GuardedBall Ball;
    double Distance2;
  };

  /// In the plane of a face, in its axes.
  struct Side
  {
    Point2 Tail;
    Point2 Head;
  };
  struct Disk
  {
    Point2 Center;
    double Radius2;
  };

  struct Face
  {
    Point3 Origin;
    Point3 U;
    Point3 V;
    Point3 At(const Point2& place) const
    {
      return this->Origin + place.X * this->U + place.Y * this->V;
    }
  };

  /// Half of the extent of a bite along a direction.
  double HalfWidth(const GuardedBall& ball, const Point3& direction) const;
  void FindOn(const Face& face);
  void CutCube(const Face& face, const Other& other);
  void AddSide(const Face& face, const Side& side);
  void CrossSides(const Face& face, const Side& a, const Side& b);
  void CrossCircle(const Face& face, const Disk& disk, const Side& side);
  void CrossCircles(const Face& face, const Disk& a, const Disk& b);
  void Keep(const Face& face, const Point2& place);

  const std::vector<CubeAxes>& Axes;
  GuardedBall Own;
  double HalfSide = 0.0;
  std::vector<Other> Others;
  std::vector<Side> Sides;
  std::vector<Disk> Disks;
  std::vector<Point3> Meetings;
};

} // namespace biting

#endif
