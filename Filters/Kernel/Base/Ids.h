// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingIds_h
#define BitingIds_h

#include <cstdint> // for int32_t

namespace biting
{

/// Index of a vertex, segment, triangle or bite. 32 bits: the facade checks sizes once.
using Id = std::int32_t;

constexpr Id NoId = -1;

} // namespace biting

#endif
