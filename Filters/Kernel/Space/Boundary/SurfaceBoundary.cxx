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

#include <algorithm> // for min, max, their elements
#include <array>     // for corners
#include <cmath>     // for abs, floor
#include <utility>   // for pairs

namespace biting
{

namespace
{

/// The dual edge of a facet: foot + h normal, for h from Begin to End, near the facet.
struct DualEdge
{
  Point3 Normal; ///< of the facet, away from its cell, unit
  Point3 Foot;   ///< in its plane
  double Begin;
  double End;
};

std::array<Point3, 3> CornersOf(const TetMesh& mesh, Id facet)
{
  return { mesh.PointAt(mesh.FacetCorner(facet, 0)), mesh.PointAt(mesh.FacetCorner(facet, 1)),
    mesh.PointAt(mesh.FacetCorner(facet, 2)) };
}

Point3 MiddleOf(const TetMesh& mesh, Id facet)
{
  const auto [a, b, c] = CornersOf(mesh, facet);
  return (1.0 / 3.0) * (a + b + c);
}

/// The unit normal of the facet, away from its cell.
Point3 NormalOf(const TetMesh& mesh, Id facet)
{
  const auto [a, b, c] = CornersOf(mesh, facet);
  const Point3 normal = Cross(b - a, c - a);
  return (1.0 / Length(normal)) * normal;
}

/// Of a triangle of the input.
bool Agree(const SurfaceGround& ground, Id triangle, const Point3& normal)
{
  constexpr double LeastCosine = 0.5;
  return Dot(normal, ground.Normals[At(triangle)]) >= LeastCosine;
}

/// Corners of a cube around the box: so flat surfaces have cells on both sides. Then so many places
/// in the box.
std::vector<Point3> SpreadPoints(const Box3& box, std::size_t count)
{
  constexpr std::size_t Corners = 8;
  const double reach = 3.0 * box.Diagonal();
  std::vector<Point3> points(Corners + count);
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    // Multiples of 1/g, 1/g^2 and 1/g^3, where g^4 = g + 1: evenly spread.
    constexpr std::array<double, 3> Shares{ 0.8191725133961645, 0.6710436067037893,
      0.5497004779019703 };
    for (std::size_t d = 0; d < 3; ++d)
    {
      const double share = Shares[d] * static_cast<double>(k);
      points[k][d] = k < Corners
        ? box.Center()[d] + (((k >> d) & 1u) != 0 ? reach : -reach)
        : box.Low[d] + (share - std::floor(share)) * (box.High[d] - box.Low[d]);
    }
  }
  return points;
}

class BoundaryFinder
{
public:
  BoundaryFinder(const SurfaceMesh& input, const SurfaceGround& ground, const SurfaceBites& bites,
    const BoxTree<SurfaceItem, 3>& tree, bool hasBalls, Pulse& pulse)
    : Input(input)
    , Ground(ground)
    , Bites(bites)
    , Tree(tree)
    , HasBalls(hasBalls)
    , Beats(pulse)
  {
  }

  SurfaceBoundary Run()
  {
    this->Triangulate();
    const bool isSolid = !this->Ground.Sides.empty();
    const int rounds = isSolid ? 4 : 1;
    if (isSolid)
    {
      this->LabelCells();
    }
    for (int round = 0; round < rounds && (round == 0 || this->LabelAnew()); ++round)
    {
      this->Result = {};
      isSolid ? this->TakeWalls() : this->TakeMeetings();
      CheckBoundary(this->Ground, this->Bites, this->Result, this->Beats);
    }
    return std::move(this->Result);
  }

private:
  static constexpr std::size_t CheapSteps = 31;
  static constexpr std::size_t BitesPerFarPoint = 16;

  /// Points p farther from the surface than twice the radius R of any bite. They divide the cells
  /// across bodies, of which there are many where bites are on a sphere or around an axis.
  /// Facets between labels stay: their dual edges meet the surface where bites are within R. The
  /// centre c of a cell at p is on the side of p: if the way from p to c met the surface at x, a
  /// bite within R of x would be no nearer to c than p is, so |p - x| <= R.
  void AddFarPoints(RegularTriangulation& triangulation)
  {
    const InsideTest test(this->Input, this->Ground.Sides, this->Tree);
    const std::vector<double>& radii = this->Bites.Radii;
    const double reach = radii.empty() ? 0.0 : *std::max_element(radii.begin(), radii.end());
    const std::vector<Point3> points =
      SpreadPoints(this->Ground.Mesh.Bounds(), this->Bites.Centers.size() / BitesPerFarPoint);
    for (const Id k : SpatialOrder(points, this->Beats))
    {
      if (!this->Beats.Beat(64))
      {
        return;
      }
      const Point3& place = points[At(k)];
      if (NearestTriangle(this->Input, this->Tree, place, 2.0 * reach).first == NoId &&
        triangulation.Insert(place).What != PointOutcome::Duplicate)
      {
        this->FarLabels.push_back(this->Ground.Sides.empty() ? 0 : test.LabelAt(place));
        this->BiteOf.push_back(NoId);
      }
    }
  }

  void Triangulate()
  {
    RegularTriangulation triangulation(this->Bites.NumberOnLines > 0);
    constexpr double CellsPerPoint = 5.0; // on surfaces
    const std::size_t bites = this->Bites.Centers.size();
    triangulation.Reserve(bites + bites / BitesPerFarPoint + 8, CellsPerPoint);
    this->AddFarPoints(triangulation);
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

  /// The power center of a tetrahedron.
  Point3 CenterOf(Id cell) const
  {
    const auto corner = [this, cell](Id k) -> WeightedPoint
    {
      const Id vertex = this->Cells.Corners[At(4 * cell + k)];
      return { this->Cells.PointAt(vertex), this->Cells.WeightAt(vertex) };
    };
    return corner(0).Place + PowerCenter(corner(0), corner(1), corner(2), corner(3));
  }

  void LabelCells()
  {
    const InsideTest test(this->Input, this->Ground.Sides, this->Tree);
    this->Labels.assign(At(this->Cells.NumberOfSlots()), 0);
    ForRowsAtOnce(this->Beats, this->Labels.size(), CheapSteps,
      [this, &test](std::size_t begin, std::size_t end)
      {
        for (Id cell = static_cast<Id>(begin); cell < static_cast<Id>(end); ++cell)
        {
          if (this->Cells.IsTetrahedron(cell))
          {
            this->Labels[At(cell)] = this->LabelOf(cell, test);
          }
        }
      });
  }

  /// Of a cell at a far point its label, else that of the centre: by the planes of the surface at
  /// all corners where it is far from them, on the same side. No bite is in the sphere of the cell,
  /// so that the surface, which they cover, is near the sphere only.
  Id LabelOf(Id cell, const InsideTest& test) const
  {
    constexpr double LeastSlope = 0.5;
    const Id* corners = &this->Cells.Corners[At(4 * cell)];
    const std::size_t first = At(*std::min_element(corners, corners + 4));
    if (first < this->FarLabels.size())
    {
      return this->FarLabels[first];
    }
    const Point3 center = this->CenterOf(cell);
    Id label = NoId;
    bool isClear = true;
    for (Id k = 0; k < 4 && isClear; ++k)
    {
      const Id bite = this->BiteOf[At(corners[k])];
      const Point3 apart = center - this->Bites.Centers[At(bite)];
      const std::size_t triangle = At(this->Bites.Triangles[At(bite)]);
      const double height = Dot(apart, this->Ground.NormalOf(triangle));
      const TriangleSides& sides = this->Ground.Sides[At(this->Ground.Mesh.Cells[triangle])];
      const Id own = sides[height > 0.0 ? 1 : 0];
      isClear = bite >= this->Bites.NumberOnLines && (k == 0 || own == label) &&
        std::abs(height) >= LeastSlope * Length(apart);
      label = own;
    }
    return isClear ? label : test.LabelAt(center);
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
      const Id other = offence.Other == NoId ? offence.Bite : offence.Other;
      const bool isTurned = offence.Fault == BoundaryFault::Turned;
      isAt[At(offence.Bite)] |= isTurned ? 0 : 1;
      isAt[At(other)] |= isTurned ? 0 : 1;
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
        const Id bite = this->BiteOf[At(vertex)];
        isFaulty = bite != NoId;
        faults += isFaulty ? isAt[At(bite)] : 0;
        middle = middle + 0.25 * mesh.PointAt(vertex);
        size = std::min(size, isFaulty ? this->Bites.Sizes[At(bite)] : 0.0);
      }
      constexpr double LeastDepth = 0.03; // flatter cells lie along the surface
      if (isFaulty && faults > 0 &&
        NearestTriangle(this->Input, this->Tree, middle, LeastDepth * size).first == NoId)
      {
        const Id label = test.LabelAt(middle);
        this->IsByMiddle[At(cell)] = 1;
        isChanged = isChanged || label != this->Labels[At(cell)];
        this->Labels[At(cell)] = label;
      }
    }
    return isChanged;
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
        const Id met = isFound ? near : this->Meet(dual).first;
        this->Put(
          facet, isFound ? near : this->TriangleBelow(facet, met, dual.Normal), false, place);
        this->Result.Sides[place] = { labelOf(facet), labelOf(mesh.Twins[At(facet)]) };
        if (this->HasBalls)
        {
          this->Result.BallCenters[place] = this->BallCenter(dual, met);
        }
      });
  }

  /// NoId: far points.
  std::array<Id, 3> BitesOf(Id facet) const
  {
    const auto bite = [this, facet](int k)
    { return this->BiteOf[At(this->Cells.FacetCorner(facet, k))]; };
    return { bite(0), bite(1), bite(2) };
  }

  void TakeMeetings()
  {
    const TetMesh& mesh = this->Cells;
    // A facet with a longer side has no dual edge near the surface, of which each place is nearer
    // to a bite.
    this->TakeFacets(
      [this, &mesh](Id facet)
      {
        const Id twin = mesh.Twins[At(facet)];
        const auto [a, b, c] = CornersOf(mesh, facet);
        return (facet < twin || mesh.IsGhost(TetMesh::CellOf(twin))) &&
          std::max({ Distance(a, b), Distance(b, c), Distance(c, a) }) <=
          2.0 * this->ReachOf(facet) &&
          this->MeetOnce(facet, this->DualOf(facet)) != NoId;
      },
      [this](Id facet, std::size_t place)
      {
        const DualEdge dual = this->DualOf(facet);
        const Id met = this->MeetOnce(facet, dual);
        const bool isTurned = Dot(dual.Normal, this->Ground.Normals[At(met)]) < 0.0;
        const Id below = this->TriangleBelow(facet, met, (isTurned ? -1.0 : 1.0) * dual.Normal);
        this->Put(facet, below, isTurned, place);
      });
  }

  /// The triangle that the dual edge of the facet meets; NoId if it meets an even number. That of a
  /// facet between lines may pass beside a border: it meets the triangle at the facet's middle if
  /// it meets the plane of that.
  Id MeetOnce(Id facet, const DualEdge& dual) const
  {
    const auto [a, b, c] = this->BitesOf(facet);
    const bool isBetween = std::max({ a, b, c }) < this->Bites.NumberOnLines;
    const double reach = this->ReachOf(facet);
    const DualEdge middle{ dual.Normal, MiddleOf(this->Cells, facet), -reach, reach };
    const auto [met, count] = this->Meet(isBetween ? middle : dual);
    if (met == NoId || !isBetween)
    {
      return count % 2 == 1 ? met : NoId;
    }
    const LineMeeting line(this->Input.Triangle(At(met)), dual);
    const double height = line.Rise / line.Sum;
    return height >= dual.Begin && height <= dual.End ? met : NoId;
  }

  /// Takes the facets of tetrahedra and bites for which isWall(facet), in their order:
  /// put(facet, place).
  template <typename Question, typename Step>
  void TakeFacets(const Question& isWall, const Step& put)
  {
    constexpr std::size_t CellsPerTask = 512;
    const TetMesh& mesh = this->Cells;
    const std::size_t cells = At(mesh.NumberOfSlots());
    const auto isOfBites = [this](Id facet)
    {
      const auto [a, b, c] = this->BitesOf(facet);
      return std::min({ a, b, c }) != NoId;
    };
    std::vector<std::vector<Id>> parts((cells + CellsPerTask - 1) / CellsPerTask);
    DoTasks(this->Beats, parts.size(),
      [&mesh, &isOfBites, &isWall, &parts, cells](std::size_t k, Monitor&)
      {
        const std::size_t end = std::min(cells, (k + 1) * CellsPerTask);
        for (Id facet = static_cast<Id>(4 * k * CellsPerTask); facet < static_cast<Id>(4 * end);
             ++facet)
        {
          if (mesh.IsTetrahedron(TetMesh::CellOf(facet)) && isOfBites(facet) && isWall(facet))
          {
            parts[k].push_back(facet);
          }
        }
      });
    std::vector<Id> facets;
    for (const std::vector<Id>& part : parts)
    {
      facets.insert(facets.end(), part.begin(), part.end());
    }
    this->Result.Corners.resize(3 * facets.size());
    this->Result.Triangles.resize(facets.size());
    this->Result.Sides.resize(facets.size());
    this->Result.BallCenters.resize(this->HasBalls ? facets.size() : 0);
    ForRowsAtOnce(this->Beats, facets.size(), CheapSteps,
      [&put, &facets](std::size_t begin, std::size_t end)
      {
        for (std::size_t place = begin; place < end; ++place)
        {
          put(facets[place], place);
        }
      });
  }

  /// Of the bites of the facet: the farthest that its dual edge is followed beyond it.
  double ReachOf(Id facet) const
  {
    double reach = 0.0;
    for (const Id bite : this->BitesOf(facet))
    {
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
    const Point3 foot = center + Dot(CornersOf(mesh, facet)[0] - center, normal) * normal;
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
    const auto [a, b, c] = this->BitesOf(facet);
    const Id bite = std::max({ a, b, c });
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

  /// The triangle of the input where the dual edge meets the surface nearest to the facet, or NoId;
  /// and how often it meets it.
  std::pair<Id, Id> Meet(const DualEdge& dual) const
  {
    std::pair<Id, Id> meeting{ NoId, 0 };
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
          ++meeting.second;
          if (std::abs(height) < least)
          {
            least = std::abs(height);
            meeting.first = item.Triangle;
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
    const auto [first, second, third] = this->BitesOf(facet);
    Id* const bites = &this->Result.Corners[3 * place];
    bites[0] = first;
    bites[1] = isTurned ? third : second;
    bites[2] = isTurned ? second : third;
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
    const Id best = NearestTriangle(this->Input, this->Tree, middle,
      Near * this->Bites.Sizes[At(bite)],
      [this, &normal](Id triangle) {
        return Agree(this->Ground, triangle, normal);
      }).first;
    const Id other =
      met != NoId ? met : NearestTriangle(this->Input, this->Tree, middle, Infinity).first;
    return best != NoId ? best : other;
  }

  const SurfaceMesh& Input;
  const SurfaceGround& Ground;
  const SurfaceBites& Bites;
  const BoxTree<SurfaceItem, 3>& Tree; ///< of the input
  const bool HasBalls;
  TetMesh Cells; ///< their regular triangulation
  Pulse& Beats;
  std::vector<Id> BiteOf;               ///< of vertices
  std::vector<Id> FarLabels;            ///< of the first vertices, which are far points
  std::vector<Id> Labels;               ///< of cells: the side of the surface they are on
  std::vector<std::uint8_t> IsByMiddle; ///< of cells: labelled by their middles
  SurfaceBoundary Result;
};

} // namespace

SurfaceBoundary FindBoundary(const SurfaceMesh& input, const SurfaceGround& ground,
  const SurfaceBites& bites, const BoxTree<SurfaceItem, 3>& tree, bool hasBalls, Pulse& pulse)
{
  return BoundaryFinder(input, ground, bites, tree, hasBalls, pulse).Run();
}

} // namespace biting
