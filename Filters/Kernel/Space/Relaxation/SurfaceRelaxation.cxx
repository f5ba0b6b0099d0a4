// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceRelaxation.h"

#include "../Surface/NearestOnTriangle.h"
#include "SurfaceStars.h"

#include <algorithm> // for min, max
#include <array>     // for triangles
#include <cmath>     // for sqrt

namespace biting
{

namespace
{

/// Cosines: the larger, the smaller the angle.
constexpr double GoodCosine = 0.8191520442889918;     // 35 degrees
constexpr double BadCosine = 0.7880107536067220;      // 38 degrees
constexpr double LeastAgreement = 0.6427876096865394; // 50 degrees

/// A place on the ground.
struct GroundPlace
{
  Id Triangle;
  Point3 Place;
};

class SurfaceRelaxer
{
public:
  SurfaceRelaxer(
    const SurfaceGround& ground, const std::vector<Id>& pieces, RelaxedSurface& mesh, Pulse& pulse)
    : Ground(ground)
    , Mesh(mesh)
    , Stars(mesh.Corners, mesh.Points.size(), pieces)
    , Beats(pulse)
    , Ideal(mesh.Points.size(), 6)
    , Changes(mesh.Points.size(), 0)
    , Trials(mesh.Corners.size(), NoId)
    , Patches(ground.Mesh.NumberOfTriangles(), NoId)
  {
    this->FindPatches();
    this->FindIdeals();
  }

  void Run()
  {
    constexpr int Rounds = 5;
    for (int round = 0; round < Rounds && this->Beats.Ask(); ++round)
    {
      this->FlipAll(round < Rounds - 1);
      for (Id vertex = 0; vertex < static_cast<Id>(this->Mesh.Points.size()); ++vertex)
      {
        if (this->Mesh.IsFree[At(vertex)] != 0 && this->Beats.Beat(64))
        {
          this->Smooth(vertex);
        }
      }
    }
    constexpr int MostTrials = 12;
    for (int round = 0; round < MostTrials && this->Beats.Ask(); ++round)
    {
      if (round % 3 == 0)
      {
        this->FlipAll(false);
      }
      if (!this->MoveWorst(round))
      {
        break;
      }
    }
  }

private:
  /// Of the ground, bounded by features.
  void FindPatches()
  {
    std::vector<Id> front;
    for (std::size_t t = 0; t < this->Patches.size(); ++t)
    {
      if (this->Patches[t] != NoId)
      {
        continue;
      }
      this->Patches[t] = static_cast<Id>(t);
      front.assign(1, static_cast<Id>(t));
      while (!front.empty())
      {
        const std::size_t base = 3 * At(front.back());
        front.pop_back();
        for (std::size_t slot = base; slot < base + 3; ++slot)
        {
          const Id across = this->Ground.Across[slot];
          if (across != NoId && this->Patches[At(across / 3)] == NoId)
          {
            this->Patches[At(across / 3)] = static_cast<Id>(t);
            front.push_back(across / 3);
          }
        }
      }
    }
  }

  /// Numbers of triangles: 6 at free vertices; at others the angle that they have in all, by 60
  /// degrees, which flips do not change much.
  void FindIdeals()
  {
    std::vector<double> angles(this->Mesh.Points.size(), 0.0);
    for (std::size_t slot = 0; slot < this->Mesh.Corners.size(); ++slot)
    {
      const Point3& place = this->PointOf(slot);
      const Point3 a = this->PointOf(NextSlotOf(slot)) - place;
      const Point3 b = this->PointOf(PreviousSlotOf(slot)) - place;
      angles[At(this->Mesh.Corners[slot])] += std::atan2(Length(Cross(a, b)), Dot(a, b));
    }
    for (std::size_t v = 0; v < angles.size(); ++v)
    {
      constexpr double Sixty = 1.0471975511965976;
      this->Ideal[v] = this->Mesh.IsFree[v] != 0
        ? 6
        : std::max(static_cast<Id>(std::lround(angles[v] / Sixty)), Id{ 1 });
    }
  }

  const Point3& PointOf(std::size_t slot) const
  {
    return this->Mesh.Points[At(this->Mesh.Corners[slot])];
  }

  using Triangle = std::array<Point3, 3>;

  Triangle TriangleAt(std::size_t slot) const
  {
    return { this->PointOf(slot), this->PointOf(NextSlotOf(slot)),
      this->PointOf(PreviousSlotOf(slot)) };
  }

  /// The cosine of the smallest angle, which is opposite the shortest side.
  static double WorstCosine(const Triangle& t)
  {
    std::array<double, 3> sides{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Point3 side = t[(k + 2) % 3] - t[(k + 1) % 3];
      sides[k] = Dot(side, side);
    }
    const double least = std::min(sides[0], std::min(sides[1], sides[2]));
    const double most = std::max(sides[0], std::max(sides[1], sides[2]));
    const double middle = sides[0] + sides[1] + sides[2] - least - most;
    return middle > 0.0 ? 0.5 * (middle + most - least) / std::sqrt(middle * most) : 1.0;
  }

  static Point3 UnitNormal(const Triangle& t)
  {
    const Point3 normal = Cross(t[1] - t[0], t[2] - t[0]);
    const double length = Length(normal);
    return length > 0.0 ? (1.0 / length) * normal : Point3{};
  }

  /// Whether a new triangle agrees with the ground under its free corners, and with the normal of
  /// an old one there.
  bool Agrees(const Triangle& triangle, const std::array<Id, 3>& vertices, const Point3& old) const
  {
    const Point3 normal = UnitNormal(triangle);
    bool agrees = Dot(normal, old) > LeastAgreement;
    for (const Id vertex : vertices)
    {
      agrees = agrees &&
        (this->Mesh.IsFree[At(vertex)] == 0 ||
          Dot(normal, this->Ground.NormalOf(At(this->Mesh.Triangles[At(vertex)]))) >
            LeastAgreement);
    }
    return agrees;
  }

  void FlipAll(bool byDegrees)
  {
    constexpr int MostSweeps = 2;
    bool isChanged = true;
    if (byDegrees != this->AreByDegrees)
    {
      this->Trials.assign(this->Trials.size(), NoId);
      this->AreByDegrees = byDegrees;
    }
    for (int sweep = 0; sweep < MostSweeps && isChanged; ++sweep)
    {
      isChanged = false;
      for (std::size_t slot = 0; slot < this->Mesh.Corners.size(); ++slot)
      {
        const Id across = this->Stars.Across(slot);
        if (across > static_cast<Id>(slot) && this->Beats.Beat(4) && !this->WasTried(slot))
        {
          this->Trials[slot] = this->Now;
          isChanged = this->TryFlip(slot, byDegrees) || isChanged;
        }
      }
    }
  }

  /// Whether nothing at the four vertices has changed since the flip was tried.
  bool WasTried(std::size_t slot) const
  {
    const auto changed = [this](std::size_t s) { return this->Changes[At(this->Mesh.Corners[s])]; };
    return std::max(std::max(changed(slot), changed(At(this->Stars.Across(slot)))),
             std::max(changed(NextSlotOf(slot)), changed(PreviousSlotOf(slot)))) <=
      this->Trials[slot];
  }

  /// How much better the numbers of triangles at the four vertices are after a flip.
  Id GainOfDegrees(Id a, Id b, Id c, Id d) const
  {
    const auto off = [this](Id vertex, Id change)
    {
      const Id excess = this->Stars.Degree(vertex) + change - this->Ideal[At(vertex)];
      return excess * excess;
    };
    return off(a, 0) + off(b, 0) + off(c, 0) + off(d, 0) - off(a, 1) - off(b, -1) - off(c, -1) -
      off(d, 1);
  }

  bool TryFlip(std::size_t slot, bool byDegrees)
  {
    const auto other = At(this->Stars.Across(slot));
    const Id a = this->Mesh.Corners[slot];
    const Id b = this->Mesh.Corners[NextSlotOf(slot)];
    const Id c = this->Mesh.Corners[PreviousSlotOf(slot)];
    const Id d = this->Mesh.Corners[other];
    const Triangle first = this->TriangleAt(slot);
    const Triangle second = this->TriangleAt(other);
    const Triangle newFirst{ first[0], first[1], second[0] };
    const Triangle newSecond{ second[0], first[2], first[0] };
    const double before = std::max(WorstCosine(first), WorstCosine(second));
    const double after = std::max(WorstCosine(newFirst), WorstCosine(newSecond));
    const Id gain = byDegrees ? this->GainOfDegrees(a, b, c, d) : 0;
    constexpr double Better = 1e-6;
    constexpr double LeastForDegrees = 0.9063077870366499; // 25 degrees
    const bool isWanted =
      gain > 0 ? after <= std::max(before, LeastForDegrees) : gain == 0 && after < before - Better;
    const bool isPoor = before > GoodCosine && after < before - Better;
    if ((!isWanted && !isPoor) || (gain > 0 && after > before && after > GoodCosine) ||
      this->Stars.Degree(b) <= 3 || this->Stars.Degree(c) <= 3)
    {
      return false;
    }
    const Point3 old = UnitNormal(first) + UnitNormal(second);
    const Point3 mean = (1.0 / std::max(Length(old), 1e-300)) * old;
    if (this->IsEdge(slot, a, d) || !this->Agrees(newFirst, { a, b, d }, mean) ||
      !this->Agrees(newSecond, { d, c, a }, mean))
    {
      return false;
    }
    this->Stars.Flip(slot);
    ++this->Now;
    for (const Id vertex : { a, b, c, d })
    {
      this->Changes[At(vertex)] = this->Now;
    }
    return true;
  }

  /// Whether a and d, the apexes at an edge, have an edge already. At vertices of features that is
  /// not known, and taken for so if both are such.
  bool IsEdge(std::size_t slot, Id a, Id d) const
  {
    const bool isAFree = this->Mesh.IsFree[At(a)] != 0;
    if (!isAFree && this->Mesh.IsFree[At(d)] == 0)
    {
      return true;
    }
    const Id vertex = isAFree ? a : d;
    const Id other = isAFree ? d : a;
    bool isEdge = slot == this->Mesh.Corners.size();
    this->Stars.ForStar(vertex,
      [this, other, &isEdge](std::size_t s)
      { isEdge = isEdge || this->Mesh.Corners[NextSlotOf(s)] == other; });
    return isEdge;
  }

  /// The nearest place of the patch, by going downhill from a triangle.
  GroundPlace Project(Id triangle, const Point3& place) const
  {
    GroundPlace best{ triangle, NearestPoint(this->Ground.Mesh.Triangle(At(triangle)), place) };
    double least = Distance(best.Place, place);
    const Id patch = this->Patches[At(triangle)];
    constexpr int MostSteps = 64;
    bool isNearer = true;
    for (int step = 0; step < MostSteps && isNearer && least > 0.0; ++step)
    {
      isNearer = false;
      const std::size_t base = 3 * At(best.Triangle);
      for (std::size_t slot = base; slot < base + 3; ++slot)
      {
        const Id vertex = this->Ground.Mesh.Corners[slot];
        for (const Id* t = this->Ground.TrianglesAt.Begin(vertex);
             t < this->Ground.TrianglesAt.End(vertex); ++t)
        {
          if (this->Patches[At(*t)] != patch)
          {
            continue;
          }
          const Point3 foot = NearestPoint(this->Ground.Mesh.Triangle(At(*t)), place);
          const double distance = Distance(foot, place);
          if (distance < (1.0 - 1e-12) * least)
          {
            least = distance;
            best = { *t, foot };
            isNearer = true;
          }
        }
      }
    }
    return best;
  }

  void Smooth(Id vertex)
  {
    Point3 sum{};
    double mass = 0.0;
    this->Stars.ForStar(vertex,
      [this, &sum, &mass](std::size_t slot)
      {
        const Triangle t = this->TriangleAt(slot);
        const double size = (this->SizeOf(slot) + this->SizeOf(NextSlotOf(slot)) +
                              this->SizeOf(PreviousSlotOf(slot))) /
          3.0;
        const double own = Length(Cross(t[1] - t[0], t[2] - t[0])) / (size * size * size * size);
        sum = sum + (own / 3.0) * (t[0] + t[1] + t[2]);
        mass += own;
      });
    if (mass > 0.0)
    {
      this->TryMove(vertex, (1.0 / mass) * sum, GoodCosine);
    }
  }

  double SizeOf(std::size_t slot) const { return this->Mesh.Sizes[At(this->Mesh.Corners[slot])]; }

  /// Moves the vertex to the place on the ground if no triangle of its star is worse then than the
  /// worst one was, or than `good`.
  bool TryMove(Id vertex, const Point3& wanted, double good)
  {
    const GroundPlace place = this->Project(this->Mesh.Triangles[At(vertex)], wanted);
    double before = 0.0;
    double after = 0.0;
    bool agrees = true;
    const GroundPlace old{ this->Mesh.Triangles[At(vertex)], this->Mesh.Points[At(vertex)] };
    this->Mesh.Triangles[At(vertex)] = place.Triangle;
    this->Stars.ForStar(vertex,
      [this, &place, &before, &after, &agrees](std::size_t slot)
      {
        Triangle t = this->TriangleAt(slot);
        before = std::max(before, WorstCosine(t));
        const Point3 normal = UnitNormal(t);
        t[0] = place.Place;
        after = std::max(after, WorstCosine(t));
        agrees = agrees &&
          this->Agrees(t,
            { this->Mesh.Corners[slot], this->Mesh.Corners[NextSlotOf(slot)],
              this->Mesh.Corners[PreviousSlotOf(slot)] },
            normal);
      });
    constexpr double Better = 1e-9;
    if (agrees && after < std::max(before - Better, good))
    {
      this->Changes[At(vertex)] = ++this->Now;
      this->Mesh.Points[At(vertex)] = place.Place;
      this->Mesh.Sizes[At(vertex)] = this->Ground.SizeAt(place.Triangle, place.Place);
      return true;
    }
    this->Mesh.Triangles[At(vertex)] = old.Triangle;
    return false;
  }

  /// Tries to move the free vertices of poor triangles in twelve directions. False where none is
  /// better for it.
  bool MoveWorst(int round)
  {
    constexpr int Directions = 12;
    bool isChanged = false;
    for (std::size_t t = 0; t < this->Mesh.Corners.size() / 3; ++t)
    {
      if (WorstCosine(this->TriangleAt(3 * t)) < BadCosine || !this->Beats.Beat(8))
      {
        continue;
      }
      for (std::size_t slot = 3 * t; slot < 3 * t + 3; ++slot)
      {
        const Id vertex = this->Mesh.Corners[slot];
        if (this->Mesh.IsFree[At(vertex)] == 0)
        {
          continue;
        }
        const Point3& normal = this->Ground.NormalOf(At(this->Mesh.Triangles[At(vertex)]));
        const Point3 side = this->PointOf(NextSlotOf(slot)) - this->PointOf(slot);
        const Point3 across = Cross(normal, side);
        const double length = Length(across);
        const double step =
          (round % 3 == 0 ? 0.1 : (round % 3 == 1 ? 0.03 : 0.01)) * this->Mesh.Sizes[At(vertex)];
        const Point3 v = (step / std::max(length, 1e-300)) * across;
        const Point3 u = Cross(v, normal);
        for (int k = 0; k < Directions; ++k)
        {
          const double angle = k * 0.5235987755982988;
          const Point3 place =
            this->Mesh.Points[At(vertex)] + std::cos(angle) * u + std::sin(angle) * v;
          isChanged = this->TryMove(vertex, place, 0.0) || isChanged;
        }
      }
    }
    return isChanged || round < 3;
  }

  const SurfaceGround& Ground;
  RelaxedSurface& Mesh;
  SurfaceStars Stars;
  Pulse& Beats;
  std::vector<Id> Ideal;   ///< numbers of triangles
  std::vector<Id> Changes; ///< of vertices: the number of their last change
  std::vector<Id> Trials;  ///< of slots: the number of changes before the last trial of a flip
  std::vector<Id> Patches; ///< of triangles of the ground
  Id Now = 0;              ///< the number of changes
  bool AreByDegrees = false;
};

} // namespace

void RelaxSurface(
  const SurfaceGround& ground, const std::vector<Id>& pieces, RelaxedSurface& mesh, Pulse& pulse)
{
  SurfaceRelaxer(ground, pieces, mesh, pulse).Run();
}

} // namespace biting
