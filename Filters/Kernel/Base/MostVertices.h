// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingMostVertices_h
#define BitingMostVertices_h

#include "Ids.h"

#include <limits> // for the largest number

namespace biting
{

/// Of a mesh in one process: half-edges are to have ids, four a triangle and so eight a vertex, and
/// so are those of vertices that come late: an eighth is room enough.
constexpr Id MostVerticesInIds = std::numeric_limits<Id>::max() / 9;

} // namespace biting

#endif
