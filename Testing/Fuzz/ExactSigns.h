// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingExactSigns_h
#define BitingExactSigns_h

#include "Base/Point.h"

namespace biting
{

/// The predicates once more, by other means: a filter in double arithmetic, then whole numbers of
/// any length. They share nothing with those of the kernel.

/// Sign of the doubled area of (a, b, c): +1 counterclockwise.
int ExactOrientation(const Point2& a, const Point2& b, const Point2& c);

/// Position of d against the circle through a, b, c, which are counterclockwise: +1 inside.
int ExactInCircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d);

} // namespace biting

#endif
