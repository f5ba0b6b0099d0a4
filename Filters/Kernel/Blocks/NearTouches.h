// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingNearTouches_h
#define BitingNearTouches_h

#include "../Base/Pulse.h"
#include "../Domain/Domain.h"
#include "../Spacing/Spacing.h"

namespace biting
{

/// Whether segments that are divided by f may meet, by rounding of the vertices on them, other than
/// at common ends: where two are as near as that, or leave a vertex at so small an angle. The mesh
/// of a whole takes such divisions back. Blocks can not, if one has the one segment, and another
/// one the other.
///
/// Law: where this is false, vertices on different segments of the domain differ, and parts of
/// segments meet at common ends only, wherever these are divided in proportion to f.
/// Cost O(n log n). Where the monitor wants to stop the answer has no meaning.
bool HasNearTouches(const Domain& domain, const Spacing& spacing, Pulse& pulse);

} // namespace biting

#endif
