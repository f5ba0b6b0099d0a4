// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingTriangulation_h
#define BitingTriangulation_h

#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Base/Point.h"

#include <cstdint> // for flags
#include <vector>  // for the arrays

namespace biting
{

/// A triangulation with adjacency.
/// Corner k (0..2) of triangle t is Corners[3t + k], counterclockwise. Neighbors[3t + k] lies
/// across the edge opposite corner k, NoId where there is none. Constraints[3t + k] is the
/// constraint that covers that edge, NoId where there is none. Regions[t] numbers the connected
/// faces between constraints.
struct Triangulation
{
  std::vector<Id> Corners;
  std::vector<Id> Neighbors;
  std::vector<Id> Constraints;
  std::vector<Id> Regions;

  Id NumberOfTriangles() const { return static_cast<Id>(this->Corners.size() / 3); }
};

/// Edges that must be in the triangulation. Constraint c joins the points Starts[c] and Ends[c].
struct ConstraintEdges
{
  std::vector<Id> Starts;
  std::vector<Id> Ends;
  std::vector<std::uint8_t> IsBoundary; ///< 1: inside and outside change across it
};

struct TriangulationOptions
{
  /// The phi of the phi-Delaunay criterion (paper, section 4.4), in (0, 1]; 1 is Delaunay. An edge
  /// that is not Delaunay stays where neither opposite point lies within phi times the circumradius
  /// of the triangle across it, and both triangles have a radius-edge ratio of at most sqrt(2) /
  /// phi.
  ///
  /// That bound is the one of theorem 4.12 for a constant spacing. Its proof needs the
  /// phi-circumcircle of each triangle to be empty of all points. Definition 4.1 asks it of the
  /// neighbours only, and for phi < 1 the one does not follow from the other: without the bound,
  /// slivers keep each other.
  double Phi = 1.0;
};

/// Two constraints that are in each other's way: they cross, as their ends were rounded, or they
/// cover the same edge.
struct ConstraintConflict
{
  Id First = NoId;
  Id Second = NoId;
};

struct TriangulationResult
{
  Triangulation Mesh;                        ///< inside triangles only
  std::vector<ConstraintConflict> Conflicts; ///< where not empty, Mesh is empty
  /// Constraints that cover an edge together: it has the number of the first.
  std::vector<ConstraintConflict> Coincidences;
  bool WasAborted = false;
};

/// The constrained phi-Delaunay triangulation of the even-odd inside of the constraints.
///
/// Points are inserted in an order of their own (Hilbert curve, rounds of growing size), so the
/// result depends only on the points and constraints; co-circular points are decided by the order
/// of insertion. Constraints not present after insertion are recovered; a point that lies exactly
/// on a constraint splits it (both parts carry the constraint's number). The outside is removed:
/// what an even number of boundaries parts from beyond the convex hull. Points that no inside
/// triangle uses are allowed: they are simply not referred to. Region numbers are by the smallest
/// constraint on each face's border. Precondition: points are distinct and finite. Cost O(n log n).
/// Source: S. W. Sloan, "A fast algorithm for generating constrained Delaunay triangulations",
/// 1993; N. Amenta, S. Choi, G. Rote, "Incremental constructions con BRIO", 2003.
TriangulationResult Triangulate(const std::vector<Point2>& points,
  const ConstraintEdges& constraints, const TriangulationOptions& options, Monitor& monitor);

struct ConstrainedMesh;

/// The last steps of Triangulate, where the first ones are done (ConstrainedMesh.h).
TriangulationResult FinishTriangulation(ConstrainedMesh made, Monitor& monitor);

} // namespace biting

#endif
