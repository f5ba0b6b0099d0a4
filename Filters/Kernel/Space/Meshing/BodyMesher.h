// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBodyMesher_h
#define BitingBodyMesher_h

#include "../Interior/InteriorBites.h"
#include "SurfaceMesher.h"

// The facade of meshing bodies: a checked closed surface and a spacing in, tetrahedra out that fill
// what it bounds, or problems with their places.

namespace biting
{

struct BodyMesherOptions
{
  /// As for the surface; Spacing is asked in the whole of space. Regions, of each triangle, where
  /// CheckedSurface::Mesh has none: a closed shell with one value all over encloses the region of
  /// that value; a shell within another of the same value is a cavity of it. Without values, or
  /// where a shell has several, insides are found by even-odd. Walls that bodies share: FindBodies.
  SurfaceMesherOptions Surface;

  SpaceBiteShape Shape = SpaceBiteShape::Sphere;
  double BitingConstant = 0.0; ///< radius of a bite in f; 0: the one that gives edges of f
  std::int64_t MaximumNumberOfBites = 0; ///< stop after so many, and do not relax; 0: never
};

/// The mesh, as a structure of arrays.
struct BitingBody
{
  /// The boundary, and interfaces between regions: its vertices are the first ones of the body. Its
  /// bites are the first ones, too. AskedVertices are those of the whole body.
  BitingSurface Boundary;
  std::vector<Id> BoundaryCells; ///< of triangles: the tetrahedron they are a facet of

  // Vertices.
  std::vector<Point3> Points;
  std::vector<double> Spacing;    ///< f as used
  std::vector<Id> BiteOrders;     ///< NoId of vertices that relaxation added
  std::vector<Id> OriginalPoints; ///< of corners, the point of the input; NoId = new

  // Tetrahedra: four vertices each, positive by Orient3D.
  std::vector<Id> Corners;
  std::vector<Id> Regions;      ///< values of the surface; or numbers of bodies from 0
  bool HasRegionValues = false; ///< the former

  // Only with KeepBites: of all bites, those of the boundary first.
  std::vector<Point3> BiteCenters;
  std::vector<double> BiteRadii;
  std::vector<CubeAxes> BiteAxes; ///< of cubes; the boundary has spheres
};

/// Meshes a body. Where it cannot, `problems` has an error with its place, and the mesh is empty:
/// those of MakeBitingSurface; OpenEdges, where what is inside is not clear.
/// The mesh is checked before it is handed out: all tetrahedra positive, exactly; their boundary is
/// the certified surface, closed; the volume of each region.
/// Deterministic; does not depend on the number of threads.
BitingBody MakeBitingBody(const CheckedSurface& surface, const BodyMesherOptions& options,
  ProblemList& problems, Monitor& monitor);

} // namespace biting

#endif
