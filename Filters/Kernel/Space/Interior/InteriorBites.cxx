// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "InteriorBites.h"

#include "CubeMeetings.h"
#include "SphereMeetings.h"

#include <algorithm> // for max, min
#include <cmath>     // for abs, sqrt
#include <utility>   // for move, swap

namespace biting
{

namespace
{

/// So many layers from the boundary cubes have its axes.
constexpr int AlignedLayers = 3;

/// No later center is nearer to a bite's, in radii.
constexpr double Tolerance = 0.9;

/// Bites by the meetings of spheres, or of cubes: these have axes.
template <typename Meetings>
class InteriorBiter
{
public:
  InteriorBiter(const BodyBoundary& boundary, std::vector<CubeAxes> axes, double constant,
    std::size_t mostBites, Pulse& pulse)
    : Boundary(boundary)
    , Axes(std::move(axes))
    , Constant(constant > 0.0 ? constant : Meetings::BitingConstant)
    , MostBites(mostBites)
    , Beats(pulse)
    , Bounds(BoundsOf(boundary))
    , Tree(Bounds)
    , Surface(this->Axes)
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
    Id Size;      ///< of the tree when it was found: what guards it is later
    Id Frame;     ///< of a cube
    int Layer;    ///< from the boundary
    bool IsAsked; ///< to be inside
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
    const BodyBoundary& boundary = this->Boundary;
    std::vector<double> guards(boundary.Centers.size(), 0.0);
    for (std::size_t slot = 0; slot < boundary.Facets.size(); ++slot)
    {
      double& guard = guards[static_cast<std::size_t>(boundary.Facets[slot])];
      guard = std::max(guard, NearShare * boundary.Balls[slot / 3].Radius);
    }
    for (std::size_t k = 0; k < boundary.Centers.size() && this->Beats.Beat(4); ++k)
    {
      const Point3& center = boundary.Centers[k];
      const double radius = Meetings::BitingConstant * boundary.Sizes[k];
      const double ofWeight = std::sqrt(boundary.Weights[k]);
      const double guard = std::max(guards[k], Tolerance * radius);
      if (this->Axes.empty())
      {
        this->AddWall(center, radius, std::max(guard, ofWeight), NoId);
      }
      else
      {
        this->AddWall(center, radius, guard, static_cast<Id>(k) + 1);
        this->AddWall(center, 0.0, ofWeight, NoId);
      }
    }
    for (const EmptyBall& ball : boundary.Balls)
    {
      this->AddWall(ball.Center, 0.0, ball.Radius, NoId);
    }
    this->FirstInner = this->Tree.Size();
  }

  void AddWall(const Point3& center, double radius, double guard, Id frame)
  {
    constexpr double Room = 1.02; // between guard and sphere
    if (guard > 0.0)
    {
      this->Tree.Add(this->Bite(center, std::max(radius, Room * guard), guard, frame));
    }
  }

  static GuardedBall Bite(const Point3& center, double radius, double guard, Id frame)
  {
    return { center, frame == NoId ? radius : radius / HalfSideShare, guard, frame };
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

  /// The candidates of a bite of the boundary, or of an empty ball among spheres.
  void Start(Id wall)
  {
    const GuardedBall own = this->Tree.At(wall);
    if ((own.Frame == NoId) == this->Axes.empty())
    {
      this->Surface.Start(own);
      this->Tree.VisitNear(
        wall, [this](Id id, const GuardedBall& other) { this->Surface.Add(id, other); });
      this->FindCandidates(wall, own.Frame, 1);
    }
  }

  void Try(const Candidate& candidate)
  {
    const auto isGuarded = [this, &candidate](const GuardedBall& ball)
    { return this->Surface.IsGuarded(ball, candidate.Place); };
    if (!this->Bounds.Contains(candidate.Place) ||
      this->Tree.HasAt(candidate.Place, candidate.Size, isGuarded) ||
      (candidate.IsAsked && !this->Boundary.IsInside(candidate.Place)))
    {
      return;
    }
    this->Beats.Beat(64);
    const double size = this->Boundary.Spacing(candidate.Place);
    const double radius = this->Constant * size;
    this->Bites.Centers.push_back(candidate.Place);
    this->Bites.Sizes.push_back(size);
    this->Bites.Radii.push_back(radius);
    const bool isAligned = candidate.Frame == NoId || candidate.Layer < AlignedLayers;
    if (candidate.Frame != NoId)
    {
      this->Bites.Axes.push_back(this->Axes[static_cast<std::size_t>(candidate.Frame)]);
    }
    this->Taken += radius * radius * radius / Meetings::BitesPerVolume;
    this->Beats.SetFraction(std::min(1.0, this->Taken / this->Volume));
    const GuardedBall own =
      this->Bite(candidate.Place, radius, Tolerance * radius, candidate.Frame);
    this->Surface.Start(own);
    this->Tree.Add(own, [this](Id id, const GuardedBall& other) { this->Surface.Add(id, other); });
    this->FindCandidates(
      this->Tree.Size() - 1, isAligned ? candidate.Frame : 0, candidate.Layer + 1);
  }

  /// The meetings of the surface of a bite. Those of the boundary are found by their last one.
  void FindCandidates(Id id, Id frame, int layer)
  {
    const bool isWall = id < this->FirstInner;
    const bool areAsked = isWall || this->Constant > Meetings::BitingConstant;
    const Id size = std::max(id, this->FirstInner);
    this->Surface.Find([isWall, id](Id other) { return !isWall || other < id; },
      [this, areAsked, size, frame, layer](const Point3& place, Id a, Id b)
      {
        const bool isAsked = areAsked || std::min(a, b) < this->FirstInner;
        this->Later.push_back({ place, size, frame, layer, isAsked });
      });
  }

  const BodyBoundary& Boundary;
  const std::vector<CubeAxes> Axes; ///< of cubes: those of the world, of vertices of the boundary
  const double Constant;            ///< of bites inside
  const std::size_t MostBites;
  Pulse& Beats;
  Box3 Bounds;
  BallTree Tree;                ///< bites of the boundary, empty balls, bites
  Id FirstInner = 0;            ///< in the tree
  Meetings Surface;             ///< of the bite at hand
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
  if (boundary.Centers.empty())
  {
    return {};
  }
  return shape == SpaceBiteShape::Cube
    ? InteriorBiter<CubeMeetings>(boundary, AxesOfBoundary(boundary), constant, mostBites, pulse)
        .Run()
    : InteriorBiter<SphereMeetings>(boundary, {}, constant, mostBites, pulse).Run();
}

} // namespace biting
