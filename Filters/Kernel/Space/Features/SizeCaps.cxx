// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SizeCaps.h"

#include "../Surface/NearestOnTriangle.h"
#include "../Surface/SurfaceCrossings.h"
#include "../Surface/SurfaceLinks.h"
#include "GroundPatches.h"

#include <algorithm>  // for min, max
#include <array>      // for corners
#include <cmath>      // for sqrt, floor
#include <functional> // for greater
#include <queue>      // for the front of the gradation
#include <utility>    // for pairs

namespace biting
{

namespace
{

void Cap(SurfaceGround& ground, Id vertex, double size)
{
  double& old = ground.Sizes[At(vertex)];
  old = std::min(old, std::max(size, LeastShare * ground.Given[At(vertex)]));
}

/// Balls that touch the surface from one side. Walls are the input's triangles, not the ground's,
/// which may be hundreds of times as many.
class ShrinkingBall
{
public:
  ShrinkingBall(
    const SurfaceGround& ground, const SurfaceMesh& input, const BoxTree<SurfaceItem, 3>& tree)
    : Pieces(ground.Normals.size(), NoId)
    , Ground(ground)
    , Input(input)
    , Tree(tree)
    , IsOpen(std::find(ground.Flags.begin(), ground.Flags.end(), BorderFlag) != ground.Flags.end())
  {
    for (std::size_t t = 0; t < ground.Mesh.NumberOfTriangles(); ++t)
    {
      this->Pieces[At(ground.Mesh.Cells[t])] = static_cast<Id>(t);
    }
  }

  /// The diameter of the ball that touches the place, where the surface has the normal, from the
  /// side of it (+1) or from the other one (-1).
  double Diameter(const Point3& place, const Point3& normal, double side, double most)
  {
    constexpr int MostRounds = 4;
    double radius = 0.5 * most;
    bool isLess = true;
    for (int round = 0; round < MostRounds && isLess; ++round)
    {
      const Point3 center = place + (side * radius) * normal;
      Point3 nearest;
      Id wall = NoId;
      isLess = this->IsEntered(center, place, normal, nearest, wall);
      const Point3 apart = nearest - place;
      const double height = isLess ? side * Dot(apart, normal) : 0.0;
      isLess = height > 0.0 && Dot(apart, apart) < (2.0 - 1e-6) * height * radius;
      radius = isLess ? Dot(apart, apart) / (2.0 * height) : radius;
      this->Touch = isLess ? nearest : this->Touch;
      this->Wall = isLess ? wall : this->Wall;
    }
    return 2.0 * radius;
  }

  // Where the last ball ended.
  Point3 Touch;
  Id Wall = NoId;         ///< the triangle of the input
  std::vector<Id> Pieces; ///< of triangles of the input, one of the ground each

private:
  static constexpr EdgeFlag BorderFlag = 1 + static_cast<EdgeFlag>(SurfaceEdgeKind::Border);

  /// The ball around the center that touches the place `own`. Walls of closed surfaces have
  /// opposite normals; sheets of open ones may lie above each other in the same orientation.
  bool IsEntered(
    const Point3& center, const Point3& own, const Point3& normal, Point3& nearest, Id& wall) const
  {
    constexpr double LeastOpposition = 0.75;
    this->Tree.Search(center, 1.0, Distance(center, own),
      [this, &center, &own, &normal, &nearest, &wall](const SurfaceItem& item, double limit)
      {
        const std::size_t t = At(item.Triangle);
        const double cosine = Dot(this->Ground.Normals[t], normal);
        if (cosine > -LeastOpposition && !(this->IsOpen && cosine > LeastOpposition))
        {
          return limit;
        }
        const Point3 place = NearestPoint(this->Input.Triangle(t), center);
        const double distance = Distance(place, center);
        const Point3 apart = place - own;
        const double height = std::abs(Dot(apart, normal)); // the sheet of `own` is near it
        const bool isAcross = cosine < 0.0 ||
          height > std::max(LeastOpposition * Length(apart), 0.25 * Distance(center, own));
        if (distance < limit && isAcross)
        {
          nearest = place;
          wall = item.Triangle;
          return distance;
        }
        return limit;
      });
    return wall != NoId;
  }

  const SurfaceGround& Ground;
  const SurfaceMesh& Input;
  const BoxTree<SurfaceItem, 3>& Tree; ///< of the input
  bool IsOpen;                         ///< the surface
};

/// A feature edge as an item of a tree.
struct FeatureItem
{
  Id Tail;
  Id Head;
  Box3 Bounds;

  const Box3& Box() const { return this->Bounds; }
  double Least() const { return 0.0; }
};

/// Distances of features from each other, in space and along chains.
class FeatureDistances
{
public:
  FeatureDistances(const SurfaceGround& ground, Pulse& pulse)
    : Ground(ground)
    , Ways(ground.Mesh.Points.size(), Infinity)
    , Arms(ground.Mesh.Points.size())
  {
    std::vector<FeatureItem> items;
    const FeatureChains& chains = ground.Chains;
    for (Id chain = 0; chain < chains.Size(); ++chain)
    {
      for (Id k = chains.Begin(chain) + 1; k < chains.End(chain); ++k)
      {
        const Id a = chains.At(k - 1);
        const Id b = chains.At(k);
        items.push_back(
          { a, b, Box3::Around(ground.Mesh.Points[At(a)], ground.Mesh.Points[At(b)]) });
        this->Arms[At(a)].push_back(b);
        this->Arms[At(b)].push_back(a);
      }
    }
    this->Tree = BoxTree<FeatureItem, 3>(items, pulse);
  }

  /// The least distance of a stranger, if it is below `most`.
  double FromStranger(Id vertex, double most)
  {
    this->Measure(vertex, LeastRatio * most);
    const Point3& place = this->Ground.Mesh.Points[At(vertex)];
    double least = most;
    this->Tree.Search(place, 1.0, most,
      [this, &place, &least](const FeatureItem& item, double limit)
      {
        const Point3& tail = this->Ground.Mesh.Points[At(item.Tail)];
        const Point3& head = this->Ground.Mesh.Points[At(item.Head)];
        const Point3 foot = NearestPoint({ tail, head, head }, place);
        const double distance = Distance(place, foot);
        const double way = std::min(this->Ways[At(item.Tail)] + Distance(tail, foot),
          this->Ways[At(item.Head)] + Distance(head, foot));
        if (way > LeastRatio * distance && distance < least)
        {
          least = distance;
        }
        return std::min(limit, least);
      });
    for (const Id seen : this->Seen)
    {
      this->Ways[At(seen)] = Infinity;
    }
    return least;
  }

private:
  static constexpr double LeastRatio = 4.0;
  using Entry = std::pair<double, Id>;

  /// Dijkstra along chains.
  void Measure(Id vertex, double most)
  {
    this->Seen.assign(1, vertex);
    this->Ways[At(vertex)] = 0.0;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    front.push({ 0.0, vertex });
    while (!front.empty())
    {
      const Entry entry = front.top();
      front.pop();
      if (entry.first > this->Ways[At(entry.second)])
      {
        continue;
      }
      for (const Id next : this->Arms[At(entry.second)])
      {
        const double way = entry.first +
          Distance(this->Ground.Mesh.Points[At(next)], this->Ground.Mesh.Points[At(entry.second)]);
        if (way < most && way < this->Ways[At(next)])
        {
          this->Ways[At(next)] = way;
          this->Seen.push_back(next);
          front.push({ way, next });
        }
      }
    }
  }

  const SurfaceGround& Ground;
  BoxTree<FeatureItem, 3> Tree;
  std::vector<double> Ways;
  std::vector<std::vector<Id>> Arms;
  std::vector<Id> Seen;
};

/// The piece of a wall that a ball of the diameter touches at `place`: f grows from there. What is
/// steeper than any gradation is left to later rounds, when the wall is divided there. `piece`:
/// another one of the wall, then this.
void CapWall(SurfaceGround& ground, const GroundPatches& patches, Id& piece, const Point3& place,
  double diameter)
{
  constexpr double Growth = 0.3;
  piece = patches.Project(piece, place).Triangle;
  for (std::size_t slot = 3 * At(piece); slot < 3 * At(piece) + 3; ++slot)
  {
    Cap(
      ground, ground.Mesh.Corners[slot], diameter + Growth * Distance(ground.Mesh.At(slot), place));
  }
}

/// Marks the triangles of the patch that hang together with one within the distance of the place.
void MarkAround(const SurfaceGround& ground, Id triangle, const Point3& place, double most,
  std::vector<std::uint8_t>& isMarked)
{
  std::vector<Id> front{ triangle };
  isMarked[At(triangle)] = 1;
  while (!front.empty())
  {
    const std::size_t base = 3 * At(front.back());
    front.pop_back();
    for (std::size_t slot = base; slot < base + 3; ++slot)
    {
      const Id other = ground.Across[slot] == NoId ? NoId : ground.Across[slot] / 3;
      if (other != NoId && isMarked[At(other)] == 0 &&
        Distance(ground.Mesh.Middle(At(other)), place) < most)
      {
        isMarked[At(other)] = 1;
        front.push_back(other);
      }
    }
  }
}

/// Whether the way a, b, c turns by less than .06 degrees: a side of the input that was divided.
bool IsStraight(const SurfaceGround& ground, Id a, Id b, Id c)
{
  constexpr double LeastSine = 1e-3;
  const Point3 in = ground.Mesh.Points[At(b)] - ground.Mesh.Points[At(a)];
  const Point3 out = ground.Mesh.Points[At(c)] - ground.Mesh.Points[At(b)];
  return Length(Cross(in, out)) < LeastSine * Dot(in, out);
}

/// Of a chain at its vertices of the input where it turns; a straight piece between two of them is
/// one side.
void CapByTurns(SurfaceGround& ground, Id chain, double tolerance)
{
  std::vector<Id> turns;
  for (Id k = ground.Chains.Begin(chain); k < ground.Chains.End(chain); ++k)
  {
    const Id vertex = ground.Chains.At(k);
    if (ground.Mesh.PointIds[At(vertex)] == NoId)
    {
      continue;
    }
    if (turns.size() > 1 && IsStraight(ground, turns[turns.size() - 2], turns.back(), vertex))
    {
      turns.pop_back();
    }
    turns.push_back(vertex);
  }
  if (turns.size() > 2 && turns.front() == turns.back())
  {
    if (IsStraight(ground, turns[turns.size() - 2], turns.front(), turns[1]))
    {
      turns.erase(turns.begin());
      turns.back() = turns.front();
    }
    turns.push_back(turns[1]);
  }
  for (std::size_t k = 1; k + 1 < turns.size(); ++k)
  {
    const Point3 in = ground.Mesh.Points[At(turns[k])] - ground.Mesh.Points[At(turns[k - 1])];
    const Point3 out = ground.Mesh.Points[At(turns[k + 1])] - ground.Mesh.Points[At(turns[k])];
    const double lengths = Length(in) * Length(out);
    // 2 sin(angle / 2) = sqrt(2 - 2 cos angle)
    const double turn = std::sqrt(std::max(0.0, 2.0 - 2.0 * Dot(in, out) / lengths));
    const double reach = 0.5 * (Length(in) + Length(out));
    if (turn > 0.0 && ground.Places[At(turns[k])] == FeaturePlace::Line)
    {
      // A chord l of a circle of radius R is l^2 / (8 R) from it.
      const double size = 8.0 * tolerance * reach / turn;
      Cap(ground, turns[k], std::max(size, reach));
    }
  }
}

/// Unit, of the sum of the normals of triangles; 0 where that is.
Point3 NormalAt(const SurfaceGround& ground, const IdLists::List& triangles)
{
  Point3 normal{};
  for (const Id t : triangles)
  {
    normal = normal + ground.NormalOf(At(t));
  }
  return (1.0 / std::max(Length(normal), 1e-300)) * normal;
}

/// How far from a triangle its surface has turned.
class TurnSearch
{
public:
  TurnSearch(const SurfaceMesh& mesh, const std::vector<Point3>& normals, double turn, Pulse& pulse)
    : Mesh(mesh)
    , Links(LinkSurface(mesh, pulse))
    , Normals(normals)
    , Turn(turn)
    , Beats(pulse)
    , Seen(mesh.NumberOfTriangles(), NoId)
  {
  }

  /// Raises the sizes of triangles to the least distance from a place of t to a triangle whose
  /// normal differs by more than Turn, to which a way leads over near triangles and over no
  /// feature; to infinity where that is `most` or more. Those with their middles in the ball of
  /// that radius: at an edge where faces turn the cap is the width of the faces, in however small
  /// triangles. The place is the middle of t and, where that is a cap, others within t: the more
  /// of them, the fewer triangles are in the ball. So a ball has about as many places in coarse
  /// triangles as in fine ones.
  void Raise(std::size_t t, double most, std::vector<double>& sizes)
  {
    constexpr std::size_t PlacesInBall = 2048;
    std::array<Point3, 3> corner = this->Mesh.Triangle(t);
    const Point3 middle = this->Mesh.Middle(t);
    std::sort(corner.begin(), corner.end(), // the farthest first, whatever their order is
      [&middle](const Point3& a, const Point3& b)
      { return Distance(a, middle) > Distance(b, middle); });
    const double least = this->Walk(t, middle, most, true);
    const bool isCap = least < most;
    // Balls of places farther away belong to other triangles.
    const double extent = std::min(Distance(middle, corner[0]), 4.0 * least);
    std::size_t places = 1;
    if (isCap && this->Front.size() <= PlacesInBall)
    {
      places += PlacesInBall / this->Front.size();
      // No ball about a place is larger than least + extent.
      this->Walk(t, middle, least + 2.0 * extent, false);
    }
    for (std::size_t k = 0; k < places && this->Beats.Beat(this->Front.size()); ++k)
    {
      // The middle, then evenly spread: by multiples of 1 / g and 1 / g^2, where g^3 = g + 1.
      const double share = 4.0 / 9.0 + 0.7548776662466927 * static_cast<double>(k);
      const double part = 0.5 + 0.5698402909980532 * static_cast<double>(k);
      const double u = std::sqrt(share - std::floor(share)); // areas grow as its square
      const double v = u * (part - std::floor(part));
      const Point3 place = (1.0 - u) * corner[0] + (u - v) * corner[1] + v * corner[2];
      const double away = Distance(place, middle);
      const double size = k == 0 ? least
        : away <= extent         ? this->FromTurned(place, least + away)
                                 : 0.0;
      for (const Id other : this->Front)
      {
        if (Distance(this->Mesh.Middle(At(other)), place) < size)
        {
          sizes[At(other)] = std::max(sizes[At(other)], isCap ? size : Infinity);
        }
      }
    }
  }

private:
  static constexpr double MostTurn = 0.75; ///< of neighbors; more is a feature: above 44 degrees

  /// Lists the triangles around t that are nearer to the place than the reach: Front, and those
  /// that have turned. `toFirst`: none beyond the first of these. Its distance, or the reach.
  double Walk(std::size_t t, const Point3& place, double reach, bool toFirst)
  {
    double least = reach;
    this->Seen[t] = ++this->Searches;
    this->Front.assign(1, static_cast<Id>(t));
    this->Turned.clear();
    for (std::size_t next = 0; next < this->Front.size() && this->Beats.Beat(1); ++next) // it grows
    {
      const auto from = static_cast<std::size_t>(this->Front[next]);
      for (std::size_t slot = 3 * from; slot < 3 * from + 3; ++slot)
      {
        const Id across = this->Links.Across[slot];
        if (across < 0 || this->Seen[At(across / 3)] == this->Searches)
        {
          continue;
        }
        const std::size_t other = At(across / 3);
        const double distance = Distance(place, NearestPoint(this->Mesh.Triangle(other), place));
        if (distance >= (toFirst ? least : reach) || this->Differ(from, other, MostTurn))
        {
          continue;
        }
        this->Seen[other] = this->Searches;
        const bool isTurned = this->Differ(t, other, this->Turn);
        least = isTurned ? std::min(least, distance) : least;
        (isTurned ? this->Turned : this->Front).push_back(static_cast<Id>(other));
      }
    }
    return least;
  }

  double FromTurned(const Point3& place, double least) const
  {
    for (const Id t : this->Turned)
    {
      least = std::min(least, Distance(place, NearestPoint(this->Mesh.Triangle(At(t)), place)));
    }
    return least;
  }

  bool Differ(std::size_t a, std::size_t b, double turn) const
  {
    return Length(this->Normals[a] - this->Normals[b]) > turn; // 2 sin(angle / 2)
  }

  const SurfaceMesh& Mesh;
  SurfaceLinks Links;
  const std::vector<Point3>& Normals;
  double Turn;
  Pulse& Beats;
  std::vector<Id> Seen; ///< the search that saw it last
  Id Searches = 0;
  std::vector<Id> Front;
  std::vector<Id> Turned;
};

/// Of the edge of the slot, in the ball.
double LengthWithin(const SurfaceMesh& mesh, std::size_t slot, const Point3& center, double radius)
{
  const Point3 tail = mesh.At(NextSlotOf(slot)) - center;
  const Point3 side = mesh.At(PreviousSlotOf(slot)) - center - tail;
  const double length = Length(side);
  const double foot = -Dot(tail, side) / length; // along the edge, of the centre
  const double half = std::sqrt(std::max(0.0, radius * radius - Dot(tail, tail) + foot * foot));
  return std::max(0.0, std::min(length, foot + half) - std::max(0.0, foot - half));
}

/// The turn of the surface in the ball about a vertex, in radians: of edges that are no features,
/// integrated along them, over the ball's diameter. Convex and concave turns cancel each other. At
/// a ridge it is its turn, however faces are divided; where both curvatures are 1 / R it is
/// pi radius / R. Vertices within a quarter of the radius get `isDone`. `seen`: of triangles.
double TurnInBall(const SurfaceGround& ground, Id vertex, double radius,
  std::vector<std::uint8_t>& isDone, std::vector<Id>& seen)
{
  const SurfaceMesh& mesh = ground.Mesh;
  const Point3& center = mesh.Points[At(vertex)];
  std::vector<Id> front(ground.TrianglesAt[vertex].begin(), ground.TrianglesAt[vertex].end());
  for (const Id t : front)
  {
    seen[At(t)] = vertex;
  }
  double sum = 0.0;
  for (std::size_t next = 0; next < front.size(); ++next) // it grows
  {
    const std::size_t first = 3 * At(front[next]);
    for (std::size_t slot = first; slot < first + 3; ++slot)
    {
      const Id across = ground.Across[slot];
      const double within = across == NoId ? 0.0 : LengthWithin(mesh, slot, center, radius);
      isDone[At(mesh.Corners[slot])] |= Distance(mesh.At(slot), center) < 0.25 * radius ? 1 : 0;
      if (within > 0.0)
      {
        const Point3& normal = ground.NormalOf(first / 3);
        const double turn = Length(ground.NormalOf(At(across / 3)) - normal); // 2 sin(angle / 2)
        const bool isConvex = Dot(mesh.At(At(across)) - mesh.At(first), normal) < 0.0;
        sum += (isConvex ? 0.5 : -0.5) * turn * within; // edges are seen from both sides
        if (seen[At(across / 3)] != vertex)
        {
          seen[At(across / 3)] = vertex;
          front.push_back(across / 3);
        }
      }
    }
  }
  return std::abs(sum) / (2.0 * radius);
}

} // namespace

void CapByThickness(SurfaceGround& ground, const SurfaceMesh& input,
  const BoxTree<SurfaceItem, 3>& inputTree, Id firstVertex, Pulse& pulse)
{
  ShrinkingBall ball(ground, input, inputTree);
  const GroundPatches patches(ground);
  std::vector<std::uint8_t> isDone(ground.Mesh.NumberOfTriangles(), 0);
  // Triangles near a place are not measured: where it sees no wall they see none, and a wall's
  // distance changes by less than theirs.
  const auto measure = [&ball, &ground, &patches, &isDone](const Point3& place,
                         const Point3& normal, Id triangle, const std::vector<Id>& vertices)
  {
    double size = 0.0; // no larger ball matters, nor any where f is as small as it may be
    double least = Infinity;
    for (const Id v : vertices)
    {
      size = std::max(size, ground.Sizes[At(v)]);
      least = std::min(least, LeastShare * ground.Given[At(v)]);
    }
    double near = size > least ? 0.3 * size : 0.0;
    for (const double side : { 1.0, -1.0 })
    {
      const double diameter = near > 0.0 ? ball.Diameter(place, normal, side, size) : size;
      if (diameter < size)
      {
        near = std::min(near, 0.1 * std::max(diameter, least));
        for (const Id v : vertices)
        {
          Cap(ground, v, diameter);
        }
        CapWall(ground, patches, ball.Pieces[At(ball.Wall)], ball.Touch, diameter);
      }
    }
    MarkAround(ground, triangle, place, near, isDone);
  };
  const auto isOnLine = [&ground](Id v) { return ground.Places[At(v)] != FeaturePlace::None; };
  for (Id v = firstVertex; At(v) < ground.Mesh.Points.size() && pulse.Beat(64); ++v)
  {
    const IdLists::List around = ground.TrianglesAt[v];
    const bool isToDo = around.Size() > 0 && isDone[At(around[0])] == 0 && !isOnLine(v);
    const Point3 normal = isToDo ? NormalAt(ground, around) : Point3{};
    if (Length(normal) > 0.5) // 0 where those around cancel
    {
      measure(ground.Mesh.Points[At(v)], normal, around[0], { v });
    }
  }
  for (std::size_t t = 0; t < isDone.size() && pulse.Beat(64);
       ++t) // strips without a vertex inside
  {
    const Id* corners = &ground.Mesh.Corners[3 * t];
    if (isDone[t] == 0 && std::all_of(corners, corners + 3, isOnLine) &&
      *std::max_element(corners, corners + 3) >= firstVertex)
    {
      measure(ground.Mesh.Middle(t), ground.NormalOf(t), static_cast<Id>(t),
        { corners[0], corners[1], corners[2] });
    }
  }
}

void CapByFeatures(SurfaceGround& ground, Pulse& pulse)
{
  constexpr double ShareOfDistance = 0.8;
  FeatureDistances distances(ground, pulse);
  pulse.ForEach(ground.Mesh.Points.size(),
    [&ground, &distances](std::size_t v)
    {
      if (ground.Places[v] != FeaturePlace::None)
      {
        const auto vertex = static_cast<Id>(v);
        const double most = ground.Given[v] / ShareOfDistance;
        Cap(ground, vertex, ShareOfDistance * distances.FromStranger(vertex, most));
      }
    });
  for (Id chain = 0; chain < ground.Chains.Size(); ++chain)
  {
    const Id begin = ground.Chains.Begin(chain);
    const Id end = ground.Chains.End(chain);
    const bool isClosed = ground.Chains.At(begin) == ground.Chains.At(end - 1);
    const double size = ground.LengthOf(chain) / (isClosed ? 4.0 : 1.0);
    for (Id k = begin; k < end; ++k)
    {
      Cap(ground, ground.Chains.At(k), size);
    }
  }
}

void CapByCurvature(SurfaceGround& ground, const SurfaceMesh& input, double tolerance, Pulse& pulse)
{
  if (tolerance == 0.0)
  {
    return;
  }
  // A triangle of circumradius l / sqrt 3 is l^2 / (6 R) from a sphere of radius R, on which
  // normals l apart differ by l / R. Edges are up to 1.22 f, and 1.22^2 * 4 = 6. Facets turn in
  // steps: the turn that is looked for is larger by 1 / Share, 25 degrees at a tolerance of .1.
  constexpr double Share = 0.89;
  TurnSearch search(input, ground.Normals, 4.0 / Share * tolerance, pulse);
  std::vector<double> sizes(input.NumberOfTriangles(), 0.0);
  pulse.ForEach(sizes.size(),
    [&ground, &input, &search, &sizes](std::size_t t)
    {
      double most = 0.0;
      for (std::size_t slot = 3 * t; slot < 3 * t + 3; ++slot)
      {
        most = std::max(most, ground.Sizes[At(input.Corners[slot])]);
      }
      search.Raise(t, most, sizes);
    });
  for (std::size_t slot = 0; slot < ground.Mesh.Corners.size(); ++slot)
  {
    const double size = sizes[At(ground.Mesh.Cells[slot / 3])];
    if (size < Infinity)
    {
      Cap(ground, ground.Mesh.Corners[slot], Share * size);
    }
  }
  for (Id chain = 0; chain < ground.Chains.Size(); ++chain)
  {
    CapByTurns(ground, chain, tolerance);
  }
}

bool HalveAtTurns(SurfaceGround& ground, Pulse& pulse)
{
  constexpr double MostTurn = 1.2; // a facet across such a ridge is .2 f from it
  constexpr double Radius = 0.58;  // of a facet of edges f
  std::vector<double> sizes = ground.Sizes;
  std::vector<std::uint8_t> isDone(sizes.size(), 0);
  std::vector<Id> seen(ground.Mesh.NumberOfTriangles(), NoId);
  pulse.ForEach(sizes.size(),
    [&ground, &sizes, &isDone, &seen](std::size_t v)
    {
      const double shares = sizes[v] / (LeastShare * ground.Given[v]);
      if (shares > 0.45 && shares < 1.1 && isDone[v] == 0 &&
        TurnInBall(ground, static_cast<Id>(v), Radius * sizes[v], isDone, seen) > MostTurn)
      {
        sizes[v] *= 0.5;
      }
    });
  return std::exchange(ground.Sizes, sizes) != sizes;
}

void GradeSizes(SurfaceGround& ground, double gradation, Pulse& pulse)
{
  using Entry = std::pair<double, Id>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  const double slope = gradation > 0.0 ? gradation : 0.3;
  const std::vector<Point3>& points = ground.Mesh.Points;
  const auto lower = [&ground, &front, &points, slope](Id from, Id other)
  {
    const double size =
      ground.Sizes[At(from)] + slope * Distance(points[At(other)], points[At(from)]);
    if (size < ground.Sizes[At(other)])
    {
      ground.Sizes[At(other)] = size;
      front.push({ size, other });
    }
  };
  const std::vector<Id>& corners = ground.Mesh.Corners;
  for (std::size_t slot = 0; slot < corners.size() && pulse.Beat(1); ++slot)
  {
    const Id vertex = corners[slot];
    const bool isCapped = ground.Sizes[At(vertex)] < ground.Given[At(vertex)];
    lower(vertex, gradation > 0.0 || isCapped ? corners[NextSlotOf(slot)] : vertex);
    lower(vertex, gradation > 0.0 || isCapped ? corners[PreviousSlotOf(slot)] : vertex);
  }
  while (!front.empty() && pulse.Beat())
  {
    const Entry entry = front.top();
    front.pop();
    if (entry.first > ground.Sizes[At(entry.second)])
    {
      continue;
    }
    for (const Id t : ground.TrianglesAt[entry.second])
    {
      for (std::size_t slot = 3 * At(t); slot < 3 * At(t) + 3; ++slot)
      {
        lower(entry.second, corners[slot]);
      }
    }
  }
}

} // namespace biting
