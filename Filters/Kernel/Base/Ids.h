// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingIds_h
#define BitingIds_h

#include <cstdint> // for int32_t
#include <limits>  // for the largest number

namespace biting
{

/// Index of a vertex, segment, triangle or bite. 32 bits: the facade checks sizes once.
using Id = std::int32_t;

constexpr Id NoId = -1;

/// Of a mesh in one process: half-edges are to have ids, four a triangle and so eight a vertex, and
/// so are those of vertices that come late: an eighth is room enough.
constexpr Id MostVerticesInIds = std::numeric_limits<Id>::max() / 9;

} // namespace biting

#endif
