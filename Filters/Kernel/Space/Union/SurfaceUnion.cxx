// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceUnion.h"

#include "../../Base/DisjointSets.h"
#include "../../Base/DistanceToSegment.h"
#include "../../Delaunay/ConstrainedMesh.h"
#include "../../Predicates/Predicates.h"
#include "SmallCrossings.h"
#include "WindingNumber.h"

#include <algorithm> // for all_of, find, lower_bound, max, min, set_symmetric_difference, sort
#include <cmath>     // for abs
#include <cstdint>   // for marks
#include <iterator>  // for back_inserter
#include <map>       // for segments
#include <set>       // for points in order
#include <utility>   // for pairs

namespace biting
{

namespace
{

using PointPair = std::pair<Id, Id>; ///< in order

using PlaceInOrder = std::pair<double, Id>;

constexpr Point3 Sweep{ 0.8, 0.5123, 0.3117 }; // shorter than 1; few points lie across it

// Points of space: given ones, and new ones, which are nearer than a tolerance to none.
class WeldedPoints
{
public:
  WeldedPoints(const std::vector<Point3>& given, double tolerance)
    : All(given)
    , Tolerance(tolerance)
  {
  }

  const Point3& operator[](Id point) const { return this->All[At(point)]; }

  double Along(Id point) const { return Dot(Sweep, this->All[At(point)]); }

  bool IsBefore(Id one, Id other) const
  {
    return PlaceInOrder(this->Along(one), one) < PlaceInOrder(this->Along(other), other);
  }

  // That others may be welded to the given point.
  void Use(Id point) { this->Order.insert({ this->Along(point), point }); }

  // The point nearest to the place, if it is within the tolerance, else a new one.
  Id Find(const Point3& place)
  {
    const double along = Dot(Sweep, place);
    Id nearest = NoId;
    double least = this->Tolerance;
    for (auto at = this->Order.lower_bound({ along - least, 0 });
         at != this->Order.end() && at->first <= along + this->Tolerance; ++at)
    {
      const double distance = Distance(place, this->All[At(at->second)]);
      nearest = distance <= least ? at->second : nearest;
      least = std::min(least, distance);
    }
    if (nearest == NoId)
    {
      nearest = static_cast<Id>(this->All.size());
      this->All.push_back(place);
      this->Use(nearest);
    }
    return nearest;
  }

  std::vector<Point3> All;

private:
  double Tolerance;
  std::set<PlaceInOrder> Order; ///< of points in use
};

// A segment that divides triangles, or bounds them.
struct Segment
{
  std::vector<Id> Planes; ///< that it lies in
  std::vector<Id> Sided;  ///< triangles that it is a side of
};

// Whether all corners of a triangle are near to the plane of the other.
bool IsNearPlane(const SurfaceMesh& mesh, Id triangle, Id other, double tolerance)
{
  const Point3 origin = mesh.At(3 * At(other));
  const Point3 normal = mesh.Normal(At(other));
  const Triangle3 corners = mesh.Triangle(At(triangle));
  return std::all_of(corners.begin(), corners.end(),
    [&origin, &normal, tolerance](const Point3& corner)
    { return std::abs(Dot(corner - origin, normal)) <= tolerance * Length(normal); });
}

// Of triangles of one plane: whether no side of the first one separates them.
bool Overlap(const SurfaceMesh& mesh, Id one, Id other, double tolerance)
{
  const Point3 normal = mesh.Normal(At(one));
  const Triangle3 corners = mesh.Triangle(At(other));
  bool overlap = true;
  for (std::size_t slot = 3 * At(one); slot < 3 * At(one) + 3; ++slot)
  {
    const Point3& begin = mesh.At(NextSlotOf(slot));
    const Point3 inwards = Cross(normal, mesh.At(PreviousSlotOf(slot)) - begin);
    overlap = overlap &&
      std::any_of(corners.begin(), corners.end(),
        [&begin, &inwards, tolerance](const Point3& corner)
        { return Dot(corner - begin, inwards) > tolerance * Length(inwards); });
  }
  return overlap;
}

bool LieOnEachOther(const SurfaceMesh& mesh, Id one, Id other, double tolerance)
{
  return IsNearPlane(mesh, one, other, tolerance) && IsNearPlane(mesh, other, one, tolerance) &&
    Overlap(mesh, one, other, tolerance) && Overlap(mesh, other, one, tolerance);
}

class SurfaceUniter
{
public:
  SurfaceUniter(const CheckedSurface& surface, double tolerance, Pulse& pulse)
    : Surface(surface)
    , Mesh(surface.Mesh)
    , Tolerance(tolerance)
    , Beats(pulse)
    , Links(LinkSurface(this->Mesh, pulse))
    , Tree(MakeSurfaceTree(this->Mesh, pulse))
    , Winding(this->Mesh, this->Tree)
    , IsCut(this->Mesh.NumberOfTriangles(), 0)
    , PlaneOf(this->Mesh.NumberOfTriangles(), NoId)
    , Points(this->Mesh.Points, tolerance)
    , PointsIn(this->Mesh.NumberOfTriangles())
    , SegmentsIn(this->Mesh.NumberOfTriangles())
  {
  }

  SurfaceMesh Run()
  {
    if (!this->Mesh.Regions.empty() || !IsBounding(this->Surface))
    {
      return {};
    }
    this->FindPlanes();
    this->AddSides();
    this->AddMeetings();
    for (std::size_t plane = 0; plane < this->IsCut.size() && this->Beats.Beat(); ++plane)
    {
      this->AddCrossings(static_cast<Id>(plane));
    }
    this->ListSegments();
    while (this->DivideSegments() && this->Beats.Ask())
    {
    }
    this->KeepWhole();
    for (std::size_t plane = 0; plane < this->IsCut.size() && this->Beats.Beat(); ++plane)
    {
      const bool isDivided =
        this->SegmentsIn[plane].empty() || this->DividePlane(static_cast<Id>(plane));
      this->IsClear = this->IsClear && isDivided;
    }
    if (!this->IsClear)
    {
      return {};
    }
    this->Result.Points = std::move(this->Points.All);
    this->Result.PointIds = this->Mesh.PointIds;
    this->Result.PointIds.resize(this->Result.Points.size(), NoId);
    return std::move(this->Result);
  }

private:
  // Whether one of the triangles, which lie on each other, is of a cavity without a wall there: its
  // shell is oriented by nesting, and the shells cross nowhere.
  bool IsFlush(Id one, Id other) const
  {
    const std::vector<Id>& shellOf = this->Surface.Shells.ShellOf;
    const auto shells = std::minmax({ shellOf[At(one)], shellOf[At(other)] });
    const std::vector<SurfaceContact>& crossings = this->Surface.Crossings;
    const auto volume = [this](Id shell) { return this->Surface.Shells.Shells[At(shell)].Volume; };
    return (volume(shells.first) < 0.0) != (volume(shells.second) < 0.0) &&
      std::none_of(crossings.begin(), crossings.end(),
        [&shellOf, &shells](const SurfaceContact& contact) {
          return shells == std::minmax({ shellOf[At(contact.First)], shellOf[At(contact.Second)] });
        });
  }

  // All that meet others are divided, and those beside them, whose sides may be. Rounding may have
  // put triangles of one plane apart.
  void FindPlanes()
  {
    std::vector<Id> cut;
    for (const auto* list : { &this->Surface.Crossings, &this->Surface.Touches })
    {
      for (const SurfaceContact& contact : *list)
      {
        cut.push_back(contact.First);
        cut.push_back(contact.Second);
      }
    }
    DisjointSets planes(this->PlaneOf.size());
    for (std::size_t k = 0; k < cut.size() && this->Beats.Beat(); ++k)
    {
      if (this->IsCut[At(cut[k])]++ > 0)
      {
        this->IsCut[At(cut[k])] = 1;
        continue;
      }
      Box3 box = this->Mesh.BoxOf(At(cut[k]));
      box.Grow(this->Tolerance);
      this->Tree.AllOf(box,
        [this, &cut, &planes, k](const SurfaceItem& item)
        {
          if (item.Triangle != cut[k] &&
            LieOnEachOther(this->Mesh, cut[k], item.Triangle, this->Tolerance))
          {
            this->IsClear = this->IsClear && !this->IsFlush(cut[k], item.Triangle);
            planes.Unite(cut[k], item.Triangle);
            cut.push_back(item.Triangle);
          }
          return this->Beats.Beat(1);
        });
    }
    std::vector<Id> beside = this->Links.CrowdedSlots;
    for (const Id triangle : cut)
    {
      const auto across = this->Links.Across.begin() + 3 * triangle;
      beside.insert(beside.end(), across, across + 3);
    }
    for (const Id slot : beside)
    {
      this->IsCut[At(std::max(slot, Id{ 0 }) / 3)] = 1; // one more at crowded edges does no harm
    }
    for (std::size_t t = 0; t < this->PlaneOf.size(); ++t)
    {
      this->PlaneOf[t] = planes.SetOf(static_cast<Id>(t));
    }
  }

  void AddSides()
  {
    for (std::size_t slot = 0; slot < this->Mesh.Corners.size(); ++slot)
    {
      if (this->IsCut[slot / 3] != 0)
      {
        const auto triangle = static_cast<Id>(slot / 3);
        const Id vertex = this->Mesh.Corners[slot];
        Segment& segment = this->Segments[EndsOf(this->Mesh, slot)];
        segment.Planes.push_back(this->PlaneOf[At(triangle)]);
        segment.Sided.push_back(triangle);
        this->PointsIn[At(this->PlaneOf[At(triangle)])].push_back(vertex);
        this->Points.Use(vertex);
      }
    }
  }

  // Whether triangles of a fold have a common side.
  bool HaveSide(const SurfaceContact& contact) const
  {
    const auto across = this->Links.Across.begin() + 3 * contact.First;
    return std::any_of(
      across, across + 3, [&contact](Id slot) { return slot / 3 == contact.Second; });
  }

  // Of triangles that meet, but are not in one plane.
  void AddMeetings()
  {
    for (const auto* list : { &this->Surface.Crossings, &this->Surface.Touches })
    {
      for (const SurfaceContact& contact : *list)
      {
        const Id one = this->PlaneOf[At(contact.First)];
        const Id other = this->PlaneOf[At(contact.Second)];
        if (one == other || this->HaveSide(contact) || !this->Beats.Beat(16))
        {
          continue;
        }
        std::vector<Id> points;
        for (const Point3& place : PlacesOfMeeting(this->Mesh, contact))
        {
          points.push_back(this->Points.Find(place));
          this->PointsIn[At(one)].push_back(points.back());
          this->PointsIn[At(other)].push_back(points.back());
        }
        PointPair longest{ 0, 0 };
        for (const Id a : points)
        {
          for (const Id b : points)
          {
            const bool isLonger = Distance(this->Points[a], this->Points[b]) >
              Distance(this->Points[longest.first], this->Points[longest.second]);
            longest = isLonger ? PointPair(std::minmax(a, b)) : longest;
          }
        }
        if (longest.first != longest.second)
        {
          Segment& segment = this->Segments[longest];
          segment.Planes.push_back(one);
          segment.Planes.push_back(other);
        }
      }
    }
    this->ListSegments();
  }

  void ListSegments()
  {
    const auto isBefore = [this](Id one, Id other) { return this->Points.IsBefore(one, other); };
    for (std::vector<Id>& points : this->PointsIn)
    {
      std::sort(points.begin(), points.end(), isBefore);
      points.erase(std::unique(points.begin(), points.end()), points.end());
    }
    std::vector<std::vector<PointPair>>(this->IsCut.size()).swap(this->SegmentsIn);
    for (auto& [ends, segment] : this->Segments)
    {
      std::sort(segment.Planes.begin(), segment.Planes.end());
      segment.Planes.erase(
        std::unique(segment.Planes.begin(), segment.Planes.end()), segment.Planes.end());
      for (const Id plane : segment.Planes)
      {
        this->SegmentsIn[At(plane)].push_back(ends);
      }
    }
  }

  // The axis that the plane is seen along, by its first triangle.
  std::size_t AxisOf(Id plane) const { return LongestAxis(this->Mesh.Normal(At(plane))); }

  Point2 Seen(Id point, std::size_t axis) const
  {
    const Point3& place = this->Points[point];
    return { place[(axis + 1) % 3], place[(axis + 2) % 3] };
  }

  // Where segments of a plane cross.
  void AddCrossings(Id plane)
  {
    const std::size_t axis = this->AxisOf(plane);
    std::vector<std::pair<double, PointPair>> order;
    for (const PointPair& ends : this->SegmentsIn[At(plane)])
    {
      order.emplace_back(
        std::min(this->Seen(ends.first, axis).X, this->Seen(ends.second, axis).X), ends);
    }
    std::sort(order.begin(), order.end());
    for (std::size_t k = 0; k < order.size(); ++k)
    {
      const PointPair& one = order[k].second;
      const Point2 a = this->Seen(one.first, axis);
      const Point2 b = this->Seen(one.second, axis);
      for (std::size_t next = k + 1;
           next < order.size() && this->Beats.Beat(1) && order[next].first <= std::max(a.X, b.X);
           ++next)
      {
        const PointPair& other = order[next].second;
        const Point2 c = this->Seen(other.first, axis);
        const Point2 d = this->Seen(other.second, axis);
        const int sides[] = { Orient2D(a, b, c), Orient2D(a, b, d), Orient2D(c, d, a),
          Orient2D(c, d, b) };
        if (sides[0] * sides[1] < 0 && sides[2] * sides[3] < 0)
        {
          const double sine = Cross(b - a, d - c); // rounded: 0 of nearly parallel ones
          const double share =
            sine != 0.0 ? std::min(1.0, std::max(0.0, Cross(c - a, d - c) / sine)) : 0.5;
          const Point3& begin = this->Points[one.first];
          const Point3 place = begin + share * (this->Points[one.second] - begin);
          this->PointsIn[At(plane)].push_back(this->Points.Find(place));
        }
      }
    }
  }

  // At points on them; these belong to all planes of a segment then. Whether there were any.
  bool DivideSegments()
  {
    std::map<PointPair, Segment> divided;
    std::vector<std::pair<Id, Id>> added; // to planes: points
    for (const auto& [ends, segment] : this->Segments)
    {
      const std::vector<Id> on = this->PointsOn(ends, segment);
      for (std::size_t k = 0; k + 1 < on.size(); ++k)
      {
        Segment& part = divided[PointPair(std::minmax(on[k], on[k + 1]))];
        part.Planes.insert(part.Planes.end(), segment.Planes.begin(), segment.Planes.end());
        part.Sided.insert(part.Sided.end(), segment.Sided.begin(), segment.Sided.end());
        for (const Id plane : segment.Planes)
        {
          added.emplace_back(plane, on[k]);
        }
      }
    }
    const bool isChanged = divided.size() > this->Segments.size();
    this->Segments = std::move(divided);
    for (const auto& [plane, point] : added)
    {
      this->PointsIn[At(plane)].push_back(point);
    }
    this->ListSegments();
    return isChanged;
  }

  // Its ends, and the points of its planes between them, in order.
  std::vector<Id> PointsOn(const PointPair& ends, const Segment& segment)
  {
    const Point3& begin = this->Points[ends.first];
    const Point3& end = this->Points[ends.second];
    const double square = Dot(end - begin, end - begin);
    const auto [first, last] =
      std::minmax({ this->Points.Along(ends.first), this->Points.Along(ends.second) });
    std::vector<PlaceInOrder> order;
    for (const Id plane : segment.Planes)
    {
      const std::vector<Id>& points = this->PointsIn[At(plane)];
      auto at = std::lower_bound(points.begin(), points.end(), first - this->Tolerance,
        [this](Id point, double least) { return this->Points.Along(point) < least; });
      for (; at != points.end() && this->Points.Along(*at) <= last + this->Tolerance; ++at)
      {
        const Point3& place = this->Points[*at];
        const double share = Dot(place - begin, end - begin) / square;
        if (this->Beats.Beat(1) && *at != ends.first && *at != ends.second && share > 0.0 &&
          share < 1.0 && DistanceToSegment(place, begin, end) <= this->Tolerance)
        {
          order.emplace_back(share, *at);
        }
      }
    }
    std::sort(order.begin(), order.end());
    std::vector<Id> on{ ends.first };
    for (const auto& [share, point] : order)
    {
      if (point != on.back())
      {
        on.push_back(point);
      }
    }
    on.push_back(ends.second);
    return on;
  }

  // Triangles that are not divided.
  void KeepWhole()
  {
    const std::vector<int> windings = this->Winding.InFront(this->Links, this->IsCut, this->Beats);
    for (std::size_t t = 0; t < this->IsCut.size(); ++t)
    {
      this->IsClear = this->IsClear && windings[t] >= 0;
      if (this->IsCut[t] == 0 && windings[t] == 0)
      {
        const Id* const corners = &this->Mesh.Corners[3 * t];
        this->Keep({ corners[0], corners[1], corners[2] }, t);
      }
    }
  }

  void Keep(const std::array<Id, 3>& corners, std::size_t triangle)
  {
    this->Result.Corners.insert(this->Result.Corners.end(), corners.begin(), corners.end());
    this->Result.Cells.push_back(this->Mesh.Cells[triangle]);
  }

  // Whether all segments became edges.
  bool DividePlane(Id plane)
  {
    const std::size_t axis = this->AxisOf(plane);
    const std::vector<Id>& points = this->PointsIn[At(plane)];
    std::vector<Point2> places;
    places.reserve(points.size());
    for (const Id point : points)
    {
      places.push_back(this->Seen(point, axis));
    }
    const auto number = [this, &points](Id point)
    {
      const auto found = std::lower_bound(points.begin(), points.end(), point,
        [this](Id one, Id other) { return this->Points.IsBefore(one, other); });
      return static_cast<Id>(found - points.begin());
    };
    ConstraintEdges edges;
    for (const PointPair& ends : this->SegmentsIn[At(plane)])
    {
      edges.Starts.push_back(number(ends.first));
      edges.Ends.push_back(number(ends.second));
      edges.IsBoundary.push_back(0);
    }
    const ConstrainedMesh made = MakeConstrainedMesh(places, edges, 1.0, this->Beats);
    if (!made.IsWhole() || !made.Recovery.Coincidences.empty())
    {
      return false;
    }
    this->AddPieces(plane, made.Inserted);
    return true;
  }

  // From outside inwards: of each triangle those of the surface that it is a piece of.
  void AddPieces(Id plane, const InsertionResult& made)
  {
    const HalfEdgeMesh& flat = made.Mesh;
    std::vector<std::vector<Id>> owners(static_cast<std::size_t>(flat.NumberOfTriangles));
    std::vector<std::uint8_t> isSeen(owners.size(), 0);
    std::vector<Id> queue;
    for (Id t = 0; t < flat.NumberOfTriangles; ++t)
    {
      if (flat.IsGhost(t))
      {
        isSeen[At(t)] = 1;
        queue.push_back(t);
      }
    }
    for (std::size_t next = 0; next < queue.size() && this->Beats.Beat(64); ++next)
    {
      const Id t = queue[next];
      for (Id edge = HalfEdgeMesh::FirstEdge(t); edge < HalfEdgeMesh::FirstEdge(t) + 3; ++edge)
      {
        const Id other = HalfEdgeMesh::TriangleOf(flat.Twins[At(edge)]);
        if (isSeen[At(other)]++ == 0)
        {
          owners[At(other)] = this->OwnersAcross(owners[At(t)], plane, flat.Mark(edge));
          queue.push_back(other);
        }
        isSeen[At(other)] = 1;
      }
      if (!owners[At(t)].empty())
      {
        std::array<Id, 3> corners{ 0, 0, 0 };
        for (std::size_t k = 0; k < 3; ++k)
        {
          const Id vertex = flat.Corners[At(HalfEdgeMesh::FirstEdge(t)) + k];
          corners[k] = this->PointsIn[At(plane)][At(made.Order[At(vertex)])];
        }
        this->AddPiece(plane, corners, owners[At(t)]);
      }
    }
  }

  // Each of the triangles that have the segment as a side begins or ends there.
  std::vector<Id> OwnersAcross(const std::vector<Id>& owners, Id plane, Id mark) const
  {
    if (mark == NoId)
    {
      return owners;
    }
    std::vector<Id> sided;
    for (const Id triangle : this->Segments.at(this->SegmentsIn[At(plane)][At(mark / 2)]).Sided)
    {
      const auto same = std::find(sided.begin(), sided.end(), triangle);
      if (this->PlaneOf[At(triangle)] == plane && same == sided.end())
      {
        sided.push_back(triangle);
      }
      else if (same != sided.end())
      {
        sided.erase(same); // there and back
      }
    }
    std::sort(sided.begin(), sided.end());
    std::vector<Id> across;
    std::set_symmetric_difference(
      owners.begin(), owners.end(), sided.begin(), sided.end(), std::back_inserter(across));
    return across;
  }

  // Seen along the axis the corners are counterclockwise.
  void AddPiece(Id plane, std::array<Id, 3> corners, const std::vector<Id>& owners)
  {
    const std::size_t axis = this->AxisOf(plane);
    const Point3 middle = (1.0 / 3.0) *
      (this->Points[corners[0]] + this->Points[corners[1]] + this->Points[corners[2]]);
    const int above = this->Winding.At(
      middle, axis, [this, plane](std::size_t t) { return this->PlaneOf[t] == plane; });
    const auto isUp = [this, axis](Id t) { return this->Mesh.Normal(At(t))[axis] > 0.0; };
    int below = above;
    for (const Id owner : owners)
    {
      below += isUp(owner) ? 1 : -1;
    }
    this->IsClear = this->IsClear && above >= 0 && below >= 0;
    if ((above > 0) != (below > 0))
    {
      const bool isTurned = above > 0;
      const auto alike = std::find_if(
        owners.begin(), owners.end(), [&isUp, isTurned](Id t) { return isUp(t) != isTurned; });
      if (isTurned)
      {
        std::swap(corners[1], corners[2]);
      }
      this->Keep(corners, At(*alike));
    }
  }

  const CheckedSurface& Surface;
  const SurfaceMesh& Mesh;
  double Tolerance;
  Pulse& Beats;
  SurfaceLinks Links;
  BoxTree<SurfaceItem, 3> Tree;
  WindingNumber Winding;
  std::vector<std::uint8_t> IsCut; ///< of triangles
  std::vector<Id> PlaneOf;         ///< of triangles: the first one of those on each other
  WeldedPoints Points;
  bool IsClear = true;                            ///< what is inside
  std::vector<std::vector<Id>> PointsIn;          ///< of planes, numbered by their sets
  std::vector<std::vector<PointPair>> SegmentsIn; ///< of planes
  std::map<PointPair, Segment> Segments;
  SurfaceMesh Result;
};

} // namespace

SurfaceMesh UniteSurfaces(const CheckedSurface& surface, double noise, Pulse& pulse)
{
  const double tolerance = std::max(4.0 * noise, 1e-7 * surface.Figures.Diagonal);
  return SurfaceUniter(surface, tolerance, pulse).Run();
}

} // namespace biting
