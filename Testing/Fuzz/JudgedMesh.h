// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingJudgedMesh_h
#define BitingJudgedMesh_h

#include "BitingMesh.h"
#include "Drawing.h"
#include "ExactSigns.h"

#include <algorithm> // for max, min
#include <cmath>     // for hypot
#include <cstddef>   // for slots
#include <sstream>   // for texts
#include <string>    // for violations
#include <utility>   // for pairs
#include <vector>    // for arrays

namespace biting
{

/// A directed edge of a triangle, opposite the corner at `Slot`.
struct HalfEdge
{
  Id Start;
  Id End;
  std::size_t Slot;

  std::pair<Id, Id> Ends() const { return { this->Start, this->End }; }
};

inline bool operator<(const HalfEdge& a, const HalfEdge& b)
{
  return a.Ends() < b.Ends();
}

inline std::size_t Next(std::size_t slot)
{
  return slot % 3 == 2 ? slot - 2 : slot + 1;
}

inline std::size_t At(Id id)
{
  return static_cast<std::size_t>(id);
}

inline bool IsBetween(double value, double low, double high)
{
  return value >= low && value <= high;
}

/// The parameter of the place on the segment nearest to p.
inline double ParameterOf(const Point2& p, const Point2& start, const Point2& end)
{
  const Point2 direction = end - start;
  const double longest = std::max(std::abs(direction.X), std::abs(direction.Y));
  const Point2 unit = 1.0 / longest * direction;
  const double t = Dot(1.0 / longest * (p - start), unit) / Dot(unit, unit);
  return std::min(std::max(t, 0.0), 1.0);
}

inline double DistanceTo(const Point2& p, const Point2& start, const Point2& end)
{
  const Point2 nearest = start + ParameterOf(p, start, end) * (end - start);
  return std::hypot(p.X - nearest.X, p.Y - nearest.Y);
}

inline std::string PlaceText(const Point2& p)
{
  std::ostringstream text;
  text.precision(17);
  text << "(" << p.X << ", " << p.Y << ")";
  return text.str();
}

inline bool AreCollinear(const DrawnSegment& a, const DrawnSegment& b)
{
  return ExactOrientation(a.Start, a.End, b.Start) == 0 &&
    ExactOrientation(a.Start, a.End, b.End) == 0;
}

/// A mesh, what it was made of, and what the oracles have found out so far.
struct JudgedMesh
{
  JudgedMesh(const BitingMesh& mesh, const Polylines& input, const BitingMeshOptions& options)
    : Mesh(mesh)
    , Input(input)
    , Options(options)
    , Drawn(ReadDrawing(input))
    , Slack(this->Drawn.Slack())
  {
  }

  bool Refuse(const std::string& violation);
  bool Require(bool holds, const char* promise) { return holds || this->Refuse(promise); }
  bool IsRelaxed() const
  {
    return this->Options.Relaxation && this->Options.MaximumNumberOfBites < 0;
  }
  const Point2& Place(Id vertex) const { return this->Mesh.Points[At(vertex)]; }
  const Point2& Corner(std::size_t slot) const { return this->Place(this->Mesh.Corners[slot]); }
  const HalfEdge* FindHalf(Id start, Id end) const;
  bool IsCovering(const HalfEdge& half) const;
  std::string EdgeText(Id start, Id end) const;

  const BitingMesh& Mesh;
  const Polylines& Input;
  const BitingMeshOptions& Options;
  Drawing Drawn;
  double Slack;
  std::vector<HalfEdge> Halves;            ///< sorted
  std::vector<std::pair<Id, Id>> Covering; ///< smaller id first; sorted
  std::vector<std::size_t> BoundarySlots;
  std::vector<Point2> SortedPoints;
  std::string Violation;
};

/// Sizes, ids, places; that triangles fit together and cover their area once; regions. Fills what
/// is sorted of the judged mesh.
bool HoldsTopology(JudgedMesh& judged);

/// That the mesh is that of the drawing: its area, its points, its segments, what lies on them.
bool HoldsDrawing(JudgedMesh& judged);

/// Delaunay, and what the mesh says of itself: figures of quality, bites.
bool HoldsFigures(JudgedMesh& judged);

/// What a mesh must be, told without any help of the kernel:
/// - the arrays agree in size, ids are in range, places are finite;
/// - no point twice, none unused; triangles counterclockwise; an edge has one triangle or two, and
///   the neighbors are those;
/// - the covering edges are edges of the mesh, each once; those that bound have one triangle, the
///   others two;
/// - the boundary winds once about every triangle looked at: nothing overlaps;
/// - regions are what interfaces leave connected;
/// - with explicit boundaries the area is that of the drawing;
/// - every end of a segment and every embedded point that the mesh covers is a vertex, bit for bit,
///   unless it is nearer to the boundary, or to a vertex, than rounding;
/// - every segment, as far as the mesh covers it, is covered by edges; every covering edge lies on
///   its input cell; but edges between two faces of one region are covered by none;
/// - kinds and original points are true;
/// - with PreserveBoundary no vertex is added on a segment, but where two meet;
/// - with phi = 1, and in relaxed meshes, edges that cover nothing are Delaunay;
/// - quality figures are within their ranges; distances to neighbors, in small meshes, are right;
/// - bites are there if they were asked for, not more than asked for, and centred at vertices; in
///   relaxed meshes, at those of the input.
/// Returns the first violation, empty where there is none.
std::string FindMeshViolation(
  const BitingMesh& mesh, const Polylines& input, const BitingMeshOptions& options);

} // namespace biting

#endif
