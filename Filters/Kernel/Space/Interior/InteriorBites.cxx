// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "InteriorBites.h"

#include "SphereMeetings.h"

#include <algorithm> // for max, min
#include <cmath>     // for sqrt
#include <utility>   // for move, swap

namespace biting
{

namespace
{

/// Radius of a bite, in f: so the mean edge has the length f.
constexpr double BitingConstant = 0.9;

/// No later center is nearer to a bite's, in radii.
constexpr double Tolerance = 0.9;

class InteriorBiter
{
public:
  InteriorBiter(const BodyBoundary& boundary, std::size_t mostBites, Pulse& pulse)
    : Boundary(boundary)
    , MostBites(mostBites)
    , Beats(pulse)
    , Bounds(BoundsOf(boundary))
    , Tree(Bounds)
  {
  }

  InteriorBites Run()
  {
    this->AddBoundary();
    for (Id ball = 0; ball < this->NumberOfWalls && this->Beats.Beat(64); ++ball)
    {
      this->StartAt(ball);
    }
    while (!this->Later.empty() && this->MayGoOn())
    {
      std::swap(this->Queue, this->Later);
      this->Later.clear();
      for (const Candidate& candidate : this->Queue)
      {
        if (!this->MayGoOn())
        {
          break;
        }
        this->Try(candidate);
      }
    }
    return std::move(this->Bites);
  }

private:
  struct Candidate
  {
    Point3 Place;
    Id Size;       ///< of the tree when it was found: what guards it is later
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
    const auto ignore = [](Id) {};
    for (std::size_t k = 0; k < boundary.Centers.size() && this->Beats.Beat(4); ++k)
    {
      const double radius = BitingConstant * boundary.Sizes[k];
      const double guard =
        std::max({ guards[k], std::sqrt(boundary.Weights[k]), Tolerance * radius });
      this->Tree.Add({ boundary.Centers[k], std::max(radius, Room * guard), guard }, ignore);
    }
    for (const EmptyBall& ball : boundary.Balls)
    {
      if (ball.Radius > 0.0 && this->Beats.Beat(4))
      {
        this->Tree.Add({ ball.Center, Room * ball.Radius, ball.Radius }, ignore);
      }
    }
    this->NumberOfWalls = this->Tree.Size();
    this->Seen.assign(static_cast<std::size_t>(this->NumberOfWalls), NoId);
  }

  void StartAt(Id ball)
  {
    const GuardedBall own = this->Tree.At(ball);
    this->Meetings.Start(own);
    this->Tree.VisitNear(own, [this, ball](Id other) { this->Note(other, ball); });
    this->Meetings.Find([ball](Id other) { return other < ball; },
      [this](const Point3& place, Id, Id) {
        this->Later.push_back({ place, this->NumberOfWalls, true });
      });
  }

  void Note(Id other, Id of)
  {
    Id& seen = this->Seen[static_cast<std::size_t>(other)];
    if (seen != of && other != of)
    {
      seen = of;
      this->Meetings.Add(this->Tree.At(other), other);
    }
  }

  void Try(const Candidate& candidate)
  {
    if (this->Tree.IsGuarded(candidate.Place, candidate.Size) ||
      !this->Bounds.Contains(candidate.Place) ||
      (candidate.IsAtWall && !this->Boundary.IsInside(candidate.Place)))
    {
      return;
    }
    this->Beats.Beat(64);
    const double size = this->Boundary.Spacing(candidate.Place);
    const double radius = BitingConstant * size;
    this->Bites.Centers.push_back(candidate.Place);
    this->Bites.Sizes.push_back(size);
    this->Bites.Radii.push_back(radius);
    const GuardedBall own{ candidate.Place, radius, Tolerance * radius };
    this->Meetings.Start(own);
    const Id id = this->Tree.Size();
    this->Seen.push_back(NoId);
    this->Tree.Add(own, [this, id](Id other) { this->Note(other, id); });
    this->Meetings.Find([](Id) { return true; },
      [this](const Point3& place, Id a, Id b) {
        this->Later.push_back({ place, this->Tree.Size(), std::min(a, b) < this->NumberOfWalls });
      });
  }

  const BodyBoundary& Boundary;
  const std::size_t MostBites;
  Pulse& Beats;
  Box3 Bounds;
  BallTree Tree;        ///< bites of the boundary, empty balls, bites
  Id NumberOfWalls = 0; ///< in the tree, of the boundary
  std::vector<Id> Seen; ///< of balls: the last one whose neighbors were looked for
  SphereMeetings Meetings;
  std::vector<Candidate> Queue; ///< found together
  std::vector<Candidate> Later; ///< found by the bites of Queue
  InteriorBites Bites;
};

} // namespace

InteriorBites BiteInterior(
  const BodyBoundary& boundary, SpaceBiteShape /*shape*/, std::size_t mostBites, Pulse& pulse)
{
  return boundary.Centers.empty() ? InteriorBites()
                                  : InteriorBiter(boundary, mostBites, pulse).Run();
}

} // namespace biting
