// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMostVertices_h
#define BitingMostVertices_h

#include "Ids.h"

#include <limits> // for the largest number

namespace biting
{

/// Of a mesh in one process: half-edges, six a vertex, are to have ids, and a quarter is left to
/// spare.
constexpr Id MostVerticesInIds = std::numeric_limits<Id>::max() / 8;

} // namespace biting

#endif
