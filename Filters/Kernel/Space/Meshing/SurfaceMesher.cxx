// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceMesher.h"

#include "../Biting/SurfaceBites.h"
#include "../Boundary/SurfaceBoundary.h"
#include "../Features/FeatureLines.h"
#include "../Features/SizeCaps.h"
#include "../Surface/SurfaceCrossings.h"

#include <algorithm> // for min, max
#include <utility>   // for move

namespace biting
{

namespace
{

std::size_t At(Id id)
{
  return static_cast<std::size_t>(id);
}

class SurfaceMesher
{
public:
  SurfaceMesher(const CheckedSurface& surface, const SurfaceMesherOptions& options,
    ProblemList& problems, Monitor& monitor)
    : Surface(surface)
    , Options(options)
    , Problems(problems)
    , Listener(monitor)
    , Beats(monitor)
  {
  }

  BitingSurface Run()
  {
    this->Listener.BeginStage("Looking for features");
    if (!this->MakeGround())
    {
      return {};
    }
    const int MostRounds = getenv("ROUNDS") ? atoi(getenv("ROUNDS")) : 4;
    for (int round = 0; round < MostRounds; ++round)
    {
      this->Listener.BeginStage("Biting");
      this->Bites = BiteSurface(
        this->Ground, static_cast<std::size_t>(this->Options.MaximumNumberOfVertices), this->Beats);
      const BoxTree<SurfaceItem, 3> tree = MakeSurfaceTree(this->Ground.Mesh, this->Beats);
      this->Listener.BeginStage("Triangulating");
      this->Boundary = FindBoundary(this->Ground, this->Bites, tree, this->IsSolid(), this->Beats);
      fprintf(stderr, "round %d: ground %zu tri, bites %d (%d %d), facets %zu, offences %zu\n",
        round, this->Ground.Mesh.NumberOfTriangles(), this->Bites.Size(),
        this->Bites.NumberOfCorners, this->Bites.NumberOnLines, this->Boundary.Triangles.size(),
        this->Boundary.Offences.size());
      int kinds[5] = {};
      for (auto& o : this->Boundary.Offences)
      {
        ++kinds[(int)o.Fault];
        if (getenv("SHOW"))
        {
          auto& c = this->Bites.Centers[At(o.Bite)];
          fprintf(stderr, "     fault %d bite %d other %d size %g at %g %g %g\n", (int)o.Fault,
            o.Bite, o.Other, this->Bites.Sizes[At(o.Bite)], c.X, c.Y, c.Z);
        }
      }
      fprintf(stderr, "   missing %d lost %d nonmanifold %d pinched %d turned %d\n", kinds[0],
        kinds[1], kinds[2], kinds[3], kinds[4]);
      if (this->Boundary.Offences.empty() || !this->LowerSizes())
      {
        break;
      }
    }
    return this->Assemble();
  }

private:
  bool IsSolid() const
  {
    for (std::size_t t = 0; t < this->Surface.Mesh.NumberOfTriangles(); ++t)
    {
      if (!this->Surface.Shells.IsSolid(t))
      {
        return false;
      }
    }
    return true;
  }

  bool MakeGround()
  {
    SurfaceGround& ground = this->Ground;
    ground.Mesh = this->Surface.Mesh;
    const std::size_t triangles = ground.Mesh.NumberOfTriangles();
    for (std::size_t t = 0; t < triangles; ++t)
    {
      ground.Mesh.Cells[t] = static_cast<Id>(t);
      const Point3 normal = ground.Mesh.Normal(t);
      const double length = Length(normal);
      ground.Normals.push_back(length > 0.0 ? (1.0 / length) * normal : Point3{});
    }
    FlagFeatures(ground, this->Options.Regions, this->Options.FeatureAngle, this->Beats);
    const double uniform = 0.02 * this->Surface.Mesh.Bounds().Diagonal();
    this->Spacing = this->Options.Spacing;
    if (!this->Spacing)
    {
      this->Spacing = [uniform](const Point3&) { return uniform; };
    }
    for (const Point3& place : ground.Mesh.Points)
    {
      ground.Given.push_back(this->Spacing(place));
    }
    ground.Sizes = ground.Given;
    DivideGround(ground, this->Spacing, 100000000, this->Beats);
    LinkGround(ground, this->Beats);
    FindChains(ground);
    DropNoise(ground);
    LinkGround(ground, this->Beats);
    CapByCurvature(ground, this->Surface.Mesh, this->Options.BoundaryTolerance, this->Beats);
    this->Regrade();
    // Where caps divide the ground it sees more.
    constexpr int MostRounds = 3;
    std::size_t before = 0;
    for (int round = 0; round < MostRounds && this->Options.LimitByFeatureSize &&
         before < ground.Mesh.Points.size();
         ++round)
    {
      before = ground.Mesh.Points.size();
      CapByFeatures(ground, this->Beats);
      const BoxTree<SurfaceItem, 3> tree = MakeSurfaceTree(ground.Mesh, this->Beats);
      CapByThickness(ground, tree, this->Beats);
      this->Regrade();
    }
    return true;
  }

  /// After sizes were lowered.
  void Regrade()
  {
    SurfaceGround& ground = this->Ground;
    GradeSizes(ground, this->Options.Gradation, this->Beats);
    DivideGround(ground, this->Spacing, 100000000, this->Beats);
    LinkGround(ground, this->Beats);
    FindChains(ground);
  }

  bool LowerSizes()
  {
    bool isLower = false;
    for (const BoundaryOffence& offence : this->Boundary.Offences)
    {
      for (const Id bite : { offence.Bite, offence.Other })
      {
        if (bite == NoId)
        {
          continue;
        }
        const Id triangle = this->Bites.Triangles[At(bite)];
        for (std::size_t slot = 3 * At(triangle); slot < 3 * At(triangle) + 3; ++slot)
        {
          double& size = this->Ground.Sizes[At(this->Ground.Mesh.Corners[slot])];
          const double wanted = 0.5 * this->Bites.Sizes[At(bite)];
          isLower = isLower || wanted < size;
          size = std::min(size, wanted);
        }
      }
    }
    if (isLower)
    {
      this->Regrade();
    }
    return isLower;
  }

  BitingSurface Assemble()
  {
    BitingSurface mesh;
    mesh.Points = this->Bites.Centers;
    mesh.Spacing = this->Bites.Sizes;
    mesh.Corners = this->Boundary.Corners;
    for (Id bite = 0; bite < this->Bites.Size(); ++bite)
    {
      mesh.Kinds.push_back(bite < this->Bites.NumberOfCorners ? SurfaceVertexKind::Corner
          : bite < this->Bites.NumberOnLines                  ? SurfaceVertexKind::Line
                                                              : SurfaceVertexKind::Surface);
    }
    mesh.EdgeEnds = this->Bites.PieceEnds;
    return mesh;
  }

  const CheckedSurface& Surface;
  const SurfaceMesherOptions& Options;
  ProblemList& Problems;
  Monitor& Listener;
  Pulse Beats;
  SurfaceGround Ground;
  std::function<double(const Point3&)> Spacing;
  SurfaceBites Bites;
  SurfaceBoundary Boundary;
};

} // namespace

BitingSurface MakeBitingSurface(const CheckedSurface& surface, const SurfaceMesherOptions& options,
  ProblemList& problems, Monitor& monitor)
{
  return SurfaceMesher(surface, options, problems, monitor).Run();
}

} // namespace biting
