// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingFreedMemory_h
#define BitingFreedMemory_h

namespace biting
{

/// Asks the C library to hand out what is freed again, up to some ten megabytes, before it gives
/// any back to the system, which would fill all of it with zeros anew: a twentieth of the time of a
/// mesh. A hint: where the library is not glibc nothing is gained or lost.
void KeepFreedMemory();

} // namespace biting

#endif
