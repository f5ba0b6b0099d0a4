// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSurfaceMesher_h
#define BitingSurfaceMesher_h

#include "../../Base/Monitor.h"
#include "../../Base/Problem.h"
#include "../Surface/SurfaceCheck.h"

#include <cstdint>    // for kinds
#include <functional> // for the spacing
#include <vector>     // for the arrays

// The facade of surface meshing: a checked surface and a spacing in, an isotropic triangle mesh of
// the surface out, or problems with their places.

namespace biting
{

struct SurfaceMesherOptions
{
  /// f(x) as given, in input length units: positive and finite everywhere. Any number of threads
  /// may call it at once.
  std::function<double(const Point3&)> Spacing;

  /// The slope of f along the surface, as given and as capped. 0: f stays as given, and grows by
  /// 0.3 from where a cap lowers it.
  double Gradation = 0.3;

  /// True: f is capped by the thickness inside and outside, and by the distance between features;
  /// at least to a quarter of what is given.
  bool LimitByFeatureSize = true;

  /// Degrees: edges at which the surface turns by more are kept as lines.
  double FeatureAngle = 40.0;

  /// How far the mesh may be from the surface where it curves, in f: caps f, at least to a quarter
  /// of what is given. Of surfaces, not of bodies: where facets are still twice as far f is halved,
  /// at most twice, if the certificates hold then, too. 0: any distance.
  double BoundaryTolerance = 0.1;

  /// Of each triangle of CheckedSurface::Mesh: edges between different ones are kept as lines.
  /// Empty: none.
  std::vector<Id> Regions;

  std::int64_t MaximumNumberOfVertices = 20000000;

  /// True: vertices are moved on the surface, edges flipped, until triangles are good. False: the
  /// mesh of the bites.
  bool Relaxation = true;

  bool KeepBites = false; ///< fill the bites of the result

  /// The mesh is moved by that way in the end: bites lie where this rounds no coordinate.
  Point3 Origin;
};

enum class SurfaceVertexKind : std::uint8_t
{
  Corner = 0, ///< where feature lines meet, end or turn
  Line = 1,   ///< on a feature line
  Surface = 2
};

/// The mesh, as a structure of arrays.
struct BitingSurface
{
  // Vertices.
  std::vector<Point3> Points;
  std::vector<double> Spacing; ///< f as used
  std::vector<Id> BiteOrders;
  std::vector<SurfaceVertexKind> Kinds;
  std::vector<Id> OriginalPoints; ///< of corners, the point of the input; NoId = new

  // Triangles: three vertices each, oriented as the surface; walls between parts of space away from
  // the outside, or from the part that has the earlier triangle.
  std::vector<Id> Corners;
  std::vector<Id> Triangles;      ///< the triangle of CheckedSurface::Mesh below the middle
  std::vector<Id> Regions;        ///< SurfaceMesherOptions::Regions of it; 0 where that is empty
  std::vector<double> Deviations; ///< distance of the middle from the surface, in f

  // Edges of feature lines: two vertices each.
  std::vector<Id> EdgeEnds;
  std::vector<SurfaceEdgeKind> EdgeKinds;

  double AskedVertices = 0.0; ///< about how many f as given asks for, before it is capped

  // Only with KeepBites.
  std::vector<Point3> BiteCenters;
  std::vector<double> BiteRadii;
};

/// Meshes a surface. Where it cannot, `problems` has an error with its place, and the mesh is
/// empty:
/// - TooThin: walls, or feature lines, nearer to each other than a quarter of f;
/// - TooSharp: faces that meet at too small an angle for f;
/// - TooManyVertices; BadSpacing: f is not positive somewhere; Aborted.
/// Two corners joined by a feature line shorter than a tenth of f as given are merged.
/// LostFeatures is a warning: feature lines that are not in the mesh, and edges too sharp for f
/// that it cuts off (CertifySurface).
/// Precondition: `surface` was checked and its errors are none but open and non-manifold edges.
/// Deterministic; does not depend on the number of threads.
BitingSurface MakeBitingSurface(const CheckedSurface& surface, const SurfaceMesherOptions& options,
  ProblemList& problems, Monitor& monitor);

} // namespace biting

#endif
