// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingOtherReadings_h
#define BitingOtherReadings_h

#include "OldMesh.h"

#include <vector> // for the list

namespace biting
{

/// As ReadOldMesh has it.
struct Reading
{
  double Nearest;
  HangingRule Hanging;
};

/// How else a mesh may be read that was no mesh with `nearest`, where vertices that hang on edges
/// were divided, if there were any. Points that are meant to be one are mostly within a unit in the
/// last place; where what is left of slits then forms no mesh, all that rounding may have moved
/// apart is made one. Vertices that hang on edges across slits no wider than rounding may leave no
/// mesh if triangles are divided there. Not again what reads the same.
std::vector<Reading> OtherReadings(const RemeshInput& input, double nearest, bool hasHanging);

} // namespace biting

#endif
