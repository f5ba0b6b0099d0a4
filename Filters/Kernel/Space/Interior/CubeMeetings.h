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

/// Axes of cubes at the vertices of a boundary, behind those of the world: an axis is the normal of
/// a facet of the vertex. At feature lines, where facets differ by more than 40 degrees, that of
/// another facet is the second, as far as it is at right angles to the first.
std::vector<CubeAxes> AxesOfBoundary(const BodyBoundary& boundary);

/// The places of one cube's surface where the surfaces of two other cubes meet it, or one at an
/// edge, or its own edges meet, and no guard has them, nor that of a ball.
///
/// Face by face: in its plane other cubes have convex polygons. Sides that one guard has are left
/// out. Meetings are the ends of sides, and where sides cross.
class CubeMeetings
{
public:
  /// Half a side in f, so that the mean edge has the length f; and cubes of side 2 that take a large
  /// volume of 1. Both measured.
  static constexpr double BitingConstant = 0.7;
  static constexpr double BitesPerVolume = 0.7;

  /// `axes`: of all cubes, by GuardedBall::Frame.
  explicit CubeMeetings(const std::vector<CubeAxes>& axes)
    : Axes(axes)
  {
  }

  /// Whether the guard of a cube or a ball has a place.
  bool IsGuarded(const GuardedBall& ball, const Point3& place) const;

  void Start(const GuardedBall& cube);
  void Add(Id id, const GuardedBall& other);

  /// Calls visit(place, 0, 0) for the meetings, each once.
  template <typename IsParent, typename Visit>
  void Find(const IsParent& /*isParent*/, const Visit& visit)
  {
    this->FindAll();
    for (const Point3& place : this->Meetings)
    {
      visit(place, 0, 0);
    }
  }

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

  void FindAll();
  void FindOn(const Face& face);
  void CutCube(const Face& face, const GuardedBall& other);
  void AddSide(const Face& face, const Side& side);
  void CrossSides(const Face& face, const Side& a, const Side& b);
  void Keep(const Face& face, const Point2& place);

  const std::vector<CubeAxes>& Axes;
  GuardedBall Own;
  double HalfSide = 0.0;
  std::vector<Other> Others;
  std::vector<Side> Sides;
  std::vector<Point3> Meetings;
};

} // namespace biting

#endif
