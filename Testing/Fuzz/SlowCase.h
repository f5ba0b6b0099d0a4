// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingSlowCase_h
#define BitingSlowCase_h

#include <cstdint> // for seeds

namespace biting
{

/// Ends the program, with a line that names the seed, where a case takes more than so many seconds
/// of computing: how busy the machine is does not matter. From the first call on.
void BeginCase(std::uint64_t seed, int seconds);

/// The case has ended in time.
void EndCase();

} // namespace biting

#endif
