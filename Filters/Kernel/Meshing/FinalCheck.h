// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFinalCheck_h
#define BitingFinalCheck_h

#include "../Base/Ids.h"
#include "../Base/Monitor.h"
#include "../BitingMesh.h"
#include "../Domain/Domain.h"

#include <string> // for the violation
#include <vector> // for the arrays

namespace biting
{

/// What every mesh must pass before it is handed out: CheckMesh with the area of the domain, and
/// CheckSegmentCover. `constraints` is that of the triangulation, one an edge of a triangle;
/// `segments` the segment of each constraint. Returns the first violation; empty where there is
/// none, or the monitor wants to stop.
std::string CheckFinalMesh(const Domain& domain, const BitingMesh& mesh,
  const std::vector<Id>& constraints, const std::vector<Id>& segments, Monitor& monitor);

} // namespace biting

#endif
