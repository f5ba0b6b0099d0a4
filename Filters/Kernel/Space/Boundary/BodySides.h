// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBodySides_h
#define BitingBodySides_h

#include "../Features/SurfaceGround.h"

#include <vector> // for the arrays

namespace biting
{

/// Which bodies a surface bounds. Labels of bodies are 1, 2, ..; all else has the label 0.
struct BodySides
{
  std::vector<TriangleSides> Sides; ///< of triangles
  std::vector<Id> Regions;          ///< of labels, ascending from label 1: what users call them
  Id OpenTriangle = NoId;           ///< it has one part of space on both sides: nothing is known
};

/// Parts of space are what hangs together without crossing a triangle: sides of triangles meet
/// around their edges (exact order), shells along rays. The outermost part is no body.
///
/// Within a shell of edges of an even number of triangles: with a value of its own a body that has
/// this region, or, where the part around has the same, a cavity; without values, or where some
/// shell has several, a body where the part around is none (even-odd). A shell with edges of an odd
/// number of triangles has walls between bodies: all that it closes in are bodies; their regions
/// are the values of walls, where each body has a value of which all triangles are its own (walls
/// that are given twice have one value only, of the first).
/// Without values, or where these rules give none, regions count bodies from 0 in the order of
/// their first triangles.
/// Triangles are turned so that IsBehind(label behind, label in front).
BodySides FindBodies(SurfaceMesh& mesh, const std::vector<Id>& values, Pulse& pulse);

/// Whether a triangle between these labels has the first one behind it: it looks away from bodies,
/// and from the lower of two.
constexpr bool IsBehind(Id label, Id other)
{
  return label != 0 && (other == 0 || label < other);
}

} // namespace biting

#endif
