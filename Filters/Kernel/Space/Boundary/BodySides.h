// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBodySides_h
#define BitingBodySides_h

#include "../Features/SurfaceGround.h"

#include <array>  // for pairs
#include <vector> // for the arrays

namespace biting
{

/// Which bodies a surface bounds. Labels of bodies are 1, 2, ..; all else has the label 0.
struct BodySides
{
  std::vector<TriangleSides> Sides; ///< of triangles
  std::vector<Id> Regions;          ///< of labels, ascending from label 1: what users call them
  Id OpenTriangle = NoId;           ///< it has one part of space on both sides: nothing is known
  std::array<Id, 2> Folded = { NoId, NoId }; ///< closed: nearest in angle at a crowded edge
};

/// Parts of space are what hangs together without crossing a triangle: sides of triangles meet
/// around their edges (exact order), shells along rays. The outermost part is no body.
///
/// What a shell closes in, without values: a body where the part around is none (even-odd); all
/// parts are bodies where an edge has an odd number of triangles, as walls between bodies have.
/// With values: a shell of one value closes in a body of this region; a cavity where the part
/// around has the same. In a shell of several each triangle belongs to a body of its value on one
/// of its sides; parts that no triangle belongs to are cavities (walls that are given twice have
/// the first value only). Where that does not go, or where a shell of several values has no edge of
/// more than two triangles, it is as without values.
/// Without values regions count bodies from 0 in the order of their first triangles.
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
