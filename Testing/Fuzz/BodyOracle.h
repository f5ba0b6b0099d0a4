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
  double SmallestDihedral = 180.0;
};

/// Checks the surface, meshes it, fills it. Laws: a mesh or an error, and a place with that; no
/// error says that the check of the result failed; a fair surface has both meshes. The surface is
/// closed where the input is, with its Euler number; its volume is off by at most the area times
/// f / 2. Tetrahedra are positive; each facet has a neighbor or is in the boundary, which is
/// closed, with the volume as the surface; no vertex is unused.
BodyOutcome RunSurfaceCase(const SurfaceCase& surface);

} // namespace biting

#endif
