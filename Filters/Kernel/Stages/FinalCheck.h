// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFinalCheck_h
#define BitingFinalCheck_h

#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../Domain/Domain.h"
#include "../Mesh/BitingMesh.h"

#include <string> // for the violation
#include <vector> // for the arrays

namespace biting
{

/// A mesh before it is handed out.
struct FinalCheckInput
{
  const Domain& Geometry;
  const BitingMesh& Mesh;
  const std::vector<Id>& Constraints; ///< of the triangulation, one an edge of a triangle
  const std::vector<Id>& Segments;    ///< of the constraints
  bool IsDelaunay = true;             ///< it must be
};

/// What every mesh must pass: CheckMesh with the area of the domain, and CheckSegmentCover. Returns
/// the first violation; empty where there is none, or the monitor wants to stop.
std::string CheckFinalMesh(const FinalCheckInput& input, Monitor& monitor);

} // namespace biting

#endif
