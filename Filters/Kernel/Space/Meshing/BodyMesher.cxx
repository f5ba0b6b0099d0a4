// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BodyMesher.h"

#include "../../Base/DisjointSets.h"
#include "../../Base/Tasks.h"
#include "../Boundary/BodySides.h"
#include "../Boundary/InsideTest.h"
#include "../Boundary/WholeCheck.h"
#include "../Delaunay/SpaceTriangulation.h"
#include "../Finishing/BodyRelaxation.h"
#include "BodyCells.h"
#include "BodyCheck.h"
#include "CertifiedSurface.h"

#include <algorithm> // for min, max, sort
#include <cmath>     // for sqrt
#include <utility>   // for move, pairs

namespace biting
{

namespace
{

/// A bite of the boundary whose f was lowered, as an item of a BoxTree.
struct SmallBite
{
  Point3 Center;
  double Size;

  Box3 Box() const { return Box3::Around(this->Center, this->Center); }
  double Least() const { return this->Size; }
};

/// f in a body: as given, and no more than that of any bite of the boundary allows at its distance.
class BodySpacing
{
public:
  BodySpacing(const std::function<double(const Point3&)>& given, const SurfaceBites& bites,
    double gradation, Pulse& pulse)
    : Given(given)
    , Slope(gradation)
  {
    std::vector<SmallBite> small;
    for (std::size_t bite = 0; bite < bites.Centers.size(); ++bite)
    {
      if (bites.Sizes[bite] < given(bites.Centers[bite]))
      {
        small.push_back({ bites.Centers[bite], bites.Sizes[bite] });
      }
    }
    this->Tree = BoxTree<SmallBite, 3>(small, pulse);
  }

  double operator()(const Point3& place) const
  {
    double size = this->Given(place);
    this->Tree.Search(place, this->Slope, size,
      [this, &place, &size](const SmallBite& bite, double)
      {
        size = std::min(size, bite.Size + this->Slope * Distance(bite.Center, place));
        return size;
      });
    return size;
  }

private:
  std::function<double(const Point3&)> Given;
  double Slope;
  BoxTree<SmallBite, 3> Tree;
};

class BodyMesher
{
public:
  BodyMesher(const CheckedSurface& surface, const BodyMesherOptions& options, ProblemList& problems,
    Monitor& monitor)
    : Surface(surface)
    , Options(options)
    , Problems(problems)
    , Listener(monitor)
  {
  }

  BitingBody Run()
  {
    BitingBody mesh;
    if (this->FindSides() && this->Certify() && this->FitsLimit() && this->FillInside() &&
      this->FindCells() && this->Relax())
    {
      mesh = this->Finish();
    }
    Pulse pulse(this->Listener);
    return MayGoOn(this->Problems, pulse) ? mesh : BitingBody();
  }

private:
  static constexpr double LargestOfTetrahedra = 1.4142135623730951; ///< vertices in f^3, about

  Id NumberOnBoundary() const { return this->Certified.Bites.Size(); }

  bool Refuse(ProblemCode code, const Point3& place, const std::string& detail)
  {
    this->Problems.Add({ code, {}, place, detail });
    return false;
  }

  bool RefuseSize()
  {
    return this->Refuse(ProblemCode::TooManyVertices, {},
      "more than " + std::to_string(this->Options.Surface.MaximumNumberOfVertices) + " vertices");
  }

  /// What each triangle has on both sides.
  bool FindSides()
  {
    Pulse pulse(this->Listener);
    this->Bodies = FindBodies(this->Surface.Mesh, this->Options.Surface.Regions, pulse);
    const Id open = this->Bodies.OpenTriangle;
    if (open != NoId && MayGoOn(this->Problems, pulse))
    {
      this->Refuse(ProblemCode::OpenEdges, this->Surface.Mesh.Middle(At(open)),
        "it has the same part of space on both sides");
    }
    return MayGoOn(this->Problems, pulse);
  }

  bool Certify()
  {
    return CertifySurface(this->Surface, this->Options.Surface, this->Bodies.Sides, this->Certified,
      this->Problems, this->Listener);
  }

  /// About how many vertices there will be inside: the integral of sqrt(2) / f^3, by samples.
  bool FitsLimit()
  {
    constexpr std::size_t Samples = 24; // along each side of the box
    const Box3 box = this->Surface.Mesh.Bounds();
    const InsideTest test(this->Certified.Ground, this->Certified.Tree);
    std::vector<double> densities(Samples * Samples * Samples, 0.0);
    Pulse pulse(this->Listener);
    ForRowsAtOnce(pulse, Samples * Samples, 256 * Samples,
      [this, &box, &test, &densities](std::size_t begin, std::size_t end)
      {
        for (std::size_t k = begin * Samples; k < end * Samples; ++k)
        {
          const std::array<std::size_t, 3> steps{ k % Samples, k / Samples % Samples,
            k / Samples / Samples };
          Point3 place;
          for (std::size_t d = 0; d < 3; ++d)
          {
            const double share = (static_cast<double>(steps[d]) + 0.5) / Samples;
            place[d] = box.Low[d] + share * box.Size(d);
          }
          const double size = this->Certified.Spacing(place);
          densities[k] = test.LabelAt(place) != 0 ? 1.0 / (size * size * size) : 0.0;
        }
      });
    const double cell =
      box.Size(0) * box.Size(1) * box.Size(2) / static_cast<double>(densities.size());
    double expected = 0.0;
    for (const double density : densities)
    {
      expected += LargestOfTetrahedra * cell * density;
    }
    // Samples of a graded f are off.
    constexpr double Surely = 2.0;
    const auto most = static_cast<double>(this->Options.Surface.MaximumNumberOfVertices);
    return expected > Surely * most ? this->RefuseSize() : MayGoOn(this->Problems, pulse);
  }

  bool FillInside()
  {
    this->Listener.BeginStage("Biting inside");
    Pulse pulse(this->Listener);
    const SurfaceBites& bites = this->Certified.Bites;
    const InsideTest test(this->Certified.Ground, this->Certified.Tree);
    BodyBoundary boundary;
    boundary.Centers = bites.Centers;
    boundary.Sizes = bites.Sizes;
    for (Id bite = 0; bite < bites.Size(); ++bite)
    {
      this->Weights.push_back(bites.WeightOf(bite));
    }
    boundary.Weights = this->Weights;
    boundary.Facets = this->Certified.Boundary.Corners;
    for (std::size_t facet = 0; facet < this->Certified.Boundary.BallCenters.size(); ++facet)
    {
      boundary.Balls.push_back(this->BallOf(facet));
    }
    boundary.IsInside = [&test](const Point3& place) { return test.LabelAt(place) != 0; };
    this->Spacing =
      BodySpacing(this->Certified.Spacing, bites, this->Options.Surface.Gradation, pulse);
    boundary.Spacing = this->Spacing;
    const auto most = static_cast<std::size_t>(
      std::max<std::int64_t>(0, this->Options.Surface.MaximumNumberOfVertices - bites.Size()));
    const auto wanted = static_cast<std::size_t>(
      std::max<std::int64_t>(0, this->Options.MaximumNumberOfBites - bites.Size()));
    const bool isLimited = this->Options.MaximumNumberOfBites > 0;
    this->Inside =
      BiteInterior(boundary, this->Options.Shape, isLimited ? std::min(wanted, most) : most, pulse);
    return this->Inside.Centers.size() > most && !(isLimited && wanted < most)
      ? this->RefuseSize()
      : MayGoOn(this->Problems, pulse);
  }

  EmptyBall BallOf(std::size_t facet) const
  {
    constexpr double Rounding = 1.0 + 1e-7;
    const Point3& center = this->Certified.Boundary.BallCenters[facet];
    const Id corner = this->Certified.Boundary.Corners[3 * facet];
    const Point3 apart = center - this->Certified.Bites.Centers[At(corner)];
    const double power = Dot(apart, apart) - this->Weights[At(corner)];
    return { center, Rounding * std::sqrt(std::max(0.0, power)) };
  }

  /// The tetrahedra. Where a facet is missing, bites in its ball go.
  bool FindCells()
  {
    this->Listener.BeginStage("Triangulating");
    Pulse pulse(this->Listener);
    const SurfaceBoundary& boundary = this->Certified.Boundary;
    constexpr int MostRounds = 8;
    BodyCells cells;
    for (int round = 0; round < MostRounds; ++round)
    {
      std::vector<Point3> points = this->Certified.Bites.Centers;
      points.insert(points.end(), this->Inside.Centers.begin(), this->Inside.Centers.end());
      this->Weights.resize(points.size(), 0.0);
      const SpaceTriangulation triangulation =
        TriangulateSpace(points, this->Weights, this->Listener);
      if (!MayGoOn(this->Problems, pulse))
      {
        return false;
      }
      cells = LabelCells(
        triangulation, boundary.Corners, boundary.Sides, At(this->NumberOnBoundary()), pulse);
      if (cells.Lost.empty())
      {
        this->MakeBody(points, std::move(cells));
        return MayGoOn(this->Problems, pulse);
      }
      if (!this->ClearBalls(cells.Lost))
      {
        break;
      }
    }
    return this->Refuse(
      ProblemCode::TooThin, boundary.BallCenters[At(cells.Lost.front())], "a facet is missing");
  }

  /// Whether bites went.
  bool ClearBalls(const std::vector<Id>& facets)
  {
    std::size_t kept = 0;
    for (std::size_t bite = 0; bite < this->Inside.Centers.size(); ++bite)
    {
      bool isIn = false;
      for (const Id facet : facets)
      {
        const EmptyBall ball = this->BallOf(At(facet));
        isIn = isIn || Distance(ball.Center, this->Inside.Centers[bite]) < ball.Radius;
      }
      if (!isIn)
      {
        this->Inside.Centers[kept] = this->Inside.Centers[bite];
        this->Inside.Sizes[kept] = this->Inside.Sizes[bite];
        this->Inside.Radii[kept] = this->Inside.Radii[bite];
        ++kept;
      }
    }
    const bool isFewer = kept < this->Inside.Centers.size();
    this->Inside.Centers.resize(kept);
    this->Inside.Sizes.resize(kept);
    this->Inside.Radii.resize(kept);
    return isFewer;
  }

  /// Bites inside that no tetrahedron has are no vertices.
  void MakeBody(const std::vector<Point3>& points, BodyCells cells)
  {
    const SurfaceBites& bites = this->Certified.Bites;
    RelaxedBody& body = this->Body;
    const auto onBoundary = static_cast<std::size_t>(bites.Size());
    std::vector<Id> numbers(points.size(), NoId);
    for (const Id corner : cells.Corners)
    {
      numbers[At(corner)] = 0;
    }
    for (std::size_t point = 0; point < points.size(); ++point)
    {
      if (point < onBoundary || numbers[point] != NoId)
      {
        numbers[point] = static_cast<Id>(body.Points.size());
        body.Points.push_back(points[point]);
        body.Sizes.push_back(
          point < onBoundary ? bites.Sizes[point] : this->Inside.Sizes[point - onBoundary]);
        this->BiteOrders.push_back(static_cast<Id>(point));
      }
    }
    for (Id& corner : cells.Corners)
    {
      corner = numbers[At(corner)];
    }
    body.Corners = std::move(cells.Corners);
    body.Regions = std::move(cells.Labels);
    body.NumberOnLines = bites.NumberOnLines;
    body.NumberOnBoundary = bites.Size();
    body.BoundaryPlaces = bites.Triangles;
    body.Facets = this->Certified.Boundary.Corners;
    body.PieceEnds = bites.PieceEnds;
    this->TagFacets();
  }

  /// Facets of one tag hang together by edges that are no pieces of chains.
  void TagFacets()
  {
    struct Side
    {
      std::pair<Id, Id> Ends;
      Id Facet; ///< NoId: a piece
      bool operator<(const Side& other) const
      {
        return this->Ends != other.Ends ? this->Ends < other.Ends : this->Facet < other.Facet;
      }
    };
    std::vector<Side> sides;
    const std::vector<Id>& facets = this->Body.Facets;
    const std::vector<Id>& pieces = this->Body.PieceEnds;
    sides.reserve(facets.size() + pieces.size() / 2);
    for (std::size_t k = 0; k < pieces.size(); k += 2)
    {
      sides.push_back({ std::minmax(pieces[k], pieces[k + 1]), NoId });
    }
    for (std::size_t slot = 0; slot < facets.size(); ++slot)
    {
      sides.push_back(
        { std::minmax(facets[slot], facets[NextSlotOf(slot)]), static_cast<Id>(slot / 3) });
    }
    std::sort(sides.begin(), sides.end());
    DisjointSets sets(facets.size() / 3);
    for (std::size_t k = 1; k < sides.size(); ++k)
    {
      if (sides[k].Ends == sides[k - 1].Ends && sides[k - 1].Facet != NoId)
      {
        sets.Unite(sides[k - 1].Facet, sides[k].Facet);
      }
    }
    for (Id facet = 0; facet < static_cast<Id>(facets.size() / 3); ++facet)
    {
      this->Body.FacetTags.push_back(sets.SetOf(facet));
    }
  }

  bool Relax()
  {
    this->Listener.BeginStage("Relaxing");
    Pulse pulse(this->Listener);
    if (this->Options.Surface.Relaxation)
    {
      RelaxBody(this->Certified.Ground, this->Spacing, this->Body, pulse);
    }
    return MayGoOn(this->Problems, pulse);
  }

  /// The mesh, or what is wrong with it.
  BitingBody Finish()
  {
    this->Listener.BeginStage("Checking");
    Pulse pulse(this->Listener);
    BodyVerdict verdict = CheckBody(this->Surface, this->Bodies.Sides, this->Body, pulse);
    const std::size_t onBoundary = At(this->Body.NumberOnBoundary);
    BitingBody mesh;
    BitingSurface& boundary = mesh.Boundary;
    const auto begin = this->Body.Points.begin();
    boundary.Points.assign(begin, begin + this->Body.NumberOnBoundary);
    std::vector<Id> below;
    for (std::size_t slot = 0; slot < this->Body.Facets.size(); slot += 3)
    {
      const Id triangle = this->Body.BoundaryPlaces[At(this->Body.Facets[slot])];
      below.push_back(this->Certified.Ground.Mesh.Cells[At(triangle)]);
    }
    const WholeVerdict whole = CheckWhole(this->Surface, boundary.Points, this->Body.Facets, below);
    if (MayGoOn(this->Problems, pulse) && (!verdict.What.empty() || !whole.IsSame))
    {
      const bool isOwn = !verdict.What.empty();
      this->Refuse(ProblemCode::CheckFailed, isOwn ? verdict.Place : whole.Place,
        isOwn ? verdict.What : whole.What);
    }
    boundary.Spacing.assign(
      this->Body.Sizes.begin(), this->Body.Sizes.begin() + static_cast<std::ptrdiff_t>(onBoundary));
    boundary.Corners = std::move(this->Body.Facets);
    DescribeMesh(this->Certified, this->Options.Surface, boundary, pulse);
    mesh.BoundaryCells = std::move(verdict.CellsBehind);
    mesh.OriginalPoints = boundary.OriginalPoints;
    mesh.OriginalPoints.resize(this->Body.Points.size(), NoId);
    mesh.Points = std::move(this->Body.Points);
    mesh.Spacing = std::move(this->Body.Sizes);
    mesh.BiteOrders = std::move(this->BiteOrders);
    mesh.Corners = std::move(this->Body.Corners);
    mesh.Regions = std::move(this->Body.Regions);
    for (Id& region : mesh.Regions)
    {
      region = this->Bodies.Regions[At(region) - 1];
    }
    if (this->Options.Surface.KeepBites)
    {
      mesh.BiteCenters = boundary.BiteCenters;
      mesh.BiteRadii = boundary.BiteRadii;
      mesh.BiteCenters.insert(
        mesh.BiteCenters.end(), this->Inside.Centers.begin(), this->Inside.Centers.end());
      mesh.BiteRadii.insert(
        mesh.BiteRadii.end(), this->Inside.Radii.begin(), this->Inside.Radii.end());
    }
    return mesh;
  }

  CheckedSurface Surface; ///< turned as its bodies want
  const BodyMesherOptions& Options;
  ProblemList& Problems;
  Monitor& Listener;
  BodySides Bodies;
  CertifiedSurface Certified;
  std::vector<double> Weights;                  ///< of bites
  std::function<double(const Point3&)> Spacing; ///< f in the body
  InteriorBites Inside;
  RelaxedBody Body;
  std::vector<Id> BiteOrders; ///< of its points
};

void MoveBody(BitingBody& mesh, const Point3& way)
{
  MovePoints(mesh.Points, way);
  MovePoints(mesh.Boundary.Points, way);
  MovePoints(mesh.BiteCenters, way);
  MovePoints(mesh.Boundary.BiteCenters, way);
}

} // namespace

BitingBody MakeBitingBody(const CheckedSurface& surface, const BodyMesherOptions& options,
  ProblemList& problems, Monitor& monitor)
{
  if (surface.Mesh.NumberOfTriangles() == 0)
  {
    return {};
  }
  SurfaceMesherOptions surfaceOptions = options.Surface;
  if (!surfaceOptions.Spacing)
  {
    const double uniform = 0.04 * surface.Mesh.Bounds().Diagonal();
    surfaceOptions.Spacing = [uniform](const Point3&) { return uniform; };
  }
  BitingBody mesh = MeshNearOrigin(
    surface, surfaceOptions, problems,
    [&options, &monitor](const CheckedSurface& s, const SurfaceMesherOptions& o, ProblemList& p)
    {
      BodyMesherOptions own = options;
      own.Surface = o;
      return BodyMesher(s, own, p, monitor).Run();
    },
    MoveBody);
  Pulse pulse(monitor);
  const Id flat = FindNotPositive(mesh.Points, mesh.Corners, pulse);
  if (flat != NoId)
  {
    problems.Add({ ProblemCode::CheckFailed, {}, mesh.Points[At(mesh.Corners[4 * At(flat)])],
      "a tetrahedron that is not positive" });
  }
  return MayGoOn(problems, pulse) ? mesh : BitingBody();
}

} // namespace biting
