// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingBodyOracle_h
#define BitingBodyOracle_h

#include "RandomSurface.h"

#include <string> // for what is wrong

namespace biting
{

/// What became of a surface.
struct BodyOutcome
{
  enum class Stage
  {
    Checked, ///< refused by the check
    Meshed,  ///< the surface is meshed, the body refused
    Filled,  ///< the body is meshed
    Refused  ///< neither
  };
  Stage Reached = Stage::Checked;
  std::string Violation; ///< empty: none
  std::string Refusal;   ///< of the last stage; empty: none
  bool IsClean = false;  ///< closed, and the check has nothing to say
  double SmallestDihedral = 180.0;
};

/// Checks the surface, meshes it, fills it. Laws: a mesh or an error, and a place with that; no
/// error says that the check of the result failed; a fair surface has both meshes. Arrays have one
/// value per item, within their range.
/// The surface has the parts of the input with their Euler numbers, and edges of one or more than
/// two triangles exactly if the input has some, but where fins are told to be lost; it is within
/// f / 2 of the input, and the input within f of it; within f, and 1.5 f, where edges are told to
/// be cut off. Volumes are off by at most the area times f / 2. Tetrahedra are positive; each facet
/// has a neighbor or is in the boundary, which is closed; no vertex is unused.
/// `isRepeated`: with four threads, once more, and the same bytes.
BodyOutcome RunSurfaceCase(const SurfaceCase& surface, bool isRepeated);

} // namespace biting

#endif
