// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "InteriorBites.h"

#include "BoundaryAxes.h"
#include "CubeMeetings.h"
#include "SphereMeetings.h"

#include <algorithm> // for max, min
#include <cmath>     // for abs, sqrt
#include <utility>   // for move, swap

namespace biting
{

namespace
{

/// Radius of a sphere, and half the side of a cube, in f: so the mean edge has the length f.
constexpr double SphereConstant = 0.885;
constexpr double CubeConstant = 0.7;

/// So many layers from the boundary cubes have its axes.
constexpr int AlignedLayers = 3;

/// No later center is nearer to a bite's, in radii.
constexpr double Tolerance = 0.9;

/// Bites in a large body of volume 1, of radius 1 or side 2, measured: to tell how far it is.
constexpr double SpheresPerVolume = 1.3;
constexpr double CubesPerVolume = 0.7;

class InteriorBiter
{
public:
  InteriorBiter(const BodyBoundary& boundary, SpaceBiteShape shape, double constant,
    std::size_t mostBites, Pulse& pulse)
    : Boundary(boundary)
    , IsCube(shape == SpaceBiteShape::Cube)
    , Constant(constant > 0.0 ? constant : this->WallConstant())
    , MostBites(mostBites)
    , Beats(pulse)
    , Bounds(BoundsOf(boundary))
    , Tree(Bounds)
    , Axes(IsCube ? AxesOfBoundary(boundary) : std::vector<CubeAxes>())
    , Cubes(Axes)
  {
  }

  InteriorBites Run()
  {
    this->Volume = VolumeOf(this->Boundary);
    this->AddBoundary();
    for (Id ball = 0; ball < this->FirstInner && this->Beats.Beat(64); ++ball)
    {
      this->Start(ball);
    }
    this->EmptyQueue();
    return std::move(this->Bites);
  }

private:
  struct Candidate
  {
    Point3 Place;
    Id Size;       ///< of the tree when it was found: what guards it is later
    Id Frame;      ///< of a cube
    int Layer;     ///< from the boundary
    bool IsAtWall; ///< a parent is of the boundary
  };

  static Box3 BoundsOf(const BodyBoundary& boundary)
  {
    Box3 box;
    for (const Point3& center : boundary.Centers)
    {
      box.Add(center);
    }
    return box;
  }

  /// Of the body, from its facets.
  static double VolumeOf(const BodyBoundary& boundary)
  {
    double volume = 0.0;
    for (std::size_t slot = 0; slot < boundary.Facets.size(); slot += 3)
    {
      const auto at = [&boundary, slot](std::size_t k)
      { return boundary.Centers[static_cast<std::size_t>(boundary.Facets[slot + k])]; };
      volume += Dot(at(0) - boundary.Centers.front(), Cross(at(1) - at(0), at(2) - at(0)));
    }
    return std::abs(volume) / 6.0;
  }

  bool MayGoOn() { return this->Beats.Beat(1) && this->Bites.Centers.size() <= this->MostBites; }

  /// Bites of the boundary, then the empty balls.
  void AddBoundary()
  {
    constexpr double NearShare = 0.15; // of the radius of a ball: no vertex is nearer to its own
    constexpr double Room = 1.02;      // between guard and sphere
    const BodyBoundary& boundary = this->Boundary;
    std::vector<double> guards(boundary.Centers.size(), 0.0);
    for (std::size_t slot = 0; slot < boundary.Facets.size(); ++slot)
    {
      double& guard = guards[static_cast<std::size_t>(boundary.Facets[slot])];
      guard = std::max(guard, NearShare * boundary.Balls[slot / 3].Radius);
    }
    for (std::size_t k = 0; k < boundary.Centers.size() && this->Beats.Beat(4); ++k)
    {
      const double weightRadius = std::sqrt(boundary.Weights[k]);
      const double radius = this->WallConstant() * boundary.Sizes[k];
      const double guard =
        std::max({ guards[k], Tolerance * radius, this->IsCube ? 0.0 : weightRadius });
      this->AddWall(boundary.Centers[k], std::max(radius, Room * guard), guard,
        this->IsCube ? static_cast<Id>(k) + 1 : NoId);
      if (this->IsCube && weightRadius > 0.0)
      {
        this->AddWall(boundary.Centers[k], Room * weightRadius, weightRadius, NoId);
      }
    }
    for (const EmptyBall& ball : boundary.Balls)
    {
      if (ball.Radius > 0.0 && this->Beats.Beat(4))
      {
        this->AddWall(ball.Center, Room * ball.Radius, ball.Radius, NoId);
      }
    }
    this->FirstInner = this->Tree.Size();
  }

  double WallConstant() const { return this->IsCube ? CubeConstant : SphereConstant; }

  void AddWall(const Point3& center, double radius, double guard, Id frame)
  {
    this->Tree.Add(this->Bite(center, radius, guard, frame), [](Id, const GuardedBall&) {});
  }

  static GuardedBall Bite(const Point3& center, double radius, double guard, Id frame)
  {
    return { center, frame == NoId ? radius : radius / HalfSideShare, guard, frame, NoId };
  }

  void EmptyQueue()
  {
    while (!this->Later.empty() && this->MayGoOn())
    {
      std::swap(this->Queue, this->Later);
      this->Later.clear();
      for (std::size_t k = 0; k < this->Queue.size() && this->MayGoOn(); ++k)
      {
        this->Try(this->Queue[k]);
      }
    }
  }

  /// The candidates of a bite of the boundary: each meeting is found by its last bite.
  void Start(Id wall)
  {
    const GuardedBall own = this->Tree.At(wall);
    this->StartMeetings(own);
    this->Tree.VisitNear(
      wall, [this, own](Id id, const GuardedBall& other) { this->Note(own, id, other); });
    this->FindCandidates(own, wall, this->IsCube ? std::max(own.Frame, Id(0)) : NoId, 1);
  }

  void Try(const Candidate& candidate)
  {
    const auto isGuarded = [this, &candidate](const GuardedBall& ball)
    { return CubeMeetings::IsGuarded(ball, this->Axes, candidate.Place); };
    if (this->Tree.HasAt(candidate.Place, candidate.Size, isGuarded) ||
      !this->Bounds.Contains(candidate.Place) ||
      (candidate.IsAtWall && !this->Boundary.IsInside(candidate.Place)))
    {
      return;
    }
    this->Beats.Beat(64);
    const double size = this->Boundary.Spacing(candidate.Place);
    const double radius = this->Constant * size;
    this->Bites.Centers.push_back(candidate.Place);
    this->Bites.Sizes.push_back(size);
    this->Bites.Radii.push_back(radius);
    if (this->IsCube)
    {
      this->Bites.Axes.push_back(this->Axes[static_cast<std::size_t>(candidate.Frame)]);
    }
    this->Taken += radius * radius * radius / (this->IsCube ? CubesPerVolume : SpheresPerVolume);
    this->Beats.SetFraction(std::min(1.0, this->Taken / this->Volume));
    const Id id = this->Tree.Size();
    const GuardedBall own =
      this->Bite(candidate.Place, radius, Tolerance * radius, candidate.Frame);
    this->StartMeetings(own);
    this->Tree.Add(
      own, [this, &own](Id other, const GuardedBall& ball) { this->Note(own, other, ball); });
    this->FindCandidates(own, id,
      candidate.Layer < AlignedLayers ? candidate.Frame : std::min(candidate.Frame, Id(0)),
      candidate.Layer + 1);
  }

  void StartMeetings(const GuardedBall& own)
  {
    if (own.Frame == NoId)
    {
      this->Spheres.Start(own);
    }
    else
    {
      this->Cubes.Start(own);
    }
  }

  /// A neighbor.
  void Note(const GuardedBall& own, Id id, const GuardedBall& other)
  {
    if (own.Frame != NoId)
    {
      this->Cubes.Add(other);
    }
    else if (other.Frame == NoId)
    {
      this->Spheres.Add(other, id);
    }
  }

  /// The meetings of its surface. Those of balls of the boundary only may be within cubes.
  void FindCandidates(const GuardedBall& own, Id id, Id frame, int layer)
  {
    const Id first = this->IsCube && own.Frame == NoId ? 0 : std::max(id, this->FirstInner);
    if (own.Frame == NoId)
    {
      const bool isWall = id < this->FirstInner;
      this->Spheres.Find([isWall, id](Id other) { return !isWall || other < id; },
        [this, isWall, first, frame, layer](const Point3& place, Id a, Id b)
        {
          const bool isAtWall =
            isWall || this->Constant > SphereConstant || std::min(a, b) < this->FirstInner;
          this->Later.push_back({ place, first, frame, layer, isAtWall });
        });
      return;
    }
    for (const Point3& meeting : this->Cubes.Find())
    {
      // Corners of cubes reach beyond the boundary: all of them are tested.
      this->Later.push_back({ meeting, first, frame, layer, true });
    }
  }

  const BodyBoundary& Boundary;
  const bool IsCube;
  const double Constant; ///< of bites inside
  const std::size_t MostBites;
  Pulse& Beats;
  Box3 Bounds;
  BallTree Tree;     ///< bites of the boundary, empty balls, bites
  Id FirstInner = 0; ///< in the tree
  std::vector<CubeAxes> Axes;
  SphereMeetings Spheres;
  CubeMeetings Cubes;
  std::vector<Candidate> Queue; ///< found together
  std::vector<Candidate> Later; ///< found by the bites of Queue
  InteriorBites Bites;
  double Volume = 0.0; ///< of the body
  double Taken = 0.0;  ///< of it
};

} // namespace

InteriorBites BiteInterior(const BodyBoundary& boundary, SpaceBiteShape shape,
  std::size_t mostBites, Pulse& pulse, double constant)
{
  return boundary.Centers.empty()
    ? InteriorBites()
    : InteriorBiter(boundary, shape, constant, mostBites, pulse).Run();
}

} // namespace biting
