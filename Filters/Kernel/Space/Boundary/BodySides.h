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
  std::vector<Id> Regions;          ///< of each label, from label 1 on
  bool HasValues = false;           ///< these are Regions of the mesh; else they count bodies
  Id OpenTriangle = NoId;           ///< a triangle with one part on both sides: no bodies are known
  std::array<Id, 2> Folded = { NoId, NoId }; ///< closed: nearest in angle at a crowded edge
};

/// A part is a connected component of space without the triangles: sides of triangles are joined
/// around edges (exact order), shells along rays. The outermost part is no body.
///
/// Values are Regions of the mesh. Where all triangles at the outside have two, the common one (of
/// two common ones the second) is no region.
/// A part inside a shell, without values: a body if the part around the shell is none (even-odd);
/// always a body if an edge of the shell has an odd number of triangles, as at walls of bodies.
/// With values: in a shell of one value a body of this region, or a cavity if the part around is a
/// body of the same region. In a shell of several values each value of a triangle is that of a body
/// on one of its sides; a part that owns no triangle is a cavity. Where a triangle finds no such
/// body, or a shell of several values has neither an edge of more than two triangles nor a triangle
/// of two values, all is as without values.
/// Without values regions count bodies from 0 in the order of their first triangles.
/// Triangles are turned so that IsBehind(label behind, label in front).
BodySides FindBodies(SurfaceMesh& mesh, Pulse& pulse);

/// Whether a triangle between these labels has the first one behind it: it looks away from bodies,
/// and from the lower of two.
constexpr bool IsBehind(Id label, Id other)
{
  return label != 0 && (other == 0 || label < other);
}

} // namespace biting

#endif
