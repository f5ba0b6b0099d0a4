// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingNarrowAngles_h
#define BitingNarrowAngles_h

#include "../Base/Problem.h"
#include "../Base/Pulse.h"
#include "../Domain/Domain.h"

namespace biting
{

/// Adds a problem for each angle of the domain between two segments that is below 0.01 degrees
/// (ProblemCode::NarrowAngles): the triangle there is as thin, whatever the spacing. Cost O(n log
/// n).
void ReportNarrowAngles(const Domain& domain, ProblemList& problems, Pulse& pulse);

} // namespace biting

#endif
