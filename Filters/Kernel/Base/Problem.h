// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingProblem_h
#define BitingProblem_h

#include "Ids.h"
#include "Point.h"

#include <string> // for the detail
#include <vector> // for lists of problems

namespace biting
{

/// The numbers stand in files, as the kind of a problem: new codes come before Aborted.
enum class ProblemCode
{
  // Repaired: the mesh is valid, the user is told.
  DuplicatePoints,    ///< points with equal coordinates that are not shared (ids: point, point)
  ZeroLengthSegments, ///< (ids: cell, point)
  DuplicateSegments,  ///< equal or overlapping segments (ids: cell, cell)
  Crossings,          ///< two segments cross in their interiors (ids: cell, cell)
  Touches,            ///< a vertex lies on a segment (ids: cell, point)
  OutsidePoints,      ///< an embedded point outside the domain, dropped (ids: point)
  OutsideInterfaces,  ///< an interface outside the domain, dropped (ids: cell)
  // Refused: no mesh.
  NoClosedLoop, ///< nothing bounds a domain (ids: point, an open end; none where nothing is open,
                ///< with the place of the first boundary drawn an even number of times, interface,
                ///< embedded point or segment of length 0, and what is known of it in the detail)
  NotFinite,    ///< a coordinate is NaN or infinite (ids: point)
  OutOfRange,   ///< coordinates too large or too small for the exact predicates (ids: point)
  NotPlanar,    ///< a loop leaves the fitted plane (ids: point)
  BadSpacing,   ///< the spacing is zero, negative or not finite (ids: point or cell)
  TooManyVertices, ///< the estimate exceeds the limit
  NotResolved,     ///< crossings that could not be resolved (ids: cell, cell)
  CheckFailed,     ///< the result did not pass the check: a defect of this library
  // Repaired, like the first.
  OverlappingCells, ///< faces on top of each other: an odd number of them covers the domain (ids:
                    ///< cell)
  NearPoints, ///< a point too near to another one, or to a segment, to be told apart from it (ids:
              ///< point; point, or NoId where it is a segment, which the detail names then)
  // Meshed, and told.
  NarrowAngles,  ///< an angle below 0.01 degrees between segments (ids: cell, cell)
  RaisedSpacing, ///< a spacing below the rounding of vertices
  // Noted: the mesh is what was asked for.
  SmallLoops,  ///< closed loops that were left out (ids: cell of the first segment)
  FineDrawing, ///< without a tolerance: it decides the mesh, not the spacing (no ids)
  // Refused.
  BadTriangles, ///< that form no mesh of a plane (ids: cell; none where it is only known that some
                ///< overlap)
  // Repaired, like the first.
  FlatTriangles, ///< without area, in a mesh that is changed (ids: cell)
  JoinedEnds,    ///< an open end that was moved onto what it nearly touched (ids: point, cell)
  // Refused.
  OpenOutlines, ///< chains that would bound the domain, but for gaps (ids: point, point: the open
                ///< ends at the largest gap)
  // Meshed, and told.
  NearMisses,  ///< a vertex that nearly meets a segment or an embedded point (ids: cell, cell; NoId
               ///< for an embedded point)
  ChangedArea, ///< a tolerance changed the area of the domain by more than 5 % (no ids)
  NestedCells, ///< a face within another one, which is a hole by DomainRule::EvenOdd (ids: cell)
  // Of surfaces: they bound no body there.
  OpenEdges,        ///< a loop or chain of edges of one triangle (ids: point)
  NonManifoldEdges, ///< an edge of more than two triangles (ids: cell, cell)
  PinchedVertices,  ///< a vertex where several fans of triangles meet (ids: point)
  Folds,            ///< neighbors that lie on each other (ids: cell, cell)
  SelfCrossings,    ///< two triangles that cross (ids: cell, cell)
  NotOrientable,    ///< a closed walk along the surface ends on its other side (ids: cell, cell)
  // Of surfaces: repaired, or noted.
  DuplicateTriangles, ///< of the same three vertices (ids: cell, cell: the one that stays)
  InconsistentEdges,  ///< triangles at an edge that are oriented against each other (ids: cell,
                      ///< cell)
  SurfaceTouches,     ///< two triangles that meet, but not deeper than rounding (ids: cell, cell)
  // Refused.
  UnmatchedSides, ///< sides that a translation maps in part, or beside others (ids: cell)
  // Of meshes of surfaces: refused.
  TooThin,  ///< walls or feature lines too near to each other for f (ids: cell)
  TooSharp, ///< faces at too small an angle for f (ids: cell)
  // Meshed, and told.
  LostFeatures,   ///< lines or sharp edges that the mesh cuts off or leaves out (ids: point)
  ClosedHoles,    ///< loops of open edges that are narrow for f: closed (ids: point)
  SmallCrossings, ///< triangles that cross or fold, too small for f to be seen (ids: cell, cell)
  UnitedSurfaces, ///< surfaces that cross or touch: the mesh is of their union (ids: cell, cell)
  Aborted         ///< the monitor asked to stop; not an error
};

/// One thing that is wrong with the input: what, which, where.
struct Problem
{
  ProblemCode Code = ProblemCode::CheckFailed;
  std::vector<std::int64_t> Ids; ///< input ids, in the order that the code states
  Point3 Place;                  ///< in input coordinates, of the plane (z = 0) or of space
  std::string Detail;            ///< figures that ids and place do not say; may be empty
};

/// All problems of one kind: how many there were, and the first few.
struct ProblemGroup
{
  ProblemCode Code = ProblemCode::CheckFailed;
  std::int64_t Count = 0;
  std::vector<Problem> First; ///< at most ProblemList::KeptPerKind
};

/// Collects problems by kind, in the order in which the kinds first occur.
class ProblemList
{
public:
  static constexpr std::size_t KeptPerKind = 10000;

  void Add(Problem problem);
  void Add(const ProblemGroup& group); ///< all that it counts
  std::int64_t Count(ProblemCode code) const;
  bool Has(ProblemCode code) const { return this->Count(code) > 0; }
  bool HasErrors() const;
  const std::vector<ProblemGroup>& Groups() const { return this->Kinds; }

private:
  ProblemGroup& GroupOf(ProblemCode code);
  std::vector<ProblemGroup> Kinds;
};

/// Whether the problem leaves no mesh (true), or was repaired or only noted (false).
bool IsError(ProblemCode code);

/// Whether it is worth a word only, and nothing is wrong.
bool IsNote(ProblemCode code);

/// A figure of a detail.
std::string Figure(double value, int digits = 3);

/// A figure of two digits, no less than the value, which is above zero.
std::string FigureAbove(double value);

} // namespace biting

#endif
