// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceBites.h"

#include "ChainDivision.h"

#include <algorithm> // for find, max, min, none_of
#include <array>     // for corners
#include <cmath>     // for sqrt
#include <deque>     // for queues
#include <utility>   // for move

namespace biting
{

namespace
{

/// No later centre is nearer to one on the surface, in radii.
constexpr double Tolerance = 0.9;

/// A point is taken for one of a triangle up to so far beyond its sides, in its heights: a
/// candidate on a side must not be lost by rounding, and is the same in both triangles.
constexpr double Beside = 1e-9;

/// A triangle of the ground in its plane.
struct GroundPlane
{
  explicit GroundPlane(const std::array<Point3, 3>& triangle)
    : Corners(triangle)
    , Normal(Cross(triangle[1] - triangle[0], triangle[2] - triangle[0]))
    , Twice(Length(Normal))
  {
    this->Normal = (1.0 / this->Twice) * this->Normal;
    for (std::size_t k = 0; k < 3; ++k)
    {
      this->Inwards[k] = Cross(this->Normal, triangle[(k + 1) % 3] - triangle[k]);
    }
  }

  bool Has(const Point3& p) const
  {
    bool isIn = true;
    for (std::size_t k = 0; k < 3 && isIn; ++k)
    {
      isIn = Dot(p - this->Corners[k], this->Inwards[k]) >= -Beside * this->Twice;
    }
    return isIn;
  }

  std::array<Point3, 3> Corners;
  Point3 Normal;
  double Twice;                  ///< the area
  std::array<Point3, 3> Inwards; ///< across the sides, as long as they are
};

/// A ball's disk in the plane of a triangle.
struct PlaneDisk
{
  Point3 Center;
  double Radius2;
};

class SurfaceBiter
{
public:
  SurfaceBiter(const SurfaceGround& ground, std::size_t mostBites, Pulse& pulse)
    : Ground(ground)
    , MostBites(mostBites)
    , Beats(pulse)
    , Heads(ground.Mesh.NumberOfTriangles(), NoId)
    , IsGuard(ground.Mesh.NumberOfTriangles(), false)
    , Seen(ground.Mesh.NumberOfTriangles(), NoId)
  {
  }

  SurfaceBites Run()
  {
    DivideChains(this->Ground, this->Bites, this->Beats);
    for (Id bite = 0; bite < this->Bites.NumberOnLines && this->Beats.Beat(); ++bite)
    {
      this->StartAtFeature(bite);
      this->Take(bite);
    }
    this->EmptyQueue();
    for (std::size_t t = 0; t < this->Heads.size() && !this->Beats.HasStopped(); ++t)
    {
      // Of a patch that no bite has reached.
      if (this->Heads[t] == NoId)
      {
        this->AddBite(this->Ground.Mesh.Middle(t), static_cast<Id>(t));
        this->EmptyQueue();
      }
    }
    this->Bites.Guards.clear();
    this->Entries.clear();
    return this->Bites; // a copy, without the room of growing arrays
  }

private:
  struct Entry
  {
    Id Bite; ///< ~Bite where its ball has all of the triangle: its sphere meets none there
    Id Next;

    Id Number() const { return this->Bite < 0 ? ~this->Bite : this->Bite; }
  };

  struct Candidate
  {
    Point3 Place;
    Id Triangle;
  };

  void EmptyQueue()
  {
    while (
      !this->Queue.empty() && this->Beats.Beat(16) && this->Bites.Centers.size() <= this->MostBites)
    {
      const Candidate candidate = this->Queue.front();
      this->Queue.pop_front();
      if (!this->IsTaken(candidate.Triangle, candidate.Place))
      {
        this->AddBite(candidate.Place, candidate.Triangle);
      }
    }
    this->Queue.clear();
  }

  /// Whether the guard of a bite that reaches the triangle has the place.
  bool IsTaken(Id triangle, const Point3& place) const
  {
    Id entry = this->Heads[At(triangle)];
    while (entry != NoId && !this->IsGuarded(this->Entries[At(entry)].Number(), place))
    {
      entry = this->Entries[At(entry)].Next;
    }
    return entry != NoId;
  }

  bool IsGuarded(Id bite, const Point3& place) const
  {
    const Point3 apart = place - this->Bites.Centers[At(bite)];
    return Dot(apart, apart) < this->Bites.Guards[At(bite)] * this->Bites.Guards[At(bite)];
  }

  void AddBite(const Point3& place, Id triangle)
  {
    const double size = this->Ground.SizeAt(triangle, place);
    this->Bites.Centers.push_back(place);
    this->Bites.Sizes.push_back(size);
    this->Bites.Radii.push_back(SurfaceBitingConstant * size);
    this->Bites.Guards.push_back(Tolerance * SurfaceBitingConstant * size);
    this->Bites.Triangles.push_back(triangle);
    this->Bites.GroundVertices.push_back(NoId);
    this->Front.clear();
    this->GoTo(this->Bites.Size() - 1, triangle);
    this->Take(this->Bites.Size() - 1);
  }

  /// All triangles at the vertex, or at the edge that the vertex lies on, begin the walk.
  void StartAtFeature(Id bite)
  {
    const Id vertex = this->Bites.GroundVertices[At(bite)];
    this->Front.clear();
    if (vertex != NoId)
    {
      for (const Id t : this->Ground.TrianglesAt[vertex])
      {
        this->GoTo(bite, t);
      }
      return;
    }
    const Point3& center = this->Bites.Centers[At(bite)];
    const Id* corners = &this->Ground.Mesh.Corners[3 * At(this->Bites.Triangles[At(bite)])];
    const double near = 1e-9 * this->Bites.Radii[At(bite)];
    for (std::size_t k = 0; k < 3; ++k)
    {
      for (const Id t : this->Ground.TrianglesAt[corners[k]])
      {
        bool isAt = false;
        for (std::size_t slot = 3 * At(t); slot < 3 * At(t) + 3; ++slot)
        {
          isAt = isAt || this->Distance2(slot, center) <= near * near;
        }
        if (isAt)
        {
          this->GoTo(bite, t);
        }
      }
    }
  }

  /// Of the place from the edge of the slot, squared.
  double Distance2(std::size_t slot, const Point3& place) const
  {
    const Point3& tail = this->Ground.Mesh.At(NextSlotOf(slot));
    const Point3 side = this->Ground.Mesh.At(PreviousSlotOf(slot)) - tail;
    const Point3 away = place - tail;
    const double part = std::min(1.0, std::max(0.0, Dot(away, side) / Dot(side, side)));
    const Point3 apart = away - part * side;
    return Dot(apart, apart);
  }

  /// Walks from Front over what the bite takes; the candidates on its sphere go into the queue.
  void Take(Id bite)
  {
    const Point3 center = this->Bites.Centers[At(bite)];
    const double radius2 = this->Bites.Radii[At(bite)] * this->Bites.Radii[At(bite)];
    const double guard2 = this->Bites.Guards[At(bite)] * this->Bites.Guards[At(bite)];
    this->NumberOfMeetings = 0;
    std::size_t next = 0;
    while (next < this->Front.size()) // GoAcross adds some
    {
      const Id triangle = this->Front[next++];
      std::array<double, 3> away{}; // of the corners, squared
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Point3 apart = this->Ground.Mesh.At(3 * At(triangle) + k) - center;
        away[k] = Dot(apart, apart);
      }
      // By more than candidates may be beside the triangle.
      constexpr double Most = 1.0 - 1e-6;
      const double farthest = std::max(away[0], std::max(away[1], away[2]));
      const bool isWithin = farthest < Most * radius2;
      if (!isWithin && !this->IsGuard[At(triangle)])
      {
        this->Meet(bite, triangle);
      }
      this->IsGuard[At(triangle)] = this->IsGuard[At(triangle)] || farthest < Most * guard2;
      this->Entries.push_back({ isWithin ? ~bite : bite, this->Heads[At(triangle)] });
      this->Heads[At(triangle)] = static_cast<Id>(this->Entries.size()) - 1;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t slot = 3 * At(triangle) + k;
        const Id across = this->Ground.Across[slot];
        const bool isSeen = across != NoId && this->Seen[At(across / 3)] == bite;
        if (!isSeen &&
          (std::min(away[(k + 1) % 3], away[(k + 2) % 3]) <= radius2 ||
            this->Distance2(slot, center) <= radius2))
        {
          this->GoAcross(bite, slot);
        }
      }
    }
    // Candidates in guards are not free: they only count where there are no others.
    for (std::size_t k = 0; this->NumberOfMeetings == 0 && k < this->Front.size(); ++k)
    {
      this->Meet(bite, this->Front[k]);
    }
    Candidate way{ {}, NoId };
    for (std::size_t k = 0; this->NumberOfMeetings == 0 && k < this->Front.size(); ++k)
    {
      this->FindWay(bite, this->Front[k], way);
    }
    if (way.Triangle != NoId && !this->IsTaken(way.Triangle, way.Place))
    {
      this->Queue.push_back(way);
    }
  }

  void GoAcross(Id bite, std::size_t slot)
  {
    const Id across = this->Ground.Across[slot];
    if (across != NoId)
    {
      this->GoTo(bite, across / 3);
    }
    else if (bite < this->Bites.NumberOnLines)
    {
      // No centre may be in the ball of a feature: it goes on beyond other features.
      const Id tail = this->Ground.Mesh.Corners[NextSlotOf(slot)];
      const Id head = this->Ground.Mesh.Corners[PreviousSlotOf(slot)];
      for (const Id t : this->Ground.TrianglesAt[tail])
      {
        const Id* corners = &this->Ground.Mesh.Corners[3 * At(t)];
        if (std::find(corners, corners + 3, head) != corners + 3)
        {
          this->GoTo(bite, t);
        }
      }
    }
  }

  void GoTo(Id bite, Id triangle)
  {
    if (this->Seen[At(triangle)] != bite)
    {
      this->Seen[At(triangle)] = bite;
      this->Front.push_back(triangle);
    }
  }

  /// The candidates in a triangle.
  void Meet(Id bite, Id triangle)
  {
    this->Near.clear();
    bool isAny = false;
    for (Id entry = this->Heads[At(triangle)]; entry != NoId; entry = this->Entries[At(entry)].Next)
    {
      const Entry& other = this->Entries[At(entry)];
      if (!this->AreApart(bite, other.Number()))
      {
        this->Near.push_back(other.Bite);
        isAny = isAny || other.Bite >= 0;
      }
    }
    if (!isAny)
    {
      return;
    }
    const GroundPlane plane(this->Ground.Mesh.Triangle(At(triangle)));
    PlaneDisk own{};
    if (!(plane.Twice > 0.0) || !this->DiskOf(bite, plane, own))
    {
      return;
    }
    for (const Id near : this->Near)
    {
      PlaneDisk other{};
      if (near >= 0 && this->DiskOf(near, plane, other))
      {
        this->MeetDisk(own, other, plane, triangle);
      }
    }
  }

  bool AreApart(Id a, Id b) const
  {
    constexpr double Beyond = 1.0 + 1e-9;
    const Point3 way = this->Bites.Centers[At(b)] - this->Bites.Centers[At(a)];
    const double reach = Beyond * (this->Bites.Radii[At(a)] + this->Bites.Radii[At(b)]);
    return Dot(way, way) > reach * reach;
  }

  bool DiskOf(Id bite, const GroundPlane& plane, PlaneDisk& disk) const
  {
    const Point3& center = this->Bites.Centers[At(bite)];
    const double radius = this->Bites.Radii[At(bite)];
    const double height = Dot(center - plane.Corners[0], plane.Normal);
    disk.Center = center - height * plane.Normal;
    disk.Radius2 = radius * radius - height * height;
    return disk.Radius2 > 0.0;
  }

  void MeetDisk(const PlaneDisk& a, const PlaneDisk& b, const GroundPlane& plane, Id triangle)
  {
    const Point3 way = b.Center - a.Center;
    const double way2 = Dot(way, way);
    const double part = 0.5 * (1.0 + (a.Radius2 - b.Radius2) / way2);
    const double rise2 = a.Radius2 / way2 - part * part;
    if (!(rise2 >= 0.0))
    {
      return;
    }
    const Point3 foot = a.Center + part * way;
    const Point3 across = std::sqrt(rise2) * Cross(plane.Normal, way);
    for (const Point3& place : { foot + across, foot - across })
    {
      if (plane.Has(place))
      {
        ++this->NumberOfMeetings;
        // Guards that the new sphere meets are of bites that are near.
        if (std::none_of(this->Near.begin(), this->Near.end(),
              [this, &place](Id near) { return this->IsGuarded(near < 0 ? ~near : near, place); }))
        {
          this->Queue.push_back({ place, triangle });
        }
      }
    }
  }

  /// A point of the sphere on a side of the triangle, for a bite that meets no other.
  void FindWay(Id bite, Id triangle, Candidate& way) const
  {
    const GroundPlane plane(this->Ground.Mesh.Triangle(At(triangle)));
    PlaneDisk disk{};
    if (!(plane.Twice > 0.0) || !this->DiskOf(bite, plane, disk))
    {
      return;
    }
    for (std::size_t k = 0; k < 3 && way.Triangle == NoId; ++k)
    {
      const Point3& tail = plane.Corners[k];
      const Point3 side = plane.Corners[(k + 1) % 3] - tail;
      const Point3 away = tail - disk.Center;
      const double half = Dot(away, side) / Dot(side, side);
      const double rest = half * half - (Dot(away, away) - disk.Radius2) / Dot(side, side);
      const double root = rest >= 0.0 ? std::sqrt(rest) : -1.0;
      for (const double part : { -half - root, -half + root })
      {
        if (rest >= 0.0 && part >= 0.0 && part <= 1.0)
        {
          way = { tail + part * side, triangle };
        }
      }
    }
  }

  const SurfaceGround& Ground;
  const std::size_t MostBites;
  Pulse& Beats;
  SurfaceBites Bites;
  std::vector<Id> Heads;     ///< of triangles: the first of the entries of bites that reach it
  std::vector<bool> IsGuard; ///< of triangles: the guard of a bite has all of them
  std::deque<Entry> Entries; ///< most of memory: it is not copied
  std::vector<Id> Seen;      ///< of triangles: the last bite whose walk came there
  std::vector<Id> Front;     ///< of the walk
  std::deque<Candidate> Queue;
  std::size_t NumberOfMeetings = 0;
  std::vector<Id> Near; ///< bites in a triangle that the new one may meet, as Entry::Bite
};

} // namespace

SurfaceBites BiteSurface(const SurfaceGround& ground, std::size_t mostBites, Pulse& pulse)
{
  return SurfaceBiter(ground, mostBites, pulse).Run();
}

} // namespace biting
