// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingRaisedSpacing_h
#define BitingRaisedSpacing_h

#include "../Base/Problem.h"
#include "../Domain/Domain.h"
#include "../Spacing/Spacing.h"

namespace biting
{

/// The options with a minimum of the rounding of vertices, as vertices nearer to each other are
/// none; unless they have bounds that say otherwise. Where a spacing below that is given, it is
/// told once (ProblemCode::RaisedSpacing).
SpacingOptions RaiseToRounding(SpacingOptions spacing, const Domain& domain, ProblemList& problems);

} // namespace biting

#endif
