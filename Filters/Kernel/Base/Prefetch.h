// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingPrefetch_h
#define BitingPrefetch_h

namespace biting
{

/// Begins to bring what is at the address into the cache, where the compiler knows how to. It need
/// not be a place that may be read.
inline void Prefetch([[maybe_unused]] const void* address)
{
#ifdef __GNUC__
  __builtin_prefetch(address);
#endif
}

} // namespace biting

#endif
