// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceRelaxation.h"

#include "../../Base/Numbers.h"
#include "../Features/GroundPatches.h"
#include "ChainPlaces.h"
#include "SurfaceStars.h"

#include <algorithm> // for all_of, any_of, min, max
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

// In f, of middles of triangles from the ground.
constexpr double MostDeviation = 0.08;
constexpr double Nearer = 1e-3; ///< by as much at least, steps approach the ground

using Triangle = std::array<Point3, 3>;

/// Of the smallest angle, which is opposite the shortest side: twice the product of the sides at it
/// and its cosine, and the square of that of the sides.
inline std::array<double, 2> WorstAngle(const Triangle& t)
{
  const double a = Dot(t[2] - t[1], t[2] - t[1]);
  const double b = Dot(t[0] - t[2], t[0] - t[2]);
  const double c = Dot(t[1] - t[0], t[1] - t[0]);
  const double least = std::min(a, std::min(b, c));
  const double most = std::max(a, std::max(b, c));
  const double middle = a + b + c - least - most;
  return { middle + most - least, middle * most };
}

double WorstCosine(const Triangle& t)
{
  const auto [twice, square] = WorstAngle(t);
  return square > 0.0 ? 0.5 * twice / std::sqrt(square) : 1.0;
}

/// Whether WorstCosine is below `cosine`.
inline bool IsBetter(const Triangle& t, double cosine)
{
  const auto [twice, square] = WorstAngle(t);
  return twice * twice < 4.0 * cosine * cosine * square;
}

inline Point3 NormalOf(const Triangle& t)
{
  return Cross(t[1] - t[0], t[2] - t[0]);
}

/// The other diagonal of two triangles (a, b, c) and (d, c, b): (a, b, d) and (d, c, a).
struct SurfaceFlip
{
  std::array<Id, 4> Vertices; ///< a, b, c, d
  Triangle First;
  Triangle Second;
  Triangle NewFirst;
  Triangle NewSecond;

  double Before() const { return std::max(WorstCosine(this->First), WorstCosine(this->Second)); }
  double After() const
  {
    return std::max(WorstCosine(this->NewFirst), WorstCosine(this->NewSecond));
  }
};

/// A mesh that is relaxed, and the steps that keep the laws of RelaxSurface.
class SurfaceSteps
{
protected:
  SurfaceSteps(
    const SurfaceGround& ground, const std::vector<Id>& pieces, RelaxedSurface& mesh, Pulse& pulse)
    : Ground(ground)
    , Mesh(mesh)
    , Stars(mesh.Corners, mesh.Points.size(), pieces, pulse)
    , Changes(mesh.Points.size(), 0)
    , Patches(ground)
    , Places(ground, mesh.Chains, mesh.Points)
    , SlotsAt(PlacesByOwner(mesh.Corners, mesh.Points.size()))
  {
  }

  Triangle TriangleAt(std::size_t slot) const
  {
    const auto point = [this](std::size_t s)
    { return this->Mesh.Points[At(this->Mesh.Corners[s])]; };
    return { point(slot), point(NextSlotOf(slot)), point(PreviousSlotOf(slot)) };
  }

  /// Of the triangles at the edge of the slot (SurfaceFlip).
  std::array<Id, 4> VerticesAt(std::size_t slot) const
  {
    return { this->Mesh.Corners[slot], this->Mesh.Corners[NextSlotOf(slot)],
      this->Mesh.Corners[PreviousSlotOf(slot)], this->Mesh.Corners[At(this->Stars.Across(slot))] };
  }

  SurfaceFlip FlipAt(std::size_t slot) const
  {
    SurfaceFlip flip{ this->VerticesAt(slot), this->TriangleAt(slot),
      this->TriangleAt(At(this->Stars.Across(slot))), {}, {} };
    flip.NewFirst = { flip.First[0], flip.First[1], flip.Second[0] };
    flip.NewSecond = { flip.Second[0], flip.First[2], flip.First[0] };
    return flip;
  }

  bool MayFlip(std::size_t slot, const SurfaceFlip& flip) const
  {
    const auto [a, b, c, d] = flip.Vertices;
    const Point3 mean = NormalOf(flip.First) + NormalOf(flip.Second);
    return this->Stars.Degree(b) > 3 && this->Stars.Degree(c) > 3 && !this->IsEdge(slot, a, d) &&
      this->Agrees(flip.NewFirst, { a, b, d }, mean) &&
      this->Agrees(flip.NewSecond, { d, c, a }, mean);
  }

  void Do(std::size_t slot, const SurfaceFlip& flip)
  {
    this->Stars.Flip(slot);
    ++this->Now;
    for (const Id vertex : flip.Vertices)
    {
      this->Changes[At(vertex)] = this->Now;
    }
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

  /// Whether a new triangle agrees with the ground under its free corners, and with the normal of
  /// an old one there, of any length.
  bool Agrees(const Triangle& triangle, const std::array<Id, 3>& vertices, const Point3& old) const
  {
    const Point3 normal = NormalOf(triangle);
    const double least = LeastAgreement * Length(normal);
    bool agrees = Dot(normal, old) > least * Length(old);
    for (const Id vertex : vertices)
    {
      agrees = agrees &&
        (this->Mesh.IsFree[At(vertex)] == 0 ||
          Dot(normal, this->Ground.NormalOf(At(this->Mesh.Triangles[At(vertex)]))) > least);
    }
    return agrees;
  }

  /// After flips.
  void ListSlots() { this->SlotsAt = PlacesByOwner(this->Mesh.Corners, this->Mesh.Points.size()); }

  /// Lists the triangles at the vertex, which is their first corner.
  void Gather(Id vertex)
  {
    this->Old.clear();
    for (const Id s : this->SlotsAt[vertex])
    {
      this->Old.push_back(this->TriangleAt(At(s)));
    }
  }

  /// Moves the vertex, of which Gather was called, to the place on the ground, or on its chain, if
  /// no triangle is worse then than the worst one was, or than `good`, and none as far from the
  /// ground as `far`.
  bool TryMove(Id vertex, const Point3& wanted, double good, double far = Infinity)
  {
    const bool isFree = this->Mesh.IsFree[At(vertex)] != 0;
    const Point3 oldPlace = this->Mesh.Points[At(vertex)];
    const Id oldTriangle = this->Mesh.Triangles[At(vertex)];
    ChainPlace place{};
    if (isFree)
    {
      const GroundPlace onPatch = this->Patches.Project(oldTriangle, wanted);
      this->Mesh.Triangles[At(vertex)] = onPatch.Triangle;
      place.Place = onPatch.Place;
    }
    else
    {
      place = this->Places.Project(vertex, wanted);
    }
    this->New = this->Old;
    for (Triangle& t : this->New)
    {
      t[0] = place.Place;
    }
    constexpr double Better = 1e-9;
    bool isBetter = std::all_of(
      this->New.begin(), this->New.end(), [good](const Triangle& t) { return IsBetter(t, good); });
    double before = 0.0;
    double after = 0.0;
    for (std::size_t k = 0; k < this->New.size() && !isBetter; ++k)
    {
      before = std::max(before, WorstCosine(this->Old[k]));
      after = std::max(after, WorstCosine(this->New[k]));
    }
    isBetter = isBetter || after < before - Better;
    for (std::size_t k = 0; k < this->New.size() && isBetter; ++k)
    {
      const std::size_t slot = At(this->SlotsAt[vertex][static_cast<Id>(k)]);
      isBetter = this->Agrees(this->New[k],
        { vertex, this->Mesh.Corners[NextSlotOf(slot)], this->Mesh.Corners[PreviousSlotOf(slot)] },
        NormalOf(this->Old[k]));
    }
    this->Mesh.Points[At(vertex)] = place.Place;
    if (isBetter && (far == Infinity || this->DeviationAt(vertex, far) < far))
    {
      this->Changes[At(vertex)] = ++this->Now;
      if (isFree)
      {
        this->Mesh.Sizes[At(vertex)] =
          this->Ground.SizeAt(this->Mesh.Triangles[At(vertex)], place.Place);
      }
      else
      {
        this->Places.Move(vertex, place.Edge);
      }
      return true;
    }
    this->Mesh.Points[At(vertex)] = oldPlace;
    this->Mesh.Triangles[At(vertex)] = oldTriangle;
    return false;
  }

  /// Tries to move the corners of the triangle by the step, in f: free ones in twelve directions.
  bool MoveCorners(std::size_t t, double step, bool toApproach)
  {
    bool isChanged = false;
    for (std::size_t slot = 3 * t; slot < 3 * t + 3; ++slot)
    {
      const Id vertex = this->Mesh.Corners[slot];
      const bool isFree = this->Mesh.IsFree[At(vertex)] != 0;
      if (!isFree && !this->Places.IsOn(vertex))
      {
        continue;
      }
      const double length = step * this->Mesh.Sizes[At(vertex)];
      const Point3 u = length * (isFree ? this->TangentAt(slot) : this->Places.DirectionAt(vertex));
      const Point3 v =
        isFree ? Cross(this->Ground.NormalOf(At(this->Mesh.Triangles[At(vertex)])), u) : Point3{};
      const int directions = isFree ? 12 : 2;
      double far = toApproach ? this->DeviationAt(vertex) - Nearer : Infinity;
      for (int k = 0; k < directions; ++k)
      {
        const double angle = k * 6.283185307179586 / directions;
        const Point3 place =
          this->Mesh.Points[At(vertex)] + std::cos(angle) * u + std::sin(angle) * v;
        this->Gather(vertex);
        if (this->TryMove(vertex, place, toApproach ? BadCosine : 0.0, far))
        {
          isChanged = true;
          far = toApproach ? this->DeviationAt(vertex) - Nearer : far;
        }
      }
    }
    return isChanged;
  }

  /// At a free vertex: of length 1, across the side that follows.
  Point3 TangentAt(std::size_t slot) const
  {
    const Point3& normal =
      this->Ground.NormalOf(At(this->Mesh.Triangles[At(this->Mesh.Corners[slot])]));
    const Triangle t = this->TriangleAt(slot);
    const Point3 across = Cross(normal, t[1] - t[0]);
    return (1.0 / std::max(Length(across), 1e-300)) * across;
  }

  /// Distance of the middle of a triangle from the patch of a free corner, in f. 0 without one.
  double DeviationOf(const Triangle& triangle, const std::array<Id, 3>& vertices) const
  {
    double size = 0.0;
    Id start = NoId;
    for (const Id vertex : vertices)
    {
      size += this->Mesh.Sizes[At(vertex)] / 3.0;
      start = this->Mesh.IsFree[At(vertex)] != 0 ? this->Mesh.Triangles[At(vertex)] : start;
    }
    const Point3 middle = (1.0 / 3.0) * (triangle[0] + triangle[1] + triangle[2]);
    return start == NoId ? 0.0
                         : Distance(this->Patches.Project(start, middle).Place, middle) / size;
  }

  double DeviationOf(std::size_t t) const
  {
    return this->DeviationOf(this->TriangleAt(3 * t),
      { this->Mesh.Corners[3 * t], this->Mesh.Corners[3 * t + 1], this->Mesh.Corners[3 * t + 2] });
  }

  /// The largest one of the triangles at the vertex; or one of them that is not below `most`.
  double DeviationAt(Id vertex, double most = Infinity) const
  {
    double largest = 0.0;
    for (const Id s : this->SlotsAt[vertex])
    {
      largest = largest < most ? std::max(largest, this->DeviationOf(At(s) / 3)) : largest;
    }
    return largest;
  }

  const SurfaceGround& Ground;
  RelaxedSurface& Mesh;
  SurfaceStars Stars;
  std::vector<Id> Changes; ///< of vertices: the number of their last change
  Id Now = 0;              ///< the number of changes
  GroundPatches Patches;
  ChainPlaces Places;
  IdLists SlotsAt;           ///< of vertices
  std::vector<Triangle> Old; ///< at a vertex
  std::vector<Triangle> New; ///< the same, when it is moved
};

/// The order of the steps.
class SurfaceRelaxer : private SurfaceSteps
{
public:
  SurfaceRelaxer(
    const SurfaceGround& ground, const std::vector<Id>& pieces, RelaxedSurface& mesh, Pulse& pulse)
    : SurfaceSteps(ground, pieces, mesh, pulse)
    , Beats(pulse)
    , Ideal(mesh.Points.size(), 6)
    , Trials(mesh.Corners.size(), NoId)
  {
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
    Id before = 0;
    for (const double step : { 0.15, 0.05, 0.15, 0.05 })
    {
      const Id changes = this->Now;
      this->Approach(step, before);
      before = changes;
    }
  }

private:
  /// Numbers of triangles: 6 at free vertices; at others the angle that they have in all, by 60
  /// degrees, which flips do not change much.
  void FindIdeals()
  {
    std::vector<double> angles(this->Mesh.Points.size(), 0.0);
    for (std::size_t slot = 0; slot < this->Mesh.Corners.size(); ++slot)
    {
      const std::size_t vertex = At(this->Mesh.Corners[slot]);
      const Triangle t = this->TriangleAt(slot);
      angles[vertex] += this->Mesh.IsFree[vertex] != 0
        ? 0.0
        : std::atan2(Length(NormalOf(t)), Dot(t[1] - t[0], t[2] - t[0]));
    }
    for (std::size_t v = 0; v < angles.size(); ++v)
    {
      constexpr double Sixty = 1.0471975511965976;
      const Id ideal = std::max(static_cast<Id>(std::lround(angles[v] / Sixty)), Id{ 1 });
      this->Ideal[v] = this->Mesh.IsFree[v] != 0 ? 6 : ideal;
    }
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
    int sweep = 0;
    for (; sweep < MostSweeps && isChanged; ++sweep)
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
    if (sweep > 1) // there were flips
    {
      this->ListSlots();
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

  /// By how much the sum of the squares of what the numbers of triangles are off at the four
  /// vertices is less after a flip: e^2 - (e - 1)^2 = 2 e - 1, e^2 - (e + 1)^2 = -2 e - 1.
  Id GainOfDegrees(const std::array<Id, 4>& vertices) const
  {
    const auto [a, b, c, d] = vertices;
    const auto excess = [this](Id vertex)
    { return this->Stars.Degree(vertex) - this->Ideal[At(vertex)]; };
    return 2 * (excess(b) + excess(c) - excess(a) - excess(d)) - 4;
  }

  bool TryFlip(std::size_t slot, bool byDegrees)
  {
    const Id gain = byDegrees ? this->GainOfDegrees(this->VerticesAt(slot)) : 0;
    if (gain < 0 && IsBetter(this->TriangleAt(slot), GoodCosine) &&
      IsBetter(this->TriangleAt(At(this->Stars.Across(slot))), GoodCosine))
    {
      return false;
    }
    const SurfaceFlip flip = this->FlipAt(slot);
    const double before = flip.Before();
    const double after = flip.After();
    constexpr double Better = 1e-6;
    constexpr double LeastForDegrees = 0.9063077870366499; // 25 degrees
    const bool isWanted =
      gain > 0 ? after <= std::max(before, LeastForDegrees) : gain == 0 && after < before - Better;
    const bool isPoor = before > GoodCosine && after < before - Better;
    if ((!isWanted && !isPoor) || (gain > 0 && after > before && after > GoodCosine) ||
      !this->MayFlip(slot, flip))
    {
      return false;
    }
    this->Do(slot, flip);
    return true;
  }

  void Smooth(Id vertex)
  {
    Point3 sum{};
    double mass = 0.0;
    this->Gather(vertex);
    for (std::size_t k = 0; k < this->Old.size(); ++k)
    {
      const Triangle& t = this->Old[k];
      const std::size_t first = At(this->SlotsAt[vertex][static_cast<Id>(k)]) / 3 * 3;
      const auto sizeAt = [this, first](std::size_t corner)
      { return this->Mesh.Sizes[At(this->Mesh.Corners[first + corner])]; };
      const double size = (sizeAt(0) + sizeAt(1) + sizeAt(2)) / 3.0;
      const double own = Length(NormalOf(t)) / (size * size * size * size);
      sum = sum + (own / 3.0) * (t[0] + t[1] + t[2]);
      mass += own;
    }
    if (mass > 0.0)
    {
      this->TryMove(vertex, (1.0 / mass) * sum, GoodCosine);
    }
  }

  /// Tries to move the vertices of poor triangles in twelve directions. False where none is better
  /// for it.
  bool MoveWorst(int round)
  {
    const double step = round % 3 == 0 ? 0.1 : (round % 3 == 1 ? 0.03 : 0.01);
    bool isChanged = false;
    for (std::size_t t = 0; t < this->Mesh.Corners.size() / 3; ++t)
    {
      if (!IsBetter(this->TriangleAt(3 * t), BadCosine) && this->Beats.Beat(8))
      {
        isChanged = this->MoveCorners(t, step, false) || isChanged;
      }
    }
    return isChanged || round < 3;
  }

  /// Tries flips and moves by the step where triangles are far from the ground and something has
  /// changed since `before`.
  void Approach(double step, Id before)
  {
    std::vector<std::size_t> far;
    for (std::size_t t = 0; t < this->Mesh.Corners.size() / 3 && this->Beats.Beat(4); ++t)
    {
      const Id* corners = &this->Mesh.Corners[3 * t];
      const bool isNew = std::any_of(corners, corners + 3,
        [this, before](Id vertex) { return this->Changes[At(vertex)] >= before; });
      if (isNew && this->DeviationOf(t) > MostDeviation)
      {
        far.push_back(t);
      }
    }
    // Where more are far the input's facets are coarse for f: steps help little, and cost most.
    constexpr std::size_t MostShare = 8;
    if (far.size() > this->Mesh.Corners.size() / 3 / MostShare)
    {
      return;
    }
    for (const std::size_t t : far)
    {
      for (std::size_t slot = 3 * t; slot < 3 * t + 3; ++slot)
      {
        this->FlipToApproach(slot);
      }
    }
    this->ListSlots();
    for (const std::size_t t : far)
    {
      if (this->Beats.Beat(64) && this->DeviationOf(t) > MostDeviation)
      {
        this->MoveCorners(t, step, true);
      }
    }
  }

  void FlipToApproach(std::size_t slot)
  {
    if (this->Stars.Across(slot) == NoId)
    {
      return;
    }
    const SurfaceFlip flip = this->FlipAt(slot);
    const auto [a, b, c, d] = flip.Vertices;
    if (flip.After() < std::max(flip.Before(), BadCosine) &&
      std::max(this->DeviationOf(flip.NewFirst, { a, b, d }),
        this->DeviationOf(flip.NewSecond, { d, c, a })) <
        std::max(
          this->DeviationOf(flip.First, { a, b, c }), this->DeviationOf(flip.Second, { d, c, b })) -
          Nearer &&
      this->MayFlip(slot, flip))
    {
      this->Do(slot, flip);
    }
  }

  Pulse& Beats;
  std::vector<Id> Ideal;  ///< numbers of triangles
  std::vector<Id> Trials; ///< of slots: the number of changes before the last trial of a flip
  bool AreByDegrees = false;
};

} // namespace

void RelaxSurface(
  const SurfaceGround& ground, const std::vector<Id>& pieces, RelaxedSurface& mesh, Pulse& pulse)
{
  SurfaceRelaxer(ground, pieces, mesh, pulse).Run();
}

} // namespace biting
