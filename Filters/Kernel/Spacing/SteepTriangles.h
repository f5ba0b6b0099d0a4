// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSteepTriangles_h
#define BitingSteepTriangles_h

#include "../Base/Pulse.h"
#include "Spacing.h"
#include "ValueRange.h"

#include <vector> // for marks

namespace biting
{

/// Which triangles are steeper than the gradation, by more than a margin: the slope along one of
/// their edges, or the mean gradient around one of their corners; or by so much of their own
/// gradient that it counts in f. Empty where none is, or the pulse stops.
std::vector<bool> FindSteepTriangles(
  const TriangulatedSource& source, double gradation, const ValueRange& range, Pulse& pulse);

} // namespace biting

#endif
