// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSharpCorners_h
#define BitingSharpCorners_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "../Domain/Domain.h"
#include "../Spacing/Spacing.h"
#include "EdgeDivision.h"
#include "Spokes.h"

#include <vector> // for the arrays

namespace biting
{

/// Where the segments of sharp corners are to be divided: both sides at the same distances from the
/// corner, in concentric shells (as J. Ruppert, "A Delaunay refinement algorithm for quality
/// 2-dimensional mesh generation", 1995, does for another reason).
///
/// A corner is sharp where two segments enclose less than 60 degrees of the domain. As long as the
/// sides are closer together than f, there is no room for a vertex between them, and triangles
/// reach from one side to the other: their smallest angles cannot be much above that of the corner,
/// if f is to hold. With vertices opposite each other these triangles are half trapezoids, with
/// angles of 90 degrees plus half that of the corner at most; where divisions do not match, up to
/// 180. Once the sides are f apart, the shells end.
///
/// The shells of one vertex are the same for all of its segments, a spacing apart each: f is the
/// greatest on any of those that have a sharp corner there.
class SharpCorners
{
public:
  /// `spacings`: f at the vertices. `step`: the distance of shells, in units of f. No more than
  /// `limit` shells at one vertex.
  SharpCorners(const Domain& domain, const std::vector<double>& spacings, const Spacing& spacing,
    double step, Id limit, Pulse& pulse);

  /// The shells that the segment meets.
  EndShells ShellsOn(Id segment) const;

private:
  struct Side
  {
    biting::Spoke Spoke;
    double Length;
    double HalfSine; ///< sine of half the smallest sharp angle beside it
    Id Count = 0;    ///< of its shells
  };

  void FindSides(const std::vector<SharpSector>& sectors);
  void AddSide(const Spoke& spoke, double halfSine);
  void AddShells(const Point2& corner, double spacing, Id limit);
  double SpacingAt(const Point2& corner, double radius) const;
  bool CountShell(double radius, double lastRadius, double lastSpacing);
  std::vector<double> ShellsAt(Id segment, int end) const;

  const Domain& Geometry;
  const Spacing& F;
  double Step;
  std::vector<Side> Sides;         ///< of the vertex at hand
  std::vector<double> Radii;       ///< of the shells of all vertices, one after the other
  std::vector<Id> FirstShells;     ///< of each vertex, in Radii
  std::vector<Id> NumbersOfShells; ///< of segment s: 2 s at its start, 2 s + 1 at its end
};

} // namespace biting

#endif
