// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceBoundary.h"

#include "../../Base/Numbers.h"
#include "../../Base/Tasks.h"
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
  Id Triangle = NoId; ///< of the input, nearest to the facet; NoId: nowhere
  Id Count = 0;
};

/// The dual edge of a facet: foot + h normal, for h from Begin to End, near the facet.
struct DualEdge
{
  Point3 Normal; ///< of the facet, away from its cell, unit
  Point3 Foot;   ///< in its plane
  double Begin;
  double End;
};

/// The unit normal of the facet, away from its cell.
Point3 NormalOf(const TetMesh& mesh, Id facet)
{
  const Point3& first = mesh.PointAt(mesh.FacetCorner(facet, 0));
  const Point3 normal = Cross(mesh.PointAt(mesh.FacetCorner(facet, 1)) - first,
    mesh.PointAt(mesh.FacetCorner(facet, 2)) - first);
  return (1.0 / Length(normal)) * normal;
}

Point3 MiddleOf(const TetMesh& mesh, Id facet)
{
  Point3 middle{};
  for (int k = 0; k < 3; ++k)
  {
    middle = middle + (1.0 / 3.0) * mesh.PointAt(mesh.FacetCorner(facet, k));
  }
  return middle;
}

/// Of a triangle of the input.
bool Agree(const SurfaceGround& ground, Id triangle, const Point3& normal)
{
  constexpr double LeastCosine = 0.5;
  return Dot(normal, ground.Normals[At(triangle)]) >= LeastCosine;
}

class BoundaryFinder
{
public:
  BoundaryFinder(const SurfaceMesh& input, const SurfaceGround& ground, const SurfaceBites& bites,
    const BoxTree<SurfaceItem, 3>& tree, Pulse& pulse)
    : Input(input)
    , Ground(ground)
    , Bites(bites)
    , Tree(tree)
    , Beats(pulse)
  {
  }

  SurfaceBoundary Run()
  {
    const bool isSolid = !this->Ground.Sides.empty();
    this->Triangulate(isSolid);
    if (isSolid)
    {
      this->LabelCells();
      this->TakeWalls();
    }
    else
    {
      this->TakeMeetings();
    }
    CheckBoundary(this->Ground, this->Bites, this->Result, this->Beats);
    constexpr int MostRounds = 3;
    for (int round = 0; isSolid && round < MostRounds && this->LabelAnew(); ++round)
    {
      this->Result = {};
      this->TakeWalls();
      CheckBoundary(this->Ground, this->Bites, this->Result, this->Beats);
    }
    return std::move(this->Result);
  }

private:
  /// Corners of a cube around all: so flat surfaces have cells on both sides.
  void AddFrame(RegularTriangulation& triangulation)
  {
    const Box3 box = this->Ground.Mesh.Bounds();
    const double reach = 3.0 * box.Diagonal();
    for (int corner = 0; corner < 8; ++corner)
    {
      const Point3 way{ (corner & 1) != 0 ? reach : -reach, (corner & 2) != 0 ? reach : -reach,
        (corner & 4) != 0 ? reach : -reach };
      triangulation.Insert(box.Center() + way);
      this->BiteOf.push_back(NoId);
    }
  }

  void Triangulate(bool isSolid)
  {
    RegularTriangulation triangulation(this->Bites.NumberOnLines > 0);
    triangulation.Reserve(this->Bites.Centers.size());
    if (!isSolid)
    {
      this->AddFrame(triangulation);
    }
    const std::vector<Id> order = SpatialOrder(this->Bites.Centers, this->Beats);
    this->BiteOf.reserve(order.size());
    for (const Id bite : order)
    {
      if (!this->Beats.Beat(64))
      {
        return;
      }
      const PointInsertion made =
        triangulation.Insert(this->Bites.Centers[At(bite)], this->Bites.WeightOf(bite));
      if (made.What != PointOutcome::Duplicate)
      {
        this->BiteOf.push_back(bite);
      }
    }
    this->Cells = triangulation.TakeMesh();
  }

  WeightedPoint CornerAt(Id cell, Id k) const
  {
    const Id vertex = this->Cells.Corners[At(4 * cell + k)];
    return { this->Cells.PointAt(vertex), this->Cells.WeightAt(vertex) };
  }

  /// The power center of a tetrahedron.
  Point3 CenterOf(Id cell) const
  {
    const WeightedPoint first = this->CornerAt(cell, 0);
    return first.Place +
      PowerCenter(first, this->CornerAt(cell, 1), this->CornerAt(cell, 2), this->CornerAt(cell, 3));
  }

  void LabelCells()
  {
    constexpr std::size_t CheapSteps = 31;
    const InsideTest test(this->Input, this->Ground.Sides, this->Tree);
    this->Labels.assign(At(this->Cells.NumberOfSlots()), 0);
    ForRowsAtOnce(this->Beats, this->Labels.size(), CheapSteps,
      [this, &test](std::size_t begin, std::size_t end)
      {
        for (Id cell = static_cast<Id>(begin); cell < static_cast<Id>(end); ++cell)
        {
          if (this->Cells.IsTetrahedron(cell))
          {
            const Point3 center = this->CenterOf(cell);
            const Id label = this->LabelByNormals(cell, center);
            this->Labels[At(cell)] = label != NoId ? label : test.LabelAt(center);
          }
        }
      });
  }

  /// Labels cells at bites with faults by their middles. In a wedge or a wall too thin for f power
  /// centres are beyond the other side, but middles are not. Whether a label changes.
  bool LabelAnew()
  {
    const InsideTest test(this->Input, this->Ground.Sides, this->Tree);
    const TetMesh& mesh = this->Cells;
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
    for (Id cell = 0;
         cell < mesh.NumberOfSlots() && !this->Result.Offences.empty() && this->Beats.Beat();
         ++cell)
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
  Id LabelByNormals(Id cell, const Point3& center) const
  {
    constexpr double LeastSlope = 0.5;
    Id label = NoId;
    for (Id k = 0; k < 4; ++k)
    {
      const Id bite = this->BiteOf[At(this->Cells.Corners[At(4 * cell + k)])];
      if (bite < this->Bites.NumberOnLines)
      {
        return NoId;
      }
      const Point3 apart = center - this->Bites.Centers[At(bite)];
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
    const TetMesh& mesh = this->Cells;
    const auto labelOf = [this](Id facet) { return this->Labels[At(TetMesh::CellOf(facet))]; };
    this->TakeFacets(
      [&mesh, &labelOf](Id facet)
      {
        const Id label = labelOf(facet);
        const Id other = label == 0 ? 0 : labelOf(mesh.Twins[At(facet)]);
        return label != other && IsBehind(label, other);
      },
      [this, &mesh, &labelOf](Id facet, std::size_t place)
      {
        const DualEdge dual = this->DualOf(facet);
        const Id near = this->WalkTo(facet, dual);
        const bool isFound = near != NoId && Agree(this->Ground, near, dual.Normal);
        const Id met = isFound ? near : this->Meet(dual).Triangle;
        this->Put(
          facet, isFound ? near : this->TriangleBelow(facet, met, dual.Normal), false, place);
        this->Result.Sides[place] = { labelOf(facet), labelOf(mesh.Twins[At(facet)]) };
        this->Result.BallCenters[place] = this->BallCenter(dual, met);
      });
  }

  void TakeMeetings()
  {
    const TetMesh& mesh = this->Cells;
    // A facet with a longer side has no dual edge near the surface, of which each place is nearer
    // to a bite.
    const auto isSmall = [this, &mesh](Id facet)
    {
      const auto side = [&mesh, facet](int a, int b)
      {
        return Distance(
          mesh.PointAt(mesh.FacetCorner(facet, a)), mesh.PointAt(mesh.FacetCorner(facet, b)));
      };
      return std::max(std::max(side(0, 1), side(1, 2)), side(2, 0)) <= 2.0 * this->ReachOf(facet);
    };
    this->TakeFacets(
      [this, &mesh, &isSmall](Id facet)
      {
        const Id twin = mesh.Twins[At(facet)];
        const auto isOfFrame = [this, &mesh, facet](int k)
        { return this->BiteOf[At(mesh.FacetCorner(facet, k))] == NoId; };
        return !isOfFrame(0) && !isOfFrame(1) && !isOfFrame(2) &&
          (facet < twin || mesh.IsGhost(TetMesh::CellOf(twin))) && isSmall(facet) &&
          this->Meet(this->DualOf(facet)).Count % 2 == 1;
      },
      [this](Id facet, std::size_t place)
      {
        const DualEdge dual = this->DualOf(facet);
        const Id met = this->Meet(dual).Triangle;
        const bool isTurned = Dot(dual.Normal, this->Ground.Normals[At(met)]) < 0.0;
        const Id below = this->TriangleBelow(facet, met, (isTurned ? -1.0 : 1.0) * dual.Normal);
        this->Put(facet, below, isTurned, place);
      });
  }

  /// Takes the facets of tetrahedra for which isWall(facet), in their order: put(facet, place).
  template <typename Question, typename Step>
  void TakeFacets(const Question& isWall, const Step& put)
  {
    constexpr std::size_t CellsPerTask = 512;
    const TetMesh& mesh = this->Cells;
    const std::size_t cells = At(mesh.NumberOfSlots());
    std::vector<std::vector<Id>> parts((cells + CellsPerTask - 1) / CellsPerTask);
    DoTasks(this->Beats, parts.size(),
      [&mesh, &isWall, &parts, cells](std::size_t k, Monitor&)
      {
        const std::size_t end = std::min(cells, (k + 1) * CellsPerTask);
        for (Id facet = static_cast<Id>(4 * k * CellsPerTask); facet < static_cast<Id>(4 * end);
             ++facet)
        {
          if (mesh.IsTetrahedron(TetMesh::CellOf(facet)) && isWall(facet))
          {
            parts[k].push_back(facet);
          }
        }
      });
    std::vector<std::size_t> begins(1, 0); // of parts
    for (const std::vector<Id>& part : parts)
    {
      begins.push_back(begins.back() + part.size());
    }
    const std::size_t facets = begins.back();
    this->Result.Corners.resize(3 * facets);
    this->Result.Triangles.resize(facets);
    this->Result.Sides.resize(facets);
    this->Result.BallCenters.resize(facets);
    DoTasks(this->Beats, parts.size(),
      [&put, &parts, &begins](std::size_t k, Monitor&)
      {
        for (std::size_t i = 0; i < parts[k].size(); ++i)
        {
          put(parts[k][i], begins[k] + i);
        }
      });
  }

  /// Of the bites of the facet: the farthest that its dual edge is followed beyond it.
  double ReachOf(Id facet) const
  {
    double reach = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const Id bite = this->BiteOf[At(this->Cells.FacetCorner(facet, k))];
      reach = std::max(reach, 1.5 * this->Bites.Sizes[At(bite)]);
    }
    return reach;
  }

  /// It begins at the centre of the cell of the facet.
  DualEdge DualOf(Id facet) const
  {
    const TetMesh& mesh = this->Cells;
    const Point3 normal = NormalOf(mesh, facet);
    const Point3 center = this->CenterOf(TetMesh::CellOf(facet));
    const Id first = mesh.FacetCorner(facet, 0);
    const Point3 foot = center + Dot(mesh.PointAt(first) - center, normal) * normal;
    const Id other = TetMesh::CellOf(mesh.Twins[At(facet)]);
    const double reach = this->ReachOf(facet);
    const auto height = [&normal, &foot](const Point3& place) { return Dot(place - foot, normal); };
    const double low = height(center);
    const double high = mesh.IsTetrahedron(other) ? height(this->CenterOf(other)) : Infinity;
    return { normal, foot, std::max(std::min(low, high), -reach),
      std::min(std::max(low, high), reach) };
  }

  /// Twice the areas of the triangle's parts opposite its corners, as cut by the line of the dual
  /// edge; and the line's height where it meets its plane, times their sum.
  struct LineMeeting
  {
    LineMeeting(const std::array<Point3, 3>& t, const DualEdge& dual)
    {
      const Point3 a = t[0] - dual.Foot;
      const Point3 b = t[1] - dual.Foot;
      const Point3 c = t[2] - dual.Foot;
      this->Parts = { Dot(Cross(b, c), dual.Normal), Dot(Cross(c, a), dual.Normal),
        Dot(Cross(a, b), dual.Normal) };
      this->Sum = this->Parts[0] + this->Parts[1] + this->Parts[2];
      this->Rise = this->Parts[0] * Dot(a, dual.Normal) + this->Parts[1] * Dot(b, dual.Normal) +
        this->Parts[2] * Dot(c, dual.Normal);
    }

    std::array<double, 3> Parts;
    double Sum;
    double Rise;
  };

  /// The triangle that the dual edge meets, by a walk over the patch of a bite of the facet; NoId
  /// where it leaves the patch, or meets the plane of the last triangle elsewhere.
  Id WalkTo(Id facet, const DualEdge& dual) const
  {
    constexpr int MostSteps = 32;
    Id bite = NoId;
    for (int k = 0; k < 3; ++k)
    {
      bite = std::max(bite, this->BiteOf[At(this->Cells.FacetCorner(facet, k))]);
    }
    Id triangle = bite < this->Bites.NumberOnLines ? NoId : this->Bites.Triangles[At(bite)];
    for (int step = 0; step < MostSteps && triangle != NoId; ++step)
    {
      const LineMeeting line(this->Ground.Mesh.Triangle(At(triangle)), dual);
      std::size_t worst = 0;
      for (std::size_t k = 0; k < 3; ++k)
      {
        worst = line.Parts[k] * line.Sum < line.Parts[worst] * line.Sum ? k : worst;
      }
      const double height = line.Rise / line.Sum;
      if (line.Parts[worst] * line.Sum >= 0.0)
      {
        return height >= dual.Begin && height <= dual.End ? this->Ground.Mesh.Cells[At(triangle)]
                                                          : NoId;
      }
      const Id across = this->Ground.Across[3 * At(triangle) + worst];
      triangle = across == NoId ? NoId : across / 3;
    }
    return NoId;
  }

  DualMeeting Meet(const DualEdge& dual) const
  {
    DualMeeting meeting;
    if (!(dual.Begin < dual.End))
    {
      return meeting;
    }
    const Box3 box =
      Box3::Around(dual.Foot + dual.Begin * dual.Normal, dual.Foot + dual.End * dual.Normal);
    double least = Infinity;
    this->Tree.AllOf(box,
      [this, &dual, &meeting, &least](const SurfaceItem& item)
      {
        const LineMeeting line(this->Input.Triangle(At(item.Triangle)), dual);
        // What passes an edge passes one of its two triangles: their rounded products only differ
        // in sign, and 0 has that of the order of the ends.
        const Id* ends = &this->Input.Corners[3 * At(item.Triangle)];
        const auto isLeft = [&line, ends](std::size_t k) {
          return line.Parts[k] > 0.0 ||
            (line.Parts[k] == 0.0 && ends[(k + 1) % 3] < ends[(k + 2) % 3]);
        };
        const bool isMet = line.Sum != 0.0 && isLeft(0) == isLeft(1) && isLeft(0) == isLeft(2);
        const double height = isMet ? line.Rise / line.Sum : Infinity;
        if (height >= dual.Begin && height <= dual.End)
        {
          ++meeting.Count;
          if (std::abs(height) < least)
          {
            least = std::abs(height);
            meeting.Triangle = item.Triangle;
          }
        }
        return true;
      });
    return meeting;
  }

  /// Where the dual edge meets the triangle; NoId: its place nearest to the facet.
  Point3 BallCenter(const DualEdge& dual, Id triangle) const
  {
    double height = dual.Begin > 0.0 ? dual.Begin : std::min(dual.End, 0.0);
    if (triangle != NoId)
    {
      const LineMeeting line(this->Input.Triangle(At(triangle)), dual);
      height = std::min(std::max(line.Rise / line.Sum, dual.Begin), dual.End);
    }
    return dual.Foot + height * dual.Normal;
  }

  /// `below`: the triangle of the input.
  void Put(Id facet, Id below, bool isTurned, std::size_t place)
  {
    Id* const bites = &this->Result.Corners[3 * place];
    for (int k = 0; k < 3; ++k)
    {
      bites[k] = this->BiteOf[At(this->Cells.FacetCorner(facet, k))];
    }
    if (isTurned)
    {
      std::swap(bites[1], bites[2]);
    }
    this->Result.Triangles[place] = below;
  }

  /// Where the dual edge meets no triangle that agrees with the facet's normal, as near features,
  /// the nearest one that does, if it is near; else the nearest one.
  Id TriangleBelow(Id facet, Id met, const Point3& normal) const
  {
    constexpr double Near = 0.25; // in f
    if (met != NoId && Agree(this->Ground, met, normal))
    {
      return met;
    }
    const Point3 middle = MiddleOf(this->Cells, facet);
    const Id bite = this->BiteOf[At(this->Cells.FacetCorner(facet, 0))];
    const Id best = this->NearestTo(middle, Near * this->Bites.Sizes[At(bite)],
      [this, &normal](Id triangle) { return Agree(this->Ground, triangle, normal); });
    const Id other = met != NoId ? met : this->NearestTo(middle, Infinity, [](Id) { return true; });
    return best != NoId ? best : other;
  }

  /// The triangle of the input that is nearest to the place, and nearer than `most`, of those that
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
        const std::array<Point3, 3> triangle = this->Input.Triangle(At(item.Triangle));
        const double distance = Distance(NearestPoint(triangle, place), place);
        nearest = distance < limit ? item.Triangle : nearest;
        return std::min(limit, distance);
      });
    return nearest;
  }

  const SurfaceMesh& Input;
  const SurfaceGround& Ground;
  const SurfaceBites& Bites;
  const BoxTree<SurfaceItem, 3>& Tree; ///< of the input
  TetMesh Cells;                       ///< their regular triangulation
  Pulse& Beats;
  std::vector<Id> BiteOf;               ///< of vertices
  std::vector<Id> Labels;               ///< of cells: the side of the surface they are on
  std::vector<std::uint8_t> IsByMiddle; ///< of cells: labelled by their middles
  SurfaceBoundary Result;
};

} // namespace

SurfaceBoundary FindBoundary(const SurfaceMesh& input, const SurfaceGround& ground,
  const SurfaceBites& bites, const BoxTree<SurfaceItem, 3>& tree, Pulse& pulse)
{
  return BoundaryFinder(input, ground, bites, tree, pulse).Run();
}

} // namespace biting
