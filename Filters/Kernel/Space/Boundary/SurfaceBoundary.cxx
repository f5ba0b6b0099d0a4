// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceBoundary.h"

#include "../../Base/Numbers.h"
#include "../../Delaunay/SpatialOrder.h"
#include "../Delaunay/RegularTriangulation.h"
#include "../Surface/NearestOnTriangle.h"
#include "BodySides.h"
#include "BoundaryCheck.h"
#include "InsideTest.h"

#include <algorithm> // for min, max
#include <array>     // for corners
#include <cmath>     // for abs

namespace biting
{

namespace
{

/// Where the dual edge of a facet meets the surface.
struct DualMeeting
{
  Id Triangle = NoId; ///< of the ground; NoId: nowhere
  Point3 Place;       ///< then that of the dual edge which is nearest to the facet
  Id Count = 0;
};

class BoundaryFinder
{
public:
  BoundaryFinder(const SurfaceGround& ground, const SurfaceBites& bites,
    const BoxTree<SurfaceItem, 3>& tree, Pulse& pulse)
    : Ground(ground)
    , Bites(bites)
    , Tree(tree)
    , Cells(bites.NumberOnLines > 0)
    , Beats(pulse)
  {
  }

  SurfaceBoundary Run()
  {
    const bool isSolid = !this->Ground.Sides.empty();
    if (!isSolid)
    {
      this->AddFrame();
    }
    this->Triangulate();
    this->FindCenters();
    if (isSolid)
    {
      this->LabelCells();
      this->TakeWalls();
    }
    else
    {
      this->TakeMeetings();
    }
    CheckBoundary(this->Ground, this->Bites, this->Result);
    constexpr int MostRounds = 3;
    for (int round = 0; isSolid && round < MostRounds && this->LabelAnew(); ++round)
    {
      this->Result = {};
      this->TakeWalls();
      CheckBoundary(this->Ground, this->Bites, this->Result);
    }
    return std::move(this->Result);
  }

private:
  /// Corners of a cube around all: so flat surfaces have cells on both sides.
  void AddFrame()
  {
    const Box3 box = this->Ground.Mesh.Bounds();
    const double reach = 3.0 * box.Diagonal();
    for (int corner = 0; corner < 8; ++corner)
    {
      const Point3 way{ (corner & 1) != 0 ? reach : -reach, (corner & 2) != 0 ? reach : -reach,
        (corner & 4) != 0 ? reach : -reach };
      this->Cells.Insert(box.Center() + way);
      this->BiteOf.push_back(NoId);
    }
  }

  void Triangulate()
  {
    this->Cells.Reserve(this->Bites.Centers.size());
    const std::vector<Id> order = SpatialOrder(this->Bites.Centers, this->Beats);
    this->BiteOf.reserve(order.size());
    for (const Id bite : order)
    {
      if (!this->Beats.Beat(64))
      {
        return;
      }
      const PointInsertion made =
        this->Cells.Insert(this->Bites.Centers[At(bite)], this->Bites.WeightOf(bite));
      if (made.What != PointOutcome::Duplicate)
      {
        this->BiteOf.push_back(bite);
      }
    }
  }

  WeightedPoint CornerAt(Id cell, Id k) const
  {
    const Id vertex = this->Cells.Mesh().Corners[At(4 * cell + k)];
    return { this->Cells.Mesh().PointAt(vertex), this->Cells.Mesh().WeightAt(vertex) };
  }

  void FindCenters()
  {
    const TetMesh& mesh = this->Cells.Mesh();
    this->Centers.resize(At(mesh.NumberOfSlots()));
    for (Id cell = 0; cell < mesh.NumberOfSlots() && this->Beats.Beat(8); ++cell)
    {
      if (mesh.IsTetrahedron(cell))
      {
        const WeightedPoint first = this->CornerAt(cell, 0);
        this->Centers[At(cell)] = first.Place +
          PowerCenter(
            first, this->CornerAt(cell, 1), this->CornerAt(cell, 2), this->CornerAt(cell, 3));
      }
    }
  }

  void LabelCells()
  {
    const InsideTest test(this->Ground, this->Tree);
    const TetMesh& mesh = this->Cells.Mesh();
    this->Labels.assign(At(mesh.NumberOfSlots()), 0);
    for (Id cell = 0; cell < mesh.NumberOfSlots() && this->Beats.Beat(32); ++cell)
    {
      if (mesh.IsTetrahedron(cell))
      {
        const Id label = this->LabelByNormals(cell);
        this->Labels[At(cell)] = label != NoId ? label : test.LabelAt(this->Centers[At(cell)]);
      }
    }
  }

  /// Labels cells at bites with faults by their middles. In a wedge or a wall too thin for f power
  /// centres are beyond the other side, but middles are not. Whether a label changes.
  bool LabelAnew()
  {
    const InsideTest test(this->Ground, this->Tree);
    const TetMesh& mesh = this->Cells.Mesh();
    std::vector<std::uint8_t> isAt(this->Bites.Centers.size(), 0);
    for (const BoundaryOffence& offence : this->Result.Offences)
    {
      if (offence.Fault == BoundaryFault::Turned)
      {
        continue;
      }
      isAt[At(offence.Bite)] = 1;
      isAt[At(offence.Other == NoId ? offence.Bite : offence.Other)] = 1;
    }
    bool isChanged = false;
    this->IsByMiddle.resize(this->Labels.size(), 0);
    for (Id cell = 0; cell < mesh.NumberOfSlots() && !this->Result.Offences.empty(); ++cell)
    {
      bool isFaulty = mesh.IsTetrahedron(cell) && this->IsByMiddle[At(cell)] == 0;
      Point3 middle{};
      Id faults = 0;
      double size = Infinity;
      for (Id k = 0; k < 4 && isFaulty; ++k)
      {
        const Id vertex = mesh.Corners[At(4 * cell + k)];
        faults += isAt[At(this->BiteOf[At(vertex)])];
        middle = middle + 0.25 * mesh.PointAt(vertex);
        size = std::min(size, this->Bites.Sizes[At(this->BiteOf[At(vertex)])]);
      }
      constexpr double LeastDepth = 0.03; // flatter cells lie along the surface
      if (isFaulty && faults > 0 &&
        this->NearestTo(middle, LeastDepth * size, [](Id) { return true; }) == NoId)
      {
        const Id label = test.LabelAt(middle);
        this->IsByMiddle[At(cell)] = 1;
        isChanged = isChanged || label != this->Labels[At(cell)];
        this->Labels[At(cell)] = label;
      }
    }
    return isChanged;
  }

  /// Where the centre is far from the planes of the surface at all corners, on the same side; else
  /// NoId. No bite is in the sphere of the cell, so that the surface, which they cover, is near the
  /// sphere only.
  Id LabelByNormals(Id cell) const
  {
    constexpr double LeastSlope = 0.5;
    Id label = NoId;
    for (Id k = 0; k < 4; ++k)
    {
      const Id bite = this->BiteOf[At(this->Cells.Mesh().Corners[At(4 * cell + k)])];
      if (bite < this->Bites.NumberOnLines)
      {
        return NoId;
      }
      const Point3 apart = this->Centers[At(cell)] - this->Bites.Centers[At(bite)];
      const std::size_t triangle = At(this->Bites.Triangles[At(bite)]);
      const double height = Dot(apart, this->Ground.NormalOf(triangle));
      const TriangleSides& sides = this->Ground.Sides[At(this->Ground.Mesh.Cells[triangle])];
      const Id own = sides[height > 0.0 ? 1 : 0];
      if (std::abs(height) < LeastSlope * Length(apart) || (k > 0 && own != label))
      {
        return NoId;
      }
      label = own;
    }
    return label;
  }

  void TakeWalls()
  {
    const TetMesh& mesh = this->Cells.Mesh();
    for (Id cell = 0; cell < mesh.NumberOfSlots() && this->Beats.Beat(8); ++cell)
    {
      const Id label = this->Labels[At(cell)];
      for (Id facet = 4 * cell; facet < 4 * cell + 4 && label != 0; ++facet)
      {
        const Id other = this->Labels[At(TetMesh::CellOf(mesh.Twins[At(facet)]))];
        if (label != other && IsBehind(label, other))
        {
          this->Add(facet, this->Meet(facet), false);
          this->Result.Sides.push_back({ label, other });
        }
      }
    }
  }

  void TakeMeetings()
  {
    const TetMesh& mesh = this->Cells.Mesh();
    for (Id facet = 0; facet < 4 * mesh.NumberOfSlots() && this->Beats.Beat(64); ++facet)
    {
      const Id twin = mesh.Twins[At(facet)];
      const Id cell = TetMesh::CellOf(facet);
      if (mesh.IsTetrahedron(cell) && this->IsOfBites(facet) &&
        (facet < twin || mesh.IsGhost(TetMesh::CellOf(twin))))
      {
        const DualMeeting meeting = this->Meet(facet);
        if (meeting.Count % 2 == 1)
        {
          const Point3 normal = this->NormalOf(facet);
          this->Add(facet, meeting, Dot(normal, this->Ground.NormalOf(At(meeting.Triangle))) < 0.0);
        }
      }
    }
  }

  bool IsOfBites(Id facet) const
  {
    const TetMesh& mesh = this->Cells.Mesh();
    return this->BiteOf[At(mesh.FacetCorner(facet, 0))] != NoId &&
      this->BiteOf[At(mesh.FacetCorner(facet, 1))] != NoId &&
      this->BiteOf[At(mesh.FacetCorner(facet, 2))] != NoId;
  }

  /// The unit normal of the facet, away from its cell.
  Point3 NormalOf(Id facet) const
  {
    const TetMesh& mesh = this->Cells.Mesh();
    const Point3 normal =
      Cross(mesh.PointAt(mesh.FacetCorner(facet, 1)) - mesh.PointAt(mesh.FacetCorner(facet, 0)),
        mesh.PointAt(mesh.FacetCorner(facet, 2)) - mesh.PointAt(mesh.FacetCorner(facet, 0)));
    return (1.0 / Length(normal)) * normal;
  }

  /// Along the dual edge, which begins at the centre of the cell of the facet; near the facet.
  DualMeeting Meet(Id facet) const
  {
    const TetMesh& mesh = this->Cells.Mesh();
    const Point3 normal = this->NormalOf(facet);
    const Point3& center = this->Centers[At(TetMesh::CellOf(facet))];
    const Id first = mesh.FacetCorner(facet, 0);
    const Point3 foot = center + Dot(mesh.PointAt(first) - center, normal) * normal;
    const Id other = TetMesh::CellOf(mesh.Twins[At(facet)]);
    double reach = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const Id bite = this->BiteOf[At(mesh.FacetCorner(facet, k))];
      reach = std::max(reach, 1.5 * this->Bites.Sizes[At(bite)]);
    }
    const auto height = [&normal, &foot](const Point3& place) { return Dot(place - foot, normal); };
    const double low = height(center);
    const double high = mesh.IsTetrahedron(other) ? height(this->Centers[At(other)]) : Infinity;
    double begin = std::min(low, high);
    double end = std::max(low, high);
    DualMeeting meeting;
    meeting.Place = foot + std::min(std::max(0.0, begin), end) * normal;
    begin = std::max(begin, -reach);
    end = std::min(end, reach);
    if (begin < end)
    {
      this->MeetSegment(foot, normal, begin, end, meeting);
    }
    return meeting;
  }

  void MeetSegment(
    const Point3& foot, const Point3& normal, double begin, double end, DualMeeting& meeting) const
  {
    const Box3 box = Box3::Around(foot + begin * normal, foot + end * normal);
    double least = Infinity;
    this->Tree.AllOf(box,
      [this, &foot, &normal, begin, end, &meeting, &least](const SurfaceItem& item)
      {
        const std::array<Point3, 3> t = this->Ground.Mesh.Triangle(At(item.Triangle));
        const Point3 a = t[0] - foot;
        const Point3 b = t[1] - foot;
        const Point3 c = t[2] - foot;
        const double x = Dot(Cross(b, c), normal);
        const double y = Dot(Cross(c, a), normal);
        const double z = Dot(Cross(a, b), normal);
        const double sum = x + y + z;
        // What passes an edge passes one of its two triangles: their rounded products only differ
        // in sign, and 0 has that of the order of the ends.
        const Id* ends = &this->Ground.Mesh.Corners[3 * At(item.Triangle)];
        const bool isLeft = x > 0.0 || (x == 0.0 && ends[1] < ends[2]);
        const bool isMet = sum != 0.0 && isLeft == (y > 0.0 || (y == 0.0 && ends[2] < ends[0])) &&
          isLeft == (z > 0.0 || (z == 0.0 && ends[0] < ends[1]));
        const double height =
          isMet ? (x * Dot(a, normal) + y * Dot(b, normal) + z * Dot(c, normal)) / sum : Infinity;
        if (height >= begin && height <= end)
        {
          ++meeting.Count;
          if (std::abs(height) < least)
          {
            least = std::abs(height);
            meeting.Triangle = item.Triangle;
            meeting.Place = foot + height * normal;
          }
        }
        return true;
      });
  }

  void Add(Id facet, const DualMeeting& meeting, bool isTurned)
  {
    const TetMesh& mesh = this->Cells.Mesh();
    std::array<Id, 3> bites{};
    for (int k = 0; k < 3; ++k)
    {
      bites[At(k)] = this->BiteOf[At(mesh.FacetCorner(facet, k))];
    }
    if (isTurned)
    {
      std::swap(bites[1], bites[2]);
    }
    this->Result.Corners.insert(this->Result.Corners.end(), bites.begin(), bites.end());
    this->Result.Triangles.push_back(this->TriangleBelow(facet, meeting.Triangle, isTurned));
    this->Result.BallCenters.push_back(meeting.Place);
  }

  /// Where the dual edge meets no triangle that agrees with the facet, as near features, the
  /// nearest one that does, if it is near; else the nearest one.
  Id TriangleBelow(Id facet, Id met, bool isTurned) const
  {
    constexpr double LeastCosine = 0.5;
    constexpr double Near = 0.25; // in f
    const Point3 normal = (isTurned ? -1.0 : 1.0) * this->NormalOf(facet);
    const auto agrees = [this, &normal](Id triangle)
    { return Dot(normal, this->Ground.NormalOf(At(triangle))) >= LeastCosine; };
    if (met != NoId && agrees(met))
    {
      return met;
    }
    const Point3 middle = this->MiddleOf(facet);
    const Id bite = this->BiteOf[At(this->Cells.Mesh().FacetCorner(facet, 0))];
    const Id best = this->NearestTo(middle, Near * this->Bites.Sizes[At(bite)], agrees);
    const Id other = met != NoId ? met : this->NearestTo(middle, Infinity, [](Id) { return true; });
    return best != NoId ? best : other;
  }

  Point3 MiddleOf(Id facet) const
  {
    const TetMesh& mesh = this->Cells.Mesh();
    Point3 middle{};
    for (int k = 0; k < 3; ++k)
    {
      middle = middle + (1.0 / 3.0) * mesh.PointAt(mesh.FacetCorner(facet, k));
    }
    return middle;
  }

  /// The triangle of the ground that is nearest to the place, and nearer than `most`, of those that
  /// are wanted; or NoId.
  template <typename Question>
  Id NearestTo(const Point3& place, double most, const Question& isWanted) const
  {
    Id nearest = NoId;
    this->Tree.Search(place, 1.0, most,
      [this, &place, &nearest, &isWanted](const SurfaceItem& item, double limit)
      {
        if (!isWanted(item.Triangle))
        {
          return limit;
        }
        const std::array<Point3, 3> triangle = this->Ground.Mesh.Triangle(At(item.Triangle));
        const double distance = Distance(NearestPoint(triangle, place), place);
        nearest = distance < limit ? item.Triangle : nearest;
        return std::min(limit, distance);
      });
    return nearest;
  }

  const SurfaceGround& Ground;
  const SurfaceBites& Bites;
  const BoxTree<SurfaceItem, 3>& Tree;
  RegularTriangulation Cells;
  Pulse& Beats;
  std::vector<Id> BiteOf;               ///< of vertices
  std::vector<Point3> Centers;          ///< of cells
  std::vector<Id> Labels;               ///< of cells: the side of the surface they are on
  std::vector<std::uint8_t> IsByMiddle; ///< of cells: labelled by their middles
  SurfaceBoundary Result;
};

} // namespace

SurfaceBoundary FindBoundary(const SurfaceGround& ground, const SurfaceBites& bites,
  const BoxTree<SurfaceItem, 3>& tree, Pulse& pulse)
{
  return BoundaryFinder(ground, bites, tree, pulse).Run();
}

} // namespace biting
