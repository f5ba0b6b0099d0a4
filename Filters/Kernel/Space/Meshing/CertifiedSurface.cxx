// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "CertifiedSurface.h"

#include "../../Base/Tasks.h"
#include "../Boundary/InsideTest.h"
#include "../Boundary/WholeCheck.h"
#include "../Features/FeatureLines.h"
#include "../Features/SizeCaps.h"
#include "../Surface/SurfaceCrossings.h"
#include "ExpectedVertices.h"

#include <algorithm> // for fill_n, max, min, none_of
#include <cmath>     // for isfinite, sqrt
#include <limits>    // for counts
#include <numeric>   // for exclusive_scan
#include <utility>   // for exchange, move

namespace biting
{

namespace
{

/// Of bites: vertices of the boundary, or of lines.
std::vector<std::uint8_t> UsedBites(const SurfaceBites& bites, const SurfaceBoundary& boundary)
{
  std::vector<std::uint8_t> isUsed(bites.Centers.size(), 0);
  std::fill_n(isUsed.begin(), bites.NumberOnLines, std::uint8_t{ 1 });
  for (const Id bite : boundary.Corners)
  {
    isUsed[At(bite)] = 1;
  }
  return isUsed;
}

/// The bites of offences.
std::vector<Id> FaultyBites(const std::vector<BoundaryOffence>& offences, bool withTurned)
{
  std::vector<Id> bites;
  for (const BoundaryOffence& offence : offences)
  {
    if (withTurned || offence.Fault != BoundaryFault::Turned)
    {
      bites.push_back(offence.Bite);
      bites.push_back(offence.Other == NoId ? offence.Bite : offence.Other);
    }
  }
  return bites;
}

/// Its region, and how far its middle is from the surface.
void MeasureTriangle(const SurfaceMesh& input, const CertifiedSurface& certified,
  const SurfaceMesherOptions& options, std::size_t t, BitingSurface& mesh)
{
  Point3 middle{};
  double size = 0.0;
  for (std::size_t slot = 3 * t; slot < 3 * t + 3; ++slot)
  {
    middle = middle + (1.0 / 3.0) * mesh.Points[At(mesh.Corners[slot])];
    size += mesh.Spacing[At(mesh.Corners[slot])] / 3.0;
  }
  const Id start =
    certified.Ground.Mesh.Cells[At(certified.Bites.Triangles[At(mesh.Corners[3 * t])])];
  const double most = Distance(NearestPoint(input.Triangle(At(start)), middle), middle);
  const auto [nearest, least] = NearestTriangle(input, certified.Tree, middle, most);
  mesh.Deviations[t] = least / size;
  mesh.Triangles[t] = nearest == NoId ? start : nearest;
  mesh.Regions[t] = options.Regions.empty() ? 0 : options.Regions[At(mesh.Triangles[t])];
}

void Measure(const SurfaceMesh& input, const CertifiedSurface& certified,
  const SurfaceMesherOptions& options, BitingSurface& mesh, Pulse& pulse)
{
  constexpr std::size_t CheapSteps = 31;
  const std::size_t triangles = mesh.Corners.size() / 3;
  mesh.Deviations.resize(triangles);
  mesh.Triangles.resize(triangles, 0);
  mesh.Regions.resize(triangles, 0);
  ForRowsAtOnce(pulse, triangles, CheapSteps,
    [&input, &certified, &options, &mesh](std::size_t begin, std::size_t end)
    {
      for (std::size_t t = begin; t < end; ++t)
      {
        MeasureTriangle(input, certified, options, t, mesh);
      }
    });
}

class SurfaceCertifier
{
public:
  SurfaceCertifier(const CheckedSurface& surface, const SurfaceMesherOptions& options,
    CertifiedSurface& result, ProblemList& problems, Monitor& monitor)
    : Surface(surface)
    , Options(options)
    , Ground(result.Ground)
    , Bites(result.Bites)
    , Tree(result.Tree)
    , Boundary(result.Boundary)
    , Result(result)
    , Problems(problems)
    , Beats(monitor)
  {
  }

  bool Run(Monitor& monitor)
  {
    monitor.BeginStage("Looking for features");
    {
      const PulsePart part(this->Beats, 0.0, 0.0);
      this->MakeGround();
    }
    monitor.BeginStage("Biting");
    bool isDone = this->MayGoOn();
    std::size_t before = std::numeric_limits<std::size_t>::max();
    std::size_t first = 0;
    int torn = 0;
    for (int round = 0; isDone && round < MostRounds + 2 * torn; ++round)
    {
      const PulsePart part(this->Beats, 1.0 - 1.0 / (1 << round), 1.0);
      this->Bite();
      isDone = this->MayGoOn();
      const std::size_t faults = this->Boundary.Offences.size();
      if (!isDone)
      {
        break;
      }
      // Facets far from the surface close connections and holes off, though none is at fault.
      if (faults == 0 || (round >= RoundsForSoft && this->AreSoft()))
      {
        this->IsWhole = torn < MostTorn && this->Compare().IsSame;
        if (torn < MostTorn && !this->IsWhole && this->LowerSizes(this->FindFar()))
        {
          ++torn;
          before = std::numeric_limits<std::size_t>::max();
          continue;
        }
        this->GiveUpSoft();
        break;
      }
      // Where no faults go, lines are noise, or f never suits.
      constexpr std::size_t MostGrowth = 4;
      first = first == 0 ? faults : first;
      const bool isDropped = faults >= before && this->DropLostFeatures();
      const std::vector<Id> faulty = FaultyBites(this->Boundary.Offences, torn == 0);
      if (!isDropped && (faults > MostGrowth * first || !this->LowerSizes(faulty)))
      {
        break;
      }
      before = isDropped ? std::numeric_limits<std::size_t>::max() : faults;
    }
    for (const Id vertex : this->Ground.Vanished)
    {
      this->Problems.Add({ ProblemCode::LostFeatures, {}, this->Ground.Mesh.Points[At(vertex)],
        "a hole, or a wall at an edge of more than two triangles, that is smaller than a tenth of "
        "the spacing" });
    }
    return isDone && this->MayGoOn() && this->IsCertified() && this->MayGoOn();
  }

private:
  static constexpr int MostRounds = 8;
  static constexpr int RoundsForSoft = 2; ///< in which f was lowered or lines were given up
  static constexpr int MostTorn = 4;      ///< rounds, each with another one for faults
  static constexpr double LeastTornShare = 0.0625; ///< of the given f: no smaller one is halved

  void Bite()
  {
    if (this->Problems.HasErrors())
    {
      return;
    }
    MergeCorners(this->Ground);
    this->IsWhole = false;
    this->Bites = BiteSurface(
      this->Ground, static_cast<std::size_t>(this->Options.MaximumNumberOfVertices), this->Beats);
    if (this->Bites.Size() > this->Options.MaximumNumberOfVertices)
    {
      this->RefuseSize();
      return;
    }
    MovePoints(this->Bites.Centers, this->Options.Origin);
    MovePoints(this->Bites.Centers, -1.0 * this->Options.Origin);
    this->Boundary = FindBoundary(this->Surface.Mesh, this->Ground, this->Bites, this->Tree,
      this->Result.HasBalls, this->Beats);
  }

  bool MayGoOn() { return biting::MayGoOn(this->Problems, this->Beats); }

  /// `triangle`: of the surface.
  void Refuse(ProblemCode code, const Point3& place, Id triangle, const std::string& detail)
  {
    std::vector<std::int64_t> ids;
    if (triangle != NoId)
    {
      ids.push_back(this->Surface.Mesh.Cells[At(triangle)]);
    }
    this->Problems.Add({ code, std::move(ids), place, detail });
  }

  void RefuseSize()
  {
    this->Refuse(ProblemCode::TooManyVertices, {}, NoId,
      "more than " + std::to_string(this->Options.MaximumNumberOfVertices) + " vertices");
  }

  /// Refuses what is no mesh of the surface.
  bool IsCertified()
  {
    for (const BoundaryOffence& offence : this->Boundary.Offences)
    {
      const bool isSharp = offence.Bite < this->Bites.NumberOnLines ||
        (offence.Other != NoId && offence.Other < this->Bites.NumberOnLines);
      const auto bite = At(offence.Bite);
      this->Refuse(isSharp ? ProblemCode::TooSharp : ProblemCode::TooThin,
        this->Bites.Centers[bite], this->Ground.Mesh.Cells[At(this->Bites.Triangles[bite])],
        "with spacing " + Figure(this->Bites.Sizes[bite]));
    }
    if (!this->Boundary.Offences.empty())
    {
      return false;
    }
    const WholeVerdict verdict = this->IsWhole ? WholeVerdict() : this->Compare();
    if (!verdict.IsSame)
    {
      this->Refuse(ProblemCode::TooThin, verdict.Place, verdict.Triangle, verdict.What);
    }
    return verdict.IsSame;
  }

  WholeVerdict Compare()
  {
    return CheckWhole(this->Surface, this->Bites.Centers, this->Boundary.Corners,
      this->Boundary.Triangles, this->Beats);
  }

  void MakeGround()
  {
    int& rounds = this->Result.RoundsForTurns; // those that halve f
    const int wanted = std::exchange(rounds, 0);
    SurfaceGround& ground = this->Ground;
    ground.Mesh = this->Surface.Mesh;
    ground.Normals.resize(ground.Mesh.NumberOfTriangles());
    for (std::size_t t = 0; t < ground.Normals.size(); ++t)
    {
      ground.Mesh.Cells[t] = static_cast<Id>(t);
      const Point3 normal = ground.Mesh.Normal(t);
      const double length = Length(normal);
      ground.Normals[t] = length > 0.0 ? (1.0 / length) * normal : Point3{};
    }
    FlagFeatures(ground, this->Options.Regions, this->Options.FeatureAngle, this->Beats);
    for (const Point3& place : ground.Mesh.Points)
    {
      const double size = this->Options.Spacing(place);
      if (!(size > 0.0) || !std::isfinite(size))
      {
        this->Refuse(ProblemCode::BadSpacing, place, NoId, "value " + Figure(size));
        return;
      }
      ground.Given.push_back(size);
    }
    const auto most = static_cast<double>(this->Options.MaximumNumberOfVertices);
    this->Result.AskedVertices = ExpectedVertices(ground.Mesh, this->Options.Spacing, most);
    if (this->Result.AskedVertices > most)
    {
      this->RefuseSize();
      return;
    }
    ground.Sizes = ground.Given;
    this->Divide();
    LinkGround(ground, this->Beats);
    FindChains(ground);
    const Id chains = ground.Chains.Size();
    DropNoise(ground);
    if (ground.Chains.Size() < chains)
    {
      LinkGround(ground, this->Beats);
    }
    this->Tree = MakeSurfaceTree(this->Surface.Mesh, this->Beats);
    if (this->FitsLimit())
    {
      this->CapSizes();
    }
    for (; rounds < wanted && !this->Problems.HasErrors() && HalveAtTurns(ground, this->Beats);
         ++rounds)
    {
      this->Regrade();
    }
  }

  /// Whether the ground does not surely have too many vertices; else refuses it.
  bool FitsLimit()
  {
    constexpr double Surely = 1.5;
    const double wanted = LeastVertices(this->Ground);
    const bool fits = wanted <= Surely * static_cast<double>(this->Options.MaximumNumberOfVertices);
    if (!fits)
    {
      this->Refuse(ProblemCode::TooManyVertices, {}, NoId,
        "at least " + Figure(wanted) + " vertices on the surface, with a spacing that walls, " +
          "features and curvature cap; at most " +
          std::to_string(this->Options.MaximumNumberOfVertices));
    }
    return fits;
  }

  void CapSizes()
  {
    SurfaceGround& ground = this->Ground;
    CapByCurvature(ground, this->Surface.Mesh, this->Options.BoundaryTolerance, this->Beats);
    this->Regrade();
    if (!this->Options.LimitByFeatureSize)
    {
      return;
    }
    // Where caps divide the ground it sees more: from its new vertices.
    constexpr int MostDivisions = 3;
    std::size_t seen = 0;
    for (int round = 0;
         round < MostDivisions && seen < ground.Mesh.Points.size() && !this->Problems.HasErrors();
         ++round)
    {
      const std::size_t before = ground.Mesh.Points.size();
      CapByFeatures(ground, this->Beats);
      CapByThickness(ground, this->Surface.Mesh, this->Tree, static_cast<Id>(seen), this->Beats);
      seen = before;
      this->Regrade();
    }
  }

  /// After sizes were lowered.
  void Regrade()
  {
    SurfaceGround& ground = this->Ground;
    GradeSizes(ground, this->Options.Gradation, this->Beats);
    const std::size_t before = ground.Mesh.Points.size();
    if (this->FitsLimit())
    {
      this->Divide();
    }
    if (ground.Mesh.Points.size() > before)
    {
      LinkGround(ground, this->Beats);
      FindChains(ground);
    }
  }

  /// Refuses a ground that would need several GB.
  void Divide()
  {
    constexpr std::size_t MostTriangles = 40000000;
    if (!DivideGround(this->Ground, this->Options.Spacing, MostTriangles, this->Beats))
    {
      this->RefuseSize();
    }
  }

  double GivenAt(Id bite) const
  {
    const std::size_t first = 3 * At(this->Bites.Triangles[At(bite)]);
    return this->Ground.Given[At(this->Ground.Mesh.Corners[first])];
  }

  /// Whether the boundary is sound but for turned facets, and bites that are none of its vertices
  /// though one is nearer than half of the given f: edges too sharp for f are cut off there.
  bool AreSoft() const
  {
    const std::vector<std::uint8_t> isUsed = UsedBites(this->Bites, this->Boundary);
    for (const BoundaryOffence& offence : this->Boundary.Offences)
    {
      bool isSoft = offence.Fault == BoundaryFault::Turned;
      if (offence.Fault == BoundaryFault::Missing && offence.Bite >= this->Bites.NumberOnLines)
      {
        const double reach = 0.5 * this->GivenAt(offence.Bite);
        const Point3& place = this->Bites.Centers[At(offence.Bite)];
        for (std::size_t k = 0; k < isUsed.size() && !isSoft; ++k)
        {
          isSoft = isUsed[k] != 0 && Distance(this->Bites.Centers[k], place) < reach;
        }
      }
      if (!isSoft)
      {
        return false;
      }
    }
    return true;
  }

  /// Takes the boundary as it is, and the bites away that are none of its vertices.
  void GiveUpSoft()
  {
    for (const BoundaryOffence& offence : this->Boundary.Offences)
    {
      this->Problems.Add(
        { ProblemCode::LostFeatures, {}, this->Bites.Centers[At(offence.Bite)], "" });
    }
    this->Boundary.Offences.clear();
    const std::vector<std::uint8_t> isUsed = UsedBites(this->Bites, this->Boundary);
    const auto keep = [&isUsed](auto& list)
    {
      std::size_t next = 0;
      for (std::size_t k = 0; k < isUsed.size(); ++k)
      {
        list[next] = list[k];
        next += isUsed[k];
      }
      list.resize(next);
    };
    std::vector<Id> numbers(isUsed.size());
    std::exclusive_scan(isUsed.begin(), isUsed.end(), numbers.begin(), Id{ 0 });
    for (Id& bite : this->Boundary.Corners)
    {
      bite = numbers[At(bite)];
    }
    keep(this->Bites.Centers);
    keep(this->Bites.Sizes);
    keep(this->Bites.Radii);
    keep(this->Bites.Triangles);
    keep(this->Bites.GroundVertices);
  }

  /// Gives up the turning lines that have faults. Whether there is one.
  bool DropLostFeatures()
  {
    std::vector<std::uint8_t> isFaulty(this->Bites.Centers.size(), 0);
    for (const BoundaryOffence& offence : this->Boundary.Offences)
    {
      isFaulty[At(offence.Bite)] |= offence.Fault != BoundaryFault::Turned ? 1 : 0;
    }
    std::vector<Id> chains;
    for (std::size_t k = 0; k < this->Bites.PieceChains.size(); ++k)
    {
      const Id chain = this->Bites.PieceChains[k];
      const Id first = this->Bites.PieceEnds[2 * k];
      const bool isLost =
        (isFaulty[At(first)] | isFaulty[At(this->Bites.PieceEnds[2 * k + 1])]) != 0;
      if (isLost && this->Ground.Chains.Kinds[At(chain)] == SurfaceEdgeKind::Feature &&
        (chains.empty() || chains.back() != chain))
      {
        chains.push_back(chain);
        this->Problems.Add({ ProblemCode::LostFeatures, {}, this->Bites.Centers[At(first)], "" });
      }
    }
    DropChains(this->Ground, chains, this->Beats);
    return !chains.empty();
  }

  /// Halves f at the bites. Whether it is lower then.
  bool LowerSizes(const std::vector<Id>& bites)
  {
    bool isLower = false;
    for (const Id bite : bites)
    {
      const double wanted = 0.5 * this->Bites.Sizes[At(bite)];
      const std::size_t first = 3 * At(this->Bites.Triangles[At(bite)]);
      for (std::size_t slot = first; slot < first + 3; ++slot)
      {
        double& size = this->Ground.Sizes[At(this->Ground.Mesh.Corners[slot])];
        isLower = isLower || wanted < size;
        size = std::min(size, wanted);
      }
    }
    if (isLower)
    {
      this->Regrade();
    }
    return isLower;
  }

  /// The bites at facets whose middles are farther from the surface than twice the tolerance. A
  /// ridge that turns by FeatureAngle is .14 edges from a facet across it, however small that is.
  /// None where half of f there may make too many vertices.
  std::vector<Id> FindFar()
  {
    constexpr std::int64_t MostGrowth = 4; // half of f makes four times the vertices
    if (!(this->Options.BoundaryTolerance > 0.0) ||
      MostGrowth * this->Bites.Size() > this->Options.MaximumNumberOfVertices)
    {
      return {};
    }
    BitingSurface mesh;
    mesh.Points = this->Bites.Centers;
    mesh.Spacing = this->Bites.Sizes;
    mesh.Corners = this->Boundary.Corners;
    Measure(this->Surface.Mesh, this->Result, this->Options, mesh, this->Beats);
    const auto isSmall = [this](Id bite)
    { return this->Bites.Sizes[At(bite)] <= LeastTornShare * this->GivenAt(bite); };
    std::vector<Id> far;
    for (auto facet = mesh.Corners.begin(); facet != mesh.Corners.end(); facet += 3)
    {
      const double deviation = mesh.Deviations[At((facet - mesh.Corners.begin()) / 3)];
      if (deviation >= 2.0 * this->Options.BoundaryTolerance &&
        std::none_of(facet, facet + 3, isSmall))
      {
        far.insert(far.end(), facet, facet + 3);
      }
    }
    return far;
  }

  const CheckedSurface& Surface;
  const SurfaceMesherOptions& Options;
  SurfaceGround& Ground;
  SurfaceBites& Bites;
  BoxTree<SurfaceItem, 3>& Tree;
  SurfaceBoundary& Boundary;
  CertifiedSurface& Result;
  bool IsWhole = false; ///< Compare has found no difference since the last bites
  ProblemList& Problems;
  Pulse Beats;
};

} // namespace

bool CertifySurface(const CheckedSurface& surface, const SurfaceMesherOptions& options,
  std::vector<TriangleSides> sides, CertifiedSurface& result, ProblemList& problems,
  Monitor& monitor)
{
  result.Ground.Sides = std::move(sides);
  return SurfaceCertifier(surface, options, result, problems, monitor).Run(monitor);
}

bool MayGoOn(ProblemList& problems, Pulse& pulse)
{
  if (!pulse.Ask() && !problems.Has(ProblemCode::Aborted))
  {
    problems.Add({ ProblemCode::Aborted, {}, {}, "" });
  }
  return !problems.HasErrors();
}

void DescribeMesh(const CheckedSurface& surface, const CertifiedSurface& certified,
  const SurfaceMesherOptions& options, BitingSurface& mesh, ProblemList& problems, Pulse& pulse)
{
  const SurfaceBites& bites = certified.Bites;
  const SurfaceGround& ground = certified.Ground;
  mesh.AskedVertices = certified.AskedVertices;
  mesh.EdgeEnds = bites.PieceEnds;
  for (const Id chain : bites.PieceChains)
  {
    mesh.EdgeKinds.push_back(ground.Chains.Kinds[At(chain)]);
  }
  for (Id bite = 0; bite < bites.Size(); ++bite)
  {
    const Id vertex = bites.GroundVertices[At(bite)];
    mesh.BiteOrders.push_back(bite);
    mesh.OriginalPoints.push_back(vertex == NoId ? NoId : ground.Mesh.PointIds[At(vertex)]);
    mesh.Kinds.push_back(bite < bites.NumberOfCorners ? SurfaceVertexKind::Corner
        : bite < bites.NumberOnLines                  ? SurfaceVertexKind::Line
                                                      : SurfaceVertexKind::Surface);
  }
  if (options.KeepBites)
  {
    mesh.BiteCenters = bites.Centers;
    mesh.BiteRadii = bites.Radii;
  }
  Measure(surface.Mesh, certified, options, mesh, pulse);
  const double tolerance = options.BoundaryTolerance;
  const double most = tolerance > 0.0 ? std::max(0.25, 2.0 * tolerance) : Infinity;
  for (std::size_t t = 0; t < mesh.Deviations.size(); ++t)
  {
    if (mesh.Deviations[t] > most)
    {
      const Point3& place = mesh.Points[At(mesh.Corners[3 * t])];
      problems.Add({ ProblemCode::LostFeatures, {}, place, "" });
    }
  }
}

bool CrossesItself(const std::vector<Point3>& points, const std::vector<Id>& corners, Pulse& pulse)
{
  SurfaceMesh mesh;
  mesh.Points = points;
  mesh.Corners = corners;
  mesh.Cells.resize(corners.size() / 3);
  const BoxTree<SurfaceItem, 3> tree = MakeSurfaceTree(mesh, pulse);
  return !FindContacts(mesh, tree, pulse).empty();
}

Point3 OriginFor(const SurfaceMesh& mesh)
{
  const Box3 box = mesh.Bounds();
  Point3 origin = box.Center();
  for (double& x : origin)
  {
    x = std::abs(x) > box.Diagonal() ? x : 0.0;
  }
  return origin;
}

void MovePoints(std::vector<Point3>& points, const Point3& way)
{
  for (Point3& point : points)
  {
    point = point + way;
  }
}

} // namespace biting
