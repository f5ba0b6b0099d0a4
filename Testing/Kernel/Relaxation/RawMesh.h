// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRawMesh_h
#define BitingRawMesh_h

#include "../Support/Dice.h"
#include "../Support/MeshShapes.h"
#include "../Support/SameMesh.h"
#include "Delaunay/Triangulation.h"
#include "Domain/DomainLocator.h"
#include "Quality/MeshCheck.h"
#include "Quality/Quality.h"
#include "Relaxation/Relaxation.h"

#include <algorithm> // for max
#include <string>    // for verdicts
#include <vector>    // for the arrays

namespace biting
{

/// To the last byte.
inline bool AreSame(const RelaxationMesh& a, const RelaxationMesh& b)
{
  return HaveSameBytes(a.Points, b.Points) && HaveSameBytes(a.Spacings, b.Spacings) &&
    HaveSameBytes(a.Segments, b.Segments) && HaveSameBytes(a.EdgeStarts, b.EdgeStarts) &&
    HaveSameBytes(a.EdgeEnds, b.EdgeEnds) && HaveSameBytes(a.EdgeSegments, b.EdgeSegments) &&
    HaveSameBytes(a.Triangles.Corners, b.Triangles.Corners) &&
    HaveSameBytes(a.Triangles.Neighbors, b.Triangles.Neighbors) &&
    HaveSameBytes(a.Triangles.Constraints, b.Triangles.Constraints) &&
    HaveSameBytes(a.Triangles.Regions, b.Triangles.Regions);
}

/// What CheckMesh says about a mesh that is, or need not be, Delaunay.
inline std::string Violation(const Domain& domain, const RelaxationMesh& mesh, bool isDelaunay)
{
  const Triangulation& triangles = mesh.Triangles;
  MeshCheckInput input{ mesh.Points, triangles.Corners, triangles.Neighbors, triangles.Constraints,
    domain.Area };
  input.IsDelaunay = isDelaunay;
  return CheckMesh(input);
}

/// A domain, a spacing, and a mesh of mediocre triangles: parts of segments of about the spacing,
/// and inside random points, each at least `distance` spacings from all others.
struct RawMesh
{
  biting::Domain Domain;
  biting::Spacing Spacing;
  RelaxationMesh Mesh;

  RawMesh(
    const Polylines& lines, const SpacingOptions& options, double distance = 0.7, int darts = 4000)
  {
    ProblemList problems;
    SilentMonitor monitor;
    this->Domain = MakeDomain(lines, {}, problems, monitor);
    this->Spacing = MakeSpacing(options, this->Domain.Bounds, problems, monitor);
    for (const Point2& place : this->Domain.Vertices)
    {
      this->AddVertex(place, NoId);
    }
    for (Id segment = 0; segment < this->Domain.NumberOfSegments(); ++segment)
    {
      this->Divide(segment);
    }
    if (darts > 0)
    {
      this->ThrowDarts(distance, darts);
    }
    this->Triangulate();
  }

  RelaxationResult Relax(const RelaxationOptions& options = {})
  {
    SilentMonitor monitor;
    return biting::Relax(this->Domain, this->Spacing, options, this->Mesh, monitor);
  }

  std::string Violation(bool isDelaunay) const
  {
    return biting::Violation(this->Domain, this->Mesh, isDelaunay);
  }

  MeshQuality Quality() const
  {
    const Triangulation& triangles = this->Mesh.Triangles;
    return MeasureQuality(
      { this->Mesh.Points, this->Mesh.Spacings, triangles.Corners, triangles.Neighbors });
  }

  double MeanMinimumAngle() const
  {
    double sum = 0.0;
    const MeshQuality quality = this->Quality();
    for (const double angle : quality.MinimumAngle)
    {
      sum += angle;
    }
    return sum / static_cast<double>(quality.MinimumAngle.size());
  }

private:
  void AddVertex(const Point2& place, Id segment)
  {
    this->Mesh.Points.push_back(place);
    this->Mesh.Spacings.push_back(this->Spacing(place));
    this->Mesh.Segments.push_back(segment);
  }

  void AddPart(Id start, Id end, Id segment)
  {
    this->Mesh.EdgeStarts.push_back(start);
    this->Mesh.EdgeEnds.push_back(end);
    this->Mesh.EdgeSegments.push_back(segment);
  }

  void Divide(Id segment)
  {
    const Point2& start = this->Domain.Vertices[this->Domain.Starts[segment]];
    const Point2& end = this->Domain.Vertices[this->Domain.Ends[segment]];
    const double spacing = this->Spacing(Midpoint(start, end));
    const int parts = std::max(1, static_cast<int>(Distance(start, end) / spacing));
    Id last = this->Domain.Starts[segment];
    for (int part = 1; part < parts; ++part)
    {
      const Id next = static_cast<Id>(this->Mesh.Points.size());
      this->AddVertex(start + (static_cast<double>(part) / parts) * (end - start), segment);
      this->AddPart(last, next, segment);
      last = next;
    }
    this->AddPart(last, this->Domain.Ends[segment], segment);
  }

  void ThrowDarts(double distance, int darts)
  {
    Pulse unheard(NoMonitor());
    const DomainLocator locator(this->Domain, unheard);
    const Box2& box = this->Domain.Bounds;
    Dice dice(1);
    for (int dart = 0; dart < darts; ++dart)
    {
      const double x = box.Low.X + dice.Unit() * box.Width();
      const Point2 place{ x, box.Low.Y + dice.Unit() * box.Height() };
      if (locator.IsInside(place) && this->IsFree(place, distance * this->Spacing(place)))
      {
        this->AddVertex(place, NoId);
      }
    }
  }

  bool IsFree(const Point2& place, double reach) const
  {
    for (const Point2& point : this->Mesh.Points)
    {
      if (Distance(point, place) < reach)
      {
        return false;
      }
    }
    return true;
  }

  void Triangulate()
  {
    SilentMonitor monitor;
    ConstraintEdges edges{ this->Mesh.EdgeStarts, this->Mesh.EdgeEnds, {} };
    for (const Id segment : this->Mesh.EdgeSegments)
    {
      edges.IsBoundary.push_back(this->Domain.IsBoundary[segment]);
    }
    this->Mesh.Triangles = biting::Triangulate(this->Mesh.Points, edges, {}, monitor).Mesh;
  }
};

inline RawMesh UnitSquare(double spacing = 0.08)
{
  return RawMesh(PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Lines(), UniformSpacing(spacing));
}

/// A square with a round hole, a slanted interface through it and embedded points.
inline RawMesh Plate(double spacing = 0.06)
{
  return RawMesh(PolylineBuilder()
                   .Box(0.0, 0.0, 1.0, 1.0)
                   .Loop(RegularPolygon({ 0.6, 0.6 }, 0.2, 14))
                   .Chain({ { 0.1, 0.1 }, { 0.9, 0.23 } }, ChainKind::Interface)
                   .Chain({ { 0.25, 0.85 } }, ChainKind::EmbeddedPoint)
                   .Chain({ { 0.26, 0.84 } }, ChainKind::EmbeddedPoint)
                   .Lines(),
    UniformSpacing(spacing));
}

/// Triangles with tips of 5, 20 and 40 degrees that share the vertex there.
inline RawMesh Wedges()
{
  return RawMesh(PolylineBuilder()
                   .Loop({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 0.087 } })
                   .Loop({ { 0.0, 0.0 }, { 0.9, 0.4 }, { 0.6, 0.6 } })
                   .Loop({ { 0.0, 0.0 }, { -0.8, 0.4 }, { -0.8, -0.2 } })
                   .Lines(),
    UniformSpacing(0.06));
}

/// Grows from 0.02 in a corner.
inline RawMesh GradedSquare()
{
  return RawMesh(PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Lines(),
    RadialSpacing({ 0.0, 0.0 }, 0.02, 0.1), 0.7, 8000);
}

inline std::vector<RawMesh> AllRawMeshes()
{
  std::vector<RawMesh> meshes;
  meshes.push_back(UnitSquare());
  meshes.push_back(Plate());
  meshes.push_back(Wedges());
  meshes.push_back(GradedSquare());
  // Points in such disorder that there are slivers.
  meshes.emplace_back(
    PolylineBuilder().Box(0.0, 0.0, 1.0, 1.0).Lines(), UniformSpacing(0.08), 0.001, 300);
  return meshes;
}

} // namespace biting

#endif
