// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPreservedSpacing_h
#define BitingPreservedSpacing_h

#include "../Base/Monitor.h"
#include "../Domain/Domain.h"
#include "../Spacing/Spacing.h"

namespace biting
{

/// The spacing for a domain whose segments are not divided: what `spacing` asks for, as far as the
/// lengths of the segments leave a choice.
///
/// With L(x) = min_i(l_i + g |x - segment i|), the lengths l_i and their extension with the
/// gradation g, f is at most L, and at least L(y) - g |x - y| for each end and middle y of a
/// segment. So f is L on the boundary, whatever `spacing` is there, and may differ from it by 2 g d
/// at a distance d. Where nothing else is given, f is L. A gradation of 0 becomes the default. The
/// scale does not apply to L, and where a segment source is given, to its values only, not to g.
/// Minimum and maximum apply, but not below the lower bound. A floor that was set is replaced.
/// Cost O(n log n) for n segments. Where the monitor asks to stop the result has no meaning.
SpacingOptions FollowSegments(
  SpacingOptions spacing, const Domain& domain, Monitor& monitor = NoMonitor());

} // namespace biting

#endif
