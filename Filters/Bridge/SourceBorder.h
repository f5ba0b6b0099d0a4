// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSourceBorder_h
#define BitingSourceBorder_h

#include "../Kernel/Base/Pulse.h"
#include "../Kernel/Spacing/Spacing.h"

namespace biting
{

/// Adds the values on the border of `source`, whose corners are sorted (SourceOrder.h), to the
/// segments of `options`: f grows from them with the gradation. Where a triangle ends on others
/// that ask for more, f would jump. Nothing is added where there is no gradation: f is as given
/// then.
void AddBorderOf(const TriangulatedSource& source, SpacingOptions& options, Pulse& pulse);

} // namespace biting

#endif
