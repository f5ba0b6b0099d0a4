// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFaceRegions_h
#define BitingFaceRegions_h

#include "../Base/Ids.h"
#include "../Base/Pulse.h"
#include "ChangedRegion.h"
#include "EdgeSimplification.h"
#include "OldMesh.h"
#include "Stitching.h"

#include <string> // for the violation
#include <vector> // for regions

namespace biting
{

/// Of each face of the cavity's triangulation, the region of the old mesh that it is: that of the
/// old triangle at the middle of the largest triangle of the face. Edges do not tell: where they
/// lie on each other within rounding they have different regions on one side. Cost O(n).
std::vector<Id> FindFaceRegions(
  const OldMesh& mesh, const ChangedRegion& region, const CavityMesh& cavity, Pulse& pulse);

/// Compares the areas of regions in the cavity, whose FaceRegions are known, with those of the old
/// mesh. They may differ by strips: along the old edges of the region as wide as `tolerance` lets
/// edges move, and along all old edges as wide as rounding. Returns what is wrong as text, empty
/// where nothing is.
std::string CheckAreas(const OldMesh& mesh, const ChangedRegion& region, const CavityMesh& cavity,
  const EdgeTolerance& tolerance);

} // namespace biting

#endif
