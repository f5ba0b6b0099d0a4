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

/// The side of a cube in units of its diagonal: 1 / sqrt(3).
constexpr double HalfSideShare = 0.57735026918962576;

/// Axes of cubes: those of the world, then those of vertex k at k + 1. The first axis is the normal
/// of a facet at the vertex. The second is, made orthogonal to the first, the normal of a facet
/// turned by more than 40 degrees, as at feature lines, or else an axis of the world.
std::vector<CubeAxes> AxesOfBoundary(const BodyBoundary& boundary);

/// The meetings on the surface of one cube, outside of all guards of cubes and balls: its corners,
/// the places where another surface crosses its edges, and where two others cross on a face.
///
/// Face by face: another cube meets the plane of a face in a convex polygon. Sides inside one guard
/// are left out. Meetings are the ends of sides, and the crossings of sides.
class CubeMeetings
{
public:
  /// Half a side in f, for a mean edge length f; and the number of cubes of side 2 per unit of a
  /// large volume. Both measured.
  static constexpr double BitingConstant = 0.7;
  static constexpr double BitesPerVolume = 0.7;

  /// `axes`: of all cubes, by GuardedBall::Frame.
  explicit CubeMeetings(const std::vector<CubeAxes>& axes)
    : Axes(axes)
  {
  }

  /// Whether the place lies in the guard of a cube or a ball.
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
  std::vector<GuardedBall> Others;
  std::vector<Side> Sides;
  std::vector<Point3> Meetings;
};

} // namespace biting

#endif
