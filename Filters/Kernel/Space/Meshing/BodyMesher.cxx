// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "BodyMesher.h"

#include "../../Base/Tasks.h"
#include "../Boundary/BodySides.h"
#include "../Boundary/InsideTest.h"
#include "../Boundary/WholeCheck.h"
#include "../Delaunay/SpaceTriangulation.h"
#include "../Finishing/BodyRelaxation.h"
#include "../Interior/BodySpacing.h"
#include "../Surface/SurfaceCrossings.h"
#include "BodyCells.h"
#include "BodyCheck.h"
#include "CertifiedSurface.h"

#include <algorithm> // for any_of, max, min
#include <array>     // for pairs
#include <cmath>     // for sqrt
#include <utility>   // for move

namespace biting
{

namespace
{

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
    if (this->FindSides() && this->Certify() && this->FillInside() && this->FindCells() &&
      this->Relax())
    {
      mesh = this->Finish();
    }
    return this->Problems.HasErrors() ? BitingBody() : std::move(mesh);
  }

private:
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

  bool FindSides()
  {
    this->Listener.BeginStage("Looking for bodies");
    Pulse pulse(this->Listener);
    if (this->Surface.Mesh.Regions.empty())
    {
      for (const Id region : this->Options.Surface.Regions)
      {
        this->Surface.Mesh.Regions.push_back({ region, NoId });
      }
    }
    this->Bodies = FindBodies(this->Surface.Mesh, pulse);
    if (this->Bodies.OpenTriangle != NoId && MayGoOn(this->Problems, pulse))
    {
      this->RefuseSides();
    }
    return MayGoOn(this->Problems, pulse) && this->FitsLimit(pulse);
  }

  void RefuseSides()
  {
    const SurfaceMesh& mesh = this->Surface.Mesh;
    const std::array<Id, 2> folded = this->Bodies.Folded;
    if (folded[0] == NoId)
    {
      const std::vector<SurfaceEdgeKind>& kinds = this->Surface.EdgeKinds;
      const auto border = std::find(kinds.begin(), kinds.end(), SurfaceEdgeKind::Border);
      const Id* ends = this->Surface.EdgeEnds.data() + 2 * (border - kinds.begin());
      this->Refuse(ProblemCode::OpenEdges,
        border == kinds.end() ? mesh.Middle(At(this->Bodies.OpenTriangle))
                              : Midpoint(mesh.Points[At(ends[0])], mesh.Points[At(ends[1])]),
        "the same part of space is on both sides of the surface");
      return;
    }
    this->Problems.Add(
      { ProblemCode::Folds, { mesh.Cells[At(folded[0])], mesh.Cells[At(folded[1])] },
        mesh.Middle(At(folded[0])), "at an edge of more than two triangles" });
  }

  /// Refuses what will surely have too many vertices: inside about the integral of sqrt(2) / f^3,
  /// by samples.
  bool FitsLimit(Pulse& pulse)
  {
    constexpr std::size_t Samples = 24; // along each side of the box
    const Box3 box = this->Surface.Mesh.Bounds();
    const BoxTree<SurfaceItem, 3> tree = MakeSurfaceTree(this->Surface.Mesh, pulse);
    const InsideTest test(this->Surface.Mesh, this->Bodies.Sides, tree);
    const auto placeOf = [&box](std::size_t k)
    {
      Point3 place;
      for (std::size_t d = 0; d < 3; ++d)
      {
        place[d] = box.Low[d] + (static_cast<double>(k % Samples) + 0.5) / Samples * box.Size(d);
        k /= Samples;
      }
      return place;
    };
    std::vector<double> densities(Samples * Samples * Samples, 0.0);
    ForRowsAtOnce(pulse, densities.size(), 256,
      [this, &test, &placeOf, &densities](std::size_t begin, std::size_t end)
      {
        for (std::size_t k = begin; k < end; ++k)
        {
          const Point3 place = placeOf(k);
          const double size = this->Options.Surface.Spacing(place);
          densities[k] = test.LabelAt(place) != 0 ? std::sqrt(2.0) / (size * size * size) : 0.0;
        }
      });
    double expected = 0.0;
    for (std::size_t k = 0; k < densities.size(); ++k)
    {
      if (!(densities[k] >= 0.0 && densities[k] < Infinity))
      {
        return this->Refuse(ProblemCode::BadSpacing, placeOf(k), "");
      }
      expected += densities[k] * box.Size(0) * box.Size(1) * box.Size(2) /
        static_cast<double>(densities.size());
    }
    this->AskedInside = expected;
    constexpr double Surely = 2.0; // samples of a graded f are off
    const auto most = static_cast<double>(this->Options.Surface.MaximumNumberOfVertices);
    return expected > Surely * most ? this->RefuseSize() : MayGoOn(this->Problems, pulse);
  }

  bool Certify()
  {
    return CertifySurface(this->Surface, this->Options.Surface, this->Bodies.Sides, this->Certified,
      this->Problems, this->Listener);
  }

  bool FillInside()
  {
    this->Listener.BeginStage("Biting inside");
    Pulse pulse(this->Listener);
    const SurfaceBites& bites = this->Certified.Bites;
    const InsideTest test(this->Surface.Mesh, this->Certified.Ground.Sides, this->Certified.Tree);
    BodyBoundary boundary;
    boundary.Centers = bites.Centers;
    boundary.Sizes = bites.Sizes;
    std::vector<double> sizes;
    for (Id bite = 0; bite < bites.Size(); ++bite)
    {
      this->Weights.push_back(bites.WeightOf(bite));
      sizes.push_back(
        this->Certified.Ground.SizeAt(bites.Triangles[At(bite)], bites.Centers[At(bite)]));
    }
    boundary.Weights = this->Weights;
    boundary.Facets = this->Certified.Boundary.Corners;
    for (std::size_t facet = 0; facet < this->Certified.Boundary.BallCenters.size(); ++facet)
    {
      boundary.Balls.push_back(this->BallOf(facet));
    }
    boundary.IsInside = [&test](const Point3& place) { return test.LabelAt(place) != 0; };
    this->Spacing = BodySpacing(
      this->Options.Surface.Spacing, bites.Centers, sizes, this->Options.Surface.Gradation, pulse);
    boundary.Spacing = this->Spacing;
    const auto left = [&bites](std::int64_t limit)
    { return static_cast<std::size_t>(std::max<std::int64_t>(0, limit - bites.Size())); };
    const std::size_t most = left(this->Options.Surface.MaximumNumberOfVertices);
    const std::size_t wanted =
      this->Options.MaximumNumberOfBites > 0 ? left(this->Options.MaximumNumberOfBites) : most + 1;
    this->Inside = BiteInterior(
      boundary, this->Options.Shape, std::min(wanted, most), pulse, this->Options.BitingConstant);
    MovePoints(this->Inside.Centers, this->Options.Surface.Origin);
    MovePoints(this->Inside.Centers, -1.0 * this->Options.Surface.Origin);
    this->IsCutShort = this->Inside.Centers.size() > wanted;
    return this->Inside.Centers.size() > most && !this->IsCutShort ? this->RefuseSize()
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
    std::vector<Point3> points = this->Certified.Bites.Centers;
    points.reserve(points.size() + this->Inside.Centers.size());
    points.insert(points.end(), this->Inside.Centers.begin(), this->Inside.Centers.end());
    std::vector<Point3>().swap(this->Inside.Centers);
    for (int round = 0; round < MostRounds; ++round)
    {
      this->Weights.resize(points.size(), 0.0);
      cells = this->TriangulateAll(points, pulse);
      if (!MayGoOn(this->Problems, pulse))
      {
        return false;
      }
      if (cells.Lost.empty())
      {
        this->MakeBody(std::move(points), std::move(cells));
        return MayGoOn(this->Problems, pulse);
      }
      if (!this->ClearBalls(cells.Lost, points))
      {
        break;
      }
    }
    return this->Refuse(
      ProblemCode::TooThin, boundary.BallCenters[At(cells.Lost.front())], "a facet is missing");
  }

  BodyCells TriangulateAll(const std::vector<Point3>& points, Pulse& pulse)
  {
    SpaceTriangulation triangulation;
    {
      const PulsePart part(pulse, 0.0, 0.9);
      PulseMonitor monitor(pulse);
      triangulation = TriangulateSpace(points, this->Weights, monitor);
    }
    const SurfaceBoundary& boundary = this->Certified.Boundary;
    return pulse.Ask() ? LabelCells(std::move(triangulation), boundary.Corners, boundary.Sides,
                           At(this->NumberOnBoundary()), pulse)
                       : BodyCells();
  }

  /// Whether bites went.
  bool ClearBalls(const std::vector<Id>& facets, std::vector<Point3>& points)
  {
    const InteriorBites given = std::move(this->Inside);
    this->Inside = {};
    std::size_t kept = At(this->NumberOnBoundary());
    for (std::size_t bite = 0; bite < given.Sizes.size(); ++bite)
    {
      const Point3 place = points[At(this->NumberOnBoundary()) + bite];
      const bool isIn = std::any_of(facets.begin(), facets.end(),
        [this, &place](Id facet)
        {
          const EmptyBall ball = this->BallOf(At(facet));
          return Distance(ball.Center, place) < ball.Radius;
        });
      if (!isIn)
      {
        points[kept++] = place;
        this->Inside.Sizes.push_back(given.Sizes[bite]);
        this->Inside.Radii.push_back(given.Radii[bite]);
        if (!given.Axes.empty())
        {
          this->Inside.Axes.push_back(given.Axes[bite]);
        }
      }
    }
    points.resize(kept);
    return this->Inside.Sizes.size() < given.Sizes.size();
  }

  /// Bites inside that no tetrahedron has are no vertices.
  void MakeBody(std::vector<Point3> points, BodyCells cells)
  {
    const SurfaceBites& bites = this->Certified.Bites;
    RelaxedBody& body = this->Body;
    const auto onBoundary = static_cast<std::size_t>(bites.Size());
    InteriorBites inside = std::move(this->Inside);
    if (this->Options.Surface.KeepBites)
    {
      this->Inside.Centers.assign(points.begin() + bites.Size(), points.end());
      this->Inside.Radii = std::move(inside.Radii);
      this->Inside.Axes = std::move(inside.Axes);
    }
    std::vector<Id> numbers(points.size(), NoId);
    for (const Id corner : cells.Corners)
    {
      numbers[At(corner)] = 0;
    }
    body.Sizes.reserve(points.size());
    this->BiteOrders.reserve(points.size());
    for (std::size_t point = 0; point < points.size(); ++point)
    {
      if (point < onBoundary || numbers[point] != NoId)
      {
        numbers[point] = static_cast<Id>(body.Sizes.size());
        points[body.Sizes.size()] = points[point];
        body.Sizes.push_back(
          point < onBoundary ? bites.Sizes[point] : inside.Sizes[point - onBoundary]);
        this->BiteOrders.push_back(static_cast<Id>(point));
      }
    }
    points.resize(body.Sizes.size());
    body.Points = std::move(points);
    for (Id& corner : cells.Corners)
    {
      corner = numbers[At(corner)];
    }
    body.Corners = std::move(cells.Corners);
    body.Twins = std::move(cells.Twins);
    body.Regions = std::move(cells.Labels);
    body.NumberOfCorners = bites.NumberOfCorners;
    body.NumberOnLines = bites.NumberOnLines;
    body.NumberOnBoundary = bites.Size();
    body.BoundaryPlaces = bites.Triangles;
    body.Facets = this->Certified.Boundary.Corners;
    body.FacetPlaces = this->Certified.Boundary.Triangles;
    body.PieceEnds = bites.PieceEnds;
    body.PieceChains = bites.PieceChains;
    std::vector<double>().swap(this->Weights);
  }

  bool Relax()
  {
    this->Listener.BeginStage("Relaxing");
    Pulse pulse(this->Listener);
    if (this->Options.Surface.Relaxation && !this->IsCutShort)
    {
      RelaxBody(this->Certified.Ground, this->Spacing, this->Body, pulse);
    }
    else
    {
      RemoveFlatTetrahedra(this->Certified.Ground, this->Body, pulse);
    }
    return MayGoOn(this->Problems, pulse);
  }

  /// The mesh, or what is wrong with it.
  BitingBody Finish()
  {
    this->Listener.BeginStage("Checking");
    Pulse pulse(this->Listener);
    BodyVerdict verdict = CheckBody(this->Surface, this->Bodies.Sides, this->Body, pulse);
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
    std::vector<Id>().swap(this->Body.Twins);
    const WholeVerdict whole =
      CheckWhole(this->Surface, boundary.Points, this->Body.Facets, below, pulse);
    if (MayGoOn(this->Problems, pulse) && (!verdict.What.empty() || !whole.IsSame))
    {
      const bool isOwn = !verdict.What.empty();
      const bool isCoarse = isOwn ? verdict.IsCoarse : whole.IsCoarse;
      this->Refuse(isCoarse ? ProblemCode::TooThin : ProblemCode::CheckFailed,
        isOwn ? verdict.Place : whole.Place, isOwn ? verdict.What : whole.What);
    }
    boundary.Spacing.assign(
      this->Body.Sizes.begin(), this->Body.Sizes.begin() + this->Body.NumberOnBoundary);
    boundary.Corners = std::move(this->Body.Facets);
    this->DescribeBoundary(boundary, pulse);
    mesh.BoundaryCells = std::move(verdict.CellsBehind);
    mesh.OriginalPoints = boundary.OriginalPoints;
    mesh.OriginalPoints.resize(this->Body.Points.size(), NoId);
    mesh.Points = std::move(this->Body.Points);
    mesh.Spacing = std::move(this->Body.Sizes);
    mesh.BiteOrders = std::move(this->BiteOrders);
    mesh.Corners = std::move(this->Body.Corners);
    boundary.AskedVertices = this->AskedInside + 0.5 * boundary.AskedVertices;
    mesh.HasRegionValues = this->Bodies.HasValues;
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
      mesh.BiteAxes = std::move(this->Inside.Axes);
    }
    return mesh;
  }

  /// Vertices that relaxation took away are none; those that it added are of no bite.
  void DescribeBoundary(BitingSurface& boundary, Pulse& pulse)
  {
    SurfaceBites& bites = this->Certified.Bites;
    const std::vector<Id>& origins = this->Body.Origins;
    const std::vector<Id> orders = std::move(this->BiteOrders);
    const std::vector<Id> vertices = std::move(bites.GroundVertices);
    const std::vector<Point3> centers = std::move(bites.Centers);
    this->BiteOrders.clear();
    bites.GroundVertices.clear();
    for (std::size_t v = 0; v < origins.size(); ++v)
    {
      const Id origin = origins[v];
      this->BiteOrders.push_back(origin == NoId ? NoId : orders[At(origin)]);
      if (v < boundary.Points.size())
      {
        bites.GroundVertices.push_back(origin == NoId ? NoId : vertices[At(origin)]);
      }
    }
    bites.Centers = boundary.Points;
    bites.Triangles = std::move(this->Body.BoundaryPlaces);
    bites.NumberOnLines = this->Body.NumberOnLines;
    bites.PieceEnds = std::move(this->Body.PieceEnds);
    bites.PieceChains = std::move(this->Body.PieceChains);
    DescribeMesh(
      this->Surface, this->Certified, this->Options.Surface, boundary, this->Problems, pulse);
    std::copy_n(this->BiteOrders.begin(), boundary.Points.size(), boundary.BiteOrders.begin());
    if (this->Options.Surface.KeepBites)
    {
      boundary.BiteCenters = centers;
    }
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
  double AskedInside = 0.0; ///< vertices, by f as given
  bool IsCutShort = false;  ///< bites were not to go on
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
  BitingBody mesh = MeshNearOrigin(
    surface, options.Surface, problems,
    [&options, &monitor](const CheckedSurface& s, const SurfaceMesherOptions& o, ProblemList& p)
    {
      BodyMesherOptions own = options;
      own.Surface = o;
      return BodyMesher(s, own, p, monitor).Run();
    },
    MoveBody);
  Pulse pulse(monitor);
  pulse.SetFraction(1.0);
  const Id flat = FindNotPositive(mesh.Points, mesh.Corners, pulse);
  if (flat != NoId)
  {
    problems.Add({ ProblemCode::CheckFailed, {}, mesh.Points[At(mesh.Corners[4 * At(flat)])],
      "a tetrahedron that is not positive; move surfaces that are far from the origin there" });
  }
  return MayGoOn(problems, pulse) ? std::move(mesh) : BitingBody();
}

} // namespace biting
